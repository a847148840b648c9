#pragma once

#include <raio/push_macros.hpp>

#include <raio/shape/hyperboloid.hpp>

/// \file
/// The hyperboloid of revolution of two sheets, with caps, a solid, and without.
///
/// With the height y, -1 at the base and 1 at the top, the side is at the distance rho from the axis,
///
///     rho^2 = end^2 (y^2 - gap^2) / (1 - gap^2)
///
/// All else is as of one sheet: see hyperboloid.hpp.

namespace raio {

namespace detail {

template <class W, real T>
RAIO_FN constexpr hyperboloid_side<W> two_sheets(T gap, T end_radius) {
    W g(gap), end(end_radius);
    const mask_t<T> sound = every(gap > T(0), gap < T(1));
    W end2 = end * end;
    return {select(sound, (W(1) - g) * (W(1) + g), W(1)), -(g * g) * end2, W(4) * end2, select(sound, end, W(0)), g};
}

/// The side as it is turned about the axis, with h = 0 in the middle and -1/2 and 1/2 at the ends.
template <class Line, real T>
RAIO_FN constexpr auto two_sheets_on(const Line& line, const T& gap, const T& end) {
    const auto g2 = square(line.given(gap));
    const auto scale = square(line.given(end)) * inverse(line.between(gap, T(1)) * line.between(-gap, T(1)));
    const auto c0 = -(g2 * scale);
    const auto c2 = line.given(T(4)) * scale;
    const zero_number<typename Line::number> none;
    return turned_conic{c0, none, c2, -(c0 * c2)};
}

/// No radius, or the largest.
template <real T>
RAIO_FN constexpr T radius_beyond(const T& gap, const T& end) {
    return select(every(gap > T(0), gap < T(1)), end, T(0));
}

}  // namespace detail

/// The points inside both sheets of a hyperboloid, up to its two ends: closed, a solid in two parts.
template <real T>
struct two_sheet_hyperboloid {
    using number = T;

    vec3<T> base, top;  ///< the centres of the two caps
    T gap;              ///< between the two vertices, of the axis: between 0 and 1
    T end_radius;       ///< at both ends, positive

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr raio::spans<T, 2> spans(const ray<T>& ray) const { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const {
        return unless_nan(detail::axial_bounds(base, top, vec2<T>(end_radius)), gap);
    }

    RAIO_FN T area() const requires(std::floating_point<T>) {
        return detail::hyperboloid_area(base, top, detail::two_sheets<double>(gap, end_radius)) +
               T(2 * pi<T>) * end_radius * end_radius;
    }

    /// u.x chooses among the side, the base and the top, and what is left of it is the angle.
    RAIO_FN surface_sample<T> sample(const vec2<T>& u) const requires(std::floating_point<T>) {
        return detail::sample_capped(base, top, end_radius, detail::two_sheets<double>(gap, end_radius), u);
    }

    template <class Line, class Wanted = every_crossing>
    RAIO_FORMULA constexpr chords_for_t<typename Line::number, Wanted> crossings(const Line& line,
                                                                                 const Wanted& wanted = {}) const {
        return detail::cross_capped(base, top, detail::two_sheets_on(line, gap, end_radius),
                                    detail::radius_beyond(gap, end_radius), line, wanted);
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        detail::hyperboloid_surface(at, base, top, end_radius, detail::two_sheets<W>(gap, end_radius));
    }
};

/// Both sheets of a hyperboloid up to their rims, seen from both sides.
template <real T>
struct open_two_sheet_hyperboloid {
    using number = T;

    vec3<T> base, top;  ///< the centres of the two rims, which belong to it
    T gap;              ///< between the two vertices, of the axis: between 0 and 1
    T end_radius;       ///< at both ends, positive

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr aabb<T> bounds() const {
        return unless_nan(detail::axial_bounds(base, top, vec2<T>(end_radius)), gap);
    }

    RAIO_FN T area() const requires(std::floating_point<T>) {
        return detail::hyperboloid_area(base, top, detail::two_sheets<double>(gap, end_radius));
    }

    /// u.x turns about the axis, u.y is the area between the base and the point.
    RAIO_FN surface_sample<T> sample(const vec2<T>& u) const requires(std::floating_point<T>) {
        return detail::sample_hyperboloid(base, top, detail::two_sheets<double>(gap, end_radius), u);
    }

    template <class Line>
    RAIO_FORMULA constexpr chord<typename Line::number> crossings(const Line& line) const {
        return detail::cross_side(base, top, detail::two_sheets_on(line, gap, end_radius),
                                  detail::radius_beyond(gap, end_radius), line);
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        detail::hyperboloid_surface(at, base, top, end_radius, detail::two_sheets<W>(gap, end_radius));
    }
};

}  // namespace raio

#include <raio/pop_macros.hpp>
