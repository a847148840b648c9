#pragma once

#include <raio/concepts.hpp>
#include <raio/formula/axis.hpp>
#include <raio/formula/quadric.hpp>
#include <raio/math/quadratic.hpp>
#include <raio/surface_sample.hpp>

/// \file
/// Both cylinders: with its caps it is a solid, without them a tube.
///
/// With the axis A = top - base and l = base - origin, the distance of the point at t from the axis is |(t d - l) x A|
/// / |A|. It is the radius at
///
///     t = (b -+ s) / a,   n = d x A,  a = n.n,  b = (l x A).n,   s^2 = A.A (a radius^2 - (A.(l x d))^2)
///
/// |A.(l x d)| / |n| is the distance at which the two lines pass each other: like the sphere's, the discriminant is
/// free of differences of large squares. A line parallel to the axis, n = 0, is inside everywhere or nowhere.
///
/// Faces are counted side, base, top. uv of the side: u is the angle about the axis, from the x axis of
/// `frame_about(axis)`; v the height, 0 at the base and 1 at the top. uv of a cap: the same u, and v the distance from
/// the axis over the radius.

namespace raio {

namespace detail {

/// The chord through the endless cylinder.
template <class W, real T, real R>
RAIO_FN constexpr chord<W> cross_endless_cylinder(const vec3<T>& base, const vec3<T>& top, T radius,
                                                  const ray<R>& ray) {
    using E = bound_t<W>;
    constexpr double u = unit_roundoff<W>, least = least_normal<W>;
    vec3<W> d(ray.direction), axis = difference_as<W>(top, base), l = difference_as<W>(base, ray.origin);
    vec3<W> n = cross(d, axis);
    W r(radius), r2 = r * r, a = dot(n, n), axis2 = dot(axis, axis), d2 = dot(d, d), zero(0);
    W passed = dot(l, n), ar2 = a * r2, passed2 = passed * passed, s2 = ar2 - passed2;

    // The errors, with u the unit roundoff: n is off by less than 4 u |d| |A|, l x A by 5 u |l| |A| and A.(l x d) by
    // 8 u |A| |l| |d|.
    E two(2), l_size = norm1(vec3<E>(l)), d_size = norm1(vec3<E>(d)), n_size = norm1(vec3<E>(n));
    E axis_size = norm1(vec3<E>(axis)), n_error = with_underflow<W>(E(4 * u) * d_size * axis_size);
    E a_error = with_underflow<W>(n_error * (two * n_size + n_error) + E(4 * u) * E(a));
    E passed_error = with_underflow<W>(E(8 * u) * axis_size * with_underflow<W>(l_size * d_size));
    E passed2_error = passed_error * (two * abs(E(passed)) + passed_error);
    E s2_error = with_underflow<W>(E(r2) * a_error + passed2_error + E(8 * u) * (E(ar2) + E(passed2)));
    // A radius that the last precision cannot tell from none leaves no normal: such a cylinder is missed.
    E resolved = tie<W>(E(0x1p30 * u * u) * l_size * l_size);
    // A line that is all but parallel to the axis is so to the last precision, which knows nothing else of where such a
    // line meets the endless side. Of others n is good to 2^-32 of it, and so is s^2, but b^2 - a c (below) to 2^-64.
    E all_but = E(last_precision<W> ? 0x1p32 : 4 * u) * n_error;
    mask_t<W> parallel = a == zero;
    if constexpr (last_precision<W>) parallel = n_size <= all_but;
    // A cylinder so small that fourth powers are lost is missed.
    const mask_t<W> in_range = some(ar2 >= W(least), n_size <= all_but);
    const mask_t<W> sound =
        every(radius > T(0), E(r2) >= E(least) + resolved, axis2 >= W(least), d2 >= W(least), in_range);
    const mask_t<W> apart = every(sound, s2 < -s2_error);
    const mask_t<W> meets = every(sound, some(parallel, s2 >= -tie<W>(s2_error)));
    if (may_leave<W>(!meets)) return nowhere<W>(apart);

    vec3<W> m = cross(l, axis);
    W b = dot(m, n), beside2 = dot(m, m), inner2 = axis2 * r2, c = beside2 - inner2, under_root = axis2 * max(s2, zero);
    // To the last precision, what it cannot tell from a tangent touches in one point: both ends are in or out.
    if constexpr (last_precision<W>) under_root = select(s2 > s2_error, under_root, zero);
    W s = sqrt(under_root), over_a = quotient(W(1), a, zero);
    E c_error = E(0x1p8 * u) * (E(beside2) + E(dot(l, l)) * E(axis2)), m_size = norm1(vec3<E>(m));
    // What it strays on its way along the cylinder.
    E astray = tie<W>(n_size * quotient(l_size + axis_size, d_size, E(0)));
    const mask_t<W> within = every(inner2 >= W(least), c <= tie<W>(c_error + astray * (two * m_size + astray)));
    mask_t<W> exists = every(meets, some(!parallel, within));

    E under_root_error = with_underflow<W>(E(axis2) * s2_error);
    E m_error = with_underflow<W>(E(5 * u) * l_size * axis_size);
    E b_error = with_underflow<W>(n_error * m_size + m_error * (n_size + n_error) + E(4 * u) * n_size * m_size);
    mask_t<W> crossed =
        every(sound, s2 > s2_error, E(under_root) > under_root_error, is_finite(under_root), E(a) > two * a_error);
    E s_error = quotient(under_root_error, E(s), E(infinity<E>)) + E(8 * u) * E(s);
    E farthest = (abs(E(b)) + E(s)) * E(over_a);
    E error = two * (b_error + s_error + farthest * a_error) * E(over_a) + E(8 * u) * farthest;
    if constexpr (last_precision<W>) {
        // All that a tangent, or a line that is all but parallel, may be off by would make a tie of what is none. This
        // is the most that others are off by: where the angle between the lines is above 2 degrees (the sine's square
        // above 2^-10) and the chord above a 32nd of the diameter.
        crossed = every(crossed, s2 > W(0x1p-10) * ar2, a > W(0x1p-10) * d2 * axis2);
        error = min(E(0x1p21 * u) * quotient(l_size + E(r), d_size, E(0)), error);
        // Of a line that is all but parallel n has few digits, and s^2 no more; but it is b^2 - a c, and c has all of
        // them. (Where these are beyond the range, s^2 has to do.)
        E square_error = b_error * (two * abs(E(b)) + b_error) + E(a) * c_error + a_error * abs(E(c)) + E(least);
        exists = every(exists, some(parallel, !(b * b - a * c < -W(square_error))));
    }
    const mask_t<W> certain = some(apart, crossed);
    error = select(parallel, E(0), with_underflow<W>(error));
    vec2<W> t = quadratic_roots(over_a, b, c, s);
    chord<W> line{{exists, certain, select(parallel, -infinity<W>, t.x), error, exists},
                  {exists, certain, select(parallel, infinity<W>, t.y), error, !exists}};
    // m is off by 5 u |l| |A|, and c by less than 32 u of the square of that product.
    const auto starts = [&] { return abs(E(c)) <= E(32 * u) * E(dot(l, l)) * E(axis2); };
    if constexpr (last_precision<W>) start_on_surface(line, starts);
    return line;
}

/// What both cylinders record.
template <class W, real T, real R, real N>
RAIO_FN constexpr void cylinder_surface(const vec3<T>& base, const vec3<T>& top, T radius, const ray<R>& ray,
                                        const crossing<W>& c, hit_record<T, N>& rec) {
    axial_surface(base, top, vec2<T>(radius), radius, ray, c, rec,
                  [](const vec3<W>& from_axis, const W&) { return from_axis; });
    keep_in_bounds(ray, c, rec, [&] { return axial_bounds(base, top, vec2<T>(radius)); });
}

}  // namespace detail

/// The points at most `radius` from the segment between the centres of the caps, and between the caps: closed, a solid.
template <real T>
struct cylinder {
    using number = T;

