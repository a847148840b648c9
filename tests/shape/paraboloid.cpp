#include <raio/shape/paraboloid.hpp>

#include "support/cases.hpp"
#include "support/paraboloids.hpp"
#include "support/sampling.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("paraboloid: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const paraboloid<T> bowl{{0, 0, 0}, {0, 4, 0}, 2}, lying{{-1, 0, 0}, {8, 0, 0}, 6};  // y = x^2 + z^2
    const ray<T> ahead{{0, 1, 5}, {0, 0, -1}};
    check_cases<paraboloid<T>>({
        {"the side", bowl, ahead, enters(4)},
        {"the side, off the axes", lying, {{0, -9, 0}, {0, 1, 0}}, enters(7)},
        {"behind the ray", bowl, {{0, 1, 5}, {0, 0, 1}}, misses},
        {"from inside to the side", bowl, {{0, 1, 0}, {1, 0, 0}}, leaves(1)},
        {"from inside to the top", bowl, {{0.5, 1, 0}, {0, 1, 0}}, leaves(3)},
        {"from inside to the vertex", bowl, {{0, 1, 0}, {0, -1, 0}}, leaves(1)},
        {"along the axis, from above", bowl, {{0, 9, 0}, {0, -1, 0}}, enters(5)},
        {"along the axis, from below (a = 0)", bowl, {{0, -5, 0}, {0, 1, 0}}, enters(5)},
        {"parallel to the axis (a = 0)", bowl, {{1, -5, 0}, {0, 1, 0}}, enters(6)},
        {"parallel to the axis, later", bowl, {{1, -5, 0}, {0, 1, 0}}, leaves(9), 7},
        {"parallel to the axis, outside", bowl, {{3, -5, 0}, {0, 1, 0}}, misses},
        {"parallel to the axis, at the rim", bowl, {{2, 9, 0}, {0, -1, 0}}, enters(5)},
        {"parallel to the axis, one number beyond the rim", bowl, {{2 + 2 * eps, 9, 0}, {0, -1, 0}}, misses},
        {"one number from parallel", bowl, {{1, -5, 0}, {0x1p-60, 1, 0}}, enters(6)},
        {"in through the side, out through the side", bowl, {{-3, 0, 0}, {2, 1, 0}}, enters(1)},
        {"in through the top, out through the side", bowl, {{0, 6, 0}, {1, -2, 0}}, enters(1)},
        {"tangent to the vertex", bowl, {{-5, 0, 0}, {1, 0, 0}}, enters(5)},
        {"one number below the vertex", bowl, {{-5, -eps, 0}, {1, 0, 0}}, misses},
        {"tangent to the side", bowl, {{0, -1, 0}, {1, 2, 0}}, enters(1)},
        {"one number beyond the tangent", bowl, {{0, -1 - eps, 0}, {1, 2, 0}}, misses},
        {"above the top", bowl, {{0, 5, 5}, {0, 0, -1}}, misses},
        {"along the top", bowl, {{-5, 4, 0}, {1, 0, 0}}, enters(3)},
        {"one number above the top", bowl, {{-5, 4 + 4 * eps, 0}, {1, 0, 0}}, misses},
        {"touches the rim", bowl, {{0, 6, 0}, {1, -1, 0}}, enters(2)},
        {"from the side inwards", bowl, {{1, 1, 0}, {-1, 0, 0}}, enters(0)},
        {"from the side outwards", bowl, {{1, 1, 0}, {1, 0, 0}}, leaves(0)},
        {"from the vertex inwards", bowl, {{0, 0, 0}, {0, 1, 0}}, enters(0)},
        {"1e4 radii away", bowl, {{-20000, 1, 0}, {1, 0, 0}}, enters(19999)},
        {"radius zero", {{0, 0, 0}, {0, 4, 0}, 0}, ahead, misses},
        {"radius below zero", {{0, 0, 0}, {0, 4, 0}, -2}, ahead, misses},
        {"vertex is top", {{0, 0, 0}, {0, 0, 0}, 2}, ahead, misses},
        {"direction zero", bowl, {{0, 1, 0}, {0, 0, 0}}, misses},
        {"first crossing before the window", bowl, ahead, leaves(6), 4.5},
        {"both crossings behind the window", bowl, ahead, misses, 0, 3.5},
        {"window between the crossings", bowl, ahead, misses, 4.5, 5.5},
        {"window that is not a number", bowl, ahead, misses, nan<T>},
    });
}

