#pragma once

#include <raio/push_macros.hpp>

#include <raio/proof/line_part.hpp>

/// \file
/// Where a line crosses an algebraic surface f(p) = 0, whose solid is where f is negative.
///
/// Along a line f is a polynomial. Its coefficients are those of a part of the line that lies near the shape and has
/// its size: p(x) = from + x along, t = middle + x half. So no power of a far origin cancels, and all that counts lies
/// between x = -1 and 1. The coordinates of p(x) are polynomials of degree 1, and f is computed with them as with
/// numbers (math/polynomial.hpp); its roots are isolated (math/polynomial_roots.hpp).

namespace raio::inline RAIO_ABI {

namespace detail {

/// The places x that lie between the ends of a chord, and a little beyond it.
template <class W>
RAIO_FN constexpr vec2<W> range_of(const chord<W>& clip, const line_part<W>& part) {
    W over_half = W(1) / part.half, more(0x1p-6);
    return {max(-part.reach, (clip.near.t - part.middle) * over_half - more),
            min(part.reach, (clip.far.t - part.middle) * over_half + more)};
}

/// The same roots are wanted, but none that is not clearly within the chord is the first.
template <class W>
RAIO_FN constexpr wanted_roots<W> within(const chord<W>& clip, const line_part<W>& part, wanted_roots<W> wanted) {
    using E = bound_t<W>;
    const E over_half = E(1) / E(part.half), middle(part.middle), less(0x1p-30);
    const auto place = [&](const E& t) { return (t - middle) * over_half; };
    wanted.from = max(wanted.from, place(E(clip.near.t) + clip.near.error) + less);
    wanted.to = min(wanted.to, place(E(clip.far.t) - clip.far.error) - less);
    return wanted;
}

}  // namespace detail

/// At most as many crossings as a polynomial of degree N has roots, or a pair for each part of a solid that a convex
/// one cuts off.
template <class W, std::size_t N>
using crossings_of_degree = crossing_list<W, N + 2 + N % 2>;

/// The solid where f <= 0, as far as it is within a convex one, whose faces close it. If only the first of the roots is
/// wanted, where the line leaves the solid behind it need not be right.
template <class W, std::size_t N>
RAIO_FN constexpr crossings_of_degree<W, N> closed_crossings(const polynomial<W, N>& f, const line_part<W>& part,
                                                             const chord<W>& clip, const wanted_roots<W>& wanted) {
    using E = bound_t<W>;
    const vec2<W> range = detail::range_of(clip, part);
    wanted_roots<W> clipped = detail::within(clip, part, wanted);
    clipped.before = -infinity<E>;  // the first root says what is inside
    const auto roots = roots_between(f, range.x, range.y, clipped);
    crossings_of_degree<W, N> list;
    list.certain = roots.certain;
    const auto append = [&](const chord<W>& inside) {
        chord<W> c = intersect(inside, clip);
        list.certain = list.certain && c.near.certain;
        // A chord that cannot be told from a point is one: edges and tangents belong to the solid.
        if (!(E(c.far.t - c.near.t) >= -(c.near.error + c.far.error))) return;
        c.near.exists = c.far.exists = true;
        list.append(c.near), list.append(c.far);
    };
    const chord<W> line = everywhere<W>();
    chord<W> inside = line;
    bool within = begins_below_zero(f, roots, range.x, range.y);
    for (const polynomial_root<W>& root : roots) {
        // Where f is zero to the end of the range, that counts as inside.
        const bool touches = root.sign_before * root.sign_after > 0, goes_on = root.sign_after <= 0;
        if (!within) inside.near = part.at(root, true);
        if (!goes_on || (within && touches)) {
            inside.far = part.at(root, false);
            append(inside);
            inside = line;
            if (goes_on) inside.near = part.at(root, true);
        }
        within = goes_on;
    }
    if (within) append(inside);
    list.start_at_origin();
    return list;
}

/// The surface where f = 0, as far as it is within a convex solid, and as far as `belongs(root)` says. A line that lies
/// in the surface is nowhere crossing it.
template <class W, std::size_t N, class Belongs>
RAIO_FN constexpr crossings_of_degree<W, N> open_crossings(const polynomial<W, N>& f, const line_part<W>& part,
                                                           const chord<W>& clip, const wanted_roots<W>& wanted,
                                                           Belongs belongs) {
    using E = bound_t<W>;
    const vec2<W> range = detail::range_of(clip, part);
    const auto roots = roots_between(f, range.x, range.y, detail::within(clip, part, wanted));
    crossings_of_degree<W, N> list;
    list.certain = roots.certain && clip.near.certain;
    for (const polynomial_root<W>& root : roots) {
        if (root.sign_before * root.sign_after == 0 || !belongs(root)) continue;
        crossing<W> c = part.at(root, root.sign_before > 0);
        E before(c.t - clip.near.t), before_error = c.error + clip.near.error;
        E after(clip.far.t - c.t), after_error = c.error + clip.far.error;
        if (before < -before_error || after < -after_error) continue;
        list.certain = list.certain && before > before_error && after > after_error;
        list.append(c, root);
    }
    list.start_at_origin();
    return list;
}
template <class W, std::size_t N>
RAIO_FN constexpr crossings_of_degree<W, N> open_crossings(const polynomial<W, N>& f, const line_part<W>& part,
                                                           const chord<W>& clip, const wanted_roots<W>& wanted) {
    return open_crossings(f, part, clip, wanted, [](const polynomial_root<W>&) { return true; });
}

/// Follows the line from outside, through one polynomial of degree 4 after the other. Where a polynomial is zero at an
/// end, the next one tells what comes of it. One that is zero all the way, or cannot be told from it for long, is that
/// of a line in the surface, which touches it from where that begins to where it ends.
template <class W, std::size_t N>
struct piecewise_walk {
    const line_part<W>& part;
    wanted_roots<W> wanted;
    crossing_list<W, N>& list;
    int sign = 1;  ///< of what the polynomials are pieces of: positive outside
    bool is_open = false, is_along = false, is_done = false;
    polynomial_root<W> begin{}, end{};  ///< of what is open; there is an end if it runs along the surface

