#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/formula/quadric.hpp>
#include <raio/proof/normal.hpp>
#include <raio/surface_sample.hpp>

/// \file
/// The frustum, a cone cut off across its axis: with its caps it is a solid, without them a funnel.
///
/// From the end with the lesser radius r on, with the other radius r + w and the height h = 0 to 1, the side is at rho
/// = r + w h from the axis: rho^2 = r^2 + 2 r w h + w^2 h^2, a quadric of revolution, for which see
/// formula/quadric.hpp. As a perfect square it has no discriminant, (r w)^2 - r^2 w^2 = 0. It has a second nappe, the
/// half of the double cone beyond its apex. A line that is steeper than the generators, the straight lines on it
/// through the apex, crosses both nappes, and is inside of this one from its crossing on, in the direction in which the
/// radius grows.
///
/// Faces are counted side, base, top. uv of the side: u is the angle about the axis in turns, from the x axis of
/// `frame_about(top - base)`; v the height, 0 at the base and 1 at the top. uv of a cap: the same u, and v the distance
/// from the axis over the cap's radius.

namespace raio::inline RAIO_ABI {

namespace detail {

/// Of a line's two parts in a cone, the one in the nappe that grows along the axis.
/// \param along  how fast the line runs that way
template <class W>
RAIO_FN constexpr chord<W> one_nappe(const hollow_chord<W>& c, const bounded_number<W>& along) {
    const mask_t<W> forward = every(c.hollow, is_positive(along).yes), back = every(c.hollow, !forward);
    chord<W> nappe{select(forward, c.ends.far, c.ends.near), select(back, c.ends.near, c.ends.far)};
    nappe.near.t = select(back, -infinity<W>, nappe.near.t), nappe.far.t = select(forward, infinity<W>, nappe.far.t);
    nappe.near.entering = W(0) == W(0), nappe.far.entering = W(0) != W(0);
    return nappe;
}

/// The chord through the one nappe, endless at its wide end.
/// \param l     from the point where the line has t = 0 to the end with the lesser radius
/// \param axis  from there to the end with the greater one
template <class Line, real T, proven_vector L, proven_vector A>
RAIO_FN constexpr auto cross_nappe(const Line& line, const L& l, const A& axis, const T& lesser, const T& greater) {
    using W = typename Line::number;
    auto r = line.given(lesser);
    auto widening = line.between(lesser, greater);
    auto d = line.direction();
    zero_number<W> zero;
    turned_conic side{r * r, r * widening, widening * widening, zero};
    chord<W> c = one_nappe(cross_quadric(d, l, axis, side, line.given(greater)), dot(d, axis));
    keep_if(every(lesser >= T(0), greater >= T(0)), c);
    return c;
}
template <class Line, real T>
RAIO_FN constexpr auto cross_nappe(const vec3<T>& base, const vec3<T>& top, const vec2<T>& radii, const Line& line) {
    const mask_t<T> turned = radii.y < radii.x;
    const vec3<T> low = select(turned, top, base), high = select(turned, base, top);
    return cross_nappe(line, line.to(low), line.between(low, high), select(turned, radii.y, radii.x),
                       select(turned, radii.x, radii.y));
}

/// Outwards across the side, of any length.
/// \param axis       from the end with the first radius to that with the second one
/// \param from_axis  to the point, which is at this height: 0 and 1 at the ends
template <class Point, class W, real T>
RAIO_FN constexpr vec3<W> frustum_gradient(const Point& at, const vec3<W>& axis, const vec2<T>& radii,
                                           const vec3<W>& from_axis, const W& height) {
    W axis2 = dot(axis, axis), r(radii.x), widening = W(radii.y) - r;
    vec3<W> outward = from_axis - axis * (widening * (r + widening * height) / axis2);
    return turned_at_apex(at, axis, widening, from_axis, outward);
}

}  // namespace detail

/// The points between two discs across one axis: a solid; or, if it is not `Closed`, only the side, rims included,
/// which is hit from both sides.
template <real T, bool Closed = true>
struct frustum {
    using number = T;

    vec3<T> base, top;          ///< the centres of both ends
    T base_radius, top_radius;  ///< lengths; the frustum is missed unless one is positive and none is negative

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr interval<T> spans(const ray<T>& ray) const requires(Closed) { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const { return detail::axial_bounds(base, top, radii()); }

    RAIO_FN constexpr T area() const { return detail::axial_area<Closed>(side()); }

    /// u.x turns about the axis, u.y is the area between the base and the point. If it is closed, u.x first chooses
    /// among the side, the base and the top, and what is left of it is the angle.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const
        requires(!Closed || std::same_as<mask_t<T>, bool>) {
        return detail::axial_sample<Closed>(side(), u);
    }

    template <class Line>
    RAIO_FORMULA constexpr chord<typename Line::number> crossings(const Line& line) const {
        auto endless = detail::cross_nappe(base, top, radii(), line);
        return detail::between_caps<Closed>(endless, base, top, line);
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        vec3<W> axis = difference_as<W>(top, base);
        detail::axial_surface(at, base, top, radii(), max(base_radius, top_radius) + norm1(vec3<T>(axis)),
                              [&](const vec3<W>& from_axis, const W& height) {
                                  return detail::frustum_gradient(at, axis, radii(), from_axis, height);
                              });
        at.keep_in([this] { return bounds(); });
    }

    template <class Point>
    RAIO_FN constexpr auto is_close_to_tip(const Point& at) const {
        return is_close_to_axis(at, base, difference_as<typename Point::number>(top, base), T(1));
    }

private:
    RAIO_FN constexpr detail::frustum_side<T> side() const { return {base, top, radii()}; }
    RAIO_FN constexpr vec2<T> radii() const { return {base_radius, top_radius}; }
};

/// The side alone.
template <real T>
using open_frustum = frustum<T, false>;

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
