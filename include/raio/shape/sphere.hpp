#pragma once

#include <raio/concepts.hpp>
#include <raio/formula/sphere.hpp>
#include <raio/math/angle.hpp>
#include <raio/surface_sample.hpp>

namespace raio {

/// The points at distance `radius` from `center`.
///
/// The point at t of a line lies on it where |t d - l| = radius, with l from the point where t = 0 to the centre:
///
///     t = (b -+ s) / a,   a = d.d,   b = l.d,   s^2 = b^2 - a (l.l - radius^2) = a radius^2 - |l x d|^2
///
/// That is `cross_sphere` in formula/sphere.hpp.
///
/// uv: u is the angle about +y from +x towards -z, v the latitude, 0 at the lowest y and 1 at the highest.
template <real T>
struct sphere {
    using number = T;

    vec3<T> center;
    T radius;  ///< a length; the sphere is missed unless it is positive

    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr interval<T> spans(const ray<T>& ray) const { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const {
        return padded(aabb<T>{center - vec3<T>(radius), center + vec3<T>(radius)});
    }

    RAIO_FN constexpr T area() const { return T(4 * pi<T>) * radius * radius; }

    /// `u` in [0, 1)^2, as the sphere's uv but for v, which is the height here (Archimedes).
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        const T y = T(2) * u.y - T(1), rho = sqrt(max(T(0), T(1) - y * y)), phi = T(2 * pi<T>) * u.x;
        vec3<T> normal(rho * cos(phi), y, -rho * sin(phi));
        return {center + normal * radius, normal};
    }

    template <class W, real R>
    [[gnu::always_inline]] RAIO_FORMULA constexpr chord<W> crossings(const ray<R>& ray) const {
        line<W, R> line{ray};
        const auto power = [&] {
            using D = wide_t<W>;
            return power_of_point<1, W>(difference_as<D>(center, ray.origin), D(radius));
        };
        return cross_sphere_along(line, line.to(center), line.direction(), line.given(radius), power);
    }

    template <class W, real R, real N>
    RAIO_FN constexpr void surface(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec) const {
        using Q = working_t<N>;
        vec3<W> from_center = seen_from(center, ray, c.t);
        vec3<N> outward(normalize_from<T>(vec3<Q>(from_center)));
        record_point(ray, c, rec, radius);
        keep_unrounded_in_bounds(rec, [this] { return bounds(); });
        rec.normal = outward * select(c.entering, N(1), N(-1));
        // Angles do not ask for unit length: they need not wait for the root.
        vec3<T> scaled(vec3<Q>(from_center) * (Q(1) / Q(radius)));
        rec.uv = {turns(-scaled.z, scaled.x), latitude(scaled.y, sqrt(scaled.x * scaled.x + scaled.z * scaled.z))};
    }
};

}  // namespace raio
