#include "light.hpp"

#include <algorithm>
#include <cmath>

#include "material.hpp"

namespace render {
namespace {

/// Is the place of an emitter that a ray met the one that was chosen on it, `distance` away along the unit direction?
/// The ray aims at the point and meets the emitter near it, but not exactly there. Of two crossings the nearer one to
/// it is meant, and of all that meet in an edge the one on the same side.
bool is_chosen_place(const shape& emitter, const ray& aimed, const hit_record& met, const vec3& normal,
                     number distance) {
    if (met.front_face != (raio::dot(normal, aimed.direction) < 0)) return false;
    return std::visit(
        [&](const auto& s) {
            hit_record behind;
            const bool again = s.hit(raio::spawn_ray(met, aimed.direction), 0, raio::infinity<number>, behind);
            return !again || distance <= met.t + behind.t / 2;
        },
        emitter);
}

}  // namespace

bool has_light(const scene& scene) {
    const color black(0);
    const auto is_lit = [&](const point_light& lamp) { return lamp.intensity != black; };
    const auto glows = [&](const object& o) {
        const material& m = scene.materials[o.material];
        const auto* lamp = std::get_if<emissive>(&m);
        return lamp ? lamp->radiance != black : shines(m);
    };
    return scene.background.bottom != black || scene.background.top != black ||
           (scene.fog.density > 0 && scene.fog.value != black) || std::ranges::any_of(scene.lights, is_lit) ||
           std::ranges::any_of(scene.objects, glows);
}

std::optional<incoming_light> light_of(const point_light& lamp, const world& world, const hit_record& rec) {
    const vec3 to_lamp = lamp.position - rec.point;
    const number distance = raio::length(to_lamp);
    if (!(raio::dot(rec.normal, to_lamp) > 0) || world.occluded(raio::spawn_ray(rec, to_lamp), 0, 1)) return {};
    const vec3 direction = to_lamp / distance;
    const auto& [constant, linear, quadratic] = lamp.attenuation;
    const number attenuation = constant + linear * distance + quadratic * distance * distance;
    return incoming_light{direction, raio::dot(rec.normal, direction),
                          lamp.intensity * raio::quotient(1.0, attenuation, 0.0), raio::infinity<number>};
}

std::optional<incoming_light> sample_emitter(const world& world, const hit_record& rec, sampler& sampler) {
    const auto emitters = world.emitters();
    if (emitters.empty()) return {};
    const auto chosen = static_cast<std::size_t>(sampler.next_1d() * static_cast<number>(emitters.size()));
    const emitter& emitter = emitters[std::min(chosen, emitters.size() - 1)];
    const auto [point, normal] = emitter.surface->sample(sampler.next_2d());

    const vec3 to_point = point - rec.point;
    if (!(raio::dot(rec.normal, to_point) > 0)) return {};
    const vec3 direction = raio::normalize(to_point);
    const ray shadow_ray = raio::spawn_ray(rec, direction);
    hit_record there;
    if (!world.hit(shadow_ray, 0, raio::infinity<number>, there) || there.index != emitter.object) return {};
    const shape& lamp = world.scene().objects[emitter.object].shape;
    if (!is_chosen_place(lamp, shadow_ray, there, normal, raio::length(to_point))) return {};
    const number density = emitter_density(world, shadow_ray, there);
    if (!(density > 0 && density < raio::infinity<number>)) return {};
    return incoming_light{direction, raio::dot(rec.normal, direction),
                          emission(world, there, coding::linear) * world.clarity(there.t), density};
}

number emitter_density(const world& world, const ray& r, const hit_record& rec) {
    const emitter* emitter = world.emitter_at(rec);
    if (!emitter) return 0;
    const number length2 = raio::dot(r.direction, r.direction), cosine = -raio::dot(rec.normal, r.direction);
    if (!(cosine > 0)) return 0;
    const number distance2_over_cosine = rec.t * rec.t * length2 * std::sqrt(length2) / cosine;
    return distance2_over_cosine * emitter->surface->density(rec.normal) / static_cast<number>(world.emitters().size());
}

}  // namespace render
