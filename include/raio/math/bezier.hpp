#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/polynomial.hpp>

namespace raio::inline RAIO_ABI {

/// A cubic Bezier curve, (1 - u)^3 v0 + 3 (1 - u)^2 u v1 + 3 (1 - u) u^2 v2 + u^3 v3, as a polynomial in u.
///
/// With the sizes of the three differences added up, the middle one twice, a coefficient is off by up to three
/// roundings of three times that: by less than 16. The first one is v0.
template <real W, real T>
RAIO_FN constexpr polynomial<W, 3> bezier_polynomial(const T& v0, const T& v1, const T& v2, const T& v3) {
    using E = bound_t<W>;
    W first = W(v1) - W(v0), second = W(v2) - W(v1), third = W(v3) - W(v2);
    E size = abs(E(first)) + E(2) * abs(E(second)) + abs(E(third)), error = E(16 * unit_roundoff<W>) * size;
    return {{W(v0), W(3) * first, W(3) * (second - first), (third - second) - (second - first)},
            {E(0), error, error, error}};
}

/// The same less v0: the curve as seen from its start.
template <real W, real T>
RAIO_FN constexpr polynomial<W, 3> bezier_from_start(const T& v0, const T& v1, const T& v2, const T& v3) {
    polynomial<W, 3> p = bezier_polynomial<W>(v0, v1, v2, v3);
    p.coefficient[0] = W(0);
    return p;
}

/// A polynomial and its first two derivatives at a place.
template <class W>
RAIO_FN constexpr std::array<W, 3> derivatives_at(const polynomial<W, 3>& p, const W& u) {
    const polynomial<W, 2> slope = p.derivative();
    return {p(u), slope(u), slope.derivative()(u)};
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
