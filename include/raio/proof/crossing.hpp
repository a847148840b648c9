#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/interval.hpp>
#include <raio/number/bounded_vector.hpp>
#include <raio/ray.hpp>

/// \file
/// Where a ray's line crosses a surface, and how sure that is.
///
/// A shape writes its formula once, for a number type W, and says with each crossing how large the rounding errors of W
/// can have become: proof/settle.hpp makes an answer of that.
///
/// The local variables of class type here and in the shapes are not const: GCC keeps a const aggregate in memory, where
/// every step waits for the one before to be stored.

namespace raio::inline RAIO_ABI {

/// What a comparison has to forgive. The last of several precisions takes what it cannot tell from a tie for one:
/// edges, rims and tangents belong to the shape. A number type that stands alone compares what it has computed.
template <real W>
RAIO_FN constexpr bound_t<W> tie(const bound_t<W>& error) {
    if constexpr (last_precision<W>) {
        return error;
    } else {
        return bound_t<W>(0);
    }
}

/// The same where an error has no limit, as that of where a line meets a plane in which it all but lies: what differs
/// by more than a millionth of `size` is no tie, however little is known of it.
template <real W>
RAIO_FN constexpr bound_t<W> tie(const bound_t<W>& error, [[maybe_unused]] const bound_t<W>& size) {
    if constexpr (last_precision<W>) {
        return min(error, bound_t<W>(0x1p-20) * size);
    } else {
        return tie<W>(error);
    }
}

/// A bound, and what may have been lost besides where small floats lose their digits. What is computed in double does
/// not come near its own smallest numbers, but in planes and polynomials, which ask nothing of sizes and say so
/// themselves.
template <real W>
RAIO_FN constexpr bound_t<W> with_underflow(const bound_t<W>& error) {
    if constexpr (std::same_as<scalar_t<W>, float>) {
        return error + bound_t<W>(least_normal<W>);
    } else {
        return error;
    }
}

/// A bound for the terms of a.(b x c), whose rounding errors are a few times that much of a roundoff: cheap where a
/// closer look can follow, and as tight as it gets where it decides.
template <class W>
RAIO_FN constexpr bound_t<W> triple_product_bound(const vec3<W>& a, const vec3<W>& b, const vec3<W>& c) {
    using E = bound_t<W>;
    if constexpr (!std::same_as<W, E>) {
        return permanent(vec3<E>(a), vec3<E>(b), vec3<E>(c));
    } else {
        return with_underflow<W>(norm1(a) * with_underflow<W>(norm1(b) * norm1(c)));
    }
}

/// The only crossing there is, which is known to exist, and to be wanted.
struct known_crossing {};

/// One crossing of the line `origin + t * direction` with a surface, in the precision of W. No member is a vector:
/// GLM's are unions unless it is told otherwise, and GCC keeps an aggregate with a union in memory.
template <class W>
struct crossing {
    using number = W;

