#include <raio/shape/quadric.hpp>

#include "support/cases.hpp"
#include "support/dual.hpp"
#include "support/packs.hpp"
#include "support/quadrics.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("quadric: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const vec3<T> low(-4), high(4);
    const quadric<T> ellipsoid{low, high, {4, 1, 1}, {0, 0, 0}, {0, 0, 0}, -4},
        elliptic_cylinder{low, high, {T(0.25), 1, 0}, {0, 0, 0}, {0, 0, 0}, -1}, elliptic_cone{low, high, {1, 4, -1}},
        paraboloid{low, high, {1, 1, 0}, {0, 0, 0}, {0, 0, -1}},
        saddle{low, high, {0, 0, 0}, {0, 0, 1}, {0, 0, -1}},  // x y <= z
        parabolic_cylinder{low, high, {0, 1, 0}, {0, 0, 0}, {0, 0, -1}},
        one_sheet{low, high, {1, 1, -1}, {0, 0, 0}, {0, 0, 0}, -1},
        two_sheets{low, high, {1, 1, -1}, {0, 0, 0}, {0, 0, 0}, 1},
        hyperbolic_cylinder{low, high, {0, 0, 0}, {0, 0, -1}, {0, 0, 0}, 1},  // x y >= 1
        crossing_planes{low, high, {0, 0, 0}, {0, 0, 1}},
        parallel_planes{low, high, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}, -1}, double_plane{low, high, {0, 0, 1}},
        half_space{low, high, {0, 0, 0}, {0, 0, 0}, {0, 0, 1}, -1}, line{low, high, {1, 1, 0}},
        all{low, high, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, -1}, none{low, high, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 1};
    const ray<T> down{{0, 0, 8}, {0, 0, -1}}, along{{-8, 0, 0}, {1, 0, 0}};
    check_cases<quadric<T>>({
        {"ellipsoid, the short axis", ellipsoid, along, enters(7)},
        {"ellipsoid, a long axis", ellipsoid, down, enters(6)},
        {"ellipsoid, from inside", ellipsoid, {{0, 0, 0}, {1, 0, 0}}, leaves(1)},
        {"ellipsoid, tangent", ellipsoid, {{1, 0, 8}, {0, 0, -1}}, enters(8)},
        {"ellipsoid, one number beyond the tangent", ellipsoid, {{1 + eps, 0, 8}, {0, 0, -1}}, misses},
        {"elliptic cylinder, the side", elliptic_cylinder, along, enters(6)},
        {"elliptic cylinder, the end", elliptic_cylinder, {{1, 0, 8}, {0, 0, -1}}, enters(4)},
        {"elliptic cylinder, parallel to it, outside", elliptic_cylinder, {{1, 1, 8}, {0, 0, -1}}, misses},
        {"elliptic cylinder, parallel to it, in the surface", elliptic_cylinder, {{2, 0, 8}, {0, 0, -1}}, enters(4)},
        {"elliptic cone, the tip", elliptic_cone, along, enters(8)},
        {"elliptic cone, through the tip, inside", elliptic_cone, down, enters(4)},
        {"elliptic cone, from the tip", elliptic_cone, {{0, 0, 0}, {1, 0, 0}}, enters(0)},
        {"elliptic cone, both nappes", elliptic_cone, {{1, 0, 8}, {0, 0, -1}}, leaves(7), 4.5},
        {"elliptic cone, both nappes, later", elliptic_cone, {{1, 0, 8}, {0, 0, -1}}, enters(9), 7.5},
        {"elliptic cone, parallel to a line of it", elliptic_cone, {{-4, 0, 2}, {1, 0, -1}}, enters(3)},
        {"elliptic cone, along a line of it", elliptic_cone, {{-5, 0, 5}, {1, 0, -1}}, enters(1)},
        {"elliptic cone, beside its narrow section", elliptic_cone, {{0, 1, 1}, {0, 0, -1}}, enters(3)},
        {"paraboloid, along its axis from below", paraboloid, {{0, 0, -8}, {0, 0, 1}}, enters(8)},
        {"paraboloid, parallel to its axis", paraboloid, {{1, 1, -8}, {0, 0, 1}}, enters(10)},
        {"paraboloid, the top", paraboloid, down, enters(4)},
        {"paraboloid, from the side", paraboloid, {{-8, 0, 1}, {1, 0, 0}}, enters(7)},
        {"saddle, from above", saddle, {{1, 1, 8}, {0, 0, -1}}, leaves(7), 4.5},
        {"saddle, along a line of it", saddle, {{0, -8, 0}, {0, 1, 0}}, enters(4)},
        {"saddle, across", saddle, {{-8, -8, 1}, {1, 1, 0}}, enters(7)},
        {"parabolic cylinder", parabolic_cylinder, {{0, 1, -8}, {0, 0, 1}}, enters(9)},
        {"parabolic cylinder, along it, outside", parabolic_cylinder, {{-8, 2, 1}, {1, 0, 0}}, misses},
        {"hyperboloid of one sheet, at the waist", one_sheet, along, enters(7)},
        {"hyperboloid of one sheet, along its axis", one_sheet, down, enters(4)},
        {"hyperboloid of one sheet, along a line of it", one_sheet, {{1, 8, 8}, {0, -1, -1}}, enters(4)},
        {"hyperboloid of one sheet, on its asymptote", one_sheet, {{8, 0, 8}, {-1, 0, -1}}, enters(4)},
        {"hyperboloid of two sheets, the first", two_sheets, down, enters(4)},
        {"hyperboloid of two sheets, out of the first", two_sheets, down, leaves(7), 4.5},
        {"hyperboloid of two sheets, the second", two_sheets, down, enters(9), 7.5},
        {"hyperboloid of two sheets, between them", two_sheets, along, misses},
        {"hyperboloid of two sheets, on its asymptote", two_sheets, {{8, 0, 8}, {-1, 0, -1}}, misses},
        {"hyperbolic cylinder", hyperbolic_cylinder, {{2, -8, 0}, {0, 1, 0}}, enters(8.5)},
        {"hyperbolic cylinder, on its asymptote", hyperbolic_cylinder, along, misses},
        {"planes that cross, where they do", crossing_planes, {{-1, -1, 0}, {1, 1, 0}}, enters(1)},
        {"planes that cross, one of them", crossing_planes, {{-1, -2, 0}, {1, 0, 0}}, enters(1)},
        {"planes that cross, in both", crossing_planes, down, enters(4)},
        {"parallel planes", parallel_planes, down, enters(7)},
        {"parallel planes, between them", parallel_planes, along, enters(4)},
        {"parallel planes, in one", parallel_planes, {{-8, 0, 1}, {1, 0, 0}}, enters(4)},
        {"parallel planes, above", parallel_planes, {{-8, 0, 2}, {1, 0, 0}}, misses},
        {"a plane that counts twice", double_plane, down, enters(8)},
        {"a plane, closed by the box", half_space, down, enters(7)},
        {"a plane, closed by the box, from below", half_space, {{0, 0, -8}, {0, 0, 1}}, enters(4)},
        {"a line", line, along, enters(8)},
        {"beside a line", line, {{-8, eps, 0}, {1, 0, 0}}, misses},
        {"everything", all, down, enters(4)},
        {"nothing", none, down, misses},
        {"ten zeros", {low, high}, down, misses},
        {"a box without thickness", {{-4, -4, 0}, {4, 4, 0}, {1, 1, 1}, {}, {}, -1}, down, misses},
        {"direction zero", ellipsoid, {{0, 0, 0}, {0, 0, 0}}, misses},
        {"1e4 sizes away", ellipsoid, {{0, 0, T(40000)}, {0, 0, -1}}, enters(39998)},
        {"window that is not a number", ellipsoid, down, misses, nan<T>},
    });
}

