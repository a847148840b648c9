#include <raio/bvh/build_box.hpp>

#include <doctest/doctest.h>

#include "support/random.hpp"

namespace raio::test {

using detail::build_box;

namespace {

build_box box_of(const vec3<float>& low, const vec3<float>& high, std::uint32_t id = 0) {
    return detail::to_build_box(aabb<float>{low, high}, id);
}

bool same(const build_box& a, const build_box& b) {
    const auto equal = [&](unsigned axis) { return a.low(axis) == b.low(axis) && a.high(axis) == b.high(axis); };
    return equal(0) && equal(1) && equal(2);
}

}  // namespace

TEST_CASE("build_box: corners, sides and what they say") {
    const build_box b = box_of({1, -2, 3}, {2, 4, 3.5f}, 7);
    CHECK((b.low(0) == 1 && b.low(1) == -2 && b.low(2) == 3));
    CHECK((b.high(0) == 2 && b.high(1) == 4 && b.high(2) == 3.5f));
    CHECK((b.extent(0) == 1 && b.extent(1) == 6 && b.extent(2) == 0.5f));
    CHECK(b.half_area() == 6 + 3 + 0.5f);
    CHECK((detail::center2(b, 0) == 3 && detail::center2(b, 1) == 2 && detail::center2(b, 2) == 6.5f));
    CHECK(b.reach() == 4);
    CHECK(box_of({1, -5, 3}, {2, 4, 3.5f}).reach() == 5);
}

TEST_CASE("build_box: the largest axis, the first of equal ones") {
    CHECK(box_of({0, 0, 0}, {3, 2, 1}).largest_axis() == 0);
    CHECK(box_of({0, 0, 0}, {2, 3, 1}).largest_axis() == 1);
    CHECK(box_of({0, 0, 0}, {1, 2, 3}).largest_axis() == 2);
    CHECK(box_of({0, 0, 0}, {3, 2, 4}).largest_axis() == 2);
    CHECK(box_of({0, 0, 0}, {1, 1, 1}).largest_axis() == 0);
    CHECK(box_of({0, 0, 0}, {0, 1, 1}).largest_axis() == 1);
}

TEST_CASE("build_box: an id has any bits, and changes no corner") {
    for (const std::uint32_t id : {0u, 1u, 0x7fc00000u, 0x80000000u, 0xffffffffu}) {  // zeros and NaN among them
        build_box b = box_of({1, 2, 3}, {4, 5, 6}, id);
        CHECK(b.id() == id);
        CHECK(same(b, box_of({1, 2, 3}, {4, 5, 6})));
        b.set_id(~id);
        CHECK(b.id() == ~id);
        CHECK(same(b, box_of({1, 2, 3}, {4, 5, 6})));
        CHECK(same(hull(b, box_of({1, 2, 3}, {7, 5, 6})), box_of({1, 2, 3}, {7, 5, 6})));
    }
}

TEST_CASE("build_box: the hull is the smallest box around both, and a new box has no points") {
    const build_box none, a = box_of({0, 1, 2}, {3, 4, 5}), b = box_of({-1, 2, 1}, {2, 6, 3});
    CHECK(same(hull(a, b), box_of({-1, 1, 1}, {3, 6, 5})));
    CHECK(same(hull(b, a), box_of({-1, 1, 1}, {3, 6, 5})));
    CHECK(same(hull(a, none), a));
    CHECK(same(hull(none, a), a));
    for (unsigned axis = 0; axis < 3; ++axis) CHECK(none.low(axis) > none.high(axis));
}

TEST_CASE_TEMPLATE("rounded_down, rounded_up: the floats on both sides of a number", T, RAIO_NUMBERS) {
    random_numbers random(1);
    const auto check = [](T x) {
        const float low = detail::rounded_down(x), high = detail::rounded_up(x);
        REQUIRE(T(low) <= x);
        REQUIRE(x <= T(high));
        REQUIRE((low == high || std::nextafter(low, infinity<float>) == high));
        REQUIRE((low == high) == (T(static_cast<float>(x)) == x));
    };
    for (int i = 0; i < at_least(10'000); ++i) {
        const T x = static_cast<T>(random.log_uniform(1e-44, 1e38));
        check(x), check(-x), check(static_cast<T>(static_cast<float>(x)));
    }
    for (const T x : {T(0), std::numeric_limits<T>::denorm_min(), std::numeric_limits<T>::max(), infinity<T>}) {
        check(x), check(-x);
    }
}

TEST_CASE("to_build_box: contains what it is made of") {
    random_numbers random(2);
    for (int i = 0; i < at_least(10'000); ++i) {
        aabb<double> of;
        for (int k = 0; k < 2; ++k) of = hull(of, random.direction() * random.log_uniform(1e-3, 1e3));
        const build_box b = detail::to_build_box(of);
        for (unsigned axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<glm::length_t>(axis);
            REQUIRE(b.low(axis) == detail::rounded_down(of.min[at]));
            REQUIRE(b.high(axis) == detail::rounded_up(of.max[at]));
        }
    }
}

TEST_CASE("cells_per_length: the farthest place falls into the last cell, and none beyond") {
    random_numbers random(3);
    for (int i = 0; i < at_least(10'000); ++i) {
        const float extent = static_cast<float>(random.log_uniform(1e-29, 1e30));
        for (const int cells : {16, 1024}) {
            const float scale = detail::cells_per_length(static_cast<float>(cells), extent);
            REQUIRE(static_cast<int>(extent * scale) == cells - 1);
            REQUIRE(static_cast<int>(extent * 0.5001f * scale) == cells / 2);
        }
    }
    for (const float extent : {0.0f, 0x1p-149f, 0x1p-100f, -infinity<float>}) {
        CHECK(detail::cells_per_length(16, extent) == 0);
    }
}

}  // namespace raio::test