TEST_CASE("paraboloid: its vertex and its rim, from far away (beyond the bounds)") {
    check_cases<paraboloid<double>>({{"along its axis",
                                      {{0, 0, 0}, {0, 0, -0x1.b2172a9c68c62p-5}, 0x1.07d8ca2e8511ep-13},
                                      {{0x1.fedcabb4d158p-5, 0x1.802bc54c602bdp-5, 0x1.ef2365714ce9ep+4},
                                       {-0x1.fedcabb4c804dp-5, -0x1.802bc54c6a081p-5, -0x1.ef2365714ce5cp+4}},
                                      enters(0x1.0000000000022p+0)},
                                     {"across",
                                      {{-0x1.1990463fba2f2p-5, 0x1.1112cba9842d7p-4, 0x1.95dfc7677970fp-4},
                                       {0x1.5c834588d405ep-6, 0x1.1112cba9842d7p-4, 0x1.95dfc7677970fp-4},
                                       0x1.13b8a54af6c22p-13},
                                      {{-0x1.14684e3b2cd0fp+4, 0x1.472cf1fd1c08ap-4, 0x1.22f6f4418dd98p-4},
                                       {0x1.13db86180cf3ep+4, -0x1.b0d1329cbed98p-7, 0x1.cba34c97ae5dcp-6}},
                                      enters(0x1.fffffffffffffp-1)}});
}

TEST_CASE_TEMPLATE("paraboloid: properties of every shape", T, RAIO_NUMBERS) { check_properties<paraboloid<T>>(); }

