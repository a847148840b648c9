#pragma once

#include <span>
#include <vector>

#include <raio/math/bezier.hpp>
#include <raio/revolved_crossing.hpp>
#include <raio/shape/frustum.hpp>
#include <raio/shape/ring.hpp>

namespace raio {

namespace detail {

/// What one straight piece of a profile sweeps: the side of a frustum, or a ring where it runs across the axis.
///
/// The ray is seen from the base of the axis. That is rounded, and so are the points of the axis from there: by less
/// than a rounding of twice their sizes together.
template <real T>
struct revolved_segment {
    using number = T;

    vec3<T> base, axis;
    vec2<T> from, to;  ///< (radius, height)

    template <class W, real R>
    RAIO_FORMULA constexpr chord<W> crossings(const ray<R>& ray) const {
        using E = bound_t<W>;
        vec3<W> a(axis), d(ray.direction), origin = difference_as<W>(ray.origin, base);
        const auto seen_from = [&](const T& height) {
            vec3<W> on_axis = product_as<W>(axis, height), l = origin - on_axis;
            vec3<E> sizes = (abs(vec3<E>(origin)) + abs(vec3<E>(on_axis))) * E(2);
            E error = with_underflow<W>(E(4 * unit_roundoff<W>) * dot(abs(vec3<E>(a)), sizes));
            return axis_point<W>{l, norm1(sizes), {dot(a, l), error}};
        };
        chord<W> c{};
        c.far.certain = true;
        if (is_flat()) {
            const auto center = seen_from(from.y);
            c.near = between_rims(cross_plane_about(a, center.to_origin, center.far, center.above, d),
                                  min(from.x, to.x), max(from.x, to.x));
        } else {
            const auto narrow = seen_from(narrow_end().y), wide = seen_from(wide_end().y);
            c = cross_nappe(cone<W>(), vec2<T>(from.x, to.x), -narrow.to_origin, narrow.far, d);
            if (missed(c)) return c;
            const bool widens = narrow_end().y < wide_end().y;
            chord<W> slab =
                widens ? cross_slab(a, narrow.above, wide.above, d) : cross_slab(a, wide.above, narrow.above, d);
            c = {within(slab, c.near), within(slab, c.far)};
        }
        keep_if_reachable<T>(ray, c);
        return c;
    }

    template <class X, class W>
    RAIO_FN constexpr crossing<W> correction(const nearby_ray<X, W>& ray, const crossing<W>& c) const {
        using E = bound_t<X>;
        auto [place, error] = ray.seen_from(base);
        vec3<X> on_axis = product_as<X>(axis, narrow_end().y);
        error += E(4 * unit_roundoff<X>) * (norm1(vec3<E>(place)) + norm1(vec3<E>(on_axis)));
        nearby_point<X> at{place - on_axis, error};
        if (is_flat()) return correct_plane(vec3<X>(axis), at, ray.direction);
        return correct_quadric(cone<X>(), at, ray.direction, c);
    }

    template <class W, real R, real N>
    RAIO_FN constexpr void surface(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec) const {
        const raio::ray<W> moved{difference_as<W>(ray.origin, base), vec3<W>(ray.direction)};
        const vec3<W> zero(W(0));
        hit_record<W, N> local;
        if (is_flat()) {
            as_ring(zero).surface(moved, c, local);
            if (from.x > to.x) local.uv.y = W(1) - local.uv.y;
        } else {
            as_frustum(zero).surface(moved, c, local);
        }
        record_point(ray, c, rec, is_flat() ? T(0) : max(from.x, to.x) + norm1(axis) * abs(to.y - from.y));
        if (is_flat()) put_onto_plane(axis, vec3<T>(vec3<W>(base) + vec3<W>(axis) * W(from.y)), rec);
        rec.normal = local.normal;
        rec.uv = {min(T(local.uv.x), T(1)), T(local.uv.y)};
    }

    RAIO_FN constexpr T area() const { return is_flat() ? as_ring(base).area() : as_frustum(base).area(); }

    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        return is_flat() ? as_ring(base).sample(u) : as_frustum(base).sample(u);
    }

private:
    /// A point of the axis: from there to the ray's origin, a bound of which that is off by a rounding, and how high
    /// the origin is above it.
    template <class W>
    struct axis_point {
        vec3<W> to_origin;
        bound_t<W> far;
        plane_height<W> above;
    };

