#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/formula/sphere.hpp>
#include <raio/math/angle.hpp>

namespace raio::inline RAIO_ABI {

/// The points whose distances from `center` along the axes, each over its radius, are the coordinates of a point of the
/// unit sphere. Turned about, it is `transformed`.
///
/// A line is mapped so that the ellipsoid becomes a sphere, and its direction is not made unit again: t stays what it
/// is. Each coordinate is multiplied by the two radii of the other axes, which needs no division and makes a sphere
/// whose radius is the product of all three; for its crossings see formula/sphere.hpp.
///
/// uv: that of the sphere; u is the angle about +y from +x towards -z, v the latitude, 0 at the lowest y and 1 at the
/// highest.
template <real T>
struct ellipsoid {
    using number = T;

    vec3<T> center;
    vec3<T> radii;  ///< along the axes: lengths; the ellipsoid is missed unless each is positive

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr interval<T> spans(const ray<T>& ray) const { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const {
        return unless_nan(padded(aabb<T>{center - radii, center + radii}), center, radii);
    }

    template <class Line>
    [[gnu::always_inline]] RAIO_FORMULA constexpr chord<typename Line::number> crossings(const Line& line) const {
        using W = typename Line::number;
        auto r = line.given(radii);
        rounded_vector<W, 1> stretch{r.y * r.z, r.z * r.x, r.x * r.y};
        rounded_number<W, 2> radius{r.x * stretch.x};
        const auto power = [&](const auto& origin) {
            using D = wide_t<W>;
            vec3<D> exactly = to_sphere<D>();
            return power_of_point<2, W>(exactly * difference_as<D>(center, origin), D(radii.x) * exactly.x);
        };
        chord<W> c = cross_sphere_along<T>(line, stretch * line.to(center), stretch * line.direction(), radius, power);
        keep_if(every(radii.x > T(0), radii.y > T(0), radii.z > T(0)), c);
        return c;
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        using Q = typename Point::precise;
        vec3<W> stretch = to_sphere<W>(), on_sphere = at.from(center) * stretch;
        const T longest = max(radii.x, max(radii.y, radii.z)), shortest = min(radii.x, min(radii.y, radii.z));
        at.record_point(min(longest * (longest / shortest), T(std::numeric_limits<scalar_t<T>>::max() / 4)));
        at.keep_in([this] { return bounds(); });
        // A fifth power of lengths: its square may be out of range.
        at.record_normal(scaled_into_range<Q>(vec3<Q>(on_sphere * stretch)));
        at.record_uv([&] {
            vec3<T> unit(normalize_from<T>(vec3<Q>(on_sphere)));
            return vec2<T>(turns(-unit.z, unit.x), latitude(unit.y, sqrt(unit.x * unit.x + unit.z * unit.z)));
        });
    }

private:
    template <class W>
    RAIO_FN constexpr vec3<W> to_sphere() const {
        vec3<W> r(radii);
        return {r.y * r.z, r.z * r.x, r.x * r.y};
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
