#pragma once

#include "support/subject.hpp"

namespace raio::test {

template <class T>
struct subject<plane<T>> {
    static auto fields(auto& s) { return std::tie(s.point, s.normal); }

    static plane<T> random(random_numbers& random, double size, const vec3<double>& place) {
        return {vec3<T>(place), vec3<T>(random.axis() * size)};
    }
    static vec3<double> inner_point(const plane<T>& s, random_numbers& random) {
        const vec3<double> n = to_double(s.normal);
        return to_double(s.point) + random.perpendicular(n) * (length(n) * random.log_uniform(1e-3, 1e3));
    }
    /// Next to the horizon.
    static vec3<double> special_point(const plane<T>& s, const vec3<double>& from, random_numbers& random) {
        return from + random.perpendicular(to_double(s.normal)) * length(to_double(s.point) - from);
    }
    static oracle distance(const plane<oracle>& s, const vec3<oracle>& p) {
        return abs(dot(s.normal, vec3<oracle>(p - s.point))) / length(s.normal);
    }
};

}  // namespace raio::test
