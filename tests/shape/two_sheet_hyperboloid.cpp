#include <raio/shape/two_sheet_hyperboloid.hpp>

#include "support/cases.hpp"
#include "support/hyperboloids.hpp"
#include "support/packs.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("two_sheet_hyperboloid: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const two_sheet_hyperboloid<T> cups{{0, -1, 0}, {0, 1, 0}, 0.5, 3};  // rho^2 = 12 y^2 - 3
    const ray<T> up{{0, -3, 0}, {0, 1, 0}};
    check_cases<two_sheet_hyperboloid<T>>({
        {"both sheets along the axis, the first crossing", cups, up, enters(2)},
        {"both sheets along the axis, the second", cups, up, leaves(2.5), 2.25},
        {"both sheets along the axis, the third", cups, up, enters(3.5), 3},
        {"both sheets along the axis, the last", cups, up, leaves(4), 3.75},
        {"through the gap", cups, {{-5, 0, 0}, {1, 0, 0}}, misses},
        {"from between the sheets", cups, {{0, 0, 0}, {0, -1, 0}}, enters(0.5)},
        {"tangent to a vertex", cups, {{-5, 0.5, 0}, {1, 0, 0}}, enters(5)},
        {"one number below the vertex", cups, {{-5, 0.5 - eps, 0}, {1, 0, 0}}, misses},
        {"along the top", cups, {{-5, 1, 0}, {1, 0, 0}}, enters(2)},
        {"one number above the top", cups, {{-5, 1 + eps, 0}, {1, 0, 0}}, misses},
        {"at the rims, parallel to the axis", cups, {{3, -3, 0}, {0, 1, 0}}, enters(2)},
        {"at the rims, the upper one", cups, {{3, -3, 0}, {0, 1, 0}}, enters(4), 3},
        {"beside both sheets", cups, {{4, -3, 0}, {0, 1, 0}}, misses},
        {"from one sheet into the other", cups, {{0, -0.75, 0}, {0, 1, 0}}, leaves(0.25)},
        {"from a vertex outwards", cups, {{0, 0.5, 0}, {0, -1, 0}}, leaves(0)},
        {"without a gap", {{0, -1, 0}, {0, 1, 0}, 0, 3}, up, misses},
        {"a gap as long as the axis", {{0, -1, 0}, {0, 1, 0}, 1, 3}, up, misses},
        {"end radius zero", {{0, -1, 0}, {0, 1, 0}, 0.5, 0}, up, misses},
        {"base is top", {{0, 0, 0}, {0, 0, 0}, 0.5, 3}, up, misses},
        {"direction zero", cups, {{0, 0.75, 0}, {0, 0, 0}}, misses},
        {"window that is not a number", cups, up, misses, nan<T>},
    });
}

TEST_CASE("two_sheet_hyperboloid: its rim, from far away (beyond the bounds)") {
    check_cases<two_sheet_hyperboloid<double>>(
        {{"across",
          {{0, 0, 0}, {0x1.0bd12d5913937p-8, 0, 0}, 0x1.896c568bd161ep-8, 0x1.5c4dd88ece386p-20},
          {{0x1.0bce7250deddap-8, -0x1.c026297242882p+5, -0x1.a08c43b4b0b53p+3},
           {0x1.5d841a15e8p-23, 0x1.c02629942b647p+5, 0x1.a08c411b99be3p+3}},
          enters(0x1.ffffffd942521p-1)}});
}

TEST_CASE_TEMPLATE("two_sheet_hyperboloid: properties of every shape", T, RAIO_NUMBERS) {
    check_properties<two_sheet_hyperboloid<T>>();
}

TEST_CASE_TEMPLATE("two_sheet_hyperboloid: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<two_sheet_hyperboloid<T>>();
    check_accuracy<two_sheet_hyperboloid<T>>(test_rays);
    check_bounds_of_errors<two_sheet_hyperboloid<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("open_two_sheet_hyperboloid: named cases", T, RAIO_NUMBERS) {
    const open_two_sheet_hyperboloid<T> cups{{0, -1, 0}, {0, 1, 0}, 0.5, 3};
    const ray<T> up{{0, -3, 0}, {0, 1, 0}};
    check_cases<open_two_sheet_hyperboloid<T>>({
        {"out of the lower sheet", cups, up, leaves(2.5)},
        {"into the upper one", cups, up, enters(3.5), 3},
        {"and out through its rim", cups, up, misses, 3.75},
        {"through the gap", cups, {{-5, 0, 0}, {1, 0, 0}}, misses},
        {"along a rim", cups, {{-5, 1, 0}, {1, 0, 0}}, enters(2)},
        {"touches a rim from outside", {{2, -2, 0}, {3, -2, -3}, 0.75, 3}, {{4, 3, -3}, {-1, -2, 0}}, enters(1)},
        {"a gap as long as the axis", {{0, -1, 0}, {0, 1, 0}, 1, 3}, up, misses},
        {"direction zero", cups, {{0, 0.75, 0}, {0, 0, 0}}, misses},
        {"window that is not a number", cups, up, misses, nan<T>},
    });
}

TEST_CASE_TEMPLATE("open_two_sheet_hyperboloid: properties of every shape", T, RAIO_NUMBERS) {
    check_properties<open_two_sheet_hyperboloid<T>>();
}

TEST_CASE_TEMPLATE("open_two_sheet_hyperboloid: as exact arithmetic", T, RAIO_NUMBERS) {
    check_accuracy<open_two_sheet_hyperboloid<T>>(test_rays, 1.0 / 200);
    check_bounds_of_errors<open_two_sheet_hyperboloid<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("two_sheet_hyperboloid: packs, lane by lane", T, RAIO_NUMBERS) {
    check_lanes_are_plain<two_sheet_hyperboloid<T>>(400);
}

TEST_CASE_TEMPLATE("two_sheet_hyperboloid: all crossings", T, RAIO_NUMBERS) {
    const auto both = two_sheet_hyperboloid<T>{{0, -1, 0}, {0, 1, 0}, 0.5, 3}.spans({{0, -3, 0}, {0, 1, 0}});
    REQUIRE(both.count == 2);
    CHECK(both.intervals[0] == interval<T>{2, 2.5});
    CHECK(both.intervals[1] == interval<T>{3.5, 4});
}

TEST_CASE_TEMPLATE("two_sheet_hyperboloid: area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    const vec3<T> base(1, 2, 3), top(1, 2, 5);
    for (const auto& [gap, end] : {std::pair<T, T>{T(0.5), 1}, {T(0.01), 3}, {T(0.99), 2}, {T(0.25), T(0.01)}}) {
        check_area<T>(open_two_sheet_hyperboloid<T>{base, top, gap, end},
                      two_sheet_hyperboloid<T>{base, top, gap, end});
    }
    // What is missed.
    CHECK(open_two_sheet_hyperboloid<T>{{0, 0, 0}, {0, 0, 3}, 1, 2}.area() == T(0));
    check_samples<T>(open_two_sheet_hyperboloid<T>{base, top, T(0.5), 2},
                     two_sheet_hyperboloid<T>{base, top, T(0.5), 2});
}

}  // namespace raio::test
