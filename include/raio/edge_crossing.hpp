#pragma once

#include <raio/settle.hpp>

/// \file
/// What a triangle and a parallelogram have in common: a corner and two edges.
///
/// Moeller and Trumbore (1997): the point origin + t direction = corner + u e1 + v e2 is three linear equations for t,
/// u and v. By Cramer's rule, with s = origin - corner, p = direction x e2, q = s x e1,
///
///     det = e1.p,   u = s.p / det,   v = direction.q / det,   t = e2.q / det.

namespace raio {

/// Where a line crosses the plane of two edges, and how far along them: u and v are u / size and v / size of the edges.
template <class W>
struct edge_crossing {
    crossing<W> at;
    W size, u, v;
    bound_t<W> size_error, u_error, v_error;
};

template <class W, real R>
RAIO_FN constexpr edge_crossing<W> cross_edges(const vec3<W>& corner, const vec3<W>& e1, const vec3<W>& e2,
                                               const ray<R>& ray) {
    using E = bound_t<W>;
    vec3<W> direction(ray.direction), s = vec3<W>(ray.origin) - corner;
    vec3<W> p = cross(direction, e2), q = cross(s, e1);
    W det = dot(e1, p), sign = copysign(W(1), det), size = abs(det);
    W u = dot(s, p) * sign, v = dot(direction, q) * sign;

    // A triple product of vectors that are off by a rounding each is off by less than 8 roundings of its terms.
    E k(8 * unit_roundoff<W>), det_error = k * triple_product_bound(e1, direction, e2);
    E u_error = k * triple_product_bound(s, direction, e2), v_error = k * triple_product_bound(direction, s, e1);

    W over_det = quotient(W(1), det, W(0)), t = dot(e2, q) * over_det;
    E t_error = k * closest_triple_product_bound(e2, s, e1);
    E error = E(2) * (t_error + abs(E(t)) * det_error) * abs(E(over_det)) + E(4 * unit_roundoff<W>) * abs(E(t));
    crossing<W> c{.exists = size > tie<W>(det_error),
                  .certain = size > E(2) * det_error,
                  .t = t,
                  .error = error,
                  .entering = det > W(0),
                  .u = u * abs(over_det),
                  .v = v * abs(over_det)};
    return {c, size, u, v, det_error, u_error, v_error};
}

/// What is missing of a crossing: t, u and v are that of the small vector `apart` from the point of the surface that it
/// names to that of the ray.
/// \param e1, e2  the edges of the surface there
template <class W>
RAIO_FN constexpr edge_crossing<W> cross_apart(const vec3<W>& apart, const vec3<W>& e1, const vec3<W>& e2,
                                               const vec3<W>& direction) {
    vec3<W> zero(W(0));
    return cross_edges(zero, e1, e2, ray<W>{apart, direction});
}

/// How much more t is off if `apart` is off by this much: t is apart.(e1 x e2) / det. Products too small for their
/// digits are taken care of.
template <class W>
RAIO_FN constexpr bound_t<W> error_of_apart(const bound_t<W>& error, const edge_crossing<W>& missing, const vec3<W>& e1,
                                            const vec3<W>& e2) {
    using E = bound_t<W>;
    E length2 = norm1(vec3<E>(e2));
    E lost = error * norm1(vec3<E>(e1)) * length2 + E(least_normal<W>) * (E(1) + length2);
    return E(2) * quotient(lost, E(missing.size), E(0));
}

/// What is missing of a crossing with a flat shape.
template <class X, class W, real T>
RAIO_FN constexpr crossing<W> correct_edges(const vec3<T>& corner, const vec3<X>& e1, const vec3<X>& e2,
                                            const nearby_ray<X, W>& ray, const crossing<W>& c) {
    using E = bound_t<X>;
    auto [p, p_error] = ray.seen_from(corner);
    vec3<X> along1 = e1 * X(c.u), along2 = e2 * X(c.v), apart = p - (along1 + along2);
    vec3<W> edge1(e1), edge2(e2);
    edge_crossing<W> missing = cross_apart(vec3<W>(apart), edge1, edge2, ray.direction);
    E lengths = norm1(vec3<E>(p)) + norm1(vec3<E>(along1)) + norm1(vec3<E>(along2));
    missing.at.error += error_of_apart(p_error + E(8 * unit_roundoff<X>) * lengths, missing, edge1, edge2);
    return missing.at;
}

/// Records a point that lies between corners: seen edge-on, the computed one may lie beyond them.
template <class W, real R, real T, real N>
RAIO_FN constexpr void record_point_between(const aabb<T>& corners, const ray<R>& ray, const crossing<W>& at,
                                            hit_record<T, N>& rec, T bend = T(0)) {
    record_point(ray, at, rec, bend);
    const auto between = [](T low, T high, T x) { return max(low, min(high, x)); };
    rec.point = {between(corners.min.x, corners.max.x, rec.point.x), between(corners.min.y, corners.max.y, rec.point.y),
                 between(corners.min.z, corners.max.z, rec.point.z)};
}

/// Records the crossing with a flat shape that has such edges.
template <class W, real R, real T, real N>
RAIO_FN constexpr void record_flat(const aabb<T>& corners, const vec3<W>& e1, const vec3<W>& e2, const ray<R>& ray,
                                   const crossing<W>& at, hit_record<T, N>& rec) {
    vec3<W> normal = cross(scaled_into_range<T>(e1), scaled_into_range<T>(e2));
    vec3<N> outward(normalize_from<T>(vec3<working_t<N>>(normal)));
    record_point_between(corners, ray, at, rec);
    rec.normal = outward * select(at.entering, N(1), N(-1));
}

}  // namespace raio
