#include <raio/shape/ring.hpp>

#include "support/cases.hpp"
#include "support/rings.hpp"
#include "support/sampling.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("ring: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const ring<T> unit{{0, 0, 0}, {0, 0, 1}, 0.5, 1}, large{{0, 0, 0}, {0, 0, 1}, 5, 13};
    const ray<T> ahead{{0.75, 0, 5}, {0, 0, -1}}, through{{0, 0, 5}, {0, 0, -1}};
    check_cases<ring<T>>({
        {"from the front", unit, ahead, enters(5)},
        {"from the back", unit, {{0, 0.75, -5}, {0, 0, 1}}, leaves(5)},
        {"behind the ray", unit, {{0.75, 0, 5}, {0, 0, 1}}, misses},
        {"through the hole", unit, through, misses},
        {"through the hole, off the centre", unit, {{0.25, 0.25, 5}, {0, 0, -1}}, misses},
        {"starts in its plane, and all but runs in it",
         {{-3, 0, -3}, {-1, 1, 0}, 1, 2},
         {{1, 4, 4}, {-0.0, 0x1p-126, 1}},
         misses},
        {"all but in its plane, through the hole",
         {{-3, 0, -3}, {-1, 1, 0}, 10, 12},
         {{1, 4, 4}, {-0.0, 0x1p-126, 1}},
         misses},
        {"beside the ring", unit, {{1, 1, 5}, {0, 0, -1}}, misses},
        {"on the outer rim", unit, {{1, 0, 5}, {0, 0, -1}}, enters(5)},
        {"on the inner rim", unit, {{0, 0.5, 5}, {0, 0, -1}}, enters(5)},
        {"on the outer rim, between the axes", large, {{5, -12, 5}, {-0.0, 0, -1}}, enters(5)},
        {"on the inner rim, between the axes", large, {{3, -4, 5}, {-0.0, 0, -1}}, enters(5)},
        {"on the inner rim, where t is a third",
         {{0, 0, 0}, {0, 0, 1}, 3, 4},
         {{0, 0, 1}, {9, 0, -3}},
         enters(1.0 / 3)},
        {"one number beyond the outer rim", unit, {{1 + eps, 0, 5}, {0, 0, -1}}, misses},
        {"one number within the inner rim", unit, {{T(0.5) - eps / 4, 0, 5}, {0, 0, -1}}, misses},
        {"one number beyond the inner rim", unit, {{T(0.5) + eps / 2, 0, 5}, {0, 0, -1}}, enters(5)},
        {"inner radius zero: a disc, its centre", {{0, 0, 0}, {0, 0, 1}, 0, 1}, through, enters(5)},
        {"inner radius zero, beside the centre", {{0, 0, 0}, {0, 0, 1}, 0, 1}, ahead, enters(5)},
        {"inner radius like the outer one", {{0, 0, 0}, {0, 0, 1}, 0.75, 0.75}, ahead, misses},
        {"inner radius above the outer one", {{0, 0, 0}, {0, 0, 1}, 1, 0.5}, ahead, misses},
        {"inner radius below zero", {{0, 0, 0}, {0, 0, 1}, -1, 1}, ahead, misses},
        {"both radii zero", {{0, 0, 0}, {0, 0, 1}, 0, 0}, through, misses},
        {"in its plane", unit, {{-5, 0, 0}, {1, 0, 0}}, misses},
        {"in its plane, from inside", unit, {{0.75, 0, 0}, {1, 0, -0.0}}, misses},
        {"parallel to its plane", unit, {{-5, 0, 1}, {1, 0, 0}}, misses},
        {"from a point of the ring", unit, {{0.75, 0, 0}, {0, 1, 1}}, leaves(0)},
        {"normal of length 1e20", {{0, 0, 0}, {0, 0, 0x1p66}, 0.5, 1}, ahead, enters(5)},
        {"normal of length 1e-20", {{0, 0, 0}, {0, 0, 0x1p-66}, 0.5, 1}, ahead, enters(5)},
        {"normal zero", {{0, 0, 0}, {0, 0, 0}, 0.5, 1}, ahead, misses},
        {"direction zero", unit, {{0.75, 0, 0}, {0, 0, 0}}, misses},
        {"window ends at the crossing", unit, ahead, enters(5), 0, 5},
        {"window that is not a number", unit, ahead, misses, nan<T>},
    });
}

TEST_CASE_TEMPLATE("ring: properties of every shape", T, RAIO_NUMBERS) { check_properties<ring<T>>(); }

TEST_CASE_TEMPLATE("ring: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<ring<T>>();
    check_accuracy<ring<T>>(test_rays);
    check_bounds_of_errors<ring<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("ring: area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    const ring<T> flat{{5, -4, 3}, {1, -2, 2}, 1, 3};
    CHECK(flat.area() == doctest::Approx(8 * std::numbers::pi));
    check_sampling(flat, [](const hit_record<T>& rec) {
        const T rho = 1 + 2 * rec.uv.y;
        return vec2<T>(rec.uv.x, (rho * rho - 1) / 8);
    });
}

TEST_CASE_TEMPLATE("ring: uv", T, RAIO_NUMBERS) {
    hit_record<T> rec{};
    const ring<T> flat{{1, 1, 0}, {0, 0, 1}, 2, 4};
    for (const auto& [x, v] : {std::pair<T, T>{3, 0}, {4, 0.5}, {5, 1}}) {
        REQUIRE(flat.hit({{x, 1, 5}, {0, 0, -1}}, T(0), infinity<T>, rec));
        CHECK((rec.uv.y == v && rec.uv.x == T(0)));
    }
}

}  // namespace raio::test
