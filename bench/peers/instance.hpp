#pragma once

#include <raio/math/transform.hpp>

#include "peers/one_weekend.hpp"

namespace peers {

/// An instance as the textbooks have it: the ray through the inverse matrix, the point through the matrix, the normal
/// through the inverse transpose, all as they stand in T. The sphere is that of *One Weekend*.
template <class T>
struct instance {
    static constexpr const char* name = "instance";
    using result = record<T>;

    one_weekend_sphere<T> sphere;
    raio::transform<T> map;
    raio::vec3<T> x, y, z;  // the rows of the inverse

    template <class Transformed>
    explicit instance(const Transformed& from) : sphere(from.primitive()), map(from.map()) {
        const raio::vec3<T> across = raio::cross(map.y, map.z);
        const T over_det = T(1) / raio::dot(map.x, across);
        x = across * over_det, y = raio::cross(map.z, map.x) * over_det, z = raio::cross(map.x, map.y) * over_det;
    }

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        const auto inverse = [this](const raio::vec3<T>& v) {
            return raio::vec3<T>(raio::dot(x, v), raio::dot(y, v), raio::dot(z, v));
        };
        const raio::ray<T> back{inverse(ray.origin - map.origin), inverse(ray.direction)};
        if (!sphere(back, t_min, t_max, rec)) return false;
        rec.point = map.linear(rec.point) + map.origin;
        rec.normal = raio::normalize(x * rec.normal.x + y * rec.normal.y + z * rec.normal.z);
        return true;
    }
};

}  // namespace peers
