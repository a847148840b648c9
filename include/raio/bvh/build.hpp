#pragma once

#include <memory>

#include <raio/bvh/binary_tree.hpp>
#include <raio/bvh/binning.hpp>
#include <raio/bvh/parallel.hpp>

/// \file
/// The binary tree, from the top down by binning. Sets of many boxes are cut level by level, all threads at work on
/// parts of all of them; what has become small is a task of its own. How the work is cut depends on the boxes only, so
/// the tree does too.

namespace raio::detail {

struct build_limits {
    std::uint32_t leaf = 1;     ///< a leaf holds at most that many references
    std::uint32_t task = 8192;  ///< sets of at most that many are not shared among threads
    std::uint32_t part = 8192;  ///< a larger one is dealt out in parts of that many
    std::uint32_t depth = 48;   ///< below that, sets are halved as they stand: no input makes a tree too deep
};

class binned_builder {
public:
    /// \param references  boxes with their ids; what is left in them afterwards is of no use
    binned_builder(std::vector<build_box>& references, kinds kind_of, build_limits limits, unsigned threads)
        : limits_(limits), kind_of_(kind_of), threads_(threads), side_{references.data(), nullptr} {
        const std::size_t n = references.size();
        tree_.order.resize(n);
        if (n == 0) return;
        spare_ = std::make_unique_for_overwrite<raw_box[]>(n);
        side_[1] = reinterpret_cast<build_box*>(spare_.get());
        build_top(static_cast<std::uint32_t>(n));
        std::vector<std::uint32_t> roots;
        for (const open_node& task : tasks_) roots.push_back(task.node);
        grow_branches(tree_, roots, threads_, [&](std::size_t i) { return build_task(tasks_[i]); });
    }

    binary_tree take() { return std::move(tree_); }

private:
    struct alignas(build_box) raw_box {
        std::byte bytes[sizeof(build_box)];
    };

    /// A node whose references are still to be divided. They are in one of two arrays; every division moves them over.
    struct open_node {
        std::uint32_t node = 0, begin = 0, end = 0, depth = 0;
        unsigned side = 0;
        build_box box, centers;

        std::uint32_t size() const { return end - begin; }
    };
    struct division {
        open_node left, right;
    };

    /// Adds a box to one of two. To the other it is added infinitely far away, which costs less than to ask.
    static void include_in(build_box& left, build_box& right, build_box box, bool is_left) {
        static constexpr std::array<float, 2> away{build_box::none, 0};
        left.v = build_box::numbers::min(left.v, box.v + build_box::numbers(away[is_left ? 1 : 0]));
        right.v = build_box::numbers::min(right.v, box.v + build_box::numbers(away[is_left ? 0 : 1]));
    }

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
        build_box left_centers, right_centers;
        for (std::size_t i = from.begin; i < from.end; ++i) {
            const build_box reference = source[i];
            const bool is_left = goes_left(reference, i);
            // Both places are written, which costs less than to ask: the wrong one is written again.
            target[left] = reference;
            target[right - 1] = reference;
            left += is_left ? 1 : 0;
            right -= is_left ? 0 : 1;
            include_in(left_centers, right_centers, center_box(reference), is_left);
        }
        d.left.centers = left_centers, d.right.centers = right_centers;
    }

    void measure(open_node& node) const {
        node.box = {};
        for (std::size_t i = node.begin; i < node.end; ++i) node.box.include(side_[node.side][i]);
    }

    /// Divides where the bins say; by kind, where a leaf would be mixed; and in the middle, where nothing else helps.
    division divide(const open_node& from) const {
        const build_box* references = side_[from.side];
        if (from.size() <= limits_.leaf) {
            const std::uint32_t kind = kind_of_(references[from.begin].id());
            const auto same = [&](std::size_t i) { return kind_of_(references[i].id()) == kind; };
            std::uint32_t count = 0;
            for (std::size_t i = from.begin; i < from.end; ++i) count += same(i) ? 1 : 0;
            division d = divide_at(from, count);
            distribute(from, d, [&](const build_box&, std::size_t i) { return same(i); });
            measure(d.left), measure(d.right);
            return d;
        }
        const bin_scale bin_of(from.centers);
        bins filled;
        for (std::size_t i = from.begin; i < from.end; ++i) filled.add(references[i], bin_of);
        const bin_split split = filled.best_split();
        if (split.axis == 3 || from.depth >= limits_.depth) return halve(from);
        division d = divide_at(from, split.left_count);
        d.left.box = split.left, d.right.box = split.right;
        distribute(from, d, [&](const build_box& box, std::size_t) { return bin_of(box, split.axis) <= split.last; });
        return d;
    }

    division halve(const open_node& from) const {
        division d = divide_at(from, from.size() / 2);
        distribute(from, d, [&](const build_box&, std::size_t i) { return i < d.left.end; });
        measure(d.left), measure(d.right);
        return d;
    }

