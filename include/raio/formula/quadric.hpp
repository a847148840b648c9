#pragma once

#include <raio/formula/axis.hpp>

/// \file
/// Where a line crosses a surface of the second degree; what is common to all of them, and those of revolution: cone,
/// paraboloid, hyperboloid.
///
/// With a point B on the axis A and the height h = (p - B).A / A.A, such a surface is v rho^2 = c0 + c1 h + c2 h^2.
/// From the line's closest approach to B on, with l = B - origin, m = l x d, n = d x A and w = m.n / d.d, the height
/// there, the points of the surface are at
///
///     a t^2 - 2 b t + c = 0,    a = v n.n - k (d.A)^2,  b = d.A (v w + k w + c1 / 2),    k = c2 / A.A
///     c = A.A (v m.m / d.d - c0) - w (v w + k w + c1)
///     b^2 - a c = v (A.A (c0 n.n + c1 m.n - v (m.A)^2) + c2 (A.A m.m - (m.A)^2)) + (d.A)^2 (c1^2 / 4 - c0 c2)
///
/// Written like this, b^2 - a c is free of the differences of large squares that lose small and far shapes, and for a
/// cone about its apex, where c0 and c1 are 0, it is exact to the square of the distance at which the line passes.

namespace raio {

/// The surface v rho^2 = c0 + c1 h + c2 h^2, to be told from W's rounding errors: each number is off by 8 roundings at
/// most.
template <class W>
struct revolved_quadric {
    vec3<W> axis;    ///< the unit of h; what counts of the surface lies between h = -1 and h = 1
    W v;             ///< above 0
    W c0, c1, c2;    ///< squares of lengths
    W discriminant;  ///< c1^2 / 4 - c0 c2, found without that difference; at least 0 if the axis meets the surface
    W radius;        ///< nothing that counts of the surface is farther from the axis

    /// v rho^2 - c0 - c1 h - c2 h^2, times (A.A)^2, at the point p as seen from B.
    RAIO_FN constexpr W level(const vec3<W>& p) const {
        vec3<W> across = cross(p, axis);
        W axis2 = dot(axis, axis), height = dot(p, axis);
        return axis2 * (v * dot(across, across) - axis2 * c0 - c1 * height) - c2 * height * height;
    }

    /// A bound of the level's terms at a point no farther from B; it is off by 32 roundings of that at most.
    RAIO_FN constexpr bound_t<W> terms_within(const bound_t<W>& far) const {
        using E = bound_t<W>;
        E area(dot(axis, axis)), size = norm1(vec3<E>(axis));
        return area * ((E(v) * area + abs(E(c2))) * far * far + abs(E(c1)) * size * far + area * abs(E(c0)));
    }
};

/// Where a line is inside a quadric.
template <class W>
struct quadric_chord {
    chord<W> ends;
    mask_t<W> hollow;  ///< is it inside before and after the two ends, and not between them?
};

/// a x^2 - 2 b x + c at the place x of a line, below zero inside of a quadric.
template <class W>
struct parabola {
    using E = bound_t<W>;

    W a, b, square;  ///< square = b^2 - a c
    E a_error, b_error, square_error;
    mask_t<W> in_range;  ///< are all of these numbers, and not off by more than they can be?

