#pragma once

#include <raio/push_macros.hpp>

#include <raio/shape/cylinder.hpp>
#include <raio/shape/sphere.hpp>

namespace raio::inline RAIO_ABI {

/// The points at most `radius` from the segment between `base` and `top`: a cylinder with round ends. A line is inside
/// from where it enters the first of the cylinder and the two spheres to where it leaves the last of them; where base
/// and top are one, that is a sphere.
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

    RAIO_FN constexpr aabb<T> bounds() const { return hull(low_end().bounds(), high_end().bounds()); }

    RAIO_FN constexpr T area() const { return T(2 * pi<T>) * radius * (length(top - base) + T(2) * radius); }

    /// Along the axis the area is spread evenly, on the round ends as well (Archimedes): `u` is the uv.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        vec3<T> axis = top - base;
        const T size = length(axis), height = u.y * (size + T(2) * radius) - radius, phi = T(2 * pi<T>) * u.x;
        const frame<T> f = frame_about(size > T(0) ? axis / size : vec3<T>(T(0), T(0), T(1)));
        const T on_axis = max(T(0), min(size, height)), rise = max(T(-1), min(T(1), (height - on_axis) / radius));
        const T rho = sqrt(max(T(0), T(1) - rise * rise));
        vec3<T> normal = f.to_world({rho * cos(phi), rho * sin(phi), rise});
        return {base + f.z * on_axis + normal * radius, normal};
    }

    template <class Line>
    RAIO_FORMULA constexpr chord<typename Line::number> crossings(const Line& line) const {
        auto c = detail::cross_endless_cylinder(base, top, radius, line);
        const auto axis2 = square(line.between(base, top));
        if (missed(c) && all(is_positive(axis2))) return c;  // without an axis there still is a sphere
        c = intersect(c, detail::cross_cap_planes(base, top, line));
        c = detail::with_round_ends(c, low_end(), high_end(), line);
        // Of an axis 2^60 radii long the axis is all that can be seen, and it has no normal.
        const auto r = line.given(radius);
        const auto slim = line.given(T(0x1p-120));
        c = only_if(r * r >= axis2 * slim, c);
        keep_if_in_range<T>(line, c);  // no point beyond the largest number
        return c;
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        using Q = typename Point::precise;
        vec3<W> axis = difference_as<W>(top, base), from_base = at.from(base);
        W axis2 = dot(axis, axis), along = quotient(dot(from_base, axis), axis2, W(0));
        // At the upper end, which may be far from the base, the distance is measured from there.
        vec3<W> beside = from_base - axis * max(W(0), along);
        vec3<Q> from_axis(select(along >= W(1), at.from(top), beside));
        at.record_point(radius);
        at.keep_in([this] { return bounds(); });
        at.record_normal(from_axis);
        at.record_uv([&] {
            const mask_t<T> is_long = T(axis2) > T(0);
            vec3<T> up(normalize(select(is_long, vec3<Q>(axis), vec3<Q>(Q(0), Q(0), Q(1))))), from_center(from_axis);
            const frame<T> f = frame_about(up);
            const T size = T(sqrt(axis2)), rise = dot(from_center, up),
                    height = max(T(0), min(T(1), T(along))) * size + rise;
            return vec2<T>(turns(dot(from_center, f.y), dot(from_center, f.x)),
                           max(T(0), min(T(1), (height + radius) / (size + T(2) * radius))));
        });
    }

private:
    RAIO_FN constexpr sphere<T> low_end() const { return {base, radius}; }
    RAIO_FN constexpr sphere<T> high_end() const { return {top, radius}; }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
