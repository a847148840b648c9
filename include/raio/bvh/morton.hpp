#pragma once

#include <raio/push_macros.hpp>

#include <raio/bvh/binary_tree.hpp>
#include <raio/bvh/binning.hpp>

/// \file
/// The binary tree, quickly: the boxes are sorted along a curve that goes through all of space, cell by cell, and is
/// cut in two where the cells' codes differ in their highest bit (Lauterbach et al., Fast BVH construction on GPUs,
/// 2009). What fills a few leaves only is cut where leaves are full, next to that place: most of the time of such a
/// build goes into writing them.

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

class morton_builder {
public:
    /// \param centers  the box around all the centres
    morton_builder(std::span<const build_box> references, const build_box& centers, kinds kind_of, std::uint32_t leaf,
                   unsigned threads)
        : references_(references), kind_of_(kind_of), leaf_(leaf), threads_(threads) {
        const std::size_t n = references.size();
        if (n == 0) return;
        find_codes(centers);
        sort();
        tree_.order.resize(n);
        build_top();
    }

    binary_tree take() { return std::move(tree_); }

private:
    static constexpr std::size_t part_size = 16384;
    static constexpr std::uint32_t digit_bits = 10, digits = 1u << digit_bits;
    /// (Measured, for 4, 8 and 32 leaves of eight triangles: a million triangles take 55, 51 and 48 bytes each instead
    /// of 73, and primary rays 2, 5 and 13 % longer.)
    static constexpr std::size_t few_leaves = 4;

    struct place {
        std::uint32_t code, reference;
    };

    /// Puts two zeros before each of ten bits.
    static std::uint32_t spread(std::uint32_t x) {
        x = (x | x << 16) & 0x030000ffu;
        x = (x | x << 8) & 0x0300f00fu;
        x = (x | x << 4) & 0x030c30c3u;
        return (x | x << 2) & 0x09249249u;
    }

    void find_codes(const build_box& centers) {
        const std::size_t n = references_.size();
        std::array<float, 3> scale;
        for (unsigned axis = 0; axis < 3; ++axis) scale[axis] = cells_per_length(1024, centers.extent(axis));
        places_.resize(n);
        parallel_for(parts_of(part_size, n), threads_, [&](std::size_t i) {
            const part p = part_of(i, part_size, n);
            for (std::size_t j = p.begin; j < p.end; ++j) {
                std::uint32_t code = 0;
                for (unsigned axis = 0; axis < 3; ++axis) {
                    const float cell = (center2(references_[j], axis) - centers.low(axis)) * scale[axis];
                    code |= spread(static_cast<std::uint32_t>(static_cast<int>(cell))) << axis;
                }
                places_[j] = {code, static_cast<std::uint32_t>(j)};
            }
        });
    }

    /// By counting, digit by digit from the lowest; parts of the range count, and move, on their own.
    void sort() {
        const std::size_t n = places_.size(), parts = parts_of(part_size, n);
        large_vector<place> sorted(n);
        std::vector<std::array<std::uint32_t, digits>> begin(parts);
        for (std::uint32_t shift = 0; shift < 30; shift += digit_bits) {
            const auto digit = [&](const place& p) { return p.code >> shift & (digits - 1); };
            parallel_for(parts, threads_, [&](std::size_t i) {
                begin[i].fill(0);
                const part p = part_of(i, part_size, n);
                for (std::size_t j = p.begin; j < p.end; ++j) ++begin[i][digit(places_[j])];
            });
            std::uint32_t before = 0;
            for (std::uint32_t d = 0; d < digits; ++d) {
                for (auto& count : begin) before += std::exchange(count[d], before);
            }
            parallel_for(parts, threads_, [&](std::size_t i) {
                const part p = part_of(i, part_size, n);
                for (std::size_t j = p.begin; j < p.end; ++j) sorted[begin[i][digit(places_[j])]++] = places_[j];
            });
            std::swap(places_, sorted);
        }
    }

    /// Where a range is cut that is more than a leaf.
    std::size_t find_cut(std::size_t begin, std::size_t end) const {
        const std::size_t cut = between_cells(begin, end);
        if (end - begin > few_leaves * leaf_) return cut;
        // At a whole number of leaves, each side at least one.
        const std::size_t nearest = (cut - begin + leaf_ / 2) / leaf_, most = (end - begin - 1) / leaf_;
        return begin + std::clamp<std::size_t>(nearest, 1, most) * leaf_;
    }

