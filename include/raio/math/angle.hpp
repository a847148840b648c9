#pragma once

#include <numbers>

#include <raio/math/real.hpp>

namespace raio {

template <class T>
inline const T pi = T(std::numbers::pi);
template <class T>
requires(std::is_trivially_copyable_v<T>) inline constexpr T pi<T> = T(std::numbers::pi);

namespace detail {

// The functions below choose by sign and not by a branch: the octant of a hit is as good as random, and a wrong guess
// would cost more than the whole computation.

/// The angle in turns of (x, y) in the first quadrant, from the x axis: in [0, 1/4]. Zero for (0, 0).
template <real T>
RAIO_FN constexpr T quadrant_turns(const T& y, const T& x) {
    if constexpr (std::same_as<scalar_t<T>, float>) {
        // atan(q) / (2 pi q) for q in [0, 1] as a polynomial in q^2 whose largest error is as small as it can be, 6e-9
        // of a turn. Evaluated in pairs (Estrin 1960): a chain of eight steps would take twice as long.
        T q = quotient(min(x, y), max(x, y), T(0)), q2 = q * q, q4 = q2 * q2, q8 = q4 * q4;
        T low = (T(0.159154837f) + T(-0.0530461210f) * q2) + (T(0.0317459454f) + T(-0.0221362721f) * q2) * q4;
        T high = (T(0.0153460353f) + T(-0.00889872527f) * q2) + (T(0.00347959913f) + T(-0.000645304744f) * q2) * q4;
        T turn = q * (low + high * q8);
        const T flat = copysign(T(1), x - y);
        return flat * turn + (T(0.125f) - flat * T(0.125f));
    } else {
        return atan2(y, x) * T(0.5 / std::numbers::pi);
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

}  // namespace raio
