#pragma once

#include <raio/push_macros.hpp>

#include <raio/bvh/binary_tree.hpp>
#include <raio/bvh/parallel.hpp>
#include <raio/bvh/wide_node.hpp>
#include <raio/number/real.hpp>

/// \file
/// The wide tree out of the binary one, of all that could be made of it the one of least cost.
///
/// A binary node may become a leaf, or a wide node, or fall away, and its children take its place. Let c(n, i) be the
/// least cost of what stands for n in at most i places of a wide node. It is found from that of the children, from the
/// bottom to the top (Ylitie, Karras and Laine, Efficient incoherent ray traversal on GPUs through compressed wide
/// BVHs, 2017):
///
///     c(n, 1) = min(leaf(n), area(n) + memory(n) + d(n, width)),   c(n, i) = min(d(n, i), c(n, i - 1)),
///     d(n, i) = min over k of c(left, k) + c(right, i - k),
///
/// where memory(n) keeps trees whose leaves are single shapes from nodes that are all but empty.

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// The references that make a leaf.
struct leaf_range {
    std::uint32_t first, count;
};

/// What a wide node that is made of this one costs for the memory that it takes: the more, the fewer shapes share it.
/// Blocks of shapes fill it by themselves. (Measured: of 100,000 discs, 0, 2 and 8 times the area over the count make a
/// tree of 17.6, 14.0 and 10.5 MB, through which a ray goes in 29.0, 29.2 and 30.1 nodes.)
/// \param lanes  how many shapes of each kind a leaf holds
inline float memory_cost(const binary_node& n, std::span<const std::uint32_t> lanes) {
    if (n.kind() != binary_node::mixed && lanes[n.kind()] > 1) return 0;
    return 8 * n.box.half_area() / static_cast<float>(n.count());
}

struct wide_tree {
    large_vector<wide_node> nodes;                 ///< the root is node 0
    std::vector<large_vector<leaf_range>> leaves;  ///< of each kind
    /// Of a ray through the box of all: the surface area heuristic, a node counting 1. The root alone
    /// counts if that box has no area.
    double cost = 0;
};

class collapser {
public:
    /// \param lanes  how many shapes of each kind a leaf holds at most; all of them cost what a node costs
    collapser(const binary_tree& tree, std::span<const std::uint32_t> lanes, unsigned threads)
        : binary_(tree), lanes_(lanes), cost_(tree.nodes.size() / 2) {
        wide_.leaves.resize(lanes.size());
        if (tree.nodes.empty()) return;
        // The nodes of a part have their children in it, but for the first part, which is on top of all.
        parallel_for(tree.parts.size() - 1, threads, [&](std::size_t i) { find_costs(tree.parts[i + 1]); });
        find_costs(tree.parts[0]);
        emit_all(threads);
    }

    wide_tree take() { return std::move(wide_); }

private:
    static constexpr std::size_t width = node_width;
    static constexpr std::uint32_t branch_size = 4096;

    /// c(n, 1), c(n, 2), ... c(n, width)
    using costs = pack<float, width>;

    struct open_place {
        std::uint32_t node;  ///< of the binary tree
        std::size_t places;
    };

    float area(std::uint32_t n) const { return binary_.nodes[n].box.half_area(); }

    float leaf_cost(const binary_node& n) const {
        if (n.kind() == binary_node::mixed || n.count() > lanes_[n.kind()]) return build_box::none;
        return n.box.half_area();
    }

    /// c(n, places)
    float cost(std::uint32_t n, std::size_t places) const {
        const binary_node& node = binary_.nodes[n];
        return node.is_leaf() ? leaf_cost(node) : cost_[node.first() / 2][places - 1];
    }
    costs all_costs(const binary_node& n) const { return n.is_leaf() ? costs(leaf_cost(n)) : cost_[n.first() / 2]; }

