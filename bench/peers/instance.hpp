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
    raio::linear_inverse<T> inverse;

    template <class Transformed>
    explicit instance(const Transformed& from) : sphere(from.primitive()), map(from.map()), inverse(from.map()) {}

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        const raio::ray<T> back{inverse(ray.origin - map.origin), inverse(ray.direction)};
        if (!sphere(back, t_min, t_max, rec)) return false;
        rec.point = map.linear(rec.point) + map.origin;
        rec.normal = raio::normalize(inverse.transposed(rec.normal));
        return true;
    }
};

}  // namespace peers
