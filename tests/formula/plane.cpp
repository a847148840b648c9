#include <raio/formula/plane.hpp>

#include <doctest/doctest.h>

#include "support/bounds.hpp"

namespace raio::test {

using W = strict_double;
using X = double_double;

TEST_CASE("plane_crossing: the bounds of slope, height, t and distance, from above as well") {
    random_numbers random(1);
    part_of_bound of_slope, of_height, of_t, of_distance;
    for (int i = 0; i < at_least(20'000); ++i) {
        const vec3<double> normal = some_vector(random), point = some_vector(random);
        const ray<double> ray{point + all_but_across(normal, random), all_but_across(normal, random)};
        const vec3<oracle> n(normal), d(ray.direction), from_point = vec3<oracle>(ray.origin) - vec3<oracle>(point);
        const auto slope = speed_across(vec3<W>(normal), vec3<W>(ray.direction));
        of_slope.add(exactly(slope.value) - dot(n, d), slope.error);
        const auto height = height_above(vec3<W>(normal), point, ray.origin);
        of_height.add(exactly(height.value) - dot(n, from_point), height.error);

        const auto [at, distance2, distance2_error] = cross_plane_about<W>(point, normal, ray);
        if (!at.certain || !at.exists) continue;
        const oracle t = -dot(n, from_point) / dot(n, d);
        const vec3<oracle> met = from_point + d * t;
        of_t.add(exactly(at.t) - t, at.error);
        of_distance.add(exactly(distance2) - dot(met, met), distance2_error);
    }
    CHECK((of_slope.largest > 0.4 && of_height.largest > 0.4 && of_distance.largest > 0.2));
    CHECK(of_t.largest > 0.1);
}

TEST_CASE("plane_crossing: a product below all numbers counts as an error, until there is nobody to leave it to") {
    const vec3<double> normal(0, 0, 0x1p-600), origin(0, 0, 0x1p-600), point(0);
    CHECK(height_above(vec3<W>(normal), point, origin).error > 0.0);
    CHECK(height_above(vec3<X>(normal), point, origin).error == 0.0);
}

}  // namespace raio::test
