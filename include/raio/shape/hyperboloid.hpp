#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/formula/quadric.hpp>
#include <raio/math/conic.hpp>
#include <raio/proof/crossing_list.hpp>
#include <raio/shape/disc.hpp>

/// \file
/// The hyperboloid of revolution of one sheet, with caps, a solid, and without; and what it has in common with that of
/// two sheets (two_sheet_hyperboloid.hpp).
///
/// With the height y, -1 at the base and 1 at the top, the side is at the distance rho from the axis,
///
///     rho^2 = waist^2 + (end^2 - waist^2) y^2
///
/// which is a quadric of revolution about the middle, for which see formula/quadric.hpp. It is not convex: a line that
/// is steeper than the asymptotes may be inside before and after its two crossings with the side.
///
/// Faces are counted side, base, top. uv of the side: u is the angle about the axis, from the x axis of
/// `frame_about(axis)`; v the height, 0 at the base and 1 at the top. uv of a cap: the same u, and v the distance from
/// the axis over the radius.

namespace raio {

namespace detail {

/// v rho^2 = c0 + c2 h^2 about the middle of the axis, where h is 1/2 at the ends.
template <class W>
struct hyperboloid_side {
    W v, c0, c2;
    W radius;  ///< the largest
    W least;   ///< from here to 1 goes |y|
};

template <class W, real T>
RAIO_FN constexpr hyperboloid_side<W> one_sheet(T waist_radius, T end_radius) {
    W waist(waist_radius), end(end_radius);
    return {W(1), waist * waist, W(4) * (end - waist) * (end + waist),
            select(every(waist_radius > T(0), end_radius > T(0)), max(waist, end), W(0)), W(0)};
}

/// The side as it is turned about the axis, with h = 0 in the middle and -1/2 and 1/2 at the ends.
template <class Line, real T>
RAIO_FN constexpr auto one_sheet_on(const Line& line, const T& waist, const T& end) {
    const auto w = line.given(waist);
    const auto c0 = w * w;
    const auto c2 = line.given(T(4)) * (line.between(waist, end) * line.between(-waist, end));
    const zero_number<typename Line::number> none;
    return turned_conic{c0, none, c2, -(c0 * c2)};
}

/// No radius, or the largest.
template <real T>
RAIO_FN constexpr T largest_radius(const T& waist, const T& end) {
    return select(every(waist > T(0), end > T(0)), max(waist, end), T(0));
}

/// Where the line is inside the endless hyperboloid.
template <class Line, real T, class Side>
RAIO_FN constexpr auto cross_endless_hyperboloid(const vec3<T>& base, const vec3<T>& top, const Side& side,
                                                 const T& radius, const Line& line) {
    return cross_quadric(line.direction(), line.to_middle(base, top), line.between(base, top), side,
                         line.given(radius));
}

/// The crossings with the solid between the caps. (A line that is inside before and after the side's two ends enters it
/// and leaves it by the caps.)
template <class Line, real T, class Side, class Wanted>
RAIO_FN constexpr auto cross_capped(const vec3<T>& base, const vec3<T>& top, const Side& side, const T& radius,
                                    const Line& line, const Wanted& wanted) {
    auto c = cross_endless_hyperboloid(base, top, side, radius, line);
    if (missed(c.ends)) return nowhere_at_all<Wanted>(c.ends);
    auto parts = intersect(c, cross_cap_planes(base, top, line), wanted);
    keep_if_reachable<T>(line, parts);
    return parts;
}

/// The crossings with the side alone: either counts on its own, if it lies between the two planes.
template <class Line, real T, class Side>
RAIO_FN constexpr auto cross_side(const vec3<T>& base, const vec3<T>& top, const Side& side, const T& radius,
                                  const Line& line) {
    auto c = cross_endless_hyperboloid(base, top, side, radius, line).ends;
    if (missed(c)) return c;
    const auto slab = cross_cap_planes(base, top, line);
    c = {within(slab, c.near), within(slab, c.far)};
    keep_if_reachable<T>(line, c);
    return c;
}

/// What all of them say of a point.
template <class Point, class W, real T>
RAIO_FN constexpr void hyperboloid_surface(Point& at, const vec3<T>& base, const vec3<T>& top, T end_radius,
                                           const hyperboloid_side<W>& side) {
    vec3<W> axis = difference_as<W>(top, base);
    W slope = side.c2 / (side.v * dot(axis, axis));
    axial_surface(
        at, base, top, vec2<T>(end_radius), T(side.radius) + norm1(vec3<T>(axis)),
        [&](const vec3<W>& from_axis, const W& height) { return from_axis - axis * (slope * (height - W(0.5))); });
    at.keep_in([&] { return axial_bounds(base, top, vec2<T>(T(side.radius))); });
}

/// From the least |y| to 1 the area of the side is 4 pi times that below this curve: with rho^2 = c + a y^2 and half
/// the axis H, its element is 2 pi rho sqrt(H^2 + rho'^2) dy, and rho rho' = a y.
template <std::floating_point T>
RAIO_FN conic area_of_side(const vec3<T>& base, const vec3<T>& top, const hyperboloid_side<double>& side) {
    const vec3<double> axis = vec3<double>(top) - vec3<double>(base);
    const double half2 = dot(axis, axis) / 4, a = side.c2 / (4 * side.v);
    return {side.c0 / side.v * half2, a * (half2 + a)};
}
template <std::floating_point T>
RAIO_FN T hyperboloid_area(const vec3<T>& base, const vec3<T>& top, const hyperboloid_side<double>& side) {
    return side.radius > 0 ? T(4 * pi<double> * area_of_side(base, top, side).area(side.least, 1)) : T(0);
}

/// The point of the side that `u` chooses: u.x turns about the axis, u.y is the area between the base and the point.
template <std::floating_point T>
RAIO_FN surface_sample<T> sample_hyperboloid(const vec3<T>& base, const vec3<T>& top,
                                             const hyperboloid_side<double>& side, const vec2<T>& u) {
    const double from_middle = 2 * double(u.y) - 1;
    const double y = copysign(area_of_side(base, top, side).place(side.least, 1, abs(from_middle)), from_middle);
    const T rho = T(std::sqrt(std::max(side.c0 + side.c2 * y * y / 4, 0.0) / side.v)), phi = T(2 * pi<T>) * u.x;
    const vec3<T> axis = top - base;
    const T size = length(axis), along = T(side.c2 * y / (2 * side.v)) / size;
    const frame<T> f = frame_about(axis / size);
    vec3<T> outwards = f.x * cos(phi) + f.y * sin(phi);
    return {base + axis * T(0.5 + 0.5 * y) + outwards * rho, normalize(outwards * rho - f.z * along)};
}

/// The same with caps of this radius: u.x chooses among the side, the base and the top, and what is left of it is the
/// angle.
template <std::floating_point T>
RAIO_FN surface_sample<T> sample_capped(const vec3<T>& base, const vec3<T>& top, T radius,
                                        const hyperboloid_side<double>& side, const vec2<T>& u) {
    const T of_side = hyperboloid_area(base, top, side), of_cap = T(pi<T>) * radius * radius;
    const T left = u.x * (of_side + T(2) * of_cap);
    if (left < of_side) return sample_hyperboloid(base, top, side, {left / of_side, u.y});
    const T turn = (left - of_side) / of_cap;
    if (turn < T(1)) return disc<T>{base, base - top, radius}.sample({turn, u.y});
    return disc<T>{top, top - base, radius}.sample({turn - T(1), u.y});
}

}  // namespace detail

/// The points inside a hyperboloid of one sheet, between its two ends: closed, a solid. With an end radius below the
/// waist radius it bulges, and with equal radii it is a cylinder.
template <real T>
struct hyperboloid {
    using number = T;

