#pragma once

#include <raio/math/quadratic.hpp>
#include <raio/proof/settle.hpp>

namespace raio {

/// |p|^2 - radius^2 of a point as seen from the centre of a sphere: its power (Steiner 1826). Negative inside.
template <class W>
struct point_power {
    W value;
    bound_t<W> error;
};

/// \tparam Roundings  as below
template <int Roundings, class W, class D>
RAIO_FN constexpr point_power<W> power_of_point(const vec3<D>& p, const D& radius) {
    using E = bound_t<W>;
    D p2 = dot(p, p), r2 = radius * radius;
    W value(p2 - r2);
    return {value, with_underflow<W>(E(2 * unit_roundoff<W>) * abs(E(value)) +
                                     E(8 * Roundings * unit_roundoff<D>) * E(p2 + r2))};
}

/// Do numbers T and R leave W more than half its digits to spare, and is there a precision beyond W?
template <class W, class T, class R>
inline constexpr bool leaves_spare_digits =
    std::same_as<scalar_t<W>, strict_double>&& std::same_as<scalar_t<T>, float>&& std::same_as<scalar_t<R>, float>;

/// The chord through the sphere about `l`, as seen from where the line has t = 0.
///
/// The point at t lies on it where |t d - l|^2 = radius^2:
///
///     t = (b -+ s) / a,    a = d.d,  b = l.d,  s^2 = a radius^2 - |l x d|^2
///
/// b / a is the closest approach to the centre, s / a half a chord, and |l x d| / |d| the distance at which the line
/// passes the centre. Written with that distance, s^2 is not a difference of large squares, which is what loses small
/// and far spheres (Haines, Guenther and Akenine-Moeller, Ray Tracing Gems ch. 7, 2019).
///
/// Where there are digits to spare, b^2 - a (l.l - radius^2) takes less, and does for what is not far away.
///
/// Always inlined, as what asks it: the part that packs seldom need would make it too large for GCC's taste.
///
/// \tparam Roundings  1 if only l is rounded, and once; 2 for up to three roundings of each number
/// \tparam Spare      do the numbers given leave W digits to spare?
/// \param power        answers with the `point_power` of l, found with more digits than l has: what packs ask of rays
///                     that start on the sphere
template <int Roundings, bool Spare, class W, class Power>
[[gnu::always_inline]] RAIO_FN constexpr chord<W> cross_sphere(const vec3<W>& l, const vec3<W>& d, const W& radius,
                                                               Power power) {
    using E = bound_t<W>;
    constexpr double u = unit_roundoff<W>, least = least_normal<W>;
    W a = dot(d, d), b = dot(l, d), ar2 = a * radius * radius, s2(0);
    E s2_error(0);
    mask_t<W> brief(false);
    if constexpr (Spare) {
        // Each of the two terms is off by less than 20 Roundings u of a (l.l + radius^2). Where s^2 is 2^35 times as
        // much, which it is up to some 60 radii away, the ends of the chord are good to 2^-34 of its half.
        W l2 = dot(l, l), r2 = radius * radius;
        s2 = b * b - a * (l2 - r2), s2_error = W(64 * Roundings * u) * (a * (l2 + r2));
        const mask_t<W> passes = s2 < -s2_error;
        if (may_leave<W>(passes)) return nowhere<W>(true);
        brief = some(passes, s2 > W(0x1p35) * s2_error);
    }
    if (!all(brief)) {
        vec3<W> moment = cross(l, d);
        W passed2 = dot(moment, moment), direct = ar2 - passed2;
        E direct_error;

        // l x d is off by less than e = 4 Roundings u |l| |d|, and that decides whether the line passes by: its length
        // is on the same side of |d| radius if its square is farther from that than e (2 |d| radius + e). The size of a
        // vector is the sum of its components here, at most 1.74 times its length. Where a closer look can follow, the
        // lengths' squares do: 2 e |d| radius is at most part |d|^2 radius^2 + e^2 / part. (Any part will do: a larger
        // one leaves more tangents open, and a smaller one more of what is far away. And l may have lost its square.)
        if constexpr (std::same_as<scalar_t<W>, strict_double>) {
            constexpr double part = 0x1p-21, of_sizes = 256 * Roundings * Roundings * u * u / part;
            direct_error = E(2 * part) * (E(ar2) + E(passed2)) + E(of_sizes) * (E(a) * (E(dot(l, l)) + E(least)));
        } else {
            E d_size = norm1(vec3<E>(d)), e = E(4 * Roundings * u) * norm1(vec3<E>(l)) * d_size;
            direct_error =
                with_underflow<W>(e * (E(2) * d_size * E(radius) + e) + E(8 * Roundings * u) * (E(ar2) + E(passed2)));
        }
        if constexpr (Spare) {
            s2 = select(brief, s2, direct), s2_error = select(brief, s2_error, direct_error);
        } else {
            s2 = direct, s2_error = direct_error;
        }
    }
    // A sphere so small that the last precision cannot tell it from its centre has no normal: it is missed.
    // (b alone may have no square.)
    E blur = E(0x1p12 * u) * E(b), resolved = tie<W>(blur * blur);
    const mask_t<W> sound = a >= W(least), apart = every(sound, s2 < -s2_error);
    const mask_t<W> exists = every(s2 >= -tie<W>(s2_error), ar2 >= W(least) + resolved, radius > W(0));
    if (may_leave<W>(!exists)) return nowhere<W>(apart);

    mask_t<W> crossed = every(sound, exists, s2 > s2_error);
    W s = sqrt(max(s2, W(0))), over_a = W(1) / a;
    // Briefly, the root is off by less than s2_error / s, a 2^35th of it; and b by less than that, since it is by 18
    // Roundings u |l| |d|, and s is at most |d| radius.
    E error = E(0x1p-34) * E(s) * E(over_a);
    if (!all(brief)) {
        // A chord above a 32nd of the diameter: its ends are then right to 2^9 Roundings u of their distance.
        crossed = every(crossed, some(brief, s2 > W(0x1p-10) * ar2));
        E far = with_underflow<W>(E(0x1p9 * Roundings * u) * norm1(vec3<E>(d)) * (norm1(vec3<E>(l)) + E(radius)) *
                                  E(over_a));
        error = select(brief, error, far);
    }
    const mask_t<W> certain = some(apart, crossed);
    // Where the square of the radius has lost digits, the power is not known.
    W r2 = radius * radius, power_of_l = select(r2 >= W(least / u), dot(l, l) - r2, infinity<W>);
    vec2<W> t = quadratic_roots(over_a, b, power_of_l, s);
    W near = t.x, far = t.y;
    E near_error = error, far_error = error;
    if constexpr (only_sieves<W>) {
        // Packs ask nobody else: they have to know on which side of the sphere a ray starts.
        const mask_t<W> at_origin = every(exists, some(abs(near) <= error, abs(far) <= error));
        if (any(at_origin)) {
            // Where that is near, |b| < 2 s, the crossing there is c / sum, with c the power of the origin. Its error
            // is that of c over sum, and |c / sum| times the relative error of sum. That is error a / sum, below a
            // 50th: twice both is a bound.
            W sum = b + copysign(s, b), over_sum = quotient(W(1), sum, W(0)), size = abs(over_sum);
            auto [c, c_error] = power();
            W at = c * over_sum;
            E at_error = with_underflow<W>(E(2) * size * (c_error + abs(c) * (error * a * size)));
            const mask_t<W> starts_near = every(at_origin, abs(b) < s + s, is_finite(sum), at_error < error);
            const mask_t<W> enters = every(starts_near, sum > W(0)), leaves = every(starts_near, sum < W(0));
            near = select(enters, at, near), near_error = select(enters, at_error, near_error);
            far = select(leaves, at, far), far_error = select(leaves, at_error, far_error);
        }
    }
    chord<W> line{{exists, certain, near, near_error, exists}, {exists, certain, far, far_error, !exists}};
    // About zero the two terms of the power are alike: see `power_of_point`.
    const auto starts = [&] { return abs(E(power_of_l)) <= E(16 * Roundings * u) * E(r2); };
    if constexpr (last_precision<W>) start_on_surface(line, starts);
    return line;
}

/// The chord of the ray's line through the sphere about `center`.
template <class W, real T, real R>
[[gnu::always_inline]] RAIO_FN constexpr chord<W> cross_sphere_about(const vec3<T>& center, const T& radius,
                                                                     const ray<R>& ray) {
    using D = wide_t<W>;
    const auto power = [&] { return power_of_point<1, W>(difference_as<D>(center, ray.origin), D(radius)); };
    return cross_sphere<1, leaves_spare_digits<W, T, R>>(difference_as<W>(center, ray.origin), vec3<W>(ray.direction),
                                                         W(radius), power);
}

}  // namespace raio
