#include <raio/shape/cone.hpp>

#include <doctest/doctest.h>

#include "support/oracle.hpp"
#include "support/random.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("normal: however close to an apex a ray comes, the normal is unit and faces the ray", T, float,
                   double) {
    random_numbers random(1);
    int hits = 0;
    for (int i = 0; i < at_least_a_tenth_of(20'000); ++i) {
        const vec3<T> apex(random.direction()), base = apex + vec3<T>(random.direction());
        const open_cone<T> cone{base, apex, T(random.log_uniform(1e-3, 1e3))};
        const vec3<double> aside = random.direction() * (random.one_in(8) ? 0 : random.log_uniform(1e-20, 1e-3));
        const vec3<T> from(vec3<double>(apex) + random.direction() * random.log_uniform(1e-3, 1e3));
        const ray<T> ray{from, vec3<T>(vec3<double>(apex) + aside) - from};
        hit_record<T> rec;
        if (!cone.hit(ray, T(0), infinity<T>, rec)) continue;
        ++hits;
        REQUIRE(std::abs(length(rec.normal) - T(1)) < T(1e-5));
        const T along = dot(rec.normal, ray.direction) / length(ray.direction);
        REQUIRE(along <= T(8 * unit_roundoff<T>));
    }
    CHECK(hits > at_least_a_tenth_of(5'000));
}

TEST_CASE("normal: what is not along the way out is left") {
    const vec3<double> d(0, 0, 2);
    CHECK(detail::turned_from(d, true, vec3<double>(1, 0, -1)) == vec3<double>(1, 0, -1));  // against the ray already
    CHECK(detail::turned_from(d, true, vec3<double>(1, 0, 1)) == vec3<double>(1, 0, 0));
    CHECK(detail::turned_from(d, false, vec3<double>(1, 0, 1)) == vec3<double>(1, 0, 1));
    CHECK(detail::turned_from(d, false, vec3<double>(1, 0, -1)) == vec3<double>(1, 0, 0));
}

TEST_CASE("normal: what errors have turned along the ray is mirrored, the other way if it leaves") {
    const vec3<double> d(0, 0, 1), along(1, 0, 2), against(1, 0, -2);
    CHECK((mirrored_against(along, d, 1.0) == against && mirrored_against(against, d, 1.0) == against));
    CHECK((mirrored_against(along, d, -1.0) == along && mirrored_against(against, d, -1.0) == along));
}

}  // namespace raio::test
