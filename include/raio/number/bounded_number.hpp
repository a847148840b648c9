#pragma once

#include <raio/push_macros.hpp>

#include <raio/number/double_double.hpp>

/// \file
/// Numbers that know how far off they may be.
///
/// A formula that is computed with them says, with every number it finds, a bound of its rounding errors, and with
/// every decision, whether they can have changed it. It need not mention them. (Running error analysis: Wilkinson 1963;
/// Higham, Accuracy and Stability of Numerical Algorithms, ch. 3. As filters of geometric predicates: Fortune and Van
/// Wyk 1993; Burnikel, Funke and Seel 2001; Melquiond and Pion 2007.)
///
/// Two kinds of them are enough. Products, quotients and roots keep their relative error: how many roundings it is, is
/// counted by the type, and nothing is computed. A sum can cancel: it carries a bound.

namespace raio::inline RAIO_ABI {

/// A number whose relative error is at most K roundings. One that is given has none, K = 0.
template <class W, int K>
struct rounded_number {
    using number = W;

    W value;

    RAIO_FN constexpr rounded_number operator-() const { return {-value}; }
};
template <class W>
using given_number = rounded_number<W, 0>;

/// Zero, as a type: what a formula has of it is not computed.
template <class W>
struct zero_number {
    using number = W;

    RAIO_FN constexpr zero_number operator-() const { return {}; }
};

namespace detail {

/// What the smallest numbers lose of their digits is less than this: of products of floats in float, of doubles. Bounds
/// in float keep count of it. In double, and where roundings are all that is counted, a formula must not multiply
/// products that are too small for their digits by more than 2^25 in float, 2^10 in double, before a root or an
/// inverse, and by 2^49 or 2^114 without one. (Numbers with a larger range than a double's lose nothing.)
template <class W>
inline constexpr double lost = std::numeric_limits<scalar_t<W>>::max_exponent > 1024 ? 0
                               : std::same_as<scalar_t<W>, float>                    ? 0x1p-100
                                                                                     : 0x1p-960;
template <class W>
inline constexpr double greatest_divisor = lost<W> > 0 ? 1 / lost<W> : std::numeric_limits<double>::infinity();

/// So many roundings of numbers of this size.
template <class W>
RAIO_FN constexpr bound_t<W> roundings(int count, const bound_t<W>& size) {
    using E = bound_t<W>;
    if constexpr (std::same_as<scalar_t<W>, float>) {
        return E(count * unit_roundoff<W>) * size + E(lost<W>);
    } else {
        return E(count * unit_roundoff<W>) * size;
    }
}

}  // namespace detail

/// A number and a bound of how far it is from the exact one.
template <class W>
struct bounded_number {
    using number = W;

    W value;
    bound_t<W> error;

    bounded_number() = default;
    RAIO_FN constexpr bounded_number(const W& v, const bound_t<W>& e) : value(v), error(e) {}
    template <int K>
    RAIO_FN constexpr bounded_number(const rounded_number<W, K>& a)
        : value(a.value), error(K == 0 ? bound_t<W>(0) : detail::roundings<W>(K, abs(bound_t<W>(a.value)))) {}

    RAIO_FN constexpr bounded_number(const zero_number<W>&) : value(W(0)), error(0) {}

