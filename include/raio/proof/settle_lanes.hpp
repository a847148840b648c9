#pragma once

#include <raio/push_macros.hpp>

#include <raio/proof/lanes.hpp>
#include <raio/proof/normal.hpp>
#include <raio/proof/window.hpp>

/// \file
/// How packs are settled: in each lane as the plain number there, bit for bit.
///
/// Packs of floats are sieved in their own precision. Its crossings state their errors, so of most lanes it is known
/// whether they are hit, and where about. What is recorded of those that are is found in packs of strict_double, as
/// that of a plain number, operation by operation. Packs of doubles go there at once. Whatever is open after that is
/// asked of the plain shape in its lane.

namespace raio::inline RAIO_ABI {

namespace detail {

/// What a pack knows of a crossing in each lane, or of the first in the window of several: between which numbers the
/// exact t comes to lie once it is rounded to T, and where that is.
template <class T>
struct sifted {
    T low, high;
    mask_t<T> sure, passed;    ///< known to be in the window, or to be before it or not at all
    mask_t<T> open;            ///< may do anything; all others are beyond it
    mask_t<T> at_near{true};   ///< of the two of a chord, is it the near one?
    mask_t<T> in_first{true};  ///< of two chords, is it of the first?
};

/// What packs of floats know of a crossing, or of the first in the window of several.
template <class T, class W>
RAIO_FN sifted<T> rounded(const crossing<W>& c, const T& t_min, const T& t_max) {
    const mask_t<T> certain = c.certain, exists = c.exists;
    if constexpr (is_believed<W>) {
        const T t(c.t);
        const mask_t<T> inside = every(exists, t_min <= t, t <= t_max), beyond = every(exists, t_max < t);
        return {t, t, inside, !some(inside, beyond), false};
    }
    mask_t<T> known = every(certain, exists);
    bound_t<W> error = c.error;
    // The bounds of floats count what is lost near their smallest number. Of doubles only t comes near theirs, or near
    // the largest, where two doubles have no products.
    if constexpr (!std::same_as<scalar_t<W>, float>) {
        error += bound_t<W>(least_normal<W>);
        known = every(known, mask_t<T>(abs(c.t) < W(0.25 * std::numeric_limits<double>::max())));
    }
    const T low(c.t - error), high(c.t + error);
    const mask_t<T> inside = every(known, t_min <= low, high <= t_max), beyond = every(known, t_max < low);
    const mask_t<T> passed = some(every(known, high < t_min), every(certain, !exists));
    return {low, high, inside, passed, !some(inside, beyond, passed)};
}

/// Of two, the first or, where that is passed, the one that comes next.
template <class T>
RAIO_FN sifted<T> or_next(const sifted<T>& a, const sifted<T>& b) {
    const auto either = [&](const mask_t<T>& x, const mask_t<T>& y) { return some(x, every(a.passed, y)); };
    return {select(a.passed, b.low, a.low), select(a.passed, b.high, a.high),
            either(a.sure, b.sure),         every(a.passed, b.passed),
            either(a.open, b.open),         either(every(!a.passed, a.at_near), b.at_near)};
}

/// Of a chord, or of two. (The chord of a tube without caps may have a far end only.)
template <class T, template <class> class Two, class W>
RAIO_FN sifted<T> rounded(const Two<W>& c, const T& t_min, const T& t_max) {
    const auto& [one, next] = c;
    const sifted<T> first = rounded(one, t_min, t_max);
    sifted<T> found = or_next(first, rounded(next, t_min, t_max));
    (std::same_as<Two<W>, chord<W>> ? found.at_near : found.in_first) = !first.passed;
    return found;
}

/// What packs know of the first crossing in the window. Of doubles it is what is recorded.
template <class T, template <class> class Found, class W>
RAIO_FN sifted<T> sift(const Found<W>& found, const T& t_min, const T& t_max) {
    if (missed(found)) return {T(0), T(0), false, true, false};
    if constexpr (keeps_all_digits<T> && !is_believed<W>) {
        auto [first, known] = settled_in_window<question::where>(found, t_min, t_max);
        const T t(first.t);
        return {t, t, every(known, first.exists), false, !known};
    } else {
        return rounded(found, t_min, t_max);
    }
}

/// The crossings that a sieve is sure of, in a wider precision: beyond doubt where they exist.
///
/// Where a formula finds one crossing, its error bound is the roundoff times what is the same in every precision, but
/// for the roundings of the bound itself: that of W is taken from the sieve's, with a factor of 16 to spare, and not
/// reckoned again (high - low is more than the error, whatever their roundings). Where `record_point` would see the
/// difference, the lane is left open.
template <question Asked, class T, class W>
RAIO_FN crossing<W> retrieved(const sifted<T>& found, crossing<W> c, const T&) {
    if constexpr (Asked == question::only_where) {
        c.exists = every(rounds_to_one<T>(c), is_finite(T(c.t)));
    } else {
        constexpr double share = 16 * unit_roundoff<W> / unit_roundoff<T>;
        const T error = (found.high - found.low) * T(share);
        c.error = bound_t<W>(error);
        c.exists = every(found.sure, rounds_to_one<T>(c), error <= least_recorded_error(T(c.t)));
    }
    return c;
}
template <question Asked, class T, class W>
RAIO_FN crossing<W> retrieved(const sifted<T>& found, const chord<W>& c, const T& t_min) {
    crossing<W> one = select(found.at_near, c.near, c.far);
    const T t(one.t), near_high(c.near.t + c.near.error);
    const mask_t<T> same =
        every(found.low <= t, t <= found.high);  // or one precision took another end for the near one
    // The sieve may know better where a ray starts on the surface than one number does, which asks again then.
    const mask_t<T> passed = every(c.near.certain, some(!c.near.exists, near_high < t_min));
    one.exists = every(found.sure, one.exists, one.certain, rounds_to_one<T>(one), same, some(found.at_near, passed));
    return one;
}

/// What packs are asked in first: of floats that is a sieve.
template <class T>
using first_t = std::conditional_t<keeps_all_digits<T>, working_t<T>, T>;

/// Is the formula of the shape one for many lanes at once?
template <class Shape, class T>
concept sifts = requires(const Shape shape, const ray<T> ray, const T t) {
    sift(shape.crossings(line_in<first_t<T>>(ray)), t, t);
};

/// Crossings of packs, with ends of the window that are numbers.
template <question Asked, class Shape, class T>
RAIO_FN auto first_crossings(const Shape& shape, const ray<T>& ray, const T& t_min, const T& t_max) {
    using W = first_t<T>;
    return crossings_for<W, Asked>(shape, ray, W(t_min), W(t_max));
}

/// What packs of floats make of it in their own precision.
template <question Asked, class Shape, class T>
RAIO_FN sifted<T> sieve(const Shape& shape, const ray<T>& ray, const T& t_min, const T& t_max) {
    using found = decltype(first_crossings<Asked>(shape, ray, t_min, t_max));
    if constexpr (Asked == question::only_where && std::same_as<found, crossing<T>>) {
        return {t_min, t_max, true, false, false};
    } else {
        return sift(first_crossings<Asked>(shape, ray, t_min, t_max), t_min, t_max);
    }
}

/// Those that the sieve has found, in the precision of W.
template <class W, class Shape, class T>
RAIO_FN auto crossings_again(const Shape& shape, const ray<T>& ray, const T& t_min, const T& t_max,
                             const sifted<T>& found) {
    if constexpr (requires { shape.crossings(line_in<W>(ray)).second; }) {
        return shape.crossings(line_in<W>(ray), known_chord<mask_t<T>>{found.in_first});
    } else {
        return crossings_for<W, question::only_where>(shape, ray, t_min, t_max);
    }
}

/// An end of a window that may be infinite: what is at infinity is missed.
template <class T>
RAIO_FN T within_numbers(const T& end) {
    const T most(std::numeric_limits<scalar_t<T>>::max());
    return max(min(end, most), -most);
}

}  // namespace detail

/// `occluded` of every shape of packs.
template <detail::has_lanes T, class Shape>
RAIO_FLATTEN RAIO_FN mask_t<T> any_hit(const Shape& shape, const ray<T>& ray, T t_min, T t_max) {
    if constexpr (detail::sifts<Shape, T>) {
        t_min = detail::within_numbers(t_min), t_max = detail::within_numbers(t_max);
        const auto found =
            detail::sift(detail::first_crossings<detail::question::whether>(shape, ray, t_min, t_max), t_min, t_max);
        const std::uint32_t open = bits(found.open);
        if (open == 0) [[likely]]
            return found.sure;
        return some(found.sure, detail::any_hit_in_lanes(shape, ray, t_min, t_max, open));
    } else {
        return detail::any_hit_in_lanes(shape, ray, t_min, t_max);
    }
}

namespace detail {

/// Records what packs know of the lanes' first crossings. Answers which lanes have one, and leaves in `left` those that
/// are open.
template <question Asked, class Shape, class T, record Record>
RAIO_FN mask_t<T> record_known(const Shape& shape, const ray<T>& ray, const T& t_min, const T& t_max, Record& rec,
                               std::uint32_t& left) {
    const T from = within_numbers(t_min), to = within_numbers(t_max);
    if constexpr (keeps_all_digits<T>) {
        const auto found = first_crossings<Asked>(shape, ray, from, to);
        left = 0;
        if (missed(found)) return false;
        auto [first, known] = settled_in_window<Asked>(found, from, to);
        const mask_t<T> met = every(mask_t<T>(known), mask_t<T>(first.exists));
        left = bits(!mask_t<T>(known)) & every_lane<T>;
        if (any(met)) [[likely]]
            record_crossing(shape, ray, first, rec);
        return met;
    } else {
        using W = working_t<T>;
        const sifted<T> found = sieve<Asked>(shape, ray, from, to);
        const std::uint32_t sure = bits(found.sure);
        left = sure | bits(found.open);
        if (sure == 0) [[unlikely]]
            return false;
        keep_as_stored<T>(shape, ray);
        auto first = retrieved<Asked>(found, crossings_again<W>(shape, ray, t_min, t_max, found), t_min);
        const mask_t<T> met = first.exists;
        left &= ~bits(met);
        record_crossing(shape, ray, first, rec);
        return met;
    }
}

}  // namespace detail

/// `hit` of every shape of packs.
/// \tparam Asked  `only_where` if there is a crossing beyond doubt in every lane
template <detail::question Asked = detail::question::where, detail::has_lanes T, class Shape, record Record>
RAIO_FLATTEN RAIO_FN mask_t<T> first_hit(const Shape& shape, const ray<T>& ray, T t_min, T t_max, Record& rec) {
    Record candidate;
    mask_t<T> met(false);
    std::uint32_t left = detail::every_lane<T>;  // who has not been answered
    if constexpr (detail::sifts<Shape, T>) {
        met = detail::record_known<Asked>(shape, ray, t_min, t_max, candidate, left);
        if (left == 0 && none(met)) return false;
    }
    if (left != 0) [[unlikely]] {
        Record of_lanes = candidate;
        met = some(met, detail::first_hit_in_lanes(shape, ray, t_min, t_max, of_lanes, left));
        candidate = of_lanes;
    }
    assign(met, rec, candidate);
    return met;
}

/// Where the lines of packs are inside a convex solid. (There is room for one span in each lane.)
template <class Shape, detail::has_lanes T>
requires requires(const Shape shape, const ray<T> ray) { shape.crossings(line_in<T>(ray)).near; }
RAIO_FN auto inside_of(const Shape& shape, const ray<T>& ray) { return detail::spans_in_lanes(shape, ray); }

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
