#pragma once

#include <raio/push_macros.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <raio/number/bounded_vector.hpp>

/// \file
/// Polynomials, their sums and products, the errors of their coefficients carried along; and vectors of them.

namespace raio::inline RAIO_ABI {

namespace detail {

/// Calls f with 0, 1, ..., Count - 1 as constants: GCC keeps in memory what a loop goes through.
template <std::size_t Count, class F>
[[gnu::always_inline]] RAIO_FN constexpr void for_each_index(F f) {
    [&]<std::size_t... I>(std::index_sequence<I...>) { (f(std::integral_constant<std::size_t, I>()), ...); }
    (std::make_index_sequence<Count>());
}

}  // namespace detail

/// coefficient[0] + coefficient[1] t + ... + coefficient[N] t^N. Any coefficient may be zero, the last one as well.
template <real W, std::size_t N>
struct polynomial {
    std::array<W, N + 1> coefficient{};
    std::array<bound_t<W>, N + 1> error{};  ///< how far each coefficient may be off

    RAIO_FN constexpr bounded_number<W> operator[](std::size_t k) const { return {coefficient[k], error[k]}; }

    /// Even and odd powers are added up side by side: each sum waits for itself alone.
    RAIO_FN constexpr W operator()(const W& t) const {
        const auto sum_from = [&](std::size_t k, const W& square) {
            W sum = coefficient[k];
            for (; k >= 2; k -= 2) sum = sum * square + coefficient[k - 2];
            return sum;
        };
        if constexpr (N == 0) {
            return coefficient[0];
        } else {
            const W square = t * t;
            return sum_from(N - N % 2, square) + sum_from(N - 1 + N % 2, square) * t;
        }
    }

    /// The value at a place that is itself known up to an error: no steeper than the slope there, and what that
    /// changes.
    RAIO_FN constexpr bounded_number<W> operator()(const bounded_number<W>& t) const {
        using E = bound_t<W>;
        const auto slope = derivative();
        E place = size_of(t) + t.error;
        E steepest = abs(E(slope(t.value))) + slope.noise()(place) + t.error * slope.derivative().magnitude(place);
        return {(*this)(t.value), noise()(place) + t.error * steepest};
    }

    /// Of a constant it is the constant 0.
    RAIO_FN constexpr polynomial<W, N - (N > 0)> derivative() const {
        using E = bound_t<W>;
        polynomial<W, N - (N > 0)> d;
        for (std::size_t k = 1; k <= N; ++k) {
            d.coefficient[k - 1] = W(static_cast<int>(k)) * coefficient[k];
            d.error[k - 1] = E(static_cast<int>(k)) * (error[k] + E(unit_roundoff<W>) * E(abs(coefficient[k])));
        }
        return d;
    }

    /// The largest magnitude between 0 and t, or a larger one.
    RAIO_FN constexpr bound_t<W> magnitude(const bound_t<W>& t) const {
        bound_t<W> sum(0);
        for (std::size_t k = N + 1; k-- > 0;) sum = sum * t + (abs(bound_t<W>(coefficient[k])) + error[k]);
        return sum;
    }

