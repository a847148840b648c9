#pragma once

#include <raio/shape/capsule.hpp>

#include "peers/one_weekend.hpp"
#include "peers/quadratic_cylinder.hpp"

namespace peers {

/// A capsule put together of the textbooks' shapes: the nearest of two spheres and a cylinder, in T as they stand. From
/// inside it would also see the parts within.
template <class T>
struct three_part_capsule {
    static constexpr const char* name = "three_parts";
    using result = record<T>;

    one_weekend_sphere<T> low, high;
    quadratic_cylinder<T> side;

    explicit three_part_capsule(const raio::capsule<T>& shape)
        : low({shape.base, shape.radius}),
          high({shape.top, shape.radius}),
          side({shape.base, shape.top, shape.radius}) {}

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        bool found = false;
        const auto ask = [&](const auto& part) {
            if (!part(ray, t_min, t_max, rec)) return;
            t_max = rec.t;
            found = true;
        };
        ask(low);
        ask(high);
        ask(side);
        return found;
    }
};

}  // namespace peers
