#pragma once

#include <raio/push_macros.hpp>

#include <raio/shape/frustum.hpp>

/// \file
/// The cone: with its base it is a solid, without it a funnel. The apex belongs to it; its normal is the axis, away
/// from the base, less what would face away from the ray (proof/normal.hpp).
///
/// With the axis A from the apex down to the base, a point p of the cone, as seen from the apex, is at the height h =
/// p.A / A.A, 0 at the apex and 1 at the base, and at the distance rho = radius h from the axis: rho^2 = radius^2 h^2.
/// This is a quadric of revolution about the apex with c0 = c1 = 0 and c2 = radius^2. So formula/quadric.hpp says where
/// the line crosses it, by tau, which is t counted from where the line is nearest to the apex. With the ray's direction
/// d, l from its origin to the apex, the moment m = l x d and k = radius^2 / A.A,
///
///     a tau^2 - 2 b tau + c = 0
///     b^2 - a c = A.A (radius^2 m.m - (1 + k) (m.A)^2) = radius^2 |m x A|^2 - A.A (m.A)^2
///
/// The code has the first of these two; the last one has a meaning. m is the normal of the plane through the apex and
/// the line, and |m.A| / |m x A| the tangent of that plane's angle with the axis. The line meets the double cone if and
/// only if the plane has more of it than the apex: if that tangent is no more than radius / |A|, that of a generator's
/// angle. (The generators are the straight lines on the cone, through the apex.)
///
/// h^2 has forgotten the sign of h: there is a second nappe, the half of the double cone beyond the apex. `one_nappe`
/// drops it. A line that is steeper than the generators crosses both nappes, each once, and is inside of ours from its
/// crossing on, down the axis. One that is less steep crosses the same nappe twice, or none. One that is parallel to a
/// generator crosses once.
///
/// What it records is what a frustum does whose upper radius is 0. Faces are counted side, base. uv of the side: u is
/// the angle about the axis in turns, from the x axis of `frame_about(apex - base)`; v = 1 - h, 0 at the base and 1 at
/// the apex. uv of the base: the same u, and v the distance from the axis over the radius.

namespace raio::inline RAIO_ABI {

/// The points between a disc and an apex over its centre: a solid; or, if it is not `Closed`, only the side, rim
/// included, which is hit from both sides.
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

    /// u.x turns about the axis, u.y is the area between the base and the point. If it is closed, u.x first chooses
    /// side or base, and what is left of it is the angle.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const
        requires(!Closed || std::same_as<mask_t<T>, bool>) {
        return as_frustum().sample(u);
    }

    /// Where the ray's line enters and where it leaves. Numbers carry bounds of their errors (proof/line.hpp), and
    /// whether a comparison of them holds may be in doubt: `every` and `some` combine such verdicts, `all` asks whether
    /// one holds beyond doubt, `any` whether it may hold (number/verdict.hpp).
    template <class Line>
    RAIO_FORMULA constexpr chord<typename Line::number> crossings(const Line& line) const {
        const auto r = line.given(radius);
        const auto d = line.direction();
        const auto axis = line.between(apex, base);
        const zero_number<typename Line::number> zero;
        const turned_conic nappes{zero, zero, r * r, zero};  // c0, c1, c2 and c1^2 - c0 c2, of both nappes
        auto endless = detail::one_nappe(cross_quadric(d, line.to(apex), axis, nappes, r), dot(d, axis));
        return detail::between_caps<Closed>(endless, base, apex, line);
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

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
