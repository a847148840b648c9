#pragma once

#include <raio/bvh/binary_tree.hpp>
#include <raio/bvh/parallel.hpp>
#include <raio/bvh/wide_node.hpp>
#include <raio/math/real.hpp>

/// \file
/// The wide tree out of the binary one, of all that could be made of it the one of least cost.
///
/// A binary node may become a leaf, or a wide node, or fall away, and its children take its place. Let c(n, i) be the
/// least cost of what stands for n in at most i places of a wide node. It is found from that of the children, from the
/// bottom to the top (Ylitie, Karras and Laine, Efficient incoherent ray traversal on GPUs through compressed wide
/// BVHs, 2017):
///
///     c(n, 1) = min(leaf(n), area(n) node + d(n, width)),   c(n, i) = min(d(n, i), c(n, i - 1)),
///     d(n, i) = min over k of c(left, k) + c(right, i - k).

namespace raio::detail {

/// What a block of shapes of one kind costs beside a node, and how many it holds.
struct leaf_kind {
    std::uint32_t lanes;
    float block_cost;  ///< to test a block
    float shape_cost;  ///< and for each of its shapes

    float of(std::uint32_t count) const { return block_cost + static_cast<float>(count) * shape_cost; }
};

/// The references that make a leaf.
struct leaf_range {
    std::uint32_t first, count;
};

struct wide_tree {
    large_vector<wide_node> nodes;                ///< the root is node 0
    std::vector<std::vector<leaf_range>> leaves;  ///< of each kind
    /// Of a ray through the box of all: the surface area heuristic, a node counting 1. The root alone
    /// counts if that box has no area.
    double cost = 0;
};

class collapser {
public:
    collapser(const binary_tree& tree, std::span<const leaf_kind> kinds, unsigned threads)
        : binary_(tree), kinds_(kinds), cost_(tree.nodes.size()) {
        wide_.leaves.resize(kinds.size());
        if (tree.nodes.empty()) return;
        // The nodes of a part have their children in it, but for the first part, which is on top of all.
        parallel_for(tree.parts.size() - 1, threads, [&](std::size_t i) { find_costs(tree.parts[i + 1]); });
        find_costs(tree.parts[0]);
        emit();
        wide_.cost = quotient(static_cast<double>(cost_[0][0]), static_cast<double>(area(0)), 1.0);
    }

    wide_tree take() { return std::move(wide_); }

private:
    static constexpr std::size_t width = node_width;

    /// c(n, 1), c(n, 2), ... c(n, width)
    using costs = std::array<float, width>;

    struct open_place {
        std::uint32_t node;  ///< of the binary tree
        std::size_t places;
    };

    float area(std::uint32_t n) const { return binary_.nodes[n].box.half_area(); }

    float leaf_cost(const binary_node& n) const {
        if (n.kind == binary_node::mixed || n.count > kinds_[n.kind].lanes) return build_box::none;
        const leaf_kind& kind = kinds_[n.kind];
        return n.box.half_area() * kind.of(n.count);
    }

    /// d(n, i + 1) for all i from 1 to width - 1
    costs distributed(const binary_node& n) const {
        const costs& left = cost_[n.left];
        // Before the first number there is none: as many as it takes to start at any i - k.
        std::array<float, 2 * width> right;
        std::fill_n(right.begin(), width, build_box::none);
        std::copy_n(cost_[n.left + 1].begin(), width, right.begin() + width);
        costs d;
        d.fill(build_box::none);
        for (std::size_t k = 0; k + 1 < width; ++k) {
            const float* shifted = right.data() + width - 1 - k;
            for (std::size_t i = 0; i < width; ++i) {
                const float sum = left[k] + shifted[i];
                d[i] = sum < d[i] ? sum : d[i];
            }
        }
        return d;
    }

    void find_costs(part range) {
        for (std::size_t i = range.end; i-- > range.begin;) {
            const binary_node& n = binary_.nodes[i];
            costs& c = cost_[i];
            const float as_leaf = leaf_cost(n);
            if (n.is_leaf()) {
                c.fill(as_leaf);
                continue;
            }
            c = distributed(n);
            c[0] = std::min(as_leaf, n.box.half_area() + c[width - 1]);
            for (std::size_t j = 1; j < width; ++j) c[j] = std::min(c[j], c[j - 1]);
        }
    }

    /// How many of the places the left child takes, of those that n is distributed to.
    std::size_t left_share(const binary_node& n, std::size_t places) const {
        const costs &left = cost_[n.left], &right = cost_[n.left + 1];
        std::size_t best = 1;
        float least = build_box::none;
        for (std::size_t k = 1; k < places; ++k) {
            const float sum = left[k - 1] + right[places - k - 1];
            if (sum < least) least = sum, best = k;
        }
        return best;
    }

    /// The binary nodes that stand in a wide node made of n.
    void find_children(std::uint32_t n, std::vector<std::uint32_t>& children) {
        children.clear();
        std::vector<open_place>& stack = places_;
        const auto distribute = [&](std::uint32_t i, std::size_t places) {
            const binary_node& node = binary_.nodes[i];
            const std::size_t left = left_share(node, places);
            stack.push_back({node.left + 1, places - left});
            stack.push_back({node.left, left});
        };
        if (becomes_leaf(n)) {
            children.push_back(n);
            return;
        }
        distribute(n, width);
        while (!stack.empty()) {
            open_place p = stack.back();
            stack.pop_back();
            while (p.places > 1 && !(cost_[p.node][p.places - 1] < cost_[p.node][p.places - 2])) --p.places;
            if (p.places == 1) {
                children.push_back(p.node);
            } else {
                distribute(p.node, p.places);
            }
        }
    }

    bool becomes_leaf(std::uint32_t n) const {
        const binary_node& node = binary_.nodes[n];
        return node.is_leaf() || (leaf_cost(node) <= cost_[n][0] && leaf_cost(node) < build_box::none);
    }

    void emit() {
        struct open_node {
            std::uint32_t binary, wide;
        };
        std::vector<open_node> stack{{0, 0}};
        std::vector<std::uint32_t> children;
        wide_.nodes.resize(1);
        while (!stack.empty()) {
            const open_node current = stack.back();
            stack.pop_back();
            find_children(current.binary, children);
            // Leaves have the first places; and where any hit will do, it is soonest found in a large child.
            std::ranges::stable_sort(children, std::ranges::greater{},
                                     [&](std::uint32_t n) { return std::pair(becomes_leaf(n), area(n)); });
            const std::size_t stacked = stack.size();
            wide_node made;
            made.first_node = static_cast<std::uint32_t>(wide_.nodes.size());
            for (std::size_t i = 0; i < children.size(); ++i) {
                const binary_node& node = binary_.nodes[children[i]];
                made.set(i, node.box);
                if (becomes_leaf(children[i])) {
                    std::vector<leaf_range>& leaves = wide_.leaves[node.kind];
                    made.leaves[made.leaf_count++] = child::leaf(node.kind, static_cast<std::uint32_t>(leaves.size()));
                    leaves.push_back({node.first, node.count});
                } else {
                    stack.push_back({children[i], static_cast<std::uint32_t>(wide_.nodes.size())});
                    wide_.nodes.emplace_back();
                }
            }
            wide_.nodes[current.wide] = made;
            std::reverse(stack.begin() + static_cast<std::ptrdiff_t>(stacked), stack.end());
        }
    }

    const binary_tree& binary_;
    std::span<const leaf_kind> kinds_;
    std::vector<costs> cost_;
    std::vector<open_place> places_;
    wide_tree wide_;
};

}  // namespace raio::detail
