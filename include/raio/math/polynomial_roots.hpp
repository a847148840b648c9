#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/depressed_quartic.hpp>
#include <raio/math/root_finder.hpp>

/// \file
/// The roots of a polynomial in an interval, as many of them as are wanted.

namespace raio::inline RAIO_ABI {

/// At most N places, in order.
template <real W, std::size_t N>
struct polynomial_roots {
    std::array<polynomial_root<W>, N> places;  ///< what is beyond `count` has no value
    std::size_t count = 0;
    bool certain = true;  ///< is each of them one simple root, and are they all, whatever the rounding errors were?

    RAIO_FN constexpr const polynomial_root<W>* begin() const { return places.data(); }
    RAIO_FN constexpr const polynomial_root<W>* end() const { return places.data() + count; }
};

/// Which roots are wanted. All of them, unless it is said that only the first beyond some place is. (The last precision
/// finds all the same: it goes one way to each, for what it cannot tell must not depend on what is wanted.)
template <real W>
struct wanted_roots {
    using E = bound_t<W>;

    E before = -infinity<E>;            ///< what is before this need not be found,
    E from = infinity<E>;               ///< nor what comes after the first root beyond this,
    E to = -infinity<E>;                ///< and of that no more than where it is enclosed, if that ends before this
    E last_step{detail::last_step<W>};  ///< a step as short as that, relative to the root, is enough
};

namespace detail {

/// The root, and no more of it than where it is enclosed.
template <real W>
RAIO_FN constexpr polynomial_root<W> somewhere_in(const enclosure<W>& about) {
    using E = bound_t<W>;
    W middle = about.low + (about.high - about.low) * W(0.5);
    return {middle, farthest_from(middle, about.low, about.high), about.sign_before, about.sign_after, E(infinity<E>)};
}

}  // namespace detail

/// The roots in [low, high], which has to be finite. One that is on an end may be found or not, and is not certain.
/// None, and that not certain, for a polynomial that is not finite. Out of line: it is more than what calls it.
template <real W, std::size_t N>
[[gnu::noinline]] RAIO_FN constexpr polynomial_roots<W, N> roots_between(const polynomial<W, N>& p, const W& low,
                                                                         const W& high,
                                                                         const wanted_roots<W>& wanted = {}) {
    using E = bound_t<W>;
    const detail::root_finder<W, N> finder(p, low, high);
    E exact = wanted.last_step, coarse(0x1p-7);
    polynomial_roots<W, N> found;
    found.certain = false;
    if (!finder.is_sound()) return found;
    const auto is_there = [&](const detail::enclosure<W>& about) {
        return E(about.low) > wanted.from && E(about.high) < wanted.to;
    };
    const auto is_enough = [&](const polynomial_root<W>& root) {
        return !last_precision<W> && E(root.t) - root.error > wanted.from;
    };
    if constexpr (N == 4 && !last_precision<W>) {
        const first_root<W> first =
            is_finite(wanted.from) ? depressed_quartic<W>(p, finder.most_noise()).between(low, high) : first_root<W>{};
        found.certain = first.known;
        if (first.known && !first.exists) return found;
        if (first.known && !(E(first.high) < wanted.before)) {
            const detail::enclosure<W> about{first.low, first.high, 1, -1, true};
            found.places[0] =
                is_there(about) ? detail::somewhere_in(about) : finder.approach(about, first.guess, exact);
            found.count = 1;
            if (is_enough(found.places[0])) return found;
        }
    }
    for (const bool in_haste : {true, false}) {
        found.count = 0, found.certain = true;
        const auto take = [&](const detail::enclosure<W>& about, auto approached) {
            if (about.is_one && E(about.high) < wanted.before) return true;
            const polynomial_root<W> root =
                about.is_one && is_there(about) ? detail::somewhere_in(about) : approached();
            found.places[found.count++] = root;
            found.certain = found.certain && about.is_one;
            return about.is_one ? !is_enough(root) : !in_haste;
        };
        finder.find(exact, in_haste ? coarse : exact, take);
        if (found.certain) break;
    }
    return found;
}

/// The same, but none of which all but nothing is known, not to a millionth of the interval: that is where a polynomial
/// is zero, or all but zero, for long. As long as there is a closer look at it, it may be anywhere.
template <real W, std::size_t N>
RAIO_FN constexpr polynomial_roots<W, N> known_roots_between(const polynomial<W, N>& p, const W& low, const W& high) {
    using E = bound_t<W>;
    polynomial_roots<W, N> roots = roots_between(p, low, high);
    if constexpr (!has_closer_look<W> && !is_believed<W>) {
        const std::size_t found = roots.count;
        roots.count = 0;
        for (std::size_t i = 0; i < found; ++i) {
            const bool known = roots.places[i].error <= E(0x1p-20) * E(high - low);
            if (known) roots.places[roots.count++] = roots.places[i];
            roots.certain = roots.certain && known;
        }
    }
    return roots;
}

/// Is a polynomial zero or below at the low end of an interval? The first of its roots there says so, if there is one.
/// Not, if the polynomial is out of range.
template <real W, std::size_t N>
RAIO_FN constexpr bool begins_below_zero(const polynomial<W, N>& p, const polynomial_roots<W, N>& roots, const W& low,
                                         const W& high) {
    using E = bound_t<W>;
    if (!is_finite(p.noise()(max(E(abs(low)), E(abs(high)))))) return false;
    return roots.count == 0 ? p(low) <= W(0) : roots.begin()->sign_before <= 0;
}

/// From one place to another. What is not known of an end counts: the stretch is as long as it may be.
template <real W>
struct stretch {
    bounded_number<W> from, to;

    /// Can its ends not be told apart?
    RAIO_FN constexpr bool may_be_point() const {
        return bound_t<W>(to.value - from.value) <= max(from.error, to.error);
    }
    /// The place of that point: the end that is known best. An end of the interval is known exactly.
    RAIO_FN constexpr bounded_number<W> point() const {
        const W length = to.value - from.value, middle = from.value + length * W(0.5);
        const W best = from.error < to.error ? from.value : to.error < from.error ? to.value : middle;
        return {best, bound_t<W>(length)};
    }
};

/// Where a polynomial is not above zero, in an interval.
template <real W, std::size_t N>
struct stretches {
    std::array<stretch<W>, N + 1> places{};  ///< what is beyond `count` has no value
    std::size_t count = 0;
    bool certain = true;  ///< are these all, and is each of them one, whatever the rounding errors were?

    RAIO_FN constexpr const stretch<W>* begin() const { return places.data(); }
    RAIO_FN constexpr const stretch<W>* end() const { return places.data() + count; }
};

template <real W, std::size_t N>
RAIO_FN constexpr stretches<W, N> stretches_below_zero(const polynomial<W, N>& p, const W& low, const W& high) {
    using E = bound_t<W>;
    const polynomial_roots<W, N> roots = roots_between(p, low, high);
    stretches<W, N> found;
    found.certain = roots.certain;
    bool within = begins_below_zero(p, roots, low, high);
    const auto add = [&](const bounded_number<W>& from, const bounded_number<W>& to) {
        found.places[found.count++] = {from, to};
    };
    bounded_number<W> from(low, E(0));
    for (const polynomial_root<W>& root : roots) {
        const bool goes_on = root.sign_after <= 0;
        if (!within) from = {max(low, root.t - W(root.error)), E(2) * root.error};
        if (!goes_on) add(from, {min(high, root.t + W(root.error)), E(2) * root.error});
        within = goes_on;
    }
    if (within) add(from, {high, E(0)});
    return found;
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
