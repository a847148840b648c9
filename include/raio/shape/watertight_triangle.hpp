#pragma once

#include <raio/shape/triangle.hpp>

namespace raio {

/// The triangle of a mesh: one question per edge, asked with the edge's two corners only, so that the two triangles at
/// an edge hear the same answer in any precision, and no ray slips between them.
///
/// Woop, Benthin and Wald, JCGT 2(1), 2013: the corners are moved so that the ray starts at the origin, and sheared so
/// that it runs along its largest axis z. In the xy plane the ray is then a point, and the edge functions
///
///     u = cx by - cy bx,   v = ax cy - ay cx,   w = bx ay - by ax
///
/// say on which side of each edge it lies. The ray hits where none of the three differs in sign from the others.
///
/// Same corners, front and uv as `triangle`, which is exact as well, but whose `crossings` in other precisions may
/// disagree with those of a neighbour.
template <real T>
struct watertight_triangle {
    using number = T;

    vec3<T> a, b, c;

    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr aabb<T> bounds() const { return as_triangle().bounds(); }
    RAIO_FN constexpr T area() const { return as_triangle().area(); }
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const { return as_triangle().sample(u); }

    template <class W, real R>
    RAIO_FORMULA constexpr crossing<W> crossings(const ray<R>& ray) const {
        // A rotation of the coordinates that makes the largest component of the direction the last one.
        const auto turned = [&](const auto& v) {
            const R x = abs(ray.direction.x), y = abs(ray.direction.y), z = abs(ray.direction.z);
            const mask_t<T> last_is_x = x > y && x > z, last_is_y = !last_is_x && y > z;
            return vec3<W>(W(select(last_is_x, v.y, select(last_is_y, v.z, v.x))),
                           W(select(last_is_x, v.z, select(last_is_y, v.x, v.y))),
                           W(select(last_is_x, v.x, select(last_is_y, v.y, v.z))));
        };
        using E = bound_t<W>;
        W zero(0);
        vec3<W> direction = turned(ray.direction);
        W over_z = quotient(W(1), direction.z, zero), shear_x = direction.x * over_z, shear_y = direction.y * over_z;
        const auto sheared = [&](const vec3<T>& corner) {
            vec3<W> from_origin = turned(difference_as<W>(corner, ray.origin));
            return vec3<W>(from_origin.x - shear_x * from_origin.z, from_origin.y - shear_y * from_origin.z,
                           from_origin.z);
        };
        vec3<W> p = sheared(a), q = sheared(b), r = sheared(c);
        W u = r.x * q.y - r.y * q.x, v = p.x * r.y - p.y * r.x, w = q.x * p.y - q.y * p.x, det = u + v + w;

        // A sheared corner is off by less than 10 roundings of its distance from the origin, and with it the edge
        // functions; their own roundings count as 4 more.
        E k = E(14 * unit_roundoff<W>), two(2);
        const auto corner_error = [&](const vec3<W>& x) { return with_underflow<W>(k * norm1(vec3<E>(x))); };
        const auto edge_error = [&](const vec3<W>& x, const E& x_error, const vec3<W>& y, const E& y_error) {
            E x_size = abs(E(x.x)) + abs(E(x.y)), y_size = abs(E(y.x)) + abs(E(y.y));
            return with_underflow<W>(x_size * y_error + y_size * x_error + two * x_error * y_error);
        };
        E p_error = corner_error(p), q_error = corner_error(q), r_error = corner_error(r);
        E u_error = edge_error(r, r_error, q, q_error), v_error = edge_error(p, p_error, r, r_error);
        E w_error = edge_error(q, q_error, p, p_error), det_error = u_error + v_error + w_error;
        E size = abs(E(det)), u_tie = tie<W>(u_error, size), v_tie = tie<W>(v_error, size),
          w_tie = tie<W>(w_error, size);
        const mask_t<W> inside =
            some(every(u >= -u_tie, v >= -v_tie, w >= -w_tie), every(u <= u_tie, v <= v_tie, w <= w_tie));
        const mask_t<W> decided = every(abs(u) > u_error, abs(v) > v_error, abs(w) > w_error);

        W height = u * p.z + v * q.z + w * r.z;
        E height_error = two * (u_error * abs(E(p.z)) + v_error * abs(E(q.z)) + w_error * abs(E(r.z)));
        if constexpr (last_precision<W>) {
            // The same, of the edges as they are: the shear would round away that it is nothing, or all but that, where
            // a ray starts on the triangle.
            vec3<W> e1 = difference_as<W>(b, a), e2 = difference_as<W>(c, a), s = difference_as<W>(ray.origin, a);
            height = dot(e2, cross(s, e1));
            height_error = E(8 * unit_roundoff<W>) * triple_product_bound(e2, s, e1);
        }
        W over_det = quotient(W(1), det, zero), t = height * over_det * over_z;
        E error = two * (height_error * abs(E(over_z)) + abs(E(t)) * det_error) * abs(E(over_det)) + k * abs(E(t));
        const mask_t<W> runs = every(is_finite(direction.z), abs(direction.z) > zero);
        return {.exists = every(inside, abs(det) > tie<W>(det_error), runs),
                .certain = every(decided, some(!inside, abs(det) > two * det_error)),
                .t = t,
                .error = error,
                .entering = (det > zero) == (direction.z > zero),
                .u = v * over_det,
                .v = w * over_det};
    }

    template <class W, real R, real N>
    RAIO_FN constexpr void surface(const ray<R>& ray, const crossing<W>& at, hit_record<T, N>& rec) const {
        as_triangle().surface(ray, at, rec);
    }

private:
    RAIO_FN constexpr triangle<T> as_triangle() const { return {a, b, c}; }
};

}  // namespace raio
