#pragma once

#include <raio/push_macros.hpp>

#include <raio/formula/plane.hpp>
#include <raio/math/angle.hpp>
#include <raio/math/frame.hpp>
#include <raio/proof/line.hpp>
#include <raio/proof/settle.hpp>
#include <raio/surface_sample.hpp>

/// \file
/// What the shapes about an axis share: they stand between the two planes across its ends, and their faces are counted
/// side, base, top.

namespace raio::inline RAIO_ABI::detail {

/// The chord through the slab between two planes across the axis.
/// \param to_base, to_top  how far each plane is along the axis from the point where t = 0, times the axis' length
template <class W, proven_vector A, proven_vector D>
RAIO_FN constexpr chord<W> cross_slab(const A& axis, const bounded_number<W>& to_base, const bounded_number<W>& to_top,
                                      const D& d) {
    const auto speed = dot(axis, d);
    const mask_t<W> upward = !(speed.value < W(0));
    const index_t<W> base_face(1), top_face(2);
    chord<W> c = cross_between(to_base, to_top, speed);
    c.near.face = select(upward, base_face, top_face), c.far.face = select(upward, top_face, base_face);
    return c;
}

/// The chord through the slab between the two planes that the caps lie in.
template <class Line, real T>
RAIO_FN constexpr auto cross_cap_planes(const vec3<T>& base, const vec3<T>& top, const Line& line) {
    const auto axis = line.between(base, top);
    return cross_slab(axis, dot(axis, line.to(base)), dot(axis, line.to(top)), line.direction());
}

/// What the planes of the caps leave of a chord that goes on beyond them: of a solid the part between them, of a side
/// alone those ends that are.
template <bool Closed, class W, class Line, real T>
RAIO_FN constexpr chord<W> between_caps(const chord<W>& endless, const vec3<T>& base, const vec3<T>& top,
                                        const Line& line) {
    if (missed(endless)) return endless;
    auto c = cut<Closed>(endless, cross_cap_planes(base, top, line));
    keep_if_in_range<T>(line, c);  // no point beyond the largest number
    return c;
}

/// The chord below the plane of the upper cap alone.
template <class Line, real T>
RAIO_FN constexpr auto cross_upper_plane(const vec3<T>& base, const vec3<T>& top, const Line& line) {
    const auto axis = line.between(base, top);
    const index_t<typename Line::number> upper(2);
    return cross_half_space(dot(axis, line.from(top)), dot(axis, line.direction()), upper);
}

/// The chord of a side, whose face is 0, and of the spheres at both its ends, whose faces are 1 and 2. These lie within
/// the side without its ends: where that is crossed between them, they are not.
template <class W, class Sphere, class Line>
RAIO_FN constexpr chord<W> with_round_ends(const chord<W>& c, const Sphere& low, const Sphere& high, const Line& line) {
    const index_t<W> side(0);
    const mask_t<W> beside = every(c.near.exists, c.near.certain, c.near.face == side, c.far.face == side);
    if (all(beside)) return c;
    chord<W> of_low = low.crossings(line), of_high = high.crossings(line);
    of_low.near.face = of_low.far.face = index_t<W>(1);
    of_high.near.face = of_high.far.face = index_t<W>(2);
    chord<W> whole = unite(c, unite(of_low, of_high));
    return {select(beside, c.near, whole.near), select(beside, c.far, whole.far)};
}

/// What all of them record of a point: the normal and uv of the face that was hit.
/// \param radii          of the two caps
/// \param bend           a bound of the radius at which the side bends, as for `record_point`
/// \param side_gradient  says what is normal to the side, outwards and of any length. It is told where the point is: as
///                       seen from the axis, and at which height, 0 at the base and 1 at the top
template <class Point, real T, class SideGradient>
RAIO_FN constexpr void axial_surface(Point& at, const vec3<T>& base, const vec3<T>& top, const vec2<T>& radii, T bend,
                                     SideGradient side_gradient) {
    using W = typename Point::number;
    using Q = typename Point::precise;
    vec3<W> axis = difference_as<W>(top, base), from_base = at.from(base);
    W height = dot(from_base, axis) / dot(axis, axis);
    vec3<W> across = from_base - axis * height;
    const mask_t<W> side = at.face() == index_t<W>(0), low = at.face() == index_t<W>(1);
    vec3<Q> up = scaled_into_range<T>(vec3<Q>(axis)), from_axis(across);

    at.record_point(bend);
    vec3<Q> sideways = scaled_into_range<T>(vec3<Q>(side_gradient(across, height)));
    vec3<Q> outward = select(side, sideways, up * select(low, Q(-1), Q(1)));
    const Q steep = length(outward);
    const mask_t<Q> has_none = !every(steep > Q(0), is_finite(steep));
    if (any(has_none)) {  // where the side has no normal, it is seen along the axis, against the ray
        const Q turned = copysign(Q(1), Q(-dot(axis, at.direction()))) * select(at.entering(), Q(1), Q(-1));
        outward = select(has_none, up * turned, outward);
    }
    at.record_normal(outward);
    at.record_uv([&] {  // angles do not ask for unit length
        const frame<Q> f = frame_about(up, length(up));
        const T rho(quotient(length(from_axis), Q(select(low, radii.x, radii.y)), Q(0)));
        return uv_about(f, from_axis, select(side, T(height), rho));
    });
}

/// Around two discs across one axis, and what may have been rounded off a point at their planes.
template <real T>
RAIO_FN constexpr aabb<T> axial_bounds(const vec3<T>& base, const vec3<T>& top, const vec2<T>& radii) {
    vec3<T> axis = top - base, rounding(norm1(axis) * T(unit_roundoff<T>));
    vec3<T> low = disc_reach(axis, radii.x) + rounding, high = disc_reach(axis, radii.y) + rounding;
    return unless_nan(padded(hull(aabb<T>{base - low, base + low}, aabb<T>{top - high, top + high})), radii.x, radii.y);
}

/// The point at the distance rho from the axis.
/// \param turn    the angle about the axis, in turns
/// \param height  0 at the base, 1 at the top
/// \param normal  away from the axis and along it, of any length
template <real T>
RAIO_FN constexpr surface_sample<T> point_about_axis(const vec3<T>& base, const vec3<T>& top, const T& turn,
                                                     const T& height, const T& rho, const vec2<T>& normal) {
    const vec3<T> axis = top - base;
    const frame<T> f = frame_about(normalize(axis));
    const T phi = T(2 * pi<T>) * turn;
    const vec3<T> outwards = f.x * cos(phi) + f.y * sin(phi);
    return {base + axis * height + outwards * rho, normalize(outwards * normal.x + f.z * normal.y)};
}

/// The side of a frustum, to be sampled: as any other side about an axis it has two ends, their radii, an area, and
/// the points that `u` chooses. There u.x turns about the axis, and u.y is the area between the base and the point.
template <real T>
struct frustum_side {
    vec3<T> base, top;
    vec2<T> radii;

