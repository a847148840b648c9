#pragma once

#include <raio/crossing.hpp>
#include <raio/hit_record.hpp>
#include <raio/refine.hpp>

/// \file
/// How a crossing is settled beyond doubt, and recorded.
///
/// For float and double a shape's formula is tried in strict_double. If every decision and the last bit of t are then
/// beyond the error, that is the answer. If only the last bit is not, as of nearly every t in double, t is refined
/// (refine.hpp). If that does not settle it, or a decision is open, the formula is evaluated again in double_double. So
/// t is the exact crossing, correctly rounded, and a ray that just misses misses (Ziv, ACM TOMS 17(3), 1991, rounds
/// elementary functions like this; Shewchuk, 1997, the signs of determinants). A few rays of a thousand need the
/// closer look in float. In double misses and `occluded` cost what they cost in float.

namespace raio {

namespace detail {

/// An end of a window of T, so far out that no exact t from beyond is rounded into the window.
/// \param sign  -1 for the lower end, 1 for the upper one
template <class W, real T>
RAIO_FN constexpr W widened(const T& end, double sign) {
    if (!is_finite(end)) return W(end);
    return W(end) + W(sign) * (abs(W(end)) * W(2 * unit_roundoff<T>) + W(least_normal<T>));
}

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

/// What is asked of the first crossing: only whether there is one, or also where; or only where, if there is one beyond
/// doubt.
enum class question { whether, where, only_where };

/// The crossings of a shape; of one that can find less with less work only what the question wants to know.
template <class W, question Asked, class Shape, real R, real T>
RAIO_FORMULA constexpr auto crossings_for(const Shape& shape, const ray<R>& ray, T t_min, T t_max) {
    constexpr bool known = Asked == question::only_where && requires {
        { shape.template crossings<W>(ray, known_crossing{}) } -> std::same_as<crossing<W>>;
    };
    if constexpr (known) {
        return shape.template crossings<W>(ray, known_crossing{});
    } else if constexpr (requires { shape.template crossings<W>(ray, first_from<T>{}); }) {
        return shape.template crossings<W>(ray, first_from<T>{t_min, t_max, Asked == question::whether});
    } else {
        return shape.template crossings<W>(ray);
    }
}

/// The first crossing that may be in the window as W finds it, and whether exact arithmetic is known to say the same:
/// the crossing is certain, wherever in its error t is, it lies inside the window, or outside; and if t is asked for,
/// both ends of the error round to the same.
template <class W>
struct verdict {
    crossing<W> first;
    bool known;
};

/// Is t certain to the last bit of T: do both ends of its error round to the same?
template <real T, class W>
RAIO_FN constexpr bool rounds_to_one(const crossing<W>& c) {
    return T(sum_as<W>(-c.error, c.t)) == T(sum_as<W>(c.error, c.t));
}

template <question Asked, real T, class W>
RAIO_FN constexpr verdict<W> settled_in_window(crossing<W> c, T t_min, T t_max) {
    if constexpr (Asked == question::only_where) {
        c.exists = true;
        return {c, every(rounds_to_one<T>(c), is_finite(T(c.t)))};
    }
    if (!c.exists) return {c, c.certain};
    const T low = T(c.t - c.error), high = T(c.t + c.error);
    const bool inside = every(t_min <= low, high <= t_max, is_finite(high), Asked == question::whether || low == high);
    const bool outside = some(high < t_min, t_max < low);
    c.exists = !outside;
    return {c, every(c.certain, some(inside, outside))};
}
template <question Asked, real T, class W>
RAIO_FN constexpr verdict<W> settled_in_window(const chord<W>& c, T t_min, T t_max) {
    // Of two crossings it has to be found out which one it is.
    constexpr question asked = Asked == question::whether ? question::whether : question::where;
    verdict<W> found = settled_in_window<asked>(c.near, t_min, t_max);
    if (!found.first.exists && found.known) found = settled_in_window<asked>(c.far, t_min, t_max);
    return found;
}

/// Is there a quicker precision, and does it hold the numbers of the ray without rounding them?
template <real T, real R>
inline constexpr bool works_first =
    !std::same_as<working_t<T>, exact_t<T>> && unit_roundoff<working_t<T>> <= unit_roundoff<R>;

/// Does the shape say what is missing of a crossing?
template <class Shape, class X, class W>
concept correctable = requires(const Shape shape, const nearby_ray<X, W> ray, const crossing<W> c) {
    shape.correction(ray, c);
};

/// Does a line that is known to cross the surface do so at a number, which can be refined?
template <class W>
RAIO_FN constexpr bool refinable(const crossing<W>& c) {
    return every(c.certain, c.exists, is_finite(c.t));
}

/// Is there no use in asking whether a quick t is certain to its last bit? It has no more bits than T.
template <class Shape, class T>
concept always_refined = correctable<Shape, exact_t<T>, working_t<T>> && std::same_as<wider_t<T>, exact_t<T>>;

/// Is a refined crossing beyond doubt: inside the window, and to the last bit of T?
template <real T, class X>
RAIO_FN constexpr bool is_settled(const crossing<X>& fine, T t_min, T t_max) {
    return fine.certain && rounds_to_one<T>(fine) && in_window(fine, t_min, t_max);
}

/// The same question, if the quick crossing has not answered it: what is missing of that is added, or the exact formula
/// decides. Out of line, and without what is known already: where this is rare, it must not cost the common case its
/// registers.
template <real T, class Shape, real R, class Then>
[[gnu::noinline]] RAIO_FN constexpr mask_t<T> settle_closer(const Shape& shape, const ray<R>& ray, T t_min, T t_max,
                                                            Then then) {
    using W = working_t<T>;
    using X = exact_t<T>;
    if constexpr (works_first<T, R>) {
        auto [quick, known] = settled_in_window<question::whether>(
            crossings_for<W, question::where>(shape, ray, t_min, t_max), t_min, t_max);
        if constexpr (correctable<Shape, X, W>) {
            // Whatever the window is, and whatever is asked, it is the same crossing that is found.
            if (refinable(quick)) {
                auto fine = refined<X>(shape, ray, quick);
                if (is_settled(fine, t_min, t_max)) return then(fine);
            }
        }
        auto exact = first_in_window(crossings_for<X, question::where>(shape, ray, t_min, t_max), t_min, t_max);
        // If the quick crossing is certain all the same, the exact one has overflowed: numbers near the end of the
        // range.
        return !exact.exists && known && quick.exists ? then(quick) : then(exact);
    } else {
        return then(first_in_window(crossings_for<X, question::where>(shape, ray, t_min, t_max), t_min, t_max));
    }
}

/// Finds the first crossing in the window, in the precision that it takes, and returns what `then` makes of it.
template <question Asked, real T, class Shape, real R, class Then>
RAIO_FORMULA constexpr mask_t<T> settle(const Shape& shape, const ray<R>& ray, T t_min, T t_max, Then then) {
    if constexpr (works_first<T, R>) {
        keep_as_stored<T>(shape, ray);
        auto quick = crossings_for<working_t<T>, Asked>(shape, ray, t_min, t_max);
        if constexpr (Asked != question::whether && always_refined<Shape, T>) {
            auto [first, known] = settled_in_window<question::whether>(quick, t_min, t_max);
            if (known && !first.exists) return false;
            if (refinable(first)) [[likely]] {
                auto fine = refined<exact_t<T>>(shape, ray, first);
                if (is_settled(fine, t_min, t_max)) [[likely]]
                    return then(fine);
            }
        } else {
            auto [first, known] = settled_in_window<Asked>(quick, t_min, t_max);
            if (known) [[likely]]
                return then(first);
        }
    }
    return settle_closer(shape, ray, t_min, t_max, then);
}

// Out of line, as what is rare.

template <real T, real N>
[[gnu::noinline]] RAIO_FN constexpr void put_within_range(hit_record<T, N>& rec) {
    rec.point = within_range(rec.point);
}

template <real R, real T, real N>
[[gnu::noinline]] RAIO_FN constexpr void put_against(const ray<R>& ray, hit_record<T, N>& rec) {
    const mask_t<N> has_normal = rec.normal.x == rec.normal.x;
    rec.normal = select(has_normal, rec.normal, -normalize(vec3<N>(ray.direction)));
    const auto number_or_0 = [](const T& x) { return select(x == x, x, T(0)); };
    rec.uv = {number_or_0(rec.uv.x), number_or_0(rec.uv.y)};
}

/// What the shape records of a crossing. Where its numbers are so uneven that no normal is left of them, that is
/// against the ray; and what is left of uv is 0.
template <class Shape, real R, class Crossing, real T, real N>
RAIO_FN constexpr void record(const Shape& shape, const ray<R>& ray, const Crossing& crossing, hit_record<T, N>& rec) {
    shape.surface(ray, crossing, rec);
    if (!all(rec.normal.x == rec.normal.x)) put_against(ray, rec);
}

}  // namespace detail

/// `occluded` of every shape that has `crossings<W>(ray)`, a crossing or a chord: is there one with t in [t_min,
/// t_max]?
template <real T, class Shape, real R>
[[gnu::flatten]] RAIO_FN constexpr mask_t<T> any_hit(const Shape& shape, const ray<R>& ray, T t_min, T t_max) {
    return detail::settle<detail::question::whether>(shape, ray, t_min, t_max,
                                                     [](const auto& crossing) { return crossing.exists; });
}

/// `hit` of every shape that has also `surface(ray, crossing, rec)`: the same crossing, and what to record of it.
/// \tparam Asked  `only_where` if there is one beyond doubt
template <detail::question Asked = detail::question::where, real T, class Shape, real R, real N>
[[gnu::flatten]] RAIO_FN constexpr mask_t<T> first_hit(const Shape& shape, const ray<R>& ray, T t_min, T t_max,
                                                       hit_record<T, N>& rec) {
    return detail::settle<Asked>(shape, ray, t_min, t_max, [&](const auto& crossing) {
        if constexpr (std::same_as<mask_t<T>, bool>) {
            if (crossing.exists) detail::record(shape, ray, crossing, rec);
        } else if (any(crossing.exists)) {
            hit_record<T, N> candidate;
            detail::record(shape, ray, crossing, candidate);
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
    if constexpr (detail::works_first<T, R>) {
        detail::keep_as_stored<T>(shape, ray);
        auto quick = shape.template crossings<working_t<T>>(ray);
        const bool meets = some(quick.near.exists, quick.far.exists);
        const auto settled = [](const auto& c) { return c.certain && detail::rounds_to_one<T>(c); };
        if (!meets) {
            if (every(quick.near.certain, quick.far.certain)) return between_ends(quick);
        } else if constexpr (detail::always_refined<Shape, T>) {
            if (detail::refinable(quick.near) && detail::refinable(quick.far)) {
                chord<exact_t<T>> fine{refined<exact_t<T>>(shape, ray, quick.near),
                                       refined<exact_t<T>>(shape, ray, quick.far)};
                if (settled(fine.near) && settled(fine.far)) return between_ends(fine);
            }
        } else if (every(settled(quick.near), settled(quick.far))) [[likely]] {
            return between_ends(quick);
        }
    }
    return between_ends(shape.template crossings<exact_t<T>>(ray));
}

/// Records what every surface records alike: t, the point, how far that may be off, and the side.
/// \param bend  the smallest radius at which the surface curves; 0 if it is flat
template <real T, real N, real R, class W>
RAIO_FN constexpr void record_point(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec, T bend = T(0)) {
    rec.t = T(c.t) + T(0);  // never -0
    rec.point = vec3<T>(sum_as<W>(ray.origin, product_as<W>(ray.direction, c.t)));
    const T reach = norm1(rec.point);
    if (!all(is_finite(reach))) detail::put_within_range(rec);

    // Three errors add up: that of t, that of the sum above in W, where |direction t| <= |origin| + |point|, and the
    // rounding of the point to T. The smallest normal number stands for all that underflows.
    constexpr double in_w = 8 * unit_roundoff<W>, in_t = unit_roundoff<T>, up = 1 + 4 * in_t;
    const T least(least_normal<T>), most(std::numeric_limits<scalar_t<T>>::max());
    const T of_t = min(T(c.error + bound_t<W>(least)), most);
    // A ray that leaves at the angle of the normal's own rounding must not meet a curved surface again, and every
    // crossing of a point that is off by this much has to be certain in double_double.
    const T floor = bend * T(4 * in_t * in_t) + (bend + reach) * T(0x1p-88) + least;
    vec3<T> error = vec3<T>(abs(ray.direction) * R(of_t)) + vec3<T>(abs(ray.origin) * R(in_w));
    error += abs(rec.point) * T(in_t + in_w);
    error = error * T(up) + vec3<T>(floor);
    rec.error = {min(most, error.x), min(most, error.y), min(most, error.z)};  // `most` also for what is not a number
    rec.index = index_t<T>{};
    rec.front_face = c.entering;
}

/// Keeps a recorded point within the bounds: that of a ray that grazes a tip, where W, as the last precision, does not
/// know t well, may have come to lie beyond them.
/// \param bounds  answers with them, to be asked only then
template <class W, real T, real N, class Bounds>
RAIO_FN constexpr void keep_in_bounds([[maybe_unused]] hit_record<T, N>& rec, [[maybe_unused]] Bounds bounds) {
    if constexpr (std::same_as<W, double_double>) {
        constexpr double rounding = (1 + 0x1p-7) * unit_roundoff<T>;  // `padded` has room for that 128th
        if (norm1(rec.error) > norm1(rec.point) * T(rounding)) rec.point = nearest_in(bounds(), rec.point);
    }
}

/// Records a point that lies between corners: seen edge-on or from far away, the computed one may lie beyond them.
template <class W, real R, real T, real N>
RAIO_FN constexpr void record_point_between(const aabb<T>& corners, const ray<R>& ray, const crossing<W>& c,
                                            hit_record<T, N>& rec, T bend = T(0)) {
    record_point(ray, c, rec, bend);
    rec.point = nearest_in(corners, rec.point);
}

}  // namespace raio
