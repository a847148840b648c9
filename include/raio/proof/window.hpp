#pragma once

#include <raio/push_macros.hpp>

#include <raio/proof/chord.hpp>
#include <raio/proof/line.hpp>

/// \file
/// Which crossings count: those with t in the closed window [t_min, t_max] that is asked for.

namespace raio::inline RAIO_ABI::detail {

/// An end of a window of T, so far out that no exact t from beyond is rounded into the window.
/// \param sign  -1 for the lower end, 1 for the upper one
template <class W, real T>
RAIO_FN constexpr W widened(const T& end, double sign) {
    if (!is_finite(end)) return W(end);
    return W(end) + W(sign) * (abs(W(end)) * W(2 * unit_roundoff<T>) + W(least_normal<T>));
}

/// Is the crossing in [t_min, t_max], once it is rounded to T?
template <real T, class W>
RAIO_FN constexpr mask_t<T> in_window(const crossing<W>& c, T t_min, T t_max) {
    const T t = T(c.t);
    return every(c.exists, t_min <= t, t <= t_max, is_finite(t));
}

/// The first crossing in the window as W finds it; `exists` says whether there is one.
template <real T, class W>
RAIO_FN constexpr crossing<W> first_in_window(crossing<W> c, T t_min, T t_max) {
    c.exists = in_window(c, t_min, t_max);
    return c;
}
/// Of two crossings, those of a chord, or of two chords.
template <real T, template <class> class Two, class W>
RAIO_FN constexpr crossing<W> first_in_window(const Two<W>& c, T t_min, T t_max) {
    const auto& [one, next] = c;
    crossing<W> first = first_in_window(one, t_min, t_max);
    return select(first.exists, first, first_in_window(next, t_min, t_max));
}

/// What is asked of the first crossing: only whether there is one, or also where; or only where, if there is one beyond
/// doubt.
enum class question { whether, where, only_where };

/// A shape that has less to do for a crossing that is known to exist, and to be wanted.
template <class Shape, class W, class Ray>
concept finds_known_crossing = requires(const Shape& shape, const Ray& ray) {
    { shape.crossings(line_in<W>(ray), known_crossing{}) } -> std::same_as<crossing<W>>;
};

/// Has T the digits of the precision that its formulas are tried in first? Then t is recorded as they find it there.
/// Any other T is rounded to from more digits, and correctly.
template <class T>
inline constexpr bool keeps_all_digits = unit_roundoff<T> <= unit_roundoff<working_t<T>>;

/// May a shape that searches find what is wanted, and no more? Where T keeps all digits the last of them depend on how
/// it is found, and the place in the list says which one it is: so all are found alike. (Packs do not search.)
template <class W, class T>
inline constexpr bool finds_no_more = is_believed<W> || !keeps_all_digits<T> || !std::same_as<mask_t<T>, bool>;

/// The crossings of a shape; of one that can find less with less work only what the question wants to know.
template <class W, question Asked, class Shape, class Ray, real T>
RAIO_FORMULA constexpr auto crossings_for(const Shape& shape, const Ray& ray, T t_min, T t_max) {
    if constexpr (Asked == question::only_where && finds_known_crossing<Shape, W, Ray>) {
        return shape.crossings(line_in<W>(ray), known_crossing{});
    } else if constexpr (finds_no_more<W, T> && requires { shape.crossings(line_in<W>(ray), first_from<T>{}); }) {
        return shape.crossings(line_in<W>(ray), first_from<T>{t_min, t_max, Asked == question::whether});
    } else {
        return shape.crossings(line_in<W>(ray));
    }
}

/// The first crossing that may be in the window as W finds it, and whether that settles it: is it known which one it
/// is and, if t is asked for, what t is recorded?
template <class W>
struct finding {
    crossing<W> first;
    mask_t<W> known;
};

/// Is t certain to the last bit of T: do both ends of its error round to the same?
template <real T, class W>
RAIO_FN constexpr mask_t<T> rounds_to_one(const crossing<W>& c) {
    return T(sum_as<W>(-c.error, c.t)) == T(sum_as<W>(c.error, c.t));
}

/// Is t beyond doubt on one side of 0, or at 0?
template <class W>
RAIO_FN constexpr mask_t<W> has_known_sign(const crossing<W>& c) {
    using E = bound_t<W>;
    E size = abs(E(c.t));
    return some(size > c.error, every(size == E(0), c.error == E(0)));
}

/// Of a crossing that exists: is T(c.t) recorded of it? If T keeps all digits, that is what the formula finds, where
/// there is no doubt which face it is and on which side of the origin.
template <real T, class W>
RAIO_FN constexpr mask_t<T> is_recorded(const crossing<W>& c) {
    if constexpr (keeps_all_digits<T>) {
        return every(mask_t<T>(!c.shared), mask_t<T>(is_finite(c.t)), mask_t<T>(has_known_sign(c)));
    } else {
        return every(rounds_to_one<T>(c), is_finite(T(c.t)));
    }
}

/// Is it beyond doubt whether the crossing exists and, if it does, what t is recorded of it? That does not depend on a
/// window, so t does not either.
template <real T, class W>
RAIO_FN constexpr mask_t<T> is_known(const crossing<W>& c) {
    return every(mask_t<T>(c.certain), some(mask_t<T>(!c.exists), is_recorded<T>(c)));
}

template <question Asked, real T, class W>
RAIO_FN constexpr finding<W> settled_in_window(crossing<W> c, T t_min, T t_max) {
    if constexpr (Asked == question::only_where) {
        c.exists = W(0) == W(0);
        return {c, is_recorded<T>(c)};
    }
    if constexpr (keeps_all_digits<T>) {
        mask_t<W> known = is_known<T>(c);
        if (!all(known)) {  // what is beyond the window, beyond doubt, need not be known any better
            const mask_t<T> beyond = some(T(c.t + c.error) < t_min, t_max < T(c.t - c.error));
            known = some(known, every(c.certain, is_finite(c.t), mask_t<W>(beyond)));
        }
        c.exists = every(c.exists, mask_t<W>(t_min <= T(c.t)), mask_t<W>(T(c.t) <= t_max));
        return {c, known};
    } else {
        if (none(c.exists)) return {c, c.certain};
        const T low = T(c.t - c.error), high = T(c.t + c.error);
        const mask_t<T> inside =
            every(t_min <= low, high <= t_max, is_finite(high), mask_t<T>(Asked == question::whether) || low == high);
        const mask_t<W> outside = some(high < t_min, t_max < low), missed = !c.exists;
        c.exists = every(c.exists, !outside);
        return {c, every(c.certain, some(missed, inside, outside))};
    }
}

/// What is known of the first of several crossings, or, where that is passed, on those that come next.
template <class W, class Next>
RAIO_FN constexpr finding<W> or_next(const finding<W>& found, Next next) {
    const mask_t<W> passed = every(found.known, !found.first.exists);
    if (none(passed)) return found;
    const finding<W> later = next();
    return {select(passed, later.first, found.first), some(every(passed, later.known), every(found.known, !passed))};
}

/// Of several crossings it has to be found out which one it is.
template <question Asked>
inline constexpr question which_one = Asked == question::whether ? Asked : question::where;

template <question Asked, real T, template <class> class Two, class W>
RAIO_FN constexpr finding<W> settled_in_window(const Two<W>& c, T t_min, T t_max) {
    const auto& [one, next] = c;
    return or_next(settled_in_window<which_one<Asked>>(one, t_min, t_max),
                   [&, &later = next] { return settled_in_window<which_one<Asked>>(later, t_min, t_max); });
}

}  // namespace raio::inline RAIO_ABI::detail

#include <raio/pop_macros.hpp>
