#pragma once

#include <array>
#include <utility>

#include <raio/concepts.hpp>
#include <raio/proof/crossing_list.hpp>
#include <raio/shape/triangle.hpp>

namespace raio {

/// The surface through four corners, which need not lie in one plane: where u goes from 0 to 1, a straight line moves
/// from the edge p00 p01 to the edge p10 p11. Its front is the side from which the turn from u to v is
/// counter-clockwise.
///
/// As seen from the ray's origin that line runs from a(u) = a + u A to a(u) + w(u), with w(u) = w + u D, where A = p10
/// - p00, w = p01 - p00, D = p00 - p10 - p01 + p11. The ray and the line lie in one plane where the triple product
///
///     f(u) = d.(a(u) x w(u)) = d.(a x w) + u (d.(A x w) + d.(a x D)) + u^2 d.(A x D)
///
/// is zero (Reshetov, Ray Tracing Gems ch. 8, 2019), and the point a(u) + v w(u) is on the ray where v n = -m, with m =
/// a(u) x d and n = w(u) x d: between both ends if m.(m + n) <= 0. f' = d.(du x dv) says from which side the ray comes.
///
/// A ray that runs along one of the straight lines, u or v constant, lies in the surface and misses it, as a ray in the
/// plane of a flat shape does. Of a planar patch that is folded over itself, the side with the lesser u comes first.
/// With an edge of no length it is a triangle; where all is on one line, the patch is missed.
///
/// uv: u and v.
template <real T>
struct bilinear_patch {
    using number = T;

    vec3<T> p00, p10, p01, p11;  ///< the corners at (u, v) = (0, 0), (1, 0), (0, 1) and (1, 1)

    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr aabb<T> bounds() const { return padded(corners()); }

    template <class W, real R>
    RAIO_FORMULA constexpr crossing_list<W, 2> crossings(const ray<R>& ray) const {
        const std::size_t i = edge_without_length();
        if (i == 4) return cross_moving_line<W>(ray);
        const std::array<vec3<T>, 4> around = corners_in_order();
        return cross_triangle<W>(triangle<T>{around[i], around[(i + 2) % 4], around[(i + 3) % 4]}, i, ray);
    }

    template <class W, real R, real N>
    RAIO_FN constexpr void surface(const ray<R>& ray, const crossing<W>& at, hit_record<T, N>& rec) const {
        using Q = working_t<N>;
        const auto [edge_u, edge_v, far] = edges<W>();
        vec3<W> twist = far - edge_v, reach = abs(far) + abs(edge_v);
        // What floats make has room in double as it is; to scale it would lose a short edge beside a long one.
        W quarter(0.25), size = norm1(edge_u * quarter) + norm1(reach * quarter),
                         scale = has_room_for<T, W> ? W(1) : quarter / size;
        vec3<W> scaled_u = edge_u * scale, scaled_v = edge_v * scale, scaled_twist = twist * scale;
        // In all digits of W, here and below: on a sliver or beside a fold the two have nearly one direction, and
        // little is left of the terms.
        vec3<Q> outward(cross(vec3<W>(scaled_u + scaled_twist * at.v), vec3<W>(scaled_v + scaled_twist * at.u)));
        vec3<Q> a(scaled_u), w(scaled_v), turn(scaled_twist);
        vec3<Q> aw = cross(a, w), at_u = cross(a, turn), at_v = cross(turn, w);
        vec3<Q> direction = normalize_from<T>(vec3<Q>(vec3<W>(ray.direction)));
        // The three are independent unless the patch is flat: only then the normal may vanish, at a corner without an
        // edge or on a fold, and is that of the plane. Much smaller than its terms it is rounding for the most part.
        if (norm1(outward) <= Q(0x1p12 * unit_roundoff<Q>) * (norm1(aw) + norm1(at_u) + norm1(at_v))) {
            const auto larger = [](const vec3<W>& x, const vec3<W>& y) { return norm1(x) < norm1(y) ? y : x; };
            outward = vec3<Q>(larger(cross(scaled_u, scaled_v),
                                     larger(cross(scaled_u, scaled_twist), cross(scaled_twist, scaled_v))));
            outward = outward * (copysign(Q(1), dot(outward, direction)) * Q(at.entering ? -1 : 1));
        }
        vec3<Q> facing = outward * choose(at.entering, Q(1), Q(-1));
        // Where rounding has turned it along the ray, it is mirrored.
        facing -= direction * (Q(2) * max(Q(0), dot(facing, direction)));
        record_point_between(corners(), ray, at, rec, T(size));
        rec.normal = vec3<N>(normalize_from<T>(facing));
        rec.uv = {max(T(0), min(T(1), T(at.u))), max(T(0), min(T(1), T(at.v)))};
    }

private:
    RAIO_FN constexpr std::array<vec3<T>, 4> corners_in_order() const { return {p00, p10, p11, p01}; }

