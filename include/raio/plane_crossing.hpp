#pragma once

#include <raio/crossing.hpp>
#include <raio/hit_record.hpp>

namespace raio {

/// Where a line crosses a plane, at t = -height / normal.direction; nowhere, if it runs parallel, inside the plane
/// included.
/// \param height  normal.(origin - a point of the plane)
/// \param height_error  bound of the error of `height`
template <real W>
RAIO_FN constexpr crossing<W> cross_plane(const vec3<W>& normal, const vec3<W>& direction, const W& height,
                                          const bound_t<W>& height_error) {
    using E = bound_t<W>;
    constexpr double u = unit_roundoff<W>;
    W speed = dot(normal, direction), per_height = quotient(W(1), speed, W(0)), t = -height * per_height;
    E speed_error = E(4 * u) * dot(abs(vec3<E>(normal)), abs(vec3<E>(direction))), size = abs(E(speed));
    // With the speed above twice its error, 1 / (|speed| - error) is at most 2 / |speed|.
    E error = E(2) * (height_error + abs(E(t)) * speed_error) * abs(E(per_height)) + E(4 * u) * abs(E(t));
    // No speed at all is certain where no term of it has a size: not where one was too small for its digits, or is not
    // in the range.
    const mask_t<W> in_range = is_finite(size), has_digits = some(size == E(0), size >= with_underflow<W>(E(0)));
    return {.exists = every(size > tie<W>(speed_error), in_range),
            .certain = every(size >= E(2) * speed_error, in_range, has_digits),
            .t = t,
            .error = with_underflow<W>(error),
            .entering = speed < W(0)};
}

/// The signed height of `origin` above the plane through `point`, times the length of the normal, and its error bound.
template <class W>
struct plane_height {
    W value;
    bound_t<W> error;
};

template <class W, real T, real R>
RAIO_FN constexpr plane_height<W> height_above(const vec3<W>& normal, const vec3<T>& point, const vec3<R>& origin) {
    using E = bound_t<W>;
    vec3<W> from_point = vec3<W>(origin) - vec3<W>(point);
    E terms = dot(abs(vec3<E>(normal)), abs(vec3<E>(from_point)));
    return {dot(normal, from_point), with_underflow<W>(E(5 * unit_roundoff<W>) * terms)};
}

/// Where a line crosses a plane, and how far from a point of that plane: the square of the distance and its error
/// bound.
template <class W>
struct crossing_about {
    crossing<W> at;
    W distance2;
    bound_t<W> error;
};

template <class W, real T, real R>
RAIO_FN constexpr crossing_about<W> cross_plane_about(const vec3<T>& center, const vec3<T>& normal, const ray<R>& ray) {
    using E = bound_t<W>;
    vec3<W> n(normal), d(ray.direction), l = vec3<W>(ray.origin) - vec3<W>(center);
    auto height = height_above<W>(n, center, ray.origin);
    crossing<W> c = cross_plane(n, d, height.value, height.error);
    vec3<W> step = d * c.t, from_center = l + step;
    E off = norm1(vec3<E>(d)) * c.error + E(3 * unit_roundoff<W>) * (norm1(vec3<E>(l)) + norm1(vec3<E>(step)));
    return {c, dot(from_center, from_center), off * (E(2) * norm1(vec3<E>(from_center)) + off)};
}

/// Puts the recorded point onto its plane if that runs across an axis, as bounds without a thickness expect it: one
/// coordinate is known then, that of any other point of the plane.
template <real T, real N>
RAIO_FN constexpr void put_onto_plane(const vec3<T>& normal, const vec3<T>& on_plane, hit_record<T, N>& rec) {
    const auto put = [](const T& n_j, const T& n_k, const T& known, T& p) {
        p = select(every(n_j == T(0), n_k == T(0)), known, p);
    };
    put(normal.y, normal.z, on_plane.x, rec.point.x);
    put(normal.z, normal.x, on_plane.y, rec.point.y);
    put(normal.x, normal.y, on_plane.z, rec.point.z);
}

}  // namespace raio
