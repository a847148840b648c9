#pragma once

#include <raio/concepts.hpp>
#include <raio/surface_sample.hpp>

namespace raio {

/// The points with min <= p <= max in every coordinate.
///
/// A line is inside the slab between two parallel faces from one t to another; it is inside the box where it is inside
/// all three slabs (Kay and Kajiya 1986). A line that runs parallel to a slab is inside it everywhere or nowhere: that
/// is asked of the origin and never of a quotient, since 0 / 0 would answer neither.
///
/// Faces are counted -x, +x, -y, +y, -z, +z. uv: the two other coordinates of the point, in their order, from 0 at
/// `min` to 1 at `max`.
template <real T>
struct box {
    using number = T;

    vec3<T> min, max;  ///< opposite corners; the box is missed unless at least two of the sizes are positive and none
                       ///< is negative

    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr interval<T> spans(const ray<T>& ray) const { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const { return padded(aabb<T>{min, max}); }

    RAIO_FN constexpr T area() const { return T(2) * aabb<T>{min, max}.half_area(); }

    /// A face is chosen by its share of the area, and a point on it with what is left of u.x.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        vec3<T> size = max - min, share(size.y * size.z, size.z * size.x, size.x * size.y);
        T left = u.x * T(2) * (share.x + share.y + share.z);
        glm::length_t axis = 0;
        while (axis < 2 && left >= T(2) * share[axis]) left -= T(2) * share[axis++];
        const bool high = left >= share[axis];
        const T within = quotient(high ? left - share[axis] : left, share[axis], T(0));
        const glm::length_t first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
        surface_sample<T> s{min, vec3<T>(T(0))};
        s.point[axis] = high ? max[axis] : min[axis];
        s.point[first] += size[first] * raio::min(within, T(1));
        s.point[second] += size[second] * u.y;
        s.normal[axis] = high ? T(1) : T(-1);
        return s;
    }

    template <class W>
    RAIO_FN constexpr chord<W> crossings(const ray<T>& ray) const {
        using E = bound_t<W>;
        auto slab = [&](glm::length_t axis) {
            W o(ray.origin[axis]), d(ray.direction[axis]), low(min[axis]), high(max[axis]), zero(0);
            const mask_t<W> parallel = d == zero, forward = d > zero, yes = some(parallel, !parallel);
            W over_d = quotient(W(1), d, zero), to_low = (low - o) * over_d, to_high = (high - o) * over_d;
            W near = select(parallel, -infinity<W>, raio::min(to_low, to_high));
            W far = select(parallel, infinity<W>, raio::max(to_low, to_high));
            E k(4 * unit_roundoff<W>), near_error = select(parallel, E(0), k * abs(E(near)));
            E far_error = select(parallel, E(0), k * abs(E(far)));
            const index_t<W> low_face = index_t<W>(2 * axis), high_face = index_t<W>(2 * axis + 1);
            const mask_t<W> exists = every(low <= high, near <= far, is_finite(d), is_finite(low), is_finite(high),
                                           some(!parallel, every(low <= o, o <= high)));
            return chord<W>{{exists, yes, near, near_error, yes, select(forward, low_face, high_face)},
                            {exists, yes, far, far_error, !yes, select(forward, high_face, low_face)}};
        };
        chord<W> c = intersect(intersect(slab(0), slab(1)), slab(2));
        const mask_t<T> x = min.x < max.x, y = min.y < max.y, z = min.z < max.z;
        c.near.exists = c.far.exists = every(c.near.exists, some(every(x, y), every(y, z), every(z, x)));
        return c;
    }

    template <class W>
    RAIO_FN constexpr void surface(const ray<T>& ray, const crossing<W>& c, hit_record<T>& rec) const {
        const auto face_is = [&](unsigned low, unsigned high) {
            return some(c.face == index_t<T>(low), c.face == index_t<T>(high));
        };
        const mask_t<T> x = face_is(0, 1), y = face_is(2, 3), z = face_is(4, 5);
        const T zero(0), one(1);
        record_point(ray, c, rec);
        // One coordinate is known without any error: that of the face.
        const auto onto = [&](mask_t<T> on, unsigned low_face, T low, T high, T& p, T& error) {
            p = select(on, select(c.face == index_t<T>(low_face), low, high), p);
            error = select(on, zero, error);
        };
        onto(x, 0, min.x, max.x, rec.point.x, rec.error.x);
        onto(y, 2, min.y, max.y, rec.point.y, rec.error.y);
        onto(z, 4, min.z, max.z, rec.point.z, rec.error.z);
        const auto against = [&](mask_t<T> on, T d) { return select(on, select(d > zero, -one, one), zero); };
        rec.normal = {against(x, ray.direction.x), against(y, ray.direction.y), against(z, ray.direction.z)};
        const auto along = [&](T p, T low, T high) {
            return raio::max(zero, raio::min(one, quotient(p - low, high - low, zero)));
        };
        vec3<T> local(along(rec.point.x, min.x, max.x), along(rec.point.y, min.y, max.y),
                      along(rec.point.z, min.z, max.z));
        rec.uv = {select(x, local.y, local.x), select(z, local.y, local.z)};
    }
};

}  // namespace raio
