#pragma once

#include <raio/hit_record.hpp>
#include <raio/math/interval.hpp>

/// \file
/// Where a ray's line crosses a surface, and how that is settled beyond doubt.
///
/// A shape writes its formula once, for a number type W, and says with each crossing how large the rounding errors of W
/// can have become. The ray's numbers are the shape's, or have more digits: those of a ray that was mapped. For float
/// and double the formula is tried in strict_double. If every decision and the last bit of t are then beyond the error,
/// that is the answer; if not, it is evaluated again in double_double. So t is the exact crossing, correctly rounded,
/// and a ray that just misses misses (Ziv, ACM TOMS 17(3), 1991, rounds elementary functions like this; Shewchuk, 1997,
/// the signs of determinants). A float needs the second look in a few cases of a thousand. A double needs it for the
/// last bit of every t, but not for a verdict: misses and `occluded` cost what they cost a float.
///
/// The local variables of class type here and in the shapes are not const: GCC keeps a const aggregate in memory, where
/// every step waits for the one before to be stored.

namespace raio {

/// What a comparison has to forgive. The last of several precisions takes what it cannot tell from a tie for one:
/// edges, rims and tangents belong to the shape. A number type that stands alone compares what it has computed.
template <real W>
RAIO_FN constexpr bound_t<W> tie(const bound_t<W>& error) {
    if constexpr (std::same_as<W, double_double>) {
        return error;
    } else {
        return bound_t<W>(0);
    }
}

/// A bound, and what may have been lost besides where small floats lose their digits. What is computed in double does
/// not come near its own smallest numbers.
template <real W>
RAIO_FN constexpr bound_t<W> with_underflow(const bound_t<W>& error) {
    if constexpr (std::same_as<scalar_t<W>, float>) {
        return error + bound_t<W>(least_normal<W>);
    } else {
        return error;
    }
}

/// A bound for the terms of a.(b x c), whose rounding errors are a few times that much of a roundoff: cheap where a
/// closer look can follow, and as tight as it gets where it decides.
template <class W>
RAIO_FN constexpr bound_t<W> triple_product_bound(const vec3<W>& a, const vec3<W>& b, const vec3<W>& c) {
    using E = bound_t<W>;
    if constexpr (std::same_as<W, double_double>) {
        return permanent(vec3<E>(a), vec3<E>(b), vec3<E>(c));
    } else {
        return with_underflow<W>(norm1(a) * with_underflow<W>(norm1(b) * norm1(c)));
    }
}

/// One crossing of the line `origin + t * direction` with a surface, in the precision of W.
template <class W>
struct crossing {
    mask_t<W> exists;      ///< does the line cross the surface?
    mask_t<W> certain;     ///< is `exists` right whatever the rounding errors were?
    W t;                   ///< ray parameter
    bound_t<W> error;      ///< bound of |t - exact t|
    mask_t<W> entering;    ///< does the line come from the outside here?
    index_t<W> face = {};  ///< which face of the shape, as the shape counts them
    vec2<W> uv = {};       ///< where on it, if the shape finds that on the way
};

/// Two crossings of one line, in order. Of a convex solid both exist or none does, and the line is inside between them.
template <class W>
struct chord {
    crossing<W> near, far;
};

template <class Mask, class W>
RAIO_FN constexpr crossing<W> select(Mask mask, const crossing<W>& a, const crossing<W>& b) {
    const auto either = [&](const Mask& x, const Mask& y) { return some(every(mask, x), every(!mask, y)); };
    return {either(a.exists, b.exists),     either(a.certain, b.certain),   select(mask, a.t, b.t),
            select(mask, a.error, b.error), either(a.entering, b.entering), select(mask, a.face, b.face),
            select(mask, a.uv, b.uv)};
}

/// The chord of a line that is inside everywhere.
template <real W>
RAIO_FN constexpr chord<W> everywhere() {
    const mask_t<W> yes = W(0) == W(0);
    const bound_t<W> none(0);
    return {{yes, yes, -infinity<W>, none, yes}, {yes, yes, infinity<W>, none, !yes}};
}

/// The chord of two convex solids that are convex together: from where the line enters the first to where it leaves the
/// last.
template <real W>
RAIO_FN constexpr chord<W> unite(const chord<W>& a, const chord<W>& b) {
    const auto chosen = [](const mask_t<W>& second, const crossing<W>& x, const crossing<W>& y) {
        crossing<W> c = select(second, y, x);
        // The crossing that was passed over counts as far as its error reaches beyond the chosen one.
        bound_t<W> beyond = select(second, x.error, y.error) - abs(bound_t<W>(y.t - x.t));
        c.error = select(every(x.exists, y.exists), max(c.error, beyond), c.error);
        c.certain = every(x.certain, y.certain);
        return c;
    };
    return {chosen(every(b.near.exists, some(!a.near.exists, b.near.t < a.near.t)), a.near, b.near),
            chosen(every(b.far.exists, some(!a.far.exists, b.far.t > a.far.t)), a.far, b.far)};
}

/// The chord of the points that two convex solids share: from where the line has entered both to where it leaves the
/// first. Of two faces that are crossed at the same t, that of `a` is named.
template <real W>
RAIO_FN constexpr chord<W> intersect(const chord<W>& a, const chord<W>& b) {
    using E = bound_t<W>;
    const mask_t<W> b_enters_later = a.near.t < b.near.t, b_leaves_first = b.far.t < a.far.t;
    // The crossing that was passed over counts as far as its error reaches beyond the chosen one.
    const auto error = [](const mask_t<W>& second, const crossing<W>& x, const crossing<W>& y) {
        E apart = abs(E(y.t - x.t));
        return max(select(second, y.error, x.error), select(second, x.error, y.error) - apart);
    };
    chord<W> both = a;
    both.near.t = max(a.near.t, b.near.t);
    both.near.error = error(b_enters_later, a.near, b.near);
    both.near.face = select(b_enters_later, b.near.face, a.near.face);
    both.far.t = min(a.far.t, b.far.t);
    both.far.error = error(b_leaves_first, a.far, b.far);
    both.far.face = select(b_leaves_first, b.far.face, a.far.face);

    W inside = both.far.t - both.near.t;
    E slack = both.near.error + both.far.error;
    const mask_t<W> missed = some(every(a.near.certain, !a.near.exists), every(b.near.certain, !b.near.exists));
    const mask_t<W> decided = every(a.near.certain, b.near.certain, abs(inside) > slack);
    both.near.exists = both.far.exists = every(a.near.exists, b.near.exists, inside >= -tie<W>(slack));
    both.near.certain = both.far.certain = some(missed, decided);
    return both;
}

namespace detail {

/// Is the crossing in [t_min, t_max], once it is rounded to T?
template <real T, class W>
RAIO_FN constexpr mask_t<T> in_window(const crossing<W>& c, T t_min, T t_max) {
    const T t = T(c.t);
    return every(c.exists, t_min <= t, t <= t_max, is_finite(t));
}

/// The first crossing in the window as W finds it; `exists` says whether there is one.
template <real T, class W>
RAIO_FN constexpr crossing<W> first_in_window(crossing<W> c, T t_min, T t_max) {
    c.exists = in_window(c, t_min, t_max);
    return c;
}
template <real T, class W>
RAIO_FN constexpr crossing<W> first_in_window(const chord<W>& c, T t_min, T t_max) {
    crossing<W> near = first_in_window(c.near, t_min, t_max);
    return select(near.exists, near, first_in_window(c.far, t_min, t_max));
}

/// What is asked of the first crossing: only whether there is one, or also where.
enum class question { whether, where };

/// The same, `certain` only if exact arithmetic would say so too: wherever in its error t is, it lies inside the
/// window, or outside; and if t is asked for, both ends of the error round to the same.
template <question Asked, real T, class W>
RAIO_FN constexpr crossing<W> settled_in_window(crossing<W> c, T t_min, T t_max) {
    if (!c.exists) return c;
    const T low = T(c.t - c.error), high = T(c.t + c.error);
    const bool inside = every(t_min <= low, high <= t_max, is_finite(high), Asked == question::whether || low == high);
    const bool outside = some(high < t_min, t_max < low);
    c.certain = every(c.certain, some(inside, outside));
    c.exists = inside;
    return c;
}
template <question Asked, real T, class W>
RAIO_FN constexpr crossing<W> settled_in_window(const chord<W>& c, T t_min, T t_max) {
    crossing<W> first = settled_in_window<Asked>(c.near, t_min, t_max);
    if (!first.exists && first.certain) first = settled_in_window<Asked>(c.far, t_min, t_max);
    return first;
}

/// Is there a quicker precision, and does it hold the numbers of the ray without rounding them?
template <real T, real R>
inline constexpr bool has_quick =
    !std::same_as<quick_t<T>, exact_t<T>> && unit_roundoff<quick_t<T>> <= unit_roundoff<R>;

/// Out of line: where this is rare, it must not cost the common case its registers.
template <real T, class Shape, real R, class Then>
[[gnu::noinline]] RAIO_FN constexpr mask_t<T> settle_exactly(const Shape& shape, const ray<R>& ray, T t_min, T t_max,
                                                             Then then) {
    auto exact = first_in_window(shape.template crossings<exact_t<T>>(ray), t_min, t_max);
    if constexpr (has_quick<T, R>) {
        if (!exact.exists) {
            // If the quick crossing is certain all the same, the exact one has overflowed: numbers near the end of the
            // range.
            auto quick = shape.template crossings<quick_t<T>>(ray);
            auto verdict = settled_in_window<question::whether>(quick, t_min, t_max);
            if (verdict.certain && verdict.exists) return then(verdict);
        }
    }
    return then(exact);
}

/// Finds the first crossing in the window, in the precision that it takes, and returns what `then` makes of it.
template <question Asked, real T, class Shape, real R, class Then>
RAIO_FN constexpr mask_t<T> settle(const Shape& shape, const ray<R>& ray, T t_min, T t_max, Then then) {
    if constexpr (has_quick<T, R>) {
        auto quick = settled_in_window<Asked>(shape.template crossings<quick_t<T>>(ray), t_min, t_max);
        if (quick.certain) [[likely]]
            return then(quick);
    }
    return settle_exactly(shape, ray, t_min, t_max, then);
}

}  // namespace detail

/// `occluded` of every shape that has `crossings<W>(ray)`, a crossing or a chord: is there one with t in [t_min,
/// t_max]?
template <real T, class Shape, real R>
RAIO_FN constexpr mask_t<T> any_hit(const Shape& shape, const ray<R>& ray, T t_min, T t_max) {
    return detail::settle<detail::question::whether>(shape, ray, t_min, t_max,
                                                     [](const auto& crossing) { return crossing.exists; });
}

/// `hit` of every shape that has also `surface(ray, crossing, rec)`: the same crossing, and what to record of it.
template <real T, class Shape, real R, real N>
RAIO_FN constexpr mask_t<T> first_hit(const Shape& shape, const ray<R>& ray, T t_min, T t_max, hit_record<T, N>& rec) {
    return detail::settle<detail::question::where>(shape, ray, t_min, t_max, [&](const auto& crossing) {
        if constexpr (std::same_as<mask_t<T>, bool>) {
            if (crossing.exists) shape.surface(ray, crossing, rec);
        } else if (any(crossing.exists)) {
            hit_record<T, N> candidate;
            shape.surface(ray, crossing, candidate);
            assign(crossing.exists, rec, candidate);
        }
        return crossing.exists;
    });
}

/// Where the line is inside a convex solid; empty where it misses. Both ends are as exact as a hit's t.
template <class Shape, real R>
RAIO_FN constexpr auto inside_of(const Shape& shape, const ray<R>& ray) {
    using T = typename Shape::number;
    const auto between_ends = [](const auto& c) {
        const mask_t<T> meets = some(c.near.exists, c.far.exists);  // an end out of T's range is still an end
        return interval<T>{select(meets, T(c.near.t), infinity<T>), select(meets, T(c.far.t), -infinity<T>)};
    };
    if constexpr (detail::has_quick<T, R>) {
        auto quick = shape.template crossings<quick_t<T>>(ray);
        const bool meets = some(quick.near.exists, quick.far.exists);
        const auto settled = [&](const auto& c) {
            return every(c.certain, some(!meets, T(c.t - c.error) == T(c.t + c.error)));
        };
        if (every(settled(quick.near), settled(quick.far))) [[likely]]
            return between_ends(quick);
    }
    return between_ends(shape.template crossings<exact_t<T>>(ray));
}

/// Keeps only crossings whose point T can say: those of a shape without end may lie beyond its largest number.
template <real T, real R, class W>
RAIO_FN constexpr void keep_if_reachable(const ray<R>& ray, crossing<W>& c) {
    vec3<bound_t<W>> origin(vec3<W>(ray.origin)), direction(vec3<W>(ray.direction));
    bound_t<W> farthest = norm1(origin) + norm1(direction) * abs(bound_t<W>(c.t));
    const bound_t<W> most(std::numeric_limits<scalar_t<T>>::max() / 2);
    if constexpr (std::same_as<W, T>) {  // whoever takes a closer look decides so close to the end of the range
        c.certain = every(c.certain, some(!c.exists, farthest + norm1(direction) * c.error < most / bound_t<W>(2)));
    }
    c.exists = every(c.exists, farthest < most);
}

/// Records what every surface records alike: t, the point, how far that may be off, and the side.
/// \param bend  the smallest radius at which the surface curves; 0 if it is flat
template <real T, real N, real R, class W>
RAIO_FN constexpr void record_point(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec, T bend = T(0)) {
    rec.t = T(c.t) + T(0);  // never -0
    rec.point = vec3<T>(vec3<W>(ray.origin) + vec3<W>(ray.direction) * c.t);

    // Three errors add up: that of t, that of the sum above in W, where |direction t| <= |origin| + |point|, and the
    // rounding of the point to T. The smallest normal number stands for all that underflows.
    constexpr double in_w = 8 * unit_roundoff<W>, in_t = unit_roundoff<T>, up = 1 + 4 * in_t;
    const T least(least_normal<T>), most(std::numeric_limits<scalar_t<T>>::max());
    const T of_t = min(T(c.error + bound_t<W>(least)), most);
    // A ray that leaves at the angle of the normal's own rounding must not meet a curved surface again, and every
    // crossing of a point that is off by this much has to be certain in double_double.
    const T floor = bend * T(4 * in_t * in_t) + (bend + norm1(rec.point)) * T(0x1p-88) + least;
    vec3<T> error = vec3<T>(abs(ray.direction) * R(of_t)) + vec3<T>(abs(ray.origin) * R(in_w));
    error += abs(rec.point) * T(in_t + in_w);
    error = error * T(up) + vec3<T>(floor);
    rec.error = {min(error.x, most), min(error.y, most), min(error.z, most)};
    rec.index = index_t<T>{};
    rec.front_face = c.entering;
}

}  // namespace raio
