#pragma once

#include <raio/push_macros.hpp>

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <numbers>
#include <type_traits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <raio/config.hpp>

/// \file
/// What raio asks of a number. A shape is a template on its number type and on nothing else: `float`, `double`, a SIMD
/// pack, a dual number and a multiprecision number all go through the same source.
///
/// A new number type brings arithmetic and comparison operators, `sqrt`, `abs`, `floor`, `copysign` and `atan2` that
/// argument-dependent lookup finds, a `std::numeric_limits`, and, where the defaults do not fit, a `real_traits` of its
/// own.

namespace raio::inline RAIO_ABI {

class strict_double;
template <class D>
class basic_double_double;
using double_double = basic_double_double<strict_double>;

namespace detail {

/// A type that behaves like one number.
template <class T>
struct one_number {
    using scalar = T;             ///< the number in one lane
    using mask = bool;            ///< what a comparison answers
    using index = std::uint32_t;  ///< what counts the members of an aggregate
    using working = T;            ///< the precision that formulas are tried in first
    using exact = T;              ///< the precision that settles what the first one left open
    using bound = T;              ///< what is good enough to bound the errors of T with
};

}  // namespace detail

/// What a number type is made of.
template <class T>
struct real_traits : detail::one_number<T> {};

/// A product of two floats is exact in double: formulas are computed there and rounded to float once.
template <>
struct real_traits<float> : detail::one_number<float> {
    using working = strict_double;
    using exact = double_double;
};

/// Nothing in the hardware is wider than double: formulas are computed with two of them.
template <>
struct real_traits<double> : detail::one_number<double> {
    using working = strict_double;
    using exact = double_double;
};

template <class T>
using scalar_t = typename real_traits<T>::scalar;
template <class T>
using mask_t = typename real_traits<T>::mask;
template <class T>
using index_t = typename real_traits<T>::index;
template <class T>
using working_t = typename real_traits<T>::working;
template <class T>
using exact_t = typename real_traits<T>::exact;
template <class T>
using bound_t = typename real_traits<T>::bound;

/// Is it packs that only sieve? (Others go the same way as one number, bit for bit.)
template <class W>
inline constexpr bool only_sieves = !std::same_as<mask_t<W>, bool> && std::floating_point<scalar_t<W>>;

/// `if_true` where the mask is set, `if_false` elsewhere; a pack chooses lane by lane.
template <std::same_as<bool> Mask, class T>
RAIO_FN constexpr T select(Mask mask, T if_true, T if_false) {
    return mask ? if_true : if_false;
}

/// The same, and never by a branch: for what is as good as random, as the side of a triangle, or the face of a box. A
/// branch would be guessed wrong every other time, and that costs as much as a whole miss. A look-up is none.
template <class Mask, class T>
RAIO_FN constexpr T choose(Mask mask, std::type_identity_t<T> if_true, T if_false) {
#if !defined(__CUDA_ARCH__)  // where nothing is guessed
    if constexpr (std::same_as<Mask, bool> && std::is_trivially_copyable_v<T>) {
        const T either[] = {if_false, if_true};
        return either[static_cast<int>(mask)];
    }
#endif
    return select(mask, if_true, if_false);
}

/// Is any, is every, is no lane of the mask set? One number has one lane.
RAIO_FN constexpr bool any(bool mask) { return mask; }
RAIO_FN constexpr bool all(bool mask) { return mask; }
RAIO_FN constexpr bool none(bool mask) { return !mask; }

/// A mask that is taken for one of another kind: of packs, those of numbers of any size.
template <class Other, class Mask>
concept mask_like = std::same_as<Other, Mask> ||(!std::same_as<Mask, bool> && std::convertible_to<Other, Mask>);

/// Are all the masks set, is one of them? Unlike && and || these ask every one of them: a branch on a comparison that
/// is as good as random costs more than the comparisons it saves.
template <class Mask, mask_like<Mask>... Masks>
RAIO_FN constexpr Mask every(const Mask& first, const Masks&... rest) {
    if constexpr (std::same_as<Mask, bool>) {
        return (static_cast<unsigned>(first) & ... & static_cast<unsigned>(rest)) != 0;
    } else {
        return (first & ... & Mask(rest));
    }
}
template <class Mask, mask_like<Mask>... Masks>
RAIO_FN constexpr Mask some(const Mask& first, const Masks&... rest) {
    if constexpr (std::same_as<Mask, bool>) {
        return (static_cast<unsigned>(first) | ... | static_cast<unsigned>(rest)) != 0;
    } else {
        return (first | ... | Mask(rest));
    }
}

namespace detail {

// What no compiler need know of <cmath> before the program runs.
template <std::floating_point T>
RAIO_FN constexpr T constant_abs(T x) {
    return x < T(0) ? -x : x + T(0);
}
template <std::floating_point T>
RAIO_FN constexpr T constant_copysign(T magnitude, T sign) {
    const bool negative = std::bit_cast<std::uint64_t>(static_cast<double>(sign)) >> 63 != 0;
    return negative ? -constant_abs(magnitude) : constant_abs(magnitude);
}

}  // namespace detail

// The functions of <cmath> for the built-in numbers. Those of other number types are found by argument-dependent
// lookup.
template <std::floating_point T>
RAIO_FN constexpr T sqrt(T x) {
#if defined(__SSE2__) && !defined(__CUDA_ARCH__)
    // The instruction alone. Beside it std::sqrt has a call, which reports a negative number in errno, and around a
    // call registers are saved.
    if (!std::is_constant_evaluated()) {
        if constexpr (std::same_as<T, double>) return _mm_cvtsd_f64(_mm_sqrt_sd(_mm_set_sd(x), _mm_set_sd(x)));
        if constexpr (std::same_as<T, float>) return _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(x)));
    }
