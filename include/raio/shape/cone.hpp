#pragma once

#include <raio/push_macros.hpp>

#include <raio/shape/frustum.hpp>

/// \file
/// The cone: with its base it is a solid, without it a funnel. The apex belongs to it; its normal is the axis.
///
/// With the axis A from the apex down to the base, a point p of the cone, as seen from the apex, is at the height h =
/// p.A / A.A, 0 at the apex and 1 at the base, and at the distance rho = radius h from the axis: rho^2 = radius^2 h^2.
/// This is a quadric of revolution about the apex with c0 = c1 = 0 and c2 = radius^2 (see formula/quadric.hpp), so that
/// with l = apex - origin and m = l x d
///
///     a x^2 - 2 b x + c = 0,   k = radius^2 / A.A
///     b^2 - a c = A.A (radius^2 m.m - (1 + k) (m.A)^2) = radius^2 |m x A|^2 - A.A (m.A)^2
///
/// That has a meaning: m is the normal of the plane through the apex and the line. The line meets the cone if this
/// plane does elsewhere than at the apex: if |m.A| / |m x A|, the tangent of the plane's angle with the axis, is no
/// more than radius / |A|, that of a generator's.
///
/// h^2 has forgotten the sign of h: there is a second nappe beyond the apex, and the plane of the apex cuts it off. A
/// line that is steeper than the generators crosses both, each once, and is inside of ours from its crossing on, down
/// the axis. One that is less steep crosses the same nappe twice. One that is parallel to a generator crosses once.
///
/// What it records is what a frustum does whose upper radius is 0. Faces are counted side, base. uv of the side: u is
/// the angle about the axis, from the x axis of `frame_about(axis)`; v the height, 0 at the base and 1 at the apex. uv
/// of the base: the same u, and v the distance from the axis over the radius.

namespace raio {

namespace detail {

/// The chord through the nappe that widens from the apex towards the base, and on.
template <class Line, real T>
RAIO_FN constexpr auto cross_endless_cone(const vec3<T>& base, const vec3<T>& apex, const T& radius, const Line& line) {
    const auto r = line.given(radius);
    const auto d = line.direction();
    const auto axis = line.between(apex, base);
    const zero_number<typename Line::number> zero;
    const turned_conic nappes{zero, zero, r * r, zero};  // c0, c1, c2 and c1^2 - c0 c2
    return one_nappe(cross_quadric(d, line.to(apex), axis, nappes, r), dot(d, axis));
}

}  // namespace detail

/// The points between a disc and an apex over its centre: a solid; or, if it is not `Closed`, only the side, up to its
/// rim, which belongs to it, seen from both sides.
template <real T, bool Closed = true>
struct cone {
    using number = T;

    vec3<T> base;  ///< the centre of the base
    vec3<T> apex;
    T radius;  ///< of the base; the cone is missed unless it is positive and base and apex differ

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr interval<T> spans(const ray<T>& ray) const requires(Closed) { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const { return as_frustum().bounds(); }

    RAIO_FN constexpr T area() const { return as_frustum().area(); }

    /// u.x turns about the axis, u.y is the area between the base and the point. With its base, u.x chooses between the
    /// side and that first, and what is left of it is the angle.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const
        requires(!Closed || std::same_as<mask_t<T>, bool>) {
        return as_frustum().sample(u);
    }

    template <class Line>
    RAIO_FORMULA constexpr chord<typename Line::number> crossings(const Line& line) const {
        auto endless = detail::cross_endless_cone(base, apex, radius, line);
        if (missed(endless)) return endless;
        auto c = cut<Closed>(endless, detail::cross_cap_planes(base, apex, line));
        keep_if_in_range<T>(line, c);
        return c;
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        as_frustum().surface(at);
    }

    template <class Point>
    RAIO_FN constexpr auto is_close_to_tip(const Point& at) const {
        return as_frustum().is_close_to_tip(at);
    }

private:
    RAIO_FN constexpr frustum<T, Closed> as_frustum() const { return {base, apex, radius, T(0)}; }
};

/// The side alone.
template <real T>
using open_cone = cone<T, false>;

}  // namespace raio

#include <raio/pop_macros.hpp>
