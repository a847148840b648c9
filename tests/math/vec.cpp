#include <raio/math/vec.hpp>

#include <doctest/doctest.h>

#include "support/oracle.hpp"

namespace raio::test {

static_assert(dot(vec3<double>(1, 2, 3), vec3<double>(4, -5, 6)) == 12);
static_assert(cross(vec3<float>(1, 0, 0), vec3<float>(0, 1, 0)) == vec3<float>(0, 0, 1));
static_assert(cross(vec3<float>(1, 2, 3), vec3<float>(2, 3, 5)) == vec3<float>(1, 1, -1));
static_assert(norm1(vec3<double>(1, -2, 3)) == 6 && norm1(vec3<double>(-1, 2, -3)) == 6);
static_assert(abs(vec3<double>(-1, -2, -3)) == vec3<double>(1, 2, 3));
static_assert(min(vec3<float>(1, 5, 3), vec3<float>(4, 2, 3)) == vec3<float>(1, 2, 3));
static_assert(max(vec3<float>(1, 5, 3), vec3<float>(4, 2, 3)) == vec3<float>(4, 5, 3));
static_assert(permanent(vec3<double>(-1, 2, -3), vec3<double>(4, -5, 6), vec3<double>(-7, 8, -9)) == 450);
static_assert(permanent(vec3<double>(1, -2, 3), vec3<double>(-4, 5, -6), vec3<double>(7, -8, 9)) == 450);
static_assert(component(vec3<float>(1, 2, 3), 0) == 1 && component(vec3<float>(1, 2, 3), 2) == 3);
static_assert(component(vec3<float>(1, 2, 3), 0.0) == 1 && component(vec3<float>(1, 2, 3), 1.0) == 2 &&
              component(vec3<float>(1, 2, 3), 2.0) == 3);
static_assert(is_finite(vec3<float>(1)) && !is_finite(vec3<float>(1, infinity<float>, 1)));
static_assert(std::same_as<vec3<float>, glm::vec3> && std::same_as<vec2<double>, glm::dvec2>);

TEST_CASE_TEMPLATE("vec: lengths and signs", T, float, double, oracle) {
    const vec3<T> v(T(2), T(-3), T(6));
    CHECK((length(v) == T(7)));
    CHECK((abs(v).y == T(3)));
    CHECK((norm1(v) == T(11)));
    CHECK((abs(normalize(v).x * T(7) - T(2)) <= T(16 * unit_roundoff<T>)));
    CHECK((abs(length(normalize(v)) - T(1)) <= T(4 * unit_roundoff<T>)));
    const T nothing = normalize(v * T(0)).x;
    CHECK(nothing != nothing);
    CHECK((select(true, v, -v).x == T(2)));
    CHECK((select(false, v, -v).x == T(-2)));
}

TEST_CASE_TEMPLATE("vec: dot and cross products", T, float, double, double_double, oracle) {
    const vec3<T> a(T(1), T(-2), T(3)), b(T(4), T(5), T(-6));
    CHECK((dot(a, b) == T(-24)));
    CHECK((cross(a, b) == vec3<T>(T(-3), T(18), T(13))));
}

TEST_CASE_TEMPLATE("vec: one of two, by a branch or without", T, float, double, double_double, oracle) {
    const vec3<T> a(T(1), T(2), T(3)), b(T(4), T(5), T(6));
    for (const bool first : {true, false}) {
        CHECK((select(first, a, b) == (first ? a : b)));
        CHECK((choose(first, a, b) == (first ? a : b)));
    }
}

TEST_CASE_TEMPLATE("vec: unit vectors of those whose squares are out of range", T, float, double, double_double) {
    constexpr double large = std::same_as<T, float> ? 0x1p100 : 0x1p900;
    for (const double size : {large, 1.0, 1 / large}) {
        const vec3<T> unit = normalize(vec3<T>(T(2), T(-3), T(6)) * T(size));
        CHECK(abs(unit.x * T(7) - T(2)) <= T(16 * unit_roundoff<T>));
        CHECK(abs(length(unit) - T(1)) <= T(4 * unit_roundoff<T>));
    }
}

}  // namespace raio::test
