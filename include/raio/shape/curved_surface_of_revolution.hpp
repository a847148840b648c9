#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/bezier.hpp>
#include <raio/shape/surface_of_revolution.hpp>

namespace raio::inline RAIO_ABI {

namespace detail {

/// What a cubic Bezier segment sweeps: see formula/revolution.hpp. Where it meets the axis, 106 bits cannot tell it
/// from 2^-40 of its size beside it.
template <real T>
struct revolved_piece<T, 3> {
    using number = T;

    vec3<T> base, axis;
    vec2<T> p0, p1, p2, p3;  ///< control points, (radius, height)

    template <class Line>
    RAIO_FORMULA constexpr crossing_list<typename Line::number, 12> crossings(const Line& line) const {
        using W = typename Line::number;
        crossing_list<W, 12> list;
        const auto [low, high] = around();
        const vec3<W> a(axis);
        const W unit = length(a), middle = (W(low.y) + W(high.y)) * W(0.5);
        const bool sound = low.x >= T(0) && is_finite(base) && is_finite(p0.x + p1.x + p2.x + p3.x) &&
                           is_finite(p0.y + p1.y + p2.y + p3.y);
        if (!sound || !(unit > W(0)) || !is_finite(bound_t<W>(unit))) return list;
        const W reach = W(high.x) + (W(high.y) - W(low.y)) * (W(0.5) * unit);
        const auto part = part_near(line, base, vec3<W>(base) + a * middle, reach);
        list.depends_on(part);
        if (!part.exists) return list;
        list = cross_revolved(beside_axis<W>(), part, W(1) / reach);
        list.start_at_origin();
        keep_if_in_range<T>(line, list);  // no point beyond the largest number
        return list;
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        using Q = typename Point::precise;
        const auto curve = beside_axis<W>();
        const W s = at.crossing().u;
        vec3<W> p = at.from(base);
        const auto [low, high] = around();
        const T size = high.x + norm1(axis) * max(abs(low.y), abs(high.y));
        at.record_point(size);
        at.add_error(error_of_sweep(size));
        at.record_gradient(outward_normal(curve, s, p));
        at.record_uv([&] {
            const vec3<W> e = curve.axis();
            return uv_about(frame_about(vec3<Q>(e)), vec3<Q>(p - e * dot(p, e)), T(s));
        });
    }

private:
    RAIO_FN constexpr profile_bounds<T> around() const { return profile_bounds<T>::around(std::array{p0, p1, p2, p3}); }

    template <class W>
    RAIO_FN constexpr curve_beside_axis<W> beside_axis() const {
        const given_vector<W> a{W(axis.x), W(axis.y), W(axis.z)};
        const auto unit = sqrt(square(a));
        const polynomial<W, 3> radii = bezier_polynomial<W>(p0.x, p1.x, p2.x, p3.x);
        const polynomial<W, 3> heights = bezier_polynomial<W>(p0.y, p1.y, p2.y, p3.y);
        return {radii, heights * unit, a * inverse(unit)};
    }
};

}  // namespace detail

/// What cubic Bezier segments sweep that turn about an axis: see surface_of_revolution.hpp.
template <real T>
using curved_surface_of_revolution = surface_of_revolution<T, 3>;

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
