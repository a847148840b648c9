#include <raio/shape/capsule.hpp>

#include "support/capsules.hpp"
#include "support/cases.hpp"
#include "support/sampling.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("capsule: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const capsule<T> unit{{0, -1, 0}, {0, 1, 0}, 1}, wide{{0, 0, 0}, {0, 0, 4}, 5};
    const ray<T> ahead{{0, 0, 5}, {0, 0, -1}};
    check_cases<capsule<T>>({
        {"the side", unit, ahead, enters(4)},
        {"the side, off the axis", wide, {{-10, 3, 1}, {1, 0, 0}}, enters(6)},
        {"behind the ray", unit, {{0, 0, 5}, {0, 0, 1}}, misses},
        {"from inside to the side", unit, {{0, 0.5, 0}, {1, 0, 0}}, leaves(1)},
        {"from inside to the pole", unit, {{0, 0.5, 0}, {0, 1, 0}}, leaves(1.5)},
        {"the pole, along the axis", unit, {{0, 5, 0}, {0, -1, 0}}, enters(3)},
        {"the lower pole, along the axis", unit, {{0, -5, 0}, {0, 1, 0}}, enters(3)},
        {"in at one pole, out at the other", unit, {{0, 5, 0}, {0, -1, 0}}, leaves(7), 3.5},
        {"a round end, parallel to the axis", wide, {{3, 0, 99}, {0, 0, -1}}, enters(91)},
        {"a round end, across the axis", wide, {{-9, 0, 8}, {1, 0, 0}}, enters(6)},
        {"across the middle of an end, inside the sphere of the other", wide, {{-9, 0, 4}, {1, 0, 0}}, enters(4)},
        {"on the seam", unit, {{5, 1, 0}, {-1, 0, 0}}, enters(4)},
        {"on the seam, obliquely", unit, {{3, 3, 0}, {-1, -1, 0}}, enters(2)},
        {"in through an end, out through the side", unit, {{-1, 3, 0}, {1, -1, 0}}, leaves(2), 1.5},
        {"parallel to the axis, outside", unit, {{2, 5, 0}, {0, -1, 0}}, misses},
        {"parallel to the axis, in the surface", unit, {{1, 5, 0}, {0, -1, 0}}, enters(4)},
        {"parallel to the axis, one number beyond the surface", unit, {{1 + eps, 5, 0}, {0, -1, 0}}, misses},
        {"tangent to the side", unit, {{1, 0, 5}, {0, 0, -1}}, enters(5)},
        {"one number beyond the tangent", unit, {{1 + eps, 0, 5}, {0, 0, -1}}, misses},
        {"tangent to the pole", unit, {{-5, 2, 0}, {1, 0, 0}}, enters(5)},
        {"over the pole", unit, {{-5, 2 + 2 * eps, 0}, {1, 0, 0}}, misses},
        {"from the side inwards", unit, {{1, 0, 0}, {-1, 0, 0}}, enters(0)},
        {"from the side outwards", unit, {{1, 0, 0}, {1, 0, 0}}, leaves(0)},
        {"base is top: a sphere", {{0, 0, 0}, {0, 0, 0}, 1}, ahead, enters(4)},
        {"base and top exchanged", {{0, 1, 0}, {0, -1, 0}, 1}, {{0, 5, 0}, {0, -1, 0}}, enters(3)},
        {"radius zero", {{0, -1, 0}, {0, 1, 0}, 0}, ahead, misses},
        {"radius below zero", {{0, -1, 0}, {0, 1, 0}, -1}, ahead, misses},
        {"direction zero", unit, {{0, 0, 0}, {0, 0, 0}}, misses},
        {"first crossing before the window", unit, ahead, leaves(6), 4.5},
        {"window between the crossings", unit, ahead, misses, 4.5, 5.5},
        {"window that is not a number", unit, ahead, misses, nan<T>},
    });
}

TEST_CASE_TEMPLATE("capsule: properties of every shape", T, RAIO_NUMBERS) { check_properties<capsule<T>>(); }

TEST_CASE_TEMPLATE("capsule: from a point of the surface, in any direction (many doubles did not start there)", T,
                   RAIO_NUMBERS) {
    check_starts_on_surface([](random_numbers& random) {
        const T r = static_cast<T>(random.uniform(1, 2)), h = static_cast<T>(random.uniform(1, 2));
        return std::pair(capsule<T>{{0, 0, 0}, {0, 0, h}, r},
                         vec3<T>(r, 0, h * static_cast<T>(random.uniform(0.1, 0.9))));
    });
}

TEST_CASE_TEMPLATE("capsule: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<capsule<T>>();
    check_accuracy<capsule<T>>(test_rays);
    check_bounds_of_errors<capsule<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("capsule: area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    const capsule<T> pill{{1, 2, 3}, {3, 3, 5}, 2};  // 3 + 2 * 2 high
    CHECK(pill.area() == doctest::Approx(28 * std::numbers::pi));
    check_sampling(pill, [](const hit_record<T>& rec) { return rec.uv; });
    check_sampling(capsule<T>{{1, 2, 3}, {1, 2, 3}, 2}, [](const hit_record<T>& rec) { return rec.uv; });
}

TEST_CASE_TEMPLATE("capsule: uv", T, RAIO_NUMBERS) {
    const capsule<T> pill{{0, 0, 0}, {0, 0, 2}, 1};
    const auto v = [&](const ray<T>& ray) {
        hit_record<T> rec{};
        REQUIRE(pill.hit(ray, T(0), infinity<T>, rec));
        return rec.uv.y;
    };
    CHECK(v({{0, 0, -9}, {0, 0, 1}}) == T(0));
    CHECK(v({{9, 0, 0}, {-1, 0, 0}}) == T(0.25));
    CHECK(v({{9, 0, 1}, {-1, 0, 0}}) == T(0.5));
    CHECK(v({{9, 0, 2}, {-1, 0, 0}}) == T(0.75));
    CHECK(v({{0, 0, 9}, {0, 0, -1}}) == T(1));
}

}  // namespace raio::test
