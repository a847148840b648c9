#pragma once

#include <raio/push_macros.hpp>

#include <bit>

#include <raio/number/plain.hpp>
#include <raio/number/strict_double.hpp>

/// \file
/// A number of 106 bits: the unevaluated sum of two doubles, the low one at most half an ulp of the high one.
///
/// The two pieces come from error-free transformations: the rounding error of a sum (Knuth 1969) and of a product
/// (Dekker 1971) are themselves doubles and can be computed. Sum, product and quotient are after Hida, Li and Bailey
/// (2001), their relative error stays below 2^-100 of the operands' size.

namespace raio::inline RAIO_ABI {

namespace detail {

/// Are they packs of as many numbers?
template <class A, class B>
concept same_lanes = requires {
    requires A::lanes == B::lanes;
};

}  // namespace detail

/// \tparam D  what its parts are: one double, or a pack of them
template <class D>
class basic_double_double {
    static constexpr bool is_pack = !std::same_as<D, strict_double>;
    using mask = mask_t<D>;

public:
    basic_double_double() = default;
    template <class N>
    requires std::is_arithmetic_v<N> RAIO_FN constexpr basic_double_double(N value)
        : high_(static_cast<double>(value)), low_(0.0) {}
    RAIO_FN constexpr basic_double_double(D value) : high_(value), low_(0.0) {}
    template <std::same_as<double_double> One>
    requires is_pack RAIO_FN constexpr basic_double_double(One value) : high_(value.high_), low_(value.low_) {}
    template <detail::same_lanes<D> Pack>
    RAIO_FN explicit basic_double_double(const Pack& value) : basic_double_double(D(value)) {}

    RAIO_FN constexpr explicit operator D() const { return high_; }
    RAIO_FN constexpr explicit operator double() const requires(!is_pack) { return static_cast<double>(high_); }
    /// The nearest float to the sum of both parts, not to the high one: a double in the middle between two floats is
    /// first moved off it by its last bit, to the side where the low part lies (round to odd; Boldo and Melquiond
    /// 2008).
    RAIO_FN constexpr explicit operator float() const requires(!is_pack) {
        const auto high = static_cast<double>(high_);
        const auto low = static_cast<double>(low_);
        const auto bits = std::bit_cast<std::uint64_t>(high);
        if (low == 0.0 || (bits & 1) != 0 || !raio::is_finite(high)) return static_cast<float>(high);
        const bool away_from_zero = (low > 0.0) == (high > 0.0);
        return static_cast<float>(std::bit_cast<double>(away_from_zero ? bits + 1 : bits - 1));
    }
    template <detail::same_lanes<D> Pack>
    RAIO_FN explicit operator Pack() const {
        return Pack(high_);
    }

    RAIO_FN constexpr basic_double_double operator-() const { return {-high_, -low_}; }

    RAIO_NO_CLONES RAIO_FN friend constexpr basic_double_double operator+(basic_double_double a,
                                                                          basic_double_double b) {
        const basic_double_double sum = exact_sum(a.high_, b.high_);
        return if_finite(sum.high_, [&] { return renormalized(sum.high_, sum.low_ + (a.low_ + b.low_)); });
    }
    RAIO_NO_CLONES RAIO_FN friend constexpr basic_double_double operator-(basic_double_double a,
                                                                          basic_double_double b) {
        return a + -b;
    }
    RAIO_NO_CLONES RAIO_FN friend constexpr basic_double_double operator*(basic_double_double a,
                                                                          basic_double_double b) {
        const basic_double_double product = unrounded_product(a, b);
        return renormalized(product.high_, product.low_);
    }
    // A number of one part has less to be computed: what sum_as and product_as are made of.
    RAIO_FN static constexpr basic_double_double sum(D a, D b) {
        const basic_double_double sum = exact_sum(a, b);
        return if_finite(sum.high_, [&] { return sum; });
    }
    RAIO_FN static constexpr basic_double_double sum(D a, basic_double_double b) {
        const basic_double_double sum = exact_sum(a, b.high_);
        return if_finite(sum.high_, [&] { return renormalized(sum.high_, sum.low_ + b.low_); });
    }
    RAIO_FN static constexpr basic_double_double product(D a, D b) { return exact_product(a, b); }
    RAIO_FN static constexpr basic_double_double product(D a, basic_double_double b) {
        const basic_double_double product = exact_product(a, b.high_);
        return renormalized(product.high_, product.low_ + a * b.low_);
    }

