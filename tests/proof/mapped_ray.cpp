#include <raio/proof/mapped_ray.hpp>

#include <doctest/doctest.h>

#include <raio/number/simd.hpp>

#include "support/linear_inverse.hpp"
#include "support/oracle.hpp"
#include "support/random.hpp"

namespace raio::test {

namespace {

/// Turned any way, stretched by up to a thousand along each axis.
template <class T>
transform<T> some_map(random_numbers& random) {
    transform<T> map = rotation(vec3<T>(random.direction()), static_cast<T>(random.uniform(-3, 3)));
    for (vec3<T>* axis : {&map.x, &map.y, &map.z}) *axis *= static_cast<T>(random.log_uniform(1e-3, 1e3));
    map = rotation(vec3<T>(random.direction()), T(1)) * map;
    map.origin = vec3<T>(random.direction() * random.log_uniform(1e-3, 1e3));
    return map;
}

ray<oracle> mapped_exactly(const ray<oracle>& ray, const transform<oracle>& map) {
    const linear_inverse<oracle> inverse(map);
    return {inverse(ray.origin - map.origin), inverse(ray.direction)};
}

template <class T>
transform<oracle> exact_map(const transform<T>& map) {
    return {vec3<oracle>(map.x), vec3<oracle>(map.y), vec3<oracle>(map.z), vec3<oracle>(map.origin)};
}

template <class W>
oracle part_of_error(const bounded_vector<W>& v, const vec3<oracle>& exact) {
    const oracle off = abs(exactly(v.x) - exact.x) + abs(exactly(v.y) - exact.y) + abs(exactly(v.z) - exact.z);
    return off / exactly(v.error);
}

}  // namespace

TEST_CASE_TEMPLATE("mapped_ray: its lines are off by no more than they say, under one map or two", T, RAIO_NUMBERS) {
    random_numbers random(1);
    oracle quick(0), closer(0);
    for (int i = 0; i < at_least(2000); ++i) {
        const transform<T> outer = some_map<T>(random), inner = some_map<T>(random);
        const inverse_map<T> by_outer(outer), by_inner(inner);
        const ray<T> world{vec3<T>(random.direction() * random.log_uniform(1e-3, 1e6)), vec3<T>(random.direction())};
        const mapped_ray<T> once(world, by_outer), twice(once, by_inner);
        const ray<oracle> exact_once =
            mapped_exactly({vec3<oracle>(world.origin), vec3<oracle>(world.direction)}, exact_map(outer));
        const ray<oracle> exact_twice = mapped_exactly(exact_once, exact_map(inner));
        const auto check = [&](const mapped_ray<T>& r, const ray<oracle>& exact) {
            const auto in_doubles = line_in<strict_double>(r);
            const auto in_two = line_in<double_double>(r);
            quick = max(quick, max(part_of_error(in_doubles.origin(), exact.origin),
                                   part_of_error(in_doubles.direction(), exact.direction)));
            closer = max(closer, max(part_of_error(in_two.origin(), exact.origin),
                                     part_of_error(in_two.direction(), exact.direction)));
        };
        check(once, exact_once);
        check(twice, exact_twice);
        REQUIRE((&once.world() == &world && &twice.world() == &world));
        // Packs hold the same numbers in every lane.
        const auto in_lanes = line_in<pack<strict_double, 4>>(twice);
        REQUIRE(in_lanes.origin().x[3] == line_in<strict_double>(twice).origin().x);
        REQUIRE(in_lanes.direction().error[2] == line_in<strict_double>(twice).direction().error);
    }
    CHECK((quick <= oracle(1) && closer <= oracle(1)));
    CHECK(quick > oracle(0.01));
}

TEST_CASE_TEMPLATE("mapped_ray: what is across a surface stays across it, and lengths are seen no longer than said", T,
                   RAIO_NUMBERS) {
    const inverse_map<T> shear(transform<T>{{1, 0, 0}, {4, 2, 0}, {0, 0, -8}});
    const ray<T> world{{1, 2, 3}, {0, 0, 1}};
    const mapped_ray<T> ray(world, shear);
    using Q = working_t<T>;
    // The plane y = 0 stays where it is, the plane x = 0 leans over.
    CHECK(ray.across({Q(0), Q(1), Q(0)}) == vec3<Q>(Q(0), Q(0.5), Q(0)));
    CHECK(dot(ray.across({Q(1), Q(0), Q(0)}), vec3<Q>(Q(4), Q(2), Q(0))) == Q(0));
    CHECK(ray.across({Q(0), Q(0), Q(1)}) == vec3<Q>(Q(0), Q(0), Q(-0.125)));
    CHECK(ray.point({Q(0), Q(1), Q(0)}) == vec3<Q>(Q(4), Q(2), Q(0)));
    CHECK(ray.stretched(T(1)) >= T(8));
    CHECK(ray.rounded().origin == vec3<T>(-3, 1, T(-0.375)));
}

TEST_CASE_TEMPLATE("mapped_ray: under a singular map it goes nowhere", T, RAIO_NUMBERS) {
    const ray<T> world{{1, 2, 3}, {0, 0, 1}};
    for (const transform<T>& flat :
         {scaling<T>({1, 0, 1}), transform<T>{{1, 2, 3}, {2, 4, 6}, {0, 0, 1}}, scaling<T>({1, infinity<T>, 1})}) {
        const inverse_map<T> map(flat);
        const auto d = line_in<double_double>(mapped_ray<T>(world, map)).direction();
        CHECK((static_cast<double>(d.x) == 0 && static_cast<double>(d.z) == 0 && static_cast<double>(d.error) == 0));
    }
}

}  // namespace raio::test
