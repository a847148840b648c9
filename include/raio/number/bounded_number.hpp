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
    if constexpr (!has_closer_look<W>) error = min(error, sqrt(off));
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
    E off = limit_of(difference), room(0);
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

/// Can they not be told apart?
template <proven_number A, proven_number B>
RAIO_FN constexpr auto may_be_equal(const A& a, const B& b) {
    using W = typename A::number;
    const bounded_number<W> difference = a - b;
    return size_of(difference) <= detail::rounded_up<W>(difference.error) + bound_t<W>(detail::lost<W>);
}

/// Is the first known at least as well as the second?
template <class W>
RAIO_FN constexpr mask_t<bound_t<W>> is_better_known(const bounded_number<W>& a, const bounded_number<W>& b) {
    return !(b.error < a.error);  // nor is the second known at all where its bound is no number
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

/// Is it not below zero? What cannot be told from zero is a tie, and holds.
template <class W>
RAIO_FN constexpr verdict<mask_t<W>> is_not_negative(const bounded_number<W>& a) {
    W off(detail::limit_of(a));
    const mask_t<W> yes = last_precision<W> ? every(a.value >= -off, is_finite(off)) : a.value >= W(0);
    return {a.value > off, !(a.value < -off), yes};
}

/// Is it anything but zero? What the last precision cannot tell from zero is zero to it.
template <class W>
RAIO_FN constexpr verdict<mask_t<W>> is_not_zero(const bounded_number<W>& a) {
    using E = bound_t<W>;
    E size = size_of(a), off = detail::rounded_up<W>(a.error) + E(detail::lost<W>);
    const mask_t<W> is_known = size > off, yes = size > E(0);
    return {is_known, some(yes, off > E(0)), last_precision<W> ? is_known : yes};
}

/// Is it not below zero, is it not above? What cannot be told from zero is a tie, and holds, if it is no more than a
/// 2^30th of `whole`, whose part it is.
template <class W>
RAIO_FN constexpr verdict<mask_t<W>> is_not_negative(const bounded_number<W>& a, const bounded_number<W>& whole) {
    using E = bound_t<W>;
    E off = detail::rounded_up<W>(a.error) + E(detail::lost<W>), room(0);
    if constexpr (last_precision<W>) room = min(off, E(0x1p-30) * size_of(whole));
    return {a.value > W(off), !(a.value < -W(off)), a.value >= -W(room)};
}
template <class W>
RAIO_FN constexpr verdict<mask_t<W>> is_not_positive(const bounded_number<W>& a, const bounded_number<W>& whole) {
    using E = bound_t<W>;
    E off = detail::rounded_up<W>(a.error) + E(detail::lost<W>), room(0);
    if constexpr (last_precision<W>) room = min(off, E(0x1p-30) * size_of(whole));
    return {a.value < -W(off), !(a.value > W(off)), a.value <= W(room)};
}

/// A number that is found in two ways: the last precision takes the one that it knows better. Others are content with
/// the first.
template <class W, class Find>
RAIO_FN constexpr bounded_number<W> closer(const bounded_number<W>& a, [[maybe_unused]] Find find_again) {
    if constexpr (last_precision<W>) {
        const bounded_number<W> b = find_again();
        return select(b.error < a.error, b, a);
    }
    return a;
}

/// a, or -a where `sign` is negative. Where that is in doubt, both are covered.
template <class W>
RAIO_FN constexpr bounded_number<W> flip(const bounded_number<W>& a, const bounded_number<W>& sign) {
    using E = bound_t<W>;
    const mask_t<E> is_known = size_of(sign) > detail::rounded_up<W>(sign.error) + E(detail::lost<W>);
    return {flip(a.value, sign.value), select(is_known, a.error, a.error + E(2) * size_of(a))};
}

namespace detail {

/// The larger of two bounds, and a NaN where one is not known.
template <class E>
RAIO_FN constexpr E larger_bound(const E& a, const E& b) {
    return select(mask_t<E>(b == b), max(a, b), b);
}

}  // namespace detail

/// Is the root of a square above zero beside b, which its error comes from? What the last precision knows less than
/// ten digits of is zero to it; who has a closer look leaves that to it.
template <class W, int K>
RAIO_FN constexpr verdict<mask_t<W>> is_root_told_from_zero(const rounded_number<W, K>& square_of_root,
                                                            const bounded_number<W>& b) {
    if constexpr (last_precision<W>) {
        return square_of_root >= square(b * given_number<W>{W(0x1p-89)});
    } else {
        return {true, true, true};
    }
}

template <class W>
RAIO_FN constexpr verdict<mask_t<W>> is_positive(const zero_number<W>&) {
    const mask_t<W> no = W(0) != W(0);
    return {no, no, no};
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

/// What is made of a verdict: as long as there is a closer look at it, what is in doubt may hold.
template <class W>
RAIO_FN constexpr mask_t<W> answer_of(const verdict<mask_t<W>>& a) {
    return has_closer_look<W> ? a.possibly : a.yes;
}

/// One of two numbers, in each lane that which is known to be meant.
template <class W>
RAIO_FN constexpr bounded_number<W> choose_where(const mask_t<W>& where, const bounded_number<W>& a,
                                                 const bounded_number<W>& b) {
    return {select(where, a.value, b.value), select(mask_t<bound_t<W>>(where), a.error, b.error)};
}

/// Is it beyond doubt that something is to be found there, or nowhere?
template <class W>
RAIO_FN constexpr mask_t<W> is_settled_at(const verdict<mask_t<W>>& exists, const bounded_number<W>& there) {
    return some(every(exists.certainly, mask_t<W>(is_finite(there.error))), !exists.possibly);
}

/// The same of something that is to be found there: to the last precision what is infinitely far off does not exist.
template <class W>
RAIO_FN constexpr mask_t<W> answer_of(const verdict<mask_t<W>>& exists, const bounded_number<W>& there) {
    if constexpr (last_precision<W>) {
        return every(exists.yes, is_finite(there.error));
    } else {
        return answer_of<W>(exists);
    }
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
template <class W>
RAIO_FN constexpr bounded_number<W> min(const bounded_number<W>& a, const bounded_number<W>& b) {
    return -max(-a, -b);
}

/// A number that is known to lie between these two, if there is one.
template <class W>
RAIO_FN constexpr bounded_number<W> held_between(const bounded_number<W>& a, const W& low, const W& high) {
    using E = bound_t<W>;
    // What is not a number becomes `high`.
    return {max(low, min(high, a.value)), min(E(high - low), a.error)};
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
