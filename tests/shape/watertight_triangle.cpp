#include <raio/shape/watertight_triangle.hpp>

#include "support/meshes.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("watertight_triangle: named cases", T, RAIO_NUMBERS) {
    check_triangle_cases<watertight_triangle<T>>();
    check_cases<watertight_triangle<T>>({{"starts in its plane, beside it, and all but runs in it",
                                          {{3, 1, 1}, {2, 1, -3}, {-2, 1, 2}},
                                          {{-1, 1, 0}, {-0x1p-135, 0x1p-95, 1}},
                                          misses}});
}

TEST_CASE("watertight_triangle: rays that start on it, or all but there, what the shear would round away") {
    check_cases<watertight_triangle<float>>({
        {"starts on it, and has no way to go",
         {{0x1.0a70cp+4f, -0x1.1cd694p+4f, -0x1.b40d6p+2f},
          {0x1.0ac578p+4f, -0x1.1ca05cp+4f, -0x1.b3c138p+2f},
          {0x1.0ac4aap+4f, -0x1.1ca0d2p+4f, -0x1.b3c1d2p+2f}},
         {{0x1.0a8f2ap+4f, -0x1.1cc31ap+4f, -0x1.b3f202p+2f}, {-0x1.b1b8fcp-2f, -0x1.a06368p-1f, 0x1.98967p-2f}},
         leaves(0)},
        {"starts 2^-124 below, and leaves",
         {{1, -1, 0}, {1, 2, 0}, {-1, -1, 0}},
         {{0, 0, -0x1.000006p-124f}, {0x1.be7eacp-1f, 0x1.b7af5cp-2f, -0x1.e0ed4p-3f}},
         misses},
    });
}

TEST_CASE("watertight_triangle: ties that double_double cannot tell") {
    check_cases<watertight_triangle<double>>({
        {"on vertex c, which double_double cannot tell",
         {{0x1.a9d60ea8067e4p+3, 0x1.86440b1b0598cp+0, -0x1.ba8d9f1a14b28p+2},
          {0x1.a8dd70e2c228fp+3, 0x1.7f34a325f81dp+0, -0x1.bb77b9d92cc81p+2},
          {0x1.a9b1db69d7898p+3, 0x1.857401b4abc0ap+0, -0x1.ba22efdeac49ep+2}},
         {{0x1.a9161780313fep+3, 0x1.80d1bbcb3caa3p+0, -0x1.bb3f2f12aa9ep+2},
          {0x1.3787d34c934p-6, 0x1.28917a5bc59cp-6, 0x1.1c3f33fe542p-6}},
         enters(1)},
    });
}

TEST_CASE_TEMPLATE("watertight_triangle: properties of every shape", T, RAIO_NUMBERS) {
    check_properties<watertight_triangle<T>>();
}

TEST_CASE_TEMPLATE("watertight_triangle: as exact arithmetic", T, RAIO_NUMBERS) {
    check_accuracy<watertight_triangle<T>>(test_rays);
    check_bounds_of_errors<watertight_triangle<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("watertight_triangle: area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    check_triangle_sampling<watertight_triangle<T>>();
}

TEST_CASE_TEMPLATE("watertight_triangle: no ray leaves a closed mesh unseen, leaks at vertices included", T,
                   RAIO_NUMBERS) {
    check_closed_mesh(icosphere<watertight_triangle<T>>());
    check_closed_mesh(cube_of_fans<watertight_triangle<T>>());
}

TEST_CASE_TEMPLATE("watertight_triangle: far from the origin as well, and what neighbours share is one crossing", T,
                   RAIO_NUMBERS) {
    const vec3<double> place(148376, 1234, -223423);
    check_closed_mesh(icosphere<watertight_triangle<T>>(), 1000, place);
    check_closed_mesh(cube_of_fans<watertight_triangle<T>>(), 1, place);
}

static_assert(watertight_triangle<double>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}.occluded({{0.25, 0.25, 5}, {0, 0, -1}}, 0,
                                                                                    9));
static_assert(!watertight_triangle<float>{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}.occluded({{0.25, 0.25, 5}, {0, 0, -1}}, 0,
                                                                                    9));

}  // namespace raio::test
