#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/formula/edges.hpp>
#include <raio/surface_sample.hpp>

namespace raio::inline RAIO_ABI {

/// The points `corner + u edge_u + v edge_v` with u and v in [0, 1]: a flat quadrilateral whose front is the side from
/// which the turn from `edge_u` to `edge_v` is counter-clockwise.
///
/// A line crosses the plane of the two edges where formula/edges.hpp finds u, v and t; the four signs of u, v, 1 - u
/// and 1 - v, which are exact, say whether that is inside.
///
/// uv: u and v.
template <real T>
struct parallelogram {
    using number = T;

    vec3<T> corner;
    vec3<T> edge_u, edge_v;  ///< the parallelogram is missed if these are parallel

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr aabb<T> bounds() const { return unless_nan(padded(corners()), corner, edge_u, edge_v); }

    RAIO_FN constexpr T area() const { return length(cross(edge_u, edge_v)); }

    /// `u` is the uv.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        return {corner + edge_u * u.x + edge_v * u.y, normalize(cross(edge_u, edge_v))};
    }

    template <class Line, class Wanted = every_crossing>
    RAIO_FORMULA constexpr crossing<typename Line::number> crossings(const Line& line,
                                                                     const Wanted& wanted = {}) const {
        const auto far = [](const auto& u, const auto& v) { return max(u, v); };
        return cross_edges(line, corner, line.given(edge_u), line.given(edge_v), far, wanted);
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        const auto edge = [this]<class V>(const V&, int i) { return vec3<V>(i == 0 ? edge_u : edge_v); };
        flat_surface(at, corners(), edge);
        at.record_uv([&] {
            const auto in_range = [](const T& x) { return max(T(0), min(T(1), x)); };
            return vec2<T>(in_range(T(at.crossing().u)), in_range(T(at.crossing().v)));
        });
    }

private:
    RAIO_FN constexpr aabb<T> corners() const {
        using W = wider_t<T>;
        vec3<W> along_u = vec3<W>(corner) + vec3<W>(edge_u), along_v = vec3<W>(corner) + vec3<W>(edge_v);
        aabb<T> box = hull_of_numbers(hull_of_numbers(aabb<T>{corner, corner}, vec3<T>(along_u)), vec3<T>(along_v));
        return hull_of_numbers(box, vec3<T>(along_u + vec3<W>(edge_v)));
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
