#pragma once

#include <raio/proof/record.hpp>
#include <raio/proof/refine.hpp>
#include <raio/proof/settle_lanes.hpp>
#include <raio/proof/window.hpp>

/// \file
/// How a crossing is settled beyond doubt, and recorded.
///
/// For float and double a shape's formula is tried in strict_double. If every decision and the last bit of t are then
/// beyond the error, that is the answer. If only the last bit is not, as of nearly every t in double, t is refined
/// (proof/refine.hpp). If that does not settle it, or a decision is open, the formula is evaluated again in
/// double_double. So t is the exact crossing, correctly rounded, and a ray that just misses misses (Ziv, ACM TOMS
/// 17(3), 1991, rounds elementary functions like this; Shewchuk, 1997, the signs of determinants). A few rays of a
/// thousand need the closer look in float. In double misses and `occluded` cost what they cost in float. The first try
/// with a ray of more digits, one that was mapped, is in rounded_double.

namespace raio {

namespace detail {

/// Is there a quicker precision?
template <real T>
inline constexpr bool works_first = !std::same_as<working_t<T>, exact_t<T>>;

/// The quicker precision, for shapes of T and rays of R, whose numbers it may have to round.
template <real T, real R>
using quick_t = std::conditional_t<unit_roundoff<working_t<T>> <= unit_roundoff<R>, working_t<T>, rounded_double>;

/// The same question, if the quick crossing has not answered it: what is missing of that is added, or the exact formula
/// decides. Out of line, and without what is known already: where this is rare, it must not cost the common case its
/// registers.
template <real T, class Shape, real R, class Then>
[[gnu::noinline]] RAIO_FN constexpr mask_t<T> settle_closer(const Shape& shape, const ray<R>& ray, T t_min, T t_max,
                                                            Then then) {
    using W = quick_t<T, R>;
    using X = exact_t<T>;
    if constexpr (works_first<T>) {
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
    if constexpr (works_first<T>) {
        keep_as_stored<T>(shape, ray);
        auto quick = crossings_for<quick_t<T, R>, Asked>(shape, ray, t_min, t_max);
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

}  // namespace detail

/// `occluded` of every shape that has `crossings<W>(ray)`, a crossing or a chord: is there one with t in [t_min,
/// t_max]?
template <real T, class Shape, real R>
RAIO_FLATTEN RAIO_FN constexpr mask_t<T> any_hit(const Shape& shape, const ray<R>& ray, T t_min, T t_max) {
    return detail::settle<detail::question::whether>(shape, ray, t_min, t_max,
                                                     [](const auto& crossing) { return crossing.exists; });
}

/// `hit` of every shape that has also `surface(ray, crossing, rec)`: the same crossing, and what to record of it.
/// \tparam Asked  `only_where` if there is one beyond doubt
template <detail::question Asked = detail::question::where, real T, class Shape, real R, real N>
RAIO_FLATTEN RAIO_FN constexpr mask_t<T> first_hit(const Shape& shape, const ray<R>& ray, T t_min, T t_max,
                                                   hit_record<T, N>& rec) {
    return detail::settle<Asked>(shape, ray, t_min, t_max, [&](const auto& crossing) {
        if (crossing.exists) detail::record(shape, ray, crossing, rec);
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
    if constexpr (detail::works_first<T>) {
        detail::keep_as_stored<T>(shape, ray);
        auto quick = shape.template crossings<detail::quick_t<T, R>>(ray);
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

}  // namespace raio