    RAIO_NO_CLONES RAIO_FN friend constexpr basic_double_double operator/(basic_double_double a,
                                                                          basic_double_double b) {
        const D quotient = a.high_ / b.high_;
        return only_where(every(raio::is_finite(quotient), raio::is_finite(b.high_)), quotient, [&] {
            const basic_double_double remainder = a - b * basic_double_double(quotient);
            return renormalized(quotient, remainder.high_ / b.high_);
        });
    }
    /// a b + c d + ..., of two or three products. The low parts wait until all high parts are added up: that is less
    /// than the operations one by one. With u = 2^-53 the low part of a product is off by 8 u^2 of its size, and at
    /// most 3 u; the sums of three of them round away 6 u^2, those of the errors of the high parts, each at most u, 2
    /// u^2, and that of both 5 u^2: 21 u^2 in all, which is below 2^-101 of the products' sizes.
    template <class... More>
    RAIO_NO_CLONES RAIO_FN static constexpr basic_double_double sum_of_products(basic_double_double a,
                                                                                basic_double_double b, More... more) {
        return sum_of(unrounded_product(a, b), D(0), more...);
    }
    RAIO_FN constexpr basic_double_double& operator+=(basic_double_double b) { return *this = *this + b; }
    RAIO_FN constexpr basic_double_double& operator-=(basic_double_double b) { return *this = *this - b; }
    RAIO_FN constexpr basic_double_double& operator*=(basic_double_double b) { return *this = *this * b; }
    RAIO_FN constexpr basic_double_double& operator/=(basic_double_double b) { return *this = *this / b; }

    RAIO_FN friend constexpr mask operator==(basic_double_double a, basic_double_double b) {
        return a.high_ == b.high_ && a.low_ == b.low_;
    }
    RAIO_FN friend constexpr mask operator!=(basic_double_double a, basic_double_double b) { return !(a == b); }
    RAIO_FN friend constexpr mask operator<(basic_double_double a, basic_double_double b) {
        return a.high_ < b.high_ || (a.high_ == b.high_ && a.low_ < b.low_);
    }
    RAIO_FN friend constexpr mask operator<=(basic_double_double a, basic_double_double b) {
        return a.high_ < b.high_ || (a.high_ == b.high_ && a.low_ <= b.low_);
    }
    RAIO_FN friend constexpr mask operator>(basic_double_double a, basic_double_double b) { return b < a; }
    RAIO_FN friend constexpr mask operator>=(basic_double_double a, basic_double_double b) { return b <= a; }

    RAIO_FN friend constexpr basic_double_double select(const mask& where, const basic_double_double& a,
                                                        const basic_double_double& b) requires is_pack {
        return {select(where, a.high_, b.high_), select(where, a.low_, b.low_)};
    }

    RAIO_FN friend constexpr basic_double_double sqrt(basic_double_double x) {
        const D root = sqrt(x.high_);
        const mask sound = every(root > D(0), raio::is_finite(root));
        return only_where(sound, root, [&] {
            const basic_double_double remainder = x - exact_product(root, root);  // one step of Newton's method
            return renormalized(root, remainder.high_ / select(sound, root + root, D(1)));
        });
    }
    RAIO_FN friend constexpr basic_double_double abs(basic_double_double x) { return select(x.high_ < D(0), -x, x); }
    RAIO_FN friend constexpr basic_double_double floor(basic_double_double x) {
        const D whole = floor(x.high_);
        return only_where(whole == x.high_, whole, [&] { return renormalized(whole, floor(x.low_)); });
    }
    RAIO_FN friend constexpr basic_double_double copysign(basic_double_double magnitude, basic_double_double sign) {
        return select(copysign(D(1), magnitude.high_) == copysign(D(1), sign.high_), magnitude, -magnitude);
    }
    /// To the precision of double only: angles are never needed in more.
    RAIO_FN friend constexpr basic_double_double atan2(basic_double_double y, basic_double_double x) {
        return atan2(y.high_, x.high_);
    }

private:
    template <class>
    friend class basic_double_double;

    RAIO_FN constexpr basic_double_double(D high, D low) : high_(high), low_(low) {}

    /// What `find` answers, but one part where that would not be a number; `find` is not asked if it is nowhere.
    template <class Find>
    RAIO_FN static constexpr basic_double_double only_where(const mask& sound, const D& otherwise, Find find) {
        if constexpr (is_pack) {
            return select(sound, find(), basic_double_double(otherwise));
        } else {
            return sound ? find() : basic_double_double(otherwise);
        }
    }
    /// The error of an infinity would be a NaN.
    template <class Find>
    RAIO_FN static constexpr basic_double_double if_finite(const D& high, Find find) {
        return only_where(raio::is_finite(high), high, find);
    }

    /// a * b, its parts not added up.
    RAIO_FN static constexpr basic_double_double unrounded_product(basic_double_double a, basic_double_double b) {
        const basic_double_double product = exact_product(a.high_, b.high_);
        return {product.high_, product.low_ + (a.high_ * b.low_ + a.low_ * b.high_)};
    }

