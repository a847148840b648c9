#pragma once

#include <vector>

#include <raio/shape/frustum.hpp>
#include <raio/shape/ring.hpp>

namespace raio {

namespace detail {

/// What one straight piece of a profile sweeps: the side of a frustum, or a ring where it runs across the axis.
///
/// The ends of neighbours lie in one plane and have one radius in every precision W: as seen from the base of the axis
/// they are products and differences of two numbers, and nothing is certain in a W in which these are rounded.
template <real T>
struct revolved_segment {
    using number = T;

    vec3<T> base, axis;
    vec2<T> from, to;  ///< (radius, height)

    RAIO_FN constexpr bool is_flat() const { return from.y == to.y; }

    /// The shape in the precision of W, as seen from `from_base`, and the ray from there.
    template <real W>
    RAIO_FN constexpr open_frustum<W> as_frustum(const vec3<W>& from_base) const {
        const vec3<W> a(axis);
        return {from_base + a * W(from.y), from_base + a * W(to.y), W(from.x), W(to.x)};
    }
    template <real W>
    RAIO_FN constexpr ring<W> as_ring(const vec3<W>& from_base) const {
        const vec3<W> a(axis);
        return {from_base + a * W(from.y), a, W(min(from.x, to.x)), W(max(from.x, to.x))};
    }
    template <class W, real R>
    RAIO_FN constexpr raio::ray<W> seen_from_base(const ray<R>& ray) const {
        return {vec3<W>(ray.origin) - vec3<W>(base), vec3<W>(ray.direction)};
    }

    template <class W, real R>
    RAIO_FN constexpr chord<W> crossings(const ray<R>& ray) const {
        const raio::ray<W> moved = seen_from_base<W>(ray);
        const vec3<W> origin(ray.origin), at_base(base), zero(W(0));
        chord<W> c{};
        c.far.certain = true;
        if (is_flat()) {
            c.near = as_ring(zero).template crossings<W>(moved);
        } else {
            c = as_frustum(zero).template crossings<W>(moved);
        }
        constexpr bool products_are_exact = unit_roundoff<W> <= unit_roundoff<T> * unit_roundoff<T>;
        const bool exact = products_are_exact && moved.origin + at_base == origin && origin - moved.origin == at_base;
        for (crossing<W>* end : {&c.near, &c.far}) {
            end->certain = end->certain && exact;
            keep_if_reachable<T>(ray, *end);
        }
        return c;
    }

    template <class W, real R, real N>
    RAIO_FN constexpr void surface(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec) const {
        const raio::ray<W> moved = seen_from_base<W>(ray);
        const vec3<W> zero(W(0));
        hit_record<W, N> local;
        if (is_flat()) {
            as_ring(zero).surface(moved, c, local);
            if (from.x > to.x) local.uv.y = W(1) - local.uv.y;
        } else {
            as_frustum(zero).surface(moved, c, local);
        }
        record_point(ray, c, rec, is_flat() ? T(0) : max(from.x, to.x) + norm1(axis) * abs(to.y - from.y));
        rec.normal = local.normal;
        rec.uv = {min(T(local.uv.x), T(1)), T(local.uv.y)};
    }

    RAIO_FN constexpr T area() const { return is_flat() ? as_ring(base).area() : as_frustum(base).area(); }

    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        return is_flat() ? as_ring(base).sample(u) : as_frustum(base).sample(u);
    }
};

}  // namespace detail

/// What a polyline sweeps that turns about an axis: goblets, vases, whatever comes from a lathe.
///
/// Each of its segments sweeps the side of a frustum, or a ring where it runs across the axis; the nearest of them is
/// hit. Neighbours share their rims, so that no ray slips through between them. `hit_record::index` is the segment. The
/// front is the side away from the axis, and of a ring the side that the axis points to.
///
/// uv: u is the angle about the axis, from the x axis of `frame_about(axis)`; v goes from 0 at the first point to 1 at
/// the last, every segment an equal part of it.
template <real T>
struct surface_of_revolution {
    using number = T;

    vec3<T> base;                  ///< the point of the axis at height 0
    vec3<T> axis;                  ///< of any length but zero: the unit of heights
    std::vector<vec2<T>> profile;  ///< (radius, height) of at least two points; no radius below 0

    mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        bool found = false;
        for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
            hit_record<T> candidate;
            if (!first_hit(segment(i), ray, t_min, found ? rec.t : t_max, candidate)) continue;
            if (found && !(candidate.t < rec.t)) continue;
            rec = candidate;
            rec.index = static_cast<index_t<T>>(i);
            rec.uv.y = (T(static_cast<double>(i)) + rec.uv.y) / T(static_cast<double>(profile.size() - 1));
            found = true;
        }
        return found;
    }

    mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
            if (any_hit(segment(i), ray, t_min, t_max)) return true;
        }
        return false;
    }

    aabb<T> bounds() const {
        aabb<T> box;
        if (profile.size() < 2) return box;
        for (const vec2<T>& end : profile) {
            const vec3<T> center = base + axis * end.y;
            const T rounding = (norm1(base) + norm1(axis) * abs(end.y)) * T(4 * unit_roundoff<T>);
            const vec3<T> reach = disc_reach(axis, end.x) + vec3<T>(rounding);
            box = hull(box, padded(aabb<T>{center - reach, center + reach}));
        }
        return box;
    }

    T area() const {
        T sum(0);
        for (std::size_t i = 0; i + 1 < profile.size(); ++i) sum += segment(i).area();
        return sum;
    }

    /// u.x chooses the segment, and what is left of it is the angle.
    surface_sample<T> sample(const vec2<T>& u) const {
        T left = u.x * area();
        for (std::size_t i = 0; i + 2 < profile.size(); ++i) {
            const T own = segment(i).area();
            if (left < own) return segment(i).sample({left / own, u.y});
            left -= own;
        }
        const auto last = segment(profile.size() - 2);
        return last.sample({min(left / last.area(), T(1 - unit_roundoff<T>)), u.y});
    }

private:
    detail::revolved_segment<T> segment(std::size_t i) const { return {base, axis, profile[i], profile[i + 1]}; }
};

}  // namespace raio