    /// Where the codes differ in their highest bit; in the middle, if they do not differ.
    std::size_t between_cells(std::size_t begin, std::size_t end) const {
        const std::uint32_t differ = places_[begin].code ^ places_[end - 1].code;
        if (differ == 0) return begin + (end - begin) / 2;
        const std::uint32_t highest = std::bit_floor(differ);
        // The last place without that bit, by halving: without branches, which would be guessed wrong half of the time.
        const place* last = places_.data() + begin;
        for (std::size_t left = end - begin; left > 1;) {
            const std::size_t half = left / 2;
            last += (last[half].code & highest) == 0 ? half : 0;
            left -= half;
        }
        return static_cast<std::size_t>(last + 1 - places_.data());
    }

    struct open_node {
        std::uint32_t node;
        std::size_t begin, end;
    };

    /// Divides what is larger than `smallest`; answers what is left.
    std::vector<open_node> divide(std::vector<binary_node>& nodes, const open_node& root, std::size_t smallest) const {
        std::vector<open_node> stack{root}, rest;
        while (!stack.empty()) {
            const open_node current = stack.back();
            stack.pop_back();
            if (current.end - current.begin <= smallest) {
                rest.push_back(current);
                continue;
            }
            const std::size_t cut = find_cut(current.begin, current.end);
            const auto left = static_cast<std::uint32_t>(nodes.size());
            nodes[current.node] = binary_node::parent(left, current.end - current.begin);
            nodes.resize(nodes.size() + 2);
            stack.push_back({left + 1, cut, current.end});
            stack.push_back({left, current.begin, cut});
        }
        return rest;
    }

    void build_top() {
        std::vector<binary_node> top(1);
        const std::vector<open_node> tasks = divide(top, {0, 0, places_.size()}, part_size);
        std::vector<std::uint32_t> roots;
        for (const open_node& task : tasks) roots.push_back(task.node);
        grow_branches(tree_, top, roots, threads_, [&](std::size_t i) {
            std::vector<binary_node> nodes(1);
            nodes.reserve(tasks[i].end - tasks[i].begin);
            for (const open_node& leaf : divide(nodes, {0, tasks[i].begin, tasks[i].end}, leaf_)) {
                close(nodes, leaf, tasks[i].end);
            }
            return nodes;
        });
    }

    /// Makes a leaf, or one of each kind.
    /// \param end  of what the same thread closes
    void close(std::vector<binary_node>& nodes, open_node leaf, std::size_t end) {
        for (;;) {
            const auto first = places_.begin() + static_cast<std::ptrdiff_t>(leaf.begin);
            const auto last = places_.begin() + static_cast<std::ptrdiff_t>(leaf.end);
            const auto kind = [&](const place& p) { return kind_of_(references_[p.reference].id()); };
            const std::uint32_t own = kind(*first);
            const auto others = std::stable_partition(first, last, [&](const place& p) { return kind(p) == own; });
            const auto cut = static_cast<std::size_t>(others - places_.begin());
            constexpr std::size_t ahead = 64;  // boxes are read from anywhere: they are asked for before
            build_box box;
            for (std::size_t i = leaf.begin; i < cut; ++i) {
                __builtin_prefetch(&references_[places_[std::min(i + ahead, end - 1)].reference]);
                box.include(references_[places_[i].reference]);
                tree_.order[i] = references_[places_[i].reference].id();
            }
            const auto made = binary_node::leaf(box, static_cast<std::uint32_t>(leaf.begin), cut - leaf.begin, own);
            if (cut == leaf.end) {
                nodes[leaf.node] = made;
                return;
            }
            const auto left = static_cast<std::uint32_t>(nodes.size());
            nodes[leaf.node] = binary_node::parent(left, leaf.end - leaf.begin);
            nodes.push_back(made);
            nodes.emplace_back();
            leaf = {left + 1, cut, leaf.end};
        }
    }

    std::span<const build_box> references_;
    kinds kind_of_;
    std::uint32_t leaf_;
    unsigned threads_;
    large_vector<place> places_;
    binary_tree tree_;
};

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
