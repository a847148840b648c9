#include <raio/bvh/morton.hpp>

#include "support/binary_trees.hpp"

namespace raio::test {

namespace {

constexpr std::uint32_t one_kind[] = {0};

binary_tree built(std::span<const build_box> references, std::uint32_t leaf, unsigned threads,
                  std::span<const std::uint32_t> first_id = one_kind) {
    return detail::morton_builder(references, detail::centers_of(references), {first_id}, leaf, threads).take();
}

/// Where the centre of a box is along the curve: the bits of its cell in turn, x the lowest.
std::uint32_t code_of(const build_box& box, const build_box& centers) {
    std::uint32_t code = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const float scale = detail::cells_per_length(1024, centers.extent(axis));
        const auto cell = static_cast<std::uint32_t>((detail::center2(box, axis) - centers.low(axis)) * scale);
        for (unsigned bit = 0; bit < 10; ++bit) code |= (cell >> bit & 1) << (3 * bit + axis);
    }
    return code;
}

}  // namespace

TEST_CASE("morton_builder: a tree, of any number of boxes") {
    random_numbers random(1);
    for (const std::size_t count : {0u, 1u, 2u, 3u, 7u, 100u, 3000u}) {
        const std::vector<build_box> references = random_references(random, count);
        for (const std::uint32_t leaf : {1u, 4u, 8u})
            check_tree(built(references, leaf, 1), references, {one_kind}, leaf);
    }
}

TEST_CASE("morton_builder: leaves of one kind") {
    random_numbers random(2);
    const std::vector<build_box> references = random_references(random, 2000);
    const std::uint32_t first_id[] = {0, 300, 300, 1500};
    check_tree(built(references, 8, 1, first_id), references, {first_id}, 8);
    for (std::uint32_t i = 0; i < 4; ++i) {  // one of each kind in one place
        const std::uint32_t each[] = {0, 1, 2, 3};
        std::vector<build_box> equal(4, references[i]);
        for (std::uint32_t j = 0; j < 4; ++j) equal[j].set_id(j);
        check_tree(built(equal, 4, 1, each), equal, {each}, 1);
    }
}

TEST_CASE("morton_builder: along the curve, boxes of one cell as they came, and from any number of threads the same") {
    random_numbers random(3);
    for (const std::size_t count : {1000u, 50'000u}) {
        std::vector<build_box> references = random_references(random, count);
        for (build_box& box : references) box.v = box.v + build_box::numbers(static_cast<float>(random.uniform(0, 1)));
        for (std::uint32_t i = 0; i < count; ++i) references[i].set_id(i);
        const build_box centers = detail::centers_of(references);
        const binary_tree tree = built(references, 4, 1);
        check_tree(tree, references, {one_kind}, 4);
        const auto place = [&](std::uint32_t id) { return std::pair(code_of(references[id], centers), id); };
        for (std::size_t i = 1; i < count; ++i) REQUIRE(place(tree.order[i - 1]) < place(tree.order[i]));
        for (const unsigned threads : {2u, 5u}) REQUIRE(same(tree, built(references, 4, threads)));
    }
}

TEST_CASE("morton_builder: cut where the codes differ in the highest bit") {
    std::vector<build_box> references;
    for (const float x : {0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 100.0f}) {
        const auto id = static_cast<std::uint32_t>(references.size());
        references.push_back(detail::to_build_box(aabb<float>{{x, 0, 0}, {x, 1, 1}}, id));
    }
    const binary_tree tree = built(references, 1, 1);
    CHECK(tree.nodes[tree.nodes[0].first()].count() == 5);
    CHECK(tree.nodes[tree.nodes[0].first() + 1].count() == 1);
    const std::vector<build_box> equal(6, references[0]);  // nowhere: halves
    const binary_tree halves = built(equal, 1, 1);
    CHECK(halves.nodes[halves.nodes[0].first()].count() == 3);
}

TEST_CASE("morton_builder: what fills a few leaves is cut where they are full") {
    // A third of the boxes in one place, the others far away: the codes say where they are cut first.
    for (const std::size_t count : {9u, 20u, 30u, 31u, 32u}) {
        std::vector<build_box> references;
        for (std::size_t i = 0; i < count; ++i) {
            const float x = (i < count / 3 ? 0.0f : 1000.0f) + static_cast<float>(i);
            references.push_back(
                detail::to_build_box(aabb<float>{{x, 0, 0}, {x, 1, 1}}, static_cast<std::uint32_t>(i)));
        }
        const binary_tree tree = built(references, 8, 1);
        check_tree(tree, references, {one_kind}, 8);
        std::size_t leaves = 0;
        for (const detail::binary_node& node : tree.nodes) leaves += node.is_leaf() ? 1u : 0u;
        CHECK(leaves == (count + 7) / 8);
        const detail::binary_node& left = tree.nodes[tree.nodes[0].first()];
        CHECK(left.count() % 8 == 0);
        CHECK(std::abs(static_cast<double>(left.count()) - static_cast<double>(count / 3)) <= 8);
    }
}

}  // namespace raio::test
