#include <raio/shape/plane.hpp>

#include "support/cases.hpp"
#include "support/planes.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("plane: named cases", T, RAIO_NUMBERS) {
    const plane<T> floor{{0, 0, 0}, {0, 1, 0}};
    const ray<T> down{{3, 2, 1}, {0, -1, 0}};
    check_cases<plane<T>>({
        {"from the front", floor, down, enters(2)},
        {"from the back", floor, {{3, -2, 1}, {0, 1, 0}}, leaves(2)},
        {"behind the ray", floor, {{3, 2, 1}, {0, 1, 0}}, misses},
        {"behind the ray, when the window says so", floor, {{3, 2, 1}, {0, 1, 0}}, leaves(-2), -3},
        {"parallel, outside", floor, {{3, 2, 1}, {1, 0, 0}}, misses},
        {"parallel, outside, on the back", floor, {{3, -2, 1}, {1, -0.0, 0}}, misses},
        {"parallel, in the plane", floor, {{3, 0, 1}, {1, 0, 0}}, misses},
        {"parallel, in the plane, with -0", floor, {{3, -0.0, 1}, {1, -0.0, 0}}, misses},
        {"parallel, in a slanted plane", {{1, 1, 1}, {1, 1, 1}}, {{3, 0, 0}, {1, -1, 0}}, misses},
        {"nearly parallel", floor, {{0, 1, 0}, {1, -0x1p-20, 0}}, enters(0x1p20)},
        {"from a point of the plane", floor, {{3, 0, 1}, {1, 1, 0}}, leaves(0)},
        {"from a point of the plane, downwards", floor, {{3, 0, 1}, {1, -1, 0}}, enters(0)},
        {"slanted", {{0, 0, 3}, {1, 1, 1}}, {{0, 0, 0}, {1, 1, 1}}, leaves(1)},
        {"normal of length 1e20", {{0, 0, 0}, {0, 0x1p66, 0}}, down, enters(2)},
        {"normal of length 1e-20", {{0, 0, 0}, {0, 0x1p-66, 0}}, down, enters(2)},
        {"normal zero", {{0, 0, 0}, {0, 0, 0}}, down, misses},
        {"direction zero", floor, {{3, 2, 1}, {0, 0, 0}}, misses},
        {"direction zero, in the plane", floor, {{3, 0, 1}, {0, 0, 0}}, misses},
        {"window ends at the crossing", floor, down, enters(2), 0, 2},
        {"window begins at the crossing", floor, down, enters(2), 2, 2},
        {"window that is not a number", floor, down, misses, nan<T>, nan<T>},
        // 1 + 2^-24 + 2^-60 lies above the middle between two floats, if only by a bit that a double has no room for.
        {"t rounded once",
         {{1, 0x1p-24, 0x1p-60}, {1, 1, 1}},
         {{0, 0, 0}, {1, 0, 0}},
         leaves(1 + (sizeof(T) == 4 ? 0x1p-23 : 0x1p-24))},
    });
}

TEST_CASE_TEMPLATE("plane: properties of every shape", T, RAIO_NUMBERS) { check_properties<plane<T>>(); }

TEST_CASE_TEMPLATE("plane: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<plane<T>>();
    check_accuracy<plane<T>>(test_rays);
    check_bounds_of_errors<plane<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("plane: uv", T, RAIO_NUMBERS) {
    const plane<T> floor{{10, 0, 10}, {0, 1, 0}};
    const auto uv = [&](T x, T z) {
        hit_record<T> rec{};
        REQUIRE(floor.hit({{x, 5, z}, {0, -1, 0}}, T(0), infinity<T>, rec));
        return rec.uv;
    };
    CHECK(uv(10, 10) == vec2<T>(0, 0));
    for (const T whole : {T(-7), T(1), T(100)}) {
        CHECK(uv(T(10.25), T(10.5)) == uv(T(10.25) + whole, T(10.5)));
        CHECK(uv(T(10.25), T(10.5)) == uv(T(10.25), T(10.5) + whole));
    }
    CHECK(uv(T(10.25), T(10.5)) != uv(T(10.5), T(10.5)));
}

static_assert(plane<double>{{0, 0, 0}, {0, 0, 1}}.occluded({{0.25, 0.25, 5}, {0, 0, -1}}, 0, 9));
static_assert(!plane<float>{{0, 0, 0}, {0, 0, 1}}.occluded({{0.25, 0.25, 5}, {0, 0, -1}}, 0, 4));

}  // namespace raio::test
