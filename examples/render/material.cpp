#include "material.hpp"

#include <algorithm>
#include <cmath>

#include <raio/shape/sphere.hpp>

namespace render {
namespace {

number greatest(const color& c) { return std::max({c.x, c.y, c.z}); }

/// The share of light that glass reflects: Schlick's approximation of Fresnel's law (Computer Graphics Forum 13(3),
/// 1994), with the angle on the side where light is faster, as it requires.
number reflectance(number cosine, number refractive_index) {
    const number straight = std::pow((1 - refractive_index) / (1 + refractive_index), 2);
    return straight + (1 - straight) * std::pow(1 - cosine, 5);
}

vec3 point_on_unit_sphere(const vec2& u) { return raio::sphere<number>{{0, 0, 0}, 1}.sample(u).point; }

/// What the glass does: reflects or refracts, each as often as it weighs.
vec3 through_glass(number refractive_index, const vec3& direction, const hit_record& rec, sampler& sampler) {
    const std::optional<vec3> straight =
        refracted(direction, rec.normal, rec.front_face ? 1 / refractive_index : refractive_index);
    if (!straight) return reflected(direction, rec.normal);
    const number cosine = -raio::dot(direction, rec.normal), cosine_behind = -raio::dot(*straight, rec.normal);
    const bool slower_behind = rec.front_face == (refractive_index > 1);
    const number reflects = reflectance(std::clamp(slower_behind ? cosine : cosine_behind, 0.0, 1.0), refractive_index);
    return sampler.next_1d() < reflects ? reflected(direction, rec.normal) : *straight;
}

phong finish_of(const phong& finish) { return finish; }
phong finish_of(const lambertian&) { return {.ambient = 0.2, .diffuse = 0.8}; }
phong finish_of(const metal&) {
    return {.ambient = 0.1, .diffuse = 0.2, .specular = 0.5, .exponent = 50, .reflected = 0.7};
}
phong finish_of(const dielectric& m) {
    return {
        .specular = 0.5, .exponent = 200, .reflected = 0.1, .transmitted = 0.9, .refractive_index = m.refractive_index};
}
phong finish_of(const emissive&) { return {.ambient = 1}; }

/// Highlights and ambient light are left out: they stand for light that is found here by itself.
scattering shares_of(const phong& m, const color& hue) {
    const number sum = m.diffuse * greatest(hue) + m.reflected + m.transmitted, at_most_1 = 1 / std::max(1.0, sum);
    return {.matte = hue * (m.diffuse * at_most_1),
            .mirror = color(m.reflected * at_most_1),
            .glass = color(m.transmitted * at_most_1),
            .refractive_index = m.refractive_index};
}
scattering shares_of(const lambertian&, const color& hue) { return {.matte = hue}; }
scattering shares_of(const metal& m, const color& hue) { return {.mirror = hue, .fuzz = m.fuzz}; }
scattering shares_of(const dielectric& m, const color& hue) {
    return {.glass = hue, .refractive_index = m.refractive_index};
}
scattering shares_of(const emissive&, const color&) { return {}; }

}  // namespace

vec3 reflected(const vec3& direction, const vec3& normal) {
    return direction - normal * (2 * raio::dot(direction, normal));
}

std::optional<vec3> refracted(const vec3& direction, const vec3& normal, number ratio) {
    const number cosine = -raio::dot(direction, normal);
    const vec3 along = (direction + normal * cosine) * ratio;  // as long as the sine of the new angle
    const number cosine2 = 1 - raio::dot(along, along);
    if (!(cosine2 > 0)) return {};
    return along - normal * std::sqrt(cosine2);
}

phong phong_of(const material& m) {
    return std::visit([](const auto& kind) { return finish_of(kind); }, m);
}

bool shines(const material& m) {
    const phong finish = phong_of(m);
    return finish.ambient > 0 && finish.diffuse == 0 && finish.specular == 0 && finish.reflected == 0 &&
           finish.transmitted == 0;
}

color emission(const world& world, const hit_record& rec, coding as) {
    const material& m = world.material_at(rec);
    if (const auto* lamp = std::get_if<emissive>(&m)) return lamp->radiance;
    return shines(m) ? world.color_at(rec, as) * phong_of(m).ambient : color(0);
}

scattering scattering_at(const world& world, const hit_record& rec) {
    const color hue = world.color_at(rec, coding::linear);
    scattering s = std::visit([&](const auto& kind) { return shares_of(kind, hue); }, world.material_at(rec));
    const number all = greatest(s.matte) + greatest(s.mirror) + greatest(s.glass);
    if (all > 0) {
        s.matte_chance = greatest(s.matte) / all;
        s.mirror_chance = greatest(s.mirror) / all;
        s.glass_chance = greatest(s.glass) / all;
    }
    return s;
}

std::optional<scattered_light> scatter(const scattering& s, const vec3& direction, const hit_record& rec,
                                       sampler& sampler) {
    const number choice = sampler.next_1d();
    if (choice < s.matte_chance) {
        // The tips of unit normals whose end is moved over the unit sphere lie as dense as the cosine with the normal.
        const vec3 sum = rec.normal + point_on_unit_sphere(sampler.next_2d());
        const number length = raio::length(sum);
        if (!(length > 0)) return {};
        const vec3 to = sum / length;
        const number cosine = raio::dot(to, rec.normal);
        if (!(cosine > 0)) return {};
        return scattered_light{to, s.matte / s.matte_chance, s.matte_chance * cosine / raio::pi<number>};
    }
    if (choice < s.matte_chance + s.mirror_chance) {
        const vec3 to = reflected(direction, rec.normal) + point_on_unit_sphere(sampler.next_2d()) * s.fuzz;
        if (!(raio::dot(to, rec.normal) > 0)) return {};
        return scattered_light{raio::normalize(to), s.mirror / s.mirror_chance, raio::infinity<number>};
    }
    if (s.glass_chance > 0) {
        const vec3 to = through_glass(s.refractive_index, direction, rec, sampler);
        return scattered_light{to, s.glass / s.glass_chance, raio::infinity<number>};
    }
    return {};
}

}  // namespace render
