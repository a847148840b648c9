#pragma once

#include <array>
#include <cmath>
#include <limits>

/// \file
/// A number that carries its derivatives along: forward-mode automatic differentiation.

namespace raio::test {

/// value + sum of slope[i] dx[i], where the dx are so small that their products vanish. Compared by value.
struct dual {
    double value;
    std::array<double, 3> slope{};

    constexpr dual() : value(0) {}
    constexpr dual(double v) : value(v) {}
    constexpr dual(double v, std::array<double, 3> s) : value(v), slope(s) {}
    /// The variable number `i`.
    static constexpr dual variable(double v, std::size_t i) {
        dual x(v);
        x.slope[i] = 1;
        return x;
    }

    constexpr dual& operator+=(const dual& b) { return *this = *this + b; }
    constexpr dual& operator-=(const dual& b) { return *this = *this - b; }
    constexpr dual& operator*=(const dual& b) { return *this = *this * b; }
    constexpr dual& operator/=(const dual& b) { return *this = *this / b; }

    friend constexpr dual operator-(const dual& a) { return chain(a, -a.value, -1, a, 0); }
    friend constexpr dual operator+(const dual& a, const dual& b) { return chain(a, a.value + b.value, 1, b, 1); }
    friend constexpr dual operator-(const dual& a, const dual& b) { return chain(a, a.value - b.value, 1, b, -1); }
    friend constexpr dual operator*(const dual& a, const dual& b) {
        return chain(a, a.value * b.value, b.value, b, a.value);
    }
    friend constexpr dual operator/(const dual& a, const dual& b) {
        return chain(a, a.value / b.value, 1 / b.value, b, -a.value / (b.value * b.value));
    }
    friend constexpr bool operator==(const dual& a, const dual& b) { return a.value == b.value; }
    friend constexpr auto operator<=>(const dual& a, const dual& b) { return a.value <=> b.value; }

    friend dual sqrt(const dual& a) {
        const double root = std::sqrt(a.value);
        return chain(a, root, root > 0 ? 0.5 / root : 0, a, 0);
    }
    friend dual abs(const dual& a) { return a.value < 0 ? -a : a; }
    friend dual floor(const dual& a) { return std::floor(a.value); }
    friend dual sin(const dual& a) { return chain(a, std::sin(a.value), std::cos(a.value), a, 0); }
    friend dual cos(const dual& a) { return chain(a, std::cos(a.value), -std::sin(a.value), a, 0); }
    friend dual copysign(const dual& a, const dual& b) {
        return std::signbit(a.value) == std::signbit(b.value) ? a : -a;
    }
    friend dual atan2(const dual& y, const dual& x) {
        const double r2 = x.value * x.value + y.value * y.value;
        return chain(y, std::atan2(y.value, x.value), x.value / r2, x, -y.value / r2);
    }

private:
    /// The value, with the slopes by_a a.slope + by_b b.slope.
    static constexpr dual chain(const dual& a, double value, double by_a, const dual& b, double by_b) {
        dual result(value);
        for (std::size_t i = 0; i < 3; ++i) result.slope[i] = by_a * a.slope[i] + by_b * b.slope[i];
        return result;
    }
};

}  // namespace raio::test

template <>
class std::numeric_limits<raio::test::dual> : public std::numeric_limits<double> {};
