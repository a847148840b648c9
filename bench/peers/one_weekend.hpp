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

/// The same, as *Ray Tracing: The Next Week* goes on: with uv, from an arc cosine and an arc tangent.
template <class T>
struct next_week_sphere : one_weekend_sphere<T> {
    static constexpr const char* name = "next_week";
    using one_weekend_sphere<T>::one_weekend_sphere;

    struct result : record<T> {
        raio::vec2<T> uv;
    };

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        if (!one_weekend_sphere<T>::operator()(ray, t_min, t_max, rec)) return false;
        const raio::vec3<T> outward = rec.front_face ? rec.normal : -rec.normal;
        const T theta = std::acos(-outward.y), phi = std::atan2(-outward.z, outward.x) + raio::pi<T>;
        rec.uv = {phi / (T(2) * raio::pi<T>), theta / raio::pi<T>};
        return true;
    }
};

}  // namespace peers
