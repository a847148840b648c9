#include <algorithm>
#include <cmath>

#include "integrator.hpp"
#include "light.hpp"
#include "material.hpp"

namespace render::whitted {
namespace {

color clamped(const color& c) {
    return {std::clamp(c.x, 0.0, 1.0), std::clamp(c.y, 0.0, 1.0), std::clamp(c.z, 0.0, 1.0)};
}

/// What a surface throws back against `direction` of the light that arrives, in Phong's model.
color thrown_back(const incoming_light& light, const phong& finish, const color& hue, const vec3& direction,
                  const hit_record& rec) {
    const vec3 mirrored = reflected(-light.direction, rec.normal);
    const number highlight = std::pow(std::max(0.0, -raio::dot(mirrored, direction)), finish.exponent);
    return light.radiance * (hue * (finish.diffuse * light.cosine) + finish.specular * highlight);
}

}  // namespace

color radiance(const world& world, const ray& view, sampler& sampler, int depth) {
    hit_record rec;
    const vec3 direction = raio::normalize(view.direction);
    if (!world.hit(view, 0, raio::infinity<number>, rec)) return clamped(world.background_in(direction));

    const phong finish = phong_of(world.material_at(rec));
    const color hue = world.color_at(rec, coding::encoded);
    const auto from = [&](const vec3& towards) {
        return radiance(world, raio::spawn_ray(rec, towards), sampler, depth - 1);
    };

    color light = shines(world.material_at(rec)) ? emission(world, rec, coding::encoded) : hue * finish.ambient;
    if (finish.diffuse > 0 || finish.specular > 0) {
        for (const point_light& lamp : world.scene().lights) {
            if (const auto arriving = light_of(lamp, world, rec)) {
                light += thrown_back(*arriving, finish, hue, direction, rec);
            }
        }
    }
    number mirror = finish.reflected;
    if (finish.transmitted > 0 && depth > 0) {
        const number ratio = rec.front_face ? 1 / finish.refractive_index : finish.refractive_index;
        if (const auto through = refracted(direction, rec.normal, ratio)) {
            light += finish.transmitted * from(*through);
        } else {
            mirror += finish.transmitted;  // total internal reflection
        }
    }
    if (mirror > 0 && depth > 0) light += mirror * from(reflected(direction, rec.normal));

    const number clarity = world.clarity(rec.t * raio::length(view.direction));
    return clamped(light * clarity + world.scene().fog.value * (1 - clarity));
}

}  // namespace render::whitted