    std::span<const build_box> references_of(const open_node& node) const {
        return {side_[node.side] + node.begin, node.size()};
    }

    /// A node as it stands before it has children.
    binary_node closed(const open_node& node) const {
        return {.box = node.box, .left = 0, .first = node.begin, .count = node.size(), .kind = 0};
    }

    /// Divides the nodes that are large, level by level. What is left are the tasks.
    void build_top(std::uint32_t n) {
        open_node root{.node = 0, .begin = 0, .end = n, .depth = 0, .side = 0, .box = {}, .centers = {}};
        const std::size_t parts = parts_of(limits_.part, n);
        std::vector<build_box> boxes(parts), centers(parts);
        parallel_for(parts, threads_, [&](std::size_t i) {
            const part p = part_of(i, limits_.part, n);
            build_box box, center;
            for (std::size_t j = p.begin; j < p.end; ++j) {
                box.include(side_[0][j]);
                center.include(center_box(side_[0][j]));
            }
            boxes[i] = box, centers[i] = center;
        });
        for (std::size_t i = 0; i < parts; ++i) root.box.include(boxes[i]), root.centers.include(centers[i]);

        tree_.nodes.resize(1);
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
            for (std::size_t j = p.range.begin; j < p.range.end; ++j) p.filled.add(side_[node.side][j], bin_of);
        });

        std::vector<bins> filled(level.size());
        for (const auto& p : pieces) filled[p->node].add(p->filled);
        std::vector<bin_split> splits;
        std::vector<division> divisions;
        for (std::size_t i = 0; i < level.size(); ++i) {
            splits.push_back(filled[i].best_split());
            if (level[i].depth >= limits_.depth) splits.back().axis = 3;
            divisions.push_back(divide_at(level[i], splits[i].axis == 3 ? level[i].size() / 2 : splits[i].left_count));
            division& d = divisions.back();
            d.left.box = splits[i].left, d.right.box = splits[i].right;
            d.left.node = static_cast<std::uint32_t>(tree_.nodes.size());
            d.right.node = d.left.node + 1;
            binary_node parent = closed(level[i]);
            parent.left = d.left.node;
            tree_.nodes[level[i].node] = parent;
            tree_.nodes.resize(tree_.nodes.size() + 2);
        }
        std::vector<std::uint32_t> left_before(level.size(), 0);
        for (const auto& p : pieces) {
            p->left_before = left_before[p->node];
            const bin_split& split = splits[p->node];
            for (unsigned b = 0; split.axis < 3 && b <= split.last; ++b) {
                left_before[p->node] += p->filled.count[split.axis][b];
            }
        }

        parallel_for(pieces.size(), threads_, [&](std::size_t i) {
            piece& p = *pieces[i];
            const open_node& node = level[p.node];
            const division& d = divisions[p.node];
            const bin_split& split = splits[p.node];
            const bin_scale bin_of(node.centers);
            std::size_t left = d.left.begin + p.left_before;
            std::size_t right = d.right.begin + (p.range.begin - node.begin) - p.left_before;
            for (std::size_t j = p.range.begin; j < p.range.end; ++j) {
                const build_box reference = side_[node.side][j];
                // Halves keep their order and their places.
                const bool goes_left = split.axis == 3 ? j < d.left.end : bin_of(reference, split.axis) <= split.last;
                side_[node.side ^ 1][split.axis == 3 ? j : goes_left ? left++ : right++] = reference;
                include_in(p.left_centers, p.right_centers, center_box(reference), goes_left);
            }
        });
        for (const auto& p : pieces) {
            divisions[p->node].left.centers.include(p->left_centers);
            divisions[p->node].right.centers.include(p->right_centers);
        }
        for (std::size_t i = 0; i < level.size(); ++i) {
            if (splits[i].axis == 3) measure(divisions[i].left), measure(divisions[i].right);
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
            binary_node node = closed(current);
            node.kind = current.size() <= limits_.leaf ? kind_of_.common(references_of(current)) : binary_node::mixed;
            if (current.size() <= limits_.leaf && node.kind != binary_node::mixed) {
                for (std::size_t i = current.begin; i < current.end; ++i) {
                    tree_.order[i] = side_[current.side][i].id();
                }
            } else {
                division d = divide(current);
                node.left = static_cast<std::uint32_t>(nodes.size());
                d.left.node = node.left, d.right.node = node.left + 1;
                nodes.resize(nodes.size() + 2);
                stack.push_back(d.right);
                stack.push_back(d.left);
            }
            nodes[current.node] = node;
        }
        return nodes;
    }

    build_limits limits_;
    kinds kind_of_;
    unsigned threads_;
    std::unique_ptr<raw_box[]> spare_;
    std::array<build_box*, 2> side_;
    std::vector<open_node> tasks_;
    binary_tree tree_;
};

}  // namespace raio::detail