    /// The polynomial whose value at |t| bounds the error of the value at t: that of the coefficients, and 2 N + 2
    /// roundings of each term. (By Horner's rule in t^2 it has 3 N / 2, and 2 more are those of the odd sum; Higham,
    /// Accuracy and Stability of Numerical Algorithms, 5.1.) And what products too small for their digits have lost.
    ///
    /// The bound is itself rounded, less than 2 N + 5 times here, and so were the errors it is made of, some fifty
    /// times in a product of products: of 128 roundings there is room for those.
    RAIO_FN constexpr polynomial<bound_t<W>, N> noise() const {
        using E = bound_t<W>;
        const E rounded_up(1 + 128 * unit_roundoff<E>);
        polynomial<E, N> bound{{E(least_normal<W>)}};
        for (std::size_t k = 0; k <= N; ++k) {
            bound.coefficient[k] +=
                (error[k] + E((2 * N + 2) * unit_roundoff<W>) * E(abs(coefficient[k]))) * rounded_up;
        }
        return bound;
    }
};

/// The polynomial of these coefficients, the constant one first.
template <class W, std::same_as<bounded_number<W>>... More>
RAIO_FN constexpr polynomial<W, sizeof...(More)> polynomial_of(const bounded_number<W>& constant, const More&... more) {
    return {{constant.value, more.value...}, {constant.error, more.error...}};
}
template <proven_number Constant, proven_number... More>
RAIO_FN constexpr auto polynomial_of(const Constant& constant, const More&... more) {
    using bounded = bounded_number<typename Constant::number>;
    return polynomial_of(bounded(constant), bounded(more)...);
}

template <real W, std::size_t N, std::size_t M>
RAIO_FN constexpr polynomial<W, (N < M ? M : N)> operator+(const polynomial<W, N>& a, const polynomial<W, M>& b) {
    using E = bound_t<W>;
    if constexpr (N < M) {
        return b + a;
    } else {
        polynomial<W, N> sum = a;
        detail::for_each_index<M + 1>([&](auto k) {
            sum.coefficient[k] = a.coefficient[k] + b.coefficient[k];
            // Twice the roundoff: that of a sum of two doubles is of the size of its operands.
            E size = max(abs(E(a.coefficient[k])), abs(E(b.coefficient[k])));
            sum.error[k] = a.error[k] + b.error[k] + E(2 * unit_roundoff<W>) * size;
        });
        return sum;
    }
}

template <real W, std::size_t N>
RAIO_FN constexpr polynomial<W, N> operator-(const polynomial<W, N>& a) {
    polynomial<W, N> minus = a;
    detail::for_each_index<N + 1>([&](auto k) { minus.coefficient[k] = -a.coefficient[k]; });
    return minus;
}
template <real W, std::size_t N, std::size_t M>
RAIO_FN constexpr polynomial<W, (N < M ? M : N)> operator-(const polynomial<W, N>& a, const polynomial<W, M>& b) {
    return a + -b;
}

/// Has it one sign from 0 to 1, beyond doubt? It has where the coefficients of its Bernstein form have one.
template <real W>
RAIO_FN constexpr bool has_one_sign(const polynomial<W, 2>& p) {
    using E = bound_t<W>;
    const auto& c = p.coefficient;
    E start(c[0]), middle(c[0] + c[1] * W(0.5)), end(c[0] + c[1] + c[2]);
    E size = abs(E(c[0])) + abs(E(c[1])) + abs(E(c[2]));
    E error = p.error[0] + p.error[1] + p.error[2] + E(4 * unit_roundoff<W>) * size;
    return min(min(start, middle), end) > error || max(max(start, middle), end) < -error;
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
    const E rounding((2 + 2 * (N < M ? N : M)) * unit_roundoff<W>);
    polynomial<W, K> p;
    if constexpr (N + M <= 4 && K <= 4) {
        detail::for_each_index<N + 1>([&](auto i) {
            E size = abs(E(a.coefficient[i])), error = a.error[i];
            detail::for_each_index<M + 1>([&](auto j) {
                if constexpr (i + j <= K) {
                    E other = abs(E(b.coefficient[j])), other_error = b.error[j];
                    p.coefficient[i + j] += a.coefficient[i] * b.coefficient[j];
                    p.error[i + j] += error * (other + other_error) + size * (other_error + rounding * other);
                }
            });
        });
    } else {
        for (std::size_t i = 0; i <= N && i <= K; ++i) {
            E size = abs(E(a.coefficient[i])), error = a.error[i];
            if (size == E(0) && error == E(0)) continue;
            for (std::size_t j = 0; j <= M && i + j <= K; ++j) {
                E other = abs(E(b.coefficient[j])), other_error = b.error[j];
                p.coefficient[i + j] += a.coefficient[i] * b.coefficient[j];
                p.error[i + j] += error * (other + other_error) + size * (other_error + rounding * other);
            }
        }
    }
    return p;
}

template <real W, std::size_t N, std::size_t M>
RAIO_FN constexpr polynomial<W, N + M> operator*(const polynomial<W, N>& a, const polynomial<W, M>& b) {
    return product<N + M>(a, b);
}
/// The same with half of the products.
template <real W, std::size_t N>
RAIO_FN constexpr polynomial<W, 2 * N> square(const polynomial<W, N>& a) {
    using E = bound_t<W>;
    const E rounding((2 + 2 * N) * unit_roundoff<W>);
    polynomial<W, 2 * N> p;
    detail::for_each_index<N + 1>([&](auto i) {
        const E size = abs(E(a.coefficient[i])), error = a.error[i];
        p.coefficient[2 * i] += a.coefficient[i] * a.coefficient[i];
        p.error[2 * i] += error * (E(2) * size + error) + size * size * rounding;
        const W twice = a.coefficient[i] + a.coefficient[i];
        detail::for_each_index<N - i>([&](auto beyond) {
            constexpr std::size_t j = i + 1 + beyond;
            const E other = abs(E(a.coefficient[j])), other_error = a.error[j];
            p.coefficient[i + j] += twice * a.coefficient[j];
            p.error[i + j] += E(2) * (error * (other + other_error) + size * (other_error + rounding * other));
        });
    });
    return p;
}

// With numbers.
template <real W, std::size_t N, proven_number A>
RAIO_FN constexpr polynomial<W, N> operator+(const polynomial<W, N>& p, const A& a) {
    return p + polynomial_of(a);
}
template <real W, std::size_t N, proven_number A>
RAIO_FN constexpr polynomial<W, N> operator-(const polynomial<W, N>& p, const A& a) {
    return p + -a;
}
template <real W, std::size_t N, proven_number A>
RAIO_FN constexpr polynomial<W, N> operator-(const A& a, const polynomial<W, N>& p) {
    return -p + a;
}
template <real W, std::size_t N, proven_number A>
RAIO_FN constexpr polynomial<W, N> operator*(const polynomial<W, N>& p, const A& a) {
    using E = bound_t<W>;
    const bounded_number<W> factor = a;
    const E size = size_of(factor), most = size + factor.error, less = factor.error + E(2 * unit_roundoff<W>) * size;
    polynomial<W, N> scaled;
    for (std::size_t k = 0; k <= N; ++k) {
        scaled.coefficient[k] = p.coefficient[k] * factor.value;
        scaled.error[k] = p.error[k] * most + abs(E(p.coefficient[k])) * less;
    }
    return scaled;
}

/// A vector whose components are polynomials: with those of degree 1, a point on its way along a line.
template <real W, std::size_t N>
using polynomial_vector = std::array<polynomial<W, N>, 3>;

template <real W, std::size_t N, proven_vector V>
RAIO_FN constexpr polynomial_vector<W, N> operator+(const polynomial_vector<W, N>& p, const V& v) {
    return {p[0] + v[0], p[1] + v[1], p[2] + v[2]};
}
template <real W, std::size_t N, proven_vector V>
RAIO_FN constexpr polynomial_vector<W, N> operator-(const polynomial_vector<W, N>& p, const V& v) {
    return p + -v;
}
template <real W, std::size_t N, proven_number A>
RAIO_FN constexpr polynomial_vector<W, N> operator*(const polynomial_vector<W, N>& p, const A& a) {
    return {p[0] * a, p[1] * a, p[2] * a};
}
template <real W, std::size_t N, proven_vector V>
RAIO_FN constexpr polynomial<W, N> dot(const polynomial_vector<W, N>& p, const V& v) {
    return p[0] * v[0] + p[1] * v[1] + p[2] * v[2];
}
template <real W, std::size_t N, proven_vector V>
RAIO_FN constexpr polynomial_vector<W, N> cross(const polynomial_vector<W, N>& p, const V& v) {
    return {p[1] * v[2] - p[2] * v[1], p[2] * v[0] - p[0] * v[2], p[0] * v[1] - p[1] * v[0]};
}
/// p.p
template <real W, std::size_t N>
RAIO_FN constexpr polynomial<W, 2 * N> square(const polynomial_vector<W, N>& p) {
    return square(p[0]) + square(p[1]) + square(p[2]);
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
