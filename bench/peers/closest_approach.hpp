#pragma once

#include <cmath>

#include <raio/shape/sphere.hpp>

namespace peers {

/// A sphere in plain floats, as a careful author of a callback writes it: the closest approach to the centre, the
/// squared distance there as a difference of vectors, and no more than t and the normal.
template <class T>
struct closest_approach_sphere {
    struct result {
        T t;
        raio::vec3<T> normal;  ///< of any length
    };

    raio::vec3<T> center;
    T radius;

    explicit closest_approach_sphere(const raio::sphere<T>& shape) : center(shape.center), radius(shape.radius) {}

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& found) const {
        const raio::vec3<T> to_center = center - ray.origin;
        const T over_a = T(1) / raio::dot(ray.direction, ray.direction);
        const T closest = raio::dot(to_center, ray.direction) * over_a;
        const raio::vec3<T> across = to_center - ray.direction * closest;
        const T left = radius * radius - raio::dot(across, across);
        if (left < T(0)) return false;
        const T half_chord = std::sqrt(left * over_a), near = closest - half_chord, far = closest + half_chord;
        found.t = near >= t_min ? near : far;
        found.normal = ray.direction * found.t - to_center;
        return found.t >= t_min && found.t <= t_max;
    }
};

}  // namespace peers
