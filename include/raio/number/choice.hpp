#pragma once

#include <raio/push_macros.hpp>

#include <raio/number/comparison.hpp>

/// \file
/// One of several numbers that know how far off they may be. Where it is in doubt which, all are covered.

namespace raio::inline RAIO_ABI {

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

/// One of two numbers, in each lane that which is known to be meant.
template <class W>
RAIO_FN constexpr bounded_number<W> choose_where(const mask_t<W>& where, const bounded_number<W>& a,
                                                 const bounded_number<W>& b) {
    return {select(where, a.value, b.value), select(mask_t<bound_t<W>>(where), a.error, b.error)};
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

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
