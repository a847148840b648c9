#pragma once

#include <raio/push_macros.hpp>

#include <raio/bvh/binary_tree.hpp>
#include <raio/bvh/binning.hpp>
#include <raio/bvh/parallel.hpp>

/// \file
/// The binary tree, from the top down by binning. Sets of many boxes are cut level by level, all threads at work on
/// parts of all of them; what has become small is a task of its own. How the work is cut depends on the boxes only, so
/// the tree does too.

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

struct build_limits {
    std::uint32_t leaf = 1;     ///< a leaf holds at most that many references, a power of two
    std::uint32_t task = 8192;  ///< sets of at most that many are not shared among threads
    std::uint32_t part = 8192;  ///< a larger one is dealt out in parts of that many
    std::uint32_t depth = 48;   ///< below that, sets are halved as they stand: no input makes a tree too deep
};

class binned_builder {
public:
    /// \param references  boxes with their ids; what is left in them afterwards is of no use
    /// \param centers     the box around all their centres
    binned_builder(std::span<build_box> references, const build_box& centers, kinds kind_of, build_limits limits,
                   unsigned threads)
        : limits_(limits), kind_of_(kind_of), threads_(threads), side_{references.data(), nullptr} {
        const std::size_t n = references.size();
        tree_.order.resize(n);
        if (n == 0) return;
        spare_.resize(n);
        side_[1] = spare_.data();
        build_top(
            {.node = 0, .begin = 0, .end = static_cast<std::uint32_t>(n), .depth = 0, .side = 0, .centers = centers});
        std::vector<std::uint32_t> roots;
        for (const open_node& task : tasks_) roots.push_back(task.node);
        grow_branches(tree_, top_, roots, threads_, [&](std::size_t i) { return build_task(tasks_[i]); });
    }

    binary_tree take() { return std::move(tree_); }

private:
    /// A node whose references are still to be divided. They are in one of two arrays; every division moves them over.
    struct open_node {
        std::uint32_t node = 0, begin = 0, end = 0, depth = 0;
        unsigned side = 0;
        build_box centers;

        std::uint32_t size() const { return end - begin; }
    };
    struct division {
        open_node left, right;
    };

    /// Both halves of `from`, of which the first has `left_count` references; where they stand is not said yet.
    static division divide_at(const open_node& from, std::uint32_t left_count) {
        const std::uint32_t middle = from.begin + left_count;
        division d;
        d.left.begin = from.begin, d.left.end = d.right.begin = middle, d.right.end = from.end;
        d.left.depth = d.right.depth = from.depth + 1;
        d.left.side = d.right.side = from.side ^ 1;
        return d;
    }

    /// Moves the references of `from` to the other array, those first for which `goes_left` is true.
    template <class GoesLeft>
    void distribute(const open_node& from, division& d, GoesLeft goes_left) const {
        const build_box* source = side_[from.side];
        build_box* target = side_[from.side ^ 1];
        std::size_t left = d.left.begin, right = d.right.end;
        for (std::size_t i = from.begin; i < from.end; ++i) {
            const build_box reference = source[i];
            const std::size_t is_left = goes_left(reference, i) ? 1 : 0;
            // Both places are written, which costs less than to ask: the wrong one is written again.
            target[left] = reference;
            target[right - 1] = reference;
            left += is_left;
            right -= 1 - is_left;
        }
        d.left.centers = centers_of(references_of(d.left)), d.right.centers = centers_of(references_of(d.right));
    }

    /// Divides where the bins say; by kind, where a leaf would be mixed; and in the middle, where nothing else helps.
    division divide(const open_node& from) const {
        const build_box* references = side_[from.side];
        if (from.size() <= limits_.leaf) {
            const std::uint32_t kind = kind_of_(references[from.begin].id());
            const auto same = [&](std::size_t i) { return kind_of_(references[i].id()) == kind; };
            std::uint32_t count = 0;
            for (std::size_t i = from.begin; i < from.end; ++i) count += same(i) ? 1u : 0u;
            division d = divide_at(from, count);
            distribute(from, d, [&](const build_box&, std::size_t i) { return same(i); });
            return d;
        }
        const bin_scale bin_of(from.centers);
        bins filled;
        filled.add(references_of(from), bin_of);
        const bin_split split = filled.best_split(limits_.leaf);
        if (split.axis == 3 || from.depth >= limits_.depth) return halve(from);
        division d = divide_at(from, split.left_count);
        distribute(from, d, [&](const build_box& box, std::size_t) { return bin_of(box, split.axis) <= split.last; });
        return d;
    }

    division halve(const open_node& from) const {
        division d = divide_at(from, from.size() / 2);
        distribute(from, d, [&](const build_box&, std::size_t i) { return i < d.left.end; });
        return d;
    }

    std::span<const build_box> references_of(const open_node& node) const {
        return {side_[node.side] + node.begin, node.size()};
    }

    /// Divides the nodes that are large, level by level. What is left are the tasks.
    void build_top(const open_node& root) {
        top_.resize(1);
        std::vector<open_node> level{root}, next;
        while (!level.empty()) {
            std::erase_if(level, [&](const open_node& node) {
                if (node.size() <= limits_.task) tasks_.push_back(node);
                return node.size() <= limits_.task;
            });
            next.clear();
            for (const division& d : divide_level(level)) next.insert(next.end(), {d.left, d.right});
            std::swap(level, next);
        }
    }

