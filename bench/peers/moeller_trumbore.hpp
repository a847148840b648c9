#pragma once

#include <cmath>

#include <raio/ray.hpp>

#include "peers/record.hpp"

namespace peers {

/// Moeller and Trumbore (1997) as it is usually written: an absolute epsilon on the determinant, the division first,
/// and out at each test that fails.
template <class T>
struct moeller_trumbore {
    static constexpr const char* name = "moeller_trumbore";
    static constexpr const char* name_with_record = "moeller_trumbore_record";
    using number = T;
    struct result {
        T t;
        raio::vec2<T> uv;
    };

    raio::vec3<T> a, b, c;

    template <class Triangle>
    explicit moeller_trumbore(const Triangle& shape) : a(shape.a), b(shape.b), c(shape.c) {}

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& found) const {
        const raio::vec3<T> e1 = b - a, e2 = c - a;
        const raio::vec3<T> p = raio::cross(ray.direction, e2);
        const T det = raio::dot(e1, p);
        if (std::abs(det) < T(1e-8)) return false;

        const T over_det = T(1) / det;
        const raio::vec3<T> s = ray.origin - a;
        const T u = raio::dot(s, p) * over_det;
        if (u < T(0) || u > T(1)) return false;

        const raio::vec3<T> q = raio::cross(s, e1);
        const T v = raio::dot(ray.direction, q) * over_det;
        if (v < T(0) || u + v > T(1)) return false;

        const T t = raio::dot(e2, q) * over_det;
        if (t < t_min || t > t_max) return false;
        found = {t, {u, v}};
        return true;
    }

    raio::vec3<T> outward_normal(const raio::vec3<T>&) const { return raio::normalize(raio::cross(b - a, c - a)); }
};

}  // namespace peers
