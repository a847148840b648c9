#pragma once

#include <raio/push_macros.hpp>

#include <raio/proof/line.hpp>
#include <raio/proof/settle.hpp>

/// \file
/// What a triangle and a parallelogram have in common: a corner and two edges.
///
/// Moeller and Trumbore (1997): the point origin + t d = corner + u e1 + v e2 is three linear equations for t, u and v.
/// By Cramer's rule, with s = origin - corner, p = d x e2 and q = s x e1,
///
///     det = e1.p,   u = s.p / det,   v = d.q / det,   t = e2.q / det.
///
/// The signs of det, u, v and of what is left of 1 beside u and v say whether the crossing counts. All are turned with
/// that of det, and nothing is divided before that is known.

namespace raio::inline RAIO_ABI {

/// Where a line crosses the plane of two edges, and how far along them: u and v are u / size and v / size of the edges.
template <class W>
struct edge_crossing {
    crossing<W> at;
    W size, u, v;
    bound_t<W> size_error, u_error, v_error;
};

namespace detail {

/// A bound of the terms of a.(b x c), a.b x c of the sizes: as tight as it gets where packs sieve. It is that of t,
/// which is near zero where rays start on the surface, and all of these would have to be asked for again.
template <class W>
RAIO_FN constexpr bound_t<W> terms_of_way(const vec3<W>& a, const vec3<W>& b, const vec3<W>& c) {
    if constexpr (!only_sieves<W>) {
        return triple_product_bound(a, b, c);
    } else {
        // What small floats lose of b x c counts |a| times. It is added as the larger of that and what is lost once,
        // twice: a product with a small |a| would be subnormal, which costs a trap.
        return permanent(a, b, c) + with_underflow<W>(W(0)) * (W(2) * max(W(1), norm1(a)));
    }
}

}  // namespace detail

/// The same formula for precisions that have a closer look. Leaves of trees spend their time here, so the bound is one
/// for all numbers, derived by hand.
///
/// The size |a| of a vector is the sum of its components' magnitudes. Edges and s are rounded once each, a cross
/// product rounds twice, a product with that three times. So a.(b x c) is off by at most 7 roundings of |a| |b| |c|;
/// one more is for those of the bound. (Of the sizes, since where p or q is out of range so are these.) Where a ray was
/// mapped, what its numbers are off by is added.
/// \param inside  how far inside the shape a crossing is, of `size`, u and v: the least of u, v and what is left of
///                `size` beside them, or beside one of them; negative outside
/// \param wanted  which crossings are. A line without any is asked no further
template <class W, class Line, class Inside, class Wanted = every_crossing>
RAIO_FN constexpr edge_crossing<W> cross_edges(const vec3<W>& corner, const vec3<W>& e1, const vec3<W>& e2,
                                               const Line& line, Inside inside, const Wanted& wanted = {}) {
    using E = bound_t<W>;
    vec3<W> direction = vector_in(line.direction()), s = vector_in(line.from(corner));
    vec3<W> p = cross(direction, e2), q = cross(s, e1);
    W det = dot(e1, p), size = abs(det);
    W u = flip(dot(s, p), det), v = flip(dot(direction, q), det), way = flip(dot(e2, q), det);
    W within = inside(size, u, v);

    E e1_size = norm1(vec3<E>(e1)), speed = norm1(vec3<E>(direction)), s_size = norm1(vec3<E>(s));
    E p_size = with_underflow<W>(speed * norm1(vec3<E>(e2))), q_size = with_underflow<W>(s_size * e1_size);
    E size_terms = with_underflow<W>(p_size * e1_size), u_terms = with_underflow<W>(p_size * s_size),
      v_terms = with_underflow<W>(q_size * speed);
    E k(8 * unit_roundoff<W>), size_error = k * size_terms, u_error = k * u_terms, v_error = k * v_terms;
    E error = k * (size_terms + u_terms + v_terms), way_error = k * detail::terms_of_way(e2, s, e1);
    if constexpr (!Line::is_exact) {
        const E of_s = detail::rounded_up<W>(line.from(corner).error), e2_size = norm1(vec3<E>(e2));
        const E of_d = detail::rounded_up<W>(line.direction().error),
                of_both = s_size * of_d + (speed + of_d + of_d) * of_s;
        size_error += e1_size * e2_size * of_d, way_error += e1_size * e2_size * of_s;
        u_error += e2_size * of_both, v_error += e1_size * of_both;
        error = size_error + u_error + v_error;
    }

    const mask_t<W> crosses = size > E(2) * size_error, outside = within < -error;
    if constexpr (!std::same_as<Wanted, known_crossing>) {
        if (all(every(crosses, some(outside, is_unwanted(wanted, way, way_error, size, size_error))))) {
            const mask_t<W> no = size < W(0);
            return {{no, !no, W(0), E(0), no, {}, W(0), W(0), no, true}, size, u, v, size_error, u_error, v_error};
        }
    }
    // |way / size - t| is at most (way_error + |t| size_error) / (size - size_error), and size is twice its error.
    W over_size = quotient(W(1), size, W(0)), t = way * over_size;
    E t_error = E(2) * (way_error + abs(E(t)) * size_error) * E(over_size) + E(4 * unit_roundoff<W>) * abs(E(t));
    if constexpr (only_sieves<W>) {
        // One number knows less of t, and records what it knows. Where that is more than `retrieved` takes for nothing,
        // a 64th of t, a 16th is said: the lane is asked alone if it is hit, and t keeps its sign.
        E looser = E(2) * k * triple_product_bound(e2, s, e1) * E(over_size);
        t_error = max(t_error, min(looser, abs(E(t)) * E(0x1p-4)));
    }
    // Made in place: a copy of packs would go through memory.
    return {{.exists = every(size > W(0), within >= W(0)),
             .certain = every(crosses, some(outside, within > error)),
             .t = t,
             .error = t_error,
             .entering = det > W(0),
             .u = u * over_size,
             .v = v * over_size},
            size,
            u,
            v,
            size_error,
            u_error,
            v_error};
}

/// Where a line crosses the plane of two edges.
/// \param far  what of u and v may not be above 1
/// \param wanted  which crossings are
template <class Line, real T, proven_vector E1, proven_vector E2, class Far, class Wanted>
RAIO_FN constexpr crossing<typename Line::number> cross_edges(const Line& line, const vec3<T>& corner, const E1& e1,
                                                              const E2& e2, Far far,
                                                              [[maybe_unused]] const Wanted& wanted) {
    using W = typename Line::number;
    if constexpr (has_closer_look<W>) {
        const auto inside = [far](const W& size, const W& u, const W& v) { return min(size - far(u, v), min(u, v)); };
        return cross_edges(vec3<W>(corner), vec3<W>(e1.x, e1.y, e1.z), vec3<W>(e2.x, e2.y, e2.z), line, inside, wanted)
            .at;
    } else {
        const auto d = line.direction();
        const auto s = line.from(corner);
        const auto det = determinant(e1, d, e2);
        const auto size = abs(det);
        const auto u = flip(determinant(s, d, e2), det);
        const auto v = flip(determinant(d, s, e1), det);
        const auto exists = every(is_not_zero(det), is_not_negative(u, size), is_not_negative(v, size),
                                  is_not_negative(size - far(u, v), size));
        const auto way = flip(determinant(e2, s, e1), det);
        if constexpr (!std::same_as<Wanted, known_crossing>) {
            const mask_t<W> passed = is_unwanted(wanted, way.value, way.error, size.value, size.error);
            if (all(some(!exists.possibly, passed))) return no_crossing<W>();
        }

        const auto over_size = inverse(size);
        const auto t = way * over_size;
        const auto u1 = u * over_size;
        const auto v1 = v * over_size;
        crossing<W> c = crossing_at(exists, t, det.value > W(0));
        if constexpr (last_precision<W>) {  // which may know so little of t that it could be any number
            const auto apart = s + d * t - (e1 * u1 + e2 * v1);
            c.exists = every(c.exists, size_of(apart) <= bound_t<W>(0x1p-30) * (size_of(e1) + size_of(e2)));
        }
        c.u = u1.value, c.v = v1.value;
        return c;
    }
}

/// What a flat shape between two such edges records of a point. Where a double has no digits to spare for the normal,
/// as on a sliver, or where the shape is seen edge-on, the normal is found with more.
/// \param corners  the box around it
/// \param edge     answers with the first or the second one in the precision of its argument
template <class Point, real T, class Edge>
RAIO_FN constexpr void flat_surface(Point& at, const aabb<T>& corners, Edge edge) {
    using W = typename Point::number;
    at.record_point();
    at.keep_between(corners);
    const auto across = [&]<class V>(V number) {
        return cross(scaled_into_range<T>(edge(number, 0)), scaled_into_range<T>(edge(number, 1)));
    };
    vec3<W> normal = across(W(0));
    if constexpr (detail::lacks_digits<T, W>) {
        const auto size = [](const vec3<W>& v) { return norm1(vec3<bound_t<W>>(v)); };
        const vec3<W> direction = at.direction();
        const bound_t<W> sizes = size(scaled_into_range<T>(edge(W(0), 0))) * size(scaled_into_range<T>(edge(W(0), 1)));
        const bound_t<W> across_ray = abs(bound_t<W>(dot(normal, direction))), few(0x1p-20);
        const mask_t<W> thin = some(size(normal) < few * sizes, across_ray < few * size(normal) * size(direction));
        if (any(thin)) [[unlikely]]
            normal = select(thin, vec3<W>(scaled_into_range<T>(across(exact_t<T>(0)))), normal);
    }
    at.record_normal(normal);
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
