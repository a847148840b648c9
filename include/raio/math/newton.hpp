#pragma once

#include <raio/push_macros.hpp>

#include <raio/number/real.hpp>

namespace raio::inline RAIO_ABI {

/// Where f is zero, which grows from `low` to `high` and changes its sign between them or is zero at an end: by
/// Newton's method, halved where it would leave what encloses the place.
/// \param x      a guess
/// \param slope  the derivative of f
template <std::floating_point T, class F, class Slope>
RAIO_FN constexpr T newton_between(T low, T high, T x, F f, Slope slope) {
    for (int i = 0; i < 64; ++i) {
        const T value = f(x), last = x;
        if (value == T(0)) break;
        (value > T(0) ? high : low) = x;
        const T next = x - quotient(value, slope(x), T(infinity<T>));
        x = low <= next && next <= high ? next : low + (high - low) / T(2);
        if (abs(x - last) <= T(2 * unit_roundoff<T>) * abs(x)) break;
    }
    return x;
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
