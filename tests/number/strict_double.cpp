#include <raio/number/strict_double.hpp>

#include <doctest/doctest.h>

#include "support/random.hpp"

namespace raio::test {

/// The same operation on memory that the compiler may not look through: each result is rounded on its own.
template <class Operation>
double one_by_one(double a, double b, Operation operation) {
    volatile double x = a, y = b;
    volatile double result = operation(static_cast<double>(x), static_cast<double>(y));
    return result;
}

TEST_CASE("strict_double: a product is rounded before it is added to") {
    random_numbers random(3);
    const auto times = [](double a, double b) { return a * b; };
    const auto plus = [](double a, double b) { return a + b; };
    const auto minus = [](double a, double b) { return a - b; };
    int contracted = 0, differ = 0, rounded_twice = 0;
    for (int i = 0; i < at_least(100'000); ++i) {
        const double a = random.uniform(-1, 1), b = random.uniform(-1, 1), c = -a * b, d = random.uniform(-1, 1);
        const strict_double x(a), y(b), z(c), w(d);
        const double ab = one_by_one(a, b, times), cd = one_by_one(c, d, times);
        contracted += static_cast<double>(x * y + z) != one_by_one(ab, c, plus);
        contracted += static_cast<double>(z + x * y) != one_by_one(ab, c, plus);
        contracted += static_cast<double>(x * y - z * w) != one_by_one(ab, cd, minus);
        differ += std::fma(a, b, c) != one_by_one(ab, c, plus);
        rounded_twice += static_cast<double>(fma(x, y, z)) != std::fma(a, b, c);
    }
    CHECK(contracted == 0);
    CHECK(rounded_twice == 0);
    CHECK(differ > 50'000);  // or else nothing would show
}

TEST_CASE("strict_double: behaves like a double") {
    const strict_double two(2), three(3.0f);
    CHECK(static_cast<double>(two + three) == 5);
    CHECK(static_cast<double>(two - three) == -1);
    CHECK(static_cast<double>(two / strict_double(8)) == 0.25);
    for (const double a : {1.0, 2.0, -0.0, std::nan("")}) {
        for (const double b : {1.0, 2.0, 0.0, std::nan("")}) {
            const strict_double x(a), y(b);
            CHECK(((x < y) == (a < b) && (x <= y) == (a <= b) && (x == y) == (a == b)));
            CHECK(((x > y) == (a > b) && (x >= y) == (a >= b)));
        }
    }
    CHECK(static_cast<float>(-three) == -3);
    CHECK((two < three && two <= two && three > two && two == two && two != three));
    CHECK(static_cast<double>(sqrt(strict_double(9))) == 3);
    CHECK(static_cast<double>(abs(-two)) == 2);
    CHECK(static_cast<double>(floor(strict_double(-0.5))) == -1);
    CHECK(static_cast<double>(copysign(two, strict_double(-0.0))) == -2);
    CHECK(static_cast<double>(atan2(strict_double(1), strict_double(0))) == std::atan2(1.0, 0.0));
    strict_double sum(1);
    sum += two, sum *= three, sum -= two, sum /= strict_double(7);
    CHECK(static_cast<double>(sum) == 1);
}

static_assert(!std::convertible_to<strict_double, double> && std::convertible_to<double, strict_double>);
static_assert(static_cast<double>(strict_double(3) * strict_double(4) + strict_double(1)) == 13);

}  // namespace raio::test
