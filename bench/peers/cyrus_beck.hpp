#pragma once

#include <raio/shape/convex_polyhedron.hpp>

#include "peers/record.hpp"

namespace peers {

/// Cyrus and Beck (1978), Haines (Graphics Gems II, 1991): a division for every plane, and out as soon as the interval
/// is empty.
template <class T, class Planes>
struct cyrus_beck {
    static constexpr const char* name = "cyrus_beck";
    static constexpr const char* name_with_record = "cyrus_beck_record";
    using number = T;
    struct result {
        T t;
    };

    Planes planes;

    explicit cyrus_beck(const raio::convex_polyhedron<T, Planes>& shape) : planes(shape.planes) {}

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& found) const {
        T near = -raio::infinity<T>, far = raio::infinity<T>;
        for (const auto& plane : planes) {
            const T height = raio::dot(plane.normal, ray.origin) + plane.offset;
            const T speed = raio::dot(plane.normal, ray.direction);
            if (speed == T(0)) {
                if (height > T(0)) return false;
                continue;
            }
            const T t = -height / speed;
            if (speed < T(0)) {
                near = t > near ? t : near;
            } else {
                far = t < far ? t : far;
            }
            if (near > far) return false;
        }
        found.t = near >= t_min ? near : far;
        return found.t >= t_min && found.t <= t_max;
    }

    /// Of the plane that the point is nearest to, as no face was remembered.
    raio::vec3<T> outward_normal(const raio::vec3<T>& point) const {
        T nearest = -raio::infinity<T>;
        raio::vec3<T> normal(T(0));
        for (const auto& plane : planes) {
            const T height = raio::dot(plane.normal, point) + plane.offset;
            if (height <= nearest) continue;
            nearest = height;
            normal = plane.normal;
        }
        return raio::normalize(normal);
    }
};

}  // namespace peers