    RAIO_FN constexpr bool is_flat() const { return from.y == to.y; }
    RAIO_FN constexpr const vec2<T>& narrow_end() const { return to.x < from.x ? to : from; }
    RAIO_FN constexpr const vec2<T>& wide_end() const { return to.x < from.x ? from : to; }

    /// The side; its axis is off by two roundings.
    template <class W>
    RAIO_FN constexpr revolved_quadric<W> cone() const {
        W height = difference_as<W>(wide_end().y, narrow_end().y);
        return nappes(product_as<W>(axis, height), vec2<T>(from.x, to.x));
    }

    /// The shape in the precision of W, as seen from `from_base`.
    template <real W>
    RAIO_FN constexpr open_frustum<W> as_frustum(const vec3<W>& from_base) const {
        const vec3<W> a(axis);
        return {from_base + a * W(from.y), from_base + a * W(to.y), W(from.x), W(to.x)};
    }
    template <real W>
    RAIO_FN constexpr ring<W> as_ring(const vec3<W>& from_base) const {
        const vec3<W> a(axis);
        return {from_base + a * W(from.y), a, W(min(from.x, to.x)), W(max(from.x, to.x))};
    }
};

/// What one cubic Bezier segment of a profile sweeps.
template <real T>
struct revolved_curve {
    using number = T;

    vec3<T> base, axis;
    vec2<T> p0, p1, p2, p3;  ///< control points, (radius, height)

    template <class W, real R>
    RAIO_FORMULA constexpr crossing_list<W, 12> crossings(const ray<R>& ray) const {
        crossing_list<W, 12> list;
        const T widest = max(max(p0.x, p1.x), max(p2.x, p3.x)), least = min(min(p0.x, p1.x), min(p2.x, p3.x));
        const T low = min(min(p0.y, p1.y), min(p2.y, p3.y)), high = max(max(p0.y, p1.y), max(p2.y, p3.y));
        const vec3<W> a(axis);
        const W unit = length(a), middle = (W(low) + W(high)) * W(0.5);
        const bool sound = least >= T(0) && is_finite(base) && is_finite(p0.x + p1.x + p2.x + p3.x) &&
                           is_finite(p0.y + p1.y + p2.y + p3.y);
        if (!sound || !(unit > W(0)) || !is_finite(bound_t<W>(unit))) return list;
        const W reach = W(widest) + (W(high) - W(low)) * (W(0.5) * unit);
        const auto part = part_near(ray, base, vec3<W>(base) + a * middle, reach);
        list.certain = part.certain;
        if (!part.exists) return list;
        list = cross_revolved(beside_axis<W>(), part, W(1) / reach);
        start_at_origin(list);
        keep_if_reachable<T>(ray, list);
        return list;
    }

