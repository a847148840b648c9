#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/formula/quadric.hpp>
#include <raio/math/conic.hpp>
#include <raio/proof/crossing_list.hpp>

/// \file
/// The hyperboloid of revolution of one sheet, with caps, a solid, and without; and what it has in common with that of
/// two sheets (two_sheet_hyperboloid.hpp).
///
/// With the height h, -1/2 at the base and 1/2 at the top, the side is at the distance rho from the axis,
///
///     rho^2 = waist^2 + (end^2 - waist^2) (2 h)^2
///
/// which is a quadric of revolution about the middle, for which see formula/quadric.hpp. It is not convex: a line that
/// is steeper than the asymptotes may be inside before and after its two crossings with the side.
///
/// Faces are counted side, base, top. uv of the side: u is the angle about the axis in turns, from the x axis of
/// `frame_about(top - base)`; v the height, 0 at the base and 1 at the top. uv of a cap: the same u, and v the distance
/// from the axis over the radius.

namespace raio::inline RAIO_ABI {

namespace detail {

/// One sheet about the middle of the axis, with the height h = -1/2 at the base and 1/2 at the top.
template <class W, real T>
RAIO_FN constexpr auto one_sheet(const T& waist, const T& end) {
    using numbers = shape_numbers<W>;
    const auto w = numbers::given(waist);
    const auto c0 = w * w;
    const auto c2 = numbers::given(T(4)) * (numbers::between(waist, end) * numbers::between(-waist, end));
    const zero_number<W> zero;
    return turned_conic{c0, zero, c2, -(c0 * c2)};
}

/// The crossings with a hyperboloid about the middle between two planes: of one that is closed by caps (a line that is
/// inside before and after the two ends enters it and leaves it by those), or each with the side on its own.
/// \param radius  the largest; 0 if there is no hyperboloid
template <bool Closed, class Line, real T, class Side, class Wanted>
RAIO_FN constexpr auto cross_hyperboloid(const vec3<T>& base, const vec3<T>& top, const Side& side, const T& radius,
                                         const Line& line, const Wanted& wanted) {
    auto endless =
        cross_quadric(line.direction(), line.to_middle(base, top), line.between(base, top), side, line.given(radius));
    if constexpr (Closed) {
        if (missed(endless.ends)) return nowhere_at_all(endless.ends, wanted);
        auto parts = intersect(endless, cross_cap_planes(base, top, line), wanted);
        keep_if_in_range<T>(line, parts);  // no point beyond the largest number
        return parts;
    } else {
        return between_caps<false>(endless.ends, base, top, line);
    }
}

/// What they record of a point.
/// \param radius     the largest
/// \param c2, scale  rho^2 grows as c2 / scale h^2
template <class Point, class W, real T>
RAIO_FN constexpr void hyperboloid_surface(Point& at, const vec3<T>& base, const vec3<T>& top, T end_radius,
                                           const T& radius, const W& c2, const W& scale) {
    vec3<W> axis = difference_as<W>(top, base);
    W slope = c2 / (scale * dot(axis, axis));
    axial_surface(
        at, base, top, vec2<T>(end_radius), radius + norm1(vec3<T>(axis)),
        [&](const vec3<W>& from_axis, const W& height) { return from_axis - axis * (slope * (height - W(0.5))); });
    at.keep_in([&] { return axial_bounds(base, top, vec2<T>(radius)); });
}

/// The side, to be sampled: rho^2 = c0 + c2 h^2 from `least` to 1 of |2 h|.
template <real T>
struct hyperboloid_side {
    vec3<T> base, top;
    vec2<T> radii;
    double c0, c2, least;

    RAIO_FN T area() const { return T(4 * pi<double> * curve().area(least, 1)); }

    RAIO_FN surface_sample<T> sample(const vec2<T>& u) const {
        const double from_middle = 2 * double(u.y) - 1;
        const double y = copysign(curve().place(least, 1, abs(from_middle)), from_middle);
        const T rho = T(std::sqrt(std::max(c0 + c2 * y * y / 4, 0.0)));
        return point_about_axis(base, top, u.x, T(0.5 + 0.5 * y), rho, {rho, -T(c2 * y / 2) / length(top - base)});
    }

private:
    /// The area is 4 pi times that below this curve: with y = 2 h, rho^2 = c0 + a y^2 and half the axis H, its element
    /// is 2 pi rho sqrt(H^2 + rho'^2) dy, and rho rho' = a y.
    RAIO_FN conic curve() const {
        const vec3<double> axis = vec3<double>(top) - vec3<double>(base);
        const double half2 = dot(axis, axis) / 4, a = c2 / 4;
        return {c0 * half2, a * (half2 + a)};
    }
};

}  // namespace detail

/// The points inside a hyperboloid of one sheet, between its two ends: a solid; or, if it is not `Closed`, only the
/// side, rims included, which is hit from both sides. With an end radius below the waist radius it bulges, and with
/// equal radii it is a cylinder.
template <real T, bool Closed = true>
struct hyperboloid {
    using number = T;

    vec3<T> base, top;           ///< the centres of both ends
    T waist_radius, end_radius;  ///< in the middle and at both ends: lengths, positive

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
        return unless_nan(detail::axial_bounds(base, top, vec2<T>(max(waist_radius, end_radius))), waist_radius,
                          end_radius);
    }

    RAIO_FN T area() const requires(std::floating_point<T>) { return detail::axial_area<Closed>(side()); }

    /// u.x turns about the axis, u.y is the area between the base and the point. With caps, u.x first chooses among the
    /// side, the base and the top, and what is left of it is the angle.
    RAIO_FN surface_sample<T> sample(const vec2<T>& u) const requires(std::floating_point<T>) {
        return detail::axial_sample<Closed>(side(), u);
    }

    template <class Line, class Wanted = every_crossing>
    RAIO_FORMULA constexpr auto crossings(const Line& line, const Wanted& wanted = {}) const {
        const auto side = detail::one_sheet<typename Line::number>(waist_radius, end_radius);
        return detail::cross_hyperboloid<Closed>(base, top, side, largest_radius(), line, wanted);
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        const auto side = detail::one_sheet<W>(waist_radius, end_radius);
        detail::hyperboloid_surface(at, base, top, end_radius, largest_radius(), side.c2.value, W(1));
    }

private:
    /// 0 if there is no hyperboloid.
    RAIO_FN constexpr T largest_radius() const {
        return select(every(waist_radius > T(0), end_radius > T(0)), max(waist_radius, end_radius), T(0));
    }
    RAIO_FN detail::hyperboloid_side<T> side() const {
        if (!(largest_radius() > T(0))) return {base, top, vec2<T>(end_radius), 0, 0, 0};
        const auto side = detail::one_sheet<double>(waist_radius, end_radius);
        return {base, top, vec2<T>(end_radius), side.c0.value, side.c2.value, 0.0};
    }
};

/// The side alone.
template <real T>
using open_hyperboloid = hyperboloid<T, false>;

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
