#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/formula/sphere.hpp>
#include <raio/math/angle.hpp>
#include <raio/surface_sample.hpp>

namespace raio::inline RAIO_ABI {

/// The ball: its surface is at distance `radius` from `center`.
///
/// It reads as every shape does: `crossings` says where a line enters it and where it leaves, `surface` what is
/// recorded of such a point. `hit`, `occluded` and `spans` choose among the crossings (proof/settle.hpp).
///
/// With the ray's direction d and l from its origin to the centre, the point at t lies on it where |t d - l| = radius:
///
///     t = (b -+ s) / a,   a = d.d,   b = l.d,   s^2 = b^2 - a (l.l - radius^2) = a radius^2 - |l x d|^2
///
/// (formula/sphere.hpp: `cross_sphere`; what else stands there saves time). uv: u is the angle about +y from +x towards
/// -z, in turns, v the latitude, 0 at the lowest y and 1 at the highest.
template <real T>
struct sphere {
    using number = T;

    vec3<T> center;
    T radius;  ///< a length; the sphere is missed unless it is positive

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr interval<T> spans(const ray<T>& ray) const { return inside_of(*this, ray); }

    /// Larger by a rounding or two, so that points which were rounded lie within. NaN, if a field is.
    RAIO_FN constexpr aabb<T> bounds() const {
        return unless_nan(padded(aabb<T>{center - vec3<T>(radius), center + vec3<T>(radius)}), center, radius);
    }

    RAIO_FN constexpr T area() const { return T(4 * pi<T>) * radius * radius; }

    /// The point that two numbers in [0, 1) choose: u.x is the u of its uv, u.y its height from the lowest point on,
    /// over the diameter: equal steps of height cut off equal areas (Archimedes).
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        const T y = T(2) * u.y - T(1), rho = sqrt(max(T(0), T(1) - y * y)), phi = T(2 * pi<T>) * u.x;
        vec3<T> normal(rho * cos(phi), y, -rho * sin(phi));
        return {center + normal * radius, normal};
    }

    /// Where the ray's line enters the sphere and where it leaves it. Numbers carry bounds of their errors
    /// (proof/line.hpp), and whether a comparison of them holds may be in doubt: `every` and `some` combine such
    /// verdicts, `all` asks whether one holds beyond doubt, `any` whether it may hold (number/verdict.hpp). What
    /// RAIO_FN and RAIO_FORMULA tell compilers: config.hpp.
    template <class Line>
    [[gnu::always_inline]] RAIO_FORMULA constexpr chord<typename Line::number> crossings(const Line& line) const {
        return cross_sphere_about(center, radius, line);
    }

    /// Does the ray's line miss, beyond doubt? Asked before `crossings`: most spheres of a scene are missed.
    RAIO_FN constexpr bool is_passed_by(const ray<T>& ray) const requires std::floating_point<T> {
        return passes_sphere(center, radius, ray);
    }

    /// What `hit` records of a point of the surface.
    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        auto outward = at.from(center);           // to the point
        at.record_point(radius);                  // how the surface bends counts in the error bound
        at.keep_in([this] { return bounds(); });  // where that is large, the point may lie beyond them
        at.record_normal(outward, radius);
        at.record_uv([&] {
            using Q = typename Point::precise;  // doubles; of a `quick` shape, its own numbers
            vec3<T> unit(vec3<Q>(outward) * (Q(1) / Q(radius)));
            return vec2<T>(turns(-unit.z, unit.x), latitude(unit.y, sqrt(unit.x * unit.x + unit.z * unit.z)));
        });
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