    vec3<T> base, top;           ///< the centres of the two caps
    T waist_radius, end_radius;  ///< in the middle and at both ends: lengths, positive

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr raio::spans<T, 2> spans(const ray<T>& ray) const { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const {
        return unless_nan(detail::axial_bounds(base, top, vec2<T>(max(waist_radius, end_radius))), waist_radius,
                          end_radius);
    }

    RAIO_FN T area() const requires(std::floating_point<T>) {
        return detail::hyperboloid_area(base, top, detail::one_sheet<double>(waist_radius, end_radius)) +
               T(2 * pi<T>) * end_radius * end_radius;
    }

    /// u.x chooses among the side, the base and the top, and what is left of it is the angle.
    RAIO_FN surface_sample<T> sample(const vec2<T>& u) const requires(std::floating_point<T>) {
        return detail::sample_capped(base, top, end_radius, detail::one_sheet<double>(waist_radius, end_radius), u);
    }

    template <class Line, class Wanted = every_crossing>
    RAIO_FORMULA constexpr chords_for_t<typename Line::number, Wanted> crossings(const Line& line,
                                                                                 const Wanted& wanted = {}) const {
        return detail::cross_capped(base, top, detail::one_sheet_on(line, waist_radius, end_radius),
                                    detail::largest_radius(waist_radius, end_radius), line, wanted);
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        detail::hyperboloid_surface(at, base, top, end_radius, detail::one_sheet<W>(waist_radius, end_radius));
    }
};

/// A hyperboloid of one sheet up to its two rims, seen from both sides.
template <real T>
struct open_hyperboloid {
    using number = T;

    vec3<T> base, top;           ///< the centres of the two rims, which belong to it
    T waist_radius, end_radius;  ///< in the middle and at both ends: lengths, positive

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr aabb<T> bounds() const {
        return unless_nan(detail::axial_bounds(base, top, vec2<T>(max(waist_radius, end_radius))), waist_radius,
                          end_radius);
    }

    RAIO_FN T area() const requires(std::floating_point<T>) {
        return detail::hyperboloid_area(base, top, detail::one_sheet<double>(waist_radius, end_radius));
    }

    /// u.x turns about the axis, u.y is the area between the base and the point.
    RAIO_FN surface_sample<T> sample(const vec2<T>& u) const requires(std::floating_point<T>) {
        return detail::sample_hyperboloid(base, top, detail::one_sheet<double>(waist_radius, end_radius), u);
    }

    template <class Line>
    RAIO_FORMULA constexpr chord<typename Line::number> crossings(const Line& line) const {
        return detail::cross_side(base, top, detail::one_sheet_on(line, waist_radius, end_radius),
                                  detail::largest_radius(waist_radius, end_radius), line);
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        detail::hyperboloid_surface(at, base, top, end_radius, detail::one_sheet<W>(waist_radius, end_radius));
    }
};

}  // namespace raio

#include <raio/pop_macros.hpp>
