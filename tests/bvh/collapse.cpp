#include <raio/bvh/collapse.hpp>

#include <doctest/doctest.h>

#include <set>

#include <raio/bvh/morton.hpp>

#include "support/binary_trees.hpp"

namespace raio::test {

using detail::leaf_range;
using detail::wide_tree;

namespace {

/// A tree that is one leaf needs no node to be found.
bool is_leaf(const wide_tree& wide) { return wide.nodes.size() == 1 && wide.nodes[0].leaf_count == 1; }

/// Each range of references is in one leaf, of its kind and no larger than that takes; each node has one parent; boxes
/// are around what is below them. What such a tree costs by its own boxes is what is said.
struct wide_check {
    const binary_tree& binary;
    const wide_tree& wide;
    std::span<const build_box> references;
    detail::kinds kind_of;
    std::span<const std::uint32_t> lanes;
    std::vector<int> seen = std::vector<int>(references.size(), 0);
    std::vector<int> visited = std::vector<int>(wide.nodes.size(), 0);
    double sum = 0, memory = 0;  ///< what it costs, and what the memory of its nodes would

    /// Answers with what is below, as if it were a leaf of the binary tree.
    binary_node check(std::uint32_t i) {
        const wide_node& node = wide.nodes[i];
        ++visited[i];
        build_box all;
        std::size_t count = 0;
        std::set<std::uint32_t> kinds;
        for (std::size_t place = 0; place < node_width; ++place) {
            const build_box box = node.box(place);
            if (box.low(0) > box.high(0)) continue;
            const std::uint32_t child = node.child_at(place);
            binary_node below;
            if (detail::child::is_leaf(child)) {
                REQUIRE(place < node.leaf_count);
                below = check_leaf(detail::child::kind(child), detail::child::block(child));
            } else {
                REQUIRE((i < child && child < wide.nodes.size()));
                below = check(child);
            }
            REQUIRE(same_corners(below.box, box));
            all.include(below.box);
            count += below.count();
            kinds.insert(below.kind());
        }
        const binary_node made =
            binary_node::leaf(all, 0, count, kinds.size() == 1 ? *kinds.begin() : binary_node::mixed);
        if (!is_leaf(wide)) sum += double(all.half_area()), memory += double(detail::memory_cost(made, lanes));
        return made;
    }

    binary_node check_leaf(std::uint32_t kind, std::uint32_t block) {
        const leaf_range range = wide.leaves[kind][block];
        REQUIRE((1 <= range.count && range.count <= lanes[kind]));
        build_box below;
        for (std::uint32_t j = range.first; j < range.first + range.count; ++j) {
            const std::uint32_t id = binary.order[j];
            REQUIRE(kind_of(id) == kind);
            ++seen[id];
            below.include(references[id]);
        }
        sum += double(below.half_area());
        return binary_node::leaf(below, 0, range.count, kind);
    }

    void operator()() {
        const double area = double(check(0).box.half_area());
        for (const int times : seen) REQUIRE(times == 1);
        for (const int times : visited) REQUIRE(times == 1);
        REQUIRE(wide.cost == doctest::Approx(area > 0 ? sum / area : 1).epsilon(1e-3));
    }
};

/// The least cost of all wide trees that can be made, that of their memory included, found by trying them.
struct brute_force {
    const binary_tree& binary;
    std::span<const std::uint32_t> lanes;

    double best(std::uint32_t n) const {
        const binary_node& node = binary.nodes[n];
        double least = infinity<double>;
        if (node.kind() != binary_node::mixed && node.count() <= lanes[node.kind()]) {
            least = double(node.box.half_area());
        }
        if (!node.is_leaf()) {
            for (std::size_t left = 1; left < node_width; ++left) {
                const double sum = in_places(node.first(), left) + in_places(node.first() + 1, node_width - left);
                least = std::min(least, double(node.box.half_area() + detail::memory_cost(node, lanes)) + sum);
            }
        }
        return least;
    }
    /// In at most so many places of the node above.
    double in_places(std::uint32_t n, std::size_t places) const {
        const binary_node& node = binary.nodes[n];
        double least = best(n);
        for (std::size_t left = 1; !node.is_leaf() && left < places; ++left) {
            least = std::min(least, in_places(node.first(), left) + in_places(node.first() + 1, places - left));
        }
        return least;
    }
};

binary_tree along_curve(std::span<const build_box> references, detail::kinds kind_of, std::uint32_t leaf) {
    return detail::morton_builder(references, detail::centers_of(references), kind_of, leaf, 1).take();
}

constexpr std::uint32_t blocks_of_four[] = {4};

}  // namespace

TEST_CASE("collapser: each reference in one leaf, and the cost as it is said") {
    random_numbers random(1);
    for (const std::size_t count : {1u, 2u, 3u, 5u, 17u, 100u, 5000u}) {
        const std::vector<build_box> references = random_references(random, count);
        const auto n = static_cast<std::uint32_t>(count);
        const std::uint32_t first_id[] = {0, n / 2, n / 2 + n / 3};
        for (const std::size_t kinds : {1u, 3u}) {
            const std::span<const std::uint32_t> ids = std::span(first_id).first(kinds);
            for (const std::uint32_t leaf : {1u, 4u}) {
                const std::uint32_t lanes_of_all[] = {4, 8, leaf};
                const std::span<const std::uint32_t> lanes = std::span(lanes_of_all).first(kinds);
                const binary_tree binary = along_curve(references, {ids}, leaf);
                const wide_tree wide = detail::collapser(binary, lanes, 1).take();
                wide_check{binary, wide, references, {ids}, lanes}();
            }
        }
    }
    const binary_tree none;
    CHECK(detail::collapser(none, blocks_of_four, 1).take().nodes.empty());
}

TEST_CASE("collapser: no wide tree costs less") {
    random_numbers random(2);
    for (int i = 0; i < 50; ++i) {
        const std::vector<build_box> references =
            random_references(random, static_cast<std::size_t>(random.integer(1, 9)));
        const std::uint32_t first_id[] = {0, 4};
        const std::uint32_t lanes[] = {random.one_in(2) ? 4u : 1u, random.one_in(2) ? 8u : 1u};
        const binary_tree binary = along_curve(references, {first_id}, 1);
        const wide_tree wide = detail::collapser(binary, lanes, 1).take();
        wide_check check{binary, wide, references, {first_id}, lanes};
        check();
        REQUIRE(check.sum + check.memory == doctest::Approx(brute_force{binary, lanes}.best(0)).epsilon(1e-5));
    }
}

TEST_CASE("collapser: from any number of threads the same") {
    random_numbers random(3);
    const std::vector<build_box> references = random_references(random, 50'000);
    const std::uint32_t first_id[] = {0};
    const binary_tree binary = along_curve(references, {first_id}, 4);
    const wide_tree one = detail::collapser(binary, blocks_of_four, 1).take();
    wide_check{binary, one, references, {first_id}, blocks_of_four}();
    for (const unsigned threads : {2u, 5u}) {
        const wide_tree several = detail::collapser(binary, blocks_of_four, threads).take();
        REQUIRE(several.cost == one.cost);
        REQUIRE(std::ranges::equal(several.leaves[0], one.leaves[0], {}, &leaf_range::first, &leaf_range::first));
        REQUIRE(std::ranges::equal(several.nodes, one.nodes, [](const wide_node& a, const wide_node& b) {
            return a.planes == b.planes && a.leaves == b.leaves && a.leaf_count == b.leaf_count &&
                   a.first_node == b.first_node;
        }));
    }
}

}  // namespace raio::test
