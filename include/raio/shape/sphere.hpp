#pragma once

#include <raio/concepts.hpp>
#include <raio/math/angle.hpp>
#include <raio/math/quadratic.hpp>
#include <raio/surface_sample.hpp>

namespace raio {

/// The points at distance `radius` from `center`.
///
/// With l = center - origin, the point at t lies on the sphere where |t d - l|^2 = radius^2:
///
///     t = (b -+ s) / a,    a = d.d,  b = l.d,  s^2 = a radius^2 - |l x d|^2
///
/// b / a is the closest approach to the centre, s / a half a chord, and |l x d| / |d| the distance at which the line
/// passes the centre. Written with that distance, s^2 is not a difference of large squares, which is what loses small
/// and far spheres (Haines, Guenther and Akenine-Moeller, Ray Tracing Gems ch. 7, 2019).
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
    RAIO_FN constexpr chord<W> crossings(const ray<R>& ray) const {
        using E = bound_t<W>;
        vec3<W> d(ray.direction), l = vec3<W>(center) - vec3<W>(ray.origin), moment = cross(l, d);
        W a = dot(d, d), b = dot(l, d), ar2 = a * W(radius) * W(radius), passed2 = dot(moment, moment);
        W s2 = ar2 - passed2;

        // With u the unit roundoff, l x d is off by less than 4 u |l| |d|, and that decides whether the line passes
        // by. The size of a vector is the sum of its components here.
        constexpr double u = unit_roundoff<W>, least = least_normal<W>;
        E l_size = norm1(vec3<E>(l)), d_size = norm1(vec3<E>(d)), moment_error = E(4 * u) * l_size * d_size;
        E s2_error = moment_error * (E(2) * norm1(vec3<E>(moment)) + moment_error) + E(8 * u) * (E(ar2) + E(passed2));
        s2_error = with_underflow<W>(s2_error);
        // A sphere so small that the last precision cannot tell it from its centre has no normal: it is missed.
        E resolved = tie<W>(E(0x1p24 * u * u) * (E(b) * E(b)));
        const mask_t<W> exists = every(s2 >= -tie<W>(s2_error), ar2 >= W(least) + resolved, radius > T(0));
        // A chord above a 32nd of the diameter: its ends are then right to 2^9 u of their distance.
        const mask_t<W> long_chord = every(s2 > s2_error, s2 > W(0x1p-10) * ar2);
        const mask_t<W> certain = every(a >= W(least), some(s2 < -s2_error, long_chord));
        if (none(exists)) return {{exists, certain, W(0), E(0), exists}, {exists, certain, W(0), E(0), exists}};

        W s = sqrt(max(s2, W(0))), over_a = W(1) / a;
        E error = with_underflow<W>(E(0x1p9 * u) * d_size * (l_size + E(radius)) * E(over_a));
        vec2<W> t = quadratic_roots(over_a, b, dot(l, l) - W(radius) * W(radius), s);
        return {{exists, certain, t.x, error, exists}, {exists, certain, t.y, error, !exists}};
    }

    template <class W, real R, real N>
    RAIO_FN constexpr void surface(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec) const {
        using Q = quick_t<N>;
        vec3<W> from_center = (vec3<W>(ray.origin) - vec3<W>(center)) + vec3<W>(ray.direction) * c.t;
        vec3<N> outward(normalize_from<T>(vec3<Q>(from_center)));
        record_point(ray, c, rec, radius);
        rec.normal = outward * select(c.entering, N(1), N(-1));
        // Angles do not ask for unit length: they need not wait for the root.
        vec3<T> scaled(vec3<Q>(from_center) * (Q(1) / Q(radius)));
        rec.uv = {turns(-scaled.z, scaled.x), latitude(scaled.y, sqrt(scaled.x * scaled.x + scaled.z * scaled.z))};
    }
};

}  // namespace raio
