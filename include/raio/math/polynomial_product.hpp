#pragma once

#include <raio/math/polynomial.hpp>

/// \file
/// Sums and products of polynomials, the errors of their coefficients carried along.

namespace raio {

template <real W, std::size_t N>
RAIO_FN constexpr polynomial<W, N> operator+(const polynomial<W, N>& a, const polynomial<W, N>& b) {
    using E = bound_t<W>;
    polynomial<W, N> sum;
    for (std::size_t k = 0; k <= N; ++k) {
        sum.coefficient[k] = a.coefficient[k] + b.coefficient[k];
        // Twice the roundoff: that of a sum of two doubles is of the size of its operands.
        E size = max(abs(E(a.coefficient[k])), abs(E(b.coefficient[k])));
        sum.error[k] = a.error[k] + b.error[k] + E(2 * unit_roundoff<W>) * size;
    }
    return sum;
}

template <real W, std::size_t N>
RAIO_FN constexpr polynomial<W, N> operator-(const polynomial<W, N>& a) {
    polynomial<W, N> minus = a;
    for (W& c : minus.coefficient) c = -c;
    return minus;
}
template <real W, std::size_t N>
RAIO_FN constexpr polynomial<W, N> operator-(const polynomial<W, N>& a, const polynomial<W, N>& b) {
    return a + -b;
}

/// A number that was computed with so many roundings.
template <real W>
RAIO_FN constexpr polynomial<W, 0> constant(const W& c, int roundings = 0) {
    using E = bound_t<W>;
    return {{c}, {E(roundings * unit_roundoff<W>) * abs(E(c))}};
}

/// The product up to the power K of t. Where the powers beyond it are zero, that is all of it.
template <std::size_t K, real W, std::size_t N, std::size_t M>
RAIO_FN constexpr polynomial<W, K> product(const polynomial<W, N>& a, const polynomial<W, M>& b) {
    using E = bound_t<W>;
    // Each term is rounded itself, and once more with each that is added; sums may double that (see above).
    E rounding((2 + 2 * (N < M ? N : M)) * unit_roundoff<W>);
    polynomial<W, K> p;
    for (std::size_t i = 0; i <= N && i <= K; ++i) {
        E size = abs(E(a.coefficient[i])), error = a.error[i];
        if (size == E(0) && error == E(0)) continue;
        for (std::size_t j = 0; j <= M && i + j <= K; ++j) {
            E other = abs(E(b.coefficient[j])), other_error = b.error[j];
            p.coefficient[i + j] += a.coefficient[i] * b.coefficient[j];
            p.error[i + j] += error * (other + other_error) + size * (other_error + rounding * other);
        }
    }
    return p;
}

}  // namespace raio