TEST_CASE_TEMPLATE("quadric: ends of a box and of a quadric in one point", T, RAIO_NUMBERS) {
    // (They were left a little before they were entered: a window that ends there had another hit.)
    const quadric<T> at_corner{{-1, -3, 2}, {2, -1, 3}, {-1, 1, 0}, {-1, 2, 2}, {2, 0, -2}, -3},
        at_face{{0, -2, -1}, {2, 1, 2}, {-1, -1, -1}, {-1, -3, -2}, {3, -3, 2}, -1};
    const ray<T> to_corner{{1, 1, 2}, {1, -2, 0}}, to_face{{-2, 0, 0}, {2, 0, 1}};
    const T before = std::nextafter(T(1), T(0));
    check_cases<quadric<T>>({
        {"at a corner", at_corner, to_corner, enters(1)},
        {"at a corner, the window ends before", at_corner, to_corner, misses, 0, before},
        {"in a face", at_face, to_face, enters(1)},
        {"in a face, the window ends before", at_face, to_face, misses, 0, before},
    });
    const vec3<T> low(-2, 1, -3), high(1, 2, 3);
    check_cases<open_quadric<T>>({
        {"touched from within, at an edge of the box",
         {low, high, {1, -2, -1}, {-2, -1, 0}, {2, -2, 1}, 1},
         {{0, 1, -2}, {1, 0, 2}},
         leaves(1)},
        {"left at a vertex, the one point of the line in the box (was missed)",
         {{-1, 2, 2}, {3, 3, 3}, {0, 1, 0}, {-1, -1, -3}, {1, -1, -1}, -3},
         {{0, 0, 3}, {-1, 2, -1}},
         leaves(1)},
        {"left at a vertex, where the ray starts",
         {{-1, 2, 2}, {3, 3, 3}, {0, 1, 0}, {-1, -1, -3}, {1, -1, -1}, -3},
         {{-1, 2, 2}, {-1, 2, -1}},
         leaves(0)},
        {"touched from within, in a face of the box",
         {{2, -3, -3}, {3, 3, 2}, {-1, -3, -1}, {1, 1, -3}, {-1, -3, 0}, 0},
         {{0, 1, -1}, {2, -2, 2}},
         leaves(1)},
    });
}

