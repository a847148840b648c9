#pragma once

#include <raio/number/double_double.hpp>
#include <raio/number/verdict.hpp>

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

namespace raio {

/// A number whose relative error is at most K roundings. One that is given has none, K = 0.
template <class W, int K>
struct rounded_number {
    using number = W;

    W value;

    RAIO_FN constexpr rounded_number operator-() const { return {-value}; }
};
template <class W>
using given_number = rounded_number<W, 0>;

namespace detail {

/// What the smallest numbers lose of their digits is less than this: of products of floats in float, of doubles. Bounds
/// in float keep count of it. In double, and where roundings are all that is counted, a formula must not multiply
/// products that are too small for their digits by more than 2^25 in float, 2^10 in double, before a root or an
/// inverse, and by 2^49 or 2^114 without one.
template <class W>
inline constexpr double lost = std::same_as<scalar_t<W>, float> ? 0x1p-100 : 0x1p-960;

/// So many roundings, as a part of a number's size.
template <class W>
RAIO_FN constexpr bound_t<W> relative(int count) {
    return bound_t<W>(count * unit_roundoff<W>);
}

/// A bound, and what the smallest floats lose.
template <class W>
RAIO_FN constexpr bound_t<W> with_lost(const bound_t<W>& error) {
    if constexpr (std::same_as<scalar_t<W>, float>) return error + bound_t<W>(lost<W>);
    return error;
}

/// So many roundings of numbers of this size.
template <class W>
RAIO_FN constexpr bound_t<W> roundings(int count, const bound_t<W>& size) {
    return with_lost<W>(relative<W>(count) * size);
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

    RAIO_FN constexpr bounded_number operator-() const { return {-value, error}; }
};

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

/// The larger of two bounds, and a NaN where one is not known.
template <class E>
RAIO_FN constexpr E larger_bound(const E& a, const E& b) {
    return max(a, b) + (b - b);
}

template <class N>
inline constexpr bool is_proven = false;
template <class W, int K>
inline constexpr bool is_proven<rounded_number<W, K>> = true;
template <class W>
inline constexpr bool is_proven<bounded_number<W>> = true;

}  // namespace detail

/// A number that knows how far off it may be.
template <class N>
concept proven_number = detail::is_proven<N>;

template <proven_number A>
RAIO_FN constexpr auto size_of(const A& a) {
    return abs(bound_t<typename A::number>(a.value));
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

template <proven_number A>
RAIO_FN constexpr auto square(const A& a) {
    return a * a;
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
    mask_t<W> is_apart = size_of(a) > E(detail::lost<W>);
    if constexpr (K > 0) is_apart = every(is_apart, is_finite(a.value));  // or was out of range
    return {select(is_apart, W(1), W(std::numeric_limits<scalar_t<W>>::quiet_NaN())) / select(is_apart, a.value, W(1))};
}

/// The root, and 0 of what is negative: of what should be zero it may be an error.
template <class W>
RAIO_FN constexpr bounded_number<W> sqrt(const bounded_number<W>& a) {
    using E = bound_t<W>;
    W root = sqrt(max(a.value, W(0)));
    // |s - s'| = |a - a'| / (s + s'), and no more than |a - a'|^(1/2).
    E size(root), off = a.error + E(detail::lost<W>), error = quotient(off, size, E(infinity<E>));
    if constexpr (last_precision<W>) error = min(error, sqrt(off));
    return {root, error + detail::roundings<W>(1, size)};
}
/// Half of the roundings, and one; a root of numbers that may have lost digits would not be near it.
template <class W, int K>
RAIO_FN constexpr rounded_number<W, (K + 3) / 2> sqrt(const rounded_number<W, K>& a) {
    if constexpr (K == 0) {
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

// Comparisons. Ties hold where it says >= and <=: edges, rims and tangents belong to their shape since its formula says
// so. A tie of the last precision is what that cannot tell apart; of numbers that are hardly known at all it is no more
// than a 2^30th of them. What is not a number is in doubt, and the last precision says no.

namespace detail {

/// a >= b, or a > b, for which ties do not hold.
template <bool TiesHold, proven_number A, proven_number B>
RAIO_FN constexpr auto is_above(const A& a, const B& b) {
    using W = typename A::number;
    using E = bound_t<W>;
    const bounded_number<W> difference = a - b;
    E off = rounded_up<W>(difference.error) + E(lost<W>), room(0);
    if constexpr (last_precision<W>) room = min(off, E(0x1p-30) * (size_of(a) + size_of(b)));
    const mask_t<W> yes = TiesHold ? difference.value >= -W(room) : difference.value > W(room);
    return verdict<mask_t<W>>{difference.value > W(off), !(difference.value < -W(off)), yes};
}

}  // namespace detail

template <proven_number A, proven_number B>
RAIO_FN constexpr auto operator>=(const A& a, const B& b) {
    return detail::is_above<true>(a, b);
}
template <proven_number A, proven_number B>
RAIO_FN constexpr auto operator<=(const A& a, const B& b) {
    return detail::is_above<true>(b, a);
}
template <proven_number A, proven_number B>
RAIO_FN constexpr auto operator>(const A& a, const B& b) {
    return detail::is_above<false>(a, b);
}
template <proven_number A, proven_number B>
RAIO_FN constexpr auto operator<(const A& a, const B& b) {
    return detail::is_above<false>(b, a);
}

/// Is it above zero? What the last precision knows less than ten digits of is zero to it.
template <class W>
RAIO_FN constexpr verdict<mask_t<W>> is_positive(const bounded_number<W>& a) {
    using E = bound_t<W>;
    constexpr double most = last_precision<W> ? 0x1p32 : 1 + 0x1p-16;
    E off = E(most) * a.error + E(detail::lost<W>);
    return {a.value > W(off), !(a.value < -W(off)), a.value > W(last_precision<W> ? off : E(0))};
}
template <class W, int K>
RAIO_FN constexpr verdict<mask_t<W>> is_positive(const rounded_number<W, K>& a) {
    const W off(K == 0 ? 0.0 : detail::lost<W>);
    const mask_t<W> above = a.value > off;
    return {above, !(a.value <= -off), above};
}

/// One of two. Where it is in doubt which, the other one is covered as well.
template <class W>
RAIO_FN constexpr bounded_number<W> select(const verdict<mask_t<W>>& where, const bounded_number<W>& a,
                                           const bounded_number<W>& b) {
    using E = bound_t<W>;
    W value = select(where.yes, a.value, b.value);
    E chosen = select(where.yes, a.error, b.error), other = select(where.yes, b.error, a.error);
    E both = detail::larger_bound(chosen, other + abs(E(a.value - b.value)));
    return {value, select(mask_t<E>(every(where.possibly, !where.certainly)), both, chosen)};
}

/// The larger of two. The one that was passed over counts as far as its error reaches beyond the other.
template <class W>
RAIO_FN constexpr bounded_number<W> max(const bounded_number<W>& a, const bounded_number<W>& b) {
    using E = bound_t<W>;
    const mask_t<W> second = a.value < b.value;
    E chosen = select(mask_t<E>(second), b.error, a.error), other = select(mask_t<E>(second), a.error, b.error);
    // No more of the distance is taken off than there is.
    E beyond = other - E(1 - 0x1p-16) * abs(E(a.value - b.value));
    return {select(second, b.value, a.value), detail::larger_bound(chosen, beyond)};
}

template <class Mask, proven_number A, proven_number B>
RAIO_FN constexpr auto select(const verdict<Mask>& where, const A& a, const B& b) {
    using bounded = bounded_number<typename A::number>;
    return select(where, bounded(a), bounded(b));
}
template <proven_number A, proven_number B>
RAIO_FN constexpr auto max(const A& a, const B& b) {
    using bounded = bounded_number<typename A::number>;
    return max(bounded(a), bounded(b));
}
template <proven_number A, proven_number B>
RAIO_FN constexpr auto min(const A& a, const B& b) {
    return -max(-a, -b);
}

}  // namespace raio
