#pragma once

#include "support/revolved.hpp"

namespace raio::test {

struct paraboloid_profile {
    static auto ends(const auto& s) { return std::pair(s.vertex, s.top); }
    static double radius(const auto& s, double h) { return static_cast<double>(s.radius) * std::sqrt(h); }
    static double slope(const auto& s, double h) { return static_cast<double>(s.radius) * 0.5 / std::sqrt(h); }
    static double height(const auto&, random_numbers& random) { return random.uniform(0.01, 0.99); }
};

/// What the tests know of both paraboloids.
template <class Paraboloid>
struct paraboloid_subject : revolved_subject<Paraboloid, paraboloid_profile> {
    using T = number_t<Paraboloid>;

    static auto fields(auto& s) { return std::tie(s.vertex, s.top, s.radius); }

    static Paraboloid random(random_numbers& random, double size, const vec3<double>& place) {
        const vec3<double> axis = random.axis() * (size * random.log_uniform(0.01, 10));
        return {vec3<T>(place), vec3<T>(place + axis), static_cast<T>(size * random.log_uniform(0.1, 1))};
    }
    static Paraboloid lattice(random_numbers& random) {
        Paraboloid s{{}, {}, T(random.integer(0, 3))};
        for_each_number(s.vertex, [&](T& x) { x = T(random.integer(-3, 3)); });
        for_each_number(s.top, [&](T& x) { x = T(random.integer(-3, 3)); });
        return s;
    }
    /// To the side, as its gradient tells near it, and to the planes of the caps, below 0 inside.
    static std::pair<oracle, oracle> distances(const auto& s, const vec3<oracle>& p) {
        const auto at = paraboloid_subject::coordinates(s.vertex, s.top, p);
        const oracle r2 = s.radius * s.radius, slope = r2 / at.size;
        const oracle gradient = sqrt(oracle(4 * at.rho * at.rho + slope * slope));
        return {(at.rho * at.rho - r2 * at.height) / gradient, at.beyond_caps()};
    }
    static auto grown(auto s) {
        const oracle more(1e-21), wider = 1 + oracle(1e-50);
        const vec3<oracle> axis = s.top - s.vertex;
        s.vertex -= axis * oracle(1e-50);
        s.top += axis * more;
        s.radius *= sqrt(oracle(1 + more)) * wider;
        return s;
    }
};

template <class T>
struct subject<paraboloid<T>> : paraboloid_subject<paraboloid<T>> {
    static oracle distance(const paraboloid<oracle>& s, const vec3<oracle>& p) {
        const auto [side, caps] = paraboloid_subject<paraboloid<T>>::distances(s, p);
        return max(side, caps);
    }
};

template <class T>
struct subject<open_paraboloid<T>> : paraboloid_subject<open_paraboloid<T>> {
    static oracle distance(const open_paraboloid<oracle>& s, const vec3<oracle>& p) {
        const auto [side, caps] = paraboloid_subject<open_paraboloid<T>>::distances(s, p);
        return -max(side, caps);  // positive inside, and small near the rim
    }
};

}  // namespace raio::test
