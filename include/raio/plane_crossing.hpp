#pragma once

#include <raio/crossing.hpp>

namespace raio {

/// Where a line crosses a plane, at t = -height / normal.direction; nowhere, if it runs parallel, inside the plane
/// included. \param height        normal.(origin - a point of the plane) \param height_error  bound of the error of
/// `height`
template <real W>
RAIO_FN constexpr crossing<W> cross_plane(const vec3<W>& normal, const vec3<W>& direction, const W& height,
                                          const bound_t<W>& height_error) {
    using E = bound_t<W>;
    constexpr double u = unit_roundoff<W>;
    W speed = dot(normal, direction), per_height = quotient(W(1), speed, W(0)), t = -height * per_height;
    E speed_error = E(4 * u) * dot(abs(vec3<E>(normal)), abs(vec3<E>(direction))), size = abs(E(speed));
    // With the speed above twice its error, 1 / (|speed| - error) is at most 2 / |speed|.
    E error = E(2) * (height_error + abs(E(t)) * speed_error) * abs(E(per_height)) + E(4 * u) * abs(E(t));
    return {.exists = every(size > tie<W>(speed_error), is_finite(size)),
            .certain = size >= E(2) * speed_error,
            .t = t,
            .error = error,
            .entering = speed < W(0)};
}

/// The signed height of `origin` above the plane through `point`, times the length of the normal, and its error bound.
template <class W>
struct plane_height {
    W value;
    bound_t<W> error;
};

template <class W, real T>
RAIO_FN constexpr plane_height<W> height_above(const vec3<W>& normal, const vec3<T>& point, const vec3<T>& origin) {
    using E = bound_t<W>;
    vec3<W> from_point = vec3<W>(origin) - vec3<W>(point);
    return {dot(normal, from_point), E(5 * unit_roundoff<W>) * dot(abs(vec3<E>(normal)), abs(vec3<E>(from_point)))};
}

}  // namespace raio