    struct piece {
        std::size_t node;  ///< of the level
        part range;
        std::uint32_t left_before = 0;  ///< how many of the node's earlier references go left
        bins filled;
        build_box left_centers, right_centers;
    };

    std::vector<division> divide_level(const std::vector<open_node>& level) {
        std::vector<std::unique_ptr<piece>> pieces;
        for (std::size_t i = 0; i < level.size(); ++i) {
            for (std::size_t begin = level[i].begin; begin < level[i].end; begin += limits_.part) {
                pieces.push_back(std::make_unique<piece>());
                pieces.back()->node = i;
                pieces.back()->range = {begin, std::min<std::size_t>(level[i].end, begin + limits_.part)};
            }
        }
        parallel_for(pieces.size(), threads_, [&](std::size_t i) {
            piece& p = *pieces[i];
            const open_node& node = level[p.node];
            const bin_scale bin_of(node.centers);
            p.filled.add({side_[node.side] + p.range.begin, p.range.size()}, bin_of);
        });

        std::vector<bins> filled(level.size());
        for (const auto& p : pieces) filled[p->node].add(p->filled);
        std::vector<bin_split> splits;
        std::vector<division> divisions;
        for (std::size_t i = 0; i < level.size(); ++i) {
            splits.push_back(filled[i].best_split(limits_.leaf));
            if (level[i].depth >= limits_.depth) splits.back().axis = 3;
            divisions.push_back(divide_at(level[i], splits[i].axis == 3 ? level[i].size() / 2 : splits[i].left_count));
            division& d = divisions.back();
            d.left.node = static_cast<std::uint32_t>(top_.size());
            d.right.node = d.left.node + 1;
            top_[level[i].node] = binary_node::parent(d.left.node, level[i].size());
            top_.resize(top_.size() + 2);
        }
        std::vector<std::uint32_t> left_before(level.size(), 0);
        for (const auto& p : pieces) {
            p->left_before = left_before[p->node];
            const bin_split& split = splits[p->node];
            if (split.axis == 3) {
                const std::size_t middle = divisions[p->node].left.end;
                left_before[p->node] +=
                    static_cast<std::uint32_t>(std::clamp(middle, p->range.begin, p->range.end) - p->range.begin);
                continue;
            }
            for (unsigned b = 0; b <= split.last; ++b) left_before[p->node] += p->filled.count[split.axis][b];
        }

        parallel_for(pieces.size(), threads_, [&](std::size_t i) {
            piece& p = *pieces[i];
            const open_node& node = level[p.node];
            const division& d = divisions[p.node];
            const bin_split& split = splits[p.node];
            const bin_scale bin_of(node.centers);
            build_box* const target = side_[node.side ^ 1];
            build_box* const first_left = target + d.left.begin + p.left_before;
            build_box* const first_right = target + d.right.begin + (p.range.begin - node.begin) - p.left_before;
            build_box *left = first_left, *right = first_right;
            for (std::size_t j = p.range.begin; j < p.range.end; ++j) {
                const build_box& reference = side_[node.side][j];
                const bool goes_left = split.axis == 3 ? j < d.left.end : bin_of(reference, split.axis) <= split.last;
                build_box*& place = goes_left ? left : right;
                *place++ = reference;
            }
            p.left_centers = centers_of({first_left, left}), p.right_centers = centers_of({first_right, right});
        });
        for (const auto& p : pieces) {
            divisions[p->node].left.centers.include(p->left_centers);
            divisions[p->node].right.centers.include(p->right_centers);
        }
        return divisions;
    }

    std::vector<binary_node> build_task(const open_node& task) {
        std::vector<binary_node> nodes(1);
        nodes.reserve(task.size());
        std::vector<open_node> stack{task};
        stack.back().node = 0;
        while (!stack.empty()) {
            const open_node current = stack.back();
            stack.pop_back();
            const bool small = current.size() <= limits_.leaf;
            const std::uint32_t kind = small ? kind_of_.common(references_of(current)) : binary_node::mixed;
            if (kind != binary_node::mixed) {
                build_box box;
                for (std::size_t i = current.begin; i < current.end; ++i) {
                    const build_box& reference = side_[current.side][i];
                    box.include(reference);
                    tree_.order[i] = reference.id();
                }
                nodes[current.node] = binary_node::leaf(box, current.begin, current.size(), kind);
                continue;
            }
            division d = divide(current);
            d.left.node = static_cast<std::uint32_t>(nodes.size()), d.right.node = d.left.node + 1;
            nodes[current.node] = binary_node::parent(d.left.node, current.size());
            nodes.resize(nodes.size() + 2);
            stack.push_back(d.right);
            stack.push_back(d.left);
        }
        return nodes;
    }

    build_limits limits_;
    kinds kind_of_;
    unsigned threads_;
    large_vector<build_box> spare_;
    std::array<build_box*, 2> side_;
    std::vector<binary_node> top_;
    std::vector<open_node> tasks_;
    binary_tree tree_;
};

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
