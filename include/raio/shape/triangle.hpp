#pragma once

#include <raio/concepts.hpp>
#include <raio/surface_sample.hpp>

namespace raio {

/// The flat triangle a, b, c, whose front is the side from which its corners run counter-clockwise.
///
/// Moeller and Trumbore (1997): the point origin + t direction = a + u e1 + v e2, with e1 = b - a and e2 = c - a, is
/// three linear equations for t, u and v. By Cramer's rule, with s = origin - a, p = direction x e2, q = s x e1,
///
///     det = e1.p,   u = s.p / det,   v = direction.q / det,   t = e2.q / det.
///
/// The point is inside where u, v and 1 - u - v are not negative. Their signs are exact, so neighbours never disagree
/// about a ray near their edge, and no ray slips between them. There is no tolerance on det: a triangle may be as small
/// as it likes.
///
/// uv: the barycentric coordinates of b and c.
template <real T>
struct triangle {
    using number = T;

    vec3<T> a, b, c;

    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr aabb<T> bounds() const { return padded(hull(hull(aabb<T>{a, a}, b), c)); }

    RAIO_FN constexpr T area() const { return T(0.5) * length(cross(b - a, c - a)); }

    /// A square folded to a triangle by its root (Turk, Graphics Gems, 1990).
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        const T root = sqrt(u.x);
        return {a + (b - a) * (root * (T(1) - u.y)) + (c - a) * (root * u.y), normalize(cross(b - a, c - a))};
    }

    template <class W, real R>
    RAIO_FN constexpr crossing<W> crossings(const ray<R>& ray) const {
        using E = bound_t<W>;
        vec3<W> direction(ray.direction), corner(a);
        vec3<W> e1 = vec3<W>(b) - corner, e2 = vec3<W>(c) - corner, s = vec3<W>(ray.origin) - corner;
        vec3<W> p = cross(direction, e2), q = cross(s, e1);
        W det = dot(e1, p), sign = copysign(W(1), det), size = abs(det);
        W u = dot(s, p) * sign, v = dot(direction, q) * sign, w = size - (u + v);

        // A triple product of vectors that are off by a rounding each is off by less than 8 roundings of its terms.
        E k(8 * unit_roundoff<W>), det_error = k * triple_product_bound(e1, direction, e2);
        E u_error = k * triple_product_bound(s, direction, e2), v_error = k * triple_product_bound(direction, s, e1);
        E w_error = det_error + u_error + v_error;
        const mask_t<W> outside = some(u < -u_error, v < -v_error, w < -w_error);
        const mask_t<W> inside = every(u > u_error, v > v_error, w > w_error);

        W over_det = quotient(W(1), det, W(0)), t = dot(e2, q) * over_det;
        E t_error = k * triple_product_bound(e2, s, e1);
        E error = E(2) * (t_error + abs(E(t)) * det_error) * abs(E(over_det)) + E(4 * unit_roundoff<W>) * abs(E(t));
        return {.exists = every(u >= -tie<W>(u_error), v >= -tie<W>(v_error), w >= -tie<W>(w_error),
                                size > tie<W>(det_error)),
                .certain = every(size > E(2) * det_error, some(outside, inside)),
                .t = t,
                .error = error,
                .entering = det > W(0),
                .uv = vec2<W>(u, v) * abs(over_det)};
    }

    template <class W, real R, real N>
    RAIO_FN constexpr void surface(const ray<R>& ray, const crossing<W>& at, hit_record<T, N>& rec) const {
        using Q = quick_t<N>;
        vec3<W> e1 = scaled_into_range<T>(vec3<W>(b) - vec3<W>(a)), e2 = scaled_into_range<T>(vec3<W>(c) - vec3<W>(a));
        vec3<N> outward(normalize_from<T>(vec3<Q>(cross(e1, e2))));
        record_point(ray, at, rec);
        // The exact point is a mean of the corners; where the triangle is seen edge-on the computed one may lie beyond
        // them.
        const auto between = [](T v, T x, T y, T z) { return max(min(min(x, y), z), min(max(max(x, y), z), v)); };
        rec.point = {between(rec.point.x, a.x, b.x, c.x), between(rec.point.y, a.y, b.y, c.y),
                     between(rec.point.z, a.z, b.z, c.z)};
        rec.normal = outward * select(at.entering, N(1), N(-1));
        const T u = max(T(0), min(T(1), T(at.uv.x)));
        rec.uv = {u, max(T(0), min(T(1) - u, T(at.uv.y)))};
    }
};

}  // namespace raio
