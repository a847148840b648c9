#pragma once

#include <raio/bvh/binary_tree.hpp>

#include <doctest/doctest.h>

#include <array>

#include "support/slabs.hpp"

/// \file
/// What every tree of two children a node has to be, whoever makes it.

namespace raio::test {

using detail::binary_node;
using detail::binary_tree;

/// Boxes with the ids 0, 1, ..., some of them in one place.
inline std::vector<build_box> random_references(random_numbers& random, std::size_t count) {
    std::vector<build_box> references;
    for (std::size_t i = 0; i < count; ++i) {
        build_box box = random_box(random);
        if (i > 0 && random.one_in(10)) {
            box = references[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))];
        }
        box.set_id(static_cast<std::uint32_t>(i));
        references.push_back(box);
    }
    return references;
}

inline bool same_corners(const build_box& a, const build_box& b) {
    for (unsigned axis = 0; axis < 3; ++axis) {
        if (a.low(axis) != b.low(axis) || a.high(axis) != b.high(axis)) return false;
    }
    return true;
}

/// Each reference is in one leaf, leaves are small and of one kind, and nodes are what their children are together.
/// \param references  by their ids
inline void check_tree(const binary_tree& tree, std::span<const build_box> references, detail::kinds kind_of,
                       std::uint32_t leaf) {
    std::vector<std::uint32_t> ids(tree.order.begin(), tree.order.end());
    std::ranges::sort(ids);
    REQUIRE(ids.size() == references.size());
    for (std::uint32_t i = 0; i < ids.size(); ++i) REQUIRE(ids[i] == i);
    if (references.empty()) {
        REQUIRE(tree.nodes.empty());
        return;
    }
    REQUIRE((tree.first_reference(0) == 0 && tree.nodes[0].count() == references.size()));
    std::vector<int> parents(tree.nodes.size(), 0);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const binary_node& node = tree.nodes[i];
        if (node.is_leaf()) {
            REQUIRE((1 <= node.count() && node.count() <= leaf));
            build_box all;
            for (std::uint32_t j = node.first(); j < node.first() + node.count(); ++j) {
                all.include(references[tree.order[j]]);
                REQUIRE(kind_of(tree.order[j]) == node.kind());
            }
            REQUIRE(same_corners(node.box, all));
        } else {
            const std::uint32_t left = node.first();
            REQUIRE((left > i && left + 1 < tree.nodes.size()));
            ++parents[left], ++parents[left + 1];
            const binary_node &a = tree.nodes[left], &b = tree.nodes[left + 1];
            REQUIRE(tree.first_reference(left + 1) == tree.first_reference(left) + a.count());
            REQUIRE(a.count() + b.count() == node.count());
            REQUIRE(same_corners(node.box, hull(a.box, b.box)));
            REQUIRE(node.kind() == (a.kind() == b.kind() ? a.kind() : binary_node::mixed));
        }
    }
    for (std::size_t i = 0; i < parents.size(); ++i) REQUIRE(parents[i] == (i > 0 ? 1 : 0));
    // The parts are one behind the other, and but for the top each has in it what is below its nodes.
    std::size_t end = 0;
    for (const detail::part& p : tree.parts) {
        REQUIRE((p.begin == end && p.end <= tree.nodes.size()));
        for (std::size_t i = p.begin; end > 0 && i < p.end; ++i) {
            REQUIRE((tree.nodes[i].is_leaf() || tree.nodes[i].first() + 1 < p.end));
        }
        end = p.end;
    }
    REQUIRE(end == tree.nodes.size());
}

inline bool same(const binary_tree& a, const binary_tree& b) {
    return std::ranges::equal(a.order, b.order) &&
           std::ranges::equal(a.nodes, b.nodes, [](const binary_node& x, const binary_node& y) {
               return x.is_leaf() == y.is_leaf() && x.first() == y.first() && x.count() == y.count() &&
                      x.kind() == y.kind() && same_corners(x.box, y.box);
           });
}

}  // namespace raio::test
