#pragma once

#include <raio/push_macros.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <raio/number/double_double.hpp>
#include <raio/number/real.hpp>

/// \file
/// Vectors are GLM's. Only the functions that GLM reserves for the built-in numbers are written again, for every
/// `real`.

namespace raio::inline RAIO_ABI {

template <class T>
using vec2 = glm::vec<2, T, glm::defaultp>;
template <class T>
using vec3 = glm::vec<3, T, glm::defaultp>;

template <real T>
RAIO_FN constexpr T dot(const vec3<T>& a, const vec3<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class D>
RAIO_FN constexpr basic_double_double<D> dot(const vec3<basic_double_double<D>>& a,
                                             const vec3<basic_double_double<D>>& b) {
    return basic_double_double<D>::sum_of_products(a.x, b.x, a.y, b.y, a.z, b.z);
}

template <real T>
RAIO_FN constexpr vec3<T> cross(const vec3<T>& a, const vec3<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class D>
RAIO_FN constexpr vec3<basic_double_double<D>> cross(const vec3<basic_double_double<D>>& a,
                                                     const vec3<basic_double_double<D>>& b) {
    const auto minor = [](const auto& p, const auto& q, const auto& r, const auto& s) {
        return basic_double_double<D>::sum_of_products(p, q, -r, s);
    };
    return {minor(a.y, b.z, a.z, b.y), minor(a.z, b.x, a.x, b.z), minor(a.x, b.y, a.y, b.x)};
}

/// a + b, a - b and a s in the precision of W, as those of numbers.
template <class W, real A, real B>
RAIO_FN constexpr vec3<W> sum_as(const vec3<A>& a, const vec3<B>& b) {
    return {sum_as<W>(a.x, b.x), sum_as<W>(a.y, b.y), sum_as<W>(a.z, b.z)};
}
template <class W, real A, real B>
RAIO_FN constexpr vec3<W> difference_as(const vec3<A>& a, const vec3<B>& b) {
    return {difference_as<W>(a.x, b.x), difference_as<W>(a.y, b.y), difference_as<W>(a.z, b.z)};
}
template <class W, real A, real B>
RAIO_FN constexpr vec3<W> product_as(const vec3<A>& a, const B& s) {
    return {product_as<W>(a.x, s), product_as<W>(a.y, s), product_as<W>(a.z, s)};
}

template <real T>
RAIO_FN constexpr vec3<T> abs(const vec3<T>& a) {
    return {abs(a.x), abs(a.y), abs(a.z)};
}

/// Component by component.
template <real T>
RAIO_FN constexpr vec3<T> min(const vec3<T>& a, const vec3<T>& b) {
    return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)};
}
template <real T>
RAIO_FN constexpr vec3<T> max(const vec3<T>& a, const vec3<T>& b) {
    return {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)};
}

template <real T>
RAIO_FN constexpr mask_t<T> is_finite(const vec3<T>& a) {
    return every(is_finite(a.x), is_finite(a.y), is_finite(a.z));
}

/// Is one of the components no number?
template <real T>
RAIO_FN constexpr mask_t<T> is_nan(const vec3<T>& a) {
    return some(is_nan(a.x), is_nan(a.y), is_nan(a.z));
}

/// At least |a.(b x c)|, whatever the signs of the components: the terms of the triple product added up as magnitudes.
template <real T>
RAIO_FN constexpr T permanent(const vec3<T>& a, const vec3<T>& b, const vec3<T>& c) {
    vec3<T> p = abs(b), q = abs(c);
    return dot(abs(a), vec3<T>(p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x));
}

/// The component along one of the three axes.
template <real T, class Axis>
RAIO_FN constexpr T component(const vec3<T>& a, const Axis& axis) {
    if constexpr (std::integral<Axis>) {
        return a[static_cast<glm::length_t>(axis)];
    } else {
        return select(axis == Axis(0), a.x, select(axis == Axis(1), a.y, a.z));
    }
}

/// The sum of the components' magnitudes: never below the length, never above 1.74 times it, and free of roots.
template <real T>
RAIO_FN constexpr T norm1(const vec3<T>& a) {
    return abs(a.x) + abs(a.y) + abs(a.z);
}

template <real T>
RAIO_FN constexpr T length(const vec3<T>& a) {
    return sqrt(dot(a, a));
}

/// Is what is made of numbers From within the range of T, up to their eighth power? Of floats in double it is.
template <class From, class T>
inline constexpr bool has_room_for = is_believed<T> || std::numeric_limits<scalar_t<T>>::max_exponent / 8 >=
                                                           std::numeric_limits<scalar_t<From>>::max_exponent;

/// The vector itself, or, where its square would be out of range, the same times a power of two.
template <class From, real T>
RAIO_FN constexpr vec3<T> scaled_into_range(const vec3<T>& a) {
    if constexpr (has_room_for<From, T>) {
        return a;
    } else {
        using E = bound_t<T>;
        constexpr bool single = std::same_as<scalar_t<T>, float>;
        constexpr double large = single ? 0x1p50 : 0x1p500, shrink = single ? 0x1p-100 : 0x1p-600;
        E size = norm1(vec3<E>(a));
        const mask_t<T> fits = every(E(1 / large) <= size, size <= E(large));
        if (all(fits)) return a;
        return a * select(fits, T(1), select(size < E(1), T(1 / shrink), T(shrink)));
    }
}

/// The unit vector in the direction of `a`, which was made of numbers From and may have any length; not a number, if
/// that is zero.
template <class From, real T>
RAIO_FN constexpr vec3<T> normalize_from(const vec3<T>& a) {
    vec3<T> b = scaled_into_range<From>(a);
    return b * quotient(T(1), length(b), T(std::numeric_limits<scalar_t<T>>::quiet_NaN()));
}

template <real T>
RAIO_FN constexpr vec3<T> normalize(const vec3<T>& a) {
    return normalize_from<T>(a);
}

template <class Mask, class T>
RAIO_FN constexpr vec3<T> select(Mask mask, const vec3<T>& a, const vec3<T>& b) {
    return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}
template <class Mask, class T>
RAIO_FN constexpr vec3<T> choose(const Mask& mask, const vec3<T>& a, const vec3<T>& b) {
    return {choose(mask, a.x, b.x), choose(mask, a.y, b.y), choose(mask, a.z, b.z)};
}
template <class Mask, class T>
RAIO_FN constexpr vec2<T> select(Mask mask, const vec2<T>& a, const vec2<T>& b) {
    return {select(mask, a.x, b.x), select(mask, a.y, b.y)};
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