    RAIO_FN constexpr T area() const {
        const vec3<T> axis = top - base;
        const T widening = radii.y - radii.x;
        return T(pi<T>) * (radii.x + radii.y) * sqrt(dot(axis, axis) + widening * widening);
    }

    /// The height, of the axis, below which there is that part of the area.
    RAIO_FN constexpr T height(const T& part) const {
        const T low2 = radii.x * radii.x, rho = sqrt(low2 + part * (radii.y * radii.y - low2));
        // (rho - radii.x) / widening, and `part` where the radii are equal.
        return min(T(1), part * (radii.x + radii.y) / (rho + radii.x));
    }

    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        const T widening = radii.y - radii.x, h = height(u.y);
        return point_about_axis(base, top, u.x, h, radii.x + widening * h, {length(top - base), -widening});
    }
};

/// The area of a side, with the caps if it is closed.
template <bool Closed, class Side>
RAIO_FN constexpr auto axial_area(const Side& side) {
    using T = decltype(side.area());
    const vec2<T>& r = side.radii;
    return Closed ? side.area() + T(pi<T>) * (r.x * r.x + r.y * r.y) : side.area();
}

/// The point that `u` chooses of it: with caps, u.x first chooses among the side, the base and the top, and what is
/// left of it is the angle.
template <bool Closed, class Side, real T>
RAIO_FN constexpr surface_sample<T> axial_sample(const Side& side, const vec2<T>& u) {
    if constexpr (!Closed) return side.sample(u);
    const vec2<T>& r = side.radii;
    const T of_side = side.area(), of_base = T(pi<T>) * r.x * r.x, of_top = T(pi<T>) * r.y * r.y;
    T left = u.x * (of_side + of_base + of_top);
    if (left < of_side) return side.sample({left / of_side, u.y});
    left -= of_side;
    const bool on_top = left >= of_base;
    const T turn = on_top ? quotient(left - of_base, of_top, T(0)) : left / of_base, end(on_top ? 1 : 0);
    return point_about_axis(side.base, side.top, turn, end, sqrt(u.y) * (on_top ? r.y : r.x), {T(0), end + end - T(1)});
}

}  // namespace raio::inline RAIO_ABI::detail

#include <raio/pop_macros.hpp>
