#pragma once

#include <raio/push_macros.hpp>

#include <raio/shape/ring.hpp>

namespace raio::inline RAIO_ABI {

/// The points of a plane at most `radius` from `center`: where the ray meets the plane, the squared distance decides.
/// It is a ring without a hole, but asks for one rim only.
///
/// uv: u is the angle about the normal in turns, from the x axis of `frame_about(normal)`; v the distance from the
/// centre over the radius.
template <real T>
struct disc {
    using number = T;

    vec3<T> center;
    vec3<T> normal;  ///< any length but zero
    T radius;        ///< a length; the disc is missed unless it is positive

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr aabb<T> bounds() const { return as_ring().bounds(); }
    RAIO_FN constexpr T area() const { return as_ring().area(); }
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const { return as_ring().sample(u); }

    template <class Line>
    RAIO_FORMULA constexpr crossing<typename Line::number> crossings(const Line& line) const {
        using W = typename Line::number;
        const auto n = line.given(normal);
        const auto d = line.direction();
        const auto r = line.given(radius);
        const auto to_center = line.to(center);
        const auto speed = dot(n, d);
        const auto t = dot(n, to_center) * inverse(speed);
        const auto exists = every(is_positive(r), is_positive(abs(speed)), r * r >= square(d * t - to_center));
        return crossing_at(exists, t, speed.value < W(0));
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        as_ring().surface(at);
    }

private:
    RAIO_FN constexpr ring<T> as_ring() const { return {center, normal, T(0), radius}; }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
