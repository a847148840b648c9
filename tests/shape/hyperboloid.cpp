#include <raio/shape/hyperboloid.hpp>

#include "support/cases.hpp"
#include "support/hyperboloids.hpp"
#include "support/packs.hpp"
#include "support/touching.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("hyperboloid: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const hyperboloid<T> tower{{0, -1, 0}, {0, 1, 0}, 3, 5};  // rho^2 = 9 + 16 y^2
    const hyperboloid<T> barrel{{0, -1, 0}, {0, 1, 0}, 5, 3}, even{{0, -1, 0}, {0, 1, 0}, 2, 2};
    const ray<T> ahead{{0, 0, 9}, {0, 0, -1}}, beside{{2, -3, 3}, {0, 1, 0}};
    check_cases<hyperboloid<T>>({
        {"the waist", tower, ahead, enters(6)},
        {"the waist, from within", tower, {{0, 0, 0}, {0, 0, -1}}, leaves(3)},
        {"behind the ray", tower, {{0, 0, 9}, {0, 0, 1}}, misses},
        {"along the axis", tower, {{0, -3, 0}, {0, 1, 0}}, enters(2)},
        {"along the axis, later", tower, {{0, -3, 0}, {0, 1, 0}}, leaves(4), 2.5},
        {"beside the waist, four crossings, the first", tower, beside, enters(2)},
        {"beside the waist, the second", tower, beside, leaves(2.5), 2.25},
        {"beside the waist, the third", tower, beside, enters(3.5), 3},
        {"beside the waist, the last", tower, beside, leaves(4), 3.75},
        {"beside the waist, between", tower, beside, misses, 2.75, 3.25},
        {"beside both ends", tower, {{6, -3, 0}, {0, 1, 0}}, misses},
        {"parallel to the axis, at the rims", tower, {{5, -3, 0}, {0, 1, 0}}, enters(2)},
        {"tangent to the waist", tower, {{3, 0, 9}, {0, 0, -1}}, enters(9)},
        {"one number beyond the tangent, onto the flank", tower, {{3 + 2 * eps, 0, 9}, {0, 0, -1}}, misses},
        {"touches the waist from within", tower, {{3, -3, 0}, {0, 1, 0}}, leaves(3), 2.5},
        {"along a generator", tower, {{3, -2, -8}, {0, 1, 4}}, enters(1)},
        {"along a generator, later", tower, {{3, -2, -8}, {0, 1, 4}}, leaves(3), 2},
        {"asymptotic, through the centre (a = 0)", tower, {{0, -2, -8}, {0, 1, 4}}, enters(1)},
        {"asymptotic, beside the centre (a = 0)", tower, {{0, -2, -7}, {0, 1, 4}}, leaves(3), 2},
        {"asymptotic, outside", tower, {{4, -2, -8}, {0, 1, 4}}, misses},
        {"along the base", tower, {{-9, -1, 0}, {1, 0, 0}}, enters(4)},
        {"one number above the top", tower, {{-9, 1 + eps, 0}, {1, 0, 0}}, misses},
        {"from the waist inwards", tower, {{3, 0, 0}, {-1, 0, 0}}, enters(0)},
        {"from the waist outwards", tower, {{3, 0, 0}, {1, 0, 0}}, leaves(0)},
        {"a bulge", barrel, ahead, enters(4)},
        {"a bulge, along the axis", barrel, {{0, -3, 0}, {0, 1, 0}}, enters(2)},
        {"equal radii, the side", even, ahead, enters(7)},
        {"equal radii, parallel to the axis, on the surface", even, {{2, -3, 0}, {0, 1, 0}}, enters(2)},
        {"waist radius zero", {{0, -1, 0}, {0, 1, 0}, 0, 5}, ahead, misses},
        {"end radius below zero", {{0, -1, 0}, {0, 1, 0}, 3, -5}, ahead, misses},
        {"base is top", {{0, 0, 0}, {0, 0, 0}, 3, 5}, ahead, misses},
        {"direction zero", tower, {{0, 0, 0}, {0, 0, 0}}, misses},
        {"window that is not a number", tower, ahead, misses, nan<T>},
    });
}

