#pragma once

#include <raio/proof/crossing.hpp>

/// \file
/// How the last bits of a crossing's t are found.
///
/// Iterative refinement (Wilkinson, Rounding Errors in Algebraic Processes, 1963): once t is known to all but its last
/// bits, only how far the point at t lies from the surface has to be computed in twice the precision. What is missing
/// of t follows from that in once the precision, since all but its first bits are beyond those of t.

namespace raio {

/// A point close to a crossing, seen from another, and the bound of its error, which is the sum of its components'.
template <class X>
struct nearby_point {
    vec3<X> place;
    bound_t<X> error;
};

/// A ray that has gone a step, in the precision of X, to a point close to its crossing.
template <class X, class W>
struct nearby_ray {
    vec3<exact_t<W>> origin;
    vec3<X> step;
    vec3<W> direction;

    template <real T>
    RAIO_FN constexpr nearby_point<X> seen_from(const vec3<T>& base) const {
        using E = bound_t<X>;
        vec3<X> from_base = difference_as<X>(origin, base);
        E terms = norm1(vec3<E>(from_base)) + norm1(vec3<E>(step));
        return {from_base + step, E(4 * unit_roundoff<X>) * terms};
    }
};

/// What is missing of a crossing with a surface where a function of the point is zero: one step of Newton's method.
/// \param value        of the function at c.t
/// \param slope_error  how far its slope may be from `slope` anywhere within c.error of c.t
template <class X, class W>
RAIO_FN constexpr crossing<W> newton_step(const X& value, const bound_t<X>& value_error, const W& slope,
                                          const bound_t<X>& slope_error) {
    // The smallest normal number stands for all that underflows.
    return cross_zero(W(value), value_error + bound_t<X>(least_normal<X>), slope_of<W>(slope, slope_error));
}

/// The same, where one step has left nothing of t that the point or the normal could notice, and not certain elsewhere:
/// near a tangent it may leave as much as decides their last bits. (2^-72 of a place is 2^-19 of the last bit of a
/// double.)
template <class X, class W>
RAIO_FN constexpr crossing<W> if_to_all_digits(crossing<W> missing, const nearby_ray<X, W>& ray,
                                               double part = 0x1p-72) {
    using E = bound_t<X>;
    E place = norm1(vec3<E>(ray.origin)) + norm1(vec3<E>(ray.step)),
      off = norm1(vec3<E>(ray.direction)) * missing.error;
    missing.certain = every(missing.certain, off <= E(part) * place);
    return missing;
}

/// The same crossing in the precision of X. The shape's `correction(nearby, c)` is that crossing as the ray from c.t on
/// meets it, in the precision of W.
template <class X, class Shape, real R, class W>
RAIO_FN constexpr crossing<X> refined(const Shape& shape, const ray<R>& ray, const crossing<W>& c) {
    using E = bound_t<X>;
    vec3<exact_t<W>> origin(ray.origin);
    nearby_ray<X, W> nearby{origin, product_as<X>(ray.direction, c.t), vec3<W>(ray.direction)};
    crossing<W> missing = shape.correction(nearby, c);
    X t = sum_as<X>(c.t, missing.t);
    if constexpr (!std::same_as<exact_t<W>, W>) {
        // What a ray of more digits meets is mapped on, as unevenly as may be: a millionth of the normal may become all
        // of it. Where one step has left too much for that, a second one follows.
        constexpr double part = 0x1p-88;
        crossing<W> close = if_to_all_digits(missing, nearby, part);
        if (missing.certain && !close.certain) {
            crossing<W> closer = c;
            closer.t = W(t), closer.u = c.u + missing.u, closer.v = c.v + missing.v;
            closer.error = missing.error + E(4 * unit_roundoff<X>) * abs(E(t));
            nearby.step = product_as<X>(ray.direction, t);
            close = if_to_all_digits(shape.correction(nearby, closer), nearby, part);
            t = t + X(close.t), close.u = close.u + missing.u, close.v = close.v + missing.v;
        }
        missing = close;
    }
    E error = missing.error + E(4 * unit_roundoff<X>) * abs(E(t));
    // What cannot be told from a number of W is that number: simple rays meet simple shapes at simple points.
    W simple(t);
    E beyond = abs(E(t - X(simple)));
    const mask_t<X> is_simple = beyond <= error;
    t = select(is_simple, X(simple), t), error = select(is_simple, error + beyond, error);
    return {.exists = c.exists,
            .certain = every(c.certain, !c.shared, missing.exists, missing.certain),
            .t = t,
            .error = error,
            .entering = c.entering,
            .face = c.face,
            .u = X(c.u) + X(missing.u),
            .v = X(c.v) + X(missing.v)};
}

namespace detail {

/// Does the shape say what is missing of a crossing?
template <class Shape, class X, class W>
concept correctable = requires(const Shape shape, const nearby_ray<X, W> ray, const crossing<W> c) {
    shape.correction(ray, c);
};

/// Does a line that is known to cross the surface do so at a number, which can be refined?
template <class W>
RAIO_FN constexpr mask_t<W> refinable(const crossing<W>& c) {
    return every(c.certain, c.exists, is_finite(c.t));
}

/// Is there no use in asking whether a quick t is certain to its last bit? It has no more bits than T.
template <class Shape, class T>
concept always_refined = correctable<Shape, exact_t<T>, working_t<T>> && std::same_as<wider_t<T>, exact_t<T>>;

}  // namespace detail

}  // namespace raio
