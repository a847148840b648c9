#include <raio/formula/sphere.hpp>

#include <doctest/doctest.h>

#include "support/bounds.hpp"

namespace raio::test {

TEST_CASE("sphere_crossing: the bound of what is missing, from above as well") {
    using W = strict_double;
    using X = double_double;
    random_numbers random(1);
    part_of_bound of_value, of_slope;
    int seen = 0;
    for (int i = 0; i < at_least(20'000); ++i) {
        // Through a point of the sphere: ahead, or all but along it.
        const double radius = random.log_uniform(1e-3, 1e3);
        const vec3<double> outward = random.direction(), direction = all_but_across(outward, random);
        const vec3<oracle> d(direction), point = normalize(vec3<oracle>(outward)) * oracle(radius);

        // All of t is known, or only as much as the bound of its error says.
        const oracle scale = radius / length(d);
        const double error = random.one_in(2) ? 0 : random.log_uniform(1e-16, 1e-6) * rounded<double>(scale);
        const auto [start, last] = in_two_parts(point + d * oracle(error * random.uniform(-1, 1)));
        const nearby_point<X> at{start + last, W(0)};
        const crossing<W> met{true, true, W(0), W(error), true};
        const auto missing = correct_sphere(at, vec3<W>(direction), X(radius), met);
        if (!missing.certain) continue;

        const vec3<oracle> from = exactly(at.place);
        const oracle c = dot(from, from) - oracle(radius) * radius, b = dot(from, d), a = dot(d, d);
        const oracle square = b * b - a * c;
        REQUIRE(square > 0);
        const oracle t = -c / (b + (b < 0 ? -sqrt(square) : oracle(sqrt(square))));
        (error == 0 ? of_value : of_slope).add(exactly(missing.t) - t, missing.error);
        ++seen;
    }
    CHECK(seen > 10'000);
    CHECK((of_value.largest > 3e-4 && of_slope.largest > 0.2));
}

}  // namespace raio::test
