#include <raio/math/quadratic.hpp>

#include <doctest/doctest.h>

#include "support/oracle.hpp"
#include "support/random.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("quadratic roots: in order, whichever sign b has", W, float, double, double_double, oracle) {
    const auto roots = [](double a, double b, double c, double s) {
        return quadratic_roots(W(1) / W(a), W(b), W(c), W(s));
    };
    const auto are = [](const vec2<W>& t, double low, double high) { return t.x == W(low) && t.y == W(high); };
    CHECK(are(roots(1, 3, 5, 2), 1, 5));
    CHECK(are(roots(1, -3, 5, 2), -5, -1));
    CHECK(are(roots(4, 2, -15, 8), -1.5, 2.5));
    CHECK(are(roots(1, 0, -4, 2), -2, 2));
    CHECK(are(roots(1, -0.0, -4, 2), -2, 2));
    CHECK(are(roots(2, 4, 8, 0), 2, 2));
    CHECK(are(roots(1, 2, 0, 2), 0, 4));
    CHECK(are(roots(1, -2, 0, 2), -4, 0));
    CHECK(are(roots(1, 1, infinity<double>, 2), -1, 3));  // c is what is out of range first
}

TEST_CASE("quadratic roots: in the last precision the root near 0 has all its digits") {
    random_numbers random(17);
    for (int i = 0; i < at_least(1000); ++i) {
        const double b = random.uniform(-2, 2), c = random.uniform(-1, 1) * std::ldexp(1.0, -random.integer(20, 80));
        const double_double s = sqrt(double_double(b) * double_double(b) - double_double(c));
        const oracle exact_s = sqrt(oracle(b) * oracle(b) - oracle(c)),
                     exact = oracle(c) / (b + copysign(exact_s, oracle(b)));
        const vec2<double_double> t = quadratic_roots(double_double(1), double_double(b), double_double(c), s);
        const oracle found = exactly(b > 0 ? t.x : t.y);
        REQUIRE(abs(found - exact) <= abs(exact) * 1e-28);
    }
}

}  // namespace raio::test
