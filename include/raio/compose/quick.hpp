#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/proof/mapped_ray.hpp>
#include <raio/surface_sample.hpp>

namespace raio::inline RAIO_ABI {

namespace detail {

/// A shape with a formula, which takes a line in any numbers. (What is composed of shapes has none.)
template <class P>
concept has_plain_formula = primitive<P> && requires(const P shape, const ray<number_t<P>> ray) {
    shape.crossings(line_in<plain<number_t<P>>>(ray));
};

/// The first crossing in the window as T finds it itself; `exists` says whether there is one.
template <question Asked, class Shape, class Ray, real T>
RAIO_FORMULA constexpr crossing<plain<T>> first_crossing(const Shape& shape, const Ray& ray, T t_min, T t_max) {
    return first_in_window(crossings_for<plain<T>, Asked>(shape, ray, t_min, t_max), t_min, t_max);
}

/// Of two crossings the one that is nearer to t, or that exists.
template <class W>
RAIO_FN constexpr crossing<W> nearer(const W& t, const crossing<W>& a, const crossing<W>& b) {
    return select(every(b.exists, some(!a.exists, abs(b.t - t) < abs(a.t - t))), b, a);
}

/// Of all that were found the nearest to t.
template <class W, class Found>
RAIO_FN constexpr crossing<W> nearest_to(const W& t, const Found& found) {
    auto nearest = no_crossing<W>();
    for (const crossing<W>& c : in_order(found)) nearest = nearer(t, nearest, c);
    return nearest;
}
template <class W>
RAIO_FN constexpr crossing<W> nearest_to(const W& t, const chord<W>& c) {  // not through memory, as a list goes
    return nearer(t, c.near, c.far);
}

/// The crossing at t, which has been found before: the nearest to it, should other instructions have rounded t
/// otherwise.
template <class Shape, class Ray, real T>
RAIO_FORMULA constexpr crossing<plain<T>> crossing_again(const Shape& shape, const Ray& ray, const T& t) {
    using W = plain<T>;
    auto known = no_crossing<W>();
    if constexpr (finds_known_crossing<Shape, W, Ray>) {
        known = shape.crossings(line_in<W>(ray), known_crossing{});
    } else {
        known = nearest_to(W(t), shape.crossings(line_in<W>(ray)));
    }
    known.t = W(t);
    return known;
}

}  // namespace detail

/// A shape whose formula is computed once, in its own number, and believed: as fast as a textbook's, and as exact. It
/// is the formula by which the shape proves its answers otherwise, and a shape that goes wherever others go:
///
///     raio::quick<raio::sphere<float>> ball{{{0, 0, -1}, 0.5f}};
///     raio::bvh<raio::quick<raio::triangle<float>>> tree(mesh);
///
/// t, the point and the normal are off by some roundings of T, by more where the ray comes from far away. A ray close
/// to an edge, a rim or a tangent may hit or miss, and one that starts on the surface may hit it again close to t = 0.
/// `error` is a bound of the roundings on the way to the point, so `spawn_ray` leaves the surface as it does otherwise.
///
/// What is composed of shapes is made of quick ones: `transformed<quick<P>>`, a `group` of them.
template <detail::has_plain_formula P>
struct quick : P {
    using number = number_t<P>;
    using T = number;
    using shape = P;

    template <ray_of<T> Ray = raio::ray<T>, record Record>
    RAIO_FLATTEN RAIO_FN constexpr mask_t<T> hit(const Ray& ray, T t_min, T t_max, Record& rec) const {
        if constexpr (detail::is_often_passed<P, Ray>) {  // most rays miss, and cost no call
            return hit_here(ray, t_min, t_max, rec);
        } else {
            return hit_apart(ray, t_min, t_max, rec);
        }
    }

    template <ray_of<T> Ray = raio::ray<T>>
    RAIO_FLATTEN RAIO_FN constexpr mask_t<T> occluded(const Ray& ray, T t_min, T t_max) const {
        return detail::first_crossing<detail::question::whether>(*this, ray, t_min, t_max).exists;
    }

    template <ray_of<T> Ray = raio::ray<T>>
    RAIO_FLATTEN RAIO_FN constexpr auto spans(const Ray& ray) const requires(solid<P>) {
        return spans_between<T>(detail::every_end(*this, line_in<plain<T>>(ray)));
    }

    /// Records the crossing at t, which has been found before.
    template <ray_of<T> Ray, record Record>
    RAIO_NO_SLP RAIO_FLATTEN RAIO_FN constexpr void record_at(const Ray& ray, T t, Record& rec) const {
        auto known = detail::crossing_again<P>(*this, ray, t);
        detail::record_crossing(*this, ray, known, rec);
    }

private:
    template <class Ray, class Record>
    RAIO_FLATTEN RAIO_FN constexpr mask_t<T> hit_here(const Ray& ray, T t_min, T t_max, Record& rec) const {
        auto first = detail::first_crossing<detail::question::where>(*this, ray, t_min, t_max);
        if constexpr (detail::has_lanes<T>) {
            if (none(first.exists)) return first.exists;
            Record candidate;
            detail::record_crossing(*this, ray, first, candidate);
            assign(first.exists, rec, candidate);
        } else if (first.exists) {
            detail::record_crossing(*this, ray, first, rec);
        }
        return first.exists;
    }

    template <class Ray, class Record>
    RAIO_NO_SLP RAIO_FLATTEN RAIO_FN constexpr mask_t<T> hit_apart(const Ray& ray, T t_min, T t_max,
                                                                   Record& rec) const {
        return hit_here(ray, t_min, t_max, rec);
    }
};

template <detail::has_plain_formula P>
quick(P) -> quick<P>;

namespace detail {

template <class P>
inline constexpr bool is_quick = false;
template <class P>
inline constexpr bool is_quick<quick<P>> = true;

template <class P, class U>
requires requires { typename rebind<P, U>::type; }
struct rebind<quick<P>, U> {
    using type = quick<rebind_t<P, U>>;
};

}  // namespace detail

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