TEST_CASE("hyperboloid: where it is widest, from far away (beyond the bounds)") {
    check_cases<hyperboloid<double>>(
        {{"along its axis",
          {{0, 0, 0}, {-0x1.7cbc082d12feep-5, 0, 0}, 0x1.8619dd62c7405p-15, 0x1.438e0e65771bep-16},
          {{0x1.679e630f6307ep+8, -0x1.d22e092a206ecp+4, -0x1.25677235456f7p+2},
           {-0x1.67a455ff70d79p+8, 0x1.d22e092a206d1p+4, 0x1.2566af2856c06p+2}},
          enters(0x1.fffffffffffbfp-1)},
         {"across",
          {{0, 0, 0}, {0, 0, -0x1.04361396c2419p-5}, 0x1.aa4dfc7f45eabp-13, 0x1.1ca4b119b8436p-15},
          {{0x1.aa230f872450bp+7, 0x1.c5d9360eb7955p-1, 0x1.f976272c02f35p+8},
           {-0x1.aa230f872450bp+7, -0x1.c5be912eefa0fp-1, -0x1.f97a3804514e6p+8}},
          enters(1)}});
}

TEST_CASE_TEMPLATE("hyperboloid: properties of every shape", T, RAIO_NUMBERS) { check_properties<hyperboloid<T>>(); }

