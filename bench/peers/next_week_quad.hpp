#pragma once

#include <cmath>

#include <raio/shape/parallelogram.hpp>

#include "peers/record.hpp"

namespace peers {

/// The quadrilateral of "Ray Tracing: The Next Week": the plane with an absolute epsilon, then the coordinates of the
/// point by two triple products.
template <class T>
struct next_week_quad {
    static constexpr const char* name = "next_week_quad";
    using result = record<T>;

    raio::vec3<T> corner, u, v, normal, w;
    T height;

    explicit next_week_quad(const raio::parallelogram<T>& shape)
        : corner(shape.corner), u(shape.edge_u), v(shape.edge_v) {
        const raio::vec3<T> n = raio::cross(u, v);
        normal = raio::normalize(n);
        height = raio::dot(normal, corner);
        w = n / raio::dot(n, n);
    }

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        const T speed = raio::dot(normal, ray.direction);
        if (std::abs(speed) < T(1e-8)) return false;
        const T t = (height - raio::dot(normal, ray.origin)) / speed;
        if (!(t_min <= t && t <= t_max)) return false;
        const raio::vec3<T> point = ray.origin + ray.direction * t, from_corner = point - corner;
        const T alpha = raio::dot(w, raio::cross(from_corner, v)), beta = raio::dot(w, raio::cross(u, from_corner));
        if (!(T(0) <= alpha && alpha <= T(1) && T(0) <= beta && beta <= T(1))) return false;
        rec.t = t;
        rec.point = point;
        rec.face(ray, normal);
        return true;
    }
};

}  // namespace peers