    /// Which of the edges from each of these corners to the next it is, the first that there is; 4 if there is none.
    RAIO_FN constexpr std::size_t edge_without_length() const {
        const std::array<vec3<T>, 4> around = corners_in_order();
        std::size_t i = 0;
        while (i < 4 && around[i] != around[(i + 1) % 4]) ++i;
        return i;
    }

    /// A patch with an edge of no length, which is corner a of the triangle: the edge v = 0 if `turns` is 0, and so on
    /// around the patch.
    template <class W, real R>
    RAIO_FN static constexpr crossing_list<W, 2> cross_triangle(const triangle<T>& shape, std::size_t turns,
                                                                const ray<R>& ray) {
        crossing_list<W, 2> list;
        crossing<W> c = shape.template crossings<W>(ray);
        list.certain = c.certain;
        if (!c.exists) return list;
        list.append(c.t, c.error, c.entering);
        W away = c.u + c.v;
        vec2<W> uv(quotient(c.u, away, W(0)), away);
        for (std::size_t i = 0; i < turns; ++i) uv = {W(1) - uv.y, uv.x};
        list.crossings[0].u = uv.x, list.crossings[0].v = uv.y;
        return list;
    }

    template <class W, real R>
    RAIO_FN constexpr crossing_list<W, 2> cross_moving_line(const ray<R>& ray) const {
        using E = bound_t<W>;
        crossing_list<W, 2> list;
        const auto [edge_u, edge_v, far] = edges<W>();
        vec3<W> twist = far - edge_v, reach = abs(far) + abs(edge_v);
        vec3<W> d(ray.direction), corner = difference_as<W>(p00, ray.origin);

        // The vectors are off by two roundings at most, D by as many of its terms, and each sum of triple products by
        // 9 more.
        constexpr double roundoff = unit_roundoff<W>;
        const auto triple = [&](const vec3<W>& x, const vec3<W>& y) { return dot(d, cross(x, y)); };
        const auto bound = [&](const vec3<W>& x, const vec3<W>& y) {
            return E(12 * roundoff) * triple_product_bound(d, x, y);
        };
        polynomial<W, 2> f{
            {triple(corner, edge_v), triple(edge_u, edge_v) + triple(corner, twist), triple(edge_u, twist)},
            {bound(corner, edge_v), bound(edge_u, edge_v) + bound(corner, reach), bound(edge_u, reach)}};
        if (passes_by(f)) return list;
        W d2 = dot(d, d);
        const bool in_surface = abs(E(f.coefficient[0])) <= f.error[0] && abs(E(f.coefficient[1])) <= f.error[1] &&
                                abs(E(f.coefficient[2])) <= f.error[2];
        if (in_surface || !(d2 >= W(least_normal<W>))) {
            list.certain = false;
            return list;
        }

        E d_size = norm1(vec3<E>(d)), over_d2 = E(1) / E(d2), u_size = norm1(vec3<E>(edge_u)),
          reach_size = norm1(vec3<E>(reach)), corner_size = norm1(vec3<E>(corner));
        const auto roots = roots_between(f, W(-1), W(2));
        list.certain = roots.certain;
        bool may_start_here = false;  // on the patch, to a millionth of v
        for (const polynomial_root<W>& root : roots) {
            // Of a line that all but lies in the surface nobody knows where u is: not to a millionth of the patch.
            if (last_precision<W> && root.error > E(0x1p-20)) {
                list.certain = false;
                continue;
            }
            // From where the line starts and where it goes, and how far each may be off.
            vec3<W> start = corner + edge_u * root.t, along = edge_v + twist * root.t;
            E start_error = root.error * u_size + E(4 * roundoff) * (corner_size + E(2) * u_size);
            E along_error = root.error * norm1(vec3<E>(twist)) + E(16 * roundoff) * reach_size;
            vec3<W> m = cross(start, d), n = cross(along, d);
            E m_error = d_size * (start_error + E(4 * roundoff) * norm1(vec3<E>(start)));
            E n_error = d_size * (along_error + E(4 * roundoff) * norm1(vec3<E>(along)));
            E m_size = norm1(vec3<E>(m)), n_size = norm1(vec3<E>(n));

            W in_v = -dot(m, vec3<W>(m + n)), in_u = min(root.t, W(1) - root.t);
            E in_v_error = m_error * (E(2) * m_size + n_size + m_error + n_error) + m_size * n_error +
                           E(8 * roundoff) * m_size * (m_size + n_size);
            if (in_u < -tie<W>(root.error) || in_v < -tie<W>(in_v_error)) {
                list.certain = list.certain && (in_u < -root.error || in_v < -in_v_error);
                continue;
            }
            list.certain = list.certain && in_u > root.error && in_v > in_v_error;
            if (n_size <= n_error && norm1(vec3<E>(along)) > along_error) {  // the ray runs along the line
                list.certain = false;
                continue;
            }
            // (v - exact v) n is the error of m + v n.
            W v = max(W(0), min(W(1), quotient(-dot(m, n), dot(n, n), W(0))));
            E v_error =
                min(E(1), quotient(m_error + n_error, sqrt(dot(vec3<E>(n), vec3<E>(n))), E(1))) + E(16 * roundoff);
            W t = dot(d, vec3<W>(start + along * v)) / d2;
            E error = v_error * abs(dot(vec3<E>(d), vec3<E>(along))) + d_size * (start_error + along_error) +
                      E(8 * roundoff) * d_size * (corner_size + u_size + reach_size);
            error = error * over_d2;
            if (abs(E(t)) <= error) {
                const E here(quotient(-dot(start, along), dot(along, along), W(0))), about(0x1p-20);
                may_start_here = may_start_here || (here >= -about && here <= E(1) + about);
            }
            const std::size_t next = list.count;
            const E at_u_error = v_error * norm1(vec3<E>(twist)) + E(16 * roundoff) * (u_size + reach_size);
            list.append(t, error,
                        root.before * root.after > 0
                            ? along_ray(root, n, {vec3<W>(edge_u + twist * v), at_u_error}, {along, along_error})
                            : root);
            for (std::size_t i = next; i < list.count; ++i) list.crossings[i].u = root.t, list.crossings[i].v = v;
        }
        sort_by_t(list);
        if (may_start_here && lies_on(corner, ray.origin)) list.start_at_origin();
        return list;
    }

