#include <raio/number/double_double.hpp>

#include <doctest/doctest.h>

#include "support/oracle.hpp"
#include "support/random.hpp"

namespace raio::test {

/// Of any sign and size between 1e-30 and 1e30, all its bits in use.
double_double random_double_double(random_numbers& random) {
    const double high = (random.one_in(2) ? -1 : 1) * random.log_uniform(1e-30, 1e30);
    return double_double(high) + double_double(high * random.uniform(-0x1p-54, 0x1p-54));
}

double error_of(double_double result, const oracle& exact, const oracle& scale) {
    return rounded<double>(abs(exactly(result) - exact) / abs(scale));
}

TEST_CASE("double_double: the error of every operation is below 2^-100") {
    random_numbers random(1);
    double sum = 0, difference = 0, product = 0, quotient = 0, root = 0;
    for (int i = 0; i < at_least_a_tenth_of(100'000); ++i) {
        const double_double a = random_double_double(random);
        // Every other pair cancels.
        const double_double b =
            random.one_in(2) ? random_double_double(random) : a * double_double(random.uniform(0.5, 2));
        const oracle x = exactly(a), y = exactly(b), larger = max(abs(x), abs(y));
        sum = std::max(sum, error_of(a + b, x + y, larger));
        difference = std::max(difference, error_of(a - b, x - y, larger));
        product = std::max(product, error_of(a * b, x * y, x * y));
        quotient = std::max(quotient, error_of(a / b, x / y, x / y));
        root = std::max(root, error_of(sqrt(abs(a)), sqrt(abs(x)), sqrt(abs(x))));

        const double one_part = static_cast<double>(a);
        const oracle z(one_part);
        sum = std::max(sum, error_of(sum_as<double_double>(one_part, b), z + y, larger));
        difference = std::max(difference, error_of(difference_as<double_double>(one_part, b), z - y, larger));
        product = std::max(product, error_of(product_as<double_double>(one_part, b), z * y, z * y));
    }
    CHECK(sum < 0x1p-100);
    CHECK(difference < 0x1p-100);
    CHECK(product < 0x1p-100);
    CHECK(quotient < 0x1p-100);
    CHECK(root < 0x1p-100);
}

TEST_CASE("double_double: the error of a sum of products is below 2^-101 of their sizes") {
    random_numbers random(4);
    double of_two = 0, of_three = 0;
    for (int i = 0; i < at_least_a_tenth_of(100'000); ++i) {
        const auto any = [&] {
            return double_double(random.uniform(-2, 2)) + double_double(random.uniform(-0x1p-53, 0x1p-53));
        };
        const double_double a = any(), b = any(), c = any(), e = any(), f = any();
        // Every other time the products cancel: all but a few of their bits, or their low parts.
        const double_double d = random.one_in(2) ? any() : a * b / -c * (1.0 + random.log_uniform(1e-32, 1));
        const oracle ab = exactly(a) * exactly(b), cd = exactly(c) * exactly(d), ef = exactly(e) * exactly(f);
        of_two = std::max(of_two, error_of(double_double::sum_of_products(a, b, c, d), ab + cd, abs(ab) + abs(cd)));
        of_three = std::max(of_three, error_of(double_double::sum_of_products(a, b, c, d, e, f), ab + cd + ef,
                                               abs(ab) + abs(cd) + abs(ef)));
    }
    CHECK(of_two < 0x1p-101);
    CHECK(of_three < 0x1p-101);
}

TEST_CASE("double_double: of a sum of products out of range no number is left, or an infinity") {
    const double_double one(1), huge(0x1p1000), most(0x1p1023);
    const auto sum = [](auto... x) { return static_cast<double>(double_double::sum_of_products(x...)); };
    CHECK(std::isnan(sum(huge, huge, one, one)));
    CHECK(std::isnan(sum(one, one, one, one, huge, huge)));
    CHECK(sum(most, one, most, one) == infinity<double>);
    CHECK(sum(-most, one, -most, one, one, one) == -infinity<double>);
}

TEST_CASE("double_double: sums and products of doubles have no error") {
    random_numbers random(2);
    for (int i = 0; i < at_least_a_tenth_of(100'000); ++i) {
        const double a = random.uniform(-1, 1), b = random.log_uniform(1e-15, 1);
        REQUIRE(exactly(double_double(a) + double_double(b)) == oracle(a) + oracle(b));
        REQUIRE(exactly(double_double(a) * double_double(b)) == oracle(a) * oracle(b));
        REQUIRE(exactly(sum_as<double_double>(a, b)) == oracle(a) + oracle(b));
        REQUIRE(exactly(difference_as<double_double>(a, b)) == oracle(a) - oracle(b));
        REQUIRE(exactly(product_as<double_double>(a, b)) == oracle(a) * oracle(b));
    }
}

TEST_CASE("double_double: sums and products in a precision take every part of what they are given") {
    const double_double a = double_double(1) + double_double(0x1p-80), b = double_double(3) - double_double(0x1p-70);
    CHECK((sum_as<double_double>(a, b) == a + b && sum_as<double_double>(a, 3.0) == a + double_double(3)));
    CHECK((difference_as<double_double>(a, b) == a - b && product_as<double_double>(a, b) == a * b));
    CHECK((sum_as<double>(2.0, 3.0f) == 5 && difference_as<double>(2.0, 3.0f) == -1));
    CHECK((sum_as<float>(2.0f, 3.0f) == 5 && product_as<double>(2.0f, 3.0) == 6));
}

TEST_CASE("double_double: so do products up to the end of the range") {
    random_numbers random(3);
    for (int i = 0; i < at_least_a_tenth_of(10'000); ++i) {
        const double a = std::ldexp(random.uniform(-1, 1), random.integer(960, 1024)), b = random.log_uniform(1e-15, 1);
        REQUIRE(exactly(product_as<double_double>(a, b)) == oracle(a) * oracle(b));
        REQUIRE(exactly(product_as<double_double>(b, a)) == oracle(a) * oracle(b));
    }
}

TEST_CASE("double_double: compares, rounds and changes signs like a number") {
    const double_double one(1), more = one + double_double(0x1p-80), less = one - double_double(0x1p-80);
    CHECK((one <= double_double(2) && !(double_double(2) <= one) && one <= more && !(more <= one)));
    CHECK((less < one && one < more && more > less && one <= one && one >= one && one == one && one != more));
    CHECK((!(one < one) && !(more < one) && !(more < more) && !(one > one)));
    CHECK((-more < -one && abs(-more) == more && abs(less) == less));
    CHECK(floor(more) == one);
    CHECK(floor(less) == double_double(0));
    CHECK(floor(double_double(-2.5)) == double_double(-3));
    CHECK(floor(double_double(0x1p70) - double_double(0.5)) == double_double(0x1p70) - one);
    for (const double_double& size : {more, less, double_double(0.25), double_double(4)}) {
        CHECK((copysign(size, double_double(-0.0)) == -size && copysign(-size, double_double(-0.5)) == -size));
        CHECK((copysign(size, double_double(0.5)) == size && copysign(-size, double_double(2)) == size));
    }
    CHECK(!std::signbit(static_cast<double>(abs(double_double(0)))));
    CHECK(static_cast<double>(more) == 1);
    double_double part = more;
    CHECK(((part /= less) == more / less && part == more / less));
    CHECK(((part += less) == more / less + less && (part -= less) == more / less + less - less));
    CHECK(((part = more) *= less) == more * less);
    using limits = std::numeric_limits<double_double>;
    CHECK(limits::epsilon() == std::ldexp(1.0, 1 - limits::digits));
    CHECK(exactly(more) == oracle(1) + oracle(0x1p-80));
}

TEST_CASE("double_double: becomes a float by one rounding") {
    const double_double middle(1 + 0x1p-24), bit(0x1p-80);
    CHECK(static_cast<float>(middle) == 1);
    CHECK(static_cast<float>(middle + bit) == 1 + 0x1p-23f);
    CHECK(static_cast<float>(middle - bit) == 1);
    const double_double odd_middle(1 + 0x1p-23 + 0x1p-24);
    CHECK(static_cast<float>(odd_middle) == 1 + 0x1p-22f);
    CHECK(static_cast<float>(odd_middle - bit) == 1 + 0x1p-23f);
    CHECK(static_cast<float>(middle + double_double(0x1p-52) - bit) == 1 + 0x1p-23f);
    CHECK(static_cast<float>(-middle - bit) == -1 - 0x1p-23f);
    CHECK(static_cast<float>(double_double(0x1p1000)) == std::numeric_limits<float>::infinity());
}

TEST_CASE("double_double: what is not finite stays so, and a NaN compares with nothing") {
    const double infinite = std::numeric_limits<double>::infinity();
    const double_double inf(infinite), nan(std::numeric_limits<double>::quiet_NaN()), one(1), huge(1e300);
    for (const double_double& x : {inf + one, one - inf, inf * one, huge * huge, nan + one, nan * one, inf - inf}) {
        CHECK(!std::isfinite(static_cast<double>(x)));
    }
    for (const double_double& other : {one, double_double(infinite)}) {
        CHECK((sum_as<double_double>(infinite, other) == inf && sum_as<double_double>(infinite, 1.0) == inf));
    }
    CHECK((inf / one == inf && -inf < one && one < inf && sqrt(inf) == inf &&
           sqrt(double_double(0)) == double_double(0)));
    CHECK((!(nan == nan) && !(nan < one) && !(one < nan) && !(nan >= one) && !(nan <= one) && nan != nan));
    CHECK(std::isnan(static_cast<double>(sqrt(-one))));
}

constexpr double_double third = double_double(1) / double_double(3);
static_assert(abs(third * double_double(3) - double_double(1)) < double_double(0x1p-100));

}  // namespace raio::test