    RAIO_FN constexpr void cross(const polynomial<W, 4>& f, const W& low, const W& high) {
        wanted_roots<W> also_first = wanted;
        also_first.before = -infinity<bound_t<W>>;  // the first root says what is inside
        const auto roots = roots_between(f, low, high, also_first);
        list.depends_on(roots);
        if (roots.count == 0) return reach(begins_below_zero(f, roots, low, high) ? -1 : 1);
        for (const polynomial_root<W>& root : roots) {
            if (root.sign_before != 0) reach(root.sign_before);
            // (About a tangent a piece that is shorter than the root of the noise, which is below 2^-16, is zero to
            // both ends as well.)
            W first = root.sign_before == 0 ? low : max(low, root.t - W(root.error));
            W last = root.sign_after == 0 ? high : min(high, root.t + W(root.error));
            if (root.sign_before * root.sign_after == 0 && bound_t<W>(last - first) > bound_t<W>(0x1p-16)) {
                meet({first, bound_t<W>(0), 0, 0, root.height});
                end = {last, bound_t<W>(0), 0, 0, root.height}, is_along = true;
            } else {
                meet(root);
            }
            if (root.sign_after != 0) reach(root.sign_after);
        }
    }

    RAIO_FN constexpr void meet(const polynomial_root<W>& root) {
        polynomial_root<W>& known = is_along ? end : begin;
        if (is_open) {
            known.error = max(known.error, bound_t<W>(root.t - known.t) + root.error);
        } else {
            known = root;
        }
        is_open = true;
    }

    RAIO_FN constexpr void reach(int next) {
        if (is_open) {
            // What lies in the surface belongs to the solid: it is entered where that begins, and left where it ends.
            const polynomial_root<W>& last = is_along && next > 0 ? end : begin;
            list.append(part.at(sign > 0 ? begin : last, sign > 0));
            if (sign == next) list.append(part.at(last, sign < 0));
            is_done = bound_t<W>(begin.t) - begin.error > wanted.from;
        }
        is_open = is_along = false, sign = next;
    }
};

/// A box, and around it what 106 bits cannot tell from the tips of what is swept in it.
template <real T>
RAIO_FN constexpr aabb<T> with_room_for_tips(const aabb<T>& box) {
    const vec3<T> room(T(0x1p-40) * norm1(vec3<T>(box.max - box.min)));
    return {box.min - room, box.max + room};
}

/// How far a point may be off besides, of a surface of that size that is found by the roots of a polynomial: beyond
/// that all is certain, where what is swept is no thinner than 2^-30 of the size.
template <real T>
RAIO_FN constexpr T error_of_sweep(const T& size) {
    return T(0x1p-60) * size;
}

/// And how far a tangent may be off, at which there is no certain root.
template <class Point>
RAIO_FN constexpr auto error_of_tangent(Point& at) {
    using T = std::remove_cvref_t<decltype(at.point().x)>;
    return last_precision<typename Point::number> ? T(at.blur()) : T(0);
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