TEST_CASE_TEMPLATE("paraboloid: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<paraboloid<T>>();
    check_accuracy<paraboloid<T>>(test_rays);
    check_bounds_of_errors<paraboloid<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("open_paraboloid: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const open_paraboloid<T> dish{{0, 0, 0}, {0, 4, 0}, 2};
    const ray<T> ahead{{0, 1, 5}, {0, 0, -1}};
    check_cases<open_paraboloid<T>>({
        {"the side", dish, ahead, enters(4)},
        {"into the dish", dish, {{1, 9, 0}, {0, -1, 0}}, leaves(8)},
        {"along the axis, from above", dish, {{0, 9, 0}, {0, -1, 0}}, leaves(9)},
        {"along the axis, from below, and out", dish, {{0, -5, 0}, {0, 1, 0}}, misses, 6},
        {"tangent to the vertex", dish, {{-5, 0, 0}, {1, 0, 0}}, enters(5)},
        {"along the rim", dish, {{-5, 4, 0}, {1, 0, 0}}, enters(3)},
        {"one number above the rim", dish, {{-5, 4 + 4 * eps, 0}, {1, 0, 0}}, misses},
        {"onto the rim from within", dish, {{-2, 8, 0}, {1, -1, 0}}, leaves(4)},
        {"past a flat one, and through the surface above the rim",
         {{0, 0, 0}, {0, 0.125, 0.125}, 6},
         {{0, -3.5, -10.5}, {-2.75, 0, 2}},
         misses},
        {"radius zero", {{0, 0, 0}, {0, 4, 0}, 0}, ahead, misses},
        {"vertex is top", {{0, 0, 0}, {0, 0, 0}, 2}, ahead, misses},
        {"direction zero", dish, {{0, 1, 0}, {0, 0, 0}}, misses},
        {"first crossing before the window", dish, ahead, leaves(6), 4.5},
        {"window that is not a number", dish, ahead, misses, nan<T>},
    });
}

TEST_CASE_TEMPLATE("open_paraboloid: properties of every shape", T, RAIO_NUMBERS) {
    check_properties<open_paraboloid<T>>();
}

TEST_CASE_TEMPLATE("open_paraboloid: from a point of the surface, in any direction (many doubles did not start there)",
                   T, RAIO_NUMBERS) {
    check_starts_on_surface([](random_numbers& random) {
        const T r = static_cast<T>(random.uniform(1, 2)), h = static_cast<T>(random.uniform(1, 2));
        return std::pair(open_paraboloid<T>{{0, 0, 0}, {0, 0, h}, r}, vec3<T>(r / 2, 0, h / 4));
    });
}

TEST_CASE_TEMPLATE("open_paraboloid: as exact arithmetic", T, RAIO_NUMBERS) {
    check_accuracy<open_paraboloid<T>>(test_rays, 1.0 / 200);
    check_bounds_of_errors<open_paraboloid<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("paraboloid: area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    const double pi = std::numbers::pi;
    CHECK(open_paraboloid<T>{{1, 2, 3}, {1, 2, 5}, 3}.area() == doctest::Approx(49 * pi / 4));  // of a 3, 4, 5
    CHECK(paraboloid<T>{{1, 2, 3}, {1, 2, 5}, 3}.area() == doctest::Approx(49 * pi / 4 + 9 * pi));
    CHECK(open_paraboloid<T>{{0, 0, 0}, {0, 0, T(1e-6)}, 3}.area() == doctest::Approx(9 * pi));  // a disc
    // Of the 49 / 4 of the side, times pi, as much is below a height of h.
    const auto below = [](T h) { return T((std::pow(9 + 16 * double(h), 1.5) / 27 - 1) * 27 / 98); };
    check_sampling(open_paraboloid<T>{{1, 2, 3}, {1, 2, 5}, 3},
                   [&](const hit_record<T>& rec) { return vec2<T>(rec.uv.x, below(rec.uv.y)); });
    check_sampling(paraboloid<T>{{1, 2, 3}, {1, 2, 5}, 3}, [&](const hit_record<T>& rec) {
        const bool cap = rec.normal.z > T(0.5);
        return vec2<T>(rec.uv.x, cap ? (49 + 36 * rec.uv.y * rec.uv.y) / 85 : below(rec.uv.y) * 49 / 85);
    });
    const surface_sample<T> flat = open_paraboloid<T>{{0, 0, 0}, {0, 0, T(1e-6)}, 3}.sample({0, T(0.25)});
    CHECK(length(vec3<T>(flat.point)) == doctest::Approx(1.5));
}

TEST_CASE_TEMPLATE("paraboloid: bounds are tight", T, RAIO_NUMBERS) {
    const aabb<T> box = paraboloid<T>{{0, 0, 0}, {0, 3, 4}, 1}.bounds();
    CHECK(box.min.x == doctest::Approx(-1));
    CHECK(box.max.y == doctest::Approx(3.8));
    CHECK(box.min.y == doctest::Approx(-0.64 / 12));
    CHECK(box.max.z == doctest::Approx(4.6));
    CHECK(box.min.z == doctest::Approx(-0.36 / 16));
}

TEST_CASE_TEMPLATE("paraboloid: uv and normal", T, RAIO_NUMBERS) {
    const paraboloid<T> bowl{{0, 0, 0}, {0, 0, 4}, 2};
    const auto hit = [&](const ray<T>& ray) {
        hit_record<T> rec{};
        REQUIRE(bowl.hit(ray, T(0), infinity<T>, rec));
        return rec;
    };
    CHECK(hit({{9, 0, 1}, {-1, 0, 0}}).uv == vec2<T>(0, 0.25));
    CHECK(hit({{0, 1, -9}, {0, 0, 1}}).uv == vec2<T>(0.25, 0.25));
    CHECK(hit({{-1, 0, 9}, {0, 0, -1}}).uv == vec2<T>(0.5, 0.5));
    CHECK(hit({{0, 0, -9}, {0, 0, 1}}).uv.y == T(0));
    CHECK(hit({{0, 0, -9}, {0, 0, 1}}).normal == vec3<T>(0, 0, -1));
    const T root = T(std::sqrt(0.2));  // the gradient is (2 x, 2 y, -1)
    CHECK(length(hit({{9, 0, 1}, {-1, 0, 0}}).normal - vec3<T>(2 * root, 0, -root)) <
          2 * std::numeric_limits<T>::epsilon());
}

}  // namespace raio::test
