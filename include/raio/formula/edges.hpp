#pragma once

#include <raio/proof/settle.hpp>

/// \file
/// What a triangle and a parallelogram have in common: a corner and two edges.
///
/// Moeller and Trumbore (1997): the point origin + t direction = corner + u e1 + v e2 is three linear equations for t,
/// u and v. By Cramer's rule, with s = origin - corner, p = direction x e2, q = s x e1,
///
///     det = e1.p,   u = s.p / det,   v = direction.q / det,   t = e2.q / det.
///
/// All signs are turned with that of det, and nothing is divided before it is known that the crossing counts.

namespace raio {

/// Where a line crosses the plane of two edges, and how far along them: u and v are u / size and v / size of the edges.
template <class W>
struct edge_crossing {
    crossing<W> at;
    W size, u, v;
    bound_t<W> size_error, u_error, v_error;
};

/// Bounds of the terms of det, and of u and v before they are divided by it.
template <class W>
struct edge_terms {
    bound_t<W> size, u, v;
};

template <class W>
RAIO_FN constexpr edge_terms<W> terms_of_edges(const vec3<W>& e1, const vec3<W>& e2, const vec3<W>& s,
                                               const vec3<W>& direction) {
    using E = bound_t<W>;
    if constexpr (last_precision<W>) {
        return {triple_product_bound(e1, direction, e2), triple_product_bound(s, direction, e2),
                triple_product_bound(s, direction, e1)};
    } else {  // the same, of the sizes of the vectors: where p or q is out of range these are as well
        E e1_size = norm1(vec3<E>(e1)), speed = norm1(vec3<E>(direction)), s_size = norm1(vec3<E>(s));
        E p_size = with_underflow<W>(speed * norm1(vec3<E>(e2))), q_size = with_underflow<W>(s_size * e1_size);
        return {with_underflow<W>(p_size * e1_size), with_underflow<W>(p_size * s_size),
                with_underflow<W>(q_size * speed)};
    }
}

/// \param inside  how far inside the shape a crossing is, of `size`, u and v: the least of u, v and what is left of
///                `size` beside them, or beside one of them; negative outside
/// \param wanted  which crossings are. A line without any is asked no further
template <class W, real R, class Inside, class Wanted = every_crossing>
RAIO_FN constexpr edge_crossing<W> cross_edges(const vec3<W>& corner, const vec3<W>& e1, const vec3<W>& e2,
                                               const ray<R>& ray, Inside inside, const Wanted& wanted = {}) {
    using E = bound_t<W>;
    vec3<W> direction(ray.direction), s = difference_as<W>(ray.origin, corner);
    vec3<W> p = cross(direction, e2), q = cross(s, e1);
    W det = dot(e1, p), size = abs(det);
    W u = flip(dot(s, p), det), v = flip(dot(direction, q), det), way = flip(dot(e2, q), det);
    W within = inside(size, u, v);

    // A triple product of vectors that are off by a rounding each is off by less than 8 roundings of its terms.
    auto [size_terms, u_terms, v_terms] = terms_of_edges(e1, e2, s, direction);
    E k(8 * unit_roundoff<W>), size_error = k * size_terms, u_error = k * u_terms, v_error = k * v_terms;
    E error = k * (size_terms + u_terms + v_terms), way_error = k * closest_triple_product_bound(e2, s, e1);

    const mask_t<W> crosses = size > E(2) * size_error, outside = within < -error;
    if constexpr (!std::same_as<Wanted, known_crossing>) {
        if (all(every(crosses, some(outside, is_unwanted(wanted, way, way_error, size, size_error))))) {
            const mask_t<W> no = size < W(0);
            const crossing<W> none{no, !no, W(0), E(0), no, {}, W(0), W(0), no, true};
            return {none, size, u, v, size_error, u_error, v_error};
        }
    }
    W over_size = quotient(W(1), size, W(0)), t = way * over_size;
    E t_error = E(2) * (way_error + abs(E(t)) * size_error) * E(over_size) + E(4 * unit_roundoff<W>) * abs(E(t));
    if constexpr (only_sieves<W>) {
        // One number knows less of the error of the way, and records what it knows. Where that is more than `retrieved`
        // takes for nothing, which is a 64th of t here, a 16th is said: the lane is asked alone if it is hit, and t
        // keeps its sign.
        E looser = E(2) * k * triple_product_bound(e2, s, e1) * E(over_size);
        t_error = max(t_error, min(looser, abs(E(t)) * E(0x1p-4)));
    }
    mask_t<W> meets = every(size > tie<W>(size_error), within >= -tie<W>(error));
    // A tie at a corner is much closer than the error of the far edge; and none is farther outside than 2^-30 of an
    // edge, for which the bounds of floats have room (2^-29 of a coordinate), nor t from u and v, however little is
    // known of a sliver.
    if constexpr (last_precision<W>) {
        vec3<W> apart = s + direction * t - (e1 * (u * over_size) + e2 * (v * over_size));
        E room = E(0x1p-30) * (norm1(vec3<E>(e1)) + norm1(vec3<E>(e2)));
        meets = every(meets, u >= -u_error, v >= -v_error, within >= W(-0x1p-30) * size, norm1(vec3<E>(apart)) <= room);
    }
    crossing<W> c{.exists = meets,
                  .certain = every(crosses, some(outside, within > error)),
                  .t = t,
                  .error = t_error,
                  .entering = det > W(0),
                  .u = u * over_size,
                  .v = v * over_size};
    return {c, size, u, v, size_error, u_error, v_error};
}

/// Across two edges, of any length. Where a double has no digits to spare, those of a sliver, or of what is seen
/// edge-on, are found with more. \param edge  answers with the first or the second one in the precision of its argument
template <real T, class W, class Edge>
RAIO_FN constexpr vec3<W> normal_of_edges(Edge edge, [[maybe_unused]] const vec3<W>& direction) {
    const auto across = [&]<class V>(V number) {
        return cross(scaled_into_range<T>(edge(number, 0)), scaled_into_range<T>(edge(number, 1)));
    };
    vec3<W> normal = across(W(0));
    if constexpr (detail::lacks_digits<T, W>) {
        const auto size = [](const vec3<W>& v) { return norm1(vec3<bound_t<W>>(v)); };
        const bound_t<W> sizes = size(scaled_into_range<T>(edge(W(0), 0))) * size(scaled_into_range<T>(edge(W(0), 1)));
        const bound_t<W> across_ray = abs(bound_t<W>(dot(normal, direction))), few(0x1p-20);
        const mask_t<W> thin = some(size(normal) < few * sizes, across_ray < few * size(normal) * size(direction));
        if (any(thin)) [[unlikely]]
            normal = select(thin, vec3<W>(scaled_into_range<T>(across(exact_t<T>(0)))), normal);
    }
    return normal;
}

/// Records the crossing with a flat shape that has such edges.
template <class W, real R, real T, real N, class Edge>
RAIO_FN constexpr void record_flat(const aabb<T>& corners, Edge edge, const ray<R>& ray, const crossing<W>& at,
                                   hit_record<T, N>& rec) {
    vec3<N> outward(normalize_from<T>(vec3<working_t<N>>(normal_of_edges<T, W>(edge, vec3<W>(ray.direction)))));
    record_point_between(corners, ray, at, rec);
    rec.normal = outward * choose(at.entering, N(1), N(-1));
}

}  // namespace raio
