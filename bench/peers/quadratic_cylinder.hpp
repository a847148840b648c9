#pragma once

#include <cmath>

#include <raio/shape/cylinder.hpp>

#include "peers/record.hpp"

namespace peers {

/// The cylinder of the textbooks: the quadratic formula for the endless cylinder, each root taken if it lies between
/// the caps, and each cap a disc. The nearest of the four is recorded.
template <class T>
struct quadratic_cylinder {
    static constexpr const char* name = "quadratic";
    using result = record<T>;

    raio::vec3<T> base, axis;  ///< the axis as a unit vector
    T height, radius;

    explicit quadratic_cylinder(const raio::cylinder<T>& shape)
        : base(shape.base),
          axis(raio::normalize(shape.top - shape.base)),
          height(raio::length(shape.top - shape.base)),
          radius(shape.radius) {}

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        const raio::vec3<T> from_base = ray.origin - base;
        const T d_along = raio::dot(ray.direction, axis), o_along = raio::dot(from_base, axis);
        const raio::vec3<T> d_across = ray.direction - axis * d_along, o_across = from_base - axis * o_along;
        T nearest = t_max;
        raio::vec3<T> outward;
        bool found = false;

        const T a = raio::dot(d_across, d_across), half_b = raio::dot(o_across, d_across);
        const T discriminant = half_b * half_b - a * (raio::dot(o_across, o_across) - radius * radius);
        if (discriminant < T(0)) return false;
        const T root = std::sqrt(discriminant);
        for (const T t : {(-half_b - root) / a, (-half_b + root) / a}) {
            const T along = o_along + d_along * t;
            if (t < t_min || t > nearest || along < T(0) || along > height) continue;
            nearest = t;
            outward = (o_across + d_across * t) / radius;
            found = true;
        }
        for (const T level : {T(0), height}) {
            const T t = (level - o_along) / d_along;
            const raio::vec3<T> across = o_across + d_across * t;
            if (!(t >= t_min && t <= nearest) || raio::dot(across, across) > radius * radius) continue;
            nearest = t;
            outward = level == T(0) ? -axis : axis;
            found = true;
        }
        if (!found) return false;
        rec.t = nearest;
        rec.point = ray.origin + ray.direction * nearest;
        rec.face(ray, outward);
        return true;
    }
};

}  // namespace peers