    /// \param sum   its parts not added up
    /// \param lost  the errors of the sums of its high parts
    RAIO_FN static constexpr basic_double_double sum_of(basic_double_double sum, D lost) {
        // What is not a number was a product out of range.
        return only_where(raio::is_finite(sum.high_), sum.high_ + sum.low_,
                          [&] { return exact_sum(sum.high_, sum.low_ + lost); });
    }
    template <class... More>
    RAIO_FN static constexpr basic_double_double sum_of(basic_double_double sum, D lost, basic_double_double a,
                                                        basic_double_double b, More... more) {
        const basic_double_double product = unrounded_product(a, b), both = exact_sum(sum.high_, product.high_);
        return sum_of({both.high_, sum.low_ + product.low_}, lost + both.low_, more...);
    }

    /// a + b, without any error (Knuth, TAOCP 2, 4.2.2).
    RAIO_FN static constexpr basic_double_double exact_sum(D a, D b) {
        const D sum = a + b;
        // Compilers do not take inf - inf for a constant.
        if (std::is_constant_evaluated() && !all(raio::is_finite(sum))) return {sum, D(0)};
        const D b_seen = sum - a;
        return {sum, (a - (sum - b_seen)) + (b - b_seen)};
    }

    /// The same where |a| >= |b| (Dekker 1971).
    RAIO_FN static constexpr basic_double_double renormalized(D a, D b) {
        const D sum = a + b;
        return {sum, b - (sum - a)};
    }

    /// a * b, without any error as long as nothing underflows: a fused multiply-add says the error, and where the
    /// processor has none, Dekker's splitting (1971) finds the same bits in seventeen operations.
    RAIO_FN static constexpr basic_double_double exact_product(D a, D b) {
        const D product = a * b;
        if constexpr (detail::fuses) {
            if (!std::is_constant_evaluated()) return {product, fma(a, b, -product)};
        }
        const D most(0x1p990);
        const mask a_large = abs(a) > most, large = some(a_large, abs(b) > most);
        if (!any(large)) return {product, split_error(a, b, product)};
        // The splitting would overflow; the other number has room.
        const D less(0x1p-64), x = select(a_large, a * less, a), y = select(every(large, !a_large), b * less, b);
        const D error = split_error(x, y, x * y);
        return {product, select(raio::is_finite(product), select(large, error * D(0x1p64), error), -product)};
    }

    RAIO_FN static constexpr D split_error(D a, D b, D product) {
        const basic_double_double x = split(a), y = split(b);
        const D rest = x.high_ * y.high_ - product;
        return ((rest + x.high_ * y.low_) + x.low_ * y.high_) + x.low_ * y.low_;
    }

    /// a in two halves of 26 bits each.
    RAIO_FN static constexpr basic_double_double split(D a) {
        const D scaled = a * D(134217729.0);  // 2^27 + 1
        const D high = scaled - (scaled - a);
        return {high, a - high};
    }

    D high_, low_;
};

template <class D>
struct real_traits<basic_double_double<D>> : detail::one_number<basic_double_double<D>> {
    using scalar = double_double;
    using mask = mask_t<D>;
    using index = index_t<D>;
    using bound = D;
};

/// Is it the last precision, which has nobody to ask?
template <class W>
concept last_precision = std::same_as<scalar_t<W>, double_double>;

/// Is there a closer look at what W leaves in doubt?
template <class W>
inline constexpr bool has_closer_look = sizeof(scalar_t<W>) <= sizeof(double) && !is_believed<W>;

namespace detail {

/// What is taken for a number where a W of two parts is wanted.
template <class W, class T>
using one_or_two_parts = std::conditional_t<last_precision<T>, W, bound_t<W>>;

}  // namespace detail

/// a + b in the precision of W. A double_double has it for half the price where `a` is one double, and for a third
/// where both are.
template <class W, real A, real B>
RAIO_FN constexpr W sum_as(const A& a, const B& b) {
    if constexpr (last_precision<W> && !last_precision<A>) {
        return W::sum(bound_t<W>(a), detail::one_or_two_parts<W, B>(b));
    } else {
        return W(a) + W(b);
    }
}

/// a - b in the precision of W, rounded once.
template <class W, real A, real B>
RAIO_FN constexpr W difference_as(const A& a, const B& b) {
    if constexpr (last_precision<W>) {
        return sum_as<W>(a, -b);
    } else if constexpr (last_precision<A>) {
        return W(sum_as<A>(-b, a));
    } else if constexpr (last_precision<B>) {
        return W(sum_as<B>(a, -b));
    } else {
        return W(a) - W(b);
    }
}

/// a b in the precision of W.
template <class W, real A, real B>
RAIO_FN constexpr W product_as(const A& a, const B& b) {
    if constexpr (last_precision<W> && !last_precision<A>) {
        return W::product(bound_t<W>(a), detail::one_or_two_parts<W, B>(b));
    } else {
        return W(a) * W(b);
    }
}

}  // namespace raio::inline RAIO_ABI

template <class D>
class std::numeric_limits<raio::basic_double_double<D>> : public std::numeric_limits<double> {
public:
    static constexpr int digits = 101;  // that our operations guarantee; there is room for 106
    static constexpr double epsilon() { return 0x1p-100; }
};

#include <raio/pop_macros.hpp>
