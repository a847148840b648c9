#pragma once

#include <raio/proof/crossing.hpp>

/// \file
/// Where a ray's line is inside a solid: chords, each between two crossings, and what is made of them.

namespace raio {

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

/// What a shape of two chords answers.
template <class W, class Wanted>
struct chords_for {
    using type = chord_pair<W>;
};
template <class W, class Mask>
struct chords_for<W, known_chord<Mask>> {
    using type = chord<W>;
};
template <class W, class Wanted>
using chords_for_t = typename chords_for<W, Wanted>::type;

/// Is nothing left to find out: does every lane's line miss, beyond doubt?
template <class W>
RAIO_FN constexpr bool missed(const chord<W>& c) {
    return may_leave<W>(every(!c.near.exists, !c.far.exists, c.near.certain, c.far.certain));
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
    const mask_t<W> yes = has_closer_look<W> ? exists.possibly : exists.yes;
    const mask_t<W> certain = some(exists.certainly, !exists.possibly);
    return {{yes, certain, near.value, detail::rounded_up<W>(near.error), yes},
            {yes, certain, far.value, detail::rounded_up<W>(far.error), !yes}};
}

/// The two solutions of a t^2 - 2 b t + c = 0, the lower one first; a is above 0.
template <class W>
struct root_pair {
    bounded_number<W> near, far;
};

/// \param root  of b^2 - a c, found without that difference, which may cancel
template <proven_number A, class W>
RAIO_FN constexpr root_pair<W> quadratic_roots(const A& a, const bounded_number<W>& b, const bounded_number<W>& c,
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

/// The chord of a line that misses, or may miss.
template <class W>
RAIO_FN constexpr chord<W> nowhere(const mask_t<W>& certain) {
    const mask_t<W> no = W(0) != W(0);
    const crossing<W> none{no, certain, W(0), bound_t<W>(0), no};
    return {none, none};
}

/// The same, whichever it is that is wanted.
template <class Wanted, class W>
RAIO_FN constexpr chords_for_t<W, Wanted> nowhere_at_all(const chord<W>& c) {
    if constexpr (std::same_as<chords_for_t<W, Wanted>, chord<W>>) {
        return c;
    } else {
        return {c, c};
    }
}

/// The chord of a line that is inside everywhere.
template <real W>
RAIO_FN constexpr chord<W> everywhere() {
    const mask_t<W> yes = W(0) == W(0);
    const bound_t<W> none(0);
    return {{yes, yes, -infinity<W>, none, yes}, {yes, yes, infinity<W>, none, !yes}};
}

/// Lets a chord go on for ever in these lanes, if there is one.
template <class W>
RAIO_FN constexpr void keep_going_where(const mask_t<W>& where, chord<W>& c) {
    const bound_t<W> none(0);
    c.near.t = select(where, W(-infinity<W>), c.near.t), c.near.error = select(where, none, c.near.error);
    c.far.t = select(where, W(infinity<W>), c.far.t), c.far.error = select(where, none, c.far.error);
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

/// The chord of the points that two convex solids share: from where the line has entered both to where it leaves the
/// first. Of two faces that are crossed at the same t, that of `a` is named.
template <real W>
RAIO_FN constexpr chord<W> intersect(const chord<W>& a, const chord<W>& b) {
    using E = bound_t<W>;
    const mask_t<W> b_enters_later = a.near.t < b.near.t, b_leaves_first = b.far.t < a.far.t;
    // The crossing that was passed over counts as far as its error reaches beyond the chosen one.
    const auto error = [](const W& chosen, const crossing<W>& x, const crossing<W>& y) {
        return max(E(0), max(x.error - abs(E(chosen - x.t)), y.error - abs(E(chosen - y.t))));
    };
    const auto shared = [](const mask_t<W>& second, const crossing<W>& x, const crossing<W>& y) {
        return some(abs(E(y.t - x.t)) <= x.error + y.error, every(second, y.shared), every(!second, x.shared));
    };
    W near = max(a.near.t, b.near.t), far = min(a.far.t, b.far.t), inside = far - near;
    E near_error = error(near, a.near, b.near), far_error = error(far, a.far, b.far), slack = near_error + far_error;
    const mask_t<W> missed = some(every(a.near.certain, !a.near.exists), every(b.near.certain, !b.near.exists));
    const mask_t<W> decided = every(a.near.certain, b.near.certain, abs(inside) > slack);
    const mask_t<W> exists = every(a.near.exists, b.near.exists, inside >= -tie<W>(slack));
    const mask_t<W> certain = some(missed, decided);
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

/// Keeps only ends whose point T can say.
template <real T, real R, class W>
RAIO_FN constexpr void keep_if_reachable(const ray<R>& ray, chord<W>& c) {
    using E = bound_t<W>;
    vec3<E> origin(vec3<W>(ray.origin)), direction(vec3<W>(ray.direction));
    E reach = max(abs(E(c.near.t)), abs(E(c.far.t))) + max(c.near.error, c.far.error);
    E farthest = norm1(origin) + norm1(direction) * reach;
    // Both are, errors included: the half of what is asked for below leaves room for the roundings here.
    if (all(farthest < E(std::numeric_limits<scalar_t<T>>::max() / 4))) return;
    keep_if_reachable<T>(ray, c.near);
    keep_if_reachable<T>(ray, c.far);
}

template <real T, real R, class W>
RAIO_FN constexpr void keep_if_reachable(const ray<R>& ray, chord_pair<W>& c) {
    keep_if_reachable<T>(ray, c.first);
    keep_if_reachable<T>(ray, c.second);
}

}  // namespace raio
