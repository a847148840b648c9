#pragma once

#include <raio/hit_record.hpp>
#include <raio/math/interval.hpp>

/// \file
/// Where a ray's line crosses a surface, and how that is settled beyond doubt.
///
/// A shape writes its formula once, for a number type W, and says with each crossing how large the rounding errors of W
/// can have become. For float and double the formula is tried in strict_double. If every decision and the last bit of t
/// are then beyond the error, that is the answer; if not, it is evaluated again in double_double. So t is the exact
/// crossing, correctly rounded, and a ray that just misses misses, at the price of a plain double in all but a few
/// cases (Ziv, ACM TOMS 17(3), 1991, rounds elementary functions like this; Shewchuk, 1997, the signs of determinants).

namespace raio {

/// One crossing of the line `origin + t * direction` with a surface, in the precision of W.
template <class W>
struct crossing {
    mask_t<W> exists;      ///< does the line cross the surface?
    mask_t<W> certain;     ///< is `exists` right whatever the rounding errors were?
    W t;                   ///< ray parameter
    W error;               ///< bound of |t - exact t|
    mask_t<W> entering;    ///< does the line come from the outside here?
    index_t<W> face = {};  ///< which face of the shape, as the shape counts them

    template <class V>
    RAIO_FN constexpr explicit operator crossing<V>() const {
        return {exists, certain, V(t), V(error), entering, face};
    }
};

/// Two crossings of one line, in order. Of a convex solid both exist or none does, and the line is inside between them.
template <class W>
struct chord {
    crossing<W> near, far;
};

template <class Mask, class W>
RAIO_FN constexpr crossing<W> select(Mask mask, const crossing<W>& a, const crossing<W>& b) {
    return {(mask && a.exists) || (!mask && b.exists),
            (mask && a.certain) || (!mask && b.certain),
            select(mask, a.t, b.t),
            select(mask, a.error, b.error),
            (mask && a.entering) || (!mask && b.entering),
            select(mask, a.face, b.face)};
}

/// The chord of a line that is inside everywhere.
template <real W>
RAIO_FN constexpr chord<W> everywhere() {
    const mask_t<W> yes = W(0) == W(0);
    return {{yes, yes, -infinity<W>, W(0), yes}, {yes, yes, infinity<W>, W(0), !yes}};
}

/// The chord of the points that two convex solids share: it starts where the line has entered both and ends where it
/// leaves the first. A face that is entered together with another one counts where it stands first.
template <real W>
RAIO_FN constexpr chord<W> intersect(const chord<W>& a, const chord<W>& b) {
    chord<W> both{select(a.near.t < b.near.t, b.near, a.near), select(b.far.t < a.far.t, b.far, a.far)};
    // If the other crossing may really lie beyond the one that was chosen, the error reaches that far.
    const W other_near = select(a.near.t < b.near.t, a.near.t + a.near.error, b.near.t + b.near.error);
    const W other_far = select(b.far.t < a.far.t, a.far.t - a.far.error, b.far.t - b.far.error);
    both.near.error = max(both.near.error, other_near - both.near.t);
    both.far.error = max(both.far.error, both.far.t - other_far);

    const W gap = both.far.t - both.near.t, slack = both.near.error + both.far.error;
    const mask_t<W> exists = a.near.exists && b.near.exists && gap >= W(0);
    const mask_t<W> certain = (a.near.certain && !a.near.exists) || (b.near.certain && !b.near.exists) ||
                              (a.near.certain && b.near.certain && abs(gap) > slack);
    both.near.exists = both.far.exists = exists;
    both.near.certain = both.far.certain = certain;
    return both;
}

namespace detail {

/// Is the crossing in [t_min, t_max], once it is rounded to T?
template <real T, class W>
RAIO_FN constexpr mask_t<T> in_window(const crossing<W>& c, T t_min, T t_max) {
    const T t = T(c.t);
    return c.exists && t_min <= t && t <= t_max && is_finite(t);
}

/// The first crossing in the window as W finds it; `exists` says whether there is one.
template <real T, class W>
RAIO_FN constexpr crossing<W> first_in_window(crossing<W> c, T t_min, T t_max) {
    c.exists = in_window(c, t_min, t_max);
    return c;
}
template <real T, class W>
RAIO_FN constexpr crossing<W> first_in_window(const chord<W>& c, T t_min, T t_max) {
    const crossing<W> near = first_in_window(c.near, t_min, t_max);
    return select(near.exists, near, first_in_window(c.far, t_min, t_max));
}

/// The same, `certain` only if exact arithmetic would say so too and round to the same t: both ends of the error round
/// to one number, which lies inside the window, or to numbers of which none does.
template <real T, class W>
RAIO_FN constexpr crossing<W> settled_in_window(crossing<W> c, T t_min, T t_max) {
    if (!c.exists) return c;
    const T low = T(c.t - c.error), high = T(c.t + c.error);
    const bool inside = low == high && t_min <= low && high <= t_max && is_finite(low);
    const bool outside = high < t_min || t_max < low;
    c.certain = c.certain && (inside || outside);
    c.exists = inside;
    return c;
}
template <real T, class W>
RAIO_FN constexpr crossing<W> settled_in_window(const chord<W>& c, T t_min, T t_max) {
    crossing<W> first = settled_in_window(c.near, t_min, t_max);
    if (!first.exists && first.certain) first = settled_in_window(c.far, t_min, t_max);
    return first;
}

/// Kept out of line: where it is rare, it must not cost the common case its registers.
template <real T, class Shape>
[[gnu::noinline]] RAIO_FN constexpr crossing<working_t<T>> exact_first_crossing(const Shape& shape, const ray<T>& ray,
                                                                                T t_min, T t_max) {
    return static_cast<crossing<working_t<T>>>(
        first_in_window(shape.template crossings<exact_t<T>>(ray), t_min, t_max));
}

}  // namespace detail

/// The first place in the closed interval [t_min, t_max] where `shape` is crossed, in the working precision of T;
/// `exists` says whether there is one. The shape's `crossings<W>(ray)` returns a crossing or a chord.
template <real T, class Shape>
RAIO_FN constexpr crossing<working_t<T>> first_crossing(const Shape& shape, const ray<T>& ray, T t_min, T t_max) {
    if constexpr (!std::same_as<quick_t<T>, exact_t<T>>) {
        const auto quick = detail::settled_in_window(shape.template crossings<quick_t<T>>(ray), t_min, t_max);
        if (quick.certain) [[likely]]
            return static_cast<crossing<working_t<T>>>(quick);
    }
    return detail::exact_first_crossing(shape, ray, t_min, t_max);
}

/// `hit` of every shape: the first crossing, then the surface there.
template <real T, class Shape>
RAIO_FN constexpr mask_t<T> first_hit(const Shape& shape, const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) {
    const crossing<working_t<T>> c = first_crossing(shape, ray, t_min, t_max);
    if (none(c.exists)) return c.exists;
    if constexpr (std::same_as<mask_t<T>, bool>) {
        shape.surface(ray, c, rec);
    } else {
        hit_record<T> candidate;
        shape.surface(ray, c, candidate);
        assign(c.exists, rec, candidate);
    }
    return c.exists;
}

/// Where the line is inside a convex solid; empty where it misses.
template <real T, class Shape>
RAIO_FN constexpr interval<T> inside_of(const Shape& shape, const ray<T>& ray) {
    const chord<exact_t<T>> c = shape.template crossings<exact_t<T>>(ray);
    return {select(c.near.exists, T(c.near.t), infinity<T>), select(c.far.exists, T(c.far.t), -infinity<T>)};
}

/// Records what every surface records alike: t, the point, how far that may be off, and the side.
template <real T, class W>
RAIO_FN constexpr void record_point(const ray<T>& ray, const crossing<W>& c, hit_record<T>& rec) {
    const vec3<W> origin(ray.origin), direction(ray.direction), step = direction * c.t;
    // Three errors add up: that of t, that of the sum below in W, and the rounding of the point to T.
    const vec3<T> in_w(abs(direction) * c.error + (abs(origin) + abs(step)) * W(4 * unit_roundoff<W>));
    const T least(std::numeric_limits<scalar_t<T>>::min());
    rec.t = T(c.t);
    rec.point = vec3<T>(origin + step);
    rec.error = (in_w + abs(rec.point) * T(unit_roundoff<T>)) * T(1 + 4 * unit_roundoff<T>) + vec3<T>(least);
    rec.index = index_t<T>{};
    rec.front_face = c.entering;
}

}  // namespace raio
