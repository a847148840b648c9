#pragma once

#include <raio/push_macros.hpp>

#include <algorithm>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <raio/bvh/binary_tree.hpp>
#include <raio/compose/mesh.hpp>

/// \file
/// Equal shapes: every ray that meets one of them meets all, at one t and on one side, and the first is hit. Where
/// there are many in one place, no tree divides them. So it holds the first only, and says here for whom that stands.

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// What a shape is made of, to be compared byte by byte: of a mesh's triangle, its corners.
template <class Shape>
const Shape& substance_of(const Shape& shape) {
    return shape;
}
template <class T>
triangle<T> substance_of(const mesh_triangle<T>& shape) {
    return (*shape.of)[shape.index];
}

/// Shapes that own something are not compared.
template <class Shape>
concept comparable = std::is_trivially_copyable_v<Shape>;

/// Below 0, 0 or above: an order, and nothing else.
template <comparable Shape>
int compare_bytes(const Shape& a, const Shape& b) {
    const auto &x = substance_of(a), &y = substance_of(b);
    return std::memcmp(static_cast<const void*>(&x), static_cast<const void*>(&y), sizeof(x));
}

/// The references in places in which there are more than `most`, all with one box. To look for them costs next to
/// nothing: only nodes of more than `most` references are visited.
inline std::vector<std::uint32_t> crowds_of(const binary_tree& tree, std::uint32_t most) {
    std::vector<std::uint32_t> found;
    if (tree.nodes.empty()) return found;
    const auto same_box = [](const build_box& a, const build_box& b) {
        const auto same = [&](unsigned axis) { return a.low(axis) == b.low(axis) && a.high(axis) == b.high(axis); };
        return same(0) && same(1) && same(2);
    };
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
        const std::uint32_t n = open.back();
        open.pop_back();
        const binary_node& node = tree.nodes[n];
        if (node.is_leaf() || node.count() <= most) continue;
        const std::uint32_t left = node.first(), right = left + 1;
        if (node.tells_count() && same_box(tree.nodes[left].box, tree.nodes[right].box)) {
            const auto first = tree.order.begin() + tree.first_reference(n);
            found.insert(found.end(), first, first + node.count());
        } else {
            open.insert(open.end(), {left, right});
        }
    }
    return found;
}

/// Shapes of one type that a tree does not hold, each with the one that stands for it.
class equal_shapes {
public:
    bool empty() const { return pairs_.empty(); }
    std::size_t bytes() const { return pairs_.size() * sizeof(pair); }

    /// Those that equal one of lower id among them.
    /// \param shape_of  the shape of an id
    template <class ShapeOf>
    void find(std::vector<std::uint32_t> ids, ShapeOf shape_of) {
        std::ranges::sort(ids, [&](std::uint32_t a, std::uint32_t b) {
            const int order = compare_bytes(shape_of(a), shape_of(b));
            return order != 0 ? order < 0 : a < b;
        });
        std::size_t first = 0;
        for (std::size_t i = 1; i < ids.size(); ++i) {
            if (compare_bytes(shape_of(ids[first]), shape_of(ids[i])) != 0) {
                first = i;
            } else {
                pairs_.push_back({ids[first], ids[i]});
            }
        }
        std::ranges::sort(pairs_);
    }

    /// Are they still equal?
    template <class ShapeOf>
    bool hold(ShapeOf shape_of) const {
        return std::ranges::all_of(
            pairs_, [&](const pair& p) { return compare_bytes(shape_of(p.first), shape_of(p.second)) == 0; });
    }

    /// Takes out of all references those that others stand for.
    template <class Boxes>
    void leave_out_of(Boxes& references) const {
        if (empty()) return;
        std::vector<std::uint32_t> others;
        for (const pair& p : pairs_) others.push_back(p.second);
        std::ranges::sort(others);
        std::erase_if(references, [&](const build_box& b) { return std::ranges::binary_search(others, b.id()); });
    }

    /// Calls `visit` with the ids for which this one stands, as long as it answers true.
    template <class Visit>
    bool for_each_equal(std::uint32_t id, Visit visit) const {
        if (empty()) return true;
        for (auto p = std::ranges::lower_bound(pairs_, pair{id, 0}); p != pairs_.end() && p->first == id; ++p) {
            if (!visit(p->second)) return false;
        }
        return true;
    }

private:
    using pair = std::pair<std::uint32_t, std::uint32_t>;  ///< who stands for whom

    std::vector<pair> pairs_;  ///< sorted
};

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