    /// With the radius r and the height y of the curve at s, and p as seen from the base,
    ///
    ///     p.A - A.A y = 0,    |p x A|^2 - A.A r^2 = 0,    A = axis
    ///
    /// Each times the slope of the other along s, and one less the other: s is gone, but for the square of what it is
    /// off by, and one step of Newton's method is left for t.
    template <class X, class W>
    RAIO_FN constexpr crossing<W> correction(const nearby_ray<X, W>& ray, const crossing<W>& c) const {
        using E = bound_t<X>;
        constexpr double in_x = 16 * unit_roundoff<X>, in_w = 64 * unit_roundoff<W>;
        const E off(c.v), end = abs(E(c.u)) + off;
        const auto [p, p_error] = ray.seen_from(base);
        const vec3<X> a(axis), across = cross(p, a);
        const vec3<W> d = ray.direction, a_w(axis), turning = cross(d, a_w);
        const X a2 = dot(a, a);
        const W a2_w(a2);
        const polynomial<X, 3> radius = radii<X>(), height = heights<X>();
        const X r = radius(X(c.u)), y = height(X(c.u));
        const cubic_near<W> r_w(radii<W>(), c.u, end), y_w(heights<W>(), c.u, end);
        const W above(dot(p, a) - a2 * y), beyond(dot(across, across) - a2 * r * r);

        const E size = norm1(vec3<E>(p)), unit = norm1(vec3<E>(a_w)), area(a2_w), speed = norm1(vec3<E>(d));
        const E across_size = norm1(vec3<E>(across)), across_error = unit * (p_error + E(in_x) * size);
        const E r_error = radius.noise()(end);
        const E above_error = unit * (p_error + E(in_x) * size) + area * (height.noise()(end) + E(in_x) * y_w.most);
        const E beyond_error = across_error * (E(2) * across_size + across_error) +
                               E(in_x) * (across_size * across_size + area * r_w.most * r_w.most) +
                               area * r_error * (E(2) * r_w.most + r_error);

        // How the two change along the line, and along the curve.
        const W above_t = dot(d, a_w), beyond_t = W(2) * dot(vec3<W>(across), turning);
        const W above_s = a2_w * y_w.slope, beyond_s = W(2) * a2_w * r_w.value * r_w.slope;
        const E most_above_s = area * y_w.fastest, most_beyond_s = E(2) * area * r_w.most * r_w.fastest;
        const E above_bend = area * y_w.most_bend;
        const E beyond_bend = E(2) * area * (r_w.fastest * r_w.fastest + r_w.most * r_w.most_bend);
        const W level = beyond_s * above - above_s * beyond, slope = beyond_s * above_t - above_s * beyond_t;
        const E level_error = most_beyond_s * (above_error + off * off * above_bend) +
                              most_above_s * (beyond_error + off * off * beyond_bend) +
                              off * E(2 * in_w) * most_beyond_s * most_above_s +
                              E(in_w) * (abs(E(beyond_s * above)) + abs(E(above_s * beyond)));
        const E turn = unit * speed,
                slope_error = E(2) * most_above_s * turn * turn * c.error +
                              E(in_w) * (most_beyond_s * turn + E(2) * most_above_s * across_size * turn);
        crossing<W> missing = cross_zero(level, level_error + E(least_normal<W>), slope_of<W>(slope, slope_error));
        // The normal depends on all digits of s.
        const bool by_height = y_w.slope * y_w.slope * a2_w >= r_w.slope * r_w.slope;
        missing.u = by_height ? quotient(above + above_t * missing.t, above_s, W(0))
                              : quotient(beyond + beyond_t * missing.t, beyond_s, W(0));
        return if_to_all_digits(missing, ray);
    }

    template <class W, real R, real N>
    RAIO_FN constexpr void surface(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec) const {
        using Q = working_t<N>;
        const auto curve = beside_axis<W>();
        const W s = c.u;
        vec3<W> p = seen_from(base, ray, c.t);
        const T widest = max(max(p0.x, p1.x), max(p2.x, p3.x));
        const T high = max(max(abs(p0.y), abs(p1.y)), max(abs(p2.y), abs(p3.y)));
        const T size = widest + norm1(axis) * high;
        vec3<W> outward = outward_normal(curve, s, p);
        record_gradient(ray, c, outward, size, rec);
        rec.error +=
            vec3<T>(T(0x1p-60) * size);  // from where on a crossing is certain, of a radius of 2^-20 of the size
        const frame<Q> f = frame_about(vec3<Q>(curve.axis));
        vec3<Q> beside(p - curve.axis * dot(p, curve.axis));
        rec.uv = {turns(T(dot(beside, f.y)), T(dot(beside, f.x))), max(T(0), min(T(1), T(s)))};
    }

private:
    template <class W>
    RAIO_FN constexpr curve_beside_axis<W> beside_axis() const {
        vec3<W> a(axis);
        W unit = length(a);
        return {radii<W>(), product<3>(heights<W>(), constant(unit, 4)), a * (W(1) / unit)};
    }

    template <class W>
    RAIO_FN constexpr polynomial<W, 3> radii() const {
        return bezier_polynomial<W>(p0.x, p1.x, p2.x, p3.x);
    }
    template <class W>
    RAIO_FN constexpr polynomial<W, 3> heights() const {
        return bezier_polynomial<W>(p0.y, p1.y, p2.y, p3.y);
    }
};

}  // namespace detail

