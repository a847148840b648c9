#pragma once

#include <bit>

#include <raio/math/strict_double.hpp>

/// \file
/// A number of 106 bits: the unevaluated sum of two doubles, the low one at most half an ulp of the high one.
///
/// The two pieces come from error-free transformations: the rounding error of a sum (Knuth 1969) and of a product
/// (Dekker 1971) are themselves doubles and can be computed. Sum, product and quotient are after Hida, Li and Bailey
/// (2001), their relative error stays below 2^-100 of the operands' size.

namespace raio {

class double_double {
public:
    double_double() = default;
    template <class N>
    requires std::is_arithmetic_v<N> RAIO_FN constexpr double_double(N value)
        : high_(static_cast<double>(value)), low_(0.0) {}
    RAIO_FN constexpr double_double(strict_double value) : high_(static_cast<double>(value)), low_(0.0) {}

    RAIO_FN constexpr explicit operator double() const { return high_; }
    /// The nearest float to the sum of both parts, not to the high one: a double in the middle between two floats is
    /// first moved off it by its last bit, to the side where the low part lies (round to odd; Boldo and Melquiond
    /// 2008).
    RAIO_FN constexpr explicit operator float() const {
        const auto bits = std::bit_cast<std::uint64_t>(high_);
        if (low_ == 0.0 || (bits & 1) != 0 || !raio::is_finite(high_)) return static_cast<float>(high_);
        const bool away_from_zero = (low_ > 0.0) == (high_ > 0.0);
        return static_cast<float>(std::bit_cast<double>(away_from_zero ? bits + 1 : bits - 1));
    }
    RAIO_FN constexpr explicit operator strict_double() const { return high_; }

    RAIO_FN constexpr double_double operator-() const { return {-high_, -low_}; }

    RAIO_NO_CLONES RAIO_FN friend constexpr double_double operator+(double_double a, double_double b) {
        const double_double sum = exact_sum(a.high_, b.high_);
        if (!raio::is_finite(sum.high_)) return sum.high_;  // the error of an infinity would be a NaN
        return renormalized(sum.high_, sum.low_ + (a.low_ + b.low_));
    }
    RAIO_NO_CLONES RAIO_FN friend constexpr double_double operator-(double_double a, double_double b) { return a + -b; }
    RAIO_NO_CLONES RAIO_FN friend constexpr double_double operator*(double_double a, double_double b) {
        const double_double product = exact_product(a.high_, b.high_);
        const double cross_terms = detail::rounded_product(a.high_, b.low_) + detail::rounded_product(a.low_, b.high_);
        return renormalized(product.high_, product.low_ + cross_terms);
    }
    // A number of one part has less to be computed: what sum_as and product_as are made of.
    RAIO_FN static constexpr double_double sum(double a, double b) {
        const double_double sum = exact_sum(a, b);
        return raio::is_finite(sum.high_) ? sum : double_double(sum.high_);
    }
    RAIO_FN static constexpr double_double sum(double a, double_double b) {
        const double_double sum = exact_sum(a, b.high_);
        return raio::is_finite(sum.high_) ? renormalized(sum.high_, sum.low_ + b.low_) : double_double(sum.high_);
    }
    RAIO_FN static constexpr double_double product(double a, double b) { return exact_product(a, b); }
    RAIO_FN static constexpr double_double product(double a, double_double b) {
        const double_double product = exact_product(a, b.high_);
        return renormalized(product.high_, product.low_ + detail::rounded_product(a, b.low_));
    }

    RAIO_NO_CLONES RAIO_FN friend constexpr double_double operator/(double_double a, double_double b) {
        const double quotient = a.high_ / b.high_;
        if (!raio::is_finite(quotient) || !raio::is_finite(b.high_)) return quotient;
        const double_double remainder = a - b * double_double(quotient);
        return renormalized(quotient, remainder.high_ / b.high_);
    }
    RAIO_FN constexpr double_double& operator+=(double_double b) { return *this = *this + b; }
    RAIO_FN constexpr double_double& operator-=(double_double b) { return *this = *this - b; }
    RAIO_FN constexpr double_double& operator*=(double_double b) { return *this = *this * b; }
    RAIO_FN constexpr double_double& operator/=(double_double b) { return *this = *this / b; }

    RAIO_FN friend constexpr bool operator==(double_double a, double_double b) {
        return a.high_ == b.high_ && a.low_ == b.low_;
    }
    RAIO_FN friend constexpr bool operator<(double_double a, double_double b) {
        return a.high_ < b.high_ || (a.high_ == b.high_ && a.low_ < b.low_);
    }
    RAIO_FN friend constexpr bool operator<=(double_double a, double_double b) {
        return a.high_ < b.high_ || (a.high_ == b.high_ && a.low_ <= b.low_);
    }
    RAIO_FN friend constexpr bool operator>(double_double a, double_double b) { return b < a; }
    RAIO_FN friend constexpr bool operator>=(double_double a, double_double b) { return b <= a; }

