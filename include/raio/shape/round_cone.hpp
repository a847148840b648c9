#pragma once

#include <raio/push_macros.hpp>

#include <raio/shape/frustum.hpp>
#include <raio/shape/sphere.hpp>

namespace raio::inline RAIO_ABI {

/// All that lies between two spheres: what a sphere sweeps that moves straight from `base` to `top` while its radius
/// changes evenly. A capsule has equal radii.
///
/// It is the two spheres and the cone that touches both, united. With the axis A from the lesser sphere, of radius r,
/// to the other, of radius r + w, and the height h = 0 to 1, the cone is at rho^2 = (r + w h)^2 A.A / D, where D = A.A
/// - w^2: a quadric of revolution, see formula/quadric.hpp. The spheres touch it where (p - center).A = -w radius. If
/// D is not above 0, one sphere is inside of the other.
///
/// uv: u is the angle about the axis in turns, from the x axis of `frame_about(top - base)`; v the height along the
/// axis, 0 at the pole of the base's sphere and 1 at that of the top's.
template <real T>
struct round_cone {
    using number = T;

    vec3<T> base, top;          ///< the centres of the spheres
    T base_radius, top_radius;  ///< lengths; it is missed unless both are positive, and above 2^-60 of the axis

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr interval<T> spans(const ray<T>& ray) const { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const { return hull(low_end().bounds(), high_end().bounds()); }

    RAIO_FN constexpr T area() const {
        const areas parts = areas_of_parts();
        return parts.low + parts.side + parts.high;
    }

    /// u.x turns about the axis, u.y is the area between the pole of the base's sphere and the point.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const requires(std::same_as<mask_t<T>, bool>) {
        const areas parts = areas_of_parts();
        const vec3<T> axis = top - base;
        const T size = length(axis), left = u.y * area();
        T which(0), rise(0);
        if (left < parts.low) {
            rise = left / (T(2 * pi<T>) * base_radius * base_radius) - T(1);
        } else if (left < parts.low + parts.side) {
            which =
                detail::frustum_side<T>{base, top, {base_radius, top_radius}}.height((left - parts.low) / parts.side);
            rise = -parts.sine;
        } else {
            which = T(1);
            rise = T(1) - (area() - left) / (T(2 * pi<T>) * top_radius * top_radius);
        }
        const T radius = base_radius + (top_radius - base_radius) * which, phi = T(2 * pi<T>) * u.x;
        const T rho = sqrt(max(T(0), T(1) - rise * rise));
        const frame<T> f = frame_about(size > T(0) ? axis / size : vec3<T>(T(0), T(0), T(1)));
        vec3<T> normal = f.to_world({rho * cos(phi), rho * sin(phi), rise});
        return {base + axis * which + normal * radius, normal};
    }

    template <class Line>
    RAIO_FORMULA constexpr chord<typename Line::number> crossings(const Line& line) const {
        auto c = detail::with_round_ends(cross_side(line), low_end(), high_end(), line);
        // Of an axis 2^60 radii long the axis is all that can be seen, and it has no normal.
        auto lesser = line.given(min(base_radius, top_radius));
        auto slim = line.given(T(0x1p-120));
        c = only_if(every(is_positive(lesser), lesser * lesser >= square(line.between(base, top)) * slim), c);
        keep_if(every(is_finite(base), is_finite(top), is_finite(base_radius + top_radius)), c);
        keep_if_in_range<T>(line, c);  // no point beyond the largest number
        return c;
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        using Q = typename Point::precise;
        vec3<W> axis = difference_as<W>(top, base), from_base = at.from(base);
        // Which of the swept spheres the point lies on: 0 the base's, 1 the top's.
        W narrowing = W(base_radius) - W(top_radius), axis2 = dot(axis, axis), apart = axis2 - narrowing * narrowing;
        W along = dot(from_base, axis), only = select(narrowing < W(0), W(1), W(0));
        W which = select(apart > W(0), quotient(along - W(base_radius) * narrowing, apart, only), only);
        vec3<W> beside = from_base - axis * max(W(0), which);
        vec3<Q> outward(select(which >= W(1), at.from(top), beside));
        at.record_point(max(base_radius, top_radius));
        at.keep_in([this] { return bounds(); });
        at.record_normal(outward);
        at.record_uv([&] {
            vec3<T> up(normalize(select(axis2 > W(0), vec3<Q>(axis), vec3<Q>(Q(0), Q(0), Q(1))))), from_center(outward);
            const frame<T> f = frame_about(up);
            const W size = sqrt(axis2), height = quotient(along, size, from_base.z);  // without an axis, along z
            return uv_about(f, from_center, T((T(height) + base_radius) / (T(size) + base_radius + top_radius)));
        });
    }

private:
    /// What is left of the base's sphere, of the cone and of the top's sphere, and how much wider the cone gets with
    /// each length of the axis.
    struct areas {
        T low, side, high, sine;
    };
    RAIO_FN constexpr areas areas_of_parts() const {
        const T size = length(top - base), widening = top_radius - base_radius;
        const mask_t<T> sided = abs(widening) < size;
        const T sine = select(sided, quotient(widening, size, T(0)), copysign(T(1), widening));
        const T apart = select(sided, quotient((size - widening) * (size + widening), size, T(0)), T(0));
        return {T(2 * pi<T>) * base_radius * base_radius * (T(1) - sine), T(pi<T>) * (base_radius + top_radius) * apart,
                T(2 * pi<T>) * top_radius * top_radius * (T(1) + sine), sine};
    }

    RAIO_FN constexpr sphere<T> low_end() const { return {base, base_radius}; }
    RAIO_FN constexpr sphere<T> high_end() const { return {top, top_radius}; }

    /// The same, with the lesser sphere first.
    RAIO_FN constexpr round_cone narrow_first() const {
        const mask_t<T> turned = top_radius < base_radius;
        return {choose(turned, top, base), choose(turned, base, top), min(base_radius, top_radius),
                max(base_radius, top_radius)};
    }

    /// The chord through the cone that touches both spheres, between the circles where it does.
    template <class Line>
    RAIO_FN constexpr auto cross_side(const Line& line) const {
        const round_cone s = narrow_first();
        auto axis = line.between(s.base, s.top);
        auto l = line.to(s.base);
        auto d = line.direction();
        auto r = line.given(s.base_radius);
        auto greater = line.given(s.top_radius);
        auto w = line.between(s.base_radius, s.top_radius);
        auto axis2 = square(axis);
        auto apart = axis2 - w * w;
        auto scale = axis2 * inverse(apart);
        zero_number<typename Line::number> zero;
        turned_conic cone{scale * (r * r), scale * (r * w), scale * (w * w), zero};
        auto c = detail::one_nappe(cross_quadric(d, l, axis, cone, greater), dot(d, axis));
        auto to_base = dot(axis, l) - w * r;
        auto to_top = dot(axis, line.to(s.top)) - w * greater;
        // Spheres that touch from inside leave no side between them.
        return only_if(is_positive(apart), intersect(c, detail::cross_slab(axis, to_base, to_top, d)));
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
