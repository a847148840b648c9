#pragma once

#include <raio/concepts.hpp>
#include <raio/formula/axis.hpp>
#include <raio/formula/quadric.hpp>
#include <raio/proof/crossing_list.hpp>
#include <raio/shape/box.hpp>

namespace raio {

/// The points of a box at which a polynomial of degree 2
///
///     f = squares.(x^2, y^2, z^2) + products.(yz, zx, xy) + linear.(x, y, z) + constant
///
/// is zero or below: a solid that the faces of the box close, or, if it is not `Closed`, only the surface f = 0 as far
/// as it lies in the box. As a symmetric matrix (Blinn, The Algebraic Properties of Homogeneous Second Order Surfaces,
/// 1984) f has the squares and the constant on the diagonal, and half of the others beside it.
///
/// Whatever the matrix is, it is a surface: ellipsoids and paraboloids, cylinders and cones with elliptic sections,
/// hyperboloids, two planes, one, or none. A cone's tip, where the gradient of f vanishes, has the normal against the
/// ray. x, y, z and uv are as for `algebraic`.
///
/// Along a line f is a parabola, by the place on that part of the line which is near the box and in units of its size,
/// so that its coefficients have the size of f there.
template <real T, bool Closed = true>
struct quadric {
    using number = T;

    vec3<T> min, max;  ///< opposite corners of the box; missed unless each size is positive
    vec3<T> squares{T(0)}, products{T(0)}, linear{T(0)};
    T constant{0};  ///< missed if all ten are zero

    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr raio::spans<T, 2> spans(const ray<T>& ray) const requires(Closed) {
        return inside_of(*this, ray);
    }

    RAIO_FN constexpr aabb<T> bounds() const { return padded(aabb<T>{min, max}); }

    /// f at a point.
    template <class W>
    RAIO_FN constexpr W value(const vec3<W>& p) const {
        return dot(p, times(p) + vec3<W>(linear)) + W(constant);
    }

    template <class W>
    RAIO_FN constexpr vec3<W> gradient(const vec3<W>& p) const {
        return times(p) * W(2) + vec3<W>(linear);
    }

    template <class W, real R, class Wanted = every_crossing>
    RAIO_FORMULA constexpr std::conditional_t<Closed, chords_for_t<W, Wanted>, chord<W>> crossings(
        const ray<R>& ray, [[maybe_unused]] const Wanted& wanted = {}) const {
        chord<W> clip = box<T>{min, max}.template crossings<W>(ray);
        const index_t<W> first_of_box(1);
        clip.near.face = clip.near.face + first_of_box, clip.far.face = clip.far.face + first_of_box;
        if constexpr (Closed) {
            if (missed(clip)) return nowhere_at_all<Wanted>(clip);
            return intersect(cross_endless<W>(ray), clip, wanted);
        } else {
            if (missed(clip)) return clip;
            const chord<W> ends = cross_endless<W>(ray).ends;
            return {detail::within(clip, ends.near), detail::within(clip, ends.far)};
        }
    }

    template <class W, real R, real N>
    RAIO_FN constexpr void surface(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec) const {
        const T size = norm1(max - min);
        record_gradient(ray, c, gradient(vec3<W>(ray.origin) + vec3<W>(ray.direction) * c.t), size, rec);
        keep_unrounded_in_bounds(rec, [this] { return bounds(); });
        rec.point = nearest_in(aabb<T>{min, max}, rec.point);
        vec3<T> place = (rec.point - min) / (max - min);
        rec.uv = {raio::min(T(1), place.x), raio::min(T(1), place.y)};
        const mask_t<T> on_box = c.face != index_t<W>(0);
        if (none(on_box)) return;
        hit_record<T, N> of_box = rec;
        crossing<W> on_face = c;
        on_face.face = c.face - index_t<W>(1);
        box<T>{min, max}.put_on_face(ray, on_face, of_box);
        // The point is on the face without any error; but what leaves it has to be certain in double_double that it is
        // not on f, for which `record_point` asks as much.
        of_box.error += vec3<T>(size * T(0x1p-72));
        assign(on_box, rec, of_box);
    }

private:
    /// The matrix of the second degree times a vector.
    template <class W>
    RAIO_FN constexpr vec3<W> times(const vec3<W>& p) const {
        vec3<W> s(squares), half = vec3<W>(products) * W(0.5);
        return {s.x * p.x + half.y * p.z + half.z * p.y, s.y * p.y + half.z * p.x + half.x * p.z,
                s.z * p.z + half.x * p.y + half.y * p.x};
    }

