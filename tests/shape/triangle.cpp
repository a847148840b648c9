#include <raio/shape/triangle.hpp>

#include "support/meshes.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("triangle: named cases", T, RAIO_NUMBERS) { check_triangle_cases<triangle<T>>(); }

TEST_CASE("triangle: ties that double_double cannot tell") {
    check_cases<triangle<double>>({
        {"on vertex c, which double_double cannot tell",
         {{0x1.a9d60ea8067e4p+3, 0x1.86440b1b0598cp+0, -0x1.ba8d9f1a14b28p+2},
          {0x1.a8dd70e2c228fp+3, 0x1.7f34a325f81dp+0, -0x1.bb77b9d92cc81p+2},
          {0x1.a9b1db69d7898p+3, 0x1.857401b4abc0ap+0, -0x1.ba22efdeac49ep+2}},
         {{0x1.a9161780313fep+3, 0x1.80d1bbcb3caa3p+0, -0x1.bb3f2f12aa9ep+2},
          {0x1.3787d34c934p-6, 0x1.28917a5bc59cp-6, 0x1.1c3f33fe542p-6}},
         enters(1)},
    });
}

/// 2^87 long and 2^-62 wide. Of t two doubles know nothing, and where the ray is at t is far from the sliver.
TEST_CASE("triangle: a sliver that a ray leaves behind") {
    check_cases<triangle<float>>({
        {"along it (t was any number in the window)",
         {{-0x1.41414p-62f, -0x1.41414p-62f, -0x1.41414p-62f},
          {-0x1.41414p-62f, -0x1.41414p-124f, 0x1.d6d6d6p+87f},
          {0x1.d6d6d6p+87f, 0x1.d6d6d6p+87f, -0x1.0000d6p-31f}},
         {{0x1.d6d6d6p+87f, 0x1.d6d6d6p+87f, -0x1.e2d6d6p+100f}, {0x1.001p-137f, 0, -0x1.801006p+113f}},
         misses},
    });
}

TEST_CASE_TEMPLATE("triangle: properties of every shape", T, RAIO_NUMBERS) { check_properties<triangle<T>>(); }

TEST_CASE_TEMPLATE("triangle: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<triangle<T>>();
    check_accuracy<triangle<T>>(test_rays);
    check_bounds_of_errors<triangle<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("triangle: area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    check_triangle_sampling<triangle<T>>();
}

TEST_CASE_TEMPLATE("triangle: no ray leaves a closed mesh unseen, leaks at vertices included", T, RAIO_NUMBERS) {
    check_closed_mesh(icosphere<triangle<T>>());
    check_closed_mesh(cube_of_fans<triangle<T>>());
}

TEST_CASE_TEMPLATE("triangle: far from the origin as well, and what neighbours share is one crossing", T,
                   RAIO_NUMBERS) {
    const vec3<double> place(148376, 1234, -223423);
    check_closed_mesh(icosphere<triangle<T>>(), 1000, place);
    check_closed_mesh(cube_of_fans<triangle<T>>(), 1, place);
}

static_assert(triangle<double>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}.occluded({{0.25, 0.25, 5}, {0, 0, -1}}, 0, 9));
static_assert(!triangle<float>{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}.occluded({{0.25, 0.25, 5}, {0, 0, -1}}, 0, 9));

}  // namespace raio::test
