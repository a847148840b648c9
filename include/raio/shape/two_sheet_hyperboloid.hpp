#pragma once

#include <raio/push_macros.hpp>

#include <raio/shape/hyperboloid.hpp>

/// \file
/// The hyperboloid of revolution of two sheets, with caps, a solid, and without.
///
/// With the height h, -1/2 at the base and 1/2 at the top, the side is at the distance rho from the axis,
///
///     rho^2 = end^2 ((2 h)^2 - gap^2) / (1 - gap^2)
///
/// All else is as of one sheet: see hyperboloid.hpp.

namespace raio::inline RAIO_ABI {

namespace detail {

/// Both sheets about the middle of the axis, with the height h = -1/2 at the base and 1/2 at the top.
template <class W, real T>
RAIO_FN constexpr auto two_sheets(const T& gap, const T& end) {
    using numbers = shape_numbers<W>;
    const auto g2 = square(numbers::given(gap));
    const auto scale =
        square(numbers::given(end)) * inverse(numbers::between(gap, T(1)) * numbers::between(-gap, T(1)));
    const auto c0 = -(g2 * scale);
    const auto c2 = numbers::given(T(4)) * scale;
    const zero_number<W> zero;
    return turned_conic{c0, zero, c2, -(c0 * c2)};
}

}  // namespace detail

/// The points inside both sheets of a hyperboloid, up to its two ends: a solid in two parts; or, if it is not `Closed`,
/// only both sheets, rims included, which are hit from both sides.
template <real T, bool Closed = true>
struct two_sheet_hyperboloid {
    using number = T;

    vec3<T> base, top;  ///< the centres of both ends
    T gap;              ///< between the two vertices, of the axis: between 0 and 1
    T end_radius;       ///< at both ends, positive

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
        return unless_nan(detail::axial_bounds(base, top, vec2<T>(end_radius)), gap);
    }

    RAIO_FN T area() const requires(std::floating_point<T>) { return detail::axial_area<Closed>(side()); }

    /// u.x turns about the axis, u.y is the area between the base and the point. With caps, u.x first chooses among the
    /// side, the base and the top, and what is left of it is the angle.
    RAIO_FN surface_sample<T> sample(const vec2<T>& u) const requires(std::floating_point<T>) {
        return detail::axial_sample<Closed>(side(), u);
    }

    template <class Line, class Wanted = every_crossing>
    RAIO_FORMULA constexpr auto crossings(const Line& line, const Wanted& wanted = {}) const {
        const auto sides = detail::two_sheets<typename Line::number>(gap, end_radius);
        return detail::cross_hyperboloid<Closed>(base, top, sides, largest_radius(), line, wanted);
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        const W g(gap), end(end_radius);
        detail::hyperboloid_surface(at, base, top, end_radius, largest_radius(), W(4) * (end * end),
                                    (W(1) - g) * (W(1) + g));
    }

private:
    /// 0 if there is no hyperboloid.
    RAIO_FN constexpr T largest_radius() const { return select(every(gap > T(0), gap < T(1)), end_radius, T(0)); }
    RAIO_FN detail::hyperboloid_side<T> side() const {
        if (!(largest_radius() > T(0))) return {base, top, vec2<T>(end_radius), 0, 0, 0};
        const auto side = detail::two_sheets<double>(gap, end_radius);
        return {base, top, vec2<T>(end_radius), side.c0.value, side.c2.value, double(gap)};
    }
};

/// Both sheets alone.
template <real T>
using open_two_sheet_hyperboloid = two_sheet_hyperboloid<T, false>;

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
