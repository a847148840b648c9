#pragma once

#include <raio/push_macros.hpp>

#include <array>
#include <tuple>
#include <utility>

#include <raio/concepts.hpp>
#include <raio/proof/crossing_list.hpp>
#include <raio/proof/line.hpp>
#include <raio/shape/triangle.hpp>

namespace raio::inline RAIO_ABI {

/// The surface through four corners, which need not lie in one plane: where u goes from 0 to 1, a straight line moves
/// from the edge p00 p01 to the edge p10 p11. Its front is the side from which the turn from u to v is
/// counter-clockwise.
///
/// As seen from the ray's origin that line runs from a(u) = a + u A to a(u) + w(u), with w(u) = w + u D, where A = p10
/// - p00, w = p01 - p00, D = p11 - p10 - w. The ray and the line lie in one plane where
///
///     f(u) = w(u).(d x a(u)) = w.(d x a) + u (D.(d x a) + w.(d x A)) + u^2 D.(d x A)
///
/// is zero (Reshetov, Ray Tracing Gems ch. 8, 2019). They cross at the point
///
///     t d = a(u) + v w(u):    m + v n = 0,    t = (a(u) + v w(u)).d / d.d,    m = d x a(u),    n = d x w(u)
///
/// which lies between both ends of the line, 0 <= v <= 1, if |2 m + n| <= |n|. (Any component of m and n says the
/// same.) f' = d.(du x dv), with the derivatives du = A + v D and dv = w(u), says from which side the ray comes; u
/// grows along the ray where (d x dv).(du x dv) > 0.
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

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr aabb<T> bounds() const { return unless_nan(padded(corners()), p00, p10, p01, p11); }

