#pragma once

#include <optional>

#include "sampler.hpp"
#include "world.hpp"

/// \file
/// What surfaces do with light: in Whitted's model, and when paths of light are traced.

namespace render {

/// The direction of light that comes along `direction` and is thrown back by a mirror with this normal.
vec3 reflected(const vec3& direction, const vec3& normal);

/// The unit direction of light that comes along the unit `direction`, goes through a surface with this normal, against
/// it, and changes its speed by the factor 1 / `ratio`: Snell's law, sin(refracted) = ratio * sin(incident). Nothing at
/// total internal reflection.
std::optional<vec3> refracted(const vec3& direction, const vec3& normal, number ratio);

/// A material as one of the course's finishes; those that are not one become what looks like them.
phong phong_of(const material& m);

/// Does the material give light of its own, when paths are traced?
bool shines(const material& m);

/// The light that the surface gives off by itself at the recorded point.
color emission(const world& world, const hit_record& rec, coding as);

/// A surface when paths are traced: shares of light that are scattered as each of three materials would do.
struct scattering {
    color matte{0}, mirror{0}, glass{0};  ///< what is left of the light; together at most 1
    number fuzz = 0, refractive_index = 1;
    number matte_chance = 0, mirror_chance = 0,
           glass_chance = 0;  ///< that `scatter` does as that material: 1 together, or 0
};

scattering scattering_at(const world& world, const hit_record& rec);

struct scattered_light {
    vec3 direction;  ///< unit
    color weight;    ///< what to multiply the light from there with
    number density;  ///< of choosing this direction, per steradian; infinite if there was no choice
};

/// Where light that leaves the recorded point against `direction`, a unit vector, may have come from. Nothing if it was
/// absorbed.
std::optional<scattered_light> scatter(const scattering& s, const vec3& direction, const hit_record& rec,
                                       sampler& sampler);

}  // namespace render
