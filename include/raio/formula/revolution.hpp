#pragma once

#include <raio/push_macros.hpp>

#include <raio/proof/polynomial_crossings.hpp>

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

namespace raio::inline RAIO_ABI {

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
        if (root.sign_before == 0 && root.sign_after == 0) continue;  // the line lies in the surface
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
        if (!root.is_simple() && all(mn_squared < product)) continue;
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
            if (any(agrees(near))) insert(near);
            if (any(agrees(far))) insert(far);
        }
    }
    return list;
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
