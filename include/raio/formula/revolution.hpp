#pragma once

#include <raio/formula/polynomial_along.hpp>

/// \file
/// Where a line crosses what a cubic curve sweeps that turns about an axis.
///
/// At the parameter s the curve has the distance rho from the axis and the height h along it, in lengths. Of a part of
/// the line, p(x) = from + x along, the height is p.e, with the unit vector e of the axis, and the distance |p x e|.
/// With g = h - from.e both agree where
///
///     x along.e = g,    x^2 n.n + 2 x m.n + m.m = rho^2,    m = from x e,  n = along x e
///
/// and without x, where n.n g^2 + 2 m.n (along.e) g + (along.e)^2 (m.m - rho^2) = 0: a polynomial of degree 6 in s
/// (after Kajiya, SIGGRAPH 1983). Its roots are isolated. For each of them x follows from the first equation or, where
/// the line runs across the axis, from the second, whose other root is on the far side of the axis.

namespace raio {

namespace detail {

/// Where a profile, or a part of it, keeps to: from the least (radius, height) to the greatest.
template <class T>
struct profile_bounds {
    vec2<T> low, high;

    template <class Points>
    RAIO_FN static constexpr profile_bounds around(const Points& points) {
        profile_bounds all{points[0], points[0]};
        for (const vec2<T>& p : points) {
            all = {{min(all.low.x, p.x), min(all.low.y, p.y)}, {max(all.high.x, p.x), max(all.high.y, p.y)}};
        }
        return all;
    }
};

/// A line and an axis. It tells parts of a surface about the axis that the line passes by, beyond doubt and for less
/// than a closer look takes: between two heights the line is nearest to the axis at one place, and farthest at an end.
template <class W>
class line_beside_axis {
public:
    using E = bound_t<W>;

    /// \param whole  the bounds of all that is asked for
    template <real R, real P, real T>
    RAIO_FN constexpr line_beside_axis(const ray<R>& ray, const vec3<P>& base, const vec3<P>& axis,
                                       const profile_bounds<P>& whole, const T& t_min, const T& t_max) {
        const vec3<W> a(axis);
        const W low(whole.low.y), high(whole.high.y);
        axis2_ = dot(a, a);
        const W reach = W(whole.high.x) + (high - low) * (W(0.5) * sqrt(axis2_));
        const auto part = part_near(ray, base, vec3<W>(base) + a * ((low + high) * W(0.5)), reach);
        const E size = norm1(vec3<E>(part.from)) + E(2) * norm1(vec3<E>(part.along));
        // How far a point of the line may be off, and what comes of that: the square of its distance from the axis is
        // off by 7 axis_size^2 size off, and that of the nearest point by no more than 4 times that.
        const E off = norm1(part.error) + E(8 * unit_roundoff<W>) * size, axis_size = norm1(vec3<E>(a));
        height_error_ = E(2) * axis_size * off;
        slack_ = E(32) * axis_size * axis_size * size * off;
        knows_ = part.certain && part.half >= W(least_normal<W>) && slack_ >= E(least_normal<W>) && is_finite(slack_);
        misses_ = knows_ && !part.exists;
        if (misses_ || !knows_) return;

        const vec3<W> from = cross(part.from, a), along = cross(part.along, a);
        distance2_ = {{dot(from, from), W(2) * dot(from, along), dot(along, along)}};
        height_ = dot(part.from, a);
        const W rise = dot(part.along, a);
        is_level_ = abs(E(rise)) <= height_error_;
        over_rise_ = is_level_ ? W(0) : W(1) / rise;
        nearest_ = quotient(W(-0.5) * distance2_.coefficient[1], distance2_.coefficient[2], W(0));
        middle_ = part.middle, over_half_ = W(1) / part.half;
        first_ = max(-part.reach, place_of(t_min) - margin(t_min)), last_ = part.reach;
        end_at(t_max);
    }

    /// From here on, nothing beyond t counts.
    template <real T>
    RAIO_FN constexpr void end_at(const T& t) {
        last_ = min(last_, place_of(t) + margin(t));
    }

