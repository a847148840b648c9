#pragma once

#include <raio/push_macros.hpp>

#include <array>

#include <raio/proof/normal.hpp>
#include <raio/proof/settle_lanes.hpp>
#include <raio/proof/window.hpp>

/// \file
/// How a crossing is settled beyond doubt, and recorded.
///
/// For float and double a shape's formula is tried in strict_double, which states its errors. What is beyond doubt then
/// is the answer; for the rest the formula is evaluated again in double_double (Ziv, ACM TOMS 17(3), 1991, rounds
/// elementary functions like this; Shewchuk, 1997, the signs of determinants). So a ray that just misses misses. A few
/// rays of a thousand need the closer look.
///
/// Of float, t is the exact one, correctly rounded: the last bit may be in doubt as well. Of double, t is what the
/// formula finds in strict_double, as long as it is known which crossings there are and on which side of the origin
/// they lie: of a crossing that is not known so well, and of those behind one that may not exist, t is what
/// double_double finds. Nothing of that depends on the window, or on what is asked, so that t does not either.

namespace raio::inline RAIO_ABI {

namespace detail {

/// Is there a quicker precision?
template <real T>
inline constexpr bool works_first = !std::same_as<working_t<T>, exact_t<T>>;

/// The crossings in order along the line, whether they exist or not.
template <class W>
RAIO_FN constexpr std::array<crossing<W>, 1> in_order(const crossing<W>& c) {
    return {c};
}
template <class W>
RAIO_FN constexpr std::array<crossing<W>, 2> in_order(const chord<W>& c) {
    return {c.near, c.far};
}
template <class W>
RAIO_FN constexpr std::array<crossing<W>, 4> in_order(const chord_pair<W>& c) {
    return {c.first.near, c.first.far, c.second.near, c.second.far};
}

/// Are these all, whatever the rounding errors were?
template <class Found>
RAIO_FN constexpr bool are_all(const Found&) {
    return true;
}

/// Calls `visit` with the crossings of one number each, in order, until it answers true: the quick ones that are known,
/// and the exact ones in the place of the others.
/// \param exact  answers with them, to be asked only then
template <real T, class Quick, class Exact, class Visit>
RAIO_FN constexpr bool visit_recorded(const Quick& quick, Exact exact, Visit visit) {
    const auto& first = in_order(quick);
    const auto size = first.end() - first.begin();
    bool same = are_all(quick);  // Is what stands in one place in both lists the same crossing?
    std::ptrdiff_t i = 0;
    for (; same && i < size && is_known<T>(first.begin()[i]); ++i) {
        if (visit(first.begin()[i])) return true;
    }
    if (same && i == size) return false;
    const auto found_closer = exact();
    const auto& closer = in_order(found_closer);
    const auto count = closer.end() - closer.begin();
    for (; i < count || (same && i < size); ++i) {
        const bool exists = i < count && closer.begin()[i].exists;
        same = same && i < size && first.begin()[i].certain;
        // If a quick crossing is certain all the same, the exact one has overflowed: numbers near the end of the range.
        if (same && (is_known<T>(first.begin()[i]) || (first.begin()[i].exists && !exists))) {
            if (visit(first.begin()[i])) return true;
        } else if (exists && visit(closer.begin()[i])) {
            return true;
        }
    }
    return false;
}

/// The same question, if the quick crossing has not answered it: the exact formula decides. Out of line, and without
/// what is known already: where this is rare, it must not cost the common case its registers.
template <real T, class Shape, class Origin, class Then>
RAIO_RARELY RAIO_FN constexpr mask_t<T> settle_closer(const Shape& shape, const Origin& origin, T t_min, T t_max,
                                                      Then then) {
    const auto& ray = made_of(origin);
    using W = working_t<T>;
    using X = exact_t<T>;
    if constexpr (works_first<T> && keeps_all_digits<T>) {
        bool met = false;
        visit_recorded<T>(
            crossings_for<W, question::where>(shape, ray, t_min, t_max),
            [&] { return crossings_for<X, question::where>(shape, ray, t_min, t_max); },
            [&](const auto& c) {
                auto first = first_in_window(c, t_min, t_max);
                if (!first.exists) return false;
                met = then(ray, first);
                return true;
            });
        return met;
    } else {
        return then(ray, first_in_window(crossings_for<X, question::where>(shape, ray, t_min, t_max), t_min, t_max));
    }
}

/// A shape that knows of most rays that they miss, sooner than it finds crossings.
template <class Shape, class Ray>
concept is_often_passed = std::floating_point<typename Shape::number> && requires(const Shape& shape, const Ray& ray) {
    shape.is_passed_by(ray);
};

/// Is that known of this ray?
template <class Shape, class Ray>
RAIO_FN constexpr bool is_passed([[maybe_unused]] const Shape& shape, [[maybe_unused]] const Ray& ray) {
    if constexpr (is_often_passed<Shape, Ray>) {
        keep_as_stored<typename Shape::number>(shape, ray);
        return shape.is_passed_by(ray);
    } else {
        return false;
    }
}

/// Finds the first crossing in the window, in the precision that it takes, and returns what `then` makes of it.
template <question Asked, real T, class Shape, class Ray, class Then>
RAIO_FORMULA constexpr mask_t<T> settle(const Shape& shape, const Ray& ray, T t_min, T t_max, Then then) {
    if constexpr (Asked == question::whether) {
        if (is_passed(shape, ray)) return mask_t<T>(false);
    }
    if constexpr (works_first<T>) {
        keep_as_stored<T>(shape, unmapped(ray));
        auto found = crossings_for<working_t<T>, Asked>(shape, ray, t_min, t_max);
        if (missed(found)) return mask_t<T>(false);
        auto [first, known] = settled_in_window<Asked>(found, t_min, t_max);
        if (known) [[likely]]
            return then(ray, first);
    }
    return settle_closer(shape, origin_of(ray), t_min, t_max, then);
}

/// The same in a function of its own: a ray that is known to miss costs no call, and no registers that only a hit
/// needs.
template <question Asked, real T, class Shape, class Ray, class Then>
[[gnu::noinline]] RAIO_NO_SLP RAIO_FLATTEN RAIO_FN constexpr mask_t<T> settle_apart(const Shape& shape, const Ray& ray,
                                                                                    T t_min, T t_max, Then then) {
    return settle<Asked>(shape, ray, t_min, t_max, then);
}

}  // namespace detail

/// `occluded` of every shape that has `crossings(line)`, a crossing or a chord: is there one with t in [t_min,
/// t_max]?
template <real T, class Shape, class Ray>
RAIO_FLATTEN RAIO_FN constexpr mask_t<T> any_hit(const Shape& shape, const Ray& ray, T t_min, T t_max) {
    return detail::settle<detail::question::whether>(shape, ray, t_min, t_max,
                                                     [](const auto&, const auto& crossing) { return crossing.exists; });
}

/// `hit` of every shape that has also `surface(at)`: the same crossing, and what to record of it.
/// \tparam Asked  `only_where` if there is one beyond doubt
template <detail::question Asked = detail::question::where, real T, class Shape, class Ray, record Record>
RAIO_FLATTEN RAIO_FN constexpr mask_t<T> first_hit(const Shape& shape, const Ray& ray, T t_min, T t_max, Record& rec) {
    const auto record = [&](const auto& same_ray, const auto& crossing) {
        if (crossing.exists) detail::record_crossing(shape, same_ray, crossing, rec);
        return crossing.exists;
    };
    if constexpr (detail::is_mapped<Ray>) {  // in what maps the ray, which can stay in registers
        return detail::settle<Asked>(shape, ray, t_min, t_max, record);
    } else {
        if (Asked == detail::question::where && detail::is_passed(shape, ray)) return mask_t<T>(false);
        return detail::settle_apart<Asked>(shape, ray, t_min, t_max, record);
    }
}

namespace detail {

template <real T, class Near, class Far>
RAIO_FN constexpr interval<T> between_ends(const Near& near, const Far& far) {
    const mask_t<T> meets = some(near.exists, far.exists);  // an end out of T's range is still an end
    return interval<T>{select(meets, T(near.t), infinity<T>), select(meets, T(far.t), -infinity<T>)};
}

/// A solid that has no end in some direction. It says which part of the line is `inside`, which may be all of it, or
/// all from some point on.
template <class Shape, class Line>
concept is_endless = requires(const Shape& shape, const Line& line) {
    shape.inside(line);
};

/// The crossings of a solid, also those whose point no number can say.
template <class Shape, class Line>
RAIO_FORMULA constexpr auto every_end(const Shape& shape, const Line& line) {
    if constexpr (is_endless<Shape, Line>) {
        using W = typename Line::number;
        auto c = shape.inside(line);
        const bound_t<W> speed = most_of(line.direction());
        const mask_t<W> is_line = every(speed > bound_t<W>(0), is_finite(speed), is_finite(most_of(line.origin())));
        keep_if(some(is_finite(c.near.t), is_finite(c.far.t), is_line), c);
        return c;
    } else {
        return shape.crossings(line);
    }
}

/// Is it beyond doubt what is recorded of an end?
template <class Shape, real T, class W>
RAIO_FN constexpr bool is_known_end(const crossing<W>& c) {
    if constexpr (is_endless<Shape, mapped_line<W>>) {
        if (c.certain && !is_finite(c.t) && c.error == bound_t<W>(0)) return true;
    }
    if constexpr (keeps_all_digits<T>) {
        return is_known<T>(c);
    } else {
        return c.certain && rounds_to_one<T>(c);
    }
}

/// Where the line is inside a convex solid, if the quick crossings have not answered it. Out of line, as
/// `settle_closer` is.
template <class Shape, class Origin, real T = typename Shape::number>
RAIO_RARELY RAIO_FN constexpr interval<T> inside_closer(const Shape& shape, const Origin& origin) {
    const auto& ray = made_of(origin);
    const auto exact = every_end(shape, line_in<exact_t<T>>(ray));
    if constexpr (keeps_all_digits<T>) {  // the same that `visit_recorded` finds
        const auto quick = every_end(shape, line_in<working_t<T>>(ray));
        const auto is_quick = [](const auto& end, const auto& closer) {
            return is_known_end<Shape, T>(end) || (end.certain && end.exists && !closer.exists);
        };
        const bool near = is_quick(quick.near, exact.near), far = quick.near.certain && is_quick(quick.far, exact.far);
        if (near && far) return between_ends<T>(quick.near, quick.far);
        if (near) return between_ends<T>(quick.near, exact.far);
        if (far) return between_ends<T>(exact.near, quick.far);
    }
    return between_ends<T>(exact.near, exact.far);
}

/// Where the line is inside a convex solid, in a function of its own.
template <class Shape, class Ray, real T = typename Shape::number>
[[gnu::noinline]] RAIO_NO_SLP RAIO_FLATTEN RAIO_FN constexpr interval<T> inside_apart(const Shape& shape,
                                                                                      const Ray& ray) {
    if constexpr (works_first<T>) {
        keep_as_stored<T>(shape, unmapped(ray));
        auto [near, far] = every_end(shape, line_in<working_t<T>>(ray));
        const bool missed = every(!near.exists, !far.exists, near.certain, far.certain);
        if (missed || every(is_known_end<Shape, T>(near), is_known_end<Shape, T>(far))) [[likely]]
            return between_ends<T>(near, far);
        return inside_closer(shape, origin_of(ray));
    } else {
        const auto exact = every_end(shape, line_in<exact_t<T>>(ray));
        return between_ends<T>(exact.near, exact.far);
    }
}

}  // namespace detail

/// Where the line is inside a solid whose crossings these are.
template <real T, class W>
RAIO_FN constexpr interval<T> spans_between(const chord<W>& c) {
    return detail::between_ends<T>(c.near, c.far);
}

/// Where the line is inside a convex solid; empty where it misses. Both ends are what a hit records for t,
/// or infinite where the solid has no end.
template <class Shape, class Ray>
RAIO_FN constexpr auto inside_of(const Shape& shape, const Ray& ray) {
    if (detail::is_passed(shape, ray)) return interval<typename Shape::number>{};
    return detail::inside_apart(shape, ray);
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
