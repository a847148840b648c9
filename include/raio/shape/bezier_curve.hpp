#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/formula/sweep.hpp>
#include <raio/math/angle.hpp>
#include <raio/math/bezier.hpp>
#include <raio/math/frame.hpp>

namespace raio::inline RAIO_ABI {

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

    /// Around the spheres of the control points: each one that is swept is a mean of them.
    RAIO_FN constexpr aabb<T> bounds() const { return padded(padded(with_room_for_tips(around_controls()))); }

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
        detail::chord_list<W, 7> inside;
        for (const stretch<W>& where : stretches) inside.insert(swept.extent(part, where));
        list.depends_on(stretches);
        inside.unite_into(list, part.half * W(0x1p-20));
        return list;
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        vec3<W> from_center = at.from(p0), ahead(W(0));
        const W u = parameter_of(at, from_center);
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            const polynomial<W, 3> center = coordinate<W>(axis);
            from_center[axis] -= center(u), ahead[axis] = center.derivative()(u);
        }
        const aabb<T> box = around_controls();
        const T size = norm1(vec3<T>(box.max - box.min));

        at.record_point(size);
        at.add_error(max(error_of_sweep(size), error_of_tangent(at)));
        at.keep_in([this] { return bounds(); });
        at.record_gradient(from_center);
        at.record_uv([&] {
            using Q = typename Point::precise;
            vec3<Q> onwards(scaled_into_range<Q>(vec3<Q>(ahead)));
            const bool still = !(norm1(onwards) > Q(0));
            const frame<Q> f = frame_about(still ? vec3<Q>(Q(0), Q(0), Q(1)) : normalize(onwards));
            return uv_about(f, vec3<Q>(from_center), T(u));
        });
    }

private:
    RAIO_FN constexpr aabb<T> around_controls() const {
        const auto around = [](const vec3<T>& p, T r) { return aabb<T>{p - vec3<T>(r), p + vec3<T>(r)}; };
        return hull(hull(around(p0, r0), around(p1, r1)), hull(around(p2, r2), around(p3, r3)));
    }

    /// The parameter of the sphere that a point p lies on. A normal asks for more digits of u than t does: with b from
    /// the centre of the sphere to p, the level |b|^2 - r^2 is zero at a crossing, and so is its slope,
    ///
    ///     -2 h,    h = b.C' + r r',    of which the slope is  h_u = b.C'' - C'.C' + r'^2 + r r''
    ///
    /// unless u is an end of the curve. One step of Newton's method finds more digits.
    /// \param p  as seen from p0
    template <class Point, class W = typename Point::number>
    RAIO_FN constexpr W parameter_of(const Point& at, const vec3<W>& p) const {
        const W u = at.crossing().u;
        const auto [r, widening, flare] = derivatives_at(radii<W>(), u);
        W h = r * widening, h_u = widening * widening + r * flare;
        vec3<W> b(W(0));
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            const auto [c, slope, bend] = derivatives_at(coordinate<W>(axis), u);
            b[axis] = p[axis] - c;
            h += b[axis] * slope, h_u += b[axis] * bend - slope * slope;
        }
        // If p moves by a step, the level changes by no more than 2 b.step + step^2, and if u does, by -h_u u^2: so far
        // from a turn of t a sphere can be without t telling them apart.
        const W longest = error_of_place(at.crossing(), [&](const W& t_error) {
            const vec3<W> step = at.direction() * t_error;
            const W change = abs(dot(b, step)) * W(2) + dot(step, step);
            return h_u < W(0) ? sqrt(change / -h_u) : W(0);
        });
        return max(W(0), min(W(1), u + max(-longest, min(longest, -quotient(h, h_u, W(0))))));
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

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
