#include <raio/number/real.hpp>

#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <raio/raio.hpp>

#include "support/dual.hpp"
#include "support/oracle.hpp"
#include "support/random.hpp"

namespace raio::test {

/// Fifty digits, as they come.
using multiprecision =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

static_assert(real<float> && real<double> && real<strict_double> && real<double_double> && real<dual>);
static_assert(real<multiprecision> && real<oracle>);
static_assert(!real<void*> && !real<vec3<float>>);
static_assert(std::same_as<scalar_t<float>, float> && std::same_as<mask_t<double>, bool>);

static_assert(primitive<sphere<dual>> && primitive<sphere<multiprecision>>);

static_assert(unit_roundoff<float> == 0x1p-24 && unit_roundoff<double> == 0x1p-53);
static_assert(std::same_as<wider_t<float>, working_t<float>> && std::same_as<wider_t<double>, exact_t<double>>);
static_assert(infinity<float> > std::numeric_limits<float>::max());

static_assert(select(true, 1, 2) == 1 && select(false, 1, 2) == 2);
static_assert(choose(true, 1.5f, 2.5f) == 1.5f && choose(false, 1.5, 2.5) == 2.5);
static_assert(choose(true, strict_double(1), strict_double(2)) == strict_double(1));
static_assert(any(true) && all(true) && !none(true) && !any(false) && !all(false) && none(false));
static_assert(min(1.0, 2.0) == 1 && max(1.0, 2.0) == 2 && min(2.0f, 1.0f) == 1 && max(2.0f, 1.0f) == 2);
static_assert(quotient(6.0, 3.0, 7.0) == 2 && quotient(6.0, 0.0, 7.0) == 7 && quotient(6.0, -0.0, 7.0) == 7);
static_assert(flip(3.0, 2.0) == 3 && flip(3.0, -2.0) == -3 && flip(-3.0f, -0.0f) == 3);

TEST_CASE_TEMPLATE("abs, copysign: as <cmath> has them, before the program runs as well", T, RAIO_NUMBERS) {
    static_assert(abs(T(-3)) == T(3) && abs(T(3)) == T(3) && copysign(T(-3), T(2)) == T(3) &&
                  copysign(T(3), T(-0.0)) == T(-3));
    const auto same = [](T a, T b) { return a == b && std::signbit(a) == std::signbit(b); };
    using limits = std::numeric_limits<T>;
    for (const T x : {T(0), T(-0.0), T(1.5), T(-1.5), limits::denorm_min(), -limits::max(), -infinity<T>}) {
        CHECK((same(detail::constant_abs(x), std::fabs(x)) && same(abs(x), std::fabs(x))));
        for (const T sign : {T(0), T(-0.0), T(2), T(-2), limits::quiet_NaN(), -limits::quiet_NaN()}) {
            CHECK((same(detail::constant_copysign(x, sign), std::copysign(x, sign)) &&
                   same(copysign(x, sign), std::copysign(x, sign))));
        }
    }
}

TEST_CASE("oracle: any double goes in as it is, and comes out as it was") {
    using limits = std::numeric_limits<double>;
    random_numbers random(3);
    std::vector<double> numbers{0, 1, limits::denorm_min(), limits::min(), limits::max(), infinity<double>};
    for (int i = 0; i < 10'000; ++i) numbers.push_back(std::bit_cast<double>(random.bits()));
    for (const double x : numbers) {
        if (std::isnan(x)) continue;
        for (const double y : {x, -x}) {
            const long double wide = y;  // which MPFR takes in itself
            REQUIRE(static_cast<double>(oracle(y)) == y);
            REQUIRE(static_cast<long double>(oracle(y)) == wide);
            REQUIRE((oracle(y) == oracle(wide) && (oracle(y) < oracle(0)) == (y < 0)));
            if (std::isnormal(y / 4)) REQUIRE(oracle(y) - oracle(y / 4) == oracle(wide * 0.75L));
        }
    }
    for (const int exponent : {-16000, -1087, -1086, 959, 960, 16000}) {  // of the digits that a long double takes
        const long double x = std::ldexp(0.75L, exponent);
        REQUIRE(static_cast<long double>(oracle(x)) == x);
        REQUIRE(static_cast<long double>(oracle(-x)) == -x);
    }
}

TEST_CASE_TEMPLATE("is_finite: neither infinite nor NaN", T, RAIO_NUMBERS) {
    CHECK(is_finite(std::numeric_limits<T>::max()));
    CHECK(is_finite(-std::numeric_limits<T>::denorm_min()));
    CHECK(!is_finite(infinity<T>));
    CHECK(!is_finite(-infinity<T>));
    CHECK(!is_finite(std::numeric_limits<T>::quiet_NaN()));
}

/// Everything that can be asked of a shape, in numbers that the library has never heard of.
template <class Shape>
void ask_everything(const Shape& shape) {
    using T = number_t<Shape>;
    const ray<T> ray{{T(0.25), T(0.125), T(5)}, {T(0), T(0), T(-1)}};
    hit_record<T> rec{};
    REQUIRE(shape.hit(ray, T(0), infinity<T>, rec));
    CHECK(shape.occluded(ray, rec.t, rec.t));
    CHECK(shape.bounds().contains(rec.point));
    CHECK((rec.t == T(5) - rec.point.z));
    CHECK((abs(dot(rec.normal, rec.normal) - T(1)) < T(1e-10)));
    CHECK((spawn_ray(rec, rec.normal).origin.z >= rec.point.z));
    if constexpr (solid<Shape>) CHECK((spans(shape.spans(ray)).begin()->min == rec.t));
    if constexpr (sampleable<Shape>) {
        CHECK((shape.area() > T(0)));
        CHECK(shape.bounds().contains(shape.sample({T(0.5), T(0.5)}).point));
    }
}

TEST_CASE_TEMPLATE("every shape in numbers from elsewhere", T, dual, multiprecision) {
    const T zero(0), one(1);
    const vec3<T> o(zero, zero, zero), x(one, zero, zero), y(zero, one, zero), z(zero, zero, one);
    const std::vector<half_space<T>> tetrahedron{{z, -one}, {-x - z, -one}, {x - y - z, -one}, {x + y - z, -one}};
    ask_everything(sphere<T>{o, one});
    ask_everything(plane<T>{o, z});
    ask_everything(disc<T>{o, z, one});
    ask_everything(triangle<T>{-x - y, x - y, y});
    ask_everything(watertight_triangle<T>{-x - y, x - y, y});
    ask_everything(box<T>{-x - y - z, x + y + z});
    ask_everything(cylinder<T>{-y, y, one});
    ask_everything(open_cylinder<T>{-y, y, one});
    ask_everything(convex_polyhedron<T>{tetrahedron});
    ask_everything(group{sphere<T>{o, one}, std::vector<box<T>>{{-x - y - z, x + y + z}}});
}

/// The crossing of a line that aims next to the centre, from anywhere.
template <class T>
T crossing_with(const vec3<T>& center, const ray<double>& ray) {
    hit_record<T> rec{};
    REQUIRE(sphere<T>{center, T(1)}.hit({vec3<T>(ray.origin), vec3<T>(ray.direction)}, T(0), infinity<T>, rec));
    return rec.t;
}

TEST_CASE("the derivative of t by a sphere's centre is that of finite differences") {
    random_numbers random(5);
    for (int i = 0; i < at_least(1000); ++i) {
        const vec3<double> center = random.direction(), from = random.direction() * random.uniform(3, 9);
        const ray<double> ray{from, center + random.direction() * 0.7 - from};
        const dual t = crossing_with<dual>(
            {dual::variable(center.x, 0), dual::variable(center.y, 1), dual::variable(center.z, 2)}, ray);
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            vec3<oracle> more(center), less(center);
            more[axis] += oracle(1e-16), less[axis] -= oracle(1e-16);
            const oracle difference = (crossing_with(more, ray) - crossing_with(less, ray)) / oracle(2e-16);
            CHECK(t.slope[static_cast<std::size_t>(axis)] ==
                  doctest::Approx(rounded<double>(difference)).epsilon(1e-10));
        }
    }
}

}  // namespace raio::test