    /// Does the line miss, beyond doubt?
    RAIO_FN constexpr mask_t<W> misses() const {
        return every(in_range, E(a) > E(2) * a_error, square < -square_error);
    }
};

/// Where it is zero or below, between -reach and reach: all that counts of the quadric is within half of that.
///
/// \param wide      is there a quadric at all?
/// \param on_axis   is `square` known not to be below 0 where a is?
/// \param constant  says c, for those who need it
template <class W, class Constant>
RAIO_FN constexpr quadric_chord<W> cross_parabola(const parabola<W>& f, const bound_t<W>& reach, const mask_t<W>& wide,
                                                  const mask_t<W>& on_axis, Constant constant) {
    using E = bound_t<W>;
    constexpr double u = unit_roundoff<W>;
    W zero(0), a = f.a, b = f.b, square = f.square;
    E a_error = f.a_error, b_error = f.b_error, square_error = f.square_error, a_size = abs(E(a)), b_size = abs(E(b));
    const mask_t<W> passes = f.misses();
    if constexpr (last_precision<W>) {
        // Of a line that all but lies in the surface a, b and c are tiny, and tell more than their difference at large.
        const auto [c, c_error] = constant();
        E direct_error = b_error * (E(2) * b_size + b_error) + c_error * (a_size + a_error) + a_error * abs(E(c)) +
                         E(8 * u) * (E(b * b) + abs(E(a * c)));
        if (direct_error < square_error) square = b * b - a * c, square_error = direct_error;
    }

    W root = sqrt(max(square, zero));
    const mask_t<W> meets = square > square_error;
    E root_error = quotient(square_error, E(root), E(infinity<E>));
    if constexpr (std::same_as<mask_t<W>, bool> && !std::same_as<W, strict_double>) {
        // The roots of two numbers differ by no more than the root of their difference.
        if (!meets) root_error = sqrt(square_error);
    }
    W over_a = quotient(W(1), a, zero), x = (b - root) * over_a, y = (b + root) * over_a;
    E farthest = (b_size + E(root)) * abs(E(over_a));
    E of_two = E(2) * (b_error + root_error + farthest * a_error) * abs(E(over_a)) + E(8 * u) * farthest;

    const mask_t<W> plain = every(f.in_range, meets, a_size > E(2) * a_error, farthest <= reach, of_two < reach);
    mask_t<W> exists = every(plain, wide), certain = some(plain, passes), hollow = every(plain, a < zero);
    W near = min(x, y), far_end = max(x, y);
    E error = of_two;
    if (!all(certain)) {
        // One of the two roots cancels if the equation is as good as linear.
        const auto [c, c_error] = constant();
        W sum = b + copysign(root, b), only = quotient(c, sum, zero);
        E sum_size = abs(E(sum)), sum_error = b_error + root_error + E(4 * u) * sum_size;
        E of_one = E(2) * quotient(c_error + abs(E(only)) * sum_error, sum_size, E(0));

        // Where the equation does not change its sign, the line is inside everywhere or nowhere; where nothing of it
        // can be told from zero, it lies in the surface. If it is as good as linear (the line is parallel to a
        // generator, or to the axis of a paraboloid), the other root is out of reach; if this one is as well, no end
        // of reach lies before it.
        E change = c_error + reach * ((a_size + a_error) * reach + E(2) * (b_size + b_error));
        const mask_t<W> apart = square < -square_error, touches = square >= -tie<W>(square_error);
        const mask_t<W> finite = every(f.in_range, is_finite(b_size + abs(E(c)))), steady = abs(E(c)) > change;
        const mask_t<W> linear = every(!plain, sum_size - sum_error > E(2) * reach * (a_size + a_error));
        const mask_t<W> blind = some(a_size <= a_error, every(!apart, of_two >= reach));
        const mask_t<W> level = every(!plain, some(steady, every(!linear, blind))),
                        steep = every(!level, !linear, a < zero);
        hollow = every(steep, some(on_axis, touches));
        const mask_t<W> everywhere = some(level, every(steep, !hollow));
        exists =
            every(wide, some(every(level, c <= tie<W>(change)), every(!level, some(linear, steep, touches))), finite);
        const mask_t<W> one = every(linear, meets, sum_size > E(2) * sum_error);
        const mask_t<W> two =
            every(!linear, !blind, a_size > E(2) * a_error, some(meets, apart, every(steep, on_axis)));
        certain = every(finite, some(passes, steady, one, two));

        W end(reach);
        near = select(everywhere, -end, select(linear, select(sum > zero, only, min(-end, only)), near));
        far_end = select(everywhere, end, select(linear, select(sum > zero, max(end, only), only), far_end));
        error = select(everywhere, E(0), select(linear, of_one, of_two));
    }
    return {{{exists, certain, near, error, !hollow}, {exists, certain, far_end, error, hollow}}, hollow};
}

/// Where a line is inside a quadric and a convex solid.
template <class W, class Wanted>
RAIO_FN constexpr chords_for_t<W, Wanted> intersect(const quadric_chord<W>& c, const chord<W>& convex,
                                                    const Wanted& wanted) {
    using E = bound_t<W>;
    const mask_t<W> yes = W(0) == W(0), exists = c.ends.near.exists, certain = c.ends.near.certain;
    // Where the quadric is hollow, the line is inside until the near end, and from the far one on.
    W near = c.ends.near.t, far = c.ends.far.t, end = infinity<W>;
    E near_error = c.ends.near.error, far_error = c.ends.far.error;
    W begins = select(c.hollow, -end, near), leaves = select(c.hollow, near, far);
    E leaves_error = select(c.hollow, near_error, far_error);
    if constexpr (std::same_as<chords_for_t<W, Wanted>, chord<W>>) {
        const mask_t<W> is_first = wanted.is_first;
        begins = select(is_first, begins, far), leaves = select(is_first, leaves, end);
        near_error = select(is_first, near_error, far_error);
        return intersect(
            chord<W>{{exists, certain, begins, near_error, yes}, {exists, certain, leaves, leaves_error, !yes}},
            convex);
    } else {
        if constexpr (std::same_as<mask_t<W>, bool>) {  // of many lanes some are hollow
            if (!c.hollow) return {intersect(c.ends, convex), nowhere<W>(yes)};
        }
        const mask_t<W> again = every(c.hollow, exists), known = some(!c.hollow, certain);
        return {intersect(
                    chord<W>{{exists, certain, begins, near_error, yes}, {exists, certain, leaves, leaves_error, !yes}},
                    convex),
                intersect(chord<W>{{again, known, far, far_error, yes}, {again, known, end, far_error, !yes}}, convex)};
    }
}

/// \param to_center  from the origin of the ray to B
/// \param far        at least as long; to_center is off by a rounding of that
template <class W>
RAIO_FN constexpr quadric_chord<W> cross_quadric(const revolved_quadric<W>& s, const vec3<W>& to_center,
                                                 const bound_t<W>& far, const vec3<W>& d) {
    using E = bound_t<W>;
    constexpr double u = unit_roundoff<W>, least = least_normal<W>;
    vec3<W> n = cross(d, s.axis), m = cross(to_center, d);
    W zero(0), d2 = dot(d, d), axis2 = dot(s.axis, s.axis), n2 = dot(n, n), m2 = dot(m, m), mn = dot(m, n);
    W along = dot(d, s.axis), along2 = along * along, turn = dot(m, s.axis), turn2 = turn * turn;
    W k = s.c2 * quotient(W(1), axis2, zero);
    parabola<W> f;
    f.a = s.v * n2 - k * along2;
    f.square =
        s.v * (axis2 * (s.c0 * n2 + s.c1 * mn - s.v * turn2) + s.c2 * (axis2 * m2 - turn2)) + along2 * s.discriminant;

    // The errors, with u the unit roundoff. Everything that m goes into is linear or quadratic in it: with |m| off by
    // m_error, the roundings of all that is made of it included, m.m is off by twice m2_error. |n| and |d.A| are at
    // most |d| |A|, and |w| is at most |m| |A| / |d|.
    E d_size = norm1(vec3<E>(d)), axis_size = norm1(vec3<E>(s.axis)), span = d_size * axis_size, area(axis2);
    E m_size = norm1(vec3<E>(m)), m_error = with_underflow<W>(E(4 * u) * far * d_size + E(24 * u) * m_size);
    E m2_error = with_underflow<W>((m_size + m_error) * m_error), v(s.v), ratio = v + abs(E(k));
    E c0 = abs(E(s.c0)), c1 = abs(E(s.c1)), of_c1 = E(2) * c1 * span * m_error;
    f.a_error = with_underflow<W>(E(32 * u) * ratio * E(d2) * area);
    f.square_error = with_underflow<W>(area * (v * (E(2) * (v * area + abs(E(s.c2))) * m2_error + of_c1) +
                                               E(64 * u) * (v * area * c0 + abs(E(s.discriminant))) * E(d2)));
    f.in_range = every(is_finite(abs(E(f.a)) + abs(E(f.square))), d2 >= W(least), axis2 >= W(least));
    const mask_t<W> passes = f.misses();
    if (may_leave<W>(passes)) return {nowhere<W>(passes), zero != zero};

    W over_d2 = quotient(W(1), d2, zero), w = mn * over_d2, tilt = (s.v + k) * w;
    E over(over_d2);
    f.b = along * (tilt + W(0.5) * s.c1);
    f.b_error = with_underflow<W>(E(2) * ratio * area * m_error + E(8 * u) * c1 * span);
    const auto constant = [&] {
        return bounded_number<W>{
            axis2 * (s.v * m2 * over_d2 - s.c0) - w * (tilt + s.c1),
            with_underflow<W>((E(4) * ratio * area * m2_error + of_c1) * over + E(16 * u) * area * c0)};
    };
    // A radius that the last precision cannot tell from none leaves no normal: such a shape is missed.
    E reach = E(2) * (axis_size + E(s.radius)) * d_size * over, extent = far + axis_size;
    E resolved = E(least) + tie<W>(E(0x1p30 * u * u) * (extent * extent));
    const mask_t<W> wide = every(s.radius > zero, E(s.radius) * E(s.radius) >= resolved);
    // Where the axis meets the surface, a line that is steep enough cannot miss it.
    quadric_chord<W> of_line = cross_parabola(f, reach, wide, s.discriminant >= zero, constant);

    W middle = dot(to_center, d) * over_d2;
    const auto from_origin = [&](const crossing<W>& c) {
        E error = with_underflow<W>(c.error + E(16 * u) * (far * d_size * over));
        return crossing<W>{c.exists, c.certain, middle + c.t, error, c.entering};
    };
    quadric_chord<W> c{{from_origin(of_line.ends.near), from_origin(of_line.ends.far)}, of_line.hollow};
    // Whether the line starts on the surface, its coefficients from the origin on say without a division.
    const auto starts = [&] { return abs(E(s.level(-to_center))) <= E(32 * u) * s.terms_within(far); };
    if constexpr (!only_sieves<W>) start_on_surface(c.ends, starts);
    return c;
}

}  // namespace raio
