#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/polynomial.hpp>
#include <raio/proof/line_part.hpp>

/// \file
/// Which parts of a surface of revolution a line passes by, for less than it takes to cross them.

namespace raio::inline RAIO_ABI {

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

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
