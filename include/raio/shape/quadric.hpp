#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/formula/axis.hpp>
#include <raio/formula/quadric.hpp>
#include <raio/proof/crossing_list.hpp>
#include <raio/shape/box.hpp>

namespace raio::inline RAIO_ABI {

/// The points of a box at which a polynomial of degree 2
///
///     f = squares.(x^2, y^2, z^2) + products.(yz, zx, xy) + linear.(x, y, z) + constant
///
/// is zero or below: a solid that the faces of the box close, or, if it is not `Closed`, only the surface f = 0 as far
/// as it lies in the box. As a symmetric matrix (Blinn, The Algebraic Properties of Homogeneous Second Order Surfaces,
/// 1984) f has the squares and the constant on the diagonal, and half of the others beside it.
///
/// Whatever the matrix is, it is a surface: ellipsoids and paraboloids, cylinders and cones with elliptic sections,
/// hyperboloids, two planes, one, or none. A cone's tip, where the gradient of f vanishes, has the normal against the
/// ray. x, y, z and uv are as for `algebraic`.
template <real T, bool Closed = true>
struct quadric {
    using number = T;

    vec3<T> min, max;  ///< opposite corners of the box; missed unless each size is positive
    vec3<T> squares{T(0)}, products{T(0)}, linear{T(0)};
    T constant{0};  ///< missed if all ten are zero

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr raio::spans<T, 2> spans(const ray<T>& ray) const requires(Closed) {
        return inside_of(*this, ray);
    }

    RAIO_FN constexpr aabb<T> bounds() const {
        return unless_nan(padded(aabb<T>{min, max}), min, max, squares, products, linear, constant);
    }

    /// f at a point.
    template <class W>
    RAIO_FN constexpr W value(const vec3<W>& p) const {
        return dot(p, times(p) + vec3<W>(linear)) + W(constant);
    }

    template <class W>
    RAIO_FN constexpr vec3<W> gradient(const vec3<W>& p) const {
        return times(p) * W(2) + vec3<W>(linear);
    }

    template <class Line, class Wanted = every_crossing>
    RAIO_FORMULA constexpr auto crossings(const Line& line, [[maybe_unused]] const Wanted& wanted = {}) const {
        using W = typename Line::number;
        auto clip = box<T>{min, max}.crossings(line);
        const index_t<W> first_of_box(1);
        clip.near.face = clip.near.face + first_of_box, clip.far.face = clip.far.face + first_of_box;
        if constexpr (Closed) {
            if (missed(clip)) return nowhere_at_all(clip, wanted);
            return intersect(cross_endless(line), clip, wanted);
        } else {
            if (missed(clip)) return clip;
            return cut<false>(cross_endless(line).ends, clip);
        }
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        at.record_point(norm1(max - min));
        const auto axis = at.face() - index_t<typename Point::number>(1);
        detail::clipped_surface(at, aabb<T>{min, max}, axis, [&](const auto& p) { return gradient(p); });
    }

private:
    /// The matrix of the second degree times a vector.
    template <class W>
    RAIO_FN constexpr vec3<W> times(const vec3<W>& p) const {
        vec3<W> s(squares), half = vec3<W>(products) * W(0.5);
        return {s.x * p.x + half.y * p.z + half.z * p.y, s.y * p.y + half.z * p.x + half.x * p.z,
                s.z * p.z + half.x * p.y + half.y * p.x};
    }

    /// Where the line is inside of what the box does not cut off.
    ///
    /// The line is seen from a place of it near the box, in steps as long as the box is large, and f in parts of the
    /// size that its terms have there: so nothing here is beyond the range of numbers. Which place, step and part that
    /// is, does not matter. With a place p and a step s it is f(p + x s) = a x^2 - 2 b x + c, where
    ///
    ///     a = s.M s,   b = -(p.M s + linear.s / 2),   c = f(p)
    template <class Line>
    RAIO_FN constexpr auto cross_endless(const Line& line) const {
        using W = typename Line::number;
        using E = bound_t<W>;
        // What is close to the origin of a line that starts near the box keeps its digits. Others are seen from where
        // they are nearest to its centre. All of the box lies between x = -4 and 4.
        const auto origin = line.origin();
        const auto direction = line.direction();
        const vec3<W> o(origin.x, origin.y, origin.z), d(direction.x, direction.y, direction.z);
        const vec3<W> low(min), high(max), center = (low + high) * W(0.5);
        const vec3<W> away = abs(center - o), wide = (high - low) * W(0.625);
        const mask_t<W> starts_near = every(away.x <= wide.x, away.y <= wide.y, away.z <= wide.z);
        const W over_speed = quotient(W(1), norm1(d), W(0)), size = norm1(high - low);
        const vec3<W> e = d * over_speed;
        const W nearest = quotient(raio::dot(center - o, e), raio::dot(e, e), W(0)) * over_speed;
        const E far = norm1(vec3<E>(center)) + E(size);
        const auto place = line.given(select(starts_near, W(0), nearest));
        const auto unit = line.given(W(E(size) * E(over_speed)));
        // A bound of f's terms no farther away than that.
        const auto sizes = [](const vec3<T>& v) { return norm1(vec3<E>(vec3<W>(v))); };
        const E terms = ((sizes(squares) + sizes(products)) * far + sizes(linear)) * far + abs(E(W(constant)));
        const auto part = line.given(W(quotient(E(1), terms, E(0))));

        const auto diagonal = line.given(squares) * part;
        const auto beside = line.given(products) * part;
        const auto first = line.given(linear) * part;
        const auto zeroth = line.given(constant) * part;
        const auto half = line.given(W(0.5));
        const auto f = [&](const auto& p) {
            return symmetric_product(diagonal, beside, p, p) + raio::dot(first, p) + zeroth;
        };
        const auto p = origin + direction * place;
        const auto step = direction * unit;
        const auto a = symmetric_product(diagonal, beside, step, step);
        const auto b = -(symmetric_product(diagonal, beside, p, step) + half * raio::dot(first, step));
        const auto c = f(p);
        const auto sound = every(is_positive(line.given(wide.x)), is_positive(line.given(wide.y)),
                                 is_positive(line.given(wide.z)), is_positive(part), is_positive(unit));
        hollow_chord<W> inside = where_below_zero(
            a, b, square(b) - a * c, sound, W(0) != W(0), [&] { return c; }, [] { return E(4); });
        move_on(inside, place, unit, [&] { return f(origin); });
        return inside;
    }
};

/// The surface alone.
template <real T>
using open_quadric = quadric<T, false>;

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
