#pragma once

#include <raio/push_macros.hpp>

#include <algorithm>
#include <span>
#include <vector>

#include <raio/bvh/build_box.hpp>
#include <raio/bvh/large_pages.hpp>
#include <raio/bvh/parallel.hpp>

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// A node of the tree that the builders make, of two children each, which stand side by side and behind their parent.
/// All beside the box stands in the room that a box has for it.
struct binary_node {
    static constexpr std::uint32_t mixed = 31;

    build_box box;

    static binary_node leaf(const build_box& box, std::uint32_t first, std::size_t count, std::uint32_t kind) {
        return with(box, first, leaf_bit | facts_of(count, kind));
    }
    /// What its box and its kind are is found in its children: see `unite`.
    static binary_node parent(std::size_t first_child, std::size_t count) {
        return with({}, static_cast<std::uint32_t>(first_child), facts_of(count, mixed));
    }

    bool is_leaf() const { return (box.note() & leaf_bit) != 0; }
    std::uint32_t first() const { return box.id(); }           ///< of both children, or of a leaf's references
    std::uint32_t count() const { return box.note() & many; }  ///< of references below; no more than `many` are told
    bool tells_count() const { return count() != many; }
    std::uint32_t kind() const { return box.note() >> kind_shift & mixed; }  ///< what type they are, or `mixed`

    void unite(const binary_node& a, const binary_node& b) {
        *this = with(hull(a.box, b.box), first(), facts_of(count(), a.kind() == b.kind() ? a.kind() : mixed));
    }

    void move_children(std::uint32_t by) { box.set_id(first() + by); }

private:
    static constexpr unsigned kind_shift = 26;
    static constexpr std::uint32_t leaf_bit = 1u << 31, many = (1u << kind_shift) - 1;

    static std::uint32_t facts_of(std::size_t count, std::uint32_t kind) {
        return kind << kind_shift | static_cast<std::uint32_t>(std::min<std::size_t>(count, many));
    }
    static binary_node with(const build_box& box, std::uint32_t first, std::uint32_t facts) {
        binary_node node{box};
        node.box.set_id(first);
        node.box.set_note(facts);
        return node;
    }
};

/// The root is node 0. Without references there are no nodes.
struct binary_tree {
    large_vector<binary_node> nodes;
    large_vector<std::uint32_t> order;  ///< ids of the references, those of a node side by side
    std::vector<part> parts;  ///< of the nodes: the top, then those whose nodes have all below in the same part

    /// Of those below a node, which come one after the other in `order`.
    std::uint32_t first_reference(std::size_t n) const {
        while (!nodes[n].is_leaf()) n = nodes[n].first();
        return nodes[n].first();
    }
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
    const std::uint32_t left = nodes[i].first();
    nodes[i].unite(nodes[left], nodes[left + 1]);
}

/// Lets branches grow where the nodes on top of a tree have ended, each a task of its own, which makes nodes of its
/// own: they are put behind those on top.
/// \param grow  makes the nodes of branch `i`, whose root is node 0
template <class Grow>
void grow_branches(binary_tree& tree, std::span<const binary_node> top, std::span<const std::uint32_t> roots,
                   unsigned threads, Grow grow) {
    std::vector<std::vector<binary_node>> grown(roots.size());
    parallel_for(roots.size(), threads, [&](std::size_t i) {
        grown[i] = grow(i);
        for (std::size_t j = grown[i].size(); j-- > 0;) unite_children(grown[i], j);
    });
    std::size_t total = top.size();
    tree.parts.push_back({0, total});
    for (const auto& nodes : grown) {
        tree.parts.push_back({total, total + nodes.size() - 1});
        total += nodes.size() - 1;
    }
    tree.nodes.resize(total);
    std::ranges::copy(top, tree.nodes.begin());
    parallel_for(roots.size(), threads, [&](std::size_t i) {
        const auto offset = static_cast<std::uint32_t>(tree.parts[i + 1].begin) - 1;  // node 0 has its place on top
        for (std::size_t j = 0; j < grown[i].size(); ++j) {
            binary_node& node = grown[i][j];
            if (!node.is_leaf()) node.move_children(offset);
            tree.nodes[j == 0 ? roots[i] : offset + j] = node;
        }
    });
    for (std::size_t i = top.size(); i-- > 0;) unite_children(tree.nodes, i);
}

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
