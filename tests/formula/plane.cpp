#include <raio/formula/plane.hpp>
#include <raio/proof/line.hpp>

#include <doctest/doctest.h>

#include "support/bounds.hpp"

namespace raio::test {

using W = strict_double;
using X = double_double;

namespace {

template <class N>
chord<N> behind(double height, double speed) {
    return cross_half_space(bounded_number<N>(N(height), bound_t<N>(0)), bounded_number<N>(N(speed), bound_t<N>(0)),
                            index_t<N>(7));
}

}  // namespace

TEST_CASE_TEMPLATE("plane: a line is behind it from its crossing on, or up to it", N, strict_double, double_double) {
    const chord<N> enters = behind<N>(3, -2), leaves = behind<N>(3, 2);
    CHECK((enters.near.exists && enters.near.certain && leaves.far.exists && leaves.far.certain));
    CHECK((enters.near.t == N(1.5) && enters.far.t == N(infinity<double>)));
    CHECK((leaves.near.t == N(-infinity<double>) && leaves.far.t == N(-1.5)));
    CHECK((enters.near.entering && !enters.far.entering && enters.near.face == 7 && enters.far.face == 7));
}

TEST_CASE("plane: a line that is parallel to it is behind it everywhere or nowhere, as the last precision says") {
    for (const double height : {-1.0, 0.0, 1.0}) {
        const chord<X> all = behind<X>(height, 0);
        CHECK((all.near.exists == (height <= 0) && all.far.exists == (height <= 0)));
        CHECK((all.near.t == X(-infinity<double>) && all.far.t == X(infinity<double>)));
        CHECK(!behind<W>(height, 0).near.certain);
    }
}

TEST_CASE("plane: the bound of t, from above as well") {
    random_numbers random(1);
    part_of_bound of_t;
    for (int i = 0; i < at_least(20'000); ++i) {
        const vec3<double> normal = some_vector(random), point = some_vector(random);
        const ray<double> ray{point + all_but_across(normal, random), all_but_across(normal, random)};
        const vec3<oracle> n(normal), d(ray.direction), from_point = vec3<oracle>(ray.origin) - vec3<oracle>(point);
        const auto line = line_in<W>(ray);
        const auto along = line.given(normal);
        const chord<W> c = cross_half_space(dot(along, line.from(point)), dot(along, line.direction()), 0u);
        const oracle t = -dot(n, from_point) / dot(n, d);
        for (const crossing<W>& end : {c.near, c.far}) {
            if (end.certain && end.exists && is_finite(end.t)) of_t.add(exactly(end.t) - t, end.error);
        }
    }
    CHECK(of_t.largest > 0.1);
}

}  // namespace raio::test
