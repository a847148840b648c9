#pragma once

#include <utility>

#include <raio/shape/box.hpp>

#include "peers/record.hpp"

namespace peers {

/// The box as it is usually written: three divisions, and the slabs' intervals intersected one after the other. A ray
/// that lies in a face gets 0 / 0 and is lost.
template <class T>
struct slabs {
    static constexpr const char* name = "slabs";
    static constexpr const char* name_with_record = "slabs_record";
    using number = T;
    struct result {
        T t;
    };

    raio::vec3<T> min, max;

    explicit slabs(const raio::box<T>& shape) : min(shape.min), max(shape.max) {}

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& found) const {
        T near = -raio::infinity<T>, far = raio::infinity<T>;
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            const T over_d = T(1) / ray.direction[axis];
            T enter = (min[axis] - ray.origin[axis]) * over_d, leave = (max[axis] - ray.origin[axis]) * over_d;
            if (over_d < T(0)) std::swap(enter, leave);
            near = enter > near ? enter : near;
            far = leave < far ? leave : far;
            if (far < near) return false;
        }
        found.t = near >= t_min ? near : far;
        return found.t >= t_min && found.t <= t_max;
    }

    /// Along the axis in which the point is farthest from the centre, measured in sizes of the box.
    raio::vec3<T> outward_normal(const raio::vec3<T>& point) const {
        const raio::vec3<T> from_center = (point - (min + max) * T(0.5)) / (max - min);
        const raio::vec3<T> distance = raio::abs(from_center);
        const glm::length_t axis =
            distance.x > distance.y ? (distance.x > distance.z ? 0 : 2) : (distance.y > distance.z ? 1 : 2);
        raio::vec3<T> normal(T(0));
        normal[axis] = from_center[axis] < T(0) ? T(-1) : T(1);
        return normal;
    }
};

}  // namespace peers
