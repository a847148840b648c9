#pragma once

#include <optional>

#include "sampler.hpp"
#include "world.hpp"

/// \file
/// How light finds its way from where it begins straight to a surface: from lamps without size, and from emissive
/// objects, on which a point is chosen by chance.

namespace render {

/// Does anything in the scene give light: a lamp, something that shines, the background or the fog?
bool has_light(const scene& scene);

/// Light that arrives at a surface.
struct incoming_light {
    vec3 direction;  ///< unit, towards the light
    number cosine;   ///< of the angle between that and the surface's normal, above 0
    color radiance;  ///< of an emitter; of a lamp, its colour at this distance
    number density;  ///< of choosing this direction, per steradian; infinite if there was no choice
};

/// The light of a lamp, or nothing if the recorded point lies in its shadow (Appel 1968).
std::optional<incoming_light> light_of(const point_light& lamp, const world& world, const hit_record& rec);

/// Light that reaches the recorded point from a place on some emitter, chosen evenly over the area of one of them;
/// nothing if there is something in between.
std::optional<incoming_light> sample_emitter(const world& world, const hit_record& rec, sampler& sampler);

/// The density with which `sample_emitter` would have chosen the way of the ray `r` that hit `rec`. 0 if it never
/// would.
number emitter_density(const world& world, const ray& r, const hit_record& rec);

}  // namespace render
