#include <raio/formula/edges.hpp>

#include <doctest/doctest.h>

#include "support/bounds.hpp"

namespace raio::test {

using W = strict_double;

TEST_CASE("edge_crossing: the bounds of t, u and v, from above as well") {
    random_numbers random(1);
    part_of_bound of_size, of_u, of_v, of_t;
    for (int i = 0; i < at_least(20'000); ++i) {
        const vec3<double> a = some_vector(random), b = a + some_vector(random), c = a + some_vector(random);
        const vec3<double> normal = cross(b - a, c - a);
        const ray<double> ray{a + all_but_across(normal, random), all_but_across(normal, random)};
        const vec3<W> corner(a);
        const auto anywhere = [](const W&, const W&, const W&) { return infinity<W>; };
        const auto met = cross_edges(corner, vec3<W>(b) - corner, vec3<W>(c) - corner, line_in<W>(ray), anywhere);
        if (met.size == W(0)) continue;  // there is no side to be on
        const vec3<oracle> e1 = vec3<oracle>(b) - vec3<oracle>(a), e2 = vec3<oracle>(c) - vec3<oracle>(a);
        const vec3<oracle> d(ray.direction), s = vec3<oracle>(ray.origin) - vec3<oracle>(a), n = cross(e1, e2);
        const oracle det = -dot(d, n), sign = met.at.entering ? 1 : -1;
        of_size.add(test::exactly(met.size) - det * sign, met.size_error);
        const oracle u = dot(s, cross(d, e2)) * sign, v = dot(d, cross(s, e1)) * sign;
        of_u.add(test::exactly(met.u) - u, met.u_error);
        of_v.add(test::exactly(met.v) - v, met.v_error);
        if (!met.at.certain) continue;
        of_t.add(test::exactly(met.at.t) - dot(s, n) / det, met.at.error);
    }
    CHECK((of_size.largest > 0.1 && of_u.largest > 0.1 && of_v.largest > 0.1));
    CHECK(of_t.largest > 0.03);
}

TEST_CASE("edge_crossing: what is out of range on the way is not taken for a miss (bundles were certain of one)") {
    const vec3<float> corner(0x1p59f, 0, 0), e1(0x1p91f, 0x1p91f, 0), e2(-0x1p59f, 0, 0);
    const auto inside = [](float size, float u, float v) { return size - u - v; };
    const ray<float> ray{{0, 0, 0}, {0, 0, -0x1p-29f}};
    const auto met = cross_edges(corner, e1, e2, line_in<float>(ray), inside);
    REQUIRE(met.v == infinity<float>);
    CHECK(!met.at.certain);
}

}  // namespace raio::test