    /// A, w and w + D. The magnitudes of the two that D is the difference of bound what its roundings are parts of.
    template <class W>
    struct edge_vectors {
        vec3<W> edge_u, edge_v, far;
    };
    template <class W>
    RAIO_FN constexpr edge_vectors<W> edges() const {
        return {difference_as<W>(p10, p00), difference_as<W>(p01, p00), difference_as<W>(p11, p10)};
    }

    RAIO_FN constexpr aabb<T> corners() const { return hull(hull(hull(aabb<T>{p00, p00}, p10), p01), p11); }

    /// Does f have one sign from 0 to 1? It does where the coefficients of its Bernstein form have one.
    template <class W>
    RAIO_FN static constexpr bool passes_by(const polynomial<W, 2>& f) {
        using E = bound_t<W>;
        const auto& c = f.coefficient;
        E start(c[0]), middle(c[0] + c[1] * W(0.5)), end(c[0] + c[1] + c[2]);
        E size = abs(E(c[0])) + abs(E(c[1])) + abs(E(c[2]));
        E error = f.error[0] + f.error[1] + f.error[2] + E(4 * unit_roundoff<W>) * size;
        return min(min(start, middle), end) > error || max(max(start, middle), end) < -error;
    }

    /// A root that is touched, with the signs of f in the order in which the ray comes by: d = (du's part) du + ...,
    /// and that part has the sign of (d x w).(du x w). On the fold of a planar patch du x w is zero, and u's order
    /// stays.
    template <class W>
    RAIO_FN static constexpr polynomial_root<W> along_ray(polynomial_root<W> root, const vec3<W>& n,
                                                          const bounded_vector<W>& du, const bounded_vector<W>& w) {
        using E = bound_t<W>;
        vec3<W> turn = cross(du.value, w.value);
        E error = norm1(vec3<E>(du.value)) * w.error + (norm1(vec3<E>(w.value)) + w.error) * du.error;
        if (dot(n, turn) > W(error * norm1(vec3<E>(n)))) root.before = -root.before, root.after = -root.after;
        return root;
    }

    template <class W>
    RAIO_FN static constexpr void sort_by_t(crossing_list<W, 2>& list) {
        if (list.count < 2) return;
        auto& [first, second] = list.crossings;
        bound_t<W> apart(second.t - first.t), error = first.error + second.error;
        list.certain = list.certain && abs(apart) > error;
        if (apart < -error) {
            std::swap(first, second);
        } else if (apart < error) {
            second.t = first.t;
        }
    }

    /// Is the ray's origin on the surface through the corners, the first of which is `a` as seen from there? Its
    /// barycentric coordinates in the tetrahedron of the corners are then (1 - u) (1 - v), u (1 - v), (1 - u) v and u
    /// v.
    template <class W, real R>
    RAIO_FN constexpr bool lies_on(const vec3<W>& a, const vec3<R>& origin) const {
        vec3<W> b = difference_as<W>(p10, origin), c = difference_as<W>(p01, origin), e = difference_as<W>(p11, origin);
        W w00 = dot(b, cross(c, e)), w10 = dot(a, cross(c, e)), w01 = dot(a, cross(b, e)), w11 = dot(a, cross(b, c)),
          zero(0);
        if (w00 - w10 + w01 == w11) return w00 == zero && w10 == zero && w01 == zero;  // then w11 is as well
        return w00 * w11 == w10 * w01;
    }
};

}  // namespace raio
