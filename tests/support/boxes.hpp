#pragma once

#include "support/subject.hpp"

namespace raio::test {

template <class T>
struct subject<box<T>> {
    static auto fields(auto& s) { return std::tie(s.min, s.max); }

    /// One in four is flat or nearly so.
    static box<T> random(random_numbers& random, double size, const vec3<double>& place) {
        vec3<double> half(size * random.uniform(0.1, 1), size * random.uniform(0.1, 1), size * random.uniform(0.1, 1));
        if (random.one_in(4)) half[random.integer(0, 2)] *= random.one_in(2) ? 0 : 1e-6;
        return {vec3<T>(place - half), vec3<T>(place + half)};
    }
    /// Of three small whole numbers each, the smaller ones first.
    static box<T> lattice(random_numbers& random) {
        box<T> s{};
        for (glm::length_t i = 0; i < 3; ++i) {
            s.min[i] = T(random.integer(-3, 2));
            s.max[i] = s.min[i] + T(random.integer(0, 3));
        }
        return s;
    }
    static vec3<double> at(const box<T>& s, double x, double y, double z) {
        return to_double(s.min) + (to_double(s.max) - to_double(s.min)) * vec3<double>(x, y, z);
    }
    static vec3<double> inner_point(const box<T>& s, random_numbers& random) {
        return at(s, random.uniform(0.01, 0.99), random.uniform(0.01, 0.99), random.uniform(0.01, 0.99));
    }
    /// On an edge, or a vertex.
    static vec3<double> special_point(const box<T>& s, const vec3<double>&, random_numbers& random) {
        vec3<double> corner(random.integer(0, 1), random.integer(0, 1), random.integer(0, 1));
        if (random.one_in(2)) corner[random.integer(0, 2)] = random.uniform();
        return at(s, corner.x, corner.y, corner.z);
    }
    static oracle distance(const box<oracle>& s, const vec3<oracle>& p) {
        oracle above = -infinity<oracle>;
        for (glm::length_t i = 0; i < 3; ++i) above = max(above, max(oracle(s.min[i] - p[i]), oracle(p[i] - s.max[i])));
        return above;
    }
    static box<oracle> grown(const box<oracle>& s) {
        const vec3<oracle> more = (s.max - s.min) * oracle(1e-40);
        return {s.min - more, s.max + more};
    }
};

}  // namespace raio::test
