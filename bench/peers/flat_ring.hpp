#pragma once

#include <raio/shape/ring.hpp>

#include "peers/record.hpp"

namespace peers {

/// The ring of the textbooks: the plane, then the squared distance between the squared radii, in T as it stands.
template <class T>
struct flat_ring {
    static constexpr const char* name = "flat_ring";
    using result = record<T>;

    raio::vec3<T> center, normal;
    T inner2, outer2;

    explicit flat_ring(const raio::ring<T>& shape)
        : center(shape.center),
          normal(raio::normalize(shape.normal)),
          inner2(shape.inner_radius * shape.inner_radius),
          outer2(shape.outer_radius * shape.outer_radius) {}

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        const T t = raio::dot(normal, center - ray.origin) / raio::dot(normal, ray.direction);
        if (!(t_min <= t && t <= t_max)) return false;
        const raio::vec3<T> point = ray.origin + ray.direction * t, from_center = point - center;
        const T distance2 = raio::dot(from_center, from_center);
        if (distance2 < inner2 || distance2 > outer2) return false;
        rec.t = t;
        rec.point = point;
        rec.face(ray, normal);
        return true;
    }
};

}  // namespace peers
