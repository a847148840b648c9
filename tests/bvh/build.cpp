#include <raio/bvh/build.hpp>

#include "support/binary_trees.hpp"

namespace raio::test {

namespace {

constexpr std::uint32_t one_kind[] = {0};

/// \param limits  so small that all of the builder has work to do
binary_tree built(std::vector<build_box> references, detail::build_limits limits, unsigned threads = 1,
                  std::span<const std::uint32_t> first_id = one_kind) {
    build_box centers;
    for (const build_box& box : references) centers.include(detail::center_box(box));
    return detail::binned_builder(references, centers, {first_id}, limits, threads).take();
}

/// Of the boxes of all nodes: how much there is to be met on the way to the leaves.
double area_of(const binary_tree& tree) {
    double sum = 0;
    for (const detail::binary_node& node : tree.nodes) sum += double(node.box.half_area());
    return sum;
}

std::size_t depth_of(const binary_tree& tree) {
    std::vector<std::size_t> depth(tree.nodes.size(), 0);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        if (tree.nodes[i].is_leaf()) continue;
        depth[tree.nodes[i].first()] = depth[tree.nodes[i].first() + 1] = depth[i] + 1;
    }
    return std::ranges::max(depth);
}

}  // namespace

TEST_CASE("binned_builder: a tree, of any number of boxes, however the work is dealt out") {
    random_numbers random(1);
    for (const std::size_t count : {0u, 1u, 2u, 3u, 7u, 100u, 3000u}) {
        const std::vector<build_box> references = random_references(random, count);
        for (const std::uint32_t leaf : {1u, 4u}) {
            for (const detail::build_limits limits :
                 {detail::build_limits{.leaf = leaf}, detail::build_limits{.leaf = leaf, .task = 64, .part = 50}}) {
                const binary_tree tree = built(references, limits);
                check_tree(tree, references, {one_kind}, leaf);
                for (const unsigned threads : {2u, 5u}) REQUIRE(same(tree, built(references, limits, threads)));
            }
        }
    }
}

TEST_CASE("binned_builder: what lies together stays together, however the work is dealt out") {
    random_numbers random(4);
    const std::vector<build_box> references = random_references(random, 2000);
    const double halved = area_of(built(references, {.leaf = 4, .depth = 0}));
    for (const std::uint32_t task : {64u, 8192u}) {
        CHECK(area_of(built(references, {.leaf = 4, .task = task, .part = 50})) < halved / 4);
    }
}

TEST_CASE("binned_builder: leaves of one kind") {
    random_numbers random(2);
    const std::vector<build_box> references = random_references(random, 2000);
    const std::uint32_t first_id[] = {0, 300, 300, 1500};
    check_tree(built(references, {.leaf = 4, .task = 64, .part = 50}, 2, first_id), references, {first_id}, 4);
}

TEST_CASE("binned_builder: boxes that cannot be told apart, or lie too deep, are halved") {
    random_numbers random(3);
    std::vector<build_box> equal(1000, random_box(random)), nested;
    for (std::uint32_t i = 0; i < 1000; ++i) equal[i].set_id(i);
    for (const std::uint32_t task : {64u, 8192u}) {
        const binary_tree tree = built(equal, {.leaf = 4, .task = task, .part = 50});
        check_tree(tree, equal, {one_kind}, 4);
        CHECK(depth_of(tree) == 8);
    }
    // Each a hundredth of the one before: every cut takes few away.
    for (std::uint32_t i = 0; i < 200; ++i) {
        const float size = std::ldexp(1.0f, -static_cast<int>(i % 100));
        nested.push_back(detail::to_build_box(aabb<float>{{size, size, 0}, {size * 1.25f, size * 1.25f, size}}, i));
    }
    for (const std::uint32_t task : {16u, 8192u}) {
        const binary_tree deep = built(nested, {.leaf = 1, .task = task, .part = 10});
        const binary_tree shallow = built(nested, {.leaf = 1, .task = task, .part = 10, .depth = 3});
        check_tree(deep, nested, {one_kind}, 1);
        check_tree(shallow, nested, {one_kind}, 1);
        CHECK(depth_of(deep) > 20);
        CHECK(depth_of(shallow) <= 3 + 8);
    }
}

}  // namespace raio::test
