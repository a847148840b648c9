#pragma once

#include <raio/shape/surface_of_revolution.hpp>

#include "support/random.hpp"

namespace raio::test {

/// A ray to a point of the profile, where straight segments have a rim, or to anywhere near.
template <class T, std::size_t Degree>
ray<T> random_ray(const surface_of_revolution<T, Degree>& s, random_numbers& random) {
    const vec3<double> axis = to_double(s.axis), base = to_double(s.base);
    const vec2<T> at = s.profile[static_cast<std::size_t>(random.integer(0, static_cast<int>(s.profile.size()) - 1))];
    double rho = static_cast<double>(at.x), height = static_cast<double>(at.y);
    if (!random.one_in(4)) rho *= random.uniform(), height *= random.uniform(0, 1.2);
    const vec3<double> target = base + axis * height + random.perpendicular(axis) * rho;
    const double size = length(axis) * std::abs(height) + rho;
    const vec3<double> from = target + random.direction() * size * random.log_uniform(0.1, 1e3);
    ray<T> r{vec3<T>(from), vec3<T>(target - from)};
    if (random.one_in(8)) r.direction = r.direction - s.axis * (dot(r.direction, s.axis) / dot(s.axis, s.axis));
    if (random.one_in(8)) r.direction = s.axis;
    return r;
}

}  // namespace raio::test
