#pragma once

#include <raio/push_macros.hpp>

#include <array>

#include <raio/concepts.hpp>
#include <raio/formula/box_faces.hpp>
#include <raio/proof/polynomial_crossings.hpp>

namespace raio::inline RAIO_ABI {

/// A part of a blob: a ball or a capsule with a field that falls from `strength` in the centre, or on the axis, to
/// nothing at `radius`.
template <real T>
struct metaball {
    vec3<T> center;
    T radius;            ///< how far the field reaches; of no effect if it is zero
    T strength{1};       ///< what is below zero takes away from the others
    vec3<T> axis{T(0)};  ///< of a capsule: from the centre to that of its other end
};

/// The points where the fields of its components add up to the threshold, or to more: balls that melt into each other
/// (Blinn 1982; with fields that end, as those of Nishimura et al. 1985, and the polynomial of Murakami and Ichihara
/// 1987):
///
///     sum of strength (1 - d^2 / radius^2)^2  over all whose centre is at a distance d < radius,  >=  threshold
///
/// and of a capsule all whose axis is. The line enters and leaves each component, and of a capsule it goes on from one
/// round end to the side, and to the other end. Between two neighbours of these places, in order, the field is one
/// polynomial of degree 4, whose roots are isolated. At the places themselves the polynomials on both sides have the
/// same value and slope, so that it does not matter how they were rounded.
///
/// uv: x and y of the point, from 0 to 1 across the bounds.
/// \tparam Most  how many components there may be; those that are not named have no effect
template <real T, std::size_t Most = 8>
struct blob {
    using number = T;

    /// Four roots of each polynomial, and one polynomial less than there are ends.
    static constexpr std::size_t most_crossings = 24 * Most;

    std::array<metaball<T>, Most> components{};
    T threshold;  ///< missed unless it is positive, and above 2^-900, since there two doubles lose their digits

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr auto spans(const ray<T>& ray) const requires(std::same_as<mask_t<T>, bool>) {
        return inside_of(*this, ray);
    }

    /// Around all components, also where their fields are below the threshold. Without any point if there are none.
    RAIO_FN constexpr aabb<T> bounds() const {
        aabb<T> all;
        for (const metaball<T>& m : components) {
            if (!has_effect(m)) continue;
            const auto around = [&](const vec3<T>& p) { return aabb<T>{p - vec3<T>(m.radius), p + vec3<T>(m.radius)}; };
            all = hull(all, hull(around(m.center), around(m.center + m.axis)));
        }
        all = unless_nan(padded(padded(all)), threshold);
        for (const metaball<T>& m : components) all = unless_nan(all, m.center, m.radius, m.strength, m.axis);
        return all;
    }

    /// The sum of the fields at a point.
    template <class W>
    RAIO_FN constexpr W field(const vec3<W>& p) const {
        W sum(0);
        for (const metaball<T>& m : components) {
            const W within = has_effect(m) ? depth(m, from_axis(m, vec3<W>(p - vec3<W>(m.center)))) : W(0);
            if (within > W(0)) sum += W(m.strength) * within * within;
        }
        return sum;
    }

    template <class Line, class Wanted = every_crossing>
    RAIO_FORMULA constexpr crossing_list<typename Line::number, most_crossings> crossings(
        const Line& line, const Wanted& wanted = {}) const {
        using W = typename Line::number;
        crossing_list<W, most_crossings> list;
        const aabb<T> box = bounds();
        if (!is_sound() || !(box.min.x < box.max.x)) return list;
        const vec3<T> base = box.min + (box.max - box.min) / T(2);
        const vec3<W> size = vec3<W>(box.max) - vec3<W>(box.min);
        const auto part = part_near(line, base, vec3<W>(base), W(length(size) * W(0.5)));
        if (!list.holds(part.is_there())) return list;

        std::array<piece<W>, 3 * Most> pieces;
        std::array<W, 6 * Most> ends;
        std::size_t count = 0, end_count = 0;
        for (const metaball<T>& m : components) {
            if (!has_effect(m)) continue;
            for_each_piece(m, part, base, [&](const piece<W>& p) {
                if (!(p.from < p.to)) return;
                pieces[count++] = p;
                insert(ends, end_count, p.from);
                insert(ends, end_count, p.to);
            });
        }

        piecewise_walk<W, most_crossings> along{part, part.roots_for(wanted), list};
        for (std::size_t i = 0; i + 1 < end_count && !along.is_done; ++i) {
            if (!(ends[i] < ends[i + 1])) continue;
            polynomial<W, 4> f{{W(threshold)}};
            bool empty = true;
            for (std::size_t k = 0; k < count; ++k) {
                if (!(pieces[k].from <= ends[i] && ends[i + 1] <= pieces[k].to)) continue;
                f = f - pieces[k].field;
                empty = false;
            }
            if (empty) {
                along.reach(1);
            } else {
                along.cross(f, ends[i], ends[i + 1]);
            }
        }
        along.reach(1);
        list.start_at_origin();
        return list;
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        vec3<W> p = at.position(), outwards(W(0));
        for (const metaball<T>& m : components) {
            if (!has_effect(m)) continue;
            const vec3<W> beside = from_axis(m, vec3<W>(p - vec3<W>(m.center)));
            const W within = depth(m, beside), over_r = W(1) / W(m.radius);
            if (within > W(0)) outwards += beside * over_r * (W(m.strength) * within * over_r);
        }
        const aabb<T> box = bounds();
        at.record_point(norm1(box.max - box.min));
        at.keep_in([&] { return box; });
        at.record_gradient(outwards);
        at.record_uv([&] { return detail::uv_across(box, index_t<T>(3), at.point()); });
    }

private:
    /// What one component, or a part of it, adds to the field, between the ends of its ball.
    template <class W>
    struct piece {
        W from, to;
        polynomial<W, 4> field;
    };

