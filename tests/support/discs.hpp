#pragma once

#include "support/subject.hpp"

namespace raio::test {

template <class T>
struct subject<disc<T>> {
    static auto fields(auto& s) { return std::tie(s.center, s.normal, s.radius); }

    static disc<T> random(random_numbers& random, double size, const vec3<double>& place) {
        return {vec3<T>(place), vec3<T>(random.axis() * random.uniform(0.5, 2)), static_cast<T>(size)};
    }
    static vec3<double> at(const disc<T>& s, double rho, random_numbers& random) {
        return to_double(s.center) + random.perpendicular(to_double(s.normal)) * (rho * static_cast<double>(s.radius));
    }
    static vec3<double> inner_point(const disc<T>& s, random_numbers& random) {
        return at(s, random.uniform(0, 0.99), random);
    }
    /// On the rim, or in the centre.
    static vec3<double> special_point(const disc<T>& s, const vec3<double>&, random_numbers& random) {
        return at(s, random.one_in(4) ? 0 : 1, random);
    }
    static oracle distance(const disc<oracle>& s, const vec3<oracle>& p) {
        const vec3<oracle> from_center = p - s.center;
        const oracle height = abs(dot(s.normal, from_center)) / length(s.normal);
        return max(height, oracle(length(from_center) - s.radius));
    }
    static disc<oracle> grown(disc<oracle> s) {
        s.radius *= 1 + oracle(1e-40);
        return s;
    }
};

}  // namespace raio::test
