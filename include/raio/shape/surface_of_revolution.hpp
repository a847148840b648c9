#pragma once

#include <raio/push_macros.hpp>

#include <span>
#include <vector>

#include <raio/formula/revolution.hpp>
#include <raio/proof/line_beside_axis.hpp>
#include <raio/shape/frustum.hpp>
#include <raio/shape/ring.hpp>

namespace raio::inline RAIO_ABI {

namespace detail {

/// What one piece of a profile of this degree sweeps.
template <real T, std::size_t Degree>
struct revolved_piece;

/// What a straight one sweeps: the side of a frustum, or a ring where it runs across the axis.
///
/// The ray is seen from the base of the axis. That is rounded, and so are the points of the axis from there: by less
/// than a rounding of twice their sizes together.
template <real T>
struct revolved_piece<T, 1> {
    using number = T;

    vec3<T> base, axis;
    vec2<T> from, to;  ///< (radius, height)

    template <class Line>
    RAIO_FORMULA constexpr chord<typename Line::number> crossings(const Line& line) const {
        auto a = line.given(axis);
        auto d = line.direction();
        const auto to_axis_at = [&](const T& height) { return line.to(base) + a * line.given(height); };
        chord<typename Line::number> c = nowhere<typename Line::number>();
        if (is_flat()) {
            c.near = cross_between_rims(d, a, to_axis_at(from.y), line.given(min(from.x, to.x)),
                                        line.given(max(from.x, to.x)));
        } else {
            auto to_narrow = to_axis_at(narrow_end().y);
            auto to_wide = to_axis_at(wide_end().y);
            auto along = a * line.between(narrow_end().y, wide_end().y);
            c = cross_nappe(line, to_narrow, along, narrow_end().x, wide_end().x);
            if (missed(c)) return c;
            const bool widens = narrow_end().y < wide_end().y;
            const auto slab = widens ? cross_slab(a, dot(a, to_narrow), dot(a, to_wide), d)
                                     : cross_slab(a, dot(a, to_wide), dot(a, to_narrow), d);
            c = cut<false>(c, slab);
        }
        keep_if_in_range<T>(line, c);  // no point beyond the largest number
        return c;
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        using Q = typename Point::precise;
        const vec3<W> a(axis), start = a * W(from.y), along = is_flat() ? a : a * W(to.y) - start;
        const vec3<W> from_start = at.from(base) - start;
        const W height = dot(from_start, along) / dot(along, along);
        const vec3<W> from_axis = from_start - along * height;
        if (is_flat()) {
            at.record_point();
            put_onto_plane(at, axis, vec3<T>(vec3<W>(base) + start));
            at.record_normal(axis);
        } else {
            at.record_point(max(from.x, to.x) + norm1(axis) * abs(to.y - from.y));
            at.record_normal(frustum_gradient(at, along, vec2<T>(from.x, to.x), from_axis, height));
        }
        at.record_uv([&] {
            const frame<Q> f = frame_about(normalize_from<T>(vec3<Q>(a)));
            const vec3<Q> beside(from_axis);
            const Q rho = length(beside), low(from.x), part = is_flat() ? (rho - low) / (Q(to.x) - low) : Q(height);
            return uv_about(f, beside, T(part));
        });
    }

    template <class Point>
    RAIO_FN constexpr auto is_close_to_tip(const Point& at) const {
        return is_close_to_axis(at, base, vec3<typename Point::number>(axis), max(abs(from.y), abs(to.y)));
    }

    RAIO_FN constexpr T area() const { return is_flat() ? as_ring().area() : as_frustum().area(); }

    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        return is_flat() ? as_ring().sample(u) : as_frustum().sample(u);
    }

private:
    RAIO_FN constexpr bool is_flat() const { return from.y == to.y; }
    RAIO_FN constexpr const vec2<T>& narrow_end() const { return to.x < from.x ? to : from; }
    RAIO_FN constexpr const vec2<T>& wide_end() const { return to.x < from.x ? from : to; }

    RAIO_FN constexpr open_frustum<T> as_frustum() const {
        return {base + axis * from.y, base + axis * to.y, from.x, to.x};
    }
    RAIO_FN constexpr ring<T> as_ring() const {
        return {base + axis * from.y, axis, min(from.x, to.x), max(from.x, to.x)};
    }
};

}  // namespace detail

