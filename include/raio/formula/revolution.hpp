#pragma once

#include <raio/push_macros.hpp>

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

/// A line and an axis. It tells parts of a surface about the axis that the line passes by, for less than it takes to
/// cross them: between two heights the line is nearest to the axis at one place, and farthest at an end.
///
/// A part that is passed by is so with a margin: `part_near` knows the line to less than a 2^13th of all that is asked
/// for, and the margin is three times that.
template <class W>
class line_beside_axis {
public:
    /// \param whole  the bounds of all that is asked for
    template <class Line, real P, real T>
    RAIO_FN constexpr line_beside_axis(const Line& line, const vec3<P>& base, const vec3<P>& axis,
                                       const profile_bounds<P>& whole, const T& t_min, const T& t_max) {
        const vec3<W> a(axis);
        const W low(whole.low.y), high(whole.high.y);
        axis2_ = dot(a, a);
        const W unit = sqrt(axis2_), size = W(whole.high.x) + (high - low) * (W(0.5) * unit);
        const auto part = part_near(line, base, vec3<W>(base) + a * ((low + high) * W(0.5)), size);
        margin_ = size * W(3 * 0x1p-13), height_margin_ = margin_ * unit;
        const auto has_all_digits = [](const W& x) { return every(W(0x1p-900) < x, x < W(0x1p900)); };
        knows_ =
            part.certain && every(has_all_digits(part.half), has_all_digits(axis2_), has_all_digits(margin_ * margin_),
                                  has_all_digits(height_margin_ * height_margin_));
        misses_ = knows_ && !part.exists;
        if (misses_ || !knows_) return;

        const vec3<W> from = cross(part.from, a), along = cross(part.along, a);
        distance2_ = {{dot(from, from), W(2) * dot(from, along), dot(along, along)}};
        height_ = dot(part.from, a);
        const W rise = dot(part.along, a);
        is_level_ = abs(rise) <= height_margin_ * W(0x1p-4);
        over_rise_ = is_level_ ? W(0) : W(1) / rise;
        nearest_ = quotient(W(-0.5) * distance2_.coefficient[1], distance2_.coefficient[2], W(0));
        middle_ = part.middle, over_half_ = W(1) / part.half;
        first_ = max(-part.reach, place_of(t_min) - window_margin(t_min)), last_ = part.reach;
        end_at(t_max);
    }

    /// From here on, nothing beyond t counts.
    template <real T>
    RAIO_FN constexpr void end_at(const T& t) {
        last_ = min(last_, place_of(t) + window_margin(t));
    }

    template <real T>
    RAIO_FN constexpr bool passes(const profile_bounds<T>& part) const {
        if (misses_ || !knows_) return misses_;
        const W low = W(part.low.y) * axis2_ - height_ - height_margin_;
        const W high = W(part.high.y) * axis2_ - height_ + height_margin_;
        W begin = first_, end = last_;
        if (is_level_) {
            if (low > W(0) || high < W(0)) return true;
        } else {
            const W one = low * over_rise_, other = high * over_rise_;
            begin = max(begin, min(one, other)), end = min(end, max(one, other));
        }
        if (end < begin) return true;
        const W inner = max(W(0), W(part.low.x) - margin_), outer = W(part.high.x) + margin_;
        return distance2_(min(max(nearest_, begin), end)) > outer * outer * axis2_ ||
               max(distance2_(begin), distance2_(end)) < inner * inner * axis2_;
    }

private:
    template <real T>
    RAIO_FN constexpr W place_of(const T& t) const {
        return (W(t) - middle_) * over_half_;
    }
    /// What is recorded as that t may lie so far beyond it.
    template <real T>
    RAIO_FN constexpr W window_margin(const T& t) const {
        return W(0x1p-10) + abs(W(t)) * (W(0x1p-22) * over_half_);
    }

