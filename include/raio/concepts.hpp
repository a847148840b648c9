#pragma once

#include <raio/crossing.hpp>

/// \file
/// What can be asked of a shape. Whatever answers is a primitive, whether it is one triangle or a tree of them.

namespace raio {

/// The number type of a shape: that of the corner of its bounds, for all that have bounds.
template <class P>
using number_t = typename P::number;

/// A surface that rays meet.
template <class P>
concept primitive = real<number_t<P>> &&
    requires(const P shape, const ray<number_t<P>> ray, number_t<P> t, hit_record<number_t<P>> rec) {
    { shape.hit(ray, t, t, rec) } -> std::same_as<mask_t<number_t<P>>>;
    { shape.occluded(ray, t, t) } -> std::same_as<mask_t<number_t<P>>>;
};

/// A primitive that knows a box around every point it can return.
template <class P>
concept bounded = primitive<P> && requires(const P shape) {
    { shape.bounds() } -> std::same_as<aabb<number_t<P>>>;
};

/// A primitive with an inside: it says which part of a ray lies there.
template <class P>
concept solid = primitive<P> && requires(const P shape, const ray<number_t<P>> ray) {
    shape.spans(ray);
};

/// A primitive that a light can be made of: it has an area, and points spread evenly over it.
template <class P>
concept sampleable = primitive<P> && requires(const P shape, vec2<number_t<P>> u) {
    { shape.area() } -> std::same_as<number_t<P>>;
    shape.sample(u);
};

}  // namespace raio