    /// Bounds of that matrix' norm, and of f's terms at a point no farther away.
    template <class W>
    RAIO_FN constexpr bound_t<W> second_degree() const {
        using E = bound_t<W>;
        return norm1(vec3<E>(vec3<W>(squares))) + norm1(vec3<E>(vec3<W>(products)));
    }
    template <class W>
    RAIO_FN constexpr bound_t<W> terms_within(const bound_t<W>& far) const {
        using E = bound_t<W>;
        return (second_degree<W>() * far + norm1(vec3<E>(vec3<W>(linear)))) * far + abs(E(W(constant)));
    }

    /// Where the line is inside of what the box does not cut off.
    template <class W, real R>
    RAIO_FN constexpr quadric_chord<W> cross_endless(const ray<R>& ray) const {
        using E = bound_t<W>;
        constexpr double u = unit_roundoff<W>;
        // A place x is at t = (along + unit x) / speed. All of the box lies between x = -4 and 4. A line that starts
        // near it is seen from its origin: what is close to that keeps its digits.
        vec3<W> o(ray.origin), low(min), high(max), center = (low + high) * W(0.5), to_center = center - o;
        W zero(0), over_speed = quotient(W(1), norm1(vec3<W>(ray.direction)), zero), unit = norm1(high - low);
        vec3<W> e = vec3<W>(ray.direction) * over_speed, away = abs(to_center), wide = (high - low) * W(0.625);
        const mask_t<W> starts_near = every(away.x <= wide.x, away.y <= wide.y, away.z <= wide.z);
        W along = select(starts_near, zero, quotient(dot(to_center, e), dot(e, e), zero));
        vec3<W> from = o + e * along, step = e * unit, bent = times(step);

        W c = value(from);
        parabola<W> f;
        f.a = dot(step, bent), f.b = -(dot(from, bent) + dot(vec3<W>(linear), step) * W(0.5));

        // Each of the three is off by roundings of its terms, and by as much as the place is off times the steepness.
        E second = second_degree<W>(), first = norm1(vec3<E>(vec3<W>(linear))), near = norm1(vec3<E>(from));
        E way = norm1(vec3<E>(o)) + abs(E(along)), off = E(8 * u) * way, pace = norm1(vec3<E>(step));
        E steep = second * near + first;
        f.a_error = E(32 * u) * second * pace * pace;
        f.b_error = (E(32 * u) * steep + second * off) * pace;
        E c_error = E(32 * u) * terms_within<W>(near) + (E(2) * steep + second * off) * off;

        // Squares of what has the size of f's terms in the box are in the range of numbers: of W if not of T.
        E far = norm1(vec3<E>(center)) + E(unit), over_terms = quotient(E(1), terms_within<W>(far), E(0));
        W scale(over_terms);
        f.a = f.a * scale, f.b = f.b * scale, c = c * scale, f.square = f.b * f.b - f.a * c;
        f.a_error = f.a_error * over_terms, f.b_error = f.b_error * over_terms, c_error = c_error * over_terms;
        E a_size = abs(E(f.a)), b_size = abs(E(f.b)), c_size = abs(E(c));
        f.square_error = f.b_error * (E(2) * b_size + f.b_error) + f.a_error * (c_size + c_error) + c_error * a_size +
                         E(4 * u) * (b_size * b_size + a_size * c_size);
        f.in_range = every(is_finite(over_terms + E(over_speed)), off <= E(0x1p-10) * far);
        const mask_t<W> exists =
            every(wide.x > zero, wide.y > zero, wide.z > zero, over_terms > E(0), over_speed > zero);
        quadric_chord<W> ends = cross_parabola(f, E(8), exists, zero != zero, [&] {
            return bounded_number<W>{c, c_error};
        });

        const auto at = [&](const crossing<W>& end) {
            E error = E(unit) * end.error + E(8 * u) * (abs(E(along)) + E(unit) * abs(E(end.t)));
            return crossing<W>{end.exists, end.certain, (along + unit * end.t) * over_speed,
                               with_underflow<W>(error * E(over_speed)), end.entering};
        };
        ends.ends = {at(ends.ends.near), at(ends.ends.far)};
        const auto starts = [&] { return abs(E(value(o))) <= E(32 * u) * terms_within<W>(norm1(vec3<E>(o))); };
        if constexpr (!only_sieves<W>) start_on_surface(ends.ends, starts);
        return ends;
    }
};

/// The surface alone.
template <real T>
using open_quadric = quadric<T, false>;

}  // namespace raio
