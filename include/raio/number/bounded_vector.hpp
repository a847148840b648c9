#pragma once

#include <raio/push_macros.hpp>

#include <raio/number/choice.hpp>

/// \file
/// Vectors that know how far off they may be: one bound for all three components is what their products need.
///
/// The size of a vector is the sum of its components' magnitudes, and its error is the sum of theirs. With |a| and |b|
/// the sizes and da and db the errors, a.b and a x b are off by at most |a| db + |b| da + da db, and by the roundings
/// of their terms, which add up to at most |a| |b|.
///
/// (No vectors of GLM's: they may be unions, which GCC keeps in memory.)

namespace raio::inline RAIO_ABI {

/// A vector each of whose components has a relative error of at most K roundings. One that is given has none, K = 0.
template <class W, int K>
struct rounded_vector {
    using number = W;

    W x, y, z;

    RAIO_FN constexpr rounded_vector operator-() const { return {-x, -y, -z}; }
    RAIO_FN constexpr rounded_number<W, K> operator[](int axis) const { return {axis == 0 ? x : axis == 1 ? y : z}; }
};
template <class W>
using given_vector = rounded_vector<W, 0>;

/// A vector and a bound of its error.
template <class W>
struct bounded_vector {
    using number = W;

    W x, y, z;
    bound_t<W> error;

