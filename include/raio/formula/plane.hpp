#pragma once

#include <raio/hit_record.hpp>
#include <raio/proof/chord.hpp>

namespace raio {

/// How fast the height above a plane changes along a line.
template <real W>
RAIO_FN constexpr slope_along<W> speed_across(const vec3<W>& normal, const vec3<W>& direction) {
    using E = bound_t<W>;
    E error = E(4 * unit_roundoff<W>) * dot(abs(vec3<E>(normal)), abs(vec3<E>(direction)));
    slope_along<W> speed = slope_of(dot(normal, direction), error);
    // Nothing is certain where all that there is are products too small for any number.
    const mask_t<W> nothing = speed.value == W(0);
    if (any(nothing)) {
        const auto no_product = [](const W& a, const W& b) { return some(a == W(0), b == W(0)); };
        const mask_t<W> parallel = every(no_product(normal.x, direction.x), no_product(normal.y, direction.y),
                                         no_product(normal.z, direction.z));
        speed.certain = every(speed.certain, some(!nothing, parallel));
    }
    return speed;
}

/// Where a line crosses a plane, at t = -height / normal.direction; nowhere, if it runs parallel, inside the plane
/// included.
/// \param height  normal.(origin - a point of the plane)
/// \param height_error  bound of the error of `height`
template <real W>
RAIO_FN constexpr crossing<W> cross_plane(const vec3<W>& normal, const vec3<W>& direction, const W& height,
                                          const bound_t<W>& height_error) {
    return cross_zero(height, height_error, speed_across(normal, direction));
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
    vec3<W> from_point = difference_as<W>(origin, point);
    E error = E(5 * unit_roundoff<W>) * dot(abs(vec3<E>(normal)), abs(vec3<E>(from_point)));
    // Planes ask nothing of the size of their numbers, so that double comes near its smallest here as well.
    return {dot(normal, from_point), last_precision<W> ? error : error + E(least_normal<W>)};
}

/// Where a line crosses a plane, and how far from a point of that plane: the square of the distance and its error
/// bound.
template <class W>
struct crossing_about {
    crossing<W> at;
    W distance2;
    bound_t<W> error;
};

/// \param l    from the point to the origin
/// \param far  at least as long; l is off by a rounding of that
template <class W>
RAIO_FN constexpr crossing_about<W> cross_plane_about(const vec3<W>& normal, const vec3<W>& l, const bound_t<W>& far,
                                                      const plane_height<W>& height, const vec3<W>& d) {
    using E = bound_t<W>;
    crossing<W> c = cross_plane(normal, d, height.value, height.error);
    vec3<W> step = d * c.t, from_center = l + step;
    E off = norm1(vec3<E>(d)) * c.error + E(3 * unit_roundoff<W>) * (far + norm1(vec3<E>(step)));
    return {c, dot(from_center, from_center), off * (E(2) * norm1(vec3<E>(from_center)) + off)};
}
template <class W, real T, real R>
RAIO_FN constexpr crossing_about<W> cross_plane_about(const vec3<T>& center, const vec3<T>& normal, const ray<R>& ray) {
    vec3<W> n(normal), l = difference_as<W>(ray.origin, center);
    return cross_plane_about(n, l, norm1(vec3<bound_t<W>>(l)), height_above<W>(n, center, ray.origin),
                             vec3<W>(ray.direction));
}

/// The part of a line behind a plane: from its crossing on, up to it, or all or nothing if it runs parallel.
/// \param height  of the point where the line has t = 0, times the length of the normal
/// \param speed   how fast the height grows
template <class W>
RAIO_FN constexpr chord<W> cross_half_space(const bounded_number<W>& height, const bounded_number<W>& speed,
                                            const index_t<W>& face) {
    const bounded_number<W> t = -height * inverse(speed);
    const auto crosses = is_positive(abs(speed));
    const mask_t<W> leaves = speed.value > W(0);
    chord<W> c = between(crosses, t, t);
    c.near.face = c.far.face = face;
    begin_never_where(leaves, c), end_never_where(!leaves, c);
    return unless(!crosses, c, is_not_negative(-height));
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
