#include "support/oracle.hpp"

#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>

namespace raio::test {

using limits = std::numeric_limits<oracle>;

/// What an oracle holds: MPFR's number, with its digits behind it, so that there is nothing to free.
struct stored {
    __mpfr_struct number;
    std::array<mp_limb_t, (limits::digits - 1) / GMP_NUMB_BITS + 1> digits;

    static mpfr_ptr in(oracle& x) { return &std::launder(reinterpret_cast<stored*>(x.number_.data()))->number; }
    static mpfr_srcptr in(const oracle& x) {
        return &std::launder(reinterpret_cast<const stored*>(x.number_.data()))->number;
    }

    /// A regular number by its highest digits, the first of which is not zero.
    static void set(oracle& x, bool is_negative, std::uint64_t digits, int exponent) {
        stored& made = *std::launder(reinterpret_cast<stored*>(x.number_.data()));
        made.digits = {};
        made.digits.back() = digits;
        mpfr_custom_init_set(&made.number, is_negative ? -MPFR_REGULAR_KIND : MPFR_REGULAR_KIND, exponent,
                             limits::digits, made.digits.data());
    }

    /// What the operation of MPFR makes of these, rounded.
    template <auto Operation>
    static oracle result(const auto&... x) {
        oracle made;
        Operation(in(made), x..., MPFR_RNDN);
        return made;
    }
    template <auto Operation>
    static oracle of(const auto&... x) {
        return result<Operation>(in(x)...);
    }
};

static_assert(sizeof(stored) <= sizeof(oracle));

oracle::oracle() {
    stored& made = *::new (number_.data()) stored;
    mpfr_custom_init_set(&made.number, MPFR_ZERO_KIND, 0, limits::digits, made.digits.data());
}
/// A normal number by its bits: MPFR takes three times the time, for any number of digits.
oracle::oracle(double x) : oracle() {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int exponent = static_cast<int>(bits >> 52 & 0x7ff);
    if (GMP_NUMB_BITS != 64 || exponent == 0 || exponent == 0x7ff) {
        mpfr_set_d(stored::in(*this), x, MPFR_RNDN);
        return;
    }
    stored::set(*this, x < 0, bits << 11 | std::uint64_t{1} << 63, exponent - 1022);
}
/// As a double, where it is the one of the x87, which has 64 digits.
oracle::oracle(long double x) : oracle() {
    std::array<std::uint64_t, 2> bits{};
    std::memcpy(bits.data(), &x, std::min(sizeof(bits), sizeof(x)));
    const int exponent = static_cast<int>(bits[1] & 0x7fff);
    const bool is_x87 = std::numeric_limits<long double>::digits == 64 && std::endian::native == std::endian::little;
    if (!is_x87 || GMP_NUMB_BITS != 64 || exponent == 0 || exponent == 0x7fff) {
        mpfr_set_ld(stored::in(*this), x, MPFR_RNDN);
        return;
    }
    stored::set(*this, x < 0, bits[0], exponent - 16382);
}
oracle::oracle(const char* decimal) : oracle() { mpfr_set_str(stored::in(*this), decimal, 10, MPFR_RNDN); }
oracle::oracle(const oracle& x) { *this = x; }
/// Its bytes; the digits have moved with them.
oracle& oracle::operator=(const oracle& x) {
    number_ = x.number_;
    mpfr_custom_move(stored::in(*this), number_.data() + offsetof(stored, digits));
    return *this;
}

oracle::operator float() const { return mpfr_get_flt(stored::in(*this), MPFR_RNDN); }
oracle::operator double() const { return mpfr_get_d(stored::in(*this), MPFR_RNDN); }
/// By its highest digits, cut: MPFR rounds them, in five times the time.
oracle::operator long double() const {
    const mpfr_srcptr x = stored::in(*this);
    if (!mpfr_regular_p(x)) return mpfr_get_d(x, MPFR_RNDN);
    const long double upper = static_cast<long double>(x->_mpfr_d[(mpfr_get_prec(x) - 1) / GMP_NUMB_BITS]);
    const long double signed_upper = mpfr_sgn(x) < 0 ? -upper : upper;
    const int exponent = static_cast<int>(mpfr_get_exp(x)) - GMP_NUMB_BITS;
    if (exponent < -1022 || exponent > 1023) return std::ldexp(signed_upper, exponent);
    return signed_upper * std::bit_cast<double>(std::uint64_t(exponent + 1023) << 52);
}
std::string oracle::str(int digits) const {
    std::string text(static_cast<std::size_t>(mpfr_snprintf(nullptr, 0, "%.*Rg", digits, stored::in(*this))), ' ');
    mpfr_snprintf(text.data(), text.size() + 1, "%.*Rg", digits, stored::in(*this));
    return text;
}

oracle operator-(const oracle& a) { return stored::of<mpfr_neg>(a); }
oracle operator+(const oracle& a, const oracle& b) { return stored::of<mpfr_add>(a, b); }
oracle operator-(const oracle& a, const oracle& b) { return stored::of<mpfr_sub>(a, b); }
oracle operator*(const oracle& a, const oracle& b) { return stored::of<mpfr_mul>(a, b); }
oracle operator/(const oracle& a, const oracle& b) { return stored::of<mpfr_div>(a, b); }
bool operator==(const oracle& a, const oracle& b) { return mpfr_equal_p(stored::in(a), stored::in(b)); }
bool operator<(const oracle& a, const oracle& b) { return mpfr_less_p(stored::in(a), stored::in(b)); }
bool operator<=(const oracle& a, const oracle& b) { return mpfr_lessequal_p(stored::in(a), stored::in(b)); }

oracle sqrt(const oracle& x) { return stored::of<mpfr_sqrt>(x); }
oracle abs(const oracle& x) { return stored::of<mpfr_abs>(x); }
oracle floor(const oracle& x) {
    oracle made;
    mpfr_floor(stored::in(made), stored::in(x));
    return made;
}
oracle sin(const oracle& x) { return stored::of<mpfr_sin>(x); }
oracle cos(const oracle& x) { return stored::of<mpfr_cos>(x); }
oracle copysign(const oracle& magnitude, const oracle& sign) { return stored::of<mpfr_copysign>(magnitude, sign); }
oracle atan2(const oracle& y, const oracle& x) { return std::atan2(static_cast<double>(y), static_cast<double>(x)); }
bool isfinite(const oracle& x) { return mpfr_number_p(stored::in(x)); }

}  // namespace raio::test

using raio::test::oracle, raio::test::stored, raio::test::limits;

oracle limits::epsilon() { return stored::result<mpfr_set_si_2exp>(1L, mpfr_exp_t(1 - digits)); }
oracle limits::max() {
    oracle most = infinity();
    mpfr_nextbelow(stored::in(most));
    return most;
}
oracle limits::min() { return stored::result<mpfr_set_si_2exp>(1L, mpfr_exp_t(min_exponent - 1)); }
