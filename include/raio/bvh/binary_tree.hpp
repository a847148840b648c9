#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include <raio/bvh/build_box.hpp>
#include <raio/bvh/parallel.hpp>

namespace raio::detail {

/// A node of the tree that the builders make, of two children each, which stand side by side and behind their parent.
struct binary_node {
    static constexpr std::uint32_t mixed = ~std::uint32_t{0};

    build_box box;
    std::uint32_t left = 0;   ///< the first of both children; 0 for a leaf
    std::uint32_t first = 0;  ///< of the references below, in `binary_tree::order`
    std::uint32_t count = 0;  ///< how many these are
    std::uint32_t kind = 0;   ///< what type of shape they are, or `mixed`

    bool is_leaf() const { return left == 0; }
};

/// The root is node 0. Without references there are no nodes.
struct binary_tree {
    std::vector<binary_node> nodes;
    std::vector<std::uint32_t> order;  ///< ids of the references, those of a node side by side
    std::vector<part> parts;  ///< of the nodes: the top, then those whose nodes have all below in the same part
};

/// Of which type a shape is where there are several: each type has the ids from one number on.
struct kinds {
    std::span<const std::uint32_t> first_id;

    std::uint32_t operator()(std::uint32_t id) const {
        std::uint32_t kind = 0;
        while (kind + 1 < first_id.size() && first_id[kind + 1] <= id) ++kind;
        return kind;
    }

    /// The one of all the boxes' ids, or `mixed`.
    std::uint32_t common(std::span<const build_box> boxes) const {
        if (first_id.size() < 2) return 0;
        const std::uint32_t kind = (*this)(boxes.front().id());
        const bool same = std::ranges::all_of(boxes, [&](const build_box& b) { return (*this)(b.id()) == kind; });
        return same ? kind : binary_node::mixed;
    }
};

/// Makes a node from its children.
inline void unite_children(std::span<binary_node> nodes, std::size_t i) {
    if (nodes[i].is_leaf()) return;
    const binary_node &a = nodes[nodes[i].left], &b = nodes[nodes[i].left + 1];
    nodes[i].box = hull(a.box, b.box);
    nodes[i].kind = a.kind == b.kind ? a.kind : binary_node::mixed;
}

/// Lets branches grow where the nodes of a tree have ended so far, each a task of its own, which makes nodes of its
/// own: they are put behind those that are there.
/// \param grow  makes the nodes of branch `i`, whose root is node 0
template <class Grow>
void grow_branches(binary_tree& tree, std::span<const std::uint32_t> roots, unsigned threads, Grow grow) {
    std::vector<std::vector<binary_node>> grown(roots.size());
    parallel_for(roots.size(), threads, [&](std::size_t i) {
        grown[i] = grow(i);
        for (std::size_t j = grown[i].size(); j-- > 0;) unite_children(grown[i], j);
    });
    const std::size_t top = tree.nodes.size();
    std::size_t total = top;
    tree.parts.push_back({0, top});
    for (const auto& nodes : grown) {
        tree.parts.push_back({total, total + nodes.size() - 1});
        total += nodes.size() - 1;
    }
    tree.nodes.resize(total);
    parallel_for(roots.size(), threads, [&](std::size_t i) {
        const auto offset = static_cast<std::uint32_t>(tree.parts[i + 1].begin) - 1;  // node 0 has its place on top
        for (std::size_t j = 0; j < grown[i].size(); ++j) {
            binary_node& node = grown[i][j];
            if (!node.is_leaf()) node.left += offset;
            tree.nodes[j == 0 ? roots[i] : offset + j] = node;
        }
    });
    for (std::size_t i = top; i-- > 0;) unite_children(tree.nodes, i);
}

}  // namespace raio::detail
