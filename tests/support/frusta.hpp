#pragma once

#include "support/revolved.hpp"

namespace raio::test {

struct frustum_profile {
    static auto ends(const auto& s) { return std::pair(s.base, s.top); }
    static double radius(const auto& s, double h) {
        return static_cast<double>(s.base_radius) * (1 - h) + static_cast<double>(s.top_radius) * h;
    }
    static double slope(const auto& s, double) {
        return static_cast<double>(s.top_radius) - static_cast<double>(s.base_radius);
    }
    static double height(const auto&, random_numbers& random) { return random.uniform(0.01, 0.99); }
};

/// What the tests know of both frusta.
template <class Frustum>
struct frustum_subject : revolved_subject<Frustum, frustum_profile> {
    using T = number_t<Frustum>;

    static auto fields(auto& s) { return std::tie(s.base, s.top, s.base_radius, s.top_radius); }

    /// One in four comes to a point, one in eight is a cylinder.
    static Frustum random(random_numbers& random, double size, const vec3<double>& place) {
        const vec3<double> axis = random.axis() * (size * random.log_uniform(0.01, 10));
        Frustum s{vec3<T>(place), vec3<T>(place + axis), static_cast<T>(size * random.log_uniform(0.1, 1)),
                  static_cast<T>(size * random.log_uniform(0.1, 1))};
        if (random.one_in(8)) s.base_radius = s.top_radius;
        if (random.one_in(4)) (random.one_in(2) ? s.base_radius : s.top_radius) = T(0);
        return s;
    }
    static Frustum lattice(random_numbers& random) {
        Frustum s{{}, {}, T(random.integer(0, 3)), T(random.integer(0, 3))};
        for_each_number(s.base, [&](T& x) { x = T(random.integer(-3, 3)); });
        for_each_number(s.top, [&](T& x) { x = T(random.integer(-3, 3)); });
        return s;
    }
    /// To the side and to the planes of the caps, below 0 inside. Where these meet at an obtuse angle, the way inwards
    /// from one leads away from the other: both are said shorter, so that edges count as edges (see away_from_edges).
    static std::pair<oracle, oracle> distances(const auto& s, const vec3<oracle>& p) {
        const auto at = frustum_subject::coordinates(s.base, s.top, p);
        const oracle widening = s.top_radius - s.base_radius, beyond = at.rho - s.base_radius - widening * at.height;
        const oracle slant = sqrt(oracle(at.size * at.size + widening * widening));
        const oracle obtuse = 1 + abs(widening) / slant;
        return {beyond * at.size / slant / obtuse, at.beyond_caps() / obtuse};
    }
    /// Longer along its generators, and by less than that wider: what meets a rim meets the side then. Only an apex
    /// stays one.
    static auto grown(auto s) {
        const oracle low = s.base_radius, high = s.top_radius, widening = high - low, wider = max(low, high) * 3e-50;
        const vec3<oracle> axis = s.top - s.base;
        const oracle down(low > 0 ? 1e-21 : 1e-50), up(high > 0 ? 1e-21 : 1e-50);
        s.base -= axis * down;
        s.top += axis * up;
        if (low > 0) s.base_radius += wider - widening * down;
        if (high > 0) s.top_radius += wider + widening * up;
        return s;
    }
    /// Does it come to a point, and is it that one?
    static bool is_apex(const auto& s, const vec3<oracle>& p, const oracle& near) {
        if (s.base_radius * s.top_radius != 0 || !(s.base_radius + s.top_radius > 0)) return false;
        return norm1(p - (s.base_radius == 0 ? s.base : s.top)) <= near;
    }
    /// Does the line lie in the side? Three of its points do then.
    static bool lies_in_side(const auto& s, const ray<oracle>& r) {
        const vec3<oracle> axis = s.top - s.base;
        const oracle rising = dot(r.direction, axis), size = norm1(axis);
        if (rising == 0) return false;
        for (const double height : {0.0, 0.5, 1.0}) {
            const vec3<oracle> center = s.base + axis * oracle(height);
            const vec3<oracle> p = r.origin + r.direction * (dot(center - r.origin, axis) / rising);
            if (abs(distances(s, p).first) > size * 1e-40) return false;
        }
        return true;
    }
};

template <class T>
struct subject<frustum<T>> : frustum_subject<frustum<T>> {
    static oracle distance(const frustum<oracle>& s, const vec3<oracle>& p) {
        const auto [side, caps] = frustum_subject<frustum<T>>::distances(s, p);
        return max(side, caps);
    }
};

template <class T>
struct subject<open_frustum<T>> : frustum_subject<open_frustum<T>> {
    static oracle distance(const open_frustum<oracle>& s, const vec3<oracle>& p) {
        const auto [side, caps] = frustum_subject<open_frustum<T>>::distances(s, p);
        return -max(side, caps);  // positive inside, and small near the rims and where the other side is near
    }
};

}  // namespace raio::test
