#include <raio/math/newton.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

namespace raio::test {

TEST_CASE_TEMPLATE("newton_between: finds the place, however bad the guess is", T, float, double) {
    const auto cube = [](T x) { return x * x * x - T(2); };
    const auto slope = [](T x) { return T(3) * x * x; };
    for (const T guess : {T(0), T(1e-3), T(1), T(3), T(4)}) {
        CHECK(newton_between(T(0), T(4), guess, cube, slope) == doctest::Approx(std::cbrt(2.0)).epsilon(1e-6));
    }
}

TEST_CASE("newton_between: where it would run away it is halved, and stays between the ends") {
    const auto steep = [](double x) { return std::atan(1e6 * (x - 0.3)); };
    const auto slope = [](double x) { return 1e6 / (1 + 1e12 * (x - 0.3) * (x - 0.3)); };
    CHECK(newton_between(0.0, 1.0, 0.9, steep, slope) == doctest::Approx(0.3).epsilon(1e-15));
    const auto flat = [](double x) { return x < 0.25 ? -1.0 : x > 0.75 ? 1.0 : 0.0; };
    const double found = newton_between(0.0, 1.0, 0.9, flat, [](double) { return 0.0; });
    CHECK((0.25 <= found && found <= 0.75));
}

TEST_CASE("newton_between: an end may be the place") {
    const auto one = [](double) { return 1.0; };
    CHECK(newton_between(
              0.0, 1.0, 0.5, [](double x) { return x; }, one) == 0);
    CHECK(newton_between(
              0.0, 1.0, 0.5, [](double x) { return x - 1; }, one) == 1);
}

}  // namespace raio::test