    RAIO_FN static constexpr bool has_effect(const metaball<T>& m) { return m.radius > T(0) && m.strength != T(0); }

    RAIO_FN constexpr bool is_sound() const {
        using W = working_t<T>;
        bool sound = W(threshold) > W(0x1p-900) && is_finite(threshold);
        for (const metaball<T>& m : components) {
            sound = sound && is_finite(m.center) && is_finite(m.axis) && m.radius >= T(0) && is_finite(m.radius) &&
                    is_finite(m.strength);
        }
        return sound;
    }

    /// The point as seen from the nearest one of the centre or the axis.
    template <class W>
    RAIO_FN static constexpr vec3<W> from_axis(const metaball<T>& m, const vec3<W>& from_center) {
        if (m.axis == vec3<T>(T(0))) return from_center;
        vec3<W> axis(m.axis);
        W height = quotient(dot(from_center, axis), dot(axis, axis), W(0));
        return from_center - axis * max(W(0), min(W(1), height));
    }

    /// 1 in the centre, 0 at the radius.
    template <class W>
    RAIO_FN static constexpr W depth(const metaball<T>& m, const vec3<W>& from_axis) {
        const vec3<W> v = from_axis * (W(1) / W(m.radius));
        return W(1) - dot(v, v);
    }

    /// The pieces of one component: with p as seen from its centre, and from the other end of its axis, the depth is
    /// 1 - p.p / radius^2 in the two balls, and between them 1 - |p x axis|^2 / (axis.axis radius^2).
    template <class W, class Visit>
    RAIO_FN static constexpr void for_each_piece(const metaball<T>& m, const line_part<W>& part, const vec3<T>& base,
                                                 Visit visit) {
        using numbers = shape_numbers<W>;
        const auto one = numbers::given(T(1));
        const auto over_radius = inverse(numbers::given(m.radius));
        const auto axis = numbers::given(m.axis);
        const auto axis2 = square(axis);
        const auto p = part.point() + numbers::between(m.center, base);
        const auto visit_ball = [&](const polynomial_vector<W, 1>& from_center, const W& from, const W& to) {
            visit(between(one - square(from_center * over_radius), m.strength, from, to));
        };
        const W end = W(2) * part.reach;
        if (!is_positive(axis2).yes) return visit_ball(p, -end, end);

        // Where the line is at the height of the centre and of the other end.
        const auto height = dot(p, axis);
        const W start = height.coefficient[0], rise = height.coefficient[1];
        const auto place = [&](const W& h) {
            return max(-end, min(end, quotient(h - start, rise, h > start ? end : -end)));
        };
        const W low = place(W(0)), high = place(axis2.value);
        const bool falls = rise < W(0);
        if (falls ? low < end : -end < low) visit_ball(p, falls ? low : -end, falls ? end : low);
        if (falls ? -end < high : high < end) visit_ball(p - axis, falls ? -end : high, falls ? high : end);
        if (low == high) return;
        const auto from_axis = cross(p, axis) * inverse(sqrt(axis2));
        visit(between(one - square(from_axis * over_radius), m.strength, min(low, high), max(low, high)));
    }

    /// Where the depth, which has its greatest value somewhere, is above zero between two places. Whatever these ends
    /// were rounded to, the depth there is as good as zero, and the field is its square.
    template <class W>
    RAIO_FN static constexpr piece<W> between(const polynomial<W, 2>& depth, const T& strength, const W& from,
                                              const W& to) {
        const auto& c = depth.coefficient;
        W low = from, high = to;
        if (c[2] < W(0)) {
            W middle = W(-0.5) * c[1] / c[2], square = middle * middle - c[0] / c[2];
            W half = square > W(0) ? sqrt(square) : W(0);
            low = max(from, middle - half), high = min(to, middle + half);
        } else if (!(c[0] > W(0))) {
            high = low;
        }
        return {low, high, raio::square(depth) * shape_numbers<W>::given(strength)};
    }

    /// Into a list in order.
    template <class W>
    RAIO_FN static constexpr void insert(std::array<W, 6 * Most>& ends, std::size_t& count, const W& x) {
        std::size_t i = count++;
        for (; i > 0 && x < ends[i - 1]; --i) ends[i] = ends[i - 1];
        ends[i] = x;
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
