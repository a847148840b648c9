#include <raio/bvh/binary_tree.hpp>

#include "support/binary_trees.hpp"

namespace raio::test {

namespace {

build_box box_with_id(std::uint32_t id) {
    const auto x = static_cast<float>(id);
    return detail::to_build_box(aabb<float>{{x, 0, 0}, {x + 1, 1, 1}}, id);
}

}  // namespace

TEST_CASE("kinds: each has the ids from one number on, be it none") {
    const std::uint32_t first_id[] = {0, 3, 3, 5};
    const detail::kinds kind_of{first_id};
    const std::uint32_t expected[] = {0, 0, 0, 2, 2, 3, 3};
    for (std::uint32_t id = 0; id < 7; ++id) CHECK(kind_of(id) == expected[id]);
    const auto common = [&](std::vector<std::uint32_t> ids) {
        std::vector<build_box> boxes;
        for (const std::uint32_t id : ids) boxes.push_back(box_with_id(id));
        return kind_of.common(boxes);
    };
    CHECK(common({1, 0, 2}) == 0);
    CHECK(common({4}) == 2);
    CHECK(common({6, 5}) == 3);
    CHECK(common({6, 5, 4}) == binary_node::mixed);
    CHECK(common({2, 3}) == binary_node::mixed);
    const std::uint32_t first_of_two[] = {0, 3};
    const std::vector<build_box> last{box_with_id(4)};
    CHECK(detail::kinds{first_of_two}.common(last) == 1);
}

TEST_CASE("binary_node: what it says, and of many references that they are many") {
    const binary_node leaf = binary_node::leaf(box_with_id(9), 0xfffffff0u, 8, 15);
    CHECK((leaf.is_leaf() && leaf.first() == 0xfffffff0u && leaf.count() == 8 && leaf.kind() == 15));
    CHECK(same_corners(leaf.box, box_with_id(9)));
    for (const std::size_t count : {std::size_t{9}, (std::size_t{1} << 26) - 1}) {
        binary_node parent = binary_node::parent(7, count);
        parent.move_children(4);
        CHECK((!parent.is_leaf() && parent.first() == 11 && parent.count() == count));
    }
    CHECK(binary_node::parent(1, std::size_t{1} << 26).count() == (1u << 26) - 1);
    CHECK(binary_node::parent(1, ~std::uint32_t{0}).kind() == binary_node::mixed);
}

TEST_CASE("unite_children: the hull, and the kind if it is one") {
    std::vector<binary_node> nodes{binary_node::parent(1, 5), binary_node::leaf(box_with_id(1), 0, 2, 7),
                                   binary_node::leaf(box_with_id(5), 2, 3, 7)};
    detail::unite_children(nodes, 2);  // a leaf stays as it is
    CHECK(same_corners(nodes[2].box, box_with_id(5)));
    detail::unite_children(nodes, 0);
    CHECK(same_corners(nodes[0].box, hull(box_with_id(1), box_with_id(5))));
    CHECK((!nodes[0].is_leaf() && nodes[0].first() == 1 && nodes[0].count() == 5 && nodes[0].kind() == 7));
    nodes[1] = binary_node::leaf(box_with_id(1), 0, 2, 3);
    detail::unite_children(nodes, 0);
    CHECK(nodes[0].kind() == binary_node::mixed);
}

TEST_CASE("grow_branches: each branch behind the one before, its root in its place on top") {
    const auto leaf = [](std::uint32_t id) { return binary_node::leaf(box_with_id(id), id, 1, 0); };
    const std::vector<binary_node> top{binary_node::parent(1, 5), {}, {}};
    const std::vector<std::vector<binary_node>> branches{
        {binary_node::parent(1, 2), leaf(0), leaf(1)},
        {binary_node::parent(1, 3), leaf(2), binary_node::parent(3, 2), leaf(3), leaf(4)}};
    for (const unsigned threads : {1u, 2u}) {
        binary_tree tree;
        detail::grow_branches(tree, top, std::vector<std::uint32_t>{2, 1}, threads,
                              [&](std::size_t i) { return branches[i]; });
        REQUIRE(tree.nodes.size() == 9);
        const auto part = [&](std::size_t i) { return std::array{tree.parts[i].begin, tree.parts[i].end}; };
        REQUIRE(tree.parts.size() == 3);
        CHECK((part(0) == std::array<std::size_t, 2>{0, 3} && part(1) == std::array<std::size_t, 2>{3, 5} &&
               part(2) == std::array<std::size_t, 2>{5, 9}));
        const std::uint32_t first[] = {1, 5, 3, 0, 1, 2, 7, 3, 4};  // child or reference
        for (std::size_t i = 0; i < 9; ++i) {
            CHECK(tree.nodes[i].first() == first[i]);
            CHECK(tree.nodes[i].is_leaf() == (i > 2 && i != 6));
        }
        CHECK(same_corners(tree.nodes[0].box, hull(box_with_id(0), box_with_id(4))));
        CHECK(same_corners(tree.nodes[1].box, hull(box_with_id(2), box_with_id(4))));
        CHECK(same_corners(tree.nodes[2].box, hull(box_with_id(0), box_with_id(1))));
    }
}

}  // namespace raio::test
