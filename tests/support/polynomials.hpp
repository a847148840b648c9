#pragma once

#include <array>

#include <raio/math/polynomial.hpp>

#include "support/oracle.hpp"
#include "support/random.hpp"

/// \file
/// Polynomials whose coefficients are known up to an error, each with the exact one that it stands for.

namespace raio::test {

/// The W nearest to x, or the next.
template <class W>
W nearest(const oracle& x) {
    const double high = rounded<double>(x);
    if constexpr (std::same_as<W, double_double>) {
        return double_double(high) + double_double(rounded<double>(x - oracle(high)));
    } else {
        return W(high);
    }
}

/// A number of W that stands for x: off by a rounding, and said to be.
template <class W>
bounded_number<W> number_for(const oracle& x) {
    const W value = nearest<W>(x);
    return {value, bound_t<W>(2 * unit_roundoff<W>) * abs(bound_t<W>(value))};
}

template <class W, std::size_t N>
struct known_polynomial {
    polynomial<W, N> number;
    std::array<oracle, N + 1> exact;

    static polynomial<W, N> number_for(const std::array<oracle, N + 1>& exact) {
        polynomial<W, N> p;
        for (std::size_t k = 0; k <= N; ++k) {
            const bounded_number<W> c = test::number_for<W>(exact[k]);
            p.coefficient[k] = c.value, p.error[k] = c.error;
        }
        return p;
    }

    /// With coefficients between -1 and 1.
    static known_polynomial any(random_numbers& random) {
        std::array<oracle, N + 1> exact;
        for (oracle& c : exact) c = oracle(random.uniform(-1, 1)) + oracle(random.uniform(-0x1p-54, 0x1p-54)) / 3;
        return {number_for(exact), exact};
    }

    /// The one that has these roots, times a factor.
    static known_polynomial with_roots(const std::array<oracle, N>& roots, const oracle& factor) {
        std::array<oracle, N + 1> exact{factor};
        for (std::size_t n = 0; n < N; ++n) {
            for (std::size_t k = n + 1; k > 0; --k) exact[k] = exact[k - 1] - exact[k] * roots[n];
            exact[0] = -exact[0] * roots[n];
        }
        return {number_for(exact), exact};
    }

    oracle operator()(const oracle& x) const {
        oracle sum(0);
        for (std::size_t k = N + 1; k-- > 0;) sum = sum * x + exact[k];
        return sum;
    }
    oracle derivative(const oracle& x) const {
        oracle sum(0);
        for (std::size_t k = N; k > 0; --k) sum = sum * x + exact[k] * oracle(static_cast<double>(k));
        return sum;
    }
};

}  // namespace raio::test
