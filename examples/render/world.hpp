#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scene.hpp"

namespace render {

/// An object that shines and that points can be chosen on.
struct emitter {
    std::uint32_t object;  ///< its index
    std::shared_ptr<const surface_sampler> surface;
};

/// A scene that is ready for rays: a tree of the shapes that end somewhere, and beside it those that do not.
class world {
public:
    explicit world(render::scene scene);

    bool hit(const ray& r, number t_min, number t_max, hit_record& rec) const;
    bool occluded(const ray& r, number t_min, number t_max) const;

    /// What the file said, the objects sorted so that `hit_record::index` counts them.
    const render::scene& scene() const { return scene_; }

    color color_at(const hit_record& rec, coding as) const;
    const material& material_at(const hit_record& rec) const;

    /// The colour of what is seen where nothing is hit.
    color background_in(const vec3& direction) const;

    /// How much light is left after `distance` in the fog, from 1 down to 0.
    number clarity(number distance) const;

    std::span<const emitter> emitters() const { return emitters_; }
    /// What was hit as an emitter; null if it is none.
    const emitter* emitter_at(const hit_record& rec) const;

private:
    struct surfaces;

    render::scene scene_;
    std::shared_ptr<const surfaces> surfaces_;
    std::vector<emitter> emitters_;  ///< in the order of their objects
};

}  // namespace render
