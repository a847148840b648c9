#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/vec.hpp>

namespace raio::inline RAIO_ABI {

/// The points `origin + t * direction`.
template <real T>
struct ray {
    vec3<T> origin;
    vec3<T> direction;  ///< need not be unit: t counts in lengths of it

    /// The point at t, rounded once or twice. (A record's `point` is found with more digits of t than `t` has, and its
    /// `error` says how far off it may be.)
    RAIO_FN constexpr vec3<T> at(const T& t) const {
        using W = wider_t<T>;
        return vec3<T>(sum_as<W>(origin, product_as<W>(direction, t)));
    }
};

/// A ray at a moment, for shapes that move. Whatever is derived from a ray goes as it is to shapes that have a template
/// `hit` of their own, through groups, trees, maps and CSG.
template <real T>
struct timed_ray : ray<T> {
    T time;
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
