#pragma once

#include <cmath>

#include <raio/compose/csg.hpp>
#include <raio/shape/sphere.hpp>

#include "peers/record.hpp"

namespace peers {

/// One sphere less another after Roth (1982): both intervals by the quadratic formula, in T as they stand.
template <class T>
struct roth_difference {
    static constexpr const char* name = "roth";
    using result = record<T>;

    raio::sphere<T> a, b;

    template <class Csg>
    explicit roth_difference(const Csg& from) : a(from.a), b(from.b) {}

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        T near, far, near_b, far_b;
        if (!interval(a, ray, near, far)) return false;
        const auto found = [&](T t, const raio::sphere<T>& s, bool inside_out) {
            if (!(t_min <= t && t <= t_max)) return false;
            rec.t = t;
            rec.point = ray.origin + ray.direction * t;
            rec.face(ray, (rec.point - s.center) * ((inside_out ? T(-1) : T(1)) / s.radius));
            return true;
        };
        const bool of_b = interval(b, ray, near_b, far_b) && near_b < far && near < far_b;
        if (!of_b) return found(near, a, false) || found(far, a, false);
        if (near < near_b && (found(near, a, false) || found(near_b, b, true))) return true;
        return far_b < far && (found(far_b, b, true) || found(far, a, false));
    }

private:
    static bool interval(const raio::sphere<T>& s, const raio::ray<T>& ray, T& near, T& far) {
        const raio::vec3<T> to_center = s.center - ray.origin;
        const T qa = raio::dot(ray.direction, ray.direction), half_b = raio::dot(ray.direction, to_center);
        const T discriminant = half_b * half_b - qa * (raio::dot(to_center, to_center) - s.radius * s.radius);
        if (discriminant < T(0)) return false;
        const T root = std::sqrt(discriminant);
        near = (half_b - root) / qa;
        far = (half_b + root) / qa;
        return true;
    }
};

}  // namespace peers
