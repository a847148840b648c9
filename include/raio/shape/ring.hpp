#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/formula/plane.hpp>
#include <raio/math/angle.hpp>
#include <raio/math/frame.hpp>
#include <raio/proof/line.hpp>
#include <raio/surface_sample.hpp>

namespace raio::inline RAIO_ABI {

namespace detail {

/// Where a line meets a plane, if that is between both rims.
/// \param to_center  from the point where the line has t = 0
template <class W, proven_vector D, proven_vector N, proven_vector L>
RAIO_FN constexpr crossing<W> cross_between_rims(const D& d, const N& n, const L& to_center,
                                                 const given_number<W>& inner, const given_number<W>& outer) {
    auto speed = dot(n, d);
    auto t = dot(n, to_center) * inverse(speed);
    auto distance2 = square(d * t - to_center);
    auto exists = every(!is_positive(-inner), outer > inner, is_positive(abs(speed)), distance2 >= inner * inner,
                        outer * outer >= distance2);
    return crossing_at(exists, t, speed.value < W(0));
}

}  // namespace detail

/// The points of a plane at least `inner_radius` and at most `outer_radius` from `center`: an annulus. Where the ray
/// meets the plane, the squared distance decides.
///
/// uv: u is the angle about the normal in turns, from the x axis of `frame_about(normal)`; v goes from 0 at the inner
/// rim to 1 at the outer one.
template <real T>
struct ring {
    using number = T;

    vec3<T> center;
    vec3<T> normal;  ///< any length but zero
    T inner_radius;  ///< not negative
    T outer_radius;  ///< the ring is missed unless this is the larger radius

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr aabb<T> bounds() const {
        vec3<T> reach = disc_reach(normal, outer_radius);
        return unless_nan(padded(aabb<T>{center - reach, center + reach}), center, normal, inner_radius, outer_radius);
    }

    RAIO_FN constexpr T area() const {
        return T(pi<T>) * (outer_radius - inner_radius) * (outer_radius + inner_radius);
    }

    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        const T inner2 = inner_radius * inner_radius, phi = T(2 * pi<T>) * u.x;
        const T rho = sqrt(inner2 + u.y * (outer_radius * outer_radius - inner2));
        const frame<T> f = frame_about(normalize(normal));
        return {center + f.to_world({rho * cos(phi), rho * sin(phi), T(0)}), f.z};
    }

    template <class Line>
    RAIO_FORMULA constexpr crossing<typename Line::number> crossings(const Line& line) const {
        return detail::cross_between_rims(line.direction(), line.given(normal), line.to(center),
                                          line.given(inner_radius), line.given(outer_radius));
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        at.record_point();
        at.keep_in([this] { return bounds(); });
        put_onto_plane(at, normal, center);
        at.record_normal(normal);
        at.record_uv([&] {
            vec3<T> up(normalize_from<T>(vec3<typename Point::precise>(normal)));
            vec3<T> local = frame_about(up).to_local(at.point() - center);
            const T rho = sqrt(local.x * local.x + local.y * local.y);
            const T across = (rho - inner_radius) / (outer_radius - inner_radius);
            return vec2<T>(turns(local.y, local.x), max(T(0), min(T(1), across)));
        });
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
