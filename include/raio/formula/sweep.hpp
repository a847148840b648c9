#pragma once

#include <raio/push_macros.hpp>

#include <raio/proof/extremum.hpp>
#include <raio/proof/polynomial_crossings.hpp>

/// \file
/// Where a line goes into what a sphere sweeps whose centre and radius are cubics, and out of it.

namespace raio::inline RAIO_ABI::detail {

/// b and s along the curve, for a part of the line (see shape/bezier_curve.hpp, where b, s and d are defined).
template <class W>
struct sweep {
    bounded_number<W> d2;  ///< d.d
    differentiated<W, 3> b;
    differentiated<W, 6> minus_s;

    /// From the least t of a stretch of the curve to the greatest.
    RAIO_FN constexpr chord<W> extent(const line_part<W>& part, const stretch<W>& where) const {
        if (where.may_be_point()) return at(part, where.point());
        chord<W> c = unite(at(part, where.from), at(part, where.to));
        const auto turns = minus_s.value * square(b.slope + b.slope) + square(minus_s.slope);  // s'^2 - 4 s b'^2
        for (const polynomial_root<W>& root : roots_between(turns, where.from.value, where.to.value)) {
            c = unite(c, at(part, root.place()));
        }
        return c;
    }

    /// Where the line goes into the sphere of u, and out of it: at the least t of all about it, and the greatest.
    RAIO_FN constexpr chord<W> at(const line_part<W>& part, const bounded_number<W>& u) const {
        const auto [near, far] = extremes_near(b, minus_s, u);
        return {located(part.at(root_at(near / d2), true), u), located(part.at(root_at(far / d2), false), u)};
    }
};

}  // namespace raio::inline RAIO_ABI::detail

#include <raio/pop_macros.hpp>
