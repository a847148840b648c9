#include "support/boxes.hpp"
#include "support/capsules.hpp"
#include "support/cones.hpp"
#include "support/cylinders.hpp"
#include "support/discs.hpp"
#include "support/ellipsoids.hpp"
#include "support/hyperboloids.hpp"
#include "support/packs.hpp"
#include "support/paraboloids.hpp"
#include "support/parallelograms.hpp"
#include "support/planes.hpp"
#include "support/polyhedra.hpp"
#include "support/quadrics.hpp"
#include "support/rings.hpp"
#include "support/round_cones.hpp"
#include "support/spheres.hpp"
#include "support/triangles.hpp"

namespace raio::test {

/// So many ordinary rays are sent to each shape.
inline const int ordinary_rays = std::max(2'000, test_rays / 5);

/// Ordinary rays leave less than one verdict in a hundred open. But of boxes one in four is flat, and a hit there is a
/// tie; and of capsules one in eight is a sphere, whose axis has no direction; and of round cones
/// one in eight is all but that.
template <class Shape>
void check_packs(double may_be_left_open = 0.01, double may_be_asked_alone = 0.01) {
    using P = pack<number_t<Shape>>;
    check_crossings_of_lanes<Shape, P>(test_rays / 20);
    check_lanes_are_plain<Shape, P>(test_rays / 20);
    const double open = fraction_left_open<P, Shape>(ordinary_rays);
    const double alone = fraction_asked_alone<P, Shape>(ordinary_rays);
    MESSAGE("left open: " << 100 * open << " %, of those that are hit asked alone: " << 100 * alone << " %");
    CHECK(open * ordinary_rays < with_chance(may_be_left_open * ordinary_rays));
    CHECK(alone * ordinary_rays < with_chance(may_be_asked_alone * ordinary_rays));
}

/// Most of the rays that leave a shape are known not to meet it again.
template <class Shape, class Arriving>
void check_packs_that_rays_leave(Arriving arriving) {
    const double open = fraction_of_spawned_left_open<pack<number_t<Shape>>, Shape>(ordinary_rays, arriving);
    MESSAGE("left open: " << 100 * open << " %");
    CHECK(open * ordinary_rays < with_chance(0.05 * ordinary_rays));
}

TEST_CASE_TEMPLATE("packs: what rays leave that is small in its scene", T, RAIO_NUMBERS) {
    const auto check = [](auto shape) {
        using Shape = decltype(shape);
        check_packs_that_rays_leave<Shape>(
            [](random_numbers& random) { return ordinary_probe_within<Shape>(500, random); });
    };
    check(sphere<T>{});
    check(ellipsoid<T>{});
    check(triangle<T>{});
    check(parallelogram<T>{});
}

// The sieve of packs of doubles has no wider numbers to ask on which side of it such a ray starts.
TEST_CASE("packs of floats: what rays leave that is the ground") {
    const auto arriving = [](auto shape) {
        return [=](random_numbers& random) {
            const vec3<double> from = random.direction() * 5.0 + vec3<double>(0, 6, 0), to = random.direction() * 5.0;
            return probe<decltype(shape)>{shape, {vec3<float>(from), vec3<float>(to - from)}};
        };
    };
    check_packs_that_rays_leave<sphere<float>>(arriving(sphere<float>{{0, -1000, 0}, 1000}));
    check_packs_that_rays_leave<ellipsoid<float>>(arriving(ellipsoid<float>{{0, -1000, 0}, {2000, 1000, 1500}}));
}

TEST_CASE("packs of floats: a ray that starts closer to a tip than squares of floats can tell") {
    using P = pack<float, 4>;
    const vec3<float> base(0), top(0x1.aea366p+16f, -0x1.b562fap+14f, 0x1.3bf152p+17f);
    const frustum<P> packed{vec3<P>(base), vec3<P>(top), P(0), P(0x1.81047p+16f)};
    const vec3<float> from(0x1.e693p-75f, -0x1.3740fep-75f, 0x1.3771aep-81f);
    const vec3<float> direction(-0x1.e8cab2p-3f, -0x1.bc0d3p-3f, -0x1.e4a6fap-1f);
    const ray<P> ray{vec3<P>(from), vec3<P>(direction)};
    const crossing<P> near = packed.crossings(line_in<P>(ray)).near;
    const double exact = -0x1.be64161cdb3d8p-70;
    CHECK((!near.certain[0] || std::abs(double(near.t[0]) - exact) <= double(near.error[0])));
}

/// A hit is recorded alike by one number and in each lane of packs that are all the same, ahead and behind.
template <class Shape, class Packed>
void check_same_in_packs(const Shape& plain, const Packed& packed, const ray<number_t<Shape>>& r) {
    using T = number_t<Shape>;
    using P = number_t<Packed>;
    const auto check_along = [&](const vec3<T>& direction, T t_min, T t_max) {
        hit_record<T> expected{};
        hit_record<P> found{};
        REQUIRE(plain.hit({r.origin, direction}, t_min, t_max, expected));
        REQUIRE(all(packed.hit({vec3<P>(r.origin), vec3<P>(direction)}, P(t_min), P(t_max), found)));
        for (std::size_t lane = 0; lane < P::lanes; ++lane)
            CHECK(same_as_plain(detail::in_lane<P>(found, lane), expected));
    };
    check_along(r.direction, T(0), infinity<T>);
    check_along(-r.direction, -infinity<T>, T(0));
}

TEST_CASE("packs of floats: a sliver, of whose error one number knows less than the sieve") {
    using P = pack<float, 4>;
    const parallelogram<float> plain{{0, 0, 0},
                                     {-0x1.3df3d2p+8f, -0x1.1d6fb4p+4f, -0x1.fec5ecp-1f},
                                     {-0x1.4c2534p+7f, -0x1.4cf3cp+3f, 0x1.9e5dbap-4f}};
    const ray<float> r{{-0x1.86f3c8p+4f, -0x1.60d2bp+0f, -0x1.2502eap-4f},
                       {0x1.05751cp-1f, -0x1.3641e2p-1f, -0x1.3849f8p-1f}};
    const parallelogram<P> packed{vec3<P>(plain.corner), vec3<P>(plain.edge_u), vec3<P>(plain.edge_v)};
    check_same_in_packs(plain, packed, r);
}

TEST_CASE("packs of floats: a ray that starts on a round end, which the sieve knows and one number does not") {
    using P = pack<float, 4>;
    const round_cone<float> plain{{0x1.ae2cbp+9f, -0x1.33aecep+6f, -0x1.98a07ep+8f},
                                  {0x1.8aabaep+10f, 0x1.cf5342p+8f, -0x1.0b0426p+10f},
                                  0x1.c51feap+8f,
                                  0x1.c51feap+8f};
    const ray<float> r{{0x1.82291ap+9f, -0x1.a6e5e8p+8f, -0x1.57d784p+9f},
                       {0x1.8ff88ep-1f, 0x1.3f7b08p-1f, 0x1.3f0cccp-6f}};
    check_same_in_packs(
        plain, round_cone<P>{vec3<P>(plain.base), vec3<P>(plain.top), P(plain.base_radius), P(plain.top_radius)}, r);
}

TEST_CASE_TEMPLATE("packs: sphere", T, RAIO_NUMBERS) { check_packs<sphere<T>>(); }
TEST_CASE_TEMPLATE("packs: ellipsoid", T, RAIO_NUMBERS) { check_packs<ellipsoid<T>>(); }
TEST_CASE_TEMPLATE("packs: plane", T, RAIO_NUMBERS) { check_packs<plane<T>>(); }
TEST_CASE_TEMPLATE("packs: disc", T, RAIO_NUMBERS) { check_packs<disc<T>>(); }
TEST_CASE_TEMPLATE("packs: ring", T, RAIO_NUMBERS) { check_packs<ring<T>>(); }
TEST_CASE_TEMPLATE("packs: triangle", T, RAIO_NUMBERS) { check_packs<triangle<T>>(); }
TEST_CASE_TEMPLATE("packs: watertight triangle", T, RAIO_NUMBERS) { check_packs<watertight_triangle<T>>(); }
TEST_CASE_TEMPLATE("packs: parallelogram", T, RAIO_NUMBERS) { check_packs<parallelogram<T>>(); }
TEST_CASE_TEMPLATE("packs: box", T, RAIO_NUMBERS) { check_packs<box<T>>(0.1); }
TEST_CASE_TEMPLATE("packs: cylinder", T, RAIO_NUMBERS) { check_packs<cylinder<T>>(); }
TEST_CASE_TEMPLATE("packs: open cylinder", T, RAIO_NUMBERS) { check_packs<open_cylinder<T>>(); }
TEST_CASE_TEMPLATE("packs: capsule", T, RAIO_NUMBERS) { check_packs<capsule<T>>(0.14); }
TEST_CASE_TEMPLATE("packs: cone", T, RAIO_NUMBERS) { check_packs<cone<T>>(); }
TEST_CASE_TEMPLATE("packs: open cone", T, RAIO_NUMBERS) { check_packs<open_cone<T>>(); }
TEST_CASE_TEMPLATE("packs: frustum", T, RAIO_NUMBERS) { check_packs<frustum<T>>(); }
TEST_CASE_TEMPLATE("packs: open frustum", T, RAIO_NUMBERS) { check_packs<open_frustum<T>>(); }
TEST_CASE_TEMPLATE("packs: round cone", T, RAIO_NUMBERS) { check_packs<round_cone<T>>(0.02, 0.02); }
TEST_CASE_TEMPLATE("packs: paraboloid", T, RAIO_NUMBERS) { check_packs<paraboloid<T>>(); }
TEST_CASE_TEMPLATE("packs: open paraboloid", T, RAIO_NUMBERS) { check_packs<open_paraboloid<T>>(); }
TEST_CASE_TEMPLATE("packs: hyperboloid", T, RAIO_NUMBERS) { check_packs<hyperboloid<T>>(); }
TEST_CASE_TEMPLATE("packs: two-sheet hyperboloid", T, RAIO_NUMBERS) { check_packs<two_sheet_hyperboloid<T>>(); }
TEST_CASE_TEMPLATE("packs: quadric", T, RAIO_NUMBERS) { check_packs<quadric<T>>(); }
TEST_CASE_TEMPLATE("packs: open quadric", T, RAIO_NUMBERS) { check_packs<open_quadric<T>>(); }
TEST_CASE_TEMPLATE("packs: open hyperboloid", T, RAIO_NUMBERS) { check_packs<open_hyperboloid<T>>(); }
TEST_CASE_TEMPLATE("packs: open two-sheet hyperboloid", T, RAIO_NUMBERS) {
    check_packs<open_two_sheet_hyperboloid<T>>();
}
TEST_CASE_TEMPLATE("packs: convex polyhedron", T, RAIO_NUMBERS) {
    // Polyhedra that have fewer planes repeat the last one, and a crossing of two faces is not refined as that of one.
    check_packs<convex_polyhedron<T>>(0.01, 0.2);
}

}  // namespace raio::test
