#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/formula/box_faces.hpp>
#include <raio/formula/plane.hpp>
#include <raio/proof/line.hpp>
#include <raio/proof/settle.hpp>
#include <raio/surface_sample.hpp>

namespace raio::inline RAIO_ABI {

/// The points with min <= p <= max in every coordinate.
///
/// A line is inside the slab between two parallel faces from one t to another; it is inside the box where it is inside
/// all three slabs (Kay and Kajiya 1986).
///
/// Faces are counted by their axis: x, y, z. uv: the two other coordinates of the point, in their order, from 0 at
/// `min` to 1 at `max`.
template <real T>
struct box {
    using number = T;

    vec3<T> min, max;  ///< opposite corners; the box is missed unless at least two of the sizes are positive and none
                       ///< is negative

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr interval<T> spans(const ray<T>& ray) const { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const { return unless_nan(padded(aabb<T>{min, max}), min, max); }

    RAIO_FN constexpr T area() const { return T(2) * aabb<T>{min, max}.half_area(); }

    /// A face is chosen by its share of the area, and a point on it with what is left of u.x.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const requires(std::same_as<mask_t<T>, bool>) {
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

    template <class Line>
    RAIO_FORMULA constexpr chord<typename Line::number> crossings(const Line& line) const {
        using W = typename Line::number;
        if constexpr (!Line::is_exact) {  // of a ray that was mapped
            const auto to_min = line.to(min);
            const auto to_max = line.to(max);
            const auto direction = line.direction();
            const auto slab = [&](int axis) {
                chord<W> c = cross_between<W>(to_min[axis], to_max[axis], direction[axis]);
                c.near.face = c.far.face = index_t<W>(axis);
                return c;
            };
            chord<W> c = intersect(intersect(slab(0), slab(1)), slab(2));
            keep_if(has_faces(), c);
            return c;
        } else if constexpr (has_closer_look<W> || is_believed<W>) {
            return crossings_at_once<W>(line.ray);
        } else {
            const auto [origin, direction] = line.ray;
            chord<W> x = between_faces<W>(origin.x, direction.x, min.x, max.x, 0);
            chord<W> y = between_faces<W>(origin.y, direction.y, min.y, max.y, 1);
            chord<W> z = between_faces<W>(origin.z, direction.z, min.z, max.z, 2);
            chord<W> c = intersect(intersect(x, y), z);
            keep_if(every(has_faces(), is_finite(origin), is_finite(direction)), c);
            return c;
        }
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        const aabb<T> corners{min, max};
        at.record_point();
        at.keep_between(corners);
        detail::put_on_face(at, corners, at.face());
        at.record_uv([&] { return detail::uv_across(corners, at.face(), at.point()); });
    }

private:
    /// Of the three sizes the least may be zero, the middle one may not.
    RAIO_FN constexpr mask_t<T> has_faces() const {
        vec3<T> size = max - min;
        const T less = raio::min(size.x, size.y), more = raio::max(size.x, size.y);
        const T thinnest = raio::min(less, size.z), middle = raio::max(less, raio::min(more, size.z));
        return every(thinnest >= T(0), middle > T(0), is_finite(size));
    }

    /// The chord of the points between two faces, low <= x <= high, from what the ray has of x, in the last precision.
    /// A line that runs along them is between them everywhere or nowhere. That is asked of the origin, and not of a
    /// quotient: 0 / 0 would answer neither. So is a line that would take more than W can say to cross anything.
    template <class W, real R>
    RAIO_FN static constexpr chord<W> between_faces(const R& origin, const R& direction, const T& low, const T& high,
                                                    const index_t<W>& face) {
        using E = bound_t<W>;
        const W over_d = quotient(W(1), W(direction), W(0)), inf = infinity<W>;
        if (direction == R(0) || !is_finite(over_d)) {
            return R(low) <= origin && origin <= R(high) ? everywhere<W>() : nowhere<W>();
        }
        const auto way_to = [&](const T& x) {
            const W way = difference_as<W>(x, origin), t = way * over_d;
            if (is_finite(t)) return t;  // products of two doubles are no numbers beyond their range
            return (way > W(0)) == (over_d > W(0)) ? inf : -inf;
        };
        const auto end = [&](const W& t, bool entering) {
            // The way, the quotient and the product were rounded.
            const E error = is_finite(t) ? E(4 * unit_roundoff<W>) * abs(E(t)) : E(0);
            return crossing<W>{true, true, t, error, entering, face};
        };
        const W to_low = way_to(low), to_high = way_to(high);
        return {end(raio::min(to_low, to_high), true), end(raio::max(to_low, to_high), false)};
    }

    /// The same formula for precisions that have a closer look. Leaves of trees spend their time here, so the bound is
    /// derived by hand: of t the difference, the quotient and the product are rounded, which is less than 4 roundings
    /// of it, and so are the largest and the smallest of three.
    template <class W>
    RAIO_FN constexpr chord<W> crossings_at_once(const ray<T>& ray) const {
        using E = bound_t<W>;
        W all_ways(0);  // finite only if the way to every face is
        const auto slab = [&all_ways](T origin, T direction, T low, T high) {
            W over_d = quotient(W(1), W(direction), W(0)), inf = infinity<W>;
            W way_to_low = difference_as<W>(low, origin), way_to_high = difference_as<W>(high, origin);
            all_ways = all_ways + way_to_low + way_to_high;
            W to_low = way_to_low * over_d, to_high = way_to_high * over_d;
            vec2<W> across(raio::min(to_low, to_high), raio::max(to_low, to_high));
            const mask_t<W> along = some(direction == T(0), !is_finite(over_d));
            if (none(along)) return across;
            const mask_t<W> within = every(low <= origin, origin <= high);
            return vec2<W>(select(along, select(within, -inf, inf), across.x),
                           select(along, select(within, inf, -inf), across.y));
        };
        vec2<W> x = slab(ray.origin.x, ray.direction.x, min.x, max.x);
        vec2<W> y = slab(ray.origin.y, ray.direction.y, min.y, max.y);
        vec2<W> z = slab(ray.origin.z, ray.direction.z, min.z, max.z);
        W near = raio::max(raio::max(x.x, y.x), z.x), far = raio::min(raio::min(x.y, y.y), z.y);

        const auto error_of = [](const W& t) {
            return select(is_finite(t), with_underflow<W>(E(4 * unit_roundoff<W>) * abs(E(t))), E(0));
        };
        E near_error = error_of(near), far_error = error_of(far);
        W inside = far - near;
        const mask_t<W> meets = inside >= W(0);
        mask_t<W> certain = abs(E(inside)) > near_error + far_error;
        // Of floats a quotient of 1 may be infinite, or have lost digits; and a way, where double says how far it is.
        // Of a direction from 2^124 on, whose quotient comes near the smallest numbers, 16 times it is infinite.
        if constexpr (std::same_as<scalar_t<W>, float>) {
            const auto has_quotient = [](const W& d) { return some(d == W(0), abs(d) >= W(4 * least_normal<W>)); };
            vec3<W> d(ray.direction);
            const mask_t<W> in_range = is_finite(abs(all_ways) + W(16) * norm1(d));
            certain = every(certain, has_quotient(d.x), has_quotient(d.y), has_quotient(d.z), in_range);
        }
        if (all(!meets)) return {{meets, certain, near, near_error, meets}, {meets, certain, far, far_error, meets}};

        const mask_t<W> exists = every(meets, has_faces(), is_finite(ray.origin), is_finite(ray.direction));
        const auto axis_of = [](const W& t, const W& t_x, const W& t_y) {
            return choose(t_x == t, index_t<W>(0), choose(t_y == t, index_t<W>(1), index_t<W>(2)));
        };
        // Do two of the three end as near?
        const auto shared = [](const W& t, const E& error, const W& t_x, const W& t_y, const W& t_z) {
            if constexpr (!detail::keeps_all_digits<T>) return mask_t<W>{};
            const auto is_near = [&](const W& other) { return abs(E(other - t)) <= E(2) * error; };
            const mask_t<W> at_x = is_near(t_x), at_y = is_near(t_y), at_z = is_near(t_z);
            return some(every(at_x, at_y), every(at_y, at_z), every(at_z, at_x));
        };
        return {{exists, certain, near, near_error, exists, axis_of(near, x.x, y.x), W(0), W(0),
                 shared(near, near_error, x.x, y.x, z.x)},
                {exists, certain, far, far_error, !exists, axis_of(far, x.y, y.y), W(0), W(0),
                 shared(far, far_error, x.y, y.y, z.y)}};
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
