#include "support/oracle.hpp"

#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <new>

namespace raio::test {

namespace mp = boost::multiprecision;
using number = mp::number<mp::mpfr_float_backend<75, mp::allocate_stack>, mp::et_off>;
using limits = std::numeric_limits<number>;

static_assert(limits::digits == std::numeric_limits<oracle>::digits);
static_assert(limits::max_exponent == std::numeric_limits<oracle>::max_exponent);
static_assert(limits::min_exponent == std::numeric_limits<oracle>::min_exponent);

/// The number in an oracle.
struct stored {
    static_assert(sizeof(number) <= sizeof(oracle));  // whose destructor has nothing to free

    static const number& in(const oracle& x) {
        return *std::launder(reinterpret_cast<const number*>(x.number_.data()));
    }
    static void put(oracle& x, const number& value) { ::new (x.number_.data()) number(value); }
    static oracle from(const number& value) {
        oracle x;
        put(x, value);
        return x;
    }

    /// What MPFR makes of both, where it is to be. (Boost's operators copy it there.)
    template <auto Operation>
    static oracle result(const oracle& a, const oracle& b) {
        oracle x;
        number& to = *std::launder(reinterpret_cast<number*>(x.number_.data()));
        Operation(to.backend().data(), in(a).backend().data(), in(b).backend().data(), MPFR_RNDN);
        return x;
    }
};

oracle::oracle() { ::new (number_.data()) number(); }
oracle::oracle(double x) { ::new (number_.data()) number(x); }
oracle::oracle(long double x) { ::new (number_.data()) number(x); }
oracle::oracle(const char* decimal) { ::new (number_.data()) number(decimal); }
oracle::oracle(const oracle& x) { stored::put(*this, stored::in(x)); }
oracle& oracle::operator=(const oracle& x) {
    stored::put(*this, stored::in(x));
    return *this;
}

oracle::operator float() const { return mpfr_get_flt(stored::in(*this).backend().data(), MPFR_RNDN); }
oracle::operator double() const { return mpfr_get_d(stored::in(*this).backend().data(), MPFR_RNDN); }
/// By its highest digits, cut: MPFR rounds them, in five times the time.
oracle::operator long double() const {
    const mpfr_srcptr x = stored::in(*this).backend().data();
    if (!mpfr_regular_p(x)) return mpfr_get_d(x, MPFR_RNDN);
    const long double upper = static_cast<long double>(x->_mpfr_d[(mpfr_get_prec(x) - 1) / mp_bits_per_limb]);
    return std::ldexp(mpfr_sgn(x) < 0 ? -upper : upper, static_cast<int>(mpfr_get_exp(x)) - mp_bits_per_limb);
}
std::string oracle::str(int digits) const { return stored::in(*this).str(digits); }

oracle operator-(const oracle& a) { return stored::from(-stored::in(a)); }
oracle operator+(const oracle& a, const oracle& b) { return stored::result<mpfr_add>(a, b); }
oracle operator-(const oracle& a, const oracle& b) { return stored::result<mpfr_sub>(a, b); }
oracle operator*(const oracle& a, const oracle& b) { return stored::result<mpfr_mul>(a, b); }
oracle operator/(const oracle& a, const oracle& b) { return stored::result<mpfr_div>(a, b); }
bool operator==(const oracle& a, const oracle& b) { return stored::in(a) == stored::in(b); }
bool operator<(const oracle& a, const oracle& b) { return stored::in(a) < stored::in(b); }
bool operator<=(const oracle& a, const oracle& b) { return stored::in(a) <= stored::in(b); }

oracle sqrt(const oracle& x) { return stored::from(sqrt(stored::in(x))); }
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
