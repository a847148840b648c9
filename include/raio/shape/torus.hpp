#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/math/angle.hpp>
#include <raio/math/frame.hpp>
#include <raio/math/newton.hpp>
#include <raio/proof/line_part.hpp>
#include <raio/surface_sample.hpp>

namespace raio::inline RAIO_ABI {

/// The points at most `minor_radius` from the circle of radius `major_radius` about `center`, across `axis`: a solid
/// ring. If the minor radius is the larger one, it has no hole, and what its surface would be inside of itself does not
/// count.
///
/// Let p be a point as seen from the centre, z its height above the plane of the circle and rho its distance from the
/// axis, R the major radius and r the minor one. In the plane of p and the axis the tube is a disc: its edge is where
/// z^2 + (rho - R)^2 = r^2, or p.p + R^2 - r^2 = 2 R rho, since p.p = z^2 + rho^2. Squared, that is free of the root in
/// rho:
///
///     f = (p.p + R^2 - r^2)^2 - 4 R^2 rho^2 = 0,    rho^2 = p.p - (p.A)^2 / A.A,    A = axis
///
/// The square has added the points where p.p + R^2 - r^2 = -2 R rho. There are some only if r > R: they are the surface
/// that does not count.
///
/// With the ray's direction d and l from its origin to the centre, p = t d - l along the line, and f is a polynomial of
/// degree 4. It is written about the closest approach q of the line to the centre, p = q + x e, for two reasons.
/// However far away the ray starts, q and e are of the size of the torus: no large powers of the distance are
/// subtracted. And q.e = 0, so that p.p = q.q + x^2 e.e has no linear term, and f no cubic one:
///
///     f = (g^2 + qb^2 - 4 R^2 q.q) + 2 qb eb x + (2 g e.e + eb^2 - 4 R^2 e.e) x^2 + (e.e)^2 x^4
///     g = q.q + R^2 - r^2,  qb = q.B,  eb = e.B,    B = 2 R A / |A|
///
/// Of such a depressed quartic one knows where it is convex and where concave. So the first root, or its absence, is
/// mostly found without the roots of its derivative (math/depressed_quartic.hpp). The unit of length is the radius of a
/// sphere about the torus, and x = -1 and 1 are where the line enters and leaves that: every coefficient is at most 16,
/// and all four roots lie between.
///
/// uv: u is the angle about the axis in turns, from the x axis of `frame_about(axis)`; v the angle about the circle in
/// turns, which starts outside and rises towards +axis.
template <real T>
struct torus {
    using number = T;

    vec3<T> center;
    vec3<T> axis;    ///< of any length but zero
    T major_radius;  ///< of the circle, positive
    T minor_radius;  ///< of the tube, positive

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr raio::spans<T, 2> spans(const ray<T>& ray) const { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const {
        vec3<T> reach = disc_reach(axis, major_radius) + vec3<T>(minor_radius);
        return unless_nan(padded(padded(aabb<T>{center - reach, center + reach})), center, axis, major_radius,
                          minor_radius);
    }

    RAIO_FN constexpr T area() const { return T(4 * pi<T>) * minor_radius * strip(widest()); }

    /// u.x turns about the axis; u.y is the area between the inside of the tube and the point.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        const T end = widest(), wanted = (T(2) * u.y - T(1)) * strip(end);
        const T psi = newton_between(
            -end, end, T(0), [&](T angle) { return strip(angle) - wanted; },
            [&](T angle) { return major_radius + minor_radius * cos(angle); });
        const frame<T> f = frame_about(normalize(axis));
        const T phi = T(2 * pi<T>) * u.x;
        vec3<T> outwards = f.x * cos(phi) + f.y * sin(phi);
        vec3<T> normal = normalize(outwards * cos(psi) + f.z * sin(psi));
        return {center + outwards * major_radius + normal * minor_radius, normal};
    }