    template <real T>
    RAIO_FN constexpr bool passes(const profile_bounds<T>& part) const {
        if (misses_ || !knows_) return misses_;
        const W low = W(part.low.y) * axis2_ - height_, high = W(part.high.y) * axis2_ - height_;
        W begin = first_, end = last_;
        if (is_level_) {
            if (E(low) > E(4) * height_error_ || E(high) < E(-4) * height_error_) return true;
        } else {
            const W one = low * over_rise_, other = high * over_rise_, more(height_error_ * abs(E(over_rise_)));
            begin = max(begin, min(one, other) - more), end = min(end, max(one, other) + more);
        }
        if (end < begin) return true;
        const W inner(part.low.x), outer(part.high.x), nearest = min(max(nearest_, begin), end);
        return E(distance2_(nearest)) > E(outer * outer * axis2_) + slack_ ||
               E(max(distance2_(begin), distance2_(end))) + slack_ < E(inner * inner * axis2_);
    }

private:
    template <real T>
    RAIO_FN constexpr W place_of(const T& t) const {
        return (W(t) - middle_) * over_half_;
    }
    /// For the roundings of a place, which `part_near` has found to be below 2^-13, and of t to T.
    template <real T>
    RAIO_FN constexpr W margin(const T& t) const {
        return W(0x1p-10) + abs(W(t)) * (W(4 * unit_roundoff<T>) * over_half_);
    }

