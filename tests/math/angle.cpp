#include <raio/math/angle.hpp>

#include <doctest/doctest.h>

#include "support/oracle.hpp"
#include "support/random.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("turns: named angles", T, RAIO_NUMBERS) {
    const T zero(0), one(1), tiny = std::numeric_limits<T>::min();
    CHECK(turns(zero, one) == T(0));
    CHECK(turns(one, one) == doctest::Approx(0.125));
    CHECK(turns(one, zero) == T(0.25));
    CHECK(turns(one, -zero) == T(0.25));
    CHECK(turns(zero, -one) == T(0.5));
    CHECK(turns(-zero, -one) == T(0.5));
    CHECK(turns(-one, zero) == T(0.75));
    CHECK(turns(-one, one) == doctest::Approx(0.875));
    CHECK(turns(-zero, one) == T(0));
    CHECK(turns(zero, zero) == T(0));
    CHECK(turns(-tiny, one) == T(0));  // a turn less nothing is no turn
    CHECK(turns(tiny, tiny) == doctest::Approx(0.125));
    CHECK(turns(T(1e-30), T(-1e-30)) == doctest::Approx(0.375));
}

TEST_CASE_TEMPLATE("latitude: named angles", T, RAIO_NUMBERS) {
    const T zero(0), one(1);
    CHECK(latitude(-one, zero) == T(0));
    CHECK(latitude(zero, one) == T(0.5));
    CHECK(latitude(-zero, one) == T(0.5));
    CHECK(latitude(one, zero) == T(1));
    CHECK(latitude(one, one) == doctest::Approx(0.75));
    CHECK(latitude(-one, one) == doctest::Approx(0.25));
}

TEST_CASE("uv_about: turns from x to y about z, and what is along it within [0, 1]") {
    const frame<double> f = frame_about(vec3<double>(0, 0, 1));
    CHECK(uv_about(f, f.y * 3.0 + f.z, 0.75f) == vec2<float>(0.25f, 0.75f));
    CHECK(uv_about(f, -f.x, 1.5f) == vec2<float>(0.5f, 1));
    CHECK(uv_about(f, f.x, -0.5f) == vec2<float>(0, 0));
}

TEST_CASE_TEMPLATE("fraction: below one, and 0 of what has none", T, RAIO_NUMBERS) {
    CHECK((fraction(T(2.25)) == T(0.25) && fraction(T(-0.25)) == T(0.75)));
    CHECK((fraction(T(3)) == T(0) && fraction(T(-1e-30)) == T(0) && fraction(infinity<T>) == T(0)));
}

TEST_CASE_TEMPLATE("turns and latitude: in range, and as exact as they say", T, RAIO_NUMBERS) {
    random_numbers random(6);
    const double pi = std::numbers::pi, tolerance = sizeof(T) == 4 ? 1e-7 : 1e-15;
    for (int i = 0; i < at_least(100'000); ++i) {
        const T length = static_cast<T>(random.log_uniform(1e-9, 1e9)),
                angle = static_cast<T>(random.uniform(0, 2 * pi));
        const T y = std::sin(angle) * length, x = std::cos(angle) * length;
        const T u = turns(y, x), v = latitude(y, std::abs(x));
        const double exact_u = std::atan2(double(y), double(x)) / (2 * pi),
                     exact_v = std::atan2(double(y), std::abs(double(x))) / pi;
        REQUIRE((0 <= u && u < 1 && 0 <= v && v <= 1));
        REQUIRE(std::abs(std::remainder(u - exact_u, 1.0)) < tolerance);
        REQUIRE(std::abs(v - 0.5 - exact_v) < tolerance);
    }
}

static_assert(pi<float> == std::numbers::pi_v<float> && pi<double> == std::numbers::pi);

}  // namespace raio::test
