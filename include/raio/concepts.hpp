#pragma once

#include <raio/push_macros.hpp>

#include <raio/proof/settle.hpp>

/// \file
/// What can be asked of a shape. Whatever answers is a primitive, whether it is one triangle or a tree of them.

namespace raio::inline RAIO_ABI {

/// The number type of a shape.
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

/// Are they all made of the same numbers? Nothing is converted in secret: `sphere<float>` and `sphere<double>` do not
/// mix.
template <class First, class... Rest>
concept of_one_number_type = (std::same_as<number_t<First>, number_t<Rest>> && ...);

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

/// Does the shape have a formula, which takes any line? (Packs are asked lane by lane.)
template <class P>
concept has_formula = !has_lanes<number_t<P>> && requires(const P shape, const mapped_line<exact_t<number_t<P>>> line) {
    shape.crossings(line);
};

// The three questions, put with a ray as it is or mapped. What knows plain rays only is asked with the mapped one,
// rounded.

template <primitive P, class Ray, record Record>
RAIO_FN constexpr mask_t<number_t<P>> hit(const P& shape, const Ray& ray, number_t<P> t_min, number_t<P> t_max,
                                          Record& rec) {
    using T = number_t<P>;
    if constexpr (requires { shape.hit(ray, t_min, t_max, rec); }) {
        return shape.hit(ray, t_min, t_max, rec);
    } else if constexpr (has_formula<P>) {
        return first_hit(shape, ray, t_min, t_max, rec);
    } else {
        hit_record<T> own;
        if constexpr (is_mapped<Ray>) {
            if (!shape.hit(ray.rounded(), t_min, t_max, own)) return false;
            own = ray.seen(own);
        } else {
            if (!shape.hit(ray, t_min, t_max, own)) return false;
        }
        assign(rec, own);
        return true;
    }
}

template <primitive P, class Ray>
RAIO_FN constexpr mask_t<number_t<P>> occluded(const P& shape, const Ray& ray, number_t<P> t_min, number_t<P> t_max) {
    if constexpr (requires { shape.occluded(ray, t_min, t_max); }) {
        return shape.occluded(ray, t_min, t_max);
    } else if constexpr (has_formula<P>) {
        return any_hit(shape, ray, t_min, t_max);
    } else {
        return shape.occluded(ray.rounded(), t_min, t_max);
    }
}

template <solid P, class Ray>
RAIO_FN constexpr auto spans_of(const P& shape, const Ray& ray) {
    if constexpr (requires { shape.spans(ray); }) {
        return shape.spans(ray);
    } else if constexpr (has_formula<P>) {
        return inside_of(shape, ray);
    } else {
        return shape.spans(ray.rounded());
    }
}

/// Along none of the axes, diagonals or other directions that shapes are made of.
template <real T>
RAIO_FN constexpr vec3<T> any_direction() {
    const auto number = [](double x) { return T(static_cast<scalar_t<T>>(x)); };
    return {number(0.5547), number(0.7193), number(0.4181)};
}

}  // namespace detail

/// Is the point in the solid, or on its surface? As exact as a ray from there. (There is `contains` of closed meshes
/// and their trees as well.)
template <solid P>
RAIO_FN constexpr mask_t<number_t<P>> contains(const P& shape, const vec3<number_t<P>>& point) {
    using T = number_t<P>;
    return detail::spans_of(shape, ray<T>{point, detail::any_direction<T>()}).contains(T(0));
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
