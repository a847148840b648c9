#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/formula/plane.hpp>
#include <raio/math/angle.hpp>
#include <raio/math/frame.hpp>
#include <raio/proof/line.hpp>

namespace raio::inline RAIO_ABI {

/// All points p with normal.(p - point) = 0, without end. A ray meets it at
///
///     t = normal.(point - origin) / normal.direction
///
/// and misses it when it runs parallel, inside the plane or outside. The side that the normal points to is the front.
///
/// uv: the two coordinates of the point in the plane, seen from `point`, without their whole parts: a pattern of unit
/// squares.
template <real T>
struct plane {
    using number = T;

    vec3<T> point;   ///< any point of the plane
    vec3<T> normal;  ///< any length but zero

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr aabb<T> bounds() const { return unless_nan(unbounded<T>(), point, normal); }

    template <class Line>
    RAIO_FORMULA constexpr crossing<typename Line::number> crossings(const Line& line) const {
        using W = typename Line::number;
        const auto n = line.given(normal);
        const auto to_plane = dot(n, line.to(point));
        const auto speed = dot(n, line.direction());
        auto c = crossing_at(is_positive(abs(speed)), to_plane * inverse(speed), speed.value < W(0));
        keep_if_in_range<T>(line, c);  // no point beyond the largest number
        return c;
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        at.record_point();
        at.record_normal(normal);
        at.record_uv([&] {
            using Q = typename Point::precise;
            vec3<T> local = frame_about(vec3<T>(normalize_from<T>(vec3<Q>(normal)))).to_local(at.point() - point);
            return vec2<T>(fraction(local.x), fraction(local.y));
        });
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