    bool knows_, misses_, is_level_{};
    polynomial<W, 2> distance2_;  ///< times the square of the axis, as the height is
    W axis2_, height_{0}, over_rise_{0}, nearest_{0}, middle_{0}, over_half_{0}, first_{0}, last_{0};
    E height_error_, slack_;
};

}  // namespace detail

/// A curve beside an axis, as polynomials of its parameter from 0 to 1.
template <class W>
struct curve_beside_axis {
    polynomial<W, 3> radius, height;  ///< rho and h, in lengths; rho is not below 0
    vec3<W> axis;                     ///< e, right to 4 roundings
};

/// Away from the axis, and up along it where the curve runs across it.
/// \param p  the point, as seen from the base of the axis
template <class W>
RAIO_FN constexpr vec3<W> outward_normal(const curve_beside_axis<W>& curve, const W& s, const vec3<W>& p) {
    W outwards = curve.radius.derivative()(s), upwards = curve.height.derivative()(s);
    W side = upwards == W(0) ? curve.height(W(1)) - curve.height(W(0)) : upwards;
    if (side == W(0)) return curve.axis;
    vec3<W> from_axis = p - curve.axis * dot(p, curve.axis);
    W per_radius = quotient(upwards, length(from_axis), W(0));
    return (from_axis * per_radius - curve.axis * outwards) * copysign(W(1), side);
}

namespace detail {

/// An error over something of at least this size.
template <real E>
RAIO_FN constexpr E over(const E& error, const E& least) {
    return least > E(0) ? error / least : E(infinity<E>);
}

/// The value of p at a place that is s up to `off`.
template <class W, std::size_t N>
RAIO_FN constexpr bounded_number<W> value_near(const polynomial<W, N>& p, const polynomial<W, N - 1>& slope, const W& s,
                                               const bound_t<W>& off) {
    using E = bound_t<W>;
    E place = abs(E(s)) + off;
    E steepest = abs(E(slope(s))) + slope.noise()(place) + off * slope.derivative().magnitude(place);
    return {p(s), p.noise()(place) + off * steepest};
}

}  // namespace detail

/// The crossings in order of x; u is s, and v how far that may be off. The base of the axis is where the part of the
/// line is seen from.
/// \param over_size  1 over the unit of length
template <class W>
RAIO_FN constexpr crossing_list<W, 12> cross_revolved(const curve_beside_axis<W>& curve, const line_part<W>& part,
                                                      const W& over_size) {
    using E = bound_t<W>;
    const auto unit = constant(over_size, 2);
    const auto radius = product<3>(curve.radius, unit), height = product<3>(curve.height, unit);
    std::array<polynomial<W, 1>, 3> p;
    std::array<polynomial<W, 0>, 3> e;
    polynomial<W, 1> along;
    polynomial<W, 2> across2;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<glm::length_t>(i);
        p[i] = product<1>(part.coordinate(axis), unit), e[i] = constant(curve.axis[axis], 4);
        along = along + product<1>(p[i], e[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const auto moment = product<1>(p[j], e[k]) - product<1>(p[k], e[j]);
        across2 = across2 + product<2>(moment, moment);
    }
    const auto coefficient = [](const auto& q, std::size_t k) {
        return polynomial<W, 0>{{q.coefficient[k]}, {q.error[k]}};
    };
    const auto slant = coefficient(along, 1), m2 = coefficient(across2, 0), mn = coefficient(across2, 1),
               n2 = coefficient(across2, 2);
    polynomial<W, 3> g = height;
    g.coefficient[0] = height.coefficient[0] - along.coefficient[0];
    g.error[0] = height.error[0] + along.error[0] + E(2 * unit_roundoff<W>) * abs(E(along.coefficient[0]));
    polynomial<W, 6> gap = -product<6>(radius, radius);  // m.m - rho^2
    gap.coefficient[0] += m2.coefficient[0];
    gap.error[0] += m2.error[0] + E(2 * unit_roundoff<W>) * abs(E(m2.coefficient[0]));
    const auto f = product<6>(product<6>(g, g), n2) + product<6>(g, product<0>(mn, slant)) +
                   product<6>(gap, product<0>(slant, slant));

    crossing_list<W, 12> list;
    const auto roots = roots_between(f, W(0), W(1));
    list.certain = roots.certain;
    const auto g_slope = g.derivative();
    const auto gap_slope = gap.derivative();
    const W tilt = slant.coefficient[0], middle = mn.coefficient[0] * W(0.5),
            over_n2 = quotient(W(1), n2.coefficient[0], W(0));
    const E tilt_error = slant.error[0], tilt_least = abs(E(tilt)) - tilt_error;
    const E n2_least = E(n2.coefficient[0]) - n2.error[0];
    for (const polynomial_root<W>& root : roots) {
        if (root.before == 0 && root.after == 0) continue;  // the line lies in the surface
        const W s = root.t;
        const E off = root.error;
        const bool simple = root.before * root.after < 0;
        const auto level = detail::value_near(g, g_slope, s, off), beyond = detail::value_near(gap, gap_slope, s, off);
        W by_height = quotient(level.value, tilt, W(0));
        E height_error = detail::over(level.error + abs(E(by_height)) * tilt_error, tilt_least);

        W square = middle * middle - n2.coefficient[0] * beyond.value;
        E m = abs(E(middle)), m_error = mn.error[0], n2_error = n2.error[0];
        E square_error = m_error * (E(2) * m + m_error) + n2_error * (abs(E(beyond.value)) + beyond.error) +
                         abs(E(n2.coefficient[0])) * beyond.error +
                         E(8 * unit_roundoff<W>) * (E(middle * middle) + abs(E(n2.coefficient[0] * beyond.value)));
        if (!simple && E(square) < -square_error) continue;  // a level line that passes the circle at its height by
        W half = sqrt(max(square, W(0)));
        E half_error =
            E(square) > E(2) * square_error ? square_error / E(half) : E(2) * sqrt(abs(E(square)) + square_error);
        E farthest = (m + E(half)) * abs(E(over_n2)), n2_rounding = E(8 * unit_roundoff<W>) * abs(E(n2.coefficient[0]));
        E across_error = detail::over(m_error + half_error + farthest * (n2_error + n2_rounding), n2_least);
        const auto append = [&](const W& x, const E& error) {
            crossing<W> c = part.at({x, error, 0, 0, E(0)}, true);
            c.u = s, c.v = W(off);
            c.entering = dot(part.along, outward_normal(curve, s, part.from + part.along * x)) <= W(0);
            std::size_t i = list.count++;
            for (; i > 0 && c.t < list.crossings[i - 1].t; --i) list.crossings[i] = list.crossings[i - 1];
            list.crossings[i] = c;
        };
        if (height_error <= across_error) {
            append(by_height, height_error);
            continue;
        }
        const W near = (-middle - half) * over_n2, far = (-middle + half) * over_n2;
        const auto agrees = [&](const W& x) { return !(abs(E(x - by_height)) > height_error + across_error); };
        if (simple) {
            const bool is_far = by_height > -middle * over_n2;
            list.certain = list.certain && !agrees(is_far ? near : far);
            append(is_far ? far : near, across_error);
        } else {
            if (agrees(near)) append(near, across_error);
            if (agrees(far)) append(far, across_error);
        }
    }
    return list;
}

}  // namespace raio
