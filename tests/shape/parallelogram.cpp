#include <raio/shape/parallelogram.hpp>

#include "support/cases.hpp"
#include "support/parallelograms.hpp"
#include "support/sampling.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("parallelogram: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon(), tiny = T(0x1p-40);
    const parallelogram<T> unit{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, slanted{{0, 0, 0}, {1, 2, 3}, {3, 1, 2}};
    const auto from = [](T x, T y) { return ray<T>{{x, y, 5}, {0, 0, -1}}; };
    const ray<T> ahead = from(0.75, 0.75);
    check_cases<parallelogram<T>>({
        {"from the front", unit, ahead, enters(5)},
        {"from the back", unit, {{0.75, 0.75, -5}, {0, 0, 1}}, leaves(5)},
        {"edges exchanged", {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, ahead, leaves(5)},
        {"an edge turned around", {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}}, ahead, leaves(5)},
        {"behind the ray", unit, {{0.75, 0.75, 5}, {0, 0, 1}}, misses},
        {"from one of its points", unit, {{0.75, 0.75, 0}, {0, 1, 1}}, leaves(0)},
        {"on the corner", unit, from(0, 0), enters(5)},
        {"on the corner along u", unit, from(1, 0), enters(5)},
        {"on the corner along v", unit, from(0, 1), enters(5)},
        {"on the corner opposite", unit, from(1, 1), enters(5)},
        {"on edge v = 0", unit, from(0.5, 0), enters(5)},
        {"on edge v = 1", unit, from(0.5, 1), enters(5)},
        {"on edge u = 0", unit, from(0, 0.5), enters(5)},
        {"on edge u = 1", unit, from(1, 0.5), enters(5)},
        {"on the corner opposite, where t is a third", unit, {{0, 0, 1}, {3, 3, -3}}, enters(1.0 / 3)},
        {"on the corner opposite, slanted", slanted, {{4, 3, 9}, {0, 0, -1}}, leaves(4)},
        {"by a hair beyond v = 0", unit, from(0.5, -0x1p-80), misses},
        {"by a hair beyond u = 0", unit, from(-0x1p-80, 0.5), misses},
        {"one number beyond v = 1", unit, from(0.5, 1 + eps), misses},
        {"one number beyond u = 1", unit, from(1 + eps, 0.5), misses},
        {"one number within u = 1", unit, from(1 - eps / 2, 0.5), enters(5)},
        {"beside it, within both widths", {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}}, from(0.25, 0.5), misses},
        {"in its plane", unit, {{-5, 0.5, 0}, {1, 0, 0}}, misses},
        {"in its plane, along an edge", unit, {{-5, 0, 0}, {1, 0, -0.0}}, misses},
        {"in its slanted plane", slanted, {{5, 5, 7}, {-4, -3, -5}}, misses},
        {"in its slanted plane, from a corner", slanted, {{0, 0, 0}, {4, 3, 5}}, misses},
        {"parallel to its plane", unit, {{-5, 0.5, 1}, {1, 0, 0}}, misses},
        {"of the size of an atom", {{0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}}, from(tiny / 2, tiny), enters(5)},
        {"as slim as an atom", {{0, 0, 0}, {1, 0, 0}, {0, tiny, 0}}, from(0.5, tiny / 2), enters(5)},
        {"beside the slim one", {{0, 0, 0}, {1, 0, 0}, {0, tiny, 0}}, from(0.5, tiny * 2), misses},
        {"edges in a line", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, from(0.5, 0), misses},
        {"edges in a slanted line", {{0, 0, 0}, {1, 3, 7}, {3, 9, 21}}, {{1, 3, 12}, {0, 0, -1}}, misses},
        {"an edge of length zero", {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}, from(0.5, 0), misses},
        {"direction zero", unit, {{0.25, 0.25, 0}, {0, 0, 0}}, misses},
        {"direction of length 1e-20", unit, {{0.25, 0.25, 5}, {0, 0, -0x1p-66}}, enters(5 * 0x1p66)},
        {"direction of length 1e20", unit, {{0.25, 0.25, 5}, {0, 0, -0x1p66}}, enters(5 * 0x1p-66)},
        {"window ends at the crossing", unit, ahead, enters(5), 0, 5},
        {"window that is not a number", unit, ahead, misses, nan<T>},
    });
}

TEST_CASE_TEMPLATE("parallelogram: properties of every shape", T, RAIO_NUMBERS) {
    check_properties<parallelogram<T>>();
}

TEST_CASE_TEMPLATE("parallelogram: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<parallelogram<T>>();
    check_accuracy<parallelogram<T>>(test_rays, 1e-3, 16);
    check_bounds_of_errors<parallelogram<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("parallelogram: area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    CHECK(parallelogram<T>{{1, 1, 1}, {3, 0, 0}, {5, 4, 0}}.area() == T(12));
    const auto to_square = [](const hit_record<T>& rec) { return rec.uv; };
    check_sampling(parallelogram<T>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, to_square);
    check_sampling(parallelogram<T>{{1, 2, 3}, {3, -2, 4}, {-4, -1, -2}}, to_square);
}

TEST_CASE_TEMPLATE("parallelogram: uv", T, RAIO_NUMBERS) {
    hit_record<T> rec{};
    const parallelogram<T> wide{{1, 1, 1}, {4, 0, 0}, {4, 2, 0}};
    REQUIRE(wide.hit({{5, 2, 9}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK(rec.uv == vec2<T>(0.5, 0.5));
    REQUIRE(wide.hit({{2, 1, 9}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK(rec.uv == vec2<T>(0.25, 0));
}

static_assert(parallelogram<double>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}.occluded({{0.75, 0.75, 5}, {0, 0, -1}}, 0, 9));
static_assert(!parallelogram<float>{{1, 0, 0}, {1, 0, 0}, {0, 1, 0}}.occluded({{0.75, 0.75, 5}, {0, 0, -1}}, 0, 9));

}  // namespace raio::test