/// What a line of points sweeps that turns about an axis: goblets, vases, whatever comes from a lathe. The points are
/// those of a polyline, or the control points of cubic Bezier segments, every third of which lies on the curve.
///
/// A straight segment sweeps the side of a frustum, or a ring where it runs across the axis, a curved one what
/// revolved_crossing.hpp says; the nearest of them is hit. (Where a curved one meets the axis, 106 bits cannot tell it
/// from 2^-40 of its size beside it.) Neighbours share their rims, so that no ray slips through
/// between them. `hit_record::index` is the segment. The front is the side away from the axis, and of what runs across
/// the axis the side that the axis points to.
///
/// uv: u is the angle about the axis, from the x axis of `frame_about(axis)`; v goes from 0 at the first point to 1 at
/// the last, every segment an equal part of it.
/// \tparam Degree  1 for a polyline, 3 for cubic Bezier segments
template <real T, std::size_t Degree = 1>
struct surface_of_revolution {
    static_assert(Degree == 1 || Degree == 3);

    using number = T;

    vec3<T> base;                  ///< the point of the axis at height 0
    vec3<T> axis;                  ///< of any length but zero: the unit of heights
    std::vector<vec2<T>> profile;  ///< (radius, height) of 1 + n Degree points, n >= 1; no radius below 0

    mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        bool found = false;
        if (segments() == 0) return found;
        auto line = seen_by(ray, t_min, t_max);
        for (std::size_t i = 0; i < segments(); ++i) {
            if (line.passes(bounds_of(i))) continue;
            hit_record<T> candidate;
            if (!first_hit(segment(i), ray, t_min, found ? rec.t : t_max, candidate)) continue;
            if (found && !(candidate.t < rec.t)) continue;
            rec = candidate;
            rec.index = static_cast<index_t<T>>(i);
            rec.uv.y = (T(static_cast<double>(i)) + rec.uv.y) / T(static_cast<double>(segments()));
            found = true;
            line.end_at(rec.t);
        }
        return found;
    }

    mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        if (segments() == 0) return false;
        const auto line = seen_by(ray, t_min, t_max);
        for (std::size_t i = 0; i < segments(); ++i) {
            if (!line.passes(bounds_of(i)) && any_hit(segment(i), ray, t_min, t_max)) return true;
        }
        return false;
    }

    aabb<T> bounds() const {
        aabb<T> box;
        if (segments() == 0) return box;
        for (const vec2<T>& end : profile) {
            const vec3<T> center = base + axis * end.y;
            const T rounding = (norm1(base) + norm1(axis) * abs(end.y)) * T(4 * unit_roundoff<T>);
            const vec3<T> reach = disc_reach(axis, end.x) + vec3<T>(rounding);
            box = hull(box, padded(aabb<T>{center - reach, center + reach}));
        }
        if constexpr (Degree > 1) {
            vec3<T> blur(T(0x1p-40) * norm1(vec3<T>(box.max - box.min)));
            box = {box.min - blur, box.max + blur};
        }
        return box;
    }

    T area() const requires(Degree == 1) {
        T sum(0);
        for (std::size_t i = 0; i < segments(); ++i) sum += segment(i).area();
        return sum;
    }

    /// u.x chooses the segment, and what is left of it is the angle.
    surface_sample<T> sample(const vec2<T>& u) const requires(Degree == 1) {
        T left = u.x * area();
        for (std::size_t i = 0; i + 1 < segments(); ++i) {
            const T own = segment(i).area();
            if (left < own) return segment(i).sample({left / own, u.y});
            left -= own;
        }
        const auto last = segment(segments() - 1);
        return last.sample({min(left / last.area(), T(1 - unit_roundoff<T>)), u.y});
    }

private:
    std::size_t segments() const { return profile.empty() ? 0 : (profile.size() - 1) / Degree; }

    detail::profile_bounds<T> bounds_of(std::size_t i) const {
        return detail::profile_bounds<T>::around(std::span(profile).subspan(Degree * i, Degree + 1));
    }

    auto seen_by(const ray<T>& ray, T t_min, T t_max) const {
        const auto whole = detail::profile_bounds<T>::around(profile);
        return detail::line_beside_axis<working_t<T>>(ray, base, axis, whole, t_min, t_max);
    }

    auto segment(std::size_t i) const {
        if constexpr (Degree == 1) {
            return detail::revolved_segment<T>{base, axis, profile[i], profile[i + 1]};
        } else {
            const vec2<T>* p = &profile[3 * i];
            return detail::revolved_curve<T>{base, axis, p[0], p[1], p[2], p[3]};
        }
    }
};

/// Of cubic Bezier segments.
template <real T>
using curved_surface_of_revolution = surface_of_revolution<T, 3>;

}  // namespace raio