/// What a line of points sweeps that turns about an axis: goblets, vases, whatever comes from a lathe. The points are
/// those of a polyline, or the control points of cubic Bezier segments, every third of which lies on the curve.
///
/// Each segment sweeps a piece, and the nearest of them is hit: of a straight one the side of a frustum, or a ring
/// where it runs across the axis. Neighbours share their rims, so that no ray slips through between them.
/// `hit_record::index` is the segment. The front is the side away from the axis, and of what runs across the axis the
/// side that the axis points to.
///
/// uv: u is the angle about the axis in turns, from the x axis of `frame_about(axis)`; v goes from 0 at the first point
/// to 1 at the last, every segment an equal part of it.
/// \tparam Degree  1 for a polyline, 3 for cubic Bezier segments (curved_surface_of_revolution.hpp)
template <real T, std::size_t Degree = 1>
struct surface_of_revolution {
    static_assert(Degree == 1 || Degree == 3);

    using number = T;

    vec3<T> base;                  ///< the point of the axis at height 0
    vec3<T> axis;                  ///< of any length but zero: the unit of heights
    std::vector<vec2<T>> profile;  ///< (radius, height) of 1 + n Degree points, n >= 1; no radius below 0

    template <record Record>
    mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        bool found = false;
        if (segments() == 0) return found;
        hit_record<T> nearest{};
        auto line = seen_by(ray, t_min, t_max);
        for (std::size_t i = 0; i < segments(); ++i) {
            if (line.passes(bounds_of(i))) continue;
            hit_record<T> candidate;
            if (!first_hit(segment(i), ray, t_min, found ? nearest.t : t_max, candidate)) continue;
            if (found && !(candidate.t < nearest.t)) continue;
            nearest = candidate;
            nearest.index = static_cast<index_t<T>>(i);
            found = true;
            line.end_at(nearest.t);
        }
        if (!found) return found;
        nearest.uv.y = (T(static_cast<double>(nearest.index)) + nearest.uv.y) / T(static_cast<double>(segments()));
        assign(rec, nearest);
        return found;
    }

    mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        if (segments() == 0) return false;
        const auto line = seen_by(ray, t_min, t_max);
        for (std::size_t i = 0; i < segments(); ++i) {
            if (!line.passes(bounds_of(i)) && any_hit(segment(i), ray, t_min, t_max)) return true;
        }
        return false;
    }

    aabb<T> bounds() const {
        aabb<T> box;
        if (segments() == 0) return unless_nan(box, base, axis);
        for (const vec2<T>& end : profile) {
            const vec3<T> center = base + axis * end.y;
            const T rounding = (norm1(base) + norm1(axis) * abs(end.y)) * T(4 * unit_roundoff<T>);
            const vec3<T> reach = disc_reach(axis, end.x) + vec3<T>(rounding);
            box = hull(box, padded(aabb<T>{center - reach, center + reach}));
        }
        if constexpr (Degree > 1) {
            box = with_room_for_tips(box);
        }
        return unless_nan(box, base, axis);
    }

    T area() const requires(Degree == 1) {
        T sum(0);
        for (std::size_t i = 0; i < segments(); ++i) sum += segment(i).area();
        return sum;
    }

    /// u.x chooses the segment, and what is left of it is the angle.
    surface_sample<T> sample(const vec2<T>& u) const requires(Degree == 1) {
        T left = u.x * area();
        for (std::size_t i = 0; i + 1 < segments(); ++i) {
            const T own = segment(i).area();
            if (left < own) return segment(i).sample({left / own, u.y});
            left -= own;
        }
        const auto last = segment(segments() - 1);
        return last.sample({min(left / last.area(), T(1 - unit_roundoff<T>)), u.y});
    }

private:
    std::size_t segments() const { return profile.empty() ? 0 : (profile.size() - 1) / Degree; }

    detail::profile_bounds<T> bounds_of(std::size_t i) const {
        return detail::profile_bounds<T>::around(std::span(profile).subspan(Degree * i, Degree + 1));
    }

    auto seen_by(const ray<T>& ray, T t_min, T t_max) const {
        const auto whole = detail::profile_bounds<T>::around(profile);
        return detail::line_beside_axis<working_t<T>>(line_in<working_t<T>>(ray), base, axis, whole, t_min, t_max);
    }

    auto segment(std::size_t i) const {
        using piece = detail::revolved_piece<T, Degree>;
        const vec2<T>* p = &profile[Degree * i];
        if constexpr (Degree == 1) {
            return piece{base, axis, p[0], p[1]};
        } else {
            return piece{base, axis, p[0], p[1], p[2], p[3]};
        }
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