    void find_costs(part range) {
        // Before the first number there is none: as many as it takes to start anywhere.
        std::array<float, 2 * width> rest;
        rest.fill(build_box::none);
        for (std::size_t i = range.end; i-- > range.begin;) {
            const binary_node& n = binary_.nodes[i];
            if (n.is_leaf()) continue;
            const binary_node *one = &binary_.nodes[n.first()], *other = one + 1;
            if (other->is_leaf()) std::swap(one, other);
            all_costs(*other).store(rest.data() + width);
            costs distributed(build_box::none);
            const auto give = [&](float cost, std::size_t places) {
                distributed = costs::min(distributed, costs(cost) + costs::load(rest.data() + width - places));
            };
            if (one->is_leaf()) {
                give(leaf_cost(*one), 1);  // which wants no more
            } else {
                for (std::size_t k = 1; k < width; ++k) give(cost_[one->first() / 2][k - 1], k);
            }
            const float as_node = n.box.half_area() + memory_cost(n, lanes_) + distributed[width - 1];
            // More places never cost more.
            cost_[n.first() / 2] = costs::min(distributed, costs(std::min(leaf_cost(n), as_node)));
        }
    }

    /// How many of the places the left child takes, of those that n is distributed to.
    std::size_t left_share(const binary_node& n, std::size_t places) const {
        const binary_node &left = binary_.nodes[n.first()], &right = binary_.nodes[n.first() + 1];
        if (left.is_leaf()) return 1;
        if (right.is_leaf()) return places - 1;
        // The least sum is the cost, or n would not be distributed to them.
        const float least = cost_[n.first() / 2][places - 1];
        const auto sum = [&](std::size_t k) {
            return cost_[left.first() / 2][k - 1] + cost_[right.first() / 2][places - k - 1];
        };
        std::size_t k = 1;
        while (k + 1 < places && sum(k) != least) ++k;
        return k;
    }

    /// The binary nodes that stand in a wide node made of n.
    template <class Visit>
    void for_each_child(std::uint32_t n, Visit visit) const {
        std::array<open_place, width> stack;
        std::size_t open = 0;
        const auto distribute = [&](std::uint32_t i, std::size_t places) {
            const binary_node& node = binary_.nodes[i];
            const std::size_t left = left_share(node, places);
            stack[open++] = {node.first() + 1, places - left};
            stack[open++] = {node.first(), left};
        };
        if (becomes_leaf(n)) {
            visit(n);
            return;
        }
        distribute(n, width);
        while (open > 0) {
            open_place p = stack[--open];
            while (p.places > 1 && !(cost(p.node, p.places) < cost(p.node, p.places - 1))) --p.places;
            if (p.places == 1) {
                visit(p.node);
            } else {
                distribute(p.node, p.places);
            }
        }
    }

    bool becomes_leaf(std::uint32_t n) const {
        // What cannot be a leaf costs less than infinity, as which it counts: boxes are within 2^41, and the leaves
        // fit.
        const binary_node& node = binary_.nodes[n];
        return node.is_leaf() || leaf_cost(node) <= cost(n, 1);
    }

    /// A wide node to be. Places are counted in the branch that it belongs to.
    struct choice {
        std::array<std::uint32_t, width> children;  ///< nodes of the binary tree, leaves first
        std::uint32_t count = 0, leaf_count = 0;
        std::uint32_t place = 0, first_node = 0;
    };

    /// The wide nodes below one of the binary tree, each of which has its children side by side.
    struct branch {
        std::uint32_t root = 0;   ///< of the binary tree
        std::uint32_t place = 0;  ///< of that one in the wide tree
        std::uint32_t places = 1;
        std::vector<choice> nodes{};
        std::vector<std::uint32_t> leaf_count{};  ///< of each kind
        std::uint32_t first_node = 1;             ///< where those below the root stand in the wide tree
        std::vector<std::uint32_t> first_leaf{};  ///< and the leaves of each kind
        double cost = 0;                          ///< of all of these
    };