TEST_CASE_TEMPLATE("open_quadric: named cases", T, RAIO_NUMBERS) {
    const vec3<T> low(-4), high(4);
    const open_quadric<T> tube{low, high, {1, 1, 0}, {0, 0, 0}, {0, 0, 0}, -4},
        one_sheet{low, high, {1, 1, -1}, {0, 0, 0}, {0, 0, 0}, -1},
        beyond{low, high, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}, T(-16641) / 1024},  // |z| = 129 / 32
        just_within{low, high, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}, T(-16129) / 1024};
    const ray<T> down{{1, 2, 8}, {0, 0, -1}};
    check_cases<open_quadric<T>>({
        {"a little beyond both ends", beyond, down, misses},
        {"a little within both ends", just_within, down, enters(8 - 127.0 / 32)},
        {"through both ends", tube, {{1, 0, 8}, {0, 0, -1}}, misses},
        {"from inside", tube, {{0, 0, 0}, {1, 0, 0}}, leaves(2)},
        {"in through an end, onto the wall", tube, {{0, 0, 5}, {1, 0, -1}}, leaves(2)},
        {"onto the rim", tube, {{0, 0, 6}, {1, 0, -1}}, leaves(2)},
        {"beyond the rim", tube, {{0, 0, 6.5}, {1, 0, -1}}, misses},
        {"in the wall", tube, {{2, 0, 8}, {0, 0, -1}}, misses},
        {"along a line of a hyperboloid", one_sheet, {{1, 8, 8}, {0, -1, -1}}, misses},
        {"at the waist of a hyperboloid", one_sheet, {{-8, 0, 0}, {1, 0, 0}}, enters(7)},
    });
}

TEST_CASE_TEMPLATE("quadric: properties of every shape", T, RAIO_NUMBERS) {
    check_properties<quadric<T>>();
    check_properties<open_quadric<T>>();
}

TEST_CASE_TEMPLATE("quadric: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<quadric<T>>();
    check_accuracy<quadric<T>>(test_rays);
    check_bounds_of_errors<quadric<T>>(test_rays / 20);
}

TEST_CASE("open_quadric: from a point of the surface, in any direction (some did not start there)") {
    check_starts_on_surface([](random_numbers& random) {
        // A cone through (3 k, 4 k, 5 k); no product of three of its numbers fits into two doubles.
        const double s = random.uniform(1, 2), k = std::ldexp(std::floor(std::ldexp(random.uniform(1, 2), 49)), -49);
        const open_quadric<double> cone{vec3<double>(-20), vec3<double>(20), {s, s, -s}};
        return std::pair(cone, vec3<double>(3 * k, 4 * k, 5 * k));
    });
}

TEST_CASE_TEMPLATE("open_quadric: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<open_quadric<T>>();
    check_accuracy<open_quadric<T>>(test_rays, 1.0 / 200);
    check_bounds_of_errors<open_quadric<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("quadric: all crossings", T, RAIO_NUMBERS) {
    const quadric<T> two_sheets{{-4, -4, -4}, {4, 4, 4}, {1, 1, -1}, {0, 0, 0}, {0, 0, 0}, 1};
    const auto inside = two_sheets.spans({{0, 0, 8}, {0, 0, -1}});
    REQUIRE(inside.count == 2);
    CHECK(inside.intervals[0] == interval<T>{4, 7});
    CHECK(inside.intervals[1] == interval<T>{9, 12});
}

TEST_CASE("quadric: the derivatives of t, by a number that carries them along") {
    quadric<dual> ball{{-3, -3, -3}, {3, 3, 3}, {1, 1, 1}};
    ball.constant = dual::variable(-4, 0);
    hit_record<dual> rec{};
    REQUIRE(ball.hit({{0, 0, dual::variable(5, 1)}, {0, 0, -1}}, 0, infinity<dual>, rec));
    CHECK(rec.t.value == doctest::Approx(3));
    CHECK(rec.t.slope[0] == doctest::Approx(0.25));  // the radius is the root of the constant
    CHECK(rec.t.slope[1] == doctest::Approx(1));
}

TEST_CASE_TEMPLATE("quadric: packs, lane by lane", T, RAIO_NUMBERS) { check_lanes_are_plain<quadric<T>>(400); }

}  // namespace raio::test
