#pragma once

#include <raio/concepts.hpp>
#include <raio/math/angle.hpp>
#include <raio/math/frame.hpp>
#include <raio/proof/crossing_list.hpp>
#include <raio/surface_sample.hpp>

namespace raio {

/// The points at distance `minor_radius` from the circle of radius `major_radius` about `center`, across `axis`: a
/// solid ring. If the minor radius is the larger one, it has no hole, and what its surface would be inside of itself
/// does not count.
///
/// A point p, as seen from the centre, lies on it where, with the major radius R and the minor radius r,
///
///     f = (p.p + R^2 - r^2)^2 - 4 R^2 (p.p - (p.A)^2 / A.A) = 0,    A = axis
///
/// which is the product of (z^2 + (rho - R)^2 - r^2) and (z^2 + (rho + R)^2 - r^2): the second factor is the surface
/// that does not count, where p.p + R^2 - r^2 < 0. From the line's closest approach to the centre on, p.p has no linear
/// term and f no cubic one. With the length of that part of the line that lies in the bounding sphere for unit, every
/// coefficient is at most 16, and the four roots lie between -1 and 1.
///
/// uv: u is the angle about the axis, from the x axis of `frame_about(axis)`; v the angle about the circle, from the
/// outside over the axis' end.
template <real T>
struct torus {
    using number = T;

    vec3<T> center;
    vec3<T> axis;    ///< of any length but zero
    T major_radius;  ///< of the circle, positive
    T minor_radius;  ///< of the tube, positive

    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr raio::spans<T, 2> spans(const ray<T>& ray) const { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const {
        vec3<T> reach = disc_reach(axis, major_radius) + vec3<T>(minor_radius);
        return padded(padded(aabb<T>{center - reach, center + reach}));
    }

    RAIO_FN constexpr T area() const { return T(4 * pi<T>) * minor_radius * strip(widest()); }

    /// u.x turns about the axis; u.y is the area between the inside of the tube and the point.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        const T end = widest(), wanted = (T(2) * u.y - T(1)) * strip(end);
        // Newton's method, halved where it would leave what encloses the angle.
        T low = -end, high = end, psi = T(0);
        for (int i = 0; i < 64; ++i) {
            const T over = strip(psi) - wanted;
            (over > T(0) ? high : low) = psi;
            const T next = psi - quotient(over, major_radius + minor_radius * cos(psi), T(infinity<T>));
            const T last = psi;
            psi = low <= next && next <= high ? next : low + (high - low) / T(2);
            if (abs(psi - last) <= T(2 * unit_roundoff<T>) * abs(psi)) break;
        }
        const frame<T> f = frame_about(normalize(axis));
        const T phi = T(2 * pi<T>) * u.x;
        vec3<T> outwards = f.x * cos(phi) + f.y * sin(phi);
        vec3<T> normal = normalize(outwards * cos(psi) + f.z * sin(psi));
        return {center + outwards * major_radius + normal * minor_radius, normal};
    }