    choice choose_children(std::uint32_t n) const {
        // Leaves have the first places; and where any hit will do, it is soonest found in a large child.
        choice made;
        std::array<std::pair<bool, float>, width> ranks;
        for_each_child(n, [&](std::uint32_t child) {
            const std::pair rank(becomes_leaf(child), area(child));
            std::size_t i = made.count++;
            for (; i > 0 && ranks[i - 1] < rank; --i) ranks[i] = ranks[i - 1], made.children[i] = made.children[i - 1];
            ranks[i] = rank, made.children[i] = child;
            made.leaf_count += rank.first ? 1 : 0;
        });
        return made;
    }

    /// \param below  if given, takes the branches that begin at nodes of few references
    void choose(branch& all, std::vector<branch>* below) const {
        struct open_node {
            std::uint32_t binary, place;
        };
        all.leaf_count.assign(lanes_.size(), 0);
        std::vector<open_node> stack{{all.root, 0}};
        while (!stack.empty()) {
            const open_node current = stack.back();
            stack.pop_back();
            if (below && binary_.nodes[current.binary].count() <= branch_size) {
                below->push_back({.root = current.binary, .place = current.place});
                continue;
            }
            choice made = choose_children(current.binary);
            made.place = current.place, made.first_node = all.places;
            if (!becomes_leaf(current.binary)) all.cost += static_cast<double>(area(current.binary));
            for (std::uint32_t i = 0; i < made.leaf_count; ++i) {
                const binary_node& leaf = binary_.nodes[made.children[i]];
                ++all.leaf_count[leaf.kind()];
                all.cost += static_cast<double>(leaf_cost(leaf));
            }
            all.places += made.count - made.leaf_count;
            for (std::uint32_t i = made.count; i-- > made.leaf_count;) {
                stack.push_back({made.children[i], made.first_node + i - made.leaf_count});
            }
            all.nodes.push_back(made);
        }
    }

    void emit(branch& from) {
        for (const choice& chosen : from.nodes) {
            wide_node made;
            made.first_node = from.first_node + chosen.first_node - 1;
            made.leaf_count = chosen.leaf_count;
            for (std::uint32_t i = 0; i < chosen.count; ++i) {
                const binary_node& node = binary_.nodes[chosen.children[i]];
                made.set(i, node.box);
                if (i >= chosen.leaf_count) continue;
                const std::uint32_t leaf = from.first_leaf[node.kind()]++;
                made.leaves[i] = child::leaf(node.kind(), leaf);
                wide_.leaves[node.kind()][leaf] = {binary_.first_reference(chosen.children[i]), node.count()};
            }
            wide_.nodes[chosen.place == 0 ? from.place : from.first_node + chosen.place - 1] = made;
        }
    }

    void emit_all(unsigned threads) {
        branch top;
        std::vector<branch> branches;
        choose(top, &branches);
        parallel_for(branches.size(), threads, [&](std::size_t i) { choose(branches[i], nullptr); });
        branches.push_back(std::move(top));
        std::uint32_t first_node = branches.back().places;
        std::vector<std::uint32_t> first_leaf(lanes_.size(), 0);
        double cost = 0;
        for (branch& b : branches) {
            cost += b.cost;
            if (&b != &branches.back()) b.first_node = std::exchange(first_node, first_node + b.places - 1);
            b.first_leaf = first_leaf;
            for (std::size_t kind = 0; kind < lanes_.size(); ++kind) first_leaf[kind] += b.leaf_count[kind];
        }
        wide_.cost = quotient(cost, static_cast<double>(area(0)), 1.0);
        wide_.nodes.resize(first_node);
        for (std::size_t kind = 0; kind < lanes_.size(); ++kind) wide_.leaves[kind].resize(first_leaf[kind]);
        parallel_for(branches.size(), threads, [&](std::size_t i) { emit(branches[i]); });
    }

    const binary_tree& binary_;
    std::span<const std::uint32_t> lanes_;
    large_vector<costs> cost_;
    wide_tree wide_;
};

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
