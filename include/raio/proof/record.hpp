#pragma once

#include <raio/hit_record.hpp>
#include <raio/proof/crossing.hpp>

/// \file
/// What is recorded of a crossing.

namespace raio {

namespace detail {

// Out of line, as what is rare.

template <real T>
[[gnu::noinline]] RAIO_FN constexpr vec3<T> put_within_range(vec3<T> p) {
    return within_range(p);
}

template <real R, real T, real N>
[[gnu::noinline]] RAIO_FN constexpr hit_record<T, N> put_against(const ray<R>& ray, hit_record<T, N> rec) {
    rec.normal = select(is_finite(norm1(rec.normal)), rec.normal, -normalize(vec3<N>(ray.direction)));
    const auto number_or_0 = [](const T& x) { return select(x == x, x, T(0)); };
    rec.uv = {number_or_0(rec.uv.x), number_or_0(rec.uv.y)};
    return rec;
}

/// Has W no more digits than are recorded, and is there a precision that has?
template <class T, class W>
inline constexpr bool lacks_digits =
    unit_roundoff<T> <= unit_roundoff<W>&& unit_roundoff<exact_t<T>> < unit_roundoff<W>;

/// The same crossing in a wider precision.
template <class X, class W>
RAIO_FN constexpr crossing<X> in_more_digits(const crossing<W>& c) {
    const auto wider = [](const W& x) { return X(bound_t<X>(x)); };
    return {c.exists, c.certain, wider(c.t), bound_t<X>(c.error), c.entering, c.face, wider(c.u), wider(c.v), c.shared};
}

/// What the shape records of a crossing. Where its numbers are so uneven that no normal is left of them, that is
/// against the ray; and what is left of uv is 0.
template <class Shape, real R, class Crossing, real T, real N>
RAIO_FN constexpr void record(const Shape& shape, const ray<R>& ray, const Crossing& crossing, hit_record<T, N>& rec) {
    using W = typename Crossing::number;
    if constexpr (unit_roundoff<N> < unit_roundoff<W>) {  // what is mapped on, as unevenly as may be
        shape.surface(ray, in_more_digits<exact_t<T>>(crossing), rec);
    } else {
        shape.surface(ray, crossing, rec);
    }
    if (!all(is_finite(norm1(rec.normal)))) rec = put_against(ray, rec);
}

/// A bound of a point's error, of which what is beyond the largest number, or no number, counts as that.
template <real T>
RAIO_FN constexpr vec3<T> finite_error(const vec3<T>& error) {
    const T most(std::numeric_limits<scalar_t<T>>::max());
    return {min(most, error.x), min(most, error.y), min(most, error.z)};
}

/// What the error of t counts for at least: a 64th of its rounding. So it is recorded alike by those who know more of
/// it and those who know less.
template <real T>
RAIO_FN constexpr T least_recorded_error(const T& t) {
    return abs(t) * T(unit_roundoff<T> / 64);
}

}  // namespace detail

/// Records what every surface records alike: t, the point, how far that may be off, and the side.
/// \param bend  the smallest radius at which the surface curves; 0 if it is flat
template <real T, real N, real R, class W>
RAIO_FN constexpr void record_point(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec, T bend = T(0)) {
    rec.t = T(c.t) + T(0);  // never -0
    rec.point = vec3<T>(sum_as<W>(ray.origin, product_as<W>(ray.direction, c.t)));
    if constexpr (last_precision<W>) {  // bounds without a thickness, as a single point's, expect no rounding of 0
        const vec3<T> rounding = abs(vec3<T>(ray.origin)) * T(8 * unit_roundoff<W>);
        const auto not_0 = [](const T& p, const T& off) { return select(abs(p) <= off, T(0), p); };
        rec.point = {not_0(rec.point.x, rounding.x), not_0(rec.point.y, rounding.y), not_0(rec.point.z, rounding.z)};
    }
    const T reach = norm1(rec.point);
    if (!all(is_finite(reach))) rec.point = detail::put_within_range(rec.point);

    // Three errors add up: that of t, that of the sum above in W, where |direction t| <= |origin| + |point|, and the
    // rounding of the point to T. The smallest normal number stands for all that underflows, `up`
    // for the roundings of this bound: less than eight.
    constexpr double in_w = 8 * unit_roundoff<W>, in_t = unit_roundoff<T>, up = 1 + 8 * in_t;
    const T least(least_normal<T>), most(std::numeric_limits<scalar_t<T>>::max());
    const T of_t = min(max(T(c.error), detail::least_recorded_error(rec.t)) + least, most);
    // A ray that leaves at the angle of the normal's own rounding must not meet a curved surface again, and every
    // crossing of a point that is off by this much has to be certain in double_double.
    const T floor = bend * T(4 * in_t * in_t) + (bend + reach) * T(0x1p-72) + least;
    vec3<T> error = vec3<T>(abs(ray.direction) * R(of_t)) + vec3<T>(abs(ray.origin) * R(in_w));
    error += abs(rec.point) * T(in_t + in_w);
    rec.error = detail::finite_error(error * T(up) + vec3<T>(floor));
    rec.index = index_t<T>{};
    rec.front_face = c.entering;
}

/// Says of a recorded point that it may be off by that much more.
template <real T, real N>
RAIO_FN constexpr void add_error(hit_record<T, N>& rec, const T& more) {
    rec.error = detail::finite_error(rec.error + vec3<T>(more));
}

/// Keeps a recorded point within the bounds: where little more is known of t than its own digits, as of a ray that
/// grazes a tip or comes from far away, it may have come to lie beyond them.
/// \param bounds  answers with them, to be asked only then
template <real R, class W, real T, real N, class Bounds>
RAIO_FN constexpr void keep_in_bounds(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec, Bounds bounds) {
    using E = bound_t<W>;
    // `padded` has room for the rounding of the point to T, and for a 128th more.
    const E room = norm1(vec3<E>(vec3<W>(rec.point))) * E(0x1p-7 * unit_roundoff<T>);
    const E off = norm1(vec3<E>(vec3<W>(ray.direction))) * c.error +
                  norm1(vec3<E>(vec3<W>(ray.origin))) * E(8 * unit_roundoff<W>);
    const mask_t<T> unknown = !(off <= room);
    if (any(unknown)) rec.point = select(unknown, nearest_in(bounds(), rec.point), rec.point);
}

/// The same where T has no fewer digits than the precision that t is tried in first, which may put any point some
/// places beyond the surface.
template <real T, real N, class Bounds>
RAIO_FN constexpr void keep_unrounded_in_bounds([[maybe_unused]] hit_record<T, N>& rec,
                                                [[maybe_unused]] Bounds bounds) {
    if constexpr (detail::lacks_digits<T, working_t<T>>) rec.point = nearest_in(bounds(), rec.point);
}

/// Records a point that lies between corners: seen edge-on or from far away, the computed one may lie beyond them.
template <class W, real R, real T, real N>
RAIO_FN constexpr void record_point_between(const aabb<T>& corners, const ray<R>& ray, const crossing<W>& c,
                                            hit_record<T, N>& rec, T bend = T(0)) {
    record_point(ray, c, rec, bend);
    rec.point = nearest_in(corners, rec.point);
}

/// Records a point of the surface and the normal along the gradient of f, which points outwards. Where f has none, at a
/// tip or where sheets cross, or none but its rounding, the surface is seen face on.
/// \param bend  as for `record_point`
template <real T, real N, real R, class W>
RAIO_FN constexpr void record_gradient(const ray<R>& ray, const crossing<W>& c, const vec3<W>& gradient, T bend,
                                       hit_record<T, N>& rec) {
    using Q = working_t<N>;
    record_point(ray, c, rec, bend);
    vec3<Q> direction(normalize(vec3<Q>(vec3<W>(ray.direction)))), outward(scaled_into_range<Q>(vec3<Q>(gradient)));
    Q steep = length(outward);
    vec3<Q> normal = outward * quotient(select(mask_t<Q>(c.entering), Q(1), Q(-1)), steep, Q(0));
    const mask_t<Q> against = every(steep > Q(0), dot(normal, direction) <= Q(unit_roundoff<T>));
    rec.normal = vec3<N>(select(against, normal, -direction));
}

}  // namespace raio
