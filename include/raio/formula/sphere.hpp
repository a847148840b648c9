#pragma once

#include <raio/push_macros.hpp>

#include <raio/proof/line.hpp>
#include <raio/proof/settle.hpp>

/// \file
/// Where a line meets a sphere.
///
/// With the ray's direction d and l from its origin to the centre, the point at t lies on the sphere where
/// |t d - l|^2 = radius^2:
///
///     a t^2 - 2 b t + c = 0,   a = d.d,   b = l.d,   c = l.l - radius^2
///     t = (b -+ s) / a,        s^2 = b^2 - a c = a radius^2 - |l x d|^2
///
/// b / a is the closest approach to the centre, s / a half a chord, and |l x d| / |d| the distance at which the line
/// passes the centre. Written with that distance, s^2 is no difference of large squares, which is what loses small and
/// far spheres (Haines, Guenther and Akenine-Moeller, Ray Tracing Gems, ch. 7, 2019). `cross_sphere` finds it like
/// this; `look_at_sphere`, which is asked first, and `quick` shapes take b^2 - a c, which costs less.

namespace raio::inline RAIO_ABI {

/// The chord through the sphere.
template <class W, int M, proven_vector L, proven_vector D>
[[gnu::always_inline]] RAIO_FN constexpr chord<W> cross_sphere(const L& l, const D& d,
                                                               const rounded_number<W, M>& radius) {
    auto a = square(d);
    auto b = dot(l, d);
    auto r2 = square(radius);
    auto ar2 = a * radius * radius;
    auto passed2 = square(cross(l, d));
    auto crosses = every(is_positive(radius), is_positive(ar2), ar2 >= passed2);
    if (all(!crosses)) return nowhere<W>();

    auto s = sqrt(ar2 - passed2);
    auto c = select(is_positive(r2), square(l) - r2, unknown_number<W>());  // r2 may be too small for a number
    auto [near_end, far_end] = quadratic_roots(a, b, c, s);  // (b -+ s) / a
    // From 2^89 radii away nothing can be told of it.
    return between(every(crosses, is_root_told_from_zero(ar2, b)), near_end, far_end);
}

/// c = |l|^2 - radius^2, of which packs of floats need more digits than they have: found in double.
/// \tparam Roundings  of each of the numbers given
template <int Roundings, class W, class D>
RAIO_FN constexpr bounded_number<W> power_of_point(const vec3<D>& l, const D& radius) {
    using E = bound_t<W>;
    D l2 = dot(l, l), r2 = radius * radius;
    W value(l2 - r2);
    return {value, E(2 * unit_roundoff<W>) * abs(E(value)) + E(8 * Roundings * unit_roundoff<D>) * E(l2 + r2)};
}

/// Packs of floats have to know on which side of the sphere a ray starts that starts near it: of b - s and b + s one
/// cancels there. Their product is a c.
/// \param sum_error  bound of the error of b -+ s
template <class W>
RAIO_FN constexpr void tell_side(const mask_t<W>& known, const W& b, const W& s, const bound_t<W>& sum_error,
                                 const bounded_number<W>& c, bounded_number<W>& near_end, bounded_number<W>& far_end) {
    using E = bound_t<W>;
    W sum = b + copysign(s, b), over = quotient(W(1), sum, W(0));
    E size = abs(E(over)), error = E(2) * size * (c.error + size_of(c) * (sum_error * size));
    bounded_number<W> better(c.value * over, error + E(detail::lost<W>));
    const mask_t<W> starts = every(known, abs(b) < s + s, is_finite(sum), better.error < near_end.error);
    near_end = choose_where(every(starts, sum > W(0)), better, near_end);
    far_end = choose_where(every(starts, sum < W(0)), better, far_end);
}

/// Does W, a double, have more than twice the digits of the floats that a shape and its rays are made of?
template <class W, class T>
inline constexpr bool has_spare_digits = std::same_as<scalar_t<W>, strict_double>&& std::same_as<scalar_t<T>, float>;

namespace detail {

/// b^2 - a c for a line and a sphere, and how far that may be off.
template <class W>
struct sphere_look {
    W a, b, s2;
    bound_t<W> of_a, bound;  ///< `of_a` bounds a itself

