#pragma once

#include <type_traits>

#include <raio/number/real.hpp>

/// \file
/// A double whose every operation is rounded on its own, as IEEE 754 defines it.
///
/// Compilers may contract `a * b + c` into one fused multiply-add where the processor has it, so that the same source
/// gives other bits with other flags. Here a product stands alone: every compiler, at every optimisation level, on the
/// processor and on the graphics card, gives the same bits.

namespace raio {

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
#elif defined(__GNUC__) && defined(__aarch64__)
    asm("" : "+w"(product));
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
template <class T, class... Arguments>
RAIO_FN constexpr void keep_as_stored([[maybe_unused]] const Arguments&... arguments) {
#if defined(__GNUC__) && __GNUC__ < 14 && !defined(__clang__) && !defined(__CUDA_ARCH__)
    if constexpr (std::same_as<scalar_t<T>, float>) {
        if (std::is_constant_evaluated()) return;
        (..., [](const Arguments& argument) { asm("" : "+m"(const_cast<Arguments&>(argument))); }(arguments));
    }
#endif
}

}  // namespace detail

/// A double that is never contracted. Converts from every built-in number, and back only when told to.
///
/// \tparam Digits  how many of its 53 digits are taken for right. A formula bounds its errors in roundings, one for
///                 each operation. With `rounded_double`, of 51 digits, every one counts for four: so the numbers that
///                 the formula is given may have been rounded as well. (A term of degree n in these has n roundings of
///                 its own at least, those of n - 1 products and of the sum or quotient that it goes into, and n more
///                 then.)
template <int Digits>
class basic_strict_double {
public:
    basic_strict_double() = default;
    template <class N>
    requires std::is_arithmetic_v<N> RAIO_FN constexpr basic_strict_double(N value)
        : value_(static_cast<double>(value)) {}
    template <std::same_as<strict_double> Strict>
    requires(Digits != 53) RAIO_FN constexpr basic_strict_double(Strict value) : value_(static_cast<double>(value)) {}

    template <std::same_as<strict_double> Strict>
    requires(Digits != 53) RAIO_FN constexpr explicit operator Strict() const { return value_; }
    RAIO_FN constexpr explicit operator double() const { return value_; }
    RAIO_FN constexpr explicit operator float() const { return static_cast<float>(value_); }

    RAIO_FN constexpr basic_strict_double operator-() const { return -value_; }
    RAIO_FN friend constexpr basic_strict_double operator+(basic_strict_double a, basic_strict_double b) {
        return a.value_ + b.value_;
    }
    RAIO_FN friend constexpr basic_strict_double operator-(basic_strict_double a, basic_strict_double b) {
        return a.value_ - b.value_;
    }
    RAIO_FN friend constexpr basic_strict_double operator*(basic_strict_double a, basic_strict_double b) {
        return detail::rounded_product(a.value_, b.value_);
    }
    RAIO_FN friend constexpr basic_strict_double operator/(basic_strict_double a, basic_strict_double b) {
        return a.value_ / b.value_;
    }
    RAIO_FN constexpr basic_strict_double& operator+=(basic_strict_double b) { return *this = *this + b; }
    RAIO_FN constexpr basic_strict_double& operator-=(basic_strict_double b) { return *this = *this - b; }
    RAIO_FN constexpr basic_strict_double& operator*=(basic_strict_double b) { return *this = *this * b; }
    RAIO_FN constexpr basic_strict_double& operator/=(basic_strict_double b) { return *this = *this / b; }

    RAIO_FN friend constexpr bool operator==(basic_strict_double a, basic_strict_double b) {
        return a.value_ == b.value_;
    }
    RAIO_FN friend constexpr bool operator<(basic_strict_double a, basic_strict_double b) {
        return a.value_ < b.value_;
    }
    RAIO_FN friend constexpr bool operator<=(basic_strict_double a, basic_strict_double b) {
        return a.value_ <= b.value_;
    }
    RAIO_FN friend constexpr bool operator>(basic_strict_double a, basic_strict_double b) {
        return a.value_ > b.value_;
    }
    RAIO_FN friend constexpr bool operator>=(basic_strict_double a, basic_strict_double b) {
        return a.value_ >= b.value_;
    }

    /// a b + c, rounded once: where that is asked for it is no contraction.
    RAIO_FN friend basic_strict_double fma(basic_strict_double a, basic_strict_double b, basic_strict_double c) {
        return std::fma(a.value_, b.value_, c.value_);
    }
    RAIO_FN friend constexpr basic_strict_double sqrt(basic_strict_double x) { return raio::sqrt(x.value_); }
    RAIO_FN friend constexpr basic_strict_double abs(basic_strict_double x) { return raio::abs(x.value_); }
    RAIO_FN friend constexpr basic_strict_double floor(basic_strict_double x) { return raio::floor(x.value_); }
    RAIO_FN friend constexpr basic_strict_double copysign(basic_strict_double magnitude, basic_strict_double sign) {
        return raio::copysign(magnitude.value_, sign.value_);
    }
    RAIO_FN friend constexpr basic_strict_double atan2(basic_strict_double y, basic_strict_double x) {
        return raio::atan2(y.value_, x.value_);
    }

private:
    double value_;
};

/// What it was rounded from settles what it leaves open.
template <>
struct real_traits<rounded_double> : detail::one_number<rounded_double> {
    using exact = double_double;
    using bound = strict_double;
};

}  // namespace raio

template <int Digits>
class std::numeric_limits<raio::basic_strict_double<Digits>> : public std::numeric_limits<double> {
public:
    static constexpr int digits = Digits;
};
