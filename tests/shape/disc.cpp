#include <raio/shape/disc.hpp>

#include "support/cases.hpp"
#include "support/discs.hpp"
#include "support/sampling.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("disc: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const disc<T> unit{{0, 0, 0}, {0, 0, 1}, 1}, large{{0, 0, 0}, {0, 0, 1}, 5};
    const ray<T> ahead{{0, 0, 5}, {0, 0, -1}};
    check_cases<disc<T>>({
        {"from the front", unit, ahead, enters(5)},
        {"from the back", unit, {{0, 0.5, -5}, {0, 0, 1}}, leaves(5)},
        {"behind the ray", unit, {{0, 0, 5}, {0, 0, 1}}, misses},
        {"beside the disc", unit, {{1, 1, 5}, {0, 0, -1}}, misses},
        {"on the rim", unit, {{1, 0, 5}, {0, 0, -1}}, enters(5)},
        {"on the rim, between the axes", large, {{3, -4, 5}, {-0.0, 0, -1}}, enters(5)},
        {"on the rim, where t is a third", {{0, 0, 0}, {0, 0, 1}, 3}, {{0, 0, 1}, {9, 0, -3}}, enters(1.0 / 3)},
        {"one number beyond the rim", unit, {{1 + eps, 0, 5}, {0, 0, -1}}, misses},
        {"one number within the rim", unit, {{1 - eps / 2, 0, 5}, {0, 0, -1}}, enters(5)},
        {"in its plane", unit, {{-5, 0, 0}, {1, 0, 0}}, misses},
        {"starts in its plane, and all but runs in it",
         {{-3, 0, -3}, {-1, 1, 0}, 2},
         {{1, 4, 4}, {-0.0, 0x1p-126, 1}},
         misses},
        {"all but in its plane, which it meets 2^99 away",
         {{-3, 3, 0}, {3, -1, 2}, 3},
         {{3, -4, 4}, {-0x1p-96, -2, -1}},
         misses},
        {"in its plane, from inside", unit, {{0, 0, 0}, {1, 0, -0.0}}, misses},
        {"parallel to its plane", unit, {{-5, 0, 1}, {1, 0, 0}}, misses},
        {"from a point of the disc", unit, {{0.5, 0, 0}, {0, 1, 1}}, leaves(0)},
        {"from 2^-155 of its size behind it", {{0, 0, 0}, {0, 0, 1}, 0x1p15}, {{0, 0, -0x1p-140}, {0, 0, -1}}, misses},
        {"normal of length 1e20", {{0, 0, 0}, {0, 0, 0x1p66}, 1}, ahead, enters(5)},
        {"normal of length 1e-20", {{0, 0, 0}, {0, 0, 0x1p-66}, 1}, ahead, enters(5)},
        {"normal zero", {{0, 0, 0}, {0, 0, 0}, 1}, ahead, misses},
        {"radius zero", {{0, 0, 0}, {0, 0, 1}, 0}, ahead, misses},
        {"radius below zero", {{0, 0, 0}, {0, 0, 1}, -1}, ahead, misses},
        {"direction zero", unit, {{0, 0, 0}, {0, 0, 0}}, misses},
        {"window ends at the crossing", unit, ahead, enters(5), 0, 5},
        {"window that is not a number", unit, ahead, misses, nan<T>},
    });
}

TEST_CASE_TEMPLATE("disc: across an axis its points have one coordinate, and no rounding moves them off", T,
                   RAIO_NUMBERS) {
    check_face_across_x(disc<T>{{0, 0, 0}, {2, 0, 0}, 1});
}

TEST_CASE_TEMPLATE("disc: properties of every shape", T, RAIO_NUMBERS) { check_properties<disc<T>>(); }

TEST_CASE_TEMPLATE("disc: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<disc<T>>();
    check_accuracy<disc<T>>(test_rays);
    check_bounds_of_errors<disc<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("disc: area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    CHECK(disc<T>{{1, 2, 3}, {0, 5, 0}, 2}.area() == doctest::Approx(4 * std::numbers::pi));
    const auto to_square = [](const hit_record<T>& rec) { return vec2<T>(rec.uv.x, rec.uv.y * rec.uv.y); };
    check_sampling(disc<T>{{0, 0, 0}, {0, 0, 1}, 1}, to_square);
    check_sampling(disc<T>{{5, -4, 3}, {1, -2, 2}, 3}, to_square);
}

TEST_CASE_TEMPLATE("disc: uv", T, RAIO_NUMBERS) {
    hit_record<T> rec{};
    const disc<T> large{{1, 1, 0}, {0, 0, 1}, 4};
    REQUIRE(large.hit({{1, 1, 5}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK(rec.uv == vec2<T>(0, 0));
    REQUIRE(large.hit({{3, 1, 5}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK(rec.uv.y == T(0.5));
    REQUIRE(large.hit({{1, 5, 5}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK(rec.uv.y == T(1));
}

static_assert(disc<double>{{0, 0, 0}, {0, 0, 1}, 1}.occluded({{0.25, 0.25, 5}, {0, 0, -1}}, 0, 9));
static_assert(!disc<float>{{1, 1, 0}, {0, 0, 1}, 1}.occluded({{0.25, 0.25, 5}, {0, 0, -1}}, 0, 9));

}  // namespace raio::test
