#pragma once

#include <cmath>

#include <raio/shape/sphere.hpp>

#include "peers/record.hpp"

namespace peers {

/// The sphere of *Ray Tracing in One Weekend* (Shirley, Black and Hollasch): the quadratic formula with half of b, the
/// nearer root that lies inside the window, and a record of point, normal, t and side.
template <class T>
struct one_weekend_sphere {
    static constexpr const char* name = "one_weekend";
    using result = record<T>;

    raio::vec3<T> center;
    T radius;

    explicit one_weekend_sphere(const raio::sphere<T>& shape) : center(shape.center), radius(shape.radius) {}

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        const raio::vec3<T> to_center = center - ray.origin;
        const T a = raio::dot(ray.direction, ray.direction);
        const T half_b = raio::dot(ray.direction, to_center);
        const T c = raio::dot(to_center, to_center) - radius * radius;
        const T discriminant = half_b * half_b - a * c;
        if (discriminant < T(0)) return false;

        const T root = std::sqrt(discriminant);
        T t = (half_b - root) / a;
        if (t <= t_min || t >= t_max) {
            t = (half_b + root) / a;
            if (t <= t_min || t >= t_max) return false;
        }
        rec.t = t;
        rec.point = ray.origin + ray.direction * t;
        rec.face(ray, (rec.point - center) / radius);
        return true;
    }
};

}  // namespace peers