    RAIO_FN friend constexpr double_double sqrt(double_double x) {
        const double root = raio::sqrt(x.high_);
        if (!(root > 0.0) || !raio::is_finite(root)) return root;
        const double_double remainder = x - exact_product(root, root);  // one step of Newton's method
        return renormalized(root, remainder.high_ / (root + root));
    }
    RAIO_FN friend constexpr double_double abs(double_double x) { return x.high_ < 0.0 ? -x : x; }
    RAIO_FN friend constexpr double_double floor(double_double x) {
        const double whole = raio::floor(x.high_);
        return whole == x.high_ ? renormalized(whole, raio::floor(x.low_)) : double_double(whole);
    }
    RAIO_FN friend constexpr double_double copysign(double_double magnitude, double_double sign) {
        return raio::copysign(1.0, magnitude.high_) == raio::copysign(1.0, sign.high_) ? magnitude : -magnitude;
    }
    /// To the precision of double only: angles are never needed in more.
    RAIO_FN friend constexpr double_double atan2(double_double y, double_double x) {
        return raio::atan2(y.high_, x.high_);
    }

private:
    RAIO_FN constexpr double_double(double high, double low) : high_(high), low_(low) {}

    /// a + b, without any error (Knuth, TAOCP 2, 4.2.2).
    RAIO_FN static constexpr double_double exact_sum(double a, double b) {
        const double sum = a + b;
        const double b_seen = sum - a;
        return {sum, (a - (sum - b_seen)) + (b - b_seen)};
    }

    /// The same where |a| >= |b| (Dekker 1971).
    RAIO_FN static constexpr double_double renormalized(double a, double b) {
        const double sum = a + b;
        return {sum, b - (sum - a)};
    }

    /// a * b, without any error as long as nothing underflows: a fused multiply-add says the error, and where the
    /// processor has none, Dekker's splitting (1971) finds the same bits in seventeen operations.
    RAIO_FN static constexpr double_double exact_product(double a, double b) {
        const double product = detail::rounded_product(a, b);
#if defined(__FMA__) || defined(FP_FAST_FMA) || defined(__CUDA_ARCH__)
        if (!std::is_constant_evaluated()) return {product, std::fma(a, b, -product)};
#endif
        if (raio::abs(a) > 0x1p990 || raio::abs(b) > 0x1p990) {  // the splitting would overflow; the other has room
            if (!raio::is_finite(product)) return {product, -product};
            const bool is_a = raio::abs(a) > 0x1p990;
            return {product, exact_product(is_a ? a * 0x1p-64 : a, is_a ? b : b * 0x1p-64).low_ * 0x1p64};
        }
        const double_double x = split(a), y = split(b);
        const double rest = detail::rounded_product(x.high_, y.high_) - product;
        const double cross = detail::rounded_product(x.high_, y.low_);
        const double cross2 = detail::rounded_product(x.low_, y.high_);
        return {product, ((rest + cross) + cross2) + detail::rounded_product(x.low_, y.low_)};
    }

    /// a in two halves of 26 bits each.
    RAIO_FN static constexpr double_double split(double a) {
        const double scaled = detail::rounded_product(a, 134217729.0);  // 2^27 + 1
        const double high = scaled - (scaled - a);
        return {high, a - high};
    }

    double high_, low_;
};

template <>
struct real_traits<double_double> : detail::one_number<double_double> {
    using bound = strict_double;
};

namespace detail {

/// Is it a number that one double holds?
template <class T>
inline constexpr bool one_double = std::same_as<T, float> || std::same_as<T, double> || std::same_as<T, strict_double>;

/// What is taken for it where a double_double is wanted.
template <class T>
using one_or_two_doubles = std::conditional_t<one_double<T>, double, double_double>;

}  // namespace detail

/// a + b in the precision of W. A double_double has it for half the price where `a` is one double, and for a third
/// where both are.
template <class W, real A, real B>
RAIO_FN constexpr W sum_as(const A& a, const B& b) {
    if constexpr (std::same_as<W, double_double> && detail::one_double<A>) {
        return double_double::sum(static_cast<double>(a), static_cast<detail::one_or_two_doubles<B>>(b));
    } else {
        return W(a) + W(b);
    }
}

/// a - b in the precision of W.
template <class W, real A, real B>
RAIO_FN constexpr W difference_as(const A& a, const B& b) {
    if constexpr (std::same_as<W, double_double>) {
        return sum_as<W>(a, -b);
    } else {
        return W(a) - W(b);
    }
}

/// a b in the precision of W.
template <class W, real A, real B>
RAIO_FN constexpr W product_as(const A& a, const B& b) {
    if constexpr (std::same_as<W, double_double> && detail::one_double<A>) {
        return double_double::product(static_cast<double>(a), static_cast<detail::one_or_two_doubles<B>>(b));
    } else {
        return W(a) * W(b);
    }
}

}  // namespace raio

template <>
class std::numeric_limits<raio::double_double> : public std::numeric_limits<double> {
public:
    static constexpr int digits = 101;  // that our operations guarantee; there is room for 106
    static constexpr double epsilon() { return 0x1p-100; }
};
