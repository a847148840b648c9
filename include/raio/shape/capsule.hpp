#pragma once

#include <raio/push_macros.hpp>

#include <raio/shape/cylinder.hpp>
#include <raio/shape/round_cone.hpp>

namespace raio::inline RAIO_ABI {

/// The points at most `radius` from the segment between `base` and `top`: a cylinder with round ends. A line is inside
/// from where it enters the first of the cylinder and the two spheres to where it leaves the last of them; where base
/// and top are one, that is a sphere. All else is as of a round cone with equal radii.
///
/// uv: u is the angle about the axis in turns, from the x axis of `frame_about(top - base)`; v the height, 0 at the
/// lower pole and 1 at the upper one.
template <real T>
struct capsule {
    using number = T;

    vec3<T> base, top;  ///< the centres of the round ends
    T radius;           ///< a length; the capsule is missed unless it is positive, and above 2^-60 of the axis

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr interval<T> spans(const ray<T>& ray) const { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const { return as_round_cone().bounds(); }

    RAIO_FN constexpr T area() const { return as_round_cone().area(); }

    /// Along the axis the area is spread evenly, on the round ends as well (Archimedes): `u` is the uv.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const requires(std::same_as<mask_t<T>, bool>) {
        return as_round_cone().sample(u);
    }

    template <class Line>
    RAIO_FORMULA constexpr chord<typename Line::number> crossings(const Line& line) const {
        auto c = detail::cross_endless_cylinder(base, top, radius, line);
        const auto axis2 = square(line.between(base, top));
        if (missed(c) && all(is_positive(axis2))) return c;  // without an axis there still is a sphere
        c = intersect(c, detail::cross_cap_planes(base, top, line));
        c = detail::with_round_ends(c, sphere<T>{base, radius}, sphere<T>{top, radius}, line);
        // Of an axis 2^60 radii long the axis is all that can be seen, and it has no normal.
        const auto r = line.given(radius);
        const auto slim = line.given(T(0x1p-120));
        c = only_if(r * r >= axis2 * slim, c);
        keep_if_in_range<T>(line, c);  // no point beyond the largest number
        return c;
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        as_round_cone().surface(at);
    }

private:
    RAIO_FN constexpr round_cone<T> as_round_cone() const { return {base, top, radius, radius}; }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
