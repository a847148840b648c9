#pragma once

#include <raio/push_macros.hpp>

#include <raio/number/bounded_number.hpp>
#include <raio/number/verdict.hpp>

/// \file
/// Comparisons of numbers that know how far off they may be.
///
/// Ties hold where it says >= and <=: edges, rims and tangents belong to their shape since its formula says
/// so. A tie of the last precision is what that cannot tell apart; of numbers that are hardly known at all it is no
/// more than a 2^30th of them. What is not a number is in doubt, and the last precision says no.

namespace raio::inline RAIO_ABI {

namespace detail {

/// How far from zero a number has to be for its sign to be known; one that is believed has its sign.
template <class W>
RAIO_FN constexpr bound_t<W> doubt_of(const bounded_number<W>& a) {
    if constexpr (is_believed<W>) return bound_t<W>(0);
    return rounded_up<W>(a.error);
}

/// Is there no doubt, if this holds? What a number that is believed has found leaves none.
template <class W>
RAIO_FN constexpr mask_t<W> beyond_doubt(const mask_t<W>& holds) {
    if constexpr (is_believed<W>) return mask_t<W>(true);
    return holds;
}

/// A verdict, of which a number that is believed has no doubt.
template <class W>
RAIO_FN constexpr verdict<mask_t<W>> decided(const mask_t<W>& certainly, const mask_t<W>& possibly,
                                             const mask_t<W>& yes) {
    if constexpr (is_believed<W>) return {yes, yes, yes};
    return {certainly, possibly, yes};
}

/// a >= b, or a > b, for which ties do not hold.
template <bool TiesHold, proven_number A, proven_number B>
RAIO_FN constexpr auto is_above(const A& a, const B& b) {
    using W = typename A::number;
    using E = bound_t<W>;
    const bounded_number<W> difference = a - b;
    E off = limit_of(difference), room(0);
    if constexpr (last_precision<W>) room = min(off, E(0x1p-30) * (size_of(a) + size_of(b)));
    const mask_t<W> yes = TiesHold ? difference.value >= -W(room) : difference.value > W(room);
    return decided<W>(difference.value > W(off), !(difference.value < -W(off)), yes);
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
    return detail::decided<W>(a.value > W(off), !(a.value < -W(off)), a.value > W(last_precision<W> ? off : E(0)));
}
template <class W, int K>
RAIO_FN constexpr verdict<mask_t<W>> is_positive(const rounded_number<W, K>& a) {
    const W off(K == 0 ? 0.0 : detail::lost<W>);
    const mask_t<W> above = a.value > off;
    return detail::decided<W>(above, !(a.value <= -off), above);
}

/// Is it not below zero? What cannot be told from zero is a tie, and holds.
template <class W>
RAIO_FN constexpr verdict<mask_t<W>> is_not_negative(const bounded_number<W>& a) {
    W off(detail::limit_of(a));
    const mask_t<W> yes = last_precision<W> ? every(a.value >= -off, is_finite(off)) : a.value >= W(0);
    return detail::decided<W>(a.value > off, !(a.value < -off), yes);
}

/// Is it anything but zero? What the last precision cannot tell from zero is zero to it.
template <class W>
RAIO_FN constexpr verdict<mask_t<W>> is_not_zero(const bounded_number<W>& a) {
    using E = bound_t<W>;
    E size = size_of(a), off = detail::rounded_up<W>(a.error) + E(detail::lost<W>);
    const mask_t<W> is_known = size > off, yes = size > E(0);
    return detail::decided<W>(is_known, some(yes, off > E(0)), last_precision<W> ? is_known : yes);
}

/// Is it not below zero, is it not above? What cannot be told from zero is a tie, and holds, if it is no more than a
/// 2^30th of `whole`, whose part it is.
template <class W>
RAIO_FN constexpr verdict<mask_t<W>> is_not_negative(const bounded_number<W>& a, const bounded_number<W>& whole) {
    using E = bound_t<W>;
    E off = detail::rounded_up<W>(a.error) + E(detail::lost<W>), room(0);
    if constexpr (last_precision<W>) room = min(off, E(0x1p-30) * size_of(whole));
    return detail::decided<W>(a.value > W(off), !(a.value < -W(off)), a.value >= -W(room));
}
template <class W>
RAIO_FN constexpr verdict<mask_t<W>> is_not_positive(const bounded_number<W>& a, const bounded_number<W>& whole) {
    using E = bound_t<W>;
    E off = detail::rounded_up<W>(a.error) + E(detail::lost<W>), room(0);
    if constexpr (last_precision<W>) room = min(off, E(0x1p-30) * size_of(whole));
    return detail::decided<W>(a.value < -W(off), !(a.value > W(off)), a.value <= W(room));
}

/// Can a root, whose square is given, be told from the error of b? The last precision knows b to 2^-104 of it: of a
/// root below 2^-89 of b, the square of that error is more than 2^-30, and the root counts as zero. The first
/// precision leaves that to the last.
template <proven_number A, class W>
RAIO_FN constexpr verdict<mask_t<W>> is_root_told_from_zero(const A& square_of_root, const bounded_number<W>& b) {
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

/// What is made of a verdict: as long as there is a closer look at it, what is in doubt may hold.
template <class W>
RAIO_FN constexpr mask_t<W> answer_of(const verdict<mask_t<W>>& a) {
    return has_closer_look<W> ? a.possibly : a.yes;
}

/// Is it beyond doubt that something is to be found there, or nowhere?
template <class W>
RAIO_FN constexpr mask_t<W> is_settled_at(const verdict<mask_t<W>>& exists, const bounded_number<W>& there) {
    return detail::beyond_doubt<W>(some(every(exists.certainly, mask_t<W>(is_finite(there.error))), !exists.possibly));
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

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
