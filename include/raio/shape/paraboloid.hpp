#pragma once

#include <raio/push_macros.hpp>

#include <cmath>

#include <raio/concepts.hpp>
#include <raio/formula/quadric.hpp>

/// \file
/// The paraboloid of revolution: with its cap it is a solid, without it a dish.
///
/// With the height h, 0 at the vertex and 1 at the top, the side is at the distance rho from the axis, rho^2 = radius^2
/// h: a quadric of revolution, for which see formula/quadric.hpp. A line parallel to the axis crosses it once.
///
/// Faces are counted side, (none), top. uv of the side: u is the angle about the axis in turns, from the x axis of
/// `frame_about(top - vertex)`; v the height. uv of the cap: the same u, and v the distance from the axis over the
/// radius.

namespace raio::inline RAIO_ABI {

namespace detail {

/// The side, to be sampled.
template <real T>
struct paraboloid_side {
    vec3<T> base, top;
    vec2<T> radii;

    RAIO_FN constexpr T area() const {
        // pi radius / (6 axis^2) (q^3 - radius^3) with q^2 = radius^2 + 4 axis^2, divided by q - radius.
        const vec3<T> axis = top - base;
        const T radius = radii.y, r2 = radius * radius, q2 = r2 + T(4) * dot(axis, axis), q = sqrt(q2);
        return T(2 * pi<T> / 3) * radius * (q2 + q * radius + r2) / (q + radius);
    }

    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        // With k = 1 + 4 axis^2 / radius^2 the area below a height h is as (1 + (k - 1) h)^(3/2) - 1. Of the c whose
        // cube is 1 + s, c - 1 is written as a quotient without a difference, and so is k^(3/2) - 1.
        const T slender = T(2) * length(top - base) / radii.y, k = T(1) + slender * slender, q = sqrt(k);
        const T per_k = u.y * (k + q + T(1)) / (q + T(1)), c = std::cbrt(T(1) + per_k * slender * slender);
        const T height = min(T(1), per_k * (c + T(1)) / (c * c + c + T(1))), root = sqrt(height);
        return point_about_axis(base, top, u.x, height, root * radii.y, {slender * root, T(-1)});
    }
};

}  // namespace detail

/// The points between a paraboloid of revolution and a disc across its axis: a solid; or, if it is not `Closed`, only
/// the side, rim included, which is hit from both sides.
template <real T, bool Closed = true>
struct paraboloid {
    using number = T;

    vec3<T> vertex, top;  ///< the lowest point, and the centre of the other end
    T radius;             ///< there; the paraboloid is missed unless it is positive and vertex and top differ

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr interval<T> spans(const ray<T>& ray) const requires(Closed) { return inside_of(*this, ray); }

    /// Around the curve h axis + sqrt(h) reach, whose highest point is inside of the paraboloid's ends where the axis
    /// goes down steeply enough.
    RAIO_FN constexpr aabb<T> bounds() const {
        vec3<T> axis = top - vertex, reach = disc_reach(axis, radius);
        const auto highest = [](const T& rise, const T& r) {
            const T bulge = quotient(r * r, T(-4) * rise, T(0)) * T(1 + 8 * unit_roundoff<T>);
            return select(T(2) * rise + r < T(0), bulge, max(T(0), rise + r));
        };
        vec3<T> up(highest(axis.x, reach.x), highest(axis.y, reach.y), highest(axis.z, reach.z));
        vec3<T> down(highest(-axis.x, reach.x), highest(-axis.y, reach.y), highest(-axis.z, reach.z));
        vec3<T> rounding(norm1(axis) * T(2 * unit_roundoff<T>));
        return unless_nan(padded(aabb<T>{vertex - (down + rounding), vertex + (up + rounding)}), vertex, top, radius);
    }

    RAIO_FN constexpr T area() const { return detail::axial_area<Closed>(side()); }

    /// u.x turns about the axis, u.y is the area between the vertex and the point. With its cap, u.x first chooses
    /// between the side and that, and what is left of it is the angle.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const requires(std::floating_point<T>) {
        return detail::axial_sample<Closed>(side(), u);
    }

    template <class Line>
    RAIO_FORMULA constexpr chord<typename Line::number> crossings(const Line& line) const {
        const auto r = line.given(radius);
        const auto c1 = line.given(T(0.5)) * (r * r);
        const zero_number<typename Line::number> zero;
        const turned_conic side{zero, c1, zero, c1 * c1};  // c0, c1, c2 and c1^2 - c0 c2
        auto endless = cross_quadric(line.direction(), line.to(vertex), line.between(vertex, top), side, r).ends;
        if (missed(endless)) return endless;
        auto c = cut<Closed>(endless, detail::cross_upper_plane(vertex, top, line));
        keep_if_in_range<T>(line, c);  // no point beyond the largest number
        return c;
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        vec3<W> axis = difference_as<W>(top, vertex);
        vec3<W> down = axis * (W(0.5) * W(radius) * W(radius) / dot(axis, axis));
        detail::axial_surface(at, vertex, top, vec2<T>(T(0), radius), radius + norm1(vec3<T>(axis)),
                              [&](const vec3<W>& from_axis, const W&) { return from_axis - down; });
        at.keep_in([this] { return bounds(); });
    }

private:
    RAIO_FN constexpr detail::paraboloid_side<T> side() const { return {vertex, top, vec2<T>(T(0), radius)}; }
};

/// The side alone.
template <real T>
using open_paraboloid = paraboloid<T, false>;

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
