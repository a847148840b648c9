#pragma once

#include <raio/push_macros.hpp>

#include <numbers>

#include <raio/math/frame.hpp>
#include <raio/number/real.hpp>

namespace raio::inline RAIO_ABI {

namespace detail {

// The functions below choose by sign and not by a branch: the octant of a hit is as good as random, and a wrong guess
// would cost more than the whole computation.

/// atan(low / high) in turns for 0 <= low <= high: in [0, 1/8]. Zero for (0, 0).
///
/// atan(q) / (2 pi q) is a polynomial in q^2 whose largest error is as small as it can be: 6e-9 of a turn for floats,
/// 7e-18 for doubles, which also fold the upper half of the angles onto the lower one. Evaluated in pairs (Estrin
/// 1960): one step after the other would take twice as long.
template <real T>
RAIO_FN constexpr T eighth_turns(const T& low, const T& high) {
    if constexpr (std::same_as<scalar_t<T>, float>) {
        T q = quotient(low, high, T(0)), q2 = q * q, q4 = q2 * q2, q8 = q4 * q4;
        T p0 = (T(0.159154837f) + T(-0.0530461210f) * q2) + (T(0.0317459454f) + T(-0.0221362721f) * q2) * q4;
        T p1 = (T(0.0153460353f) + T(-0.00889872527f) * q2) + (T(0.00347959913f) + T(-0.000645304744f) * q2) * q4;
        return q * (p0 + p1 * q8);
    } else {
        const mask_t<T> upper = low > T(std::numbers::sqrt2 - 1) * high;  // tan(pi / 8)
        T q = quotient(choose(upper, low - high, low), choose(upper, low + high, high), T(0));
        T q2 = q * q, q4 = q2 * q2, q8 = q4 * q4;
        T p0 = (T(0.15915494309189532) + T(-0.053051647697290656) * q2) +
               (T(0.031830988616556921) + T(-0.022736420275003919) * q2) * q4;
        T p1 = (T(0.017683874718384725) + T(-0.014468414713824675) * q2) +
               (T(0.012238941110840396) + T(-0.01056826053314365) * q2) * q4;
        T p2 = (T(0.0090532889747961497) + T(-0.0069201400295294301) * q2) + T(0.0033637991121386406) * q4;
        return q * (p0 + (p1 + p2 * q8) * q8) + choose(upper, T(0.125), T(0));
    }
}

/// The angle in turns of (x, y) in the first quadrant, from the x axis: in [0, 1/4]. Zero for (0, 0).
template <real T>
RAIO_FN constexpr T quadrant_turns(const T& y, const T& x) {
    if constexpr (std::same_as<scalar_t<T>, float> || std::same_as<scalar_t<T>, double>) {
        T turn = eighth_turns(min(x, y), max(x, y));
        const T flat = copysign(T(1), x - y);
        return flat * turn + (T(0.125f) - flat * T(0.125f));
    } else {
        return max(T(0), min(T(0.25), atan2(y, x) * T(0.5 / std::numbers::pi)));  // whatever the roundings were
    }
}

}  // namespace detail

/// The angle from (1, 0) to (x, y), counter-clockwise, in turns: in [0, 1). Zero for (0, 0).
template <real T>
RAIO_FN constexpr T turns(const T& y, const T& x) {
    const T right = copysign(T(1), x), up = copysign(T(1), y);
    const T half = right * detail::quadrant_turns(abs(y), abs(x)) + (T(0.25) - right * T(0.25));
    const T turn = up * half + (T(0.5) - up * T(0.5));
    return select(turn < T(1), turn, T(0));  // a tiny negative angle rounds up to a full turn
}

/// uv about an axis: u is the angle of a vector about the z axis of a frame, from its x axis, in turns; v is what is
/// given, kept from 0 to 1.
template <real T, real Q>
RAIO_FN constexpr vec2<T> uv_about(const frame<Q>& f, const vec3<Q>& vector, const T& v) {
    return {turns(T(dot(vector, f.y)), T(dot(vector, f.x))), max(T(0), min(T(1), v))};
}

/// The latitude of a direction whose height over the equator is y and whose distance from the axis is rho: 0 straight
/// down, 1 straight up.
template <real T>
RAIO_FN constexpr T latitude(const T& y, const T& rho) {
    return T(0.5) + copysign(T(2) * detail::quadrant_turns(abs(y), rho), y);
}

/// What is left of x without its whole part: in [0, 1), and 0 for what has no fraction.
template <real T>
RAIO_FN constexpr T fraction(const T& x) {
    const T rest = x - floor(x);
    return select(rest < T(1), rest, T(0));
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
