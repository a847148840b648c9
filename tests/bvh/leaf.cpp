#include <raio/bvh/leaf.hpp>

#include <doctest/doctest.h>

#include <raio/shape/convex_polyhedron.hpp>
#include <raio/shape/sphere.hpp>

#include "support/random.hpp"

namespace raio::test {

static_assert(std::same_as<detail::leaves_of<sphere<float>>, detail::leaf_blocks<sphere<float>>>);
static_assert(std::same_as<detail::leaves_of<convex_polyhedron<float>>, detail::leaf_list<convex_polyhedron<float>>>);

namespace {

/// What may be known of a crossing and the window [1, 2].
enum class state { inside, before, beyond, nowhere, open };

struct known_crossing {
    bool exists, certain;
    double t, error;
    state is;
};
const known_crossing known_crossings[] = {
    {true, true, 1.5, 0.25, state::inside},   {true, true, 1.25, 0.25, state::inside},  // as far as the end
    {true, true, 1.75, 0.25, state::inside},  {true, true, 1, 0, state::inside},
    {true, true, 2, 0, state::inside},        {true, true, 0.5, 0.25, state::before},
    {true, true, 2.5, 0.25, state::beyond},   {true, true, 0.75, 0.25, state::open},  // up to the end
    {true, true, 2.25, 0.25, state::open},    {true, true, 1.5, 2, state::open},
    {true, true, 1.5, NAN, state::open},      {true, true, NAN, 0, state::open},
    {false, true, 1.5, 0.25, state::nowhere}, {false, true, NAN, NAN, state::nowhere},
    {true, false, 1.5, 0.25, state::open},    {false, false, 1.5, 0.25, state::open},
    {true, false, 0.5, 0.25, state::open},    {false, false, 2.5, 0.25, state::open},
};

template <class W>
crossing<W> in_every_lane(const known_crossing& k) {
    const mask_t<W> yes = W(0) == W(0), no = !yes;
    return {k.exists ? yes : no, k.certain ? yes : no, W(k.t), W(k.error), no};
}

template <class T, std::size_t N>
void check_lanes(std::uint32_t lanes, bool expected) {
    CHECK((lanes & ((1u << N) - 1)) == (expected ? (1u << N) - 1 : 0));
}

}  // namespace

TEST_CASE_TEMPLATE("judge: what is known of a crossing", T, RAIO_NUMBERS) {
    using W = pack<T, 4>;
    for (const known_crossing& k : known_crossings) {
        CAPTURE(&k - known_crossings);
        const detail::findings<T, 4> found = detail::judge(in_every_lane<W>(k), W(1), W(2));
        check_lanes<T, 4>(found.sure, k.is == state::inside);
        check_lanes<T, 4>(found.open, k.is == state::open);
        if (k.is == state::inside) CHECK((found.low[3] == T(k.t - k.error) && found.high[3] == T(k.t + k.error)));
    }
}

TEST_CASE_TEMPLATE("judge: of a chord the first in the window", T, RAIO_NUMBERS) {
    using W = pack<T, 4>;
    for (const known_crossing& near : known_crossings) {
        for (const known_crossing& far : known_crossings) {
            CAPTURE(&near - known_crossings);
            CAPTURE(&far - known_crossings);
            if (near.is == state::before && far.is == state::nowhere) continue;  // only a far end stands alone
            // Nothing comes behind what is beyond; and what is passed leaves the far end to say it.
            const bool is_passed = near.is == state::before || near.is == state::nowhere;
            const known_crossing& decisive = is_passed ? far : near;
            const chord<W> c{in_every_lane<W>(near), in_every_lane<W>(far)};
            const detail::findings<T, 4> found = detail::judge(c, W(1), W(2));
            check_lanes<T, 4>(found.sure, decisive.is == state::inside);
            check_lanes<T, 4>(found.open, decisive.is == state::open);
            if (decisive.is == state::inside) {
                CHECK(found.low[3] == T(decisive.t - decisive.error));
                CHECK(found.high[3] == T(decisive.t + decisive.error));
            }
        }
    }
}

TEST_CASE_TEMPLATE("leaf_blocks: shapes with their ids, each once, and nothing in the lanes that are left", T,
                   RAIO_NUMBERS) {
    detail::leaf_blocks<sphere<T>> leaves;
    const auto shape_of = [](std::uint32_t id) { return sphere<T>{{0, 0, -T(id)}, T(0.5)}; };
    const detail::leaf_range ranges[] = {{0, 4}, {4, 1}};
    const std::uint32_t ids[] = {7, 3, 7, 3, 5};
    leaves.resize(ranges);
    REQUIRE(leaves.size() == 2);
    CHECK((leaves.bytes() >= 8 * sizeof(sphere<T>) && leaves.bytes() < 100 * sizeof(sphere<T>)));
    leaves.fill(0, std::span(ids).first(4), shape_of);
    leaves.fill(1, std::span(ids).last(1), shape_of);
    CHECK(leaves.used(0) == 3);
    CHECK((leaves.id(0, 0) == 3 && leaves.id(0, 1) == 7));
    CHECK(leaves.shape(0, 1).center == vec3<T>(0, 0, -7));
    CHECK((leaves.used(1) == 1 && leaves.id(1, 0) == 5));

    const ray<T> r{{0, 0, 0}, {0, 0, -1}};
    auto found = leaves.find(0, r, T(0), infinity<T>);
    CHECK((found.sure == 3 && found.open == 0));
    CHECK((found.low[0] <= T(2.5) && T(2.5) <= found.high[0]));
    CHECK((found.low[1] <= T(6.5) && T(6.5) <= found.high[1]));
    found = leaves.find(0, r, T(4), infinity<T>);
    CHECK((found.sure == 2 && found.open == 0));
    found = leaves.find(1, r, T(0), infinity<T>);
    CHECK((found.sure == 1 && found.open == 0));
    found = leaves.find(1, r, T(6), infinity<T>);
    CHECK((found.sure == 0 && found.open == 0));
    found = leaves.find(1, r, T(4.5), infinity<T>);  // just there: the plain shape has to say it
    CHECK((found.sure == 0 && found.open == 1));

    leaves.set(1, 0, sphere<T>{{0, 0, -9}, T(0.5)});
    CHECK(leaves.shape(1, 0).center == vec3<T>(0, 0, -9));
    CHECK(leaves.find(1, r, T(6), infinity<T>).sure == 1);
    const auto unknown = detail::open_lanes(leaves, 0);
    CHECK((unknown.sure == 0 && unknown.open == 3));
}

TEST_CASE_TEMPLATE("leaf_list: shapes with their ids, one leaf behind the other", T, RAIO_NUMBERS) {
    detail::leaf_list<convex_polyhedron<T>> leaves;
    const auto shape_of = [](std::uint32_t id) {
        return convex_polyhedron<T>{std::vector<half_space<T>>(id, half_space<T>{{1, 0, 0}, 0})};
    };
    const detail::leaf_range ranges[] = {{0, 3}, {3, 1}};
    const std::uint32_t ids[] = {7, 3, 4, 5};
    leaves.resize(ranges);
    REQUIRE(leaves.size() == 2);
    leaves.fill(0, std::span(ids).first(3), shape_of);
    leaves.fill(1, std::span(ids).last(1), shape_of);
    CHECK((leaves.used(0) == 7 && leaves.used(1) == 1));
    CHECK((leaves.bytes() >= 4 * sizeof(shape_of(1)) && leaves.bytes() < 20 * sizeof(shape_of(1))));
    for (unsigned lane = 0; lane < 3; ++lane) {
        CHECK(leaves.id(0, lane) == ids[lane]);
        CHECK(leaves.shape(0, lane).planes.size() == ids[lane]);
    }
    CHECK((leaves.id(1, 0) == 5 && leaves.shape(1, 0).planes.size() == 5));
    leaves.set(0, 2, shape_of(9));
    CHECK((leaves.shape(0, 2).planes.size() == 9 && leaves.shape(1, 0).planes.size() == 5));
    const auto unknown = detail::open_lanes(leaves, 0);
    CHECK((unknown.sure == 0 && unknown.open == 7));
}

}  // namespace raio::test
