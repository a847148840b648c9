#pragma once

#include <raio/shape/watertight_triangle.hpp>

namespace peers {

/// Woop, Benthin and Wald (JCGT 2(1), 2013) in the precision of T alone, without the wider fallback for edges.
template <class T>
struct woop {
    static constexpr const char* name = "woop";
    struct result {
        T t;
        raio::vec2<T> uv;
    };

    raio::vec3<T> a, b, c;

    explicit woop(const raio::watertight_triangle<T>& shape) : a(shape.a), b(shape.b), c(shape.c) {}

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& found) const {
        const raio::vec3<T> size = raio::abs(ray.direction);
        const glm::length_t z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        const glm::length_t x = (z + 1) % 3, y = (z + 2) % 3;
        const T scale = T(1) / ray.direction[z];
        const T shear_x = ray.direction[x] * scale, shear_y = ray.direction[y] * scale;

        const raio::vec3<T> p = a - ray.origin, q = b - ray.origin, r = c - ray.origin;
        const T px = p[x] - shear_x * p[z], py = p[y] - shear_y * p[z];
        const T qx = q[x] - shear_x * q[z], qy = q[y] - shear_y * q[z];
        const T rx = r[x] - shear_x * r[z], ry = r[y] - shear_y * r[z];
        const T u = rx * qy - ry * qx, v = px * ry - py * rx, w = qx * py - qy * px;
        if ((u < T(0) || v < T(0) || w < T(0)) && (u > T(0) || v > T(0) || w > T(0))) return false;

        const T det = u + v + w;
        if (det == T(0)) return false;
        const T over_det = T(1) / det;
        const T t = (u * p[z] + v * q[z] + w * r[z]) * scale * over_det;
        if (t < t_min || t > t_max) return false;
        found = {t, {v * over_det, w * over_det}};
        return true;
    }
};

}  // namespace peers
