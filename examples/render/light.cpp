#include "light.hpp"

#include <algorithm>
#include <cmath>

#include "material.hpp"

namespace render {

number area(const shape& s) {
    return std::visit(
        []<class Shape>(const Shape& kind) -> number {
            if constexpr (raio::sampleable<Shape>) return kind.area();
            return 0;
        },
        s);
}

namespace {

raio::surface_sample<number> sample(const shape& s, const vec2& u) {
    return std::visit(
        [&]<class Shape>(const Shape& kind) -> raio::surface_sample<number> {
            if constexpr (raio::sampleable<Shape>) return kind.sample(u);
            return {};
        },
        s);
}

}  // namespace

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
    const std::uint32_t emitter = emitters[std::min(chosen, emitters.size() - 1)];
    const auto [point, normal] = sample(world.scene().objects[emitter].shape, sampler.next_2d());

    const vec3 to_point = point - rec.point;
    if (!(raio::dot(rec.normal, to_point) > 0)) return {};
    const vec3 direction = raio::normalize(to_point);
    const ray shadow_ray = raio::spawn_ray(rec, direction);
    hit_record there;
    // The ray aims at the point and meets the emitter near it, but not exactly there. A line meets all shapes but the
    // torus once from the outside and once from the inside at most, so the side tells whether this is the place that
    // was chosen.
    if (!world.hit(shadow_ray, 0, raio::infinity<number>, there) || there.index != emitter) return {};
    if (there.front_face != (raio::dot(normal, direction) < 0)) return {};
    if (const auto* torus = std::get_if<raio::torus<number>>(&world.scene().objects[emitter].shape)) {
        // Between two places that show the same side lies one that shows the other: the chosen one lies nearer to it.
        hit_record next;
        const bool again = torus->hit(raio::spawn_ray(there, direction), 0, raio::infinity<number>, next);
        if (again && raio::length(to_point) > there.t + next.t / 2) return {};
    }
    const number density = emitter_density(world, shadow_ray, there);
    if (!(density > 0 && density < raio::infinity<number>)) return {};
    return incoming_light{direction, raio::dot(rec.normal, direction),
                          emission(world, there, coding::linear) * world.clarity(there.t), density};
}

number emitter_density(const world& world, const ray& r, const hit_record& rec) {
    const number surface = area(world.scene().objects[rec.index].shape);
    if (!(surface > 0)) return 0;
    const number length2 = raio::dot(r.direction, r.direction), cosine = -raio::dot(rec.normal, r.direction);
    if (!(cosine > 0)) return 0;
    const number distance2_over_cosine = rec.t * rec.t * length2 * std::sqrt(length2) / cosine;
    return distance2_over_cosine / (surface * static_cast<number>(world.emitters().size()));
}

}  // namespace render
