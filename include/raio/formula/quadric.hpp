#pragma once

#include <raio/push_macros.hpp>

#include <raio/formula/axis.hpp>
#include <raio/proof/line.hpp>
#include <raio/proof/parabola.hpp>

/// \file
/// Where a line crosses a quadric of revolution: cone, paraboloid, hyperboloid.
///
/// With a point B on the axis A and the height h = (p - B).A / A.A of a point p, such a surface is at the distance rho
/// from the axis,
///
///     rho^2 = c0 + 2 c1 h + c2 h^2
///
/// A line is seen from its point F that is nearest to B. With the ray's direction d, l from its origin to B and the
/// line's moment m = l x d, that is at t = l.d / d.d, and F = B + (m x d) / d.d. At t = l.d / d.d + tau a point of the
/// line is p - B = tau d + (F - B), and with n = d x A, g = d.A and w = (F - B).A = m.n / d.d
///
///     A.A rho^2 = |(p - B) x A|^2 = tau^2 n.n - 2 tau g w + A.A m.m / d.d - w^2,   A.A h = tau g + w
///
/// So the surface is crossed where
///
///     a tau^2 - 2 b tau + c = 0,   k = c2 / A.A
///     a = n.n - k g^2 = (1 + k) n.n - c2 d.d
///     b = g ((1 + k) w + c1),   c = A.A (m.m / d.d - c0) - w ((1 + k) w + 2 c1)
///     b^2 - a c = A.A (c0 n.n + 2 c1 m.n + c2 m.m - (1 + k) (m.A)^2) + (c1^2 - c0 c2) g^2
///
/// In the last line all that cancels is taken out of b^2 - a c. (If c1 is zero, -c0 c2 g^2 and c0 n.n A.A are c0 a
/// A.A.) |m| is |d| times the distance at which the line passes B: small and far shapes keep their digits. Where a is
/// zero, the line is parallel to a generator (a straight line through the apex) of the cone that the surface comes
/// close to far away, or to the axis of a paraboloid, and crosses once. Where a is below zero, it is steeper than
/// those, and inside before and after its two crossings, or everywhere.

namespace raio::inline RAIO_ABI {

/// What a conic section sweeps that is turned about an axis, rho^2 = c0 + 2 c1 h + c2 h^2.
template <class C0, class C1, class C2, class D>
struct turned_conic {
    C0 c0;
    C1 c1;
    C2 c2;
    D discriminant;  ///< c1^2 - c0 c2, found without a difference; below zero if the axis does not meet the surface
};
template <class C0, class C1, class C2, class D>
turned_conic(C0, C1, C2, D) -> turned_conic<C0, C1, C2, D>;

/// Where the line is inside, rho^2 <= c0 + 2 c1 h + c2 h^2.
///
/// \param l       from the line's origin to B
/// \param radius  nothing that counts of the surface is farther from the axis, or higher than h = 1 or -1. It is
///                missed unless that is above zero.
template <class W, int K, proven_vector D, proven_vector L, proven_number Radius, class... Conic>
RAIO_FN constexpr hollow_chord<W> cross_quadric(const D& d, const L& l, const rounded_vector<W, K>& axis,
                                                const turned_conic<Conic...>& conic, const Radius& radius) {
    const auto c0 = conic.c0;
    const auto c1 = conic.c1;
    const auto c2 = conic.c2;
    const auto discriminant = conic.discriminant;
    const auto two = given_number<W>{W(2)};
    const auto n = cross(d, axis);
    const auto moment = cross(l, d);
    const auto n2 = square(n);
    const auto mn = dot(moment, n);
    const auto m2 = square(moment);
    const auto d2 = square(d);
    const auto axis2 = square(axis);
    const auto k = c2 * inverse(axis2);
    const auto stretched = [&](const auto& x) { return x + k * x; };  // (1 + k) x
    const auto g = dot(d, axis);
    const auto a = stretched(n2) - c2 * d2;
    const auto beside = two * c1 * mn + c2 * m2 - stretched(square(dot(moment, axis)));
    const auto b2_less_ac = [&] {
        if constexpr (std::same_as<std::remove_cvref_t<decltype(c1)>, zero_number<W>>) {
            return axis2 * (c0 * a + beside);
        } else {
            return axis2 * (c0 * n2 + beside) + discriminant * square(g);
        }
    }();
    if (const auto missed = is_above_zero(a, b2_less_ac); all(missed)) return {nowhere<W>(missed), !missed};

    const auto over_d2 = inverse(d2);
    const auto w = mn * over_d2;
    const auto tilt = stretched(w) + c1;  // b / g
    const auto constant = [&] { return axis2 * (m2 * over_d2 - c0) - w * (tilt + c1); };
    const auto extent = [&] { return (size_of(axis) + size_of(radius)) * size_of(d) * size_of(over_d2); };
    // Where the axis meets the surface, so does a line that is steep enough.
    const mask_t<W> on_axis = !is_positive(-discriminant).yes;
    const auto sound = every(is_positive(radius), is_positive(axis2), is_positive(d2));
    hollow_chord<W> chord = where_below_zero(a, g * tilt, b2_less_ac, sound, on_axis, constant, extent);
    move_on(chord, dot(l, d) * over_d2, [&] {  // t = l.d / d.d + tau; the quadric at t = 0
        const auto height = dot(l, axis);
        return square(cross(l, axis)) - k * square(height) + two * c1 * height - c0 * axis2;
    });
    return chord;
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
