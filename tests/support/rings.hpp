#pragma once

#include "support/subject.hpp"

namespace raio::test {

template <class T>
struct subject<ring<T>> {
    static auto fields(auto& s) { return std::tie(s.center, s.normal, s.inner_radius, s.outer_radius); }

    /// One in four is as thin as a wire, one in four has no hole.
    static ring<T> random(random_numbers& random, double size, const vec3<double>& place) {
        const double inner = random.one_in(4) ? 0.999 : random.one_in(3) ? 0 : random.uniform(0, 0.9);
        return {vec3<T>(place), vec3<T>(random.axis() * random.uniform(0.5, 2)), static_cast<T>(size * inner),
                static_cast<T>(size)};
    }
    static vec3<double> at(const ring<T>& s, double across, random_numbers& random) {
        const double inner = static_cast<double>(s.inner_radius), outer = static_cast<double>(s.outer_radius);
        return to_double(s.center) + random.perpendicular(to_double(s.normal)) * (inner + across * (outer - inner));
    }
    static vec3<double> inner_point(const ring<T>& s, random_numbers& random) {
        return at(s, random.uniform(0.01, 0.99), random);
    }
    /// On one of the rims, or in the centre.
    static vec3<double> special_point(const ring<T>& s, const vec3<double>&, random_numbers& random) {
        return random.one_in(4) ? to_double(s.center) : at(s, random.integer(0, 1), random);
    }
    static oracle distance(const ring<oracle>& s, const vec3<oracle>& p) {
        const vec3<oracle> from_center = p - s.center;
        const oracle height = abs(dot(s.normal, from_center)) / length(s.normal), rho = length(from_center);
        return max(height, oracle(max(oracle(rho - s.outer_radius), oracle(s.inner_radius - rho))));
    }
    static ring<oracle> grown(ring<oracle> s) {
        if (!(s.outer_radius > s.inner_radius)) return s;  // nothing at all
        s.outer_radius *= 1 + oracle(1e-40);
        s.inner_radius *= 1 - oracle(1e-40);
        return s;
    }
};

}  // namespace raio::test
