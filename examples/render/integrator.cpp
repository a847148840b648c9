#include "integrator.hpp"

#include <algorithm>
#include <array>

#include "light.hpp"
#include "material.hpp"

namespace render {
namespace {

color unchanged(const color& mean) { return mean; }

/// Films round down. What was computed is shown by the nearest level instead, so that a texel in white light comes out
/// as it is.
color encoded_light(const color& mean) { return encoded(mean) + 0.5 / 255; }

bool needs_no_light(const scene&) { return true; }
bool has_light_or_ambience(const scene& scene) {
    return has_light(scene) || std::ranges::any_of(scene.objects, [&](const object& o) {
               return phong_of(scene.materials[o.material]).ambient != 0;
           });
}

}  // namespace

std::span<const integrator> integrators() {
    static constexpr std::array all{
        integrator{"flat", flat::radiance, unchanged, needs_no_light, 1, 0, "the pigment of the first surface"},
        integrator{"normals", normals::radiance, unchanged, needs_no_light, 1, 0,
                   "the normal of the first surface, as a colour"},
        integrator{"whitted", whitted::radiance, unchanged, has_light_or_ambience, 1, 6,
                   "Phong's model, shadows, mirrors and glass"},
        integrator{"path", path::radiance, encoded_light, has_light, 64, 50,
                   "all light there is, by chance: smoother with more samples"}};
    return all;
}

namespace flat {

color radiance(const world& world, const ray& view, sampler&, int) {
    hit_record rec;
    return world.hit(view, 0, raio::infinity<number>, rec) ? world.color_at(rec, coding::encoded) : color(0);
}

}  // namespace flat

namespace normals {

color radiance(const world& world, const ray& view, sampler&, int) {
    hit_record rec;
    return world.hit(view, 0, raio::infinity<number>, rec) ? (rec.normal + 1.0) / 2.0 : color(0);
}

}  // namespace normals

}  // namespace render
