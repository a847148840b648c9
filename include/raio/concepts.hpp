#pragma once

#include <raio/proof/settle.hpp>

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

/// Holds a primitive: is one, or points to one, as `const P*` and `std::shared_ptr<const P>` do. What holds a pointer
/// shares the primitive with others.
template <class H>
concept holder = primitive<H> || requires(const H h) {
    requires primitive<std::remove_cvref_t<decltype(*h)>>;
};

/// A primitive that a light can be made of: it has an area, and points spread evenly over it.
template <class P>
concept sampleable = primitive<P> && requires(const P shape, vec2<number_t<P>> u) {
    { shape.area() } -> std::same_as<number_t<P>>;
    shape.sample(u);
};

namespace detail {

template <holder H>
RAIO_FN constexpr const auto& held(const H& h) {
    if constexpr (primitive<H>) {
        return h;
    } else {
        return *h;
    }
}

/// The primitive that is held.
template <holder H>
using held_t = std::remove_cvref_t<decltype(held(std::declval<const H&>()))>;

/// Does the shape take rays of any precision?
template <class P, class R>
concept crossed_by = requires(const P shape, const ray<R> ray) {
    shape.template crossings<exact_t<number_t<P>>>(ray);
};

template <real T, real R>
RAIO_FN constexpr ray<T> rounded(const ray<R>& r) {
    return {vec3<T>(r.origin), vec3<T>(r.direction)};
}

// The three questions, put with a ray of any precision and answered with a normal of any. Shapes and compositions take
// both as they are. Of what knows its own number type only, the ray is rounded to it.

template <primitive P, real R, real N>
RAIO_FN constexpr mask_t<number_t<P>> hit(const P& shape, const ray<R>& ray, number_t<P> t_min, number_t<P> t_max,
                                          hit_record<number_t<P>, N>& rec) {
    using T = number_t<P>;
    if constexpr (!std::same_as<R, T> && crossed_by<P, R>) {
        return first_hit(shape, ray, t_min, t_max, rec);
    } else if constexpr (requires { shape.hit(ray, t_min, t_max, rec); }) {
        return shape.hit(ray, t_min, t_max, rec);
    } else {
        hit_record<T> own;
        const mask_t<T> met = shape.hit(rounded<T>(ray), t_min, t_max, own);
        if (any(met))
            assign(met, rec, {own.t, own.point, vec3<N>(own.normal), own.uv, own.error, own.index, own.front_face});
        return met;
    }
}

template <primitive P, real R>
RAIO_FN constexpr mask_t<number_t<P>> occluded(const P& shape, const ray<R>& ray, number_t<P> t_min,
                                               number_t<P> t_max) {
    if constexpr (!std::same_as<R, number_t<P>> && crossed_by<P, R>) {
        return any_hit(shape, ray, t_min, t_max);
    } else if constexpr (requires { shape.occluded(ray, t_min, t_max); }) {
        return shape.occluded(ray, t_min, t_max);
    } else {
        return shape.occluded(rounded<number_t<P>>(ray), t_min, t_max);
    }
}

template <solid P, real R>
RAIO_FN constexpr auto spans_of(const P& shape, const ray<R>& ray) {
    if constexpr (!std::same_as<R, number_t<P>> && crossed_by<P, R>) {
        return inside_of(shape, ray);
    } else if constexpr (requires { shape.spans(ray); }) {
        return shape.spans(ray);
    } else {
        return shape.spans(rounded<number_t<P>>(ray));
    }
}

}  // namespace detail

}  // namespace raio