    vec3<T> base, top;  ///< the centres of the two caps
    T radius;           ///< a length; the cylinder is missed unless it is positive and base and top differ

    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr interval<T> spans(const ray<T>& ray) const { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const { return detail::axial_bounds(base, top, vec2<T>(radius)); }

    RAIO_FN constexpr T area() const { return T(2 * pi<T>) * radius * (length(top - base) + radius); }

    /// The side and the two caps have areas like twice the height, the radius and the radius: u.x chooses among them,
    /// and what is left of it is the angle.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const requires(std::same_as<mask_t<T>, bool>) {
        vec3<T> axis = top - base;
        const T height = length(axis), side = T(2) * height;
        const frame<T> f = frame_about(axis / height);
        const auto at = [&](T turn) { return f.x * cos(T(2 * pi<T>) * turn) + f.y * sin(T(2 * pi<T>) * turn); };
        T left = u.x * (side + T(2) * radius);
        if (left < side) {
            vec3<T> normal = at(left / side);
            return {base + axis * u.y + normal * radius, normal};
        }
        left -= side;
        const bool on_top = left >= radius;
        if (on_top) left -= radius;
        vec3<T> from_axis = at(left / radius) * (radius * sqrt(u.y));
        return on_top ? surface_sample<T>{top + from_axis, f.z} : surface_sample<T>{base + from_axis, -f.z};
    }

    template <class W, real R>
    RAIO_FORMULA constexpr chord<W> crossings(const ray<R>& ray) const {
        chord<W> endless = detail::cross_endless_cylinder<W>(base, top, radius, ray);
        if (missed(endless)) return endless;
        chord<W> c = intersect(endless, detail::cross_cap_planes<W>(base, top, ray));
        keep_if_reachable<T>(ray, c);
        return c;
    }

    template <class W, real R, real N>
    RAIO_FN constexpr void surface(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec) const {
        detail::cylinder_surface(base, top, radius, ray, c, rec);
    }
};

/// The points at distance `radius` from the segment, between the two planes across its ends: a tube, seen from both
/// sides.
template <real T>
struct open_cylinder {
    using number = T;

    vec3<T> base, top;  ///< the centres of the two rims, which belong to the tube
    T radius;           ///< a length; the tube is missed unless it is positive and base and top differ

    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr aabb<T> bounds() const { return detail::axial_bounds(base, top, vec2<T>(radius)); }

    RAIO_FN constexpr T area() const { return T(2 * pi<T>) * radius * length(top - base); }

    /// Unrolled the tube is a rectangle: `u` is its uv.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        vec3<T> axis = top - base;
        const frame<T> f = frame_about(normalize(axis));
        const T phi = T(2 * pi<T>) * u.x;
        vec3<T> normal = f.x * cos(phi) + f.y * sin(phi);
        return {base + axis * u.y + normal * radius, normal};
    }

    /// Either crossing counts on its own, if it lies between the two planes.
    template <class W, real R>
    RAIO_FORMULA constexpr chord<W> crossings(const ray<R>& ray) const {
        chord<W> endless = detail::cross_endless_cylinder<W>(base, top, radius, ray);
        if (missed(endless)) return endless;
        chord<W> slab = detail::cross_cap_planes<W>(base, top, ray);
        return {detail::within(slab, endless.near), detail::within(slab, endless.far)};
    }

    template <class W, real R, real N>
    RAIO_FN constexpr void surface(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec) const {
        detail::cylinder_surface(base, top, radius, ray, c, rec);
    }
};

}  // namespace raio
