#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/formula/sweep.hpp>
#include <raio/math/angle.hpp>
#include <raio/math/bezier.hpp>
#include <raio/math/frame.hpp>

namespace raio {

/// A round curve: what a sphere sweeps whose centre C follows a cubic Bezier curve while its radius r, a cubic as well,
/// changes with it.
///
/// A line goes into the sphere of the parameter u and out of it at (see formula/sphere.hpp; s > 0 where it meets it)
///
///     t = (b -+ sqrt(s)) / d.d,    b = (C - origin).d,    s = d.d r^2 - |(C - origin) x d|^2
///
/// Where s >= 0 along a stretch of the curve, the line is inside from the least of these t to the greatest. They are at
/// the ends of the curve, or where the derivative of t is zero: 4 s b'^2 = s'^2, a polynomial of degree 10 (van Wijk,
/// Computers & Graphics 9(3), 1985). Its roots, and those of s, are isolated; t does not change with u there, so that
/// it is as exact as the square of what a root is off by. What is within another part of the curve is no surface.
///
/// The answers are as exact as those of any other shape: for float always, for double as long as 106 bits can tell. A
/// tip, where the radius is zero, they cannot tell from 2^-40 of the size beyond it.
///
/// uv: u is the angle about the direction of the curve at that sphere, from the x axis of `frame_about` of it; v is the
/// parameter of the curve, 0 at p0 and 1 at p3.
template <real T>
struct bezier_curve {
    using number = T;

    vec3<T> p0, p1, p2, p3;  ///< control points: it begins at p0 towards p1, and ends at p3, coming from p2
    T r0, r1, r2, r3;        ///< radii in the same order; missed if one is below zero, or all are zero

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr auto spans(const ray<T>& ray) const requires(std::same_as<mask_t<T>, bool>) {
        return inside_of(*this, ray);
    }

    /// Around the spheres of the control points: each one that is swept is a mean of them. And around the tips, which
    /// even 106 bits cannot tell from a little beyond.
    RAIO_FN constexpr aabb<T> bounds() const {
        const aabb<T> box = around_controls();
        vec3<T> blur(T(0x1p-40) * norm1(vec3<T>(box.max - box.min)));
        return padded(padded(aabb<T>{box.min - blur, box.max + blur}));
    }

    template <class Line>
    RAIO_FORMULA constexpr crossing_list<typename Line::number, 14> crossings(const Line& line) const {
        using W = typename Line::number;
        const aabb<T> box = around_controls();
        vec3<W> low(box.min), high(box.max);
        const W size = length(high - low) * W(0.5);
        crossing_list<W, 14> list;
        if (!is_sound()) return list;
        const auto part = part_near(line, p0, low + (high - low) * W(0.5), size);
        list.depends_on(part);
        if (!part.exists) return list;

        // (Both factors count as rounded.)
        const auto along = line.direction() * rounded_number<W, 1>{part.half};
        const detail::sweep<W> swept = sweep_along(part, along, given_number<W>{W(1) / size});
        const auto stretches = stretches_below_zero(swept.minus_s.value, W(0), W(1));
        chord_list<W, 7> inside;
        for (const stretch<W>& where : stretches) inside.insert(swept.extent(part, where));
        list.depends_on(stretches);
        list.append(inside, part.half * W(0x1p-20));
        return list;
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        const raio::crossing<W>& c = at.crossing();
        vec3<W> from_center = at.from(p0), ahead(W(0));
        // The normal depends on more digits of u than t does. What double takes for an end may be a turn before it.
        const sphere_near<W> found = sphere_at(from_center, c.u, bound_t<W>(0));
        W longest = c.v;
        if constexpr (!last_precision<W>) {
            if (!(longest > W(0))) longest = found.unnoticed(at.direction() * W(c.error));
        }
        W u = max(W(0), min(W(1), c.u + found.further(longest)));
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            const polynomial<W, 3> center = coordinate<W>(axis);
            from_center[axis] -= center(u), ahead[axis] = center.derivative()(u);
        }
        const aabb<T> box = around_controls();
        const T size = norm1(vec3<T>(box.max - box.min));
        // From where on s is certain, of a curve of 2^-30 of its length; or as far as a tangent may be off, at which
        // such an s has no certain root.
        T apart = T(0x1p-60) * size;
        if constexpr (last_precision<W>) apart = max(apart, T(at.blur()));

