#pragma once

#include <span>
#include <vector>

#include "scene.hpp"

namespace render {

template <class Variant>
struct group_of;
template <class... Shapes>
struct group_of<std::variant<Shapes...>> {
    using type = raio::group<std::vector<Shapes>...>;
};

/// A scene that is ready for rays: its shapes stand in a group, one vector for each type.
class world {
public:
    explicit world(render::scene scene);

    bool hit(const ray& r, number t_min, number t_max, hit_record& rec) const {
        return shapes_.hit(r, t_min, t_max, rec);
    }
    bool occluded(const ray& r, number t_min, number t_max) const { return shapes_.occluded(r, t_min, t_max); }

    /// What the file said, the objects sorted so that `hit_record::index` counts them.
    const render::scene& scene() const { return scene_; }

    color color_at(const hit_record& rec) const;
    const material& material_at(const hit_record& rec) const;

    /// The colour of what is seen where nothing is hit.
    color background_in(const vec3& direction) const;

    /// How much light is left after `distance` in the fog, from 1 down to 0.
    number clarity(number distance) const;

    /// The objects that shine and that points can be chosen on, by their index.
    std::span<const std::uint32_t> emitters() const { return emitters_; }

private:
    render::scene scene_;
    group_of<shape>::type shapes_;
    std::vector<std::uint32_t> emitters_;
};

}  // namespace render