    RAIO_FN constexpr mask_t<W> passes() const { return s2 < -W(bound); }
};

/// How many roundings of a (l.l + radius^2) it may be off.
template <class L, class D, int M>
inline constexpr int sphere_roundings = 20 + 2 * M + 4 * (roundings_in<L> + roundings_in<D>);

/// The difference is good enough to tell most lines that miss, and those that cross a sphere less than some ninety
/// radii away.
///
/// Each component of l is off by K roundings, of d by L, and the radius by M: b is off by K + L + 3 roundings of
/// |l| |d|, and b^2 - a c by less than 4 K + 4 L + 2 M + 18 of a (l.l + radius^2). Two more are for the roundings of
/// that bound. If l and d have bounds of their errors, dl and dd, b^2 - a c is off by 4 a |l| dl + 4 (l.l + radius^2)
/// |d| dd besides, to first order; twice that covers the rest.
/// \tparam T  of what the shape and its rays are made
template <class T, class Line, class L, class D, class W, int M>
[[gnu::always_inline]] RAIO_FN constexpr sphere_look<W> look_at_sphere(const L& l, const D& d,
                                                                       const rounded_number<W, M>& radius) {
    using E = bound_t<W>;
    W a = square(d).value, b = dot(l, d).value, l2 = square(l).value, r2 = square(radius).value;
    W s2 = b * b - a * (l2 - r2);
    E of_a(a), of_c(l2 + r2), least(0);
    if constexpr (!has_spare_digits<W, T> || roundings_in<L> + roundings_in<D> + M > 1) {
        least = E(lost<W>), of_a += least, of_c += least;  // the squares may be too small to have all digits
    }
    // a (l.l + radius^2) first: where a c is out of range, so is the bound.
    E bound = of_a * of_c * E(sphere_roundings<L, D, M> * unit_roundoff<W>) + least;
    if constexpr (!Line::is_exact) {
        const E of_both = of_a * (most_of(l) + size_of(radius)) * error_of(l) + of_c * most_of(d) * error_of(d);
        bound += E(8) * of_both;
    }
    return {a, b, s2, of_a, bound};
}

}  // namespace detail

/// The same, with less to do where the line is known to miss, or to cross a sphere less than some ninety radii away.
/// Leaves of trees spend their time here, so the bounds are derived by hand.
///
/// If s^2 = b^2 - a c is 2^-13 / u times its bound or more, s is off by half of bound / s. And as s is at most |d|
/// radius, |l| |d| is at most a (l.l + radius^2) / (2 s): what b, b -+ s and the division are off by comes to half of
/// bound / s as well.
///
/// What doubles cross goes the other way: of their t more is wanted.
/// \tparam T     of what the shape and its rays are made
/// \param power  answers with the `power_of_point` of the ray's origin, which it is given
template <class T, class Line, proven_vector L, proven_vector D, int M, class Power>
[[gnu::always_inline]] RAIO_FN constexpr auto cross_sphere_along(const Line& line, const L& l, const D& d,
                                                                 const rounded_number<typename Line::number, M>& radius,
                                                                 [[maybe_unused]] Power power)
    -> chord<typename Line::number> {
    using W = typename Line::number;
    using E = bound_t<W>;
    if constexpr (is_believed<W>) {  // as it is printed everywhere: cheaper, and small and far spheres lose digits
        auto a = square(d);
        auto b = dot(l, d);
        auto c = square(l) - square(radius);
        auto s2 = square(b) - a * c;
        auto crosses = is_not_negative(s2);
        if (all(!crosses)) return nowhere<W>();
        auto [enters, leaves] = quadratic_roots(a, b, c, sqrt(s2));
        return between(every(is_positive(radius), crosses), enters, leaves);
    }
    if constexpr (!has_closer_look<W>) return cross_sphere(l, d, radius);
    auto look = detail::look_at_sphere<T, Line>(l, d, radius);
    mask_t<W> passes = look.passes();
    if (all(passes)) return nowhere<W>();
    if constexpr (!has_spare_digits<W, T> && !only_sieves<W>) return cross_sphere(l, d, radius);

    constexpr double enough = 0x1p-13 / (detail::sphere_roundings<L, D, M> * unit_roundoff<W>);
    mask_t<W> meets = every(look.s2 > W(enough) * W(look.bound), is_finite(look.s2), radius.value > W(0));
    mask_t<W> known = some(passes, meets);
    if (none(known)) return cross_sphere(l, d, radius);
    W b = look.b, s = sqrt(max(look.s2, W(detail::lost<W>))), over_a = W(1) / look.a;
    E error = with_underflow<W>(E(1.25) * look.bound / E(s) * E(over_a));
    bounded_number<W> near_end((b - s) * over_a, error), far_end((b + s) * over_a, error);
    if constexpr (std::same_as<scalar_t<W>, float>) {
        const mask_t<W> beside = every(meets, some(size_of(near_end) <= error, size_of(far_end) <= error));
        if (any(beside)) tell_side(beside, b, s, error * look.of_a, power(line.ray.origin), near_end, far_end);
    }
    chord<W> c = between({meets, meets, meets}, near_end, far_end);
    if (all(known)) return c;
    chord<W> other = cross_sphere(l, d, radius);
    return {select(known, c.near, other.near), select(known, c.far, other.far)};
}

/// Does a line pass the sphere, beyond doubt? Found in the numbers that both are made of, whose products may be fused
/// with a sum: the verdict is right either way.
template <std::floating_point T>
RAIO_FN constexpr bool passes_sphere(const vec3<T>& center, const T& radius, const ray<T>& ray) {
    using own = raio::line<T>;
    const own line(ray);
    return detail::look_at_sphere<T, own>(line.to(center), line.direction(), line.given(radius)).passes();
}

/// The chord through the sphere about a center.
template <class Line, real T>
[[gnu::always_inline]] RAIO_FORMULA constexpr auto cross_sphere_about(const vec3<T>& center, const T& radius,
                                                                      const Line& line)
    -> chord<typename Line::number> {
    using W = typename Line::number;
    const auto power = [&](const auto& origin) {
        using D = wide_t<W>;
        return power_of_point<1, W>(difference_as<D>(center, origin), D(radius));
    };
    auto l = line.to(center);
    auto d = line.direction();
    auto r = line.given(radius);
    if constexpr (Line::is_exact && std::same_as<T, double> && !is_believed<W>) {
        return cross_sphere(l, d, r);  // `hit` and `occluded` have asked before whether the line passes
    } else {
        return cross_sphere_along<T>(line, l, d, r, power);
    }
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
