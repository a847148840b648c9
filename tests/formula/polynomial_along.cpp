#include <raio/formula/polynomial_along.hpp>

#include <doctest/doctest.h>

#include "support/oracle.hpp"
#include "support/random.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("polynomial_along: the part of a line that passes a ball has all of it between its ends", W,
                   strict_double, double_double) {
    random_numbers random(1);
    int passed = 0, missed = 0, within = 0;
    for (int i = 0; i < at_least(5'000); ++i) {
        const vec3<double> center = random.direction() * random.uniform(0, 4);
        const double radius = random.log_uniform(0.01, 10);
        const vec3<double> to = center + random.direction() * (radius * random.uniform(0, 2));
        const vec3<double> origin = random.direction() * random.log_uniform(0.01, 100);
        const ray<double> ray{origin, (to - origin) * random.log_uniform(1e-3, 1e3)};
        const line_part<W> part = part_near(line_in<W>(ray), center, vec3<W>(center), W(radius));

        const vec3<oracle> d(ray.direction), l = vec3<oracle>(center) - vec3<oracle>(origin);
        const oracle d2 = dot(d, d), nearest = dot(l, d) / d2;
        const vec3<oracle> beside = l - d * nearest;
        const oracle half2 = oracle(radius) * oracle(radius) - dot(beside, beside);
        REQUIRE(part.certain);
        if (!part.exists) {
            REQUIRE(half2 < 0);
            ++missed;
            continue;
        }
        ++passed;
        const bool starts_within = dot(l, l) <= oracle(radius) * oracle(radius);
        if (starts_within) REQUIRE(part.middle == W(0));
        within += starts_within;
        if (half2 <= 0) continue;
        const oracle half = sqrt(half2 / d2);
        for (const oracle& t : {nearest - half, nearest + half}) {
            REQUIRE(abs(t - exactly(part.middle)) < exactly(part.half) * exactly(part.reach));
        }
    }
    CHECK((passed > 1'000 && missed > 1'000 && within > 100));
}

}  // namespace raio::test