    template <class W, real R, class Wanted = every_crossing>
    RAIO_FORMULA constexpr crossing_list<W, 4> crossings(const ray<R>& ray, const Wanted& wanted = {}) const {
        using E = bound_t<W>;
        constexpr double u = unit_roundoff<W>, least = least_normal<W>;
        crossing_list<W, 4> list;
        vec3<W> d(ray.direction), l = difference_as<W>(center, ray.origin), a(axis), moment = cross(l, d);
        // A little more than the bounding sphere, so that the line's ends are clearly outside.
        W d2 = dot(d, d), a2 = dot(a, a), size = (W(major_radius) + W(minor_radius)) * W(1 + 0x1p-10);
        W reach2 = d2 * size * size - dot(moment, moment);
        E far = norm1(vec3<E>(l)), off = E(64 * u) * far;  // how far the point of closest approach may be off
        const bool sound = major_radius > T(0) && minor_radius > T(0) && a2 >= W(least) && d2 >= W(least);
        if (!sound || !is_finite(E(reach2))) {
            list.certain = !sound;
            return list;
        }
        if (off > E(0x1p-13) * E(size)) {  // too far away to be told from its centre
            list.certain = false;
            return list;
        }
        if (!(reach2 > W(0))) return list;

        W over_d2 = W(1) / d2, over_size = W(1) / size, middle = dot(l, d) * over_d2, half = sqrt(reach2) * over_d2;
        if (!(half >= W(least))) return list;  // too small for the length of the direction
        vec3<W> q = cross(moment, d) * (over_d2 * over_size), e = d * (half * over_size);
        W major2 = W(major_radius) * over_size, minor2 = W(minor_radius) * over_size;
        major2 = major2 * major2, minor2 = minor2 * minor2;
        W q2 = dot(q, q), e2 = dot(e, e), over_a2 = W(1) / a2, aq = dot(a, q), ae = dot(a, e);
        W g = q2 + (major2 - minor2), four = W(4) * major2;
        polynomial<W, 4> f{{g * g - four * (q2 - aq * aq * over_a2), W(2) * four * (aq * ae * over_a2),
                            W(2) * g * e2 - four * (e2 - ae * ae * over_a2), W(0), e2 * e2}};
        E slack = E(32) * off * E(over_size) + E(128 * u);
        f.error = {slack, slack, slack, E(0), slack};

        E drift = off * norm1(vec3<E>(d)) * E(over_d2);
        const bool is_ring = minor_radius <= major_radius;
        const auto roots =
            roots_between(f, W(-1), W(1), is_ring ? roots_for(wanted, middle, half, drift) : wanted_roots<W>{});
        list.certain = roots.certain;
        bool inside = false;
        for (const polynomial_root<W>& root : roots) {
            W t = middle + half * root.t;
            E error = E(half) * root.error + drift + E(4 * u) * abs(E(t));
            if (is_ring) {
                list.append(t, error, root);
                continue;
            }
            // On the surface that counts, `outer` is positive. At its two points on the axis it is zero. In the plane
            // of the axis and the line two circles meet there, and f is negative within one of them alone. A line that
            // goes from one into the other stays in the solid, and touches its surface from within. What both enclose
            // is about the centre: a line enters it there before its closest approach to the centre, and leaves it
            // there after that.
            E outer(g + e2 * root.t * root.t), outer_error = slack + E(2) * root.error;
            const bool tip = abs(outer) <= outer_error, twice = root.before * root.after > 0;
            const bool entering = root.before > 0, to_other = twice && !entering;
            const auto append_if_it_counts = [&](bool enters) {
                const bool leaves = inside && (to_other || E(root.t) >= -root.error);
                if (tip ? (enters ? !inside : leaves) : outer > E(0)) list.append(t, error, enters), inside = enters;
            };
            list.certain = list.certain && !tip;
            append_if_it_counts(entering);
            if (twice) append_if_it_counts(!entering);
        }
        if (list.touches_origin()) {  // and starts on it, if f is no more than its roundings
            E terms(dot(l, l) + W(major_radius) * W(major_radius) + W(minor_radius) * W(minor_radius));
            if (abs(E(level(l))) <= E(32 * u) * E(a2) * terms * terms) list.start_at_origin();
        }
        return list;
    }

    template <class W, real R, real N>
    RAIO_FN constexpr void surface(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec) const {
        using Q = working_t<N>;
        vec3<W> p = seen_from(center, ray, c.t), a(axis);
        W height = dot(p, a) / dot(a, a), major(major_radius);  // in lengths of the axis
        vec3<W> up = a * height, beside = p - up;
        W rho2 = dot(beside, beside);
        // rho - R, of which a slender tube leaves few digits.
        Q rho = sqrt(Q(rho2)), beyond = Q(rho2 - major * major) / (rho + Q(major));
        // Where the tube meets itself on the axis, or as close to it as can be told, it is seen along the axis, against
        // the ray.
        const frame<Q> f = frame_about(normalize_from<T>(vec3<Q>(a)));
        const bool nowhere = rho <= Q(c.error) * norm1(vec3<Q>(ray.direction));
        const bool along = (dot(f.z, vec3<Q>(vec3<W>(ray.direction))) > Q(0)) == !c.entering;
        vec3<Q> from_circle = vec3<Q>(beside) * beyond + vec3<Q>(up) * rho;  // times rho
        vec3<N> outward(nowhere ? f.z * Q(along ? 1 : -1) : normalize_from<T>(from_circle));
        record_point(ray, c, rec, major_radius + minor_radius);
        keep_in_bounds(ray, c, rec, [this] { return bounds(); });
        rec.normal = outward * select(c.entering, N(1), N(-1));
        rec.uv = {turns(T(dot(vec3<Q>(beside), f.y)), T(dot(vec3<Q>(beside), f.x))),
                  turns(T(dot(vec3<Q>(up), f.z)), T(beyond))};
    }

private:
    /// f, times A.A, at the point p as seen from the centre, or at -p.
    template <class W>
    RAIO_FN constexpr W level(const vec3<W>& p) const {
        vec3<W> a(axis);
        W a2 = dot(a, a), p2 = dot(p, p), ap = dot(a, p), major2 = W(major_radius) * W(major_radius);
        W sum = p2 + (major2 - W(minor_radius) * W(minor_radius));
        return a2 * (sum * sum) - W(4) * major2 * (a2 * p2 - ap * ap);
    }

    /// The angle about the circle at which the tube meets the axis; half a turn for a ring.
    RAIO_FN constexpr T widest() const {
        const T r2 = minor_radius * minor_radius - major_radius * major_radius;
        return atan2(sqrt(max(r2, T(0))), -major_radius);
    }

    /// The area of the tube between its outside and the angle psi, over its length per angle.
    RAIO_FN constexpr T strip(const T& psi) const { return major_radius * psi + minor_radius * sin(psi); }
};

}  // namespace raio
