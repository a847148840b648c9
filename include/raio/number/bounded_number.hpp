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

/// Zero, as a type: what a formula has of it is not computed.
template <class W>
struct zero_number {
    using number = W;

    RAIO_FN constexpr zero_number operator-() const { return {}; }
};

namespace detail {

/// What the smallest numbers lose of their digits is less than this: of products of floats in float, of doubles.
template <class W>
inline constexpr double lost = std::same_as<scalar_t<W>, float> ? 0x1p-100 : 0x1p-960;

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

namespace detail {

/// A bound of errors, rounded up: itself the result of no more than a hundred roundings.
template <class W>
RAIO_FN constexpr bound_t<W> rounded_up(const bound_t<W>& error) {
    return error * bound_t<W>(1 + 0x1p-16);
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

template <class W>
RAIO_FN constexpr bounded_number<W> operator+(const bounded_number<W>& a, const bounded_number<W>& b) {
    W sum = a.value + b.value;
    return {sum, a.error + b.error + detail::roundings<W>(1, abs(bound_t<W>(sum)))};
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

template <proven_number A>
RAIO_FN constexpr auto square(const A& a) {
    return a * a;
}
template <class W>
RAIO_FN constexpr bounded_number<W> square(const bounded_number<W>& a) {
    W product = a.value * a.value;
    return {product, a.error * (size_of(a) + size_of(a) + a.error) + detail::roundings<W>(1, bound_t<W>(product))};
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
    const mask_t<W> is_apart = size_of(a) > E(detail::lost<W>);
    return {select(is_apart, W(1), W(std::numeric_limits<scalar_t<W>>::quiet_NaN())) / select(is_apart, a.value, W(1))};
}

/// The root, and 0 of what is negative: of what should be zero it may be an error.
template <class W>
RAIO_FN constexpr bounded_number<W> sqrt(const bounded_number<W>& a) {
    using E = bound_t<W>;
    W root = sqrt(max(a.value, W(0)));
    // |s - s'| = |a - a'| / (s + s'), and no more than |a - a'|^(1/2).
    E size(root), error = quotient(a.error, size, E(infinity<E>));
    if constexpr (!has_closer_look<W>) error = min(error, sqrt(a.error));
    return {root, error + detail::roundings<W>(1, size)};
}
template <class W, int K>
RAIO_FN constexpr rounded_number<W, K / 2 + 2> sqrt(const rounded_number<W, K>& a) {
    return {sqrt(a.value)};
}

template <proven_number A>
RAIO_FN constexpr A abs(const A& a) {
    A size = a;
    size.value = abs(a.value);
    return size;
}

// Comparisons. Ties hold where it says >= and <=: edges, rims and tangents belong to their shape since its formula says
// so. A tie of the last precision is what that cannot tell apart; of numbers that are hardly known at all it is no more
// than a 2^30th of them.
template <proven_number A, proven_number B>
RAIO_FN constexpr auto operator>=(const A& a, const B& b) {
    using W = typename A::number;
    using E = bound_t<W>;
    const bounded_number<W> difference = a - b;
    E off = detail::rounded_up<W>(difference.error) + E(detail::lost<W>), room(0);
    if constexpr (last_precision<W>) room = min(off, E(0x1p-30) * (size_of(a) + size_of(b)));
    return verdict<mask_t<W>>{difference.value > W(off), !(difference.value < -W(off)), difference.value >= -W(room)};
}
template <proven_number A, proven_number B>
RAIO_FN constexpr auto operator<=(const A& a, const B& b) {
    return b >= a;
}
template <proven_number A, proven_number B>
RAIO_FN constexpr auto operator<(const A& a, const B& b) {
    return !(a >= b);
}
template <proven_number A, proven_number B>
RAIO_FN constexpr auto operator>(const A& a, const B& b) {
    return !(b >= a);
}

/// Is it above zero? What the last precision knows less than ten digits of is zero to it.
template <class W>
RAIO_FN constexpr verdict<mask_t<W>> is_positive(const bounded_number<W>& a) {
    using E = bound_t<W>;
    constexpr double most = last_precision<W> ? 0x1p32 : 1 + 0x1p-16;
    E off = E(most) * a.error + E(detail::lost<W>);
    return {a.value > W(off), !(a.value <= -W(off)), a.value > W(last_precision<W> ? off : E(0))};
}
template <class W, int K>
RAIO_FN constexpr verdict<mask_t<W>> is_positive(const rounded_number<W, K>& a) {
    const W off(K == 0 ? 0.0 : detail::lost<W>);
    const mask_t<W> above = a.value > off;
    return {above, K == 0 ? above : !(a.value <= -off), above};
}

template <class W>
RAIO_FN constexpr verdict<mask_t<W>> is_positive(const zero_number<W>&) {
    const mask_t<W> no = W(0) != W(0);
    return {no, no, no};
}

template <class W>
RAIO_FN constexpr bounded_number<W> select(const verdict<mask_t<W>>& where, const bounded_number<W>& a,
                                           const bounded_number<W>& b) {
    using E = bound_t<W>;
    W value = select(where.yes, a.value, b.value);
    E chosen = select(where.yes, a.error, b.error), other = select(where.yes, b.error, a.error);
    // Where that is in doubt, the other one is covered as well.
    E both = max(chosen, other + abs(E(a.value - b.value)));
    return {value, select(mask_t<E>(every(where.possibly, !where.certainly)), both, chosen)};
}

/// The larger of two. The one that was passed over counts as far as its error reaches beyond the other.
template <class W>
RAIO_FN constexpr bounded_number<W> max(const bounded_number<W>& a, const bounded_number<W>& b) {
    using E = bound_t<W>;
    W value = max(a.value, b.value);
    return {value, max(E(0), max(a.error - E(value - a.value), b.error - E(value - b.value)))};
}
template <class W>
RAIO_FN constexpr bounded_number<W> min(const bounded_number<W>& a, const bounded_number<W>& b) {
    return -max(-a, -b);
}

}  // namespace raio
