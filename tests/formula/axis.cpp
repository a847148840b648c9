#include <raio/formula/axis.hpp>

#include <doctest/doctest.h>

namespace raio::test {

using W = strict_double;
using X = double_double;

namespace {

/// Between the planes at heights 0 and 2 along an axis of length 2, from a height of that.
template <class N>
chord<N> slab(double height, double down, double error = 0) {
    const auto off = [&](double x) { return bounded_number<N>(N(x), bound_t<N>(error)); };
    return detail::cross_slab<N>(given_vector<N>{N(0), N(0), N(2)}, off(-2 * height), off(4 - 2 * height),
                                 given_vector<N>{N(1), N(0), N(-down)});
}

/// Below the plane at height 2, across which the axis has the length 2.
template <class N>
chord<N> below(double height, double down) {
    const vec3<double> vertex(0, 0, 0), top(0, 0, 2);
    const ray<double> ray{{0, 0, height}, {1, 0, -down}};
    return detail::cross_upper_plane(vertex, top, line_in<N>(ray));
}

bool sure_of(const chord<W>& c, bool exists) {
    return c.near.certain && c.far.certain && c.near.exists == exists && c.far.exists == exists;
}

}  // namespace

TEST_CASE("axis: a slab is entered by the one plane and left by the other") {
    const chord<W> down = slab<W>(4, 1), up = slab<W>(-4, -0.5);
    CHECK((sure_of(down, true) && sure_of(up, true)));
    CHECK((down.near.t == W(2) && down.far.t == W(4) && down.near.face == 2 && down.far.face == 1));
    CHECK((up.near.t == W(8) && up.far.t == W(12) && up.near.face == 1 && up.far.face == 2));
    CHECK((down.near.entering && !down.far.entering && up.near.entering && !up.far.entering));
}

TEST_CASE("axis: parallel to the planes a line is between them everywhere or nowhere, as the last precision says") {
    for (const double height : {-1.0, -0.125, 0.0, 0.125, 1.0, 1.875, 2.0, 2.125, 3.0}) {
        const chord<W> open = slab<W>(height, 0);
        CHECK((!open.near.certain && !open.far.certain));
        const bool between = 0 <= height && height <= 2;
        const chord<X> last = slab<X>(height, 0);
        CHECK((last.near.exists == between && last.far.exists == between));
        CHECK((last.near.t == X(-INFINITY) && last.far.t == X(INFINITY)));
        CHECK(slab<double>(height, 0).near.exists == between);
    }
    for (const double height : {-0.125, 2.125}) CHECK((slab<X>(height, 0, 0.5).near.exists));
}

TEST_CASE("axis: below a plane a line begins or ends, or is at no end") {
    CHECK((sure_of(below<W>(4, 1), true) && below<W>(4, 1).near.t == W(2) && below<W>(4, 1).far.t == W(INFINITY)));
    CHECK((sure_of(below<W>(4, -1), true) && below<W>(4, -1).near.t == W(-INFINITY) && below<W>(4, -1).far.t == W(-2)));
    CHECK((below<X>(1, 0).near.exists && below<X>(1, 0).near.t == X(-INFINITY) && below<X>(1, 0).far.t == X(INFINITY)));
    CHECK((below<W>(4, 1).near.entering && !below<W>(4, 1).far.entering));
    CHECK((below<W>(1, 1).near.face == 2 && below<W>(1, 1).far.face == 2));
    CHECK((!below<X>(3, 0).near.exists && !below<W>(3, 0).near.certain));
    CHECK((below<double>(2, 0).near.exists && !below<double>(3, 0).near.exists && below<double>(3, 1).near.exists));

    // At no height, and the numbers that it is computed from are rounded: strict_double does not know the side.
    const vec3<double> vertex(0, 0, 0), top(0.1, 0.2, 0.3);
    const ray<double> along{{0.1 + 0.3, 0.2, 0.3 - 0.1}, {3, 0, -1}};
    const chord<W> open = detail::cross_upper_plane(vertex, top, line_in<W>(along));
    CHECK((!open.near.certain && !open.far.certain));
}

}  // namespace raio::test
