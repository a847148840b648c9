#pragma once

#include <raio/push_macros.hpp>

#include <raio/proof/crossing.hpp>

/// \file
/// Where a ray's line is inside a solid: chords, each between two crossings, and what is made of them.

namespace raio::inline RAIO_ABI {

/// Two crossings of one line, in order. Of a convex solid both exist or none does, and the line is inside between them.
template <class W>
struct chord {
    crossing<W> near, far;
};

/// Two chords of one line, in order, with no point in common but an end: through a solid that is hollow, or in two
/// parts. The second may exist where the first does not.
template <class W>
struct chord_pair {
    chord<W> first, second;
};

/// Of two chords only the one is wanted that is known to have the crossing.
template <class Mask>
struct known_chord {
    Mask is_first;
};

/// Is nothing left to find out: does every lane's line miss, beyond doubt?
template <class W>
RAIO_FN constexpr bool missed(const chord<W>& c) {
    return all(every(!c.near.exists, !c.far.exists, c.near.certain, c.far.certain));
}

template <class W>
RAIO_FN constexpr bool missed(const chord_pair<W>& c) {
    return missed(c.first) && missed(c.second);
}

/// An end that cannot be told from t = 0 is there, if the line starts on the surface.
/// \param starts  does it? Asked only then: is what would be zero no more than its own roundings?
template <class W>
RAIO_FN constexpr void start_on_surface(chord<W>& c, auto starts) {
    if (!any(some(touches_origin(c.near), touches_origin(c.far)))) return;
    const mask_t<W> on_it = starts();
    start_at_origin(c.near, on_it);
    start_at_origin(c.far, on_it);
}

/// The chord between two places, if there is one.
template <class W>
RAIO_FN constexpr chord<W> between(const verdict<mask_t<W>>& exists, const bounded_number<W>& near,
                                   const bounded_number<W>& far) {
    const mask_t<W> yes = every(answer_of(exists, near), answer_of(exists, far)), entering(true);
    const mask_t<W> certain = every(is_settled_at(exists, near), is_settled_at(exists, far));
    return {{yes, certain, near.value, detail::limit_of(near), entering},
            {yes, certain, far.value, detail::limit_of(far), !entering}};
}

/// The two solutions of a t^2 - 2 b t + c = 0, the lower one first; a is above 0.
template <class W>
struct root_pair {
    bounded_number<W> near, far;
};

/// \param root  of b^2 - a c, found without that difference, which may cancel
template <proven_number A, class W>
[[gnu::always_inline]] RAIO_FN constexpr root_pair<W> quadratic_roots(const A& a, const bounded_number<W>& b,
                                                                      const bounded_number<W>& c,
                                                                      const bounded_number<W>& root) {
    using E = bound_t<W>;
    const auto over_a = inverse(a);
    // Both ends are off by no more than the one that is farther away.
    const E size = size_of(b) + E(root.value);
    const E error = (bounded_number<W>(W(size), b.error + root.error + detail::roundings<W>(1, size)) * over_a).error;
    bounded_number<W> near((b.value - root.value) * over_a.value, error);
    bounded_number<W> far((b.value + root.value) * over_a.value, error);
    if constexpr (last_precision<W>) {
        // Of b - root and b + root one cancels where c is small: where the line starts near the surface. Their product
        // is a c. And where c cannot be told from zero, the line starts on it.
        const bool starts = size_of(c) <= detail::rounded_up<W>(c.error);
        const bounded_number<W> power = starts ? bounded_number<W>{W(0), c.error + size_of(c)} : c;
        const bool is_near = b.value > W(0);
        bounded_number<W>& small = is_near ? near : far;
        const bounded_number<W> sum = is_near ? b + root : b - root;
        if (size_of(sum) > sum.error) {
            const bounded_number<W> better = power * inverse(sum);
            if (better.error < small.error) small = better;
        }
    }
    return {near, far};
}

/// The same chord, but only if this holds as well.
template <class W>
RAIO_FN constexpr chord<W> only_if(const verdict<mask_t<W>>& holds, chord<W> c) {
    const mask_t<W> settled = is_settled(holds), never = !holds.possibly, may = answer_of<W>(holds);
    const auto kept = [&](crossing<W>& end) {
        end.certain = some(every(end.certain, some(settled, !end.exists)), never);
        end.exists = every(end.exists, may);
    };
    kept(c.near), kept(c.far);
    return c;
}

/// The same in place, where there is no doubt whether it holds.
template <class Mask, class W>
RAIO_FN constexpr void keep_if(const Mask& holds, chord<W>& c) {
    c.near.exists = every(c.near.exists, holds), c.far.exists = every(c.far.exists, holds);
}

/// The chord of a line that misses; beyond doubt, unless it says otherwise.
template <class W>
RAIO_FN constexpr chord<W> nowhere(const mask_t<W>& certain = mask_t<W>(true)) {
    const mask_t<W> no = W(0) != W(0);
    return {{no, certain, W(0), bound_t<W>(0), no}, {no, certain, W(0), bound_t<W>(0), no}};
}

/// The same, whichever it is that is wanted.
template <class W, class Wanted>
RAIO_FN constexpr auto nowhere_at_all(const chord<W>& c, const Wanted& wanted) {
    if constexpr (requires { wanted.is_first; }) {
        return c;
    } else {
        return chord_pair<W>{c, c};
    }
}

/// The chord of a line that is inside everywhere.
template <real W>
RAIO_FN constexpr chord<W> everywhere() {
    const mask_t<W> yes = W(0) == W(0);
    const bound_t<W> none(0);
    return {{yes, yes, -infinity<W>, none, yes}, {yes, yes, infinity<W>, none, !yes}};
}

/// Lets a chord begin nowhere, or end nowhere, in these lanes.
template <class W>
RAIO_FN constexpr void begin_never_where(const mask_t<W>& where, chord<W>& c) {
    c.near.t = select(where, W(-infinity<W>), c.near.t), c.near.error = select(where, bound_t<W>(0), c.near.error);
}
template <class W>
RAIO_FN constexpr void end_never_where(const mask_t<W>& where, chord<W>& c) {
    c.far.t = select(where, W(infinity<W>), c.far.t), c.far.error = select(where, bound_t<W>(0), c.far.error);
}

/// A chord, unless the line is parallel to what it ends at: then all of the line is inside, or nothing.
template <class W>
RAIO_FN constexpr chord<W> unless_parallel(const verdict<mask_t<W>>& parallel, chord<W> c,
                                           const verdict<mask_t<W>>& inside) {
    const mask_t<W> along = parallel.yes, exists = every(along, answer_of<W>(inside));
    const mask_t<W> known = every(is_settled(parallel), some(!along, is_settled(inside)));
    const auto put = [&](crossing<W>& end) {
        end.exists = some(exists, every(!along, end.exists));
        end.certain = every(known, some(along, end.certain));
    };
    put(c.near), put(c.far);
    begin_never_where(along, c), end_never_where(along, c);
    return c;
}

/// The chord of two convex solids that are convex together: from where the line enters the first to where it leaves the
/// last.
template <real W>
RAIO_FN constexpr chord<W> unite(const chord<W>& a, const chord<W>& b) {
    const auto chosen = [](const mask_t<W>& second, const crossing<W>& x, const crossing<W>& y) {
        crossing<W> c = select(second, y, x);
        const mask_t<W> both = every(x.exists, y.exists);
        // The crossing that was passed over counts as far as its error reaches beyond the chosen one.
        bound_t<W> apart = abs(bound_t<W>(y.t - x.t)), beyond = select(second, x.error, y.error) - apart;
        c.shared = some(c.shared, every(both, apart <= x.error + y.error));
        c.error = select(both, max(c.error, beyond), c.error);
        c.certain = every(x.certain, y.certain);
        return c;
    };
    return {chosen(every(b.near.exists, some(!a.near.exists, b.near.t < a.near.t)), a.near, b.near),
            chosen(every(b.far.exists, some(!a.far.exists, b.far.t > a.far.t)), a.far, b.far)};
}

/// |a - b|. Of two that are both infinite it is not a number, which compilers do not take for a constant.
template <real W>
RAIO_FN constexpr bound_t<W> distance_between(const W& a, const W& b) {
    if (std::is_constant_evaluated() && all(a == b)) return bound_t<W>(0);
    return abs(bound_t<W>(a - b));
}

/// The chord of the points that two convex solids share: from where the line has entered both to where it leaves the
/// first. Of two faces that are crossed at the same t, that of `a` is named.
template <real W>
RAIO_FN constexpr chord<W> intersect(const chord<W>& a, const chord<W>& b) {
    using E = bound_t<W>;
    const mask_t<W> b_enters_later = a.near.t < b.near.t, b_leaves_first = b.far.t < a.far.t;
    // The crossing that was passed over counts as far as its error reaches beyond the chosen one.
    const auto error = [](const W& chosen, const crossing<W>& x, const crossing<W>& y) {
        return max(E(0), max(x.error - distance_between(chosen, x.t), y.error - distance_between(chosen, y.t)));
    };
    const auto shared = [](const mask_t<W>& second, const crossing<W>& x, const crossing<W>& y) {
        return some(distance_between(y.t, x.t) <= x.error + y.error, every(second, y.shared), every(!second, x.shared));
    };
    W near = max(a.near.t, b.near.t), far = min(a.far.t, b.far.t), inside = far - near;
    E near_error = error(near, a.near, b.near), far_error = error(far, a.far, b.far), slack = near_error + far_error;
    const mask_t<W> missed = some(every(a.near.certain, !a.near.exists), every(b.near.certain, !b.near.exists));
    const mask_t<W> decided = every(a.near.certain, b.near.certain, abs(inside) > slack);
    E size = abs(E(near)) + abs(E(far));
    const mask_t<W> exists = every(a.near.exists, b.near.exists, inside >= -tie<W>(slack, size));
    const mask_t<W> certain = detail::beyond_doubt<W>(some(missed, decided));
    if constexpr (last_precision<W>) {  // what cannot be told from a point is one, where that is known best
        const mask_t<W> is_point = every(exists, inside < W(0));
        W point = select(near_error < far_error, near, far);
        near = select(is_point, point, near), far = select(is_point, point, far);
        E moved = select(is_point, -E(inside), E(0));
        near_error += moved, far_error += moved;
    }
    return {{exists, certain, near, near_error, a.near.entering, select(b_enters_later, b.near.face, a.near.face),
             a.near.u, a.near.v, shared(b_enters_later, a.near, b.near)},
            {exists, certain, far, far_error, a.far.entering, select(b_leaves_first, b.far.face, a.far.face), a.far.u,
             a.far.v, shared(b_leaves_first, a.far, b.far)}};
}

/// The crossing, if it lies on the chord.
template <class W>
RAIO_FN constexpr crossing<W> within(const chord<W>& slab, crossing<W> c) {
    W before = c.t - slab.near.t, after = slab.far.t - c.t;
    using E = bound_t<W>;
    E before_error = c.error + slab.near.error, after_error = c.error + slab.far.error;
    E size = abs(E(slab.near.t)) + abs(E(slab.far.t));  // of its t, as in polyhedra: what is between may be a point
    const mask_t<W> off = some(before < -before_error, after < -after_error, !slab.near.exists);
    const mask_t<W> between = every(before > before_error, after > after_error);
    c.certain = detail::beyond_doubt<W>(every(c.certain, slab.near.certain, some(off, between, !c.exists)));
    c.exists =
        every(c.exists, slab.near.exists, before >= -tie<W>(before_error, size), after >= -tie<W>(after_error, size));
    return c;
}

/// What a convex solid leaves of a surface: of a closed one the chord that both share, of an open one each crossing on
/// its own, if it lies in the solid.
template <bool Closed, class W>
RAIO_FN constexpr chord<W> cut(const chord<W>& c, const chord<W>& solid) {
    if constexpr (Closed) {
        return intersect(c, solid);
    } else {
        return {within(solid, c.near), within(solid, c.far)};
    }
}

/// Keeps only ends whose point has coordinates in the range of T.
template <real T, class Line, class W>
RAIO_FN constexpr void keep_if_in_range(const Line& line, chord<W>& c) {
    using E = bound_t<W>;
    if constexpr (is_believed<W>) return;
    E reach = max(abs(E(c.near.t)), abs(E(c.far.t))) + max(c.near.error, c.far.error);
    E farthest = detail::most_of(line.origin()) + detail::most_of(line.direction()) * reach;
    // Both are, errors included: the half of what is asked for below leaves room for the roundings here.
    if (all(farthest < E(std::numeric_limits<scalar_t<T>>::max() / 4))) return;
    keep_if_in_range<T>(line, c.near);
    keep_if_in_range<T>(line, c.far);
}

template <real T, class Line, class W>
RAIO_FN constexpr void keep_if_in_range(const Line& line, chord_pair<W>& c) {
    keep_if_in_range<T>(line, c.first);
    keep_if_in_range<T>(line, c.second);
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
