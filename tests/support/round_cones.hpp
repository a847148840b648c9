#pragma once

#include "support/subject.hpp"

namespace raio::test {

template <class T>
struct subject<round_cone<T>> {
    static auto fields(auto& s) { return std::tie(s.base, s.top, s.base_radius, s.top_radius); }

    /// One in eight is a sphere, one in eight a capsule; of some one sphere is inside of the other.
    static round_cone<T> random(random_numbers& random, double size, const vec3<double>& place) {
        const double height = random.one_in(8) ? 0 : size * random.log_uniform(0.1, 10);
        const T base = static_cast<T>(size * random.log_uniform(0.1, 1)),
                top = static_cast<T>(size * random.log_uniform(0.1, 1));
        return {vec3<T>(place), vec3<T>(place + random.axis() * height), base, random.one_in(8) ? base : top};
    }
    /// One of the spheres that were swept.
    static sphere<double> swept(const round_cone<T>& s, double which) {
        const vec3<double> base = to_double(s.base);
        const double low = static_cast<double>(s.base_radius), high = static_cast<double>(s.top_radius);
        return {base + (to_double(s.top) - base) * which, low + (high - low) * which};
    }
    static vec3<double> inner_point(const round_cone<T>& s, random_numbers& random) {
        const auto [center, radius] = swept(s, random.uniform());
        return center + random.direction() * (random.uniform(0, 0.99) * radius);
    }
    /// On the axis, at a pole, or on the silhouette of one of the spheres inside: at the ends, that is on a seam.
    static vec3<double> special_point(const round_cone<T>& s, const vec3<double>& from, random_numbers& random) {
        const auto [center, radius] = swept(s, random.one_in(2) ? random.integer(0, 1) : random.uniform());
        const vec3<double> axis = to_double(s.top) - to_double(s.base), to_center = center - from;
        const double size = length(axis), sine = radius / length(to_center);
        switch (random.integer(0, 2)) {
            case 0:
                return center;
            case 1:
                if (size > 0) return center + axis * ((random.one_in(2) ? radius : -radius) / size);
                [[fallthrough]];
            default:
                if (!(sine < 1)) return center;
                return center - to_center * (sine * sine) +
                       random.perpendicular(to_center) * (radius * std::sqrt(1 - sine * sine));
        }
    }
    /// From the swept sphere on which the point would lie if it were on the surface.
    static oracle distance(const round_cone<oracle>& s, const vec3<oracle>& p) {
        const vec3<oracle> axis = s.top - s.base, from_base = p - s.base;
        const oracle narrowing = s.base_radius - s.top_radius, apart = dot(axis, axis) - narrowing * narrowing;
        const oracle along = dot(from_base, axis) - s.base_radius * narrowing;
        oracle which = apart > 0 ? oracle(along / apart) : oracle(narrowing < 0 ? 1 : 0);
        which = max(oracle(0), min(oracle(1), which));
        return length(vec3<oracle>(from_base - axis * which)) - (s.base_radius - narrowing * which);
    }
    static round_cone<oracle> grown(round_cone<oracle> s) {
        s.base_radius *= 1 + oracle(1e-40);
        s.top_radius *= 1 + oracle(1e-40);
        return s;
    }
};

}  // namespace raio::test
