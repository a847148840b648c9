#include <algorithm>
#include <cmath>

#include "integrator.hpp"
#include "light.hpp"
#include "material.hpp"

/// \file
/// Emitters are found in two ways, by a shadow ray and by a scattered ray that meets one. Each counts by the share that
/// it has in the density of both together: the balance heuristic (Veach and Guibas, SIGGRAPH 1995). Lamps without size
/// have only the first way, the background, mirrors and glass only the second.

namespace render::path {
namespace {

/// Light that comes straight from lamps and from one emitter, and is scattered by the matte share of the surface.
color direct_light(const world& world, const scattering& s, const hit_record& rec, sampler& sampler) {
    color sum(0);
    for (const point_light& lamp : world.scene().lights) {
        // A lamp lights a white surface that faces it up to its own colour: its irradiance is pi times that.
        if (const auto light = light_of(lamp, world, rec)) sum += light->radiance * s.matte * light->cosine;
    }
    if (const auto light = sample_emitter(world, rec, sampler)) {
        const number scattered = light->cosine / raio::pi<number>;
        sum += light->radiance * s.matte * (scattered / (light->density + s.matte_chance * scattered));
    }
    return sum;
}

}  // namespace

color radiance(const world& world, const ray& view, sampler& sampler, int depth) {
    color gathered(0), throughput(1);
    ray r{view.origin, raio::normalize(view.direction)};
    number density = raio::infinity<number>;  // with which the ray's direction was chosen
    for (int bounce = 0;; ++bounce) {
        hit_record rec;
        if (!world.hit(r, 0, raio::infinity<number>, rec))
            return gathered + throughput * world.background_in(r.direction);
        const number clarity = world.clarity(rec.t);
        gathered += throughput * world.scene().fog.value * (1 - clarity);
        throughput *= clarity;

        if (shines(world.material_at(rec))) {
            const number other = density < raio::infinity<number> ? emitter_density(world, r, rec) / density : 0;
            return gathered + throughput * emission(world, rec, coding::linear) / (1 + other);
        }
        if (bounce == depth) return gathered;

        const scattering s = scattering_at(world, rec);
        if (s.matte_chance > 0) gathered += throughput * direct_light(world, s, rec, sampler);
        const auto next = scatter(s, r.direction, rec, sampler);
        if (!next) return gathered;
        throughput *= next->weight;
        density = next->density;
        r = raio::spawn_ray(rec, next->direction);

        // Russian roulette: dim paths end early, and those that survive stand for them.
        const number survival = std::min(1.0, std::max({throughput.x, throughput.y, throughput.z}));
        if (bounce >= 3) {
            if (!(sampler.next_1d() < survival)) return gathered;
            throughput /= survival;
        }
    }
}

}  // namespace render::path
