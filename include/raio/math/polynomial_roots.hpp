#pragma once

#include <raio/math/depressed_quartic.hpp>
#include <raio/math/root_finder.hpp>

/// \file
/// The roots of a polynomial in an interval, as many of them as are wanted.

namespace raio {

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
    return {middle, farthest_from(middle, about.low, about.high), about.before, about.after, E(infinity<E>)};
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

}  // namespace raio
