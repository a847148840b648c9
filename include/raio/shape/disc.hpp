#pragma once

#include <raio/concepts.hpp>
#include <raio/math/angle.hpp>
#include <raio/math/frame.hpp>
#include <raio/plane_crossing.hpp>
#include <raio/surface_sample.hpp>

namespace raio {

/// The points of a plane at most `radius` from `center`: where the ray meets the plane, the squared distance decides.
///
/// uv: u is the angle about the normal, from the x axis of `frame_about(normal)`; v the distance from the centre over
/// the radius.
template <real T>
struct disc {
    using number = T;

    vec3<T> center;
    vec3<T> normal;  ///< any length but zero
    T radius;        ///< a length; the disc is missed unless it is positive

    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    /// Along each axis the disc reaches as far as the radius times the sine of the angle between axis and normal.
    RAIO_FN constexpr aabb<T> bounds() const {
        vec3<T> reach = disc_reach(normal, radius);
        return padded(aabb<T>{center - reach, center + reach});
    }

    RAIO_FN constexpr T area() const { return T(pi<T>) * radius * radius; }

    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        const T rho = radius * sqrt(u.y), phi = T(2 * pi<T>) * u.x;
        const frame<T> f = frame_about(normalize(normal));
        return {center + f.to_world({rho * cos(phi), rho * sin(phi), T(0)}), f.z};
    }

    template <class W, real R>
    RAIO_FN constexpr crossing<W> crossings(const ray<R>& ray) const {
        using E = bound_t<W>;
        auto [c, distance2, distance2_error] = cross_plane_about<W>(center, normal, ray);
        W r2 = W(radius) * W(radius), inner = r2 - distance2;
        E slack = with_underflow<W>(distance2_error + E(8 * unit_roundoff<W>) * E(r2));
        c.exists = every(c.exists, inner >= -tie<W>(slack), radius > T(0));
        c.certain = every(c.certain, abs(inner) > slack);
        return c;
    }

    template <class W, real R, real N>
    RAIO_FN constexpr void surface(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec) const {
        vec3<N> outward(normalize_from<T>(vec3<quick_t<N>>(normal)));
        record_point(ray, c, rec);
        rec.normal = outward * select(c.entering, N(1), N(-1));
        vec3<T> local = frame_about(vec3<T>(outward)).to_local(rec.point - center);
        rec.uv = {turns(local.y, local.x), min(T(1), sqrt(local.x * local.x + local.y * local.y) / radius)};
    }
};

}  // namespace raio