TEST_CASE_TEMPLATE("hyperboloid: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<hyperboloid<T>>();
    check_accuracy<hyperboloid<T>>(test_rays);
    check_bounds_of_errors<hyperboloid<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("open_hyperboloid: named cases", T, RAIO_NUMBERS) {
    const open_hyperboloid<T> tower{{0, -1, 0}, {0, 1, 0}, 3, 5};
    const ray<T> ahead{{0, 0, 9}, {0, 0, -1}}, beside{{2, -3, 3}, {0, 1, 0}};
    check_cases<open_hyperboloid<T>>({
        {"the waist", tower, ahead, enters(6)},
        {"the waist, from within", tower, {{0, 0, 0}, {0, 0, -1}}, leaves(3)},
        {"along the axis", tower, {{0, -3, 0}, {0, 1, 0}}, misses},
        {"beside the waist, out", tower, beside, leaves(2.5)},
        {"beside the waist, and in again", tower, beside, enters(3.5), 3},
        {"beside the waist, later", tower, beside, misses, 3.75},
        {"along a generator, in the surface", tower, {{3, -2, -8}, {0, 1, 4}}, misses},
        {"all but along a generator, in the surface, and out between the planes of the rims",
         {{-1, -1, 3}, {-1, -3, 3}, 3, 3},
         {{2, 4, 3}, {-0x1p-91, -2, -0x1p-55}},
         misses},
        {"along the rim of the base", tower, {{-9, -1, 0}, {1, 0, 0}}, enters(4)},
        {"touches the rim of the base from within",
         {{-3, -1, 3}, {0, -3, 1}, 3, 3},
         {{-3, -2, 0}, {-2, -1, 2}},
         leaves(1)},
        {"touches the rim of the top from within",
         {{-3, 2, 3}, {1, 3, 0}, 3, 3},
         {{-1, 1, 0}, {1, -0.0, -2}},
         leaves(1)},
        {"touches the rim of the top from outside",
         {{1, -2, -1}, {-2, -2, 0}, 1, 2},
         {{-4, 2, -1}, {2, -2, 1}},
         enters(1)},
        {"waist radius zero", {{0, -1, 0}, {0, 1, 0}, 0, 5}, ahead, misses},
        {"base is top", {{0, 0, 0}, {0, 0, 0}, 3, 5}, ahead, misses},
        {"direction zero", tower, {{0, 0, 0}, {0, 0, 0}}, misses},
        {"window that is not a number", tower, ahead, misses, nan<T>},
    });
}

TEST_CASE_TEMPLATE("open_hyperboloid: below its base, and all but parallel to that (hit there)", T, RAIO_NUMBERS) {
    const open_hyperboloid<T> tower{{-3, 2, 1}, {0, -2, -3}, 2, 2};
    for (int power = -140; power < -20; ++power) {
        CAPTURE(power);
        check_cases<open_hyperboloid<T>>({{"", tower, {{-3, 4, 1}, {-std::ldexp(T(1), power), 2, -2}}, misses}});
    }
}

TEST_CASE_TEMPLATE("open_hyperboloid: properties of every shape", T, RAIO_NUMBERS) {
    check_properties<open_hyperboloid<T>>();
}

TEST_CASE_TEMPLATE("open_hyperboloid: all but along a ruling", T, RAIO_NUMBERS) {
    check_along_surface(test_rays / 5, [](random_numbers& random) {
        const open_hyperboloid<T> tower = subject<open_hyperboloid<T>>::random(random, 1, random.direction());
        const vec3<double> base = to_double(tower.base), up = (to_double(tower.top) - base) * 0.5;
        const double waist = static_cast<double>(tower.waist_radius), end = static_cast<double>(tower.end_radius);
        const vec3<double> x = random.perpendicular(up), y = cross(up, x) * (1 / length(up));
        const vec3<double> ruling = up + y * std::sqrt(std::max(0.0, end * end - waist * waist));
        return touching_line<open_hyperboloid<T>>{tower, base + up + x * waist + ruling * random.uniform(-1, 1),
                                                  ruling};
    });
}

TEST_CASE_TEMPLATE("open_hyperboloid: from a point of the surface, in any direction (many doubles did not start there)",
                   T, RAIO_NUMBERS) {
    check_starts_on_surface([](random_numbers& random) {
        const T r = static_cast<T>(random.uniform(1, 2)), h = static_cast<T>(random.uniform(1, 2));
        return std::pair(open_hyperboloid<T>{{0, 0, -h}, {0, 0, h}, r, r + 1}, vec3<T>(0, r, 0));
    });
}

TEST_CASE_TEMPLATE("open_hyperboloid: as exact arithmetic", T, RAIO_NUMBERS) {
    check_accuracy<open_hyperboloid<T>>(test_rays, 1.0 / 200);
    check_bounds_of_errors<open_hyperboloid<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("hyperboloid: packs, lane by lane", T, RAIO_NUMBERS) { check_lanes_are_plain<hyperboloid<T>>(400); }

TEST_CASE_TEMPLATE("hyperboloid: all crossings", T, RAIO_NUMBERS) {
    const hyperboloid<T> tower{{0, -1, 0}, {0, 1, 0}, 3, 5};
    const auto inside = tower.spans({{2, -3, 3}, {0, 1, 0}});
    REQUIRE(inside.count == 2);
    CHECK(inside.intervals[0] == interval<T>{2, 2.5});
    CHECK(inside.intervals[1] == interval<T>{3.5, 4});
}

TEST_CASE_TEMPLATE("hyperboloid: uv and normal", T, RAIO_NUMBERS) {
    const hyperboloid<T> tower{{0, 0, -1}, {0, 0, 1}, 3, 5};
    const auto hit = [&](const ray<T>& ray) {
        hit_record<T> rec{};
        REQUIRE(tower.hit(ray, T(0), infinity<T>, rec));
        return rec;
    };
    CHECK(hit({{9, 0, 0}, {-1, 0, 0}}).uv == vec2<T>(0, 0.5));
    CHECK(hit({{9, 0, 0}, {-1, 0, 0}}).normal == vec3<T>(1, 0, 0));
    CHECK(hit({{0, 9, 0.5}, {0, -1, 0}}).uv == vec2<T>(0.25, 0.75));
    CHECK(hit({{2.5, 0, 9}, {0, 0, -1}}).uv == vec2<T>(0, 0.5));
    CHECK(hit({{-1, 0, -9}, {0, 0, 1}}).uv == vec2<T>(0.5, T(0.2)));
}

TEST_CASE_TEMPLATE("hyperboloid: area", T, RAIO_NUMBERS) {
    const vec3<T> base(1, 2, 3), top(1, 3, 5);
    for (const auto& [waist, end] : {std::pair<T, T>{T(0.1), 1}, {1, 2}, {1, T(1.001)}, {2, 2}, {2, 1}, {2, T(0.01)}}) {
        check_area<T>(open_hyperboloid<T>{base, top, waist, end}, hyperboloid<T>{base, top, waist, end});
    }
    // A tube, and what is missed.
    CHECK(open_hyperboloid<T>{{0, 0, 0}, {0, 0, 3}, 2, 2}.area() == doctest::Approx(12 * std::numbers::pi));
    CHECK(open_hyperboloid<T>{{0, 0, 0}, {0, 0, 3}, 0, 2}.area() == T(0));
}

TEST_CASE_TEMPLATE("hyperboloid: samples are spread evenly over the area", T, RAIO_NUMBERS) {
    const vec3<T> base(1, 2, 3), top(1, 2, 5);
    check_samples<T>(open_hyperboloid<T>{base, top, 1, 2}, hyperboloid<T>{base, top, 1, 2});
    check_samples<T>(open_hyperboloid<T>{base, top, 2, 1}, hyperboloid<T>{base, top, 2, 1});
}

}  // namespace raio::test