    mask_t<W> exists;      ///< does the line cross the surface?
    mask_t<W> certain;     ///< is `exists` right whatever the rounding errors were?
    W t;                   ///< ray parameter
    bound_t<W> error;      ///< bound of |t - exact t|
    mask_t<W> entering;    ///< does the line come from the outside here?
    index_t<W> face = {};  ///< which face of the shape, as the shape counts them
    W u = W(0), v = W(0);  ///< where on it, if the shape finds that on the way
    mask_t<W> shared{};    ///< may it be another face that is crossed there?
    bool missed = false;   ///< is nothing left to find out: does every lane's line miss, beyond doubt?
};

/// Is nothing left to find out: does every lane's line miss, beyond doubt?
template <class W>
RAIO_FN constexpr bool missed(const crossing<W>& c) {
    return c.missed;
}

/// May the line start on the surface?
template <class W>
RAIO_FN constexpr mask_t<W> touches_origin(const crossing<W>& c) {
    if constexpr (is_believed<W>) return c.t != c.t;  // t is what was found
    return abs(bound_t<W>(c.t)) <= c.error;
}

/// Where the line starts on the surface, what cannot be told from t = 0 is there.
template <class W>
RAIO_FN constexpr void start_at_origin(crossing<W>& c, const mask_t<W>& starts) {
    const mask_t<W> there = every(starts, touches_origin(c));
    c.error = select(there, c.error + abs(bound_t<W>(c.t)), c.error);
    c.t = select(there, W(0), c.t);
}

/// All crossings of a line are wanted.
struct every_crossing {};

/// Only the first crossing in [t_min, t_max] is wanted. Those that are before that need not be found, nor those after
/// the first that is not.
template <real T>
struct first_from {
    T t_min, t_max;
    bool roughly;  ///< is it enough to know whether it is in there?
};

/// Is the crossing at t = way / size out of the window, whatever the rounding errors were? Nothing is divided to find
/// out. Only a window of W's own says so: t is not rounded any further before it counts.
template <class W, class Wanted>
RAIO_FN constexpr mask_t<W> is_unwanted([[maybe_unused]] const Wanted& wanted, [[maybe_unused]] const W& way,
                                        [[maybe_unused]] const bound_t<W>& way_error, const W& size,
                                        [[maybe_unused]] const bound_t<W>& size_error) {
    if constexpr (is_believed<W> && requires { wanted.t_min; }) {
        return some(way < W(wanted.t_min) * size, W(wanted.t_max) * size < way);
    } else if constexpr (std::same_as<Wanted, first_from<W>>) {
        using E = bound_t<W>;
        // Twice the errors, for the roundings here and that of t; and a t that is too small for any number counts as 0.
        // That margin is no factor of a product: with a small size it would be subnormal, which costs a trap.
        E least = E(least_normal<W>) * max(E(1), E(size)), begin(wanted.t_min), end(wanted.t_max);
        E of_way = E(2) * way_error + least, of_size = E(2) * size_error;
        E earliest = E(way) - of_way, latest = E(way) + of_way;
        return some(latest < begin * (E(size) - flip(of_size, begin)), end * (E(size) + flip(of_size, end)) < earliest);
    } else {
        return size != size;
    }
}

template <class Mask, class W>
RAIO_FN constexpr crossing<W> select(Mask mask, const crossing<W>& a, const crossing<W>& b) {
    const auto either = [&](const Mask& x, const Mask& y) { return some(every(mask, x), every(!mask, y)); };
    return {either(a.exists, b.exists),     either(a.certain, b.certain),   select(mask, a.t, b.t),
            select(mask, a.error, b.error), either(a.entering, b.entering), select(mask, a.face, b.face),
            select(mask, a.u, b.u),         select(mask, a.v, b.v),         either(a.shared, b.shared)};
}

/// A crossing at this place, if there is one.
template <class W>
RAIO_FN constexpr crossing<W> crossing_at(const verdict<mask_t<W>>& exists, const bounded_number<W>& t,
                                          const mask_t<W>& entering) {
    return {.exists = answer_of(exists, t),
            .certain = is_settled_at(exists, t),
            .t = t.value,
            .error = detail::limit_of(t),
            .entering = entering};
}

/// A crossing at this place, which is there beyond doubt.
template <class W>
RAIO_FN constexpr crossing<W> crossing_at(const bounded_number<W>& t, const mask_t<W>& entering = {}) {
    const mask_t<W> yes = W(0) == W(0);
    return {.exists = yes, .certain = yes, .t = t.value, .error = detail::rounded_up<W>(t.error), .entering = entering};
}

/// No crossing, beyond doubt.
template <class W>
RAIO_FN constexpr crossing<W> no_crossing() {
    const mask_t<W> no = W(0) != W(0);
    return {.exists = no, .certain = !no, .t = W(0), .error = bound_t<W>(0), .entering = no, .missed = true};
}

/// The same crossing, and where it is on the surface: u is the place, and v how far that may be off.
template <class W>
RAIO_FN constexpr crossing<W> located(crossing<W> c, const bounded_number<W>& place) {
    c.u = place.value, c.v = W(place.error);
    return c;
}

/// How far that place may be off. Where double says that it is not, as of the end of a curve, it may be as far off as t
/// does not tell.
/// \param unnoticed  says how far that is, from what t is off by
template <class W, class Unnoticed>
RAIO_FN constexpr W error_of_place(const crossing<W>& c, Unnoticed unnoticed) {
    if constexpr (!last_precision<W>) {
        if (!(c.v > W(0))) return unnoticed(W(c.error));
    }
    return c.v;
}

/// Keeps only crossings whose point has coordinates in the range of T: a shape without end may be crossed beyond it.
template <real T, class Line, class W>
RAIO_FN constexpr void keep_if_in_range(const Line& line, crossing<W>& c) {
    if constexpr (is_believed<W>) return;
    bound_t<W> speed = detail::most_of(line.direction());
    bound_t<W> farthest = detail::most_of(line.origin()) + speed * abs(bound_t<W>(c.t));
    const bound_t<W> most(std::numeric_limits<scalar_t<T>>::max() / 2);
    if constexpr (std::same_as<W, T>) {  // whoever takes a closer look decides so close to the end of the range
        c.certain = every(c.certain, some(!c.exists, farthest + speed * c.error < most / bound_t<W>(2)));
    }
    c.exists = every(c.exists, farthest < most);
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
