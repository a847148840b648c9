#include <raio/shape/ellipsoid.hpp>

#include "support/cases.hpp"
#include "support/ellipsoids.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("ellipsoid: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const ellipsoid<T> egg{{0, 0, 0}, {3, 2, 1}}, needle{{0, 0, 0}, {1, T(1e4), 1}},
        plate{{1, 2, 3}, {4, T(0x1p-13), 4}};
    const ray<T> ahead{{0, 0, 5}, {0, 0, -1}};
    check_cases<ellipsoid<T>>({
        {"along the shortest axis", egg, ahead, enters(4)},
        {"along the middle axis", egg, {{0, 5, 0}, {0, -1, 0}}, enters(3)},
        {"along the longest axis", egg, {{5, 0, 0}, {-1, 0, 0}}, enters(2)},
        {"along the longest axis, later", egg, {{5, 0, 0}, {-1, 0, 0}}, leaves(8), 4},
        {"behind the ray", egg, {{0, 0, 5}, {0, 0, 1}}, misses},
        {"from the centre", egg, {{0, 0, 0}, {0, 1, 0}}, leaves(2)},
        {"from inside", egg, {{1, 0, 0}, {1, 0, 0}}, leaves(2)},
        {"from the surface inwards", egg, {{3, 0, 0}, {-1, 0, 0}}, enters(0)},
        {"from the surface outwards", egg, {{3, 0, 0}, {1, 0, 0}}, leaves(0)},
        {"from the surface outwards, later", egg, {{3, 0, 0}, {1, 0, 0}}, misses, 0x1p-60},
        {"tangent", egg, {{3, 0, 5}, {0, 0, -1}}, enters(5)},
        {"one number beyond the tangent", egg, {{3 + 2 * eps, 0, 5}, {0, 0, -1}}, misses},
        {"direction of length 2", egg, {{0, 0, 5}, {0, 0, -2}}, enters(2)},
        {"needle, from the side", needle, {{5, 0, 0}, {-1, 0, 0}}, enters(4)},
        {"needle, along its length", needle, {{0, 2e4, 0}, {0, -1, 0}}, enters(1e4)},
        {"needle, tangent along its length", needle, {{1, 2e4, 0}, {0, -1, 0}}, enters(2e4)},
        {"needle, one number beyond", needle, {{1 + eps, 2e4, 0}, {0, -1, 0}}, misses},
        {"plate, from above", plate, {{1, 9, 3}, {0, -1, 0}}, enters(7 - 0x1p-13)},
        {"plate, from its edge", plate, {{9, 2, 3}, {-1, 0, 0}}, enters(4)},
        {"equal radii: a sphere", {{0, 0, 0}, {1, 1, 1}}, ahead, enters(4)},
        {"a radius zero", {{0, 0, 0}, {1, 0, 1}}, ahead, misses},
        {"two radii below zero", {{0, 0, 0}, {-1, -1, 1}}, ahead, misses},
        {"direction zero", egg, {{0, 0, 0}, {0, 0, 0}}, misses},
        {"first crossing before the window", egg, ahead, leaves(6), 4.5},
        {"window between the crossings", egg, ahead, misses, 4.5, 5.5},
        {"window that is not a number", egg, ahead, misses, nan<T>},
    });
}

TEST_CASE("ellipsoid: from its end outwards (the comparison said that it starts 1e-46 sizes off)") {
    check_cases<ellipsoid<float>>({{"of a sphere",
                                    {{0, 0, 0}, {0x1.48bf52p+19f, 0x1.48bf52p+19f, 0x1.48bf52p+19f}},
                                    {{0x1.48bf52p+19f, 0, 0}, {0x1.17b45ep-4f, 0x1.ee37bcp-1f, -0x1.023a66p-2f}},
                                    leaves(0)}});
}

TEST_CASE("ellipsoid: where it touches its bounds, from far away (beyond them)") {
    check_cases<ellipsoid<double>>({
        {"30,000 sizes",
         {{0, 0, 0}, {0x1.4aa9c8bf6f51ep-9, 0x1.863cecf94b4a3p-19, 0x1.884a1ff776727p-8}},
         {{0x1.bc0458b8c9733p+4, 0x1.19697a0cfb2c9p+11, -0x1.39305c0e5b73bp+8},
          {-0x1.bc0458b8c9733p+4, -0x1.19697a06e238ep+11, 0x1.39305c0e5b73bp+8}},
         enters(1)},
    });
}

TEST_CASE_TEMPLATE("ellipsoid: properties of every shape", T, RAIO_NUMBERS) { check_properties<ellipsoid<T>>(); }

TEST_CASE_TEMPLATE("ellipsoid: from a point of the surface, in any direction (many doubles did not start there)", T,
                   RAIO_NUMBERS) {
    check_starts_on_surface([](random_numbers& random) {
        const T r = static_cast<T>(random.uniform(1, 2)), h = static_cast<T>(random.uniform(1, 2));
        return std::pair(ellipsoid<T>{{0, 0, 0}, {h, r, 3}}, vec3<T>(0, r, 0));
    });
}

TEST_CASE_TEMPLATE("ellipsoid: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<ellipsoid<T>>();
    check_accuracy<ellipsoid<T>>(test_rays);
    check_bounds_of_errors<ellipsoid<T>>(test_rays / 20);
}

TEST_CASE("ellipsoid: a point at the origin is off by what the rounded normal is turned by") {
    for (const vec3<float>& radii :
         {vec3<float>(8, 4, 1), {8, 1, 4}, {4, 8, 1}, {4, 1, 8}, {1, 8, 4}, {1, 4, 8}, {8, 8, 1}, {1, 1, 8}}) {
        const ellipsoid<float> some{{0, 0, radii.z}, radii};
        hit_record<float> rec{};
        REQUIRE(some.hit({{0, 0, -1}, {0, 0, 1}}, 0.0f, infinity<float>, rec));
        const float turned = 4 * 0x1p-48f * 8 * (8 / 1.0f);
        CHECK((rec.error.x >= turned && rec.error.x <= 2 * turned));
    }
}

TEST_CASE_TEMPLATE("ellipsoid: uv and normal", T, RAIO_NUMBERS) {
    const ellipsoid<T> egg{{1, 2, 3}, {3, 2, 1}};
    const auto hit = [&](const vec3<T>& from) {
        hit_record<T> rec{};
        REQUIRE(egg.hit({egg.center + from, -from}, T(0), infinity<T>, rec));
        return rec;
    };
    CHECK(hit({9, 0, 0}).uv == vec2<T>(0, 0.5));
    CHECK(hit({0, 0, -9}).uv == vec2<T>(0.25, 0.5));
    CHECK(hit({0, 9, 0}).uv.y == T(1));
    CHECK(hit({0, -9, 0}).uv.y == T(0));
    CHECK(hit({0, 9, 0}).normal == vec3<T>(0, 1, 0));
    // (3, 2, 0) is on the diagonal of the sphere; the gradient there is (1 / 3, 1 / 2, 0).
    CHECK(length(hit({3, 2, 0}).normal - normalize(vec3<T>(2, 3, 0))) < 4 * std::numeric_limits<T>::epsilon());
    CHECK(hit({3, 2, 0}).uv.y == doctest::Approx(0.75));
}

}  // namespace raio::test