    bool knows_, misses_, is_level_{};
    polynomial<W, 2> distance2_;  ///< times the square of the axis, as the height is
    W axis2_, margin_, height_margin_, height_{0}, over_rise_{0}, nearest_{0}, middle_{0}, over_half_{0}, first_{0},
        last_{0};
};

}  // namespace detail

/// A curve beside an axis, as polynomials of its parameter from 0 to 1.
template <class W>
struct curve_beside_axis {
    polynomial<W, 3> radius, height;  ///< rho and h, in lengths; rho is not below 0
    rounded_vector<W, 5> direction;   ///< e

    RAIO_FN constexpr vec3<W> axis() const { return {direction.x, direction.y, direction.z}; }
};

/// Away from the axis, and up along it where the curve runs across it.
/// \param p  the point, as seen from the base of the axis
template <class W>
RAIO_FN constexpr vec3<W> outward_normal(const curve_beside_axis<W>& curve, const W& s, const vec3<W>& p) {
    const vec3<W> axis = curve.axis();
    W outwards = curve.radius.derivative()(s), upwards = curve.height.derivative()(s);
    W side = upwards == W(0) ? curve.height(W(1)) - curve.height(W(0)) : upwards;
    if (side == W(0)) return axis;
    vec3<W> from_axis = p - axis * dot(p, axis);
    W per_radius = quotient(upwards, length(from_axis), W(0));
    return (from_axis * per_radius - axis * outwards) * copysign(W(1), side);
}

/// The crossings in order of x; u is s, and v how far that may be off. The base of the axis is where the part of the
/// line is seen from.
/// \param over_size  1 over the unit of length
template <class W>
RAIO_FN constexpr crossing_list<W, 12> cross_revolved(const curve_beside_axis<W>& curve, const line_part<W>& part,
                                                      const W& over_size) {
    const given_number<W> unit{over_size}, half{W(0.5)};
    const auto& e = curve.direction;
    const auto p = polynomial_vector<W, 1>(part.point()) * unit;
    const auto radius = curve.radius * unit;
    const auto height = curve.height * unit;
    const auto rise = dot(p, e);
    const auto across2 = square(cross(p, e));
    const auto slant = rise[1];
    const auto m2 = across2[0];
    const auto mn = across2[1] * half;
    const auto n2 = across2[2];
    const auto g = height - rise[0];
    const auto gap = m2 - square(radius);
    const auto f = square(g) * n2 + g * (across2[1] * slant) + gap * square(slant);

    const auto roots = roots_between(f, W(0), W(1));
    crossing_list<W, 12> list;
    list.depends_on(roots);
    for (const polynomial_root<W>& root : roots) {
        if (root.before == 0 && root.after == 0) continue;  // the line lies in the surface
        const auto s = root.place();
        const auto insert = [&](const bounded_number<W>& x) {
            const vec3<W> outward = outward_normal(curve, s.value, part.from + part.along * x.value);
            list.insert(located(part.at(root_at(x), dot(part.along, outward) <= W(0)), s));
        };
        const auto by_height = g(s) / slant;
        const auto beyond = gap(s);
        const auto mn_squared = square(mn);
        const auto product = n2 * beyond;
        // A level line may pass the circle at its height by.
        if (!root.is_simple() && (mn_squared < product).certainly) continue;
        const auto [near, far] = quadratic_roots(n2, -mn, beyond, sqrt(mn_squared - product));
        if (is_better_known(by_height, near)) {
            insert(by_height);
            continue;
        }
        const auto agrees = [&](const bounded_number<W>& x) { return every(x >= by_height, x <= by_height); };
        if (root.is_simple()) {
            const bool is_far = (by_height * n2 >= -mn).yes;
            list.depends_on(agrees(is_far ? near : far));
            insert(is_far ? far : near);
        } else {
            if (agrees(near).possibly) insert(near);
            if (agrees(far).possibly) insert(far);
        }
    }
    return list;
}

}  // namespace raio

#include <raio/pop_macros.hpp>
