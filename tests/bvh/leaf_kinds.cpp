#include <raio/bvh/leaf_kinds.hpp>

#include <doctest/doctest.h>

#include <raio/shape/convex_polyhedron.hpp>
#include <raio/shape/sphere.hpp>

#include "support/random.hpp"

namespace raio::test {

namespace {

template <class T>
using two_kinds = detail::leaf_kinds<detail::leaf_blocks<sphere<T>>, detail::leaf_list<convex_polyhedron<T>>>;

/// Two spheres in one block, and two solids.
template <class T>
two_kinds<T> some_leaves() {
    two_kinds<T> leaves;
    auto& [spheres, solids] = leaves.all;
    const std::uint32_t ids[] = {0, 1, 2, 3};
    const std::span all(ids);
    const detail::leaf_range of_spheres[] = {{0, 2}}, of_solids[] = {{0, 1}, {1, 1}};
    spheres.resize(of_spheres), solids.resize(of_solids);
    spheres.fill(0, all.first(2), [](std::uint32_t id) { return sphere<T>{{0, 0, -5 * T(id + 1)}, 1}; });
    const auto solid_of = [](std::uint32_t) { return convex_polyhedron<T>{{{{1, 0, 0}, 0}}}; };
    solids.fill(0, all.first(1), solid_of), solids.fill(1, all.last(1), solid_of);
    return leaves;
}

template <int>
struct numbered {
    using T = float;
};
template <std::size_t... I>
auto as_many(std::index_sequence<I...>) {
    return detail::leaf_kinds<numbered<I>...>{};
}

}  // namespace

TEST_CASE_TEMPLATE("leaf_kinds: packs say what they find in the leaves that have some, of others nothing is known", T,
                   RAIO_NUMBERS) {
    const two_kinds<T> leaves = some_leaves<T>();
    const ray<T> along{{0, 0, 0}, {0, 0, -2}};
    auto spheres = leaves.template find<0>(0, along, T(0), infinity<T>);
    CHECK((spheres.sure == 3 && spheres.open == 0));
    CHECK((spheres.low[1] <= T(4.5) && T(4.5) <= spheres.high[1]));
    spheres = leaves.template find<0>(0, along, T(0), T(3));
    CHECK((spheres.sure == 1 && spheres.open == 0));
    const auto solid = leaves.template find<1>(1, along, T(0), infinity<T>);
    CHECK((solid.sure == 0 && solid.open == 1));
    static_assert(two_kinds<T>::template filters<0, ray<T>> && !two_kinds<T>::template filters<1, ray<T>>);
}

TEST_CASE_TEMPLATE("leaf_kinds: packs know of rays that were mapped", T, RAIO_NUMBERS) {
    const two_kinds<T> leaves = some_leaves<T>();
    const ray<T> world{{0, 0, 0}, {0, 0, -2}};
    const inverse_map<T> nearer(translation<T>({0, 0, T(0.25)}));
    const mapped_ray<T> along(world, nearer);
    const auto spheres = leaves.template find<0>(0, along, T(0), T(3));
    CHECK((spheres.sure == 1 && spheres.open == 0));
    const auto solids = leaves.template find<1>(0, along, T(0), T(3));
    CHECK((solids.sure == 0 && solids.open == 1));
}

TEST_CASE("leaf_kinds: the number of a kind becomes a constant, and of what is done with it comes the answer") {
    using kinds = decltype(as_many(std::make_index_sequence<16>{}));
    for (std::uint32_t i = 0; i < 16; ++i) {
        int calls = 0;
        const std::size_t found = kinds::with_kind(i, [&](auto kind) {
            static_assert(kind() < 16);
            ++calls;
            return kind();
        });
        CHECK((found == i && calls == 1));
    }
    CHECK(two_kinds<float>::with_kind(1, [](auto kind) { return kind() == 1; }));
}

}  // namespace raio::test
