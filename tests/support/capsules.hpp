#pragma once

#include "support/subject.hpp"

namespace raio::test {

template <class T>
struct subject<capsule<T>> {
    static auto fields(auto& s) { return std::tie(s.base, s.top, s.radius); }

    /// One in eight is a sphere.
    static capsule<T> random(random_numbers& random, double size, const vec3<double>& place) {
        const double height = random.one_in(8) ? 0 : size * random.log_uniform(0.1, 10);
        return {vec3<T>(place), vec3<T>(place + random.axis() * height),
                static_cast<T>(size * random.log_uniform(0.1, 1))};
    }
    static vec3<double> inner_point(const capsule<T>& s, random_numbers& random) {
        const vec3<double> base = to_double(s.base), on_axis = base + (to_double(s.top) - base) * random.uniform();
        return on_axis + random.direction() * (random.uniform(0, 0.99) * static_cast<double>(s.radius));
    }
    /// On a seam, on the axis, at a pole, or on the silhouette of one of the spheres inside.
    static vec3<double> special_point(const capsule<T>& s, const vec3<double>& from, random_numbers& random) {
        const vec3<double> base = to_double(s.base), axis = to_double(s.top) - base;
        const double r = static_cast<double>(s.radius), size = length(axis);
        const vec3<double> center = base + axis * (random.one_in(2) ? random.integer(0, 1) : random.uniform());
        const vec3<double> to_center = center - from;
        const double sine = r / length(to_center);
        switch (random.integer(0, 3)) {
            case 0:
                if (size > 0) return center + random.perpendicular(axis) * r;
                [[fallthrough]];
            case 1:
                return center;
            case 2:
                if (size > 0) return base - axis * (r / size);
                [[fallthrough]];
            default:
                if (!(sine < 1)) return center;
                return center - to_center * (sine * sine) +
                       random.perpendicular(to_center) * (r * std::sqrt(1 - sine * sine));
        }
    }
    static oracle distance(const capsule<oracle>& s, const vec3<oracle>& p) {
        const vec3<oracle> axis = s.top - s.base, from_base = p - s.base;
        const oracle size2 = dot(axis, axis);
        const oracle along = size2 > 0 ? oracle(dot(from_base, axis) / size2) : oracle(0);
        return length(vec3<oracle>(from_base - axis * max(oracle(0), min(oracle(1), along)))) - s.radius;
    }
    static capsule<oracle> grown(capsule<oracle> s) {
        s.radius *= 1 + oracle(1e-40);
        return s;
    }
};

}  // namespace raio::test
