#pragma once

#include <raio/math/bezier.hpp>
#include <raio/shape/surface_of_revolution.hpp>

namespace raio {

namespace detail {

/// What a cubic Bezier segment sweeps: see formula/revolution.hpp. Where it meets the axis, 106 bits cannot tell it
/// from 2^-40 of its size beside it.
template <real T>
struct revolved_piece<T, 3> {
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
        list.depends_on(part);
        if (!part.exists) return list;
        list = cross_revolved(beside_axis<W>(), part, W(1) / reach);
        list.start_at_origin();
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
        add_error(rec, T(0x1p-60) * size);  // from where on a crossing is certain, of a radius of 2^-20 of the size
        const vec3<W> e = curve.axis();
        const frame<Q> f = frame_about(vec3<Q>(e));
        vec3<Q> beside(p - e * dot(p, e));
        rec.uv = {turns(T(dot(beside, f.y)), T(dot(beside, f.x))), max(T(0), min(T(1), T(s)))};
    }

private:
    template <class W>
    RAIO_FN constexpr curve_beside_axis<W> beside_axis() const {
        const given_vector<W> a{W(axis.x), W(axis.y), W(axis.z)};
        const auto unit = sqrt(square(a));
        return {radii<W>(), heights<W>() * unit, a * inverse(unit)};
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

/// What cubic Bezier segments sweep that turn about an axis: see surface_of_revolution.hpp.
template <real T>
using curved_surface_of_revolution = surface_of_revolution<T, 3>;

}  // namespace raio