    template <class Line>
    RAIO_FORMULA constexpr crossing_list<typename Line::number, 2> crossings(const Line& line) const {
        const std::size_t i = edge_without_length();
        if (i == 4) return cross_moving_line(line);
        const std::array<vec3<T>, 4> around = corners_in_order();
        return cross_triangle(triangle<T>{around[i], around[(i + 2) % 4], around[(i + 3) % 4]}, i, line);
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        using Q = typename Point::precise;
        const W &u = at.crossing().u, &v = at.crossing().v;
        // A, w and w + D. The magnitudes of the two that D is the difference of bound what its roundings are parts of.
        vec3<W> edge_u = difference_as<W>(p10, p00), edge_v = difference_as<W>(p01, p00);
        vec3<W> far = difference_as<W>(p11, p10), twist = far - edge_v, reach = abs(far) + abs(edge_v);
        // What floats make has room in double as it is; to scale it would lose a short edge beside a long one.
        W quarter(0.25), size = norm1(edge_u * quarter) + norm1(reach * quarter),
                         scale = has_room_for<T, W> ? W(1) : quarter / size;
        vec3<W> scaled_u = edge_u * scale, scaled_v = edge_v * scale, scaled_twist = twist * scale;
        // In all digits of W, here and below: on a sliver or beside a fold the two have nearly one direction, and
        // little is left of the terms.
        vec3<Q> outward(cross(vec3<W>(scaled_u + scaled_twist * v), vec3<W>(scaled_v + scaled_twist * u)));
        vec3<Q> a(scaled_u), w(scaled_v), turn(scaled_twist);
        vec3<Q> aw = cross(a, w), at_u = cross(a, turn), at_v = cross(turn, w);
        vec3<Q> direction = normalize_from<T>(vec3<Q>(at.direction()));
        const Q side(at.entering() ? 1 : -1);
        // The three are independent unless the patch is flat: only then the normal may vanish, at a corner without an
        // edge or on a fold, and is that of the plane.
        if (is_mostly_rounding(outward, norm1(aw) + norm1(at_u) + norm1(at_v))) {
            const auto larger = [](const vec3<W>& x, const vec3<W>& y) { return norm1(x) < norm1(y) ? y : x; };
            outward = vec3<Q>(larger(cross(scaled_u, scaled_v),
                                     larger(cross(scaled_u, scaled_twist), cross(scaled_twist, scaled_v))));
            outward = outward * (copysign(Q(1), dot(outward, direction)) * -side);
        }
        outward = mirrored_against(outward, direction, side);
        at.record_point(T(size));
        at.keep_between(corners());
        at.record_normal(outward);
        at.record_uv([&] { return vec2<T>(max(T(0), min(T(1), T(u))), max(T(0), min(T(1), T(v)))); });
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
    template <class Line>
    RAIO_FN static constexpr auto cross_triangle(const triangle<T>& shape, std::size_t turns, const Line& line) {
        using W = typename Line::number;
        auto c = shape.crossings(line);
        const W away = c.u + c.v;
        c.u = quotient(c.u, away, W(0)), c.v = away;
        for (std::size_t i = 0; i < turns; ++i) std::tie(c.u, c.v) = std::pair(W(1) - c.v, c.u);
        crossing_list<W, 2> list(c.certain);
        if (c.exists) list.append(c);
        return list;
    }

    template <class Line>
    RAIO_FN constexpr auto cross_moving_line(const Line& line) const {
        using W = typename Line::number;
        const auto a = line.to(p00);
        const auto edge = line.between(p00, p10);
        const auto w = line.between(p00, p01);
        const auto twist = line.between(p10, p11) - w;
        const auto d = line.direction();
        const auto half = line.given(T(0.5));
        const auto of_a = cross(d, a);
        const auto of_edge = cross(d, edge);
        const auto f = polynomial_of(dot(w, of_a), dot(twist, of_a) + dot(w, of_edge), dot(twist, of_edge));
        crossing_list<W, 2> list;
        if (has_one_sign(f)) return list;

        const auto roots = known_roots_between(f, W(-0.125), W(1.125));
        const auto d2 = square(d);
        list.depends_on(roots);
        for (const polynomial_root<W>& root : roots) {
            const auto u = root.place();
            const auto is_on_way = abs(u - half) <= half;
            if (all(!is_on_way)) continue;
            const auto from = a + edge * u;
            const auto along = w + twist * u;
            const auto m = cross(d, from);
            const auto n = cross(d, along);
            const auto size = norm1(n);
            const auto is_between = every(is_on_way, norm1(m + m + n) <= size);
            if (all(!is_between)) continue;
            // A ray that runs along the line lies in the surface, unless the line is a point.
            auto crosses = is_positive(size);
            if (!all(crosses)) crosses = some(crosses, !is_positive(square(along)));
            const auto v = held_between(-ratio(m, n), W(0), W(1));
            const auto t = (dot(from, d) + v * dot(along, d)) * inverse(d2);
            // Where f only touches zero, the line is crossed twice: in the order of u, or against it.
            const bool backwards = root.is_touched() && is_positive(-dot(n, cross(edge + twist * v, along))).yes;
            const auto exists = every(is_between, crosses, is_positive(d2));
            list.depends_on(exists);
            if (!answer_of<W>(exists)) continue;
            crossing<W> c = crossing_at(t);
            c.u = u.value, c.v = v.value;
            list.append(c, backwards ? -root : root);
        }
        sort_by_t(list);
        start_on_surface(list, [&] { return holds_origin(line).yes; });
        return list;
    }

    /// Is the ray's origin on the patch? Its barycentric coordinates in the tetrahedron of the corners are then (1 - u)
    /// (1 - v), u (1 - v), (1 - u) v and u v. They are zero if all are in one plane: then it is where the ray crosses
    /// that.
    template <class Line>
    RAIO_FN constexpr verdict<bool> holds_origin(const Line& line) const {
        const auto a = line.to(p00);
        const auto b = line.to(p10);
        const auto c = line.to(p01);
        const auto e = line.to(p11);
        const auto ce = cross(c, e);
        const auto ab = cross(a, b);
        const auto w00 = dot(b, ce);
        const auto w10 = -dot(a, ce);
        const auto w01 = dot(e, ab);
        const auto w11 = -dot(c, ab);
        const auto u = w10 + w11;
        const auto v = w01 + w11;
        const auto all = w00 + w10 + v;
        const auto half = line.given(T(0.5));
        const auto product = w00 * w11;
        const auto other = w10 * w01;
        const auto within = [&](const auto& x) { return abs(x - all * half) <= abs(all) * half; };
        return every(product <= other, product >= other, within(u), within(v));
    }

    RAIO_FN constexpr aabb<T> corners() const {
        return hull_of_numbers(hull_of_numbers(aabb<T>{p00, p00}, p10), hull_of_numbers(aabb<T>{p01, p01}, p11));
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
