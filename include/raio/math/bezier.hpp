#pragma once

#include <raio/math/polynomial.hpp>

namespace raio {

/// A cubic Bezier curve, (1 - u)^3 v0 + 3 (1 - u)^2 u v1 + 3 (1 - u) u^2 v2 + u^3 v3, less v0, as a polynomial in u.
///
/// With the sizes of the three differences added up, the middle one twice, a coefficient is off by up to three
/// roundings of three times that: by less than 16.
template <real W, real T>
RAIO_FN constexpr polynomial<W, 3> bezier_polynomial(const T& v0, const T& v1, const T& v2, const T& v3) {
    using E = bound_t<W>;
    W first = W(v1) - W(v0), second = W(v2) - W(v1), third = W(v3) - W(v2);
    E size = abs(E(first)) + E(2) * abs(E(second)) + abs(E(third)), error = E(16 * unit_roundoff<W>) * size;
    return {{W(0), W(3) * first, W(3) * (second - first), (third - second) - (second - first)},
            {E(0), error, error, error}};
}

}  // namespace raio
