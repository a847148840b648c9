#pragma once

#include <raio/push_macros.hpp>

#include <raio/proof/chord.hpp>

/// \file
/// Where a line is inside a solid whose function is of the second degree along it, a t^2 - 2 b t + c: in all cases.

namespace raio::inline RAIO_ABI {

/// Where a line is inside a solid: between two ends or, where that is hollow, before and after them.
template <class W>
struct hollow_chord {
    chord<W> ends;
    mask_t<W> hollow;
};

/// Is a t^2 - 2 b t + c above zero everywhere, beyond doubt?
/// \param square  b^2 - a c
template <class W>
RAIO_FN constexpr mask_t<W> is_above_zero(const bounded_number<W>& a, const bounded_number<W>& square) {
    return every(a.value > W(bound_t<W>(2) * a.error), square.value < -W(detail::doubt_of(square)));
}

/// Where a t^2 - 2 b t + c is zero or below.
///
/// \param square    b^2 - a c, found without that difference, which may cancel
/// \param sound     is there a solid at all?
/// \param on_axis   is `square` known not to be below zero where a is?
/// \param constant  says c, and
/// \param extent    how far from t = 0 there is something that counts: hardly a line asks for these two
template <class W, class Constant, class Extent>
RAIO_FN constexpr hollow_chord<W> where_below_zero(const bounded_number<W>& a, const bounded_number<W>& b,
                                                   bounded_number<W> square, const verdict<mask_t<W>>& sound,
                                                   const mask_t<W>& on_axis, Constant constant, Extent extent) {
    using E = bound_t<W>;
    const mask_t<W> passes = is_above_zero(a, square);
    bounded_number<W> c(W(0), E(0));
    if constexpr (last_precision<W>) {
        // Of a line that all but lies in the surface a, b and c are tiny, and tell more than their difference at large.
        c = constant();
        const bounded_number<W> direct = raio::square(b) - a * c;
        if (direct.error < square.error) square = direct;
    }
    const bounded_number<W> root = sqrt(square);
    const E square_error = detail::doubt_of(square);
    // With the signs of all three turned where a is below zero, near is the lower root.
    const auto turned = [&](const bounded_number<W>& x) { return bounded_number<W>(flip(x.value, a.value), x.error); };
    auto [near, far] = quadratic_roots(abs(a), turned(b), turned(c), root);

    const mask_t<W> curved = size_of(a) > E(16) * a.error, below = a.value < W(0);
    const mask_t<W> meets = square.value > W(square_error), apart = square.value < -W(square_error);
    const mask_t<W> two = every(curved, meets, is_finite(size_of(b) + size_of(square)));
    mask_t<W> exists = two, certain = some(two, passes), hollow = every(two, below);
    if (!all(certain)) {
        if constexpr (!last_precision<W>) c = constant();
        // One of the two roots cancels if the equation is as good as linear, and the other one is out of reach.
        const E reach = E(2) * extent(), a_most = size_of(a) + a.error;
        const bounded_number<W> sum = b + bounded_number<W>(copysign(root.value, b.value), root.error);
        const W only = quotient(c.value, sum.value, W(0));
        const E of_one = E(2) * quotient(c.error + abs(E(only)) * sum.error, size_of(sum), E(0)) +
                         detail::roundings<W>(3, abs(E(only)));
        const mask_t<W> linear = every(!two, size_of(sum) - sum.error > E(2) * reach * a_most);

        // Where the function does not change its sign, the line is inside everywhere or nowhere; where nothing of it
        // can be told from zero, it lies in the surface.
        const E change = c.error + reach * (a_most * reach + E(2) * (size_of(b) + b.error));
        const mask_t<W> steady = size_of(c) > change, touches = square.value >= -W(tie<W>(square_error));
        const mask_t<W> blind =
            some(size_of(a) <= E(2) * a.error, every(!apart, !(max(near.error, far.error) < reach)));
        const mask_t<W> level = every(!two, some(steady, every(!linear, blind)));
        const mask_t<W> steep = every(!two, !level, !linear, below);
        const mask_t<W> parts = every(steep, some(on_axis, touches));
        hollow = some(hollow, parts);

        const mask_t<W> finite = is_finite(size_of(a) + size_of(b) + size_of(c) + size_of(square));
        const mask_t<W> bent = every(!two, !level, some(linear, steep, touches));
        exists = every(finite, !passes, some(two, every(level, c.value <= W(tie<W>(change))), bent));
        const mask_t<W> one_is_known = every(linear, meets, size_of(sum) > E(2) * sum.error);
        const mask_t<W> two_are_known = every(!linear, !blind, some(meets, apart, every(steep, on_axis)));
        certain = some(passes, every(finite, some(two, steady, one_is_known, two_are_known)));

        // Inside on one side of the one root, or everywhere, is as far as there is something that counts.
        const mask_t<W> rising = sum.value > W(0);
        const W end(reach), first = select(rising, only, min(-end, only)), last = select(rising, max(end, only), only);
        near = {select(linear, first, near.value), select(linear, of_one, near.error)};
        far = {select(linear, last, far.value), select(linear, of_one, far.error)};
        const mask_t<W> everywhere = some(level, every(steep, !parts));
        near = {select(everywhere, -end, near.value), select(everywhere, E(0), near.error)};
        far = {select(everywhere, end, far.value), select(everywhere, E(0), far.error)};
    }
    if constexpr (!last_precision<W>) far.error = near.error;  // as it is: what comes next need not be done twice
    exists = every(exists, answer_of<W>(sound));
    certain = every(certain, some(sound.certainly, !sound.possibly, passes));
    return {{{exists, certain, near.value, near.error, !hollow}, {exists, certain, far.value, far.error, hollow}},
            hollow};
}

/// Counts t from elsewhere on the line: t = 0 was at that place, and t was counted in that unit. (The error of t is at
/// least a rounding of t: there is room for those here.)
/// \param at_origin  says what is zero if the line's own origin lies on the surface
template <class W, class AtOrigin>
RAIO_FN constexpr void move_on(hollow_chord<W>& c, const bounded_number<W>& place,
                               [[maybe_unused]] AtOrigin at_origin) {
    using E = bound_t<W>;
    const E off = place.error + detail::roundings<W>(1, size_of(place));
    for (crossing<W>* end : {&c.ends.near, &c.ends.far}) {
        end->t = end->t + place.value, end->error = detail::rounded_up<W>(end->error + off);
    }
    if constexpr (!only_sieves<W>) {
        start_on_surface(c.ends, [&] {
            const bounded_number<W> zero = at_origin();
            return size_of(zero) <= detail::rounded_up<W>(zero.error);
        });
    }
}
template <class W, class AtOrigin>
RAIO_FN constexpr void move_on(hollow_chord<W>& c, const given_number<W>& place, const given_number<W>& unit,
                               AtOrigin at_origin) {
    using E = bound_t<W>;
    for (crossing<W>* end : {&c.ends.near, &c.ends.far}) {
        end->t = end->t * unit.value, end->error = with_underflow<W>(E(2) * end->error * E(unit.value));
    }
    move_on(c, bounded_number<W>(place), at_origin);
}

/// Where a line is inside both a solid that may be hollow and a convex one.
template <class W, class Wanted>
RAIO_FN constexpr auto intersect(const hollow_chord<W>& c, const chord<W>& convex, const Wanted& wanted) {
    using E = bound_t<W>;
    const mask_t<W> yes = W(0) == W(0), exists = c.ends.near.exists, certain = c.ends.near.certain;
    // Where the solid is hollow, the line is inside until the near end, and from the far one on.
    W near = c.ends.near.t, far = c.ends.far.t, end = infinity<W>;
    E near_error = c.ends.near.error, far_error = c.ends.far.error;
    W begins = select(c.hollow, -end, near), leaves = select(c.hollow, near, far);
    E leaves_error = select(c.hollow, near_error, far_error);
    const auto part = [&](const mask_t<W>& is_there, const mask_t<W>& is_known, const W& from, const E& from_error,
                          const W& to, const E& to_error) {
        return intersect(
            chord<W>{{is_there, is_known, from, from_error, yes}, {is_there, is_known, to, to_error, !yes}}, convex);
    };
    if constexpr (requires { wanted.is_first; }) {
        const mask_t<W> is_first = wanted.is_first;
        begins = select(is_first, begins, far), leaves = select(is_first, leaves, end);
        near_error = select(is_first, near_error, far_error);
        return part(exists, certain, begins, near_error, leaves, leaves_error);
    } else {
        if constexpr (std::same_as<mask_t<W>, bool>) {  // of many lanes some are hollow
            if (!c.hollow) return chord_pair<W>{intersect(c.ends, convex), nowhere<W>(yes)};
        }
        return chord_pair<W>{part(exists, certain, begins, near_error, leaves, leaves_error),
                             part(every(c.hollow, exists), some(!c.hollow, certain), far, far_error, end, far_error)};
    }
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