    RAIO_FN constexpr bounded_vector operator-() const { return {-x, -y, -z, error}; }
    RAIO_FN constexpr bounded_number<W> operator[](int axis) const {
        return {axis == 0 ? x : axis == 1 ? y : z, error};
    }
};

namespace detail {

template <class V>
inline constexpr bool is_proven_vector = false;
template <class W, int K>
inline constexpr bool is_proven_vector<rounded_vector<W, K>> = true;
template <class W>
inline constexpr bool is_proven_vector<bounded_vector<W>> = true;

/// a p + b q + ..., in the precision of W.
template <class W, class... More>
RAIO_FN constexpr W sum_of_products(const W& a, const W& p, const W& b, const W& q, const More&... more) {
    if constexpr (last_precision<W>) {
        return W::sum_of_products(a, p, b, q, more...);
    } else if constexpr (sizeof...(More) == 0) {
        return a * p + b * q;
    } else {
        return [](const W& two, const W& c, const W& r) { return two + c * r; }(a * p + b * q, more...);
    }
}

}  // namespace detail

/// A vector that knows how far off it may be.
template <class V>
concept proven_vector = detail::is_proven_vector<V>;

template <proven_vector V>
RAIO_FN constexpr auto size_of(const V& v) {
    using E = bound_t<typename V::number>;
    return abs(E(v.x)) + abs(E(v.y)) + abs(E(v.z));
}

namespace detail {

/// The terms of a.b added up as magnitudes.
template <class A, class B>
RAIO_FN constexpr auto size_of_terms(const A& a, const B& b) {
    using E = bound_t<typename A::number>;
    return abs(E(a.x) * E(b.x)) + abs(E(a.y) * E(b.y)) + abs(E(a.z) * E(b.z));
}

template <class W, int K>
RAIO_FN constexpr bound_t<W> error_of(const rounded_vector<W, K>& v) {
    return K == 0 ? bound_t<W>(0) : roundings<W>(K, size_of(v));
}
template <class W>
RAIO_FN constexpr bound_t<W> error_of(const bounded_vector<W>& v) {
    return v.error;
}

/// How many roundings its components have, of which its error does not tell.
template <class V>
inline constexpr int roundings_in = 0;
template <class W, int K>
inline constexpr int roundings_in<rounded_vector<W, K>> = K;

/// As large as the exact vector may be.
template <proven_vector V>
RAIO_FN constexpr auto most_of(const V& v) {
    return size_of(v) + error_of(v);
}

// What a product is off by that rounds its terms so many times.
template <class W, int K, int L>
RAIO_FN constexpr bound_t<W> error_of_product(int count, const rounded_vector<W, K>& a, const rounded_vector<W, L>& b) {
    return roundings<W>(K + L + count, size_of(a) * size_of(b));
}
template <class W, int K>
RAIO_FN constexpr bound_t<W> error_of_product(int count, const bounded_vector<W>& a, const rounded_vector<W, K>& b) {
    return (a.error + roundings<W>(K + count, size_of(a))) * size_of(b);
}
template <class W, int K>
RAIO_FN constexpr bound_t<W> error_of_product(int count, const rounded_vector<W, K>& a, const bounded_vector<W>& b) {
    return error_of_product(count, b, a);
}
template <class W>
RAIO_FN constexpr bound_t<W> error_of_product(int count, const bounded_vector<W>& a, const bounded_vector<W>& b) {
    return a.error * (size_of(b) + b.error) + size_of(a) * (b.error + roundings<W>(count, size_of(b)));
}

}  // namespace detail

template <proven_vector A, proven_vector B>
RAIO_FN constexpr auto dot(const A& a, const B& b) {
    using W = typename A::number;
    return bounded_number<W>{detail::sum_of_products(a.x, b.x, a.y, b.y, a.z, b.z), detail::error_of_product(3, a, b)};
}

template <class W, int K, int L>
RAIO_FN constexpr bounded_number<W> dot(const rounded_vector<W, K>& a, const rounded_vector<W, L>& b) {
    return {detail::sum_of_products(a.x, b.x, a.y, b.y, a.z, b.z),
            detail::roundings<W>(K + L + 3, detail::size_of_terms(a, b))};
}

template <proven_vector A, proven_vector B>
RAIO_FN constexpr auto cross(const A& a, const B& b) {
    using W = typename A::number;
    return bounded_vector<W>{detail::sum_of_products(a.y, b.z, -a.z, b.y), detail::sum_of_products(a.z, b.x, -a.x, b.z),
                             detail::sum_of_products(a.x, b.y, -a.y, b.x), detail::error_of_product(2, a, b)};
}

/// a.(b x c). Its bound counts only the terms that there are: a sliver along an axis has all its digits.
template <class W, int K, int L, int M>
RAIO_FN constexpr bounded_number<W> determinant(const rounded_vector<W, K>& a, const rounded_vector<W, L>& b,
                                                const rounded_vector<W, M>& c) {
    using E = bound_t<W>;
    const auto [x, y, z, error] = cross(b, c);
    const auto terms = [](const W& p, const W& q, const W& r, const W& s) { return abs(E(p * q)) + abs(E(r * s)); };
    E size = abs(E(a.x)) * terms(b.y, c.z, b.z, c.y) + abs(E(a.y)) * terms(b.z, c.x, b.x, c.z) +
             abs(E(a.z)) * terms(b.x, c.y, b.y, c.x);
    return {detail::sum_of_products(a.x, x, a.y, y, a.z, z), detail::roundings<W>(K + L + M + 5, size)};
}

template <proven_vector A, proven_vector B, proven_vector C>
RAIO_FN constexpr auto determinant(const A& a, const B& b, const C& c) {
    return dot(a, cross(b, c));
}

/// The last component.
template <class W, int K>
RAIO_FN constexpr rounded_number<W, K> z_of(const rounded_vector<W, K>& v) {
    return {v.z};
}
template <class W>
RAIO_FN constexpr bounded_number<W> z_of(const bounded_vector<W>& v) {
    return {v.z, v.error};
}

template <class W, int K>
RAIO_FN constexpr rounded_vector<W, K> vector_of(const rounded_number<W, K>& x, const rounded_number<W, K>& y,
                                                 const rounded_number<W, K>& z) {
    return {x.value, y.value, z.value};
}
template <class W>
RAIO_FN constexpr bounded_vector<W> vector_of(const bounded_number<W>& x, const bounded_number<W>& y,
                                              const bounded_number<W>& z) {
    return {x.value, y.value, z.value, x.error + y.error + z.error};
}

/// The sum of the components.
template <class W>
RAIO_FN constexpr bounded_number<W> sum_of(const bounded_vector<W>& v) {
    return {v.x + v.y + v.z, v.error + detail::roundings<W>(2, size_of(v))};
}

/// The last component of a x b.
template <class W>
RAIO_FN constexpr bounded_number<W> cross_z(const bounded_vector<W>& a, const bounded_vector<W>& b) {
    using E = bound_t<W>;
    E a_size = abs(E(a.x)) + abs(E(a.y)), b_size = abs(E(b.x)) + abs(E(b.y));
    return {detail::sum_of_products(a.x, b.y, -a.y, b.x),
            a.error * (b_size + b.error) + a_size * (b.error + detail::roundings<W>(2, b_size))};
}

/// Moves v across the last axis, by `slope` for each step along it.
template <class W, int K, int L>
RAIO_FN constexpr bounded_vector<W> shear(const rounded_vector<W, K>& v, const rounded_vector<W, L>& slope) {
    using E = bound_t<W>;
    E slopes = E(1) + abs(E(slope.x)) + abs(E(slope.y));
    return {v.x - slope.x * v.z, v.y - slope.y * v.z, v.z,
            detail::roundings<W>(K + L + 2, abs(E(v.x)) + abs(E(v.y)) + slopes * abs(E(v.z)))};
}
template <proven_vector V, proven_vector Slope>
RAIO_FN constexpr auto shear(const V& v, const Slope& slope) {
    using W = typename V::number;
    using E = bound_t<W>;
    const E z = abs(E(v.z)) + detail::error_of(v), slopes = abs(E(slope.x)) + abs(E(slope.y));
    const E rounding = detail::roundings<W>(2, size_of(v) + slopes * z);
    return bounded_vector<W>{v.x - slope.x * v.z, v.y - slope.y * v.z, v.z,
                             detail::error_of(v) * (E(1) + slopes) + detail::error_of(slope) * z + rounding};
}

/// p.M q, where the symmetric matrix M has these numbers on the diagonal, and half of those beside it: at yz, zx, xy.
template <class W, int K, proven_vector P, proven_vector Q>
RAIO_FN constexpr bounded_number<W> symmetric_product(const rounded_vector<W, K>& diagonal,
                                                      const rounded_vector<W, K>& beside, const P& p, const Q& q) {
    using E = bound_t<W>;
    const auto mixed = [](const W& p1, const W& q2, const W& p2, const W& q1) { return p1 * q2 + p2 * q1; };
    const W on_diagonal = detail::sum_of_products(diagonal.x, p.x * q.x, diagonal.y, p.y * q.y, diagonal.z, p.z * q.z);
    const W off_diagonal = detail::sum_of_products(beside.x, mixed(p.y, q.z, p.z, q.y), beside.y,
                                                   mixed(p.z, q.x, p.x, q.z), beside.z, mixed(p.x, q.y, p.y, q.x));
    const E p_error = detail::error_of(p), q_error = detail::error_of(q), p_size = size_of(p), q_size = size_of(q);
    const E terms = p_error * (q_size + q_error) + p_size * (q_error + detail::roundings<W>(K + 6, q_size));
    return {on_diagonal + off_diagonal * W(0.5), (size_of(diagonal) + size_of(beside)) * terms};
}

/// v.v
template <class W, int K>
RAIO_FN constexpr rounded_number<W, 2 * K + 3> square(const rounded_vector<W, K>& v) {
    return {detail::sum_of_products(v.x, v.x, v.y, v.y, v.z, v.z)};
}
template <class W>
RAIO_FN constexpr bounded_number<W> square(const bounded_vector<W>& v) {
    using E = bound_t<W>;
    W sum = detail::sum_of_products(v.x, v.x, v.y, v.y, v.z, v.z);
    return {sum, v.error * (E(2) * size_of(v) + v.error) + detail::roundings<W>(3, E(sum))};
}

/// |x| + |y| + |z|
template <class W>
RAIO_FN constexpr bounded_number<W> norm1(const bounded_vector<W>& v) {
    W size = abs(v.x) + abs(v.y) + abs(v.z);
    return {size, v.error + detail::roundings<W>(2, bound_t<W>(size))};
}

/// The s of a = s b, for two vectors of one direction. The signs of b stand for b: no product gets out of range.
template <class W>
RAIO_FN constexpr bounded_number<W> ratio(const bounded_vector<W>& a, const bounded_vector<W>& b) {
    W reach = flip(a.x, b.x) + flip(a.y, b.y) + flip(a.z, b.z);
    return bounded_number<W>(reach, a.error + detail::roundings<W>(2, size_of(a))) * inverse(norm1(b));
}

template <proven_vector A, proven_vector B>
RAIO_FN constexpr auto operator+(const A& a, const B& b) {
    using W = typename A::number;
    bounded_vector<W> sum{a.x + b.x, a.y + b.y, a.z + b.z, detail::error_of(a) + detail::error_of(b)};
    sum.error = sum.error + detail::error_of_sum<W>(size_of(sum), size_of(a), size_of(b));
    return sum;
}
template <proven_vector A, proven_vector B>
RAIO_FN constexpr auto operator-(const A& a, const B& b) {
    return a + -b;
}

/// Component by component.
template <class W, int K, int L>
RAIO_FN constexpr rounded_vector<W, K + L + 1> operator*(const rounded_vector<W, K>& a, const rounded_vector<W, L>& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <proven_vector A, proven_vector B>
RAIO_FN constexpr auto operator*(const A& a, const B& b) {
    using W = typename A::number;
    using E = bound_t<W>;
    const auto largest = [](const auto& v) { return max(max(abs(E(v.x)), abs(E(v.y))), abs(E(v.z))); };
    const E a_error = detail::error_of(a), b_error = detail::error_of(b);
    return bounded_vector<W>{
        a.x * b.x, a.y * b.y, a.z * b.z,
        largest(a) * b_error + (largest(b) + b_error) * a_error + detail::roundings<W>(1, detail::size_of_terms(a, b))};
}

template <class W, int K, int L>
RAIO_FN constexpr rounded_vector<W, K + L + 1> operator*(const rounded_vector<W, K>& v, const rounded_number<W, L>& s) {
    return {v.x * s.value, v.y * s.value, v.z * s.value};
}
template <proven_vector V, proven_number S>
RAIO_FN constexpr auto operator*(const V& v, const S& s) {
    using W = typename V::number;
    const bounded_number<W> factor = s;
    const bound_t<W> size = size_of(v), rounding = detail::roundings<W>(1, size * size_of(s));
    return bounded_vector<W>{v.x * s.value, v.y * s.value, v.z * s.value,
                             detail::error_of(v) * (size_of(s) + factor.error) + size * factor.error + rounding};
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