#endif
    return std::sqrt(x);
}
template <std::floating_point T>
RAIO_FN constexpr T abs(T x) {
    if (std::is_constant_evaluated()) return detail::constant_abs(x);
    return std::fabs(x);
}
template <std::floating_point T>
RAIO_FN constexpr T floor(T x) {
    return std::floor(x);
}
template <std::floating_point T>
RAIO_FN constexpr T sin(T x) {
    return std::sin(x);
}
template <std::floating_point T>
RAIO_FN constexpr T cos(T x) {
    return std::cos(x);
}
template <std::floating_point T>
RAIO_FN constexpr T copysign(T magnitude, T sign) {
    if (std::is_constant_evaluated()) return detail::constant_copysign(magnitude, sign);
    return std::copysign(magnitude, sign);
}
template <std::floating_point T>
RAIO_FN constexpr T atan2(T y, T x) {
    return std::atan2(y, x);
}

/// A number type: one number or a pack of them.
template <class T>
concept real = requires(const T a, const T b, const mask_t<T> m) {
    T(scalar_t<T>(0));
    T(a + b);
    T(a - b);
    T(a * b);
    T(a / b);
    T(-a);
    mask_t<T>(a < b);
    mask_t<T>(a <= b);
    mask_t<T>(a == b);
    mask_t<T>(m && m);
    mask_t<T>(m || m);
    mask_t<T>(every(m, m));
    mask_t<T>(some(m, m));
    mask_t<T>(!m);
    T(select(m, a, b));
    bool(any(m));
    bool(none(m));
    T(sqrt(a));
    T(abs(a));
    T(copysign(a, b));
    T(atan2(a, b));
};

// A pack brings its own, for which there are instructions.
template <real T>
RAIO_FN constexpr T min(T a, T b) {
    if constexpr (requires { T::min(a, b); }) {
        return T::min(a, b);
    } else {
        return select(b < a, b, a);
    }
}
template <real T>
RAIO_FN constexpr T max(T a, T b) {
    if constexpr (requires { T::max(a, b); }) {
        return T::max(a, b);
    } else {
        return select(a < b, b, a);
    }
}

/// x, or -x where `sign` is negative.
template <real T>
RAIO_FN constexpr T flip(const T& x, const T& sign) {
    if constexpr (requires { T::flip(x, sign); }) {
        return T::flip(x, sign);
    } else {
        return x * copysign(T(1), sign);
    }
}

template <class T>
inline const T infinity = T(std::numeric_limits<scalar_t<T>>::infinity());
template <class T>
requires(std::is_trivially_copyable_v<T>) inline constexpr T infinity<T> =
    T(std::numeric_limits<scalar_t<T>>::infinity());

template <class T>
inline const T pi = T(std::numbers::pi);
template <class T>
requires(std::is_trivially_copyable_v<T>) inline constexpr T pi<T> = T(std::numbers::pi);

/// The largest relative error of one rounding: 2 to the minus number of digits, for every number type said in double.
template <class T>
inline constexpr double unit_roundoff = [] {
    double u = 1.0;
    for (int digit = 0; digit < std::numeric_limits<scalar_t<T>>::digits; ++digit) u /= 2.0;
    return u;
}();

/// The first of the precisions of T that has more digits than T; T itself where there is none.
template <class T>
using wider_t = std::conditional_t<(unit_roundoff<working_t<T>> < unit_roundoff<T>), working_t<T>, exact_t<T>>;

template <class T>
struct wide {
    using type = T;
};
/// What packs of floats become where their own digits do not do: packs of doubles. Other numbers stay what they are.
template <class T>
using wide_t = typename wide<T>::type;

/// The smallest number with all its digits: what is below has lost some. The same for every number type of the same
/// hardware.
template <class T>
inline constexpr double least_normal = std::same_as<scalar_t<T>, float> ? 0x1p-126 : 0x1p-1022;

/// Is the number neither infinite nor NaN?
template <real T>
RAIO_FN constexpr mask_t<T> is_finite(const T& x) {
    return abs(x) < infinity<T>;
}

template <real T>
RAIO_FN constexpr mask_t<T> is_nan(const T& x) {
    return !mask_t<T>(x == x);
}

/// a / b, and `otherwise` where b is zero.
template <real T>
RAIO_FN constexpr T quotient(const T& a, const T& b, const T& otherwise) {
    const mask_t<T> zero = b == T(0);
    return select(zero, otherwise, a / select(zero, T(1), b));
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
