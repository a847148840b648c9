#include "support/oracle.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdint>
#include <new>

namespace raio::test {

using number = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using limits = std::numeric_limits<number>;

static_assert(limits::digits == std::numeric_limits<oracle>::digits);
static_assert(limits::max_exponent == std::numeric_limits<oracle>::max_exponent);
static_assert(limits::min_exponent == std::numeric_limits<oracle>::min_exponent);

/// The number in an oracle.
struct stored {
    static_assert(sizeof(number) <= sizeof(oracle) && std::is_trivially_destructible_v<number>);

    static const number& in(const oracle& x) {
        return *std::launder(reinterpret_cast<const number*>(x.number_.data()));
    }
    static void put(oracle& x, const number& value) { ::new (x.number_.data()) number(value); }
    static oracle from(const number& value) {
        oracle x;
        put(x, value);
        return x;
    }
};

oracle::oracle() { stored::put(*this, number()); }

/// By its significand, a whole number, which takes a fifth of the time that Boost takes.
oracle::oracle(double x) {
    if (x == 0 || !std::isfinite(x)) {
        stored::put(*this, number(x));
        return;
    }
    constexpr int digits = std::numeric_limits<double>::digits;
    int exponent = 0;
    const auto significand = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), digits));
    stored::put(*this, ldexp(number(significand), exponent - digits));
}

oracle::oracle(const char* decimal) { stored::put(*this, number(decimal)); }
oracle::oracle(const oracle& x) { stored::put(*this, stored::in(x)); }
oracle& oracle::operator=(const oracle& x) {
    stored::put(*this, stored::in(x));
    return *this;
}

oracle::operator float() const { return stored::in(*this).convert_to<float>(); }
oracle::operator double() const { return stored::in(*this).convert_to<double>(); }
std::string oracle::str(int digits) const { return stored::in(*this).str(digits); }

oracle operator-(const oracle& a) { return stored::from(-stored::in(a)); }
oracle operator+(const oracle& a, const oracle& b) { return stored::from(stored::in(a) + stored::in(b)); }
oracle operator-(const oracle& a, const oracle& b) { return stored::from(stored::in(a)-stored::in(b)); }
oracle operator*(const oracle& a, const oracle& b) { return stored::from(stored::in(a)*stored::in(b)); }
oracle operator/(const oracle& a, const oracle& b) { return stored::from(stored::in(a) / stored::in(b)); }
bool operator==(const oracle& a, const oracle& b) { return stored::in(a) == stored::in(b); }
bool operator<(const oracle& a, const oracle& b) { return stored::in(a) < stored::in(b); }
bool operator<=(const oracle& a, const oracle& b) { return stored::in(a) <= stored::in(b); }

/// By Heron's method: each step doubles the digits of the square root of a double. (Boost finds one bit after the
/// other.)
oracle sqrt(const oracle& x) {
    const number& square = stored::in(x);
    if (!(square > 0) || !isfinite(square)) return stored::from(sqrt(square));
    int exponent = 0;
    number reduced = frexp(square, &exponent);
    if (exponent % 2 != 0) reduced *= 2, --exponent;
    number root = std::sqrt(reduced.convert_to<double>());
    for (int digits = std::numeric_limits<double>::digits; digits < limits::digits; digits *= 2) {
        root = (root + reduced / root) / 2;
    }
    return stored::from(ldexp(root, exponent / 2));
}
oracle abs(const oracle& x) { return stored::from(abs(stored::in(x))); }
oracle floor(const oracle& x) { return stored::from(floor(stored::in(x))); }
oracle sin(const oracle& x) { return stored::from(sin(stored::in(x))); }
oracle cos(const oracle& x) { return stored::from(cos(stored::in(x))); }
oracle copysign(const oracle& magnitude, const oracle& sign) {
    return stored::from(copysign(stored::in(magnitude), stored::in(sign)));
}
oracle atan2(const oracle& y, const oracle& x) { return stored::from(atan2(stored::in(y), stored::in(x))); }
bool isfinite(const oracle& x) { return isfinite(stored::in(x)); }

}  // namespace raio::test

using raio::test::oracle, raio::test::stored, raio::test::limits;

oracle std::numeric_limits<oracle>::epsilon() { return stored::from(limits::epsilon()); }
oracle std::numeric_limits<oracle>::max() { return stored::from(limits::max()); }
oracle std::numeric_limits<oracle>::min() { return stored::from(limits::min()); }
