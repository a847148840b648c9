#include <raio/bvh/gather.hpp>

#include <doctest/doctest.h>

#include <bit>

#include <raio/compose/mesh.hpp>
#include <raio/shape/box.hpp>
#include <raio/shape/convex_polyhedron.hpp>
#include <raio/shape/cylinder.hpp>
#include <raio/shape/sphere.hpp>
#include <raio/shape/triangle.hpp>

#include "support/random.hpp"

namespace raio::test {

static_assert(detail::gatherable<sphere<float>> && detail::gatherable<sphere<double>>);
static_assert(detail::gatherable<triangle<float>> && detail::gatherable<cylinder<double>>);
static_assert(detail::gatherable<mesh_triangle<float>> && detail::brings_lanes<mesh_triangle<double>>);
static_assert(!detail::gatherable<convex_polyhedron<float>>);
static_assert(!detail::gatherable<sphere<pack<float, 4>>>);

namespace {

template <class Shape, std::size_t N>
void check_lanes_of() {
    constexpr std::size_t count = sizeof(Shape) / sizeof(number_t<Shape>);
    using numbers = std::array<number_t<Shape>, count>;
    random_numbers random(1);
    std::array<numbers, N> expected{};
    detail::gathered<Shape, N> room;
    const auto any_numbers = [&] {
        numbers some;
        for (auto& x : some) x = static_cast<number_t<Shape>>(random.uniform(-1, 1));
        return some;
    };
    for (std::size_t lane = 0; lane < N; ++lane) room.set(lane, std::bit_cast<Shape>(expected[lane] = any_numbers()));
    for (int i = 0; i < 100; ++i) {  // one is exchanged, and the others stay
        const auto lane = static_cast<std::size_t>(random.integer(0, static_cast<int>(N) - 1));
        room.set(lane, std::bit_cast<Shape>(expected[lane] = any_numbers()));
        for (std::size_t j = 0; j < N; ++j) REQUIRE(std::bit_cast<numbers>(room.get(j)) == expected[j]);
    }
    // Pack k holds number k of each shape.
    std::array<number_t<Shape>, count * N> packs;
    static_assert(sizeof(packs) == sizeof(room.shapes()));
    std::memcpy(packs.data(), &room.shapes(), sizeof(packs));
    for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t j = 0; j < N; ++j) REQUIRE(packs[k * N + j] == expected[j][k]);
    }
}

}  // namespace

TEST_CASE_TEMPLATE("gathered: what goes into a lane comes out of it, and the packs hold field by field", T,
                   RAIO_NUMBERS) {
    check_lanes_of<sphere<T>, 4>();
    check_lanes_of<triangle<T>, 8>();
    check_lanes_of<cylinder<T>, 4>();
    check_lanes_of<box<T>, 8>();
}

TEST_CASE("gathered: a shape of packs is made of its fields") {
    detail::gathered<sphere<float>, 4> room;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto x = static_cast<float>(i);
        room.set(i, {{x, 10 + x, 20 + x}, 30 + x});
    }
    for (std::size_t i = 0; i < 4; ++i) {
        const auto x = static_cast<float>(i);
        CHECK(room.shapes().center.x[i] == x);
        CHECK(room.shapes().center.y[i] == 10 + x);
        CHECK(room.shapes().center.z[i] == 20 + x);
        CHECK(room.shapes().radius[i] == 30 + x);
    }
}

}  // namespace raio::test