    RAIO_FN constexpr bounded_number operator-() const { return {-value, error}; }
};

/// A number of which nothing is known.
template <class W>
RAIO_FN constexpr bounded_number<W> unknown_number() {
    return {W(0), bound_t<W>(infinity<bound_t<W>>)};
}

namespace detail {

/// What a sum is off by. Numbers of two parts add up their low parts by themselves: with u = 2^-53 the three sums of
/// them round away 2 u^2 of the sizes of both numbers, u^2 of that of the sum, whatever cancels.
template <class W>
RAIO_FN constexpr bound_t<W> error_of_sum(const bound_t<W>& sum, [[maybe_unused]] const bound_t<W>& a,
                                          [[maybe_unused]] const bound_t<W>& b) {
    if constexpr (last_precision<W>) {
        return roundings<W>(1, sum) + bound_t<W>(0x1p-105) * (a + b);
    } else {
        return roundings<W>(1, sum);
    }
}

/// A bound of errors, rounded up: itself the result of no more than a hundred roundings.
template <class W>
RAIO_FN constexpr bound_t<W> rounded_up(const bound_t<W>& error) {
    return error * bound_t<W>(1 + 0x1p-16);
}

/// How far a number may be off, everything counted.
template <class W>
RAIO_FN constexpr bound_t<W> limit_of(const bounded_number<W>& a) {
    return rounded_up<W>(a.error) + bound_t<W>(lost<W>);
}

template <class N>
inline constexpr bool is_proven = false;
template <class W, int K>
inline constexpr bool is_proven<rounded_number<W, K>> = true;
template <class W>
inline constexpr bool is_proven<bounded_number<W>> = true;
template <class W>
inline constexpr bool is_proven<zero_number<W>> = true;

}  // namespace detail

/// A number that knows how far off it may be.
template <class N>
concept proven_number = detail::is_proven<N>;

template <proven_number A>
RAIO_FN constexpr auto size_of(const A& a) {
    return abs(bound_t<typename A::number>(a.value));
}

/// What was found, as a number that is given: of a unit, or of a place to start from, no other one is meant.
template <proven_number A>
RAIO_FN constexpr given_number<typename A::number> as_given(const A& a) {
    return {a.value};
}

template <class W>
RAIO_FN constexpr bounded_number<W> operator+(const bounded_number<W>& a, const bounded_number<W>& b) {
    W sum = a.value + b.value;
    return {sum, a.error + b.error + detail::error_of_sum<W>(abs(bound_t<W>(sum)), size_of(a), size_of(b))};
}
template <class W>
RAIO_FN constexpr bounded_number<W> operator*(const bounded_number<W>& a, const bounded_number<W>& b) {
    W product = a.value * b.value;
    return {product, a.error * (size_of(b) + b.error) + size_of(a) * b.error +
                         detail::roundings<W>(1, abs(bound_t<W>(product)))};
}
template <class W, int K>
RAIO_FN constexpr bounded_number<W> operator*(const bounded_number<W>& a, const rounded_number<W, K>& b) {
    W product = a.value * b.value;
    return {product, a.error * size_of(b) + detail::roundings<W>(K + 1, abs(bound_t<W>(product)))};
}
template <class W, int K>
RAIO_FN constexpr bounded_number<W> operator*(const rounded_number<W, K>& a, const bounded_number<W>& b) {
    return b * a;
}
template <class W, int K, int L>
RAIO_FN constexpr rounded_number<W, K + L + 1> operator*(const rounded_number<W, K>& a, const rounded_number<W, L>& b) {
    return {a.value * b.value};
}

template <proven_number A, proven_number B>
RAIO_FN constexpr auto operator+(const A& a, const B& b) {
    using bounded = bounded_number<typename A::number>;
    return bounded(a) + bounded(b);
}
template <proven_number A, proven_number B>
RAIO_FN constexpr auto operator-(const A& a, const B& b) {
    return a + -b;
}

template <class W, proven_number A>
RAIO_FN constexpr A operator+(const zero_number<W>&, const A& a) {
    return a;
}
template <class W, proven_number A>
RAIO_FN constexpr A operator+(const A& a, const zero_number<W>&) {
    return a;
}
template <class W>
RAIO_FN constexpr zero_number<W> operator+(const zero_number<W>&, const zero_number<W>&) {
    return {};
}
template <class W, proven_number A>
RAIO_FN constexpr zero_number<W> operator*(const zero_number<W>&, const A&) {
    return {};
}
template <class W, proven_number A>
RAIO_FN constexpr zero_number<W> operator*(const A&, const zero_number<W>&) {
    return {};
}
template <class W>
RAIO_FN constexpr zero_number<W> operator*(const zero_number<W>&, const zero_number<W>&) {
    return {};
}

template <class W>
RAIO_FN constexpr zero_number<W> square(const zero_number<W>&) {
    return {};
}

template <class W, int K>
RAIO_FN constexpr rounded_number<W, 2 * K + 1> square(const rounded_number<W, K>& a) {
    return a * a;
}
template <class W>
RAIO_FN constexpr bounded_number<W> square(const bounded_number<W>& a) {
    W product = a.value * a.value;
    return {product, a.error * (bound_t<W>(2) * size_of(a) + a.error) + detail::roundings<W>(1, bound_t<W>(product))};
}

/// 1 / a. Nothing is known of it where a may be zero.
template <class W>
RAIO_FN constexpr bounded_number<W> inverse(const bounded_number<W>& a) {
    using E = bound_t<W>;
    W over = quotient(W(1), a.value, W(infinity<W>));
    // |1 / a - 1 / a'| = |a - a'| / |a a'|, and |a'| is at least half of |a|.
    E size = abs(E(over)), error = E(2) * a.error * size * size + detail::roundings<W>(1, size);
    const mask_t<E> is_apart = size_of(a) > E(2) * a.error + E(detail::lost<W>);
    return {over, select(is_apart, error, E(infinity<E>))};
}
template <class W, int K>
RAIO_FN constexpr rounded_number<W, K + 1> inverse(const rounded_number<W, K>& a) {
    using E = bound_t<W>;
    if constexpr (is_believed<W>) return {quotient(W(1), a.value, W(infinity<W>))};
    const E size = size_of(a);  // and of numbers that are too large, the inverse is too small for its digits
    const mask_t<W> is_apart = every(size > E(detail::lost<W>), size < E(detail::greatest_divisor<W>));
    return {select(is_apart, W(1), W(std::numeric_limits<scalar_t<W>>::quiet_NaN())) / select(is_apart, a.value, W(1))};
}

/// a / b. It may be anything where b may be zero.
template <proven_number A, proven_number B>
RAIO_FN constexpr auto operator/(const A& a, const B& b) {
    using W = typename A::number;
    using E = bound_t<W>;
    const bounded_number<W> above = a, below = b;
    W over = quotient(W(1), below.value, W(infinity<W>)), ratio = above.value * over;
    // a / b - a' / b' = (a - a' - (a / b) (b - b')) / b', and |b'| is at least |b| less its error.
    E size = abs(E(ratio)), off = above.error + size * below.error, least = size_of(below) - below.error;
    const mask_t<E> is_apart = least > E(detail::lost<W>);
    E error = last_precision<W> ? quotient(off, least, E(0)) : E(2) * off * abs(E(over));
    // ... which is at least half of |b|, or all is asked again
    const mask_t<E> is_half = last_precision<W> ? is_apart : every(is_apart, size_of(below) > E(2) * below.error);
    return bounded_number<W>{ratio, select(is_half, error + detail::roundings<W>(3, size), E(infinity<E>))};
}

/// The root, and 0 of what is negative: of what should be zero it may be an error.
template <class W>
RAIO_FN constexpr bounded_number<W> sqrt(const bounded_number<W>& a) {
    using E = bound_t<W>;
    W root = sqrt(max(a.value, W(0)));
    // |s - s'| = |a - a'| / (s + s'), and no more than |a - a'|^(1/2).
    E size(root), off = a.error + E(detail::lost<W>), error = quotient(off, size, E(infinity<E>));
    if constexpr (!has_closer_look<W> && !is_believed<W>) error = min(error, sqrt(off));
    return {root, error + detail::roundings<W>(1, size)};
}
/// Half of the roundings, and one; a root of numbers that may have lost digits would not be near it.
template <class W, int K>
RAIO_FN constexpr rounded_number<W, (K + 3) / 2> sqrt(const rounded_number<W, K>& a) {
    if constexpr (K == 0 || is_believed<W>) {
        return {sqrt(a.value)};
    } else {
        const mask_t<W> has_digits = a.value > W(detail::lost<W>);
        return {select(has_digits, sqrt(a.value), W(std::numeric_limits<scalar_t<W>>::quiet_NaN()))};
    }
}

template <proven_number A>
RAIO_FN constexpr A abs(const A& a) {
    A size = a;
    size.value = abs(a.value);
    return size;
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
