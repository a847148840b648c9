#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>

#include <raio/math/vec.hpp>

/// \file
/// A number of 75 digits, in which a shape is its own oracle: floats and doubles go in without any error, and what
/// comes out is right far beyond their last bit.

namespace raio::test {

/// MPFR's number of 251 bits, which takes half of the time of one of Boost's. What it computes with stands in
/// oracle.cpp, and no test sees it.
class oracle {
public:
    oracle();  ///< 0
    oracle(double x);
    oracle(long double x);
    explicit oracle(const char* decimal);
    oracle(std::integral auto x) : oracle(static_cast<double>(x)) {}
    oracle(const oracle& x);
    oracle& operator=(const oracle& x);

    explicit operator float() const;
    explicit operator double() const;
    explicit operator long double() const;
    std::string str(int digits) const;

    friend oracle operator-(const oracle& a);
    friend oracle operator+(const oracle& a, const oracle& b);
    friend oracle operator-(const oracle& a, const oracle& b);
    friend oracle operator*(const oracle& a, const oracle& b);
    friend oracle operator/(const oracle& a, const oracle& b);
    friend bool operator==(const oracle& a, const oracle& b);
    friend bool operator<(const oracle& a, const oracle& b);
    friend bool operator<=(const oracle& a, const oracle& b);
    friend bool operator>(const oracle& a, const oracle& b) { return b < a; }
    friend bool operator>=(const oracle& a, const oracle& b) { return b <= a; }
    oracle& operator+=(const oracle& b) { return *this = *this + b; }
    oracle& operator-=(const oracle& b) { return *this = *this - b; }
    oracle& operator*=(const oracle& b) { return *this = *this * b; }
    oracle& operator/=(const oracle& b) { return *this = *this / b; }

    friend oracle sqrt(const oracle& x);
    friend oracle abs(const oracle& x);
    friend oracle floor(const oracle& x);
    friend oracle sin(const oracle& x);
    friend oracle cos(const oracle& x);
    friend oracle copysign(const oracle& magnitude, const oracle& sign);
    friend oracle atan2(const oracle& y, const oracle& x);  ///< a double's: uv, which is all it is for, is not compared
    friend bool isfinite(const oracle& x);

private:
    friend struct stored;

    alignas(std::max_align_t) std::array<std::byte, 64> number_;
};

/// The nearest T, of two equally near ones the even one.
template <class T>
T rounded(const oracle& x) {
    return static_cast<T>(x);
}

inline oracle exactly(double x) { return oracle(x); }
inline oracle exactly(long double x) { return oracle(x); }
inline oracle exactly(strict_double x) { return oracle(static_cast<double>(x)); }

/// The double that it rounds to, and what is left.
inline oracle exactly(double_double x) {
    const double high = static_cast<double>(x);
    if (!std::isfinite(high)) return oracle(high);
    return oracle(high) + oracle(static_cast<double>(x - double_double(high)));
}
template <class W>
vec3<oracle> exactly(const vec3<W>& v) {
    return {exactly(v.x), exactly(v.y), exactly(v.z)};
}

}  // namespace raio::test

/// Bounds of its errors need some of its range, and none of its digits.
template <>
struct raio::real_traits<raio::test::oracle> : raio::detail::one_number<raio::test::oracle> {
    using bound = long double;
};

template <>
class std::numeric_limits<raio::test::oracle> : public std::numeric_limits<double> {
    using oracle = raio::test::oracle;

public:
    static constexpr int digits = 251, max_exponent = 1073741823, min_exponent = -1073741823;

    static oracle infinity() { return oracle(std::numeric_limits<double>::infinity()); }
    static oracle quiet_NaN() { return oracle(std::numeric_limits<double>::quiet_NaN()); }
    static oracle epsilon();
    static oracle max();
    static oracle min();
};