        at.record_point(size);
        at.add_error(apart);
        at.keep_in([this] { return bounds(); });
        at.record_gradient(from_center);
        at.record_uv([&] {
            using Q = typename Point::precise;
            vec3<Q> onwards(scaled_into_range<Q>(vec3<Q>(ahead))), outward(from_center);
            const bool still = !(norm1(onwards) > Q(0));
            const frame<Q> f = frame_about(still ? vec3<Q>(Q(0), Q(0), Q(1)) : normalize(onwards));
            return vec2<T>(turns(T(dot(outward, f.y)), T(dot(outward, f.x))), max(T(0), min(T(1), T(u))));
        });
    }

private:
    RAIO_FN constexpr aabb<T> around_controls() const {
        const auto around = [](const vec3<T>& p, T r) { return aabb<T>{p - vec3<T>(r), p + vec3<T>(r)}; };
        return hull(hull(around(p0, r0), around(p1, r1)), hull(around(p2, r2), around(p3, r3)));
    }

    /// The sphere of u, and what a point p makes of it, b as seen from its centre C: the level g = |b|^2 - r^2 is zero
    /// at a crossing, and so is its slope
    ///
    ///     g_u / -2 = h = b.C' + r r',    with the slope  h_u = b.C'' - C'.C' + r'^2 + r r''
    ///
    /// unless u is an end of the curve.
    template <class W>
    struct sphere_near {
        std::array<cubic_near<W>, 3> center;
        cubic_near<W> radius;
        W h, h_u;
        vec3<W> b{};  ///< p, as seen from the centre

        /// How far on the sphere is of which h is 0: one step of Newton's method, if it is no longer than that.
        RAIO_FN constexpr W further(const W& longest) const {
            return max(-longest, min(longest, -quotient(h, h_u, W(0))));
        }

        /// How far from a turn of t a sphere can be without t telling them apart, if p may be off by a step: that
        /// changes the level by no more than 2 b.step + step^2, and u does by -h_u u^2.
        RAIO_FN constexpr W unnoticed(const vec3<W>& step) const {
            const W change = abs(dot(b, step)) * W(2) + dot(step, step);
            return h_u < W(0) ? sqrt(change / -h_u) : W(0);
        }
    };

    /// \param p    as seen from p0
    /// \param end  how far along the curve bounds are wanted
    template <class W>
    RAIO_FN constexpr sphere_near<W> sphere_at(const vec3<W>& p, const W& u, const bound_t<W>& end) const {
        const auto center = [&](glm::length_t axis) { return cubic_near<W>(coordinate<W>(axis), u, end); };
        const cubic_near<W> r(radii<W>(), u, end);
        sphere_near<W> s{{center(0), center(1), center(2)}, r, r.value * r.slope, r.slope * r.slope + r.value * r.bend};
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            const cubic_near<W>& c = s.center[static_cast<std::size_t>(axis)];
            s.b[axis] = p[axis] - c.value;
            s.h += s.b[axis] * c.slope, s.h_u += s.b[axis] * c.bend - c.slope * c.slope;
        }
        return s;
    }

    RAIO_FN constexpr bool is_sound() const {
        const T least = min(min(r0, r1), min(r2, r3)), most = max(max(r0, r1), max(r2, r3));
        return is_finite(p0) && is_finite(p1) && is_finite(p2) && is_finite(p3) && least >= T(0) && most > T(0) &&
               is_finite(r0 + r1 + r2 + r3);
    }

    /// Of the centre, as seen from p0.
    template <class W>
    RAIO_FN constexpr polynomial<W, 3> coordinate(glm::length_t axis) const {
        return bezier_from_start<W>(p0[axis], p1[axis], p2[axis], p3[axis]);
    }

    template <class W>
    RAIO_FN constexpr polynomial<W, 3> radii() const {
        return bezier_polynomial<W>(r0, r1, r2, r3);
    }

    /// \param along  of the part
    /// \param unit   1 over the unit of length
    template <class W, proven_vector Along>
    RAIO_FN constexpr detail::sweep<W> sweep_along(const line_part<W>& part, const Along& along,
                                                   const given_number<W>& unit) const {
        const polynomial_vector<W, 1> p = part.point();
        const polynomial_vector<W, 3> center{coordinate<W>(0), coordinate<W>(1), coordinate<W>(2)};
        const polynomial_vector<W, 3> to_center{(center[0] - p[0][0]) * unit, (center[1] - p[1][0]) * unit,
                                                (center[2] - p[2][0]) * unit};
        const auto d = along * unit;
        const auto d2 = square(d);
        return {d2, {dot(to_center, d)}, {square(cross(to_center, d)) - square(radii<W>() * unit) * d2}};
    }
};

}  // namespace raio

#include <raio/pop_macros.hpp>
