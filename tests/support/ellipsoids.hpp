#pragma once

#include "support/subject.hpp"

namespace raio::test {

template <class T>
struct subject<ellipsoid<T>> {
    static auto fields(auto& s) { return std::tie(s.center, s.radii); }

    /// Needles and plates down to 1e-4.
    static ellipsoid<T> random(random_numbers& random, double size, const vec3<double>& place) {
        const auto radius = [&] {
            return static_cast<T>(random.one_in(2) ? size
                                                   : size * random.log_uniform(random.one_in(4) ? 1e-4 : 0.1, 1));
        };
        const T x = radius(), y = radius();
        return {vec3<T>(place), {x, y, radius()}};
    }
    static ellipsoid<T> lattice(random_numbers& random) {
        ellipsoid<T> s;
        for_each_number(s.center, [&](T& x) { x = T(random.integer(-3, 3)); });
        for_each_number(s.radii, [&](T& x) { x = T(random.integer(random.one_in(8) ? -1 : 1, 3)); });
        return s;
    }
    static vec3<double> inner_point(const ellipsoid<T>& s, random_numbers& random) {
        return to_double(s.center) + random.direction() * random.uniform(0, 0.99) * to_double(s.radii);
    }
    /// Where it touches its bounds or elsewhere on it, or on the silhouette, which is that of the sphere that it is
    /// mapped to.
    static vec3<double> special_point(const ellipsoid<T>& s, const vec3<double>& from, random_numbers& random) {
        const vec3<double> to_center = (to_double(s.center) - from) / to_double(s.radii);
        const double sine = 1 / length(to_center);
        if (random.one_in(4)) return to_double(s.center) + random.axis() * to_double(s.radii);
        if (sine > 1) return to_double(s.center);
        const vec3<double> on_sphere =
            random.perpendicular(to_center) * std::sqrt(1 - sine * sine) - to_center * (sine * sine);
        return to_double(s.center) + on_sphere * to_double(s.radii);
    }
    /// As its gradient tells near it.
    static oracle distance(const ellipsoid<oracle>& s, const vec3<oracle>& p) {
        const vec3<oracle> unit = (p - s.center) / s.radii;
        const oracle off = dot(unit, unit) - 1;
        return off / (2 * length(vec3<oracle>(unit / s.radii)));
    }
    static ellipsoid<oracle> grown(ellipsoid<oracle> s) {
        s.radii *= 1 + oracle(1e-50);
        return s;
    }
};

}  // namespace raio::test
