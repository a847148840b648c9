#pragma once

#include "support/frusta.hpp"

namespace raio::test {

struct cone_profile {
    static auto ends(const auto& s) { return std::pair(s.base, s.apex); }
    static double radius(const auto& s, double h) { return static_cast<double>(s.radius) * (1 - h); }
    static double slope(const auto& s, double) { return -static_cast<double>(s.radius); }
    static double height(const auto&, random_numbers& random) { return random.uniform(0.01, 0.99); }
};

/// What the tests know of both cones.
template <class Cone>
struct cone_subject : revolved_subject<Cone, cone_profile> {
    using T = number_t<Cone>;

    static auto fields(auto& s) { return std::tie(s.base, s.apex, s.radius); }

    static Cone random(random_numbers& random, double size, const vec3<double>& place) {
        const vec3<double> axis = random.axis() * (size * random.log_uniform(0.01, 10));
        return {vec3<T>(place), vec3<T>(place + axis), static_cast<T>(size * random.log_uniform(0.1, 1))};
    }
    static frustum<oracle> as_frustum(const auto& s) { return {s.base, s.apex, s.radius, 0}; }
    static auto distances(const auto& s, const vec3<oracle>& p) {
        return frustum_subject<frustum<T>>::distances(as_frustum(s), p);
    }
    static bool is_apex(const auto& s, const vec3<oracle>& p, const oracle& near) {
        return frustum_subject<frustum<T>>::is_apex(as_frustum(s), p, near);
    }
    static bool lies_in_side(const auto& s, const ray<oracle>& r) {
        return frustum_subject<frustum<T>>::lies_in_side(as_frustum(s), r);
    }
    static auto grown(auto s) {
        const frustum<oracle> larger = frustum_subject<frustum<T>>::grown(as_frustum(s));
        return decltype(s){larger.base, larger.top, larger.base_radius};
    }
};

template <class T>
struct subject<cone<T>> : cone_subject<cone<T>> {
    static oracle distance(const cone<oracle>& s, const vec3<oracle>& p) {
        const auto [side, caps] = cone_subject<cone<T>>::distances(s, p);
        return max(side, caps);
    }
};

template <class T>
struct subject<open_cone<T>> : cone_subject<open_cone<T>> {
    static oracle distance(const open_cone<oracle>& s, const vec3<oracle>& p) {
        const auto [side, caps] = cone_subject<open_cone<T>>::distances(s, p);
        return -max(side, caps);  // positive inside, and small near the rims and where the other side is near
    }
};

}  // namespace raio::test
