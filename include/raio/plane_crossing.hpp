#pragma once

#include <raio/crossing.hpp>

namespace raio {

/// Where a line crosses a plane, at t = -height / normal.direction; nowhere, if it runs parallel, inside the plane
/// included. \param height        normal.(origin - a point of the plane) \param height_error  bound of the error of
/// `height`
template <real W>
RAIO_FN constexpr crossing<W> cross_plane(const vec3<W>& normal, const vec3<W>& direction, const W& height,
                                          const W& height_error) {
    constexpr double u = unit_roundoff<W>;
    W speed = dot(normal, direction), zero(0);
    W speed_error = W(4 * u) * dot(abs(normal), abs(direction));
    W per_height = quotient(W(1), speed, zero), t = -height * per_height;
    // With the speed above twice its error, 1 / (|speed| - error) is at most 2 / |speed|.
    W error = W(2) * (height_error + abs(t) * speed_error) * abs(per_height) + W(4 * u) * abs(t);
    return {.exists = every(abs(speed) > tie(speed_error), is_finite(speed)),
            .certain = abs(speed) >= W(2) * speed_error,
            .t = t,
            .error = error,
            .entering = speed < zero};
}

/// The signed height of `origin` above the plane through `point`, times the length of the normal, and its error bound.
template <class W>
struct plane_height {
    W value, error;
};

template <class W, real T>
RAIO_FN constexpr plane_height<W> height_above(const vec3<W>& normal, const vec3<T>& point, const vec3<T>& origin) {
    vec3<W> from_point = vec3<W>(origin) - vec3<W>(point);
    return {dot(normal, from_point), W(5 * unit_roundoff<W>) * dot(abs(normal), abs(from_point))};
}

}  // namespace raio
