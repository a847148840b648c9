#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/formula/axis.hpp>
#include <raio/proof/line.hpp>
#include <raio/surface_sample.hpp>

/// \file
/// The cylinder: with its caps it is a solid, without them a tube.
///
/// With the axis A = top - base, the ray's direction d and l from its origin to the base, the distance of the point at
/// t from the axis is
///
///     |(t d - l) x A| / |A|
///
/// It is the radius where
///
///     a t^2 - 2 b t + c = 0,   n = d x A,   beside = l x A
///     a = n.n,   b = beside.n,   c = beside.beside - A.A radius^2
///     t = (b -+ s) / a,   s^2 = b^2 - a c = A.A (a radius^2 - (l.n)^2)
///
/// |l.n| / |n| is the distance at which the line passes the axis: as the sphere's, the last form of s^2 is no
/// difference of large squares. A line parallel to the axis, n = 0, is inside everywhere or nowhere.
///
/// Faces are counted side, base, top. uv of the side: u is the angle about the axis in turns, from the x axis of
/// `frame_about(top - base)`; v the height, 0 at the base and 1 at the top. uv of a cap: the same u, and v the distance
/// from the axis over the radius.

namespace raio::inline RAIO_ABI {

namespace detail {

/// The chord through the cylinder without its ends.
template <class Line, real T>
RAIO_FN constexpr auto cross_endless_cylinder(const vec3<T>& base, const vec3<T>& top, const T& radius,
                                              const Line& line) {
    using W = typename Line::number;
    const auto axis = line.between(base, top);
    const auto l = line.to(base);
    const auto d = line.direction();
    const auto r = line.given(radius);
    const auto n = cross(d, axis);
    const auto beside = cross(l, axis);
    const auto a = square(n);
    const auto ar2 = a * (r * r);
    const auto passed2 = square(dot(l, n));  // of the distance at which the line passes the axis, times n.n
    const auto crosses = every(is_positive(r), is_positive(ar2), ar2 >= passed2);
    const auto is_parallel = !is_positive(a);  // to the axis
    if (all(every(!is_parallel, !crosses))) return nowhere<W>();

    // The squares of the radius and of the distance of the point where t = 0 from the axis, both times A.A.
    const auto axis2 = square(axis);
    const auto inner2 = axis2 * (r * r);
    const auto beside2 = square(beside);
    const auto s = sqrt(axis2 * (ar2 - passed2));
    const auto c = beside2 - inner2;
    const auto b = dot(beside, n);
    const auto [enters, leaves] = quadratic_roots(a, b, c, s);  // (b -+ s) / a
    if (all(!is_parallel)) return between(crosses, enters, leaves);

    const auto is_inside = every(is_positive(r), is_positive(inner2), beside2 <= inner2);
    return unless_parallel(is_parallel, between(crosses, enters, leaves), is_inside);
}

}  // namespace detail

/// The points at most `radius` from the axis between base and top: a solid; or, if it is not `Closed`, only the side, a
/// tube, rims included, which is hit from both sides.
template <real T, bool Closed = true>
struct cylinder {
    using number = T;

    vec3<T> base, top;  ///< the centres of both ends
    T radius;           ///< a length; the cylinder is missed unless it is positive and base and top differ

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr interval<T> spans(const ray<T>& ray) const requires(Closed) { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const { return detail::axial_bounds(base, top, vec2<T>(radius)); }

    RAIO_FN constexpr T area() const { return detail::axial_area<Closed>(side()); }

    /// Unrolled the tube is a rectangle: `u` is its uv. If it is closed, u.x first chooses among the side, the base and
    /// the top, and what is left of it is the angle.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const
        requires(!Closed || std::same_as<mask_t<T>, bool>) {
        return detail::axial_sample<Closed>(side(), u);
    }

    /// Where the ray's line enters and where it leaves. Numbers carry bounds of their errors (proof/line.hpp), and
    /// whether a comparison of them holds may be in doubt: `every` and `some` combine such verdicts, `all` asks whether
    /// one holds beyond doubt, `any` whether it may hold (number/verdict.hpp).
    template <class Line>
    RAIO_FORMULA constexpr chord<typename Line::number> crossings(const Line& line) const {
        auto endless = detail::cross_endless_cylinder(base, top, radius, line);
        return detail::between_caps<Closed>(endless, base, top, line);
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        // What is normal to the side leads away from the axis, at any height.
        const auto outwards = [](const auto& from_axis, const auto&) { return from_axis; };
        detail::axial_surface(at, base, top, vec2<T>(radius), radius, outwards);
        at.keep_in([this] { return bounds(); });
    }

private:
    /// That of a frustum with equal radii.
    RAIO_FN constexpr detail::frustum_side<T> side() const { return {base, top, vec2<T>(radius)}; }
};

/// The side alone.
template <real T>
using open_cylinder = cylinder<T, false>;

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
