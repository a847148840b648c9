#include <raio/proof/lanes.hpp>

#include <doctest/doctest.h>

#include <raio/number/simd.hpp>
#include <raio/shape/convex_polyhedron.hpp>
#include <raio/shape/quadric.hpp>
#include <raio/shape/sphere.hpp>

namespace raio::test {

using four = pack<float, 4>;

static_assert(detail::has_lanes<four> && !detail::has_lanes<float> && !detail::has_lanes<double_double>);
static_assert(std::same_as<detail::rebind_t<quadric<four, false>, float>, quadric<float, false>>);
static_assert(detail::aggregate_of_packs<sphere<four>, four> && detail::aggregate_of_packs<quadric<four>, four>);
static_assert(!detail::aggregate_of_packs<convex_polyhedron<four>, four>);

TEST_CASE("lanes: what stands in one comes out of it") {
    const float x[] = {1, 2, 3, 4}, y[] = {5, 6, 7, 8}, z[] = {9, 10, 11, 12}, radius[] = {13, 14, 15, 16};
    const sphere<four> packed{{four::load(x), four::load(y), four::load(z)}, four::load(radius)};
    for (std::size_t lane = 0; lane < 4; ++lane) {
        const sphere<float> plain = detail::in_lane<four>(packed, lane);
        CHECK(plain.center == vec3<float>(x[lane], y[lane], z[lane]));
        CHECK(plain.radius == radius[lane]);
    }
}

}  // namespace raio::test