    /// Where the ray's line enters and where it leaves. Numbers carry bounds of their errors (proof/line.hpp), and
    /// whether a comparison of them holds may be in doubt: `every` and `some` combine such verdicts, `all` asks whether
    /// one holds beyond doubt, `any` whether it may hold (number/verdict.hpp).
    /// \param wanted  which of the crossings: of a ring the first may be found without the others
    template <class Line, class Wanted = every_crossing, class W = typename Line::number>
    RAIO_FORMULA constexpr crossing_list<W, 4> crossings(const Line& line, const Wanted& wanted = {}) const {
        const auto d = line.direction();
        const auto given_axis = line.given(axis);
        const auto l = line.to(center);
        const auto moment = cross(l, d);
        const auto major = line.given(major_radius);
        const auto tube = line.given(minor_radius);
        // A sphere about the torus, a little larger than needed, so that the surface keeps clear of x = -1 and 1.
        const auto size = as_given((major + tube) * line.given(W(1 + 0x1p-10)));
        const auto d2 = square(d);
        const auto reach2 = d2 * size * size;
        const auto passed2 = square(moment);
        crossing_list<W, 4> list;  // `holds` remembers what was in doubt: then so is the list
        if (!list.holds(every(is_positive(reach2), reach2 >= passed2))) return list;

        // t = middle + x half, |x| <= 1 in the sphere; p = q + x e, in lengths of `size`, as all that follows. (Any
        // size and any half will do, if all that follows has the same: so these two are taken as given.)
        const auto over_d2 = inverse(d2);
        const auto over_size = inverse(size);
        const auto middle = dot(l, d) * over_d2;
        const auto half = as_given(sqrt(reach2 - passed2) * over_d2);
        const auto q = cross(moment, d) * (over_d2 * over_size);
        const auto e = d * (half * over_size);
        const auto axis2 = square(given_axis);
        const auto exists = every(is_positive(major), is_positive(tube), is_positive(axis2), is_positive(half));
        // From so far away that q is not known to a small part of the torus' size, nothing can be told of it.
        if (!list.holds(every(exists, is_located(q, line.given(W(1)))))) return list;

        const auto two = line.given(W(2));
        const auto zero = line.given(W(0));
        const auto major2 = square(major * over_size);
        const auto tube2 = square(tube * over_size);
        const auto four_major2 = two * two * major2;
        const auto scaled_axis = given_axis * (two * major * over_size * inverse(sqrt(axis2)));
        const auto q2 = square(q);
        const auto e2 = square(e);
        const auto qb = dot(q, scaled_axis);
        const auto eb = dot(e, scaled_axis);
        const auto g = q2 + (major2 - tube2);
        const auto f = polynomial_of(square(g) + (square(qb) - four_major2 * q2), two * (qb * eb),
                                     two * e2 * g + (square(eb) - four_major2 * e2), zero, square(e2));

        const bool is_ring = minor_radius <= major_radius;
        const auto roots = roots_between(f, W(-1), W(1), is_ring ? roots_for(wanted, middle, half) : wanted_roots<W>{});
        list.depends_on(roots);
        for (const polynomial_root<W>& root : roots) {
            const auto x = root.place();
            const auto t = middle + half * x;
            if (is_ring) {
                list.append(crossing_at(t), root);
            } else {
                append_outer(g + e2 * square(x), root, t, list);
            }
        }
        start_on_surface(list, [&] { return is_on_surface(l * over_size, major2, tube2); });  // at p = -l: f(-p) = f(p)
        return list;
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        using Q = typename Point::precise;
        vec3<W> p = at.from(center), a(axis);
        W height = dot(p, a) / dot(a, a);  // in lengths of the axis
        W major(major_radius);
        vec3<W> up = a * height, beside = p - up;
        W rho2 = dot(beside, beside);
        // rho - R, of which a slender tube leaves few digits.
        Q rho = sqrt(Q(rho2)), beyond = Q(rho2 - major * major) / (rho + Q(major));

        at.record_point(major_radius + minor_radius);  // at which the outermost circle bends
        at.keep_in([this] { return bounds(); });
        vec3<Q> outward = vec3<Q>(beside) * beyond + vec3<Q>(up) * rho;  // from the circle, times rho
        // Where the tube meets itself on the axis it has no normal: it is seen along the axis, against the ray.
        if (rho <= Q(at.blur())) {
            const bool along = (dot(a, at.direction()) > W(0)) == !at.entering();
            outward = vec3<Q>(along ? a : -a);
        }
        at.record_normal(outward);
        at.record_uv([&] {
            const frame<Q> f = frame_about(normalize_from<T>(vec3<Q>(a)));
            return vec2<T>(turns(T(dot(vec3<Q>(beside), f.y)), T(dot(vec3<Q>(beside), f.x))),
                           turns(T(dot(vec3<Q>(up), f.z)), T(beyond)));
        });
    }

private:
    /// Lists the crossing at a root of f, of a torus without a hole: only where `outer`, p.p + R^2 - r^2, is not
    /// negative is that its surface.
    ///
    /// At two points of the axis `outer` is zero. In the plane of the axis and the line two circles meet there, and f
    /// is negative within one of them alone: a line that goes from one into the other stays in the solid, and touches
    /// its surface from within. What both enclose is about the centre: a line enters it there before its closest
    /// approach to the centre, and leaves it there after that.
    template <class W>
    RAIO_FN static constexpr void append_outer(const bounded_number<W>& outer, const polynomial_root<W>& root,
                                               const bounded_number<W>& t, crossing_list<W, 4>& list) {
        const auto x = root.place();
        const auto zero = shape_numbers<W>::given(W(0));
        const bool is_outer = list.holds(outer >= zero), on_axis = any(every(outer >= zero, outer <= zero));
        const bool entering = root.sign_before > 0, into_other_circle = root.is_touched() && !entering;
        const auto append = [&](bool enters) {
            const bool inside = list.count > 0 && list.crossings[list.count - 1].entering;
            const bool leaves = inside && (into_other_circle || any(x >= zero));
            if (on_axis ? (enters ? !inside : leaves) : is_outer) list.append(crossing_at(t, enters));
        };
        append(entering);
        if (root.is_touched()) append(!entering);
    }

    /// Is f = 0 at p? All three are in lengths of the same unit.
    template <proven_vector P, proven_number A>
    RAIO_FN constexpr bool is_on_surface(const P& p, const A& major2, const A& tube2) const {
        using W = typename P::number;
        const auto a = shape_numbers<W>::given(axis);
        const auto a2 = square(a);
        const auto p2 = square(p);
        const auto rho2 = a2 * p2 - square(dot(p, a));  // times A.A
        return may_be_equal(a2 * square(p2 + (major2 - tube2)), shape_numbers<W>::given(W(4)) * major2 * rho2);
    }

    /// The angle about the circle at which the tube meets the axis; half a turn for a ring.
    RAIO_FN constexpr T widest() const {
        const T r2 = minor_radius * minor_radius - major_radius * major_radius;
        return atan2(sqrt(max(r2, T(0))), -major_radius);
    }

    /// The area of the tube between its outside and the angle psi, over 2 pi minor_radius.
    RAIO_FN constexpr T strip(const T& psi) const { return major_radius * psi + minor_radius * sin(psi); }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
