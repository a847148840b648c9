#pragma once

#include <raio/push_macros.hpp>

#include <type_traits>

#include <raio/number/real.hpp>

/// \file
/// A double whose every operation is rounded on its own, as IEEE 754 defines it.
///
/// Compilers may contract `a * b + c` into one fused multiply-add where the processor has it, so that the same source
/// gives other bits with other flags. Here a product stands alone: every compiler, at every optimisation level, on the
/// processor and on the graphics card, gives the same bits.

namespace raio::inline RAIO_ABI {

namespace detail {

/// The product, rounded to double before anything else happens to it.
RAIO_FN constexpr double rounded_product(double a, double b) {
    if (std::is_constant_evaluated()) return a * b;
#if defined(__CUDA_ARCH__)
    return __dmul_rn(a, b);
#else
    double product = a * b;
    // To the optimiser the product may have changed here, so it cannot be fused with the addition that follows.
#if defined(__GNUC__) && (defined(__FMA__) || defined(__FMA4__))
    asm("" : "+v"(product));
#elif defined(__GNUC__) && (defined(__aarch64__) || defined(__ARM_FEATURE_FMA))
    asm("" : "+w"(product));
#elif defined(__GNUC__) && defined(__FP_FAST_FMA)  // of other processors, through memory
    asm("" : "+m"(product));
#endif
    return product;
#endif
}

/// Does the processor multiply and add with one rounding?
#if defined(__FMA__) || defined(FP_FAST_FMA) || defined(__CUDA_ARCH__)
inline constexpr bool fuses = true;
#else
inline constexpr bool fuses = false;
#endif

/// With g++ 12 a float that was made of a double can come out as that double again, never rounded, when the optimiser
/// has packed two of the conversions into one vector. So it does not learn what the floats of an argument were made of:
/// for all it knows they may have changed here, in memory, where they are floats. Costs nothing if they lie there. (Of
/// g++ 13 it is not known.)
#if defined(__GNUC__) && __GNUC__ < 14 && !defined(__clang__) && !defined(__CUDA_ARCH__)
template <class T, class... Arguments>
RAIO_FN constexpr void keep_as_stored([[maybe_unused]] const Arguments&... arguments) {
    if constexpr (std::same_as<scalar_t<T>, float>) {
        if (std::is_constant_evaluated()) return;
        (..., [](const Arguments& argument) { asm("" : "+m"(const_cast<Arguments&>(argument))); }(arguments));
    }
}
#else
template <class T, class... Arguments>
RAIO_FN constexpr void keep_as_stored(const Arguments&...) {}
#endif

}  // namespace detail

/// A double that is never contracted. Converts from every built-in number, and back only when told to.
class strict_double {
public:
    strict_double() = default;
    template <class N>
    requires std::is_arithmetic_v<N> RAIO_FN constexpr strict_double(N value) : value_(static_cast<double>(value)) {}

    RAIO_FN constexpr explicit operator double() const { return value_; }
    RAIO_FN constexpr explicit operator float() const { return static_cast<float>(value_); }

    RAIO_FN constexpr strict_double operator-() const { return -value_; }
    RAIO_FN friend constexpr strict_double operator+(strict_double a, strict_double b) { return a.value_ + b.value_; }
    RAIO_FN friend constexpr strict_double operator-(strict_double a, strict_double b) { return a.value_ - b.value_; }
    RAIO_FN friend constexpr strict_double operator*(strict_double a, strict_double b) {
        return detail::rounded_product(a.value_, b.value_);
    }
    RAIO_FN friend constexpr strict_double operator/(strict_double a, strict_double b) { return a.value_ / b.value_; }
    RAIO_FN constexpr strict_double& operator+=(strict_double b) { return *this = *this + b; }
    RAIO_FN constexpr strict_double& operator-=(strict_double b) { return *this = *this - b; }
    RAIO_FN constexpr strict_double& operator*=(strict_double b) { return *this = *this * b; }
    RAIO_FN constexpr strict_double& operator/=(strict_double b) { return *this = *this / b; }

    RAIO_FN friend constexpr bool operator==(strict_double a, strict_double b) { return a.value_ == b.value_; }
    RAIO_FN friend constexpr bool operator<(strict_double a, strict_double b) { return a.value_ < b.value_; }
    RAIO_FN friend constexpr bool operator<=(strict_double a, strict_double b) { return a.value_ <= b.value_; }
    RAIO_FN friend constexpr bool operator>(strict_double a, strict_double b) { return a.value_ > b.value_; }
    RAIO_FN friend constexpr bool operator>=(strict_double a, strict_double b) { return a.value_ >= b.value_; }

    /// a b + c, rounded once: where that is asked for it is no contraction.
    RAIO_FN friend strict_double fma(strict_double a, strict_double b, strict_double c) {
        return std::fma(a.value_, b.value_, c.value_);
    }
    RAIO_FN friend constexpr strict_double sqrt(strict_double x) { return raio::sqrt(x.value_); }
    RAIO_FN friend constexpr strict_double abs(strict_double x) { return raio::abs(x.value_); }
    RAIO_FN friend constexpr strict_double floor(strict_double x) { return raio::floor(x.value_); }
    RAIO_FN friend constexpr strict_double copysign(strict_double magnitude, strict_double sign) {
        return raio::copysign(magnitude.value_, sign.value_);
    }
    RAIO_FN friend constexpr strict_double atan2(strict_double y, strict_double x) {
        return raio::atan2(y.value_, x.value_);
    }

private:
    double value_;
};

}  // namespace raio::inline RAIO_ABI

template <>
class std::numeric_limits<raio::strict_double> : public std::numeric_limits<double> {};

#include <raio/pop_macros.hpp>
