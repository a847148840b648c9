#pragma once

#include <raio/push_macros.hpp>

#include <optional>
#include <stdexcept>
#include <string>

#include <raio/bvh/build.hpp>
#include <raio/bvh/equal_shapes.hpp>
#include <raio/bvh/leaf_kinds.hpp>
#include <raio/bvh/morton.hpp>
#include <raio/bvh/options.hpp>
#include <raio/bvh/presplit.hpp>
#include <raio/failure.hpp>

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// What a tree is made of: the nodes, and the shapes in their leaves. It is made of as many sources as there are types
/// of shapes, each of which has a size and shapes by their numbers.
template <class... Shapes>
class assembled {
public:
    using T = std::common_type_t<number_t<Shapes>...>;
    using leaves_type = leaf_kinds<leaves_of<Shapes>...>;

    large_vector<wide_node> nodes;
    leaves_type leaves;
    aabb<T> bounds;
    T scale = 1;     ///< of the nodes' boxes: a power of two that brings them near 1, if they are far from it
    float size = 0;  ///< the largest coordinate of these
    double cost = 0;
    std::array<equal_shapes, sizeof...(Shapes)> equals;  ///< of each kind

    template <class Sources>
    void build(const Sources& shapes, const bvh_options& options) {
        options_ = options;
        const unsigned threads = thread_count(options.threads);
        build_box centers;
        large_vector<build_box> pieces;
        trees made;
        do {
            large_vector<build_box> references = find_references(shapes, threads, centers);
            for (const equal_shapes& own : equals) own.leave_out_of(references);
            if (options.quality == bvh_quality::high && references.size() <= most_shapes / 2) {
                pieces = presplit(references, 0.5f, threads, [&](std::uint32_t id) { return corners_of(shapes, id); });
            }
            made = make_trees(references, centers, options.quality, threads);
        } while (find_equals(shapes, made.binary));
        if (!pieces.empty()) {
            // Pieces pay where shapes are large and lie across each other; elsewhere they are more to go through.
            trees of_pieces = make_trees(pieces, centers_of(pieces), options.quality, threads);
            if (of_pieces.wide.cost < made.wide.cost) made = std::move(of_pieces);
        }
        nodes = std::move(made.wide.nodes);
        cost = made.wide.cost;
        for_each_kind([&](auto kind) {
            fill(std::get<kind()>(leaves.all), made.wide.leaves[kind()], std::get<kind()>(shapes), made.binary.order,
                 first_id_[kind()], threads);
        });
    }

    /// Nothing is changed if this throws.
    template <class Sources>
    void refit(const Sources& shapes) {
        std::size_t count = 0;
        std::apply([&](const auto&... source) { ((count += source.size()), ...); }, shapes);
        if (count != count_) detail::fail(std::invalid_argument("raio::bvh: refit with another number of shapes"));
        assembled moved;
        moved.first_id_ = first_id_;
        build_box centers;
        const large_vector<build_box> references =
            moved.find_references(shapes, thread_count(options_.threads), centers);
        // What was left out, or would have to be, has no place in the tree that is there.
        if (references.size() != count || placed_ != count || moved.scale != scale || !equals_hold(shapes)) {
            moved.build(shapes, options_);
            *this = std::move(moved);
            return;
        }
        bounds = moved.bounds;
        size = moved.size;
        for_each_kind([&](auto kind) {
            auto& own = std::get<kind()>(leaves.all);
            for (std::uint32_t i = 0; i < own.size(); ++i) {
                for (std::uint32_t left = own.used(i); left != 0; left &= left - 1) {
                    const auto lane = static_cast<unsigned>(std::countr_zero(left));
                    own.set(i, lane, std::get<kind()>(shapes)[own.id(i, lane) - first_id_[kind()]]);
                }
            }
        });
        refit_nodes(references);
    }

    std::size_t bytes() const {
        std::size_t sum = nodes.size() * sizeof(wide_node);
        for (const equal_shapes& own : equals) sum += own.bytes();
        std::apply([&](const auto&... l) { ((sum += l.bytes()), ...); }, leaves.all);
        return sum;
    }

private:
    static constexpr std::size_t kind_count = sizeof...(Shapes);
    static constexpr std::size_t part_size = 4096;
    static constexpr std::size_t most_shapes = std::size_t{1} << child::kind_shift;  // each may have a leaf of its own

    struct trees {
        binary_tree binary;
        wide_tree wide;
    };

    trees make_trees(large_vector<build_box>& references, const build_box& centers, bvh_quality quality,
                     unsigned threads) const {
        static constexpr std::array<std::uint32_t, kind_count> lanes{leaves_of<Shapes>::lanes...};
        static_assert(std::ranges::all_of(lanes, [](std::uint32_t n) { return std::has_single_bit(n); }));
        const std::uint32_t leaf = std::ranges::min(lanes);
        trees made;
        made.binary = quality == bvh_quality::low
                          ? morton_builder(references, centers, {first_id_}, leaf, threads).take()
                          : binned_builder(references, centers, {first_id_}, {.leaf = leaf}, threads).take();
        made.wide = collapser(made.binary, lanes, threads).take();
        return made;
    }

    /// Looks for many equal shapes in one place, unless that has been done. (A few are less to go through than to keep
    /// apart.)
    template <class Sources>
    bool find_equals(const Sources& shapes, const binary_tree& tree) {
        if (!std::ranges::all_of(equals, &equal_shapes::empty)) return false;
        const std::vector<std::uint32_t> crowds = crowds_of(tree, 64);
        if (crowds.empty()) return false;
        for_each_kind([&](auto kind) {
            std::vector<std::uint32_t> ids;
            std::ranges::copy_if(crowds, std::back_inserter(ids),
                                 [&](std::uint32_t id) { return kinds{first_id_}(id) == kind(); });
            if constexpr (comparable<shape_of_kind<kind()>>) equals[kind()].find(std::move(ids), by_id<kind()>(shapes));
        });
        return !std::ranges::all_of(equals, &equal_shapes::empty);
    }

    template <class Sources>
    bool equals_hold(const Sources& shapes) const {
        bool hold = true;
        for_each_kind([&](auto kind) {
            if constexpr (comparable<shape_of_kind<kind()>>) {
                hold = hold && equals[kind()].hold(by_id<kind()>(shapes));
            }
        });
        return hold;
    }

    template <std::size_t Kind>
    using shape_of_kind = std::tuple_element_t<Kind, std::tuple<Shapes...>>;

    /// The shape of an id.
    template <std::size_t Kind, class Sources>
    auto by_id(const Sources& shapes) const {
        return [&source = std::get<Kind>(shapes), first = first_id_[Kind]](std::uint32_t id) -> decltype(auto) {
            return source[id - first];
        };
    }

    template <class Visit>
    static void for_each_kind(Visit visit) {
        [&]<std::size_t... I>(std::index_sequence<I...>) { (visit(std::integral_constant<std::size_t, I>{}), ...); }
        (std::make_index_sequence<kind_count>());
    }

    /// The corners of a triangle, scaled as the boxes are; nothing for another shape.
    template <class Sources>
    std::optional<corners> corners_of(const Sources& shapes, std::uint32_t id) const {
        std::optional<corners> found;
        for_each_kind([&](auto kind) {
            if constexpr (three_cornered<shape_of_kind<kind()>>) {
                if (kind() != kinds{first_id_}(id)) return;
                const shape_of_kind<kind()> s = by_id<kind()>(shapes)(id);
                found = {vec3<double>(s.a * scale), vec3<double>(s.b * scale), vec3<double>(s.c * scale)};
            }
        });
        return found;
    }

    /// The boxes of all shapes that have points, and all that is known from them.
    /// \param centers  becomes the box around their centres
    template <class Sources>
    large_vector<build_box> find_references(const Sources& shapes, unsigned threads, build_box& centers) {
        std::size_t count = 0;
        for_each_kind([&](auto kind) {
            first_id_[kind()] = static_cast<std::uint32_t>(count);
            count += std::get<kind()>(shapes).size();
            if (count > most_shapes) detail::fail(std::length_error("raio::bvh: more than 2^27 shapes"));
        });
        count_ = static_cast<std::uint32_t>(count);
        large_vector<build_box> references(count_);
        box_summary found;
        const auto find = [&] {
            found = {};
            for_each_kind([&](auto kind) {
                found.add(find_boxes(std::get<kind()>(shapes), first_id_[kind()], threads, references));
            });
            bounds = found.bounds;
        };
        find();
        if (!(bounds.min.x <= bounds.max.x)) return {};
        vec3<T> low = abs(bounds.min), high = abs(bounds.max);
        const T reach = max(max(max(low.x, low.y), low.z), max(max(high.x, high.y), high.z));
        if (reach > T(0) && (reach < T(0x1p-20) || reach > T(0x1p40))) {
            int exponent = 0;
            std::frexp(reach, &exponent);
            scale = std::ldexp(T(1), std::clamp(-exponent, std::numeric_limits<T>::min_exponent + 1,
                                                std::numeric_limits<T>::max_exponent - 2));
            find();
        }
        centers = found.centers;
        size = found.all.reach();
        placed_ = found.count;
        if (placed_ < count_) std::erase_if(references, [](const build_box& b) { return b.low(0) > b.high(0); });
        return references;
    }

    /// What is known of many boxes.
    struct box_summary {
        aabb<T> bounds;
        build_box all, centers;   ///< scaled and in floats
        std::uint32_t count = 0;  ///< of those that have points

        void add(const box_summary& other) {
            bounds = hull(bounds, other.bounds);
            all.include(other.all), centers.include(other.centers);
            count += other.count;
        }
    };

    template <class Source>
    box_summary find_boxes(const Source& shapes, std::uint32_t first_id, unsigned threads,
                           std::span<build_box> references) const {
        std::vector<box_summary> found(parts_of(part_size, shapes.size()));
        parallel_for(found.size(), threads, [&](std::size_t i) {
            const part p = part_of(i, part_size, shapes.size());
            box_summary own;
            for (std::size_t j = p.begin; j < p.end; ++j) {
                if constexpr (requires { shapes[j].check(); }) shapes[j].check();
                const aabb<T> box = shapes[j].bounds();
                const auto id = first_id + static_cast<std::uint32_t>(j);
                references[id] = {};
                const bool nan = is_nan(box);
                if (!nan && (box.min.x > box.max.x || box.min.y > box.max.y || box.min.z > box.max.z)) continue;
                if (nan || !is_finite(box.min) || !is_finite(box.max)) {
                    detail::fail(
                        std::invalid_argument("raio::bvh: shape " + std::to_string(id) + " has no finite bounds"));
                }
                references[id] = to_build_box(aabb<T>{box.min * scale, box.max * scale}, id);
                own.add({box, references[id], center_box(references[id]), 1});
            }
            found[i] = own;
        });
        box_summary all;
        for (const box_summary& part : found) all.add(part);
        return all;
    }

    template <class Leaves, class Source>
    static void fill(Leaves& leaves, std::span<const leaf_range> ranges, const Source& shapes,
                     std::span<const std::uint32_t> order, std::uint32_t first_id, unsigned threads) {
        leaves.resize(ranges);
        const auto ids_of = [&](const leaf_range& range) { return order.subspan(range.first, range.count); };
        // Shapes are read from anywhere: they are asked for some leaves ahead.
        constexpr std::size_t ahead = 4;
        const auto fetch = [&](const leaf_range& range) {
            if constexpr (std::is_lvalue_reference_v<decltype(shapes[0])>) {
                for (const std::uint32_t id : ids_of(range)) __builtin_prefetch(&shapes[id - first_id]);
            }
        };
        parallel_for(parts_of(part_size, ranges.size()), threads, [&](std::size_t i) {
            const part p = part_of(i, part_size, ranges.size());
            for (std::size_t j = p.begin; j < p.end; ++j) {
                if (j + ahead < p.end) fetch(ranges[j + ahead]);
                leaves.fill(j, ids_of(ranges[j]), [&](std::uint32_t id) { return shapes[id - first_id]; });
            }
        });
    }

    /// Boxes from the bottom to the top: children stand behind their parents.
    /// \param references  of all shapes, by their ids
    void refit_nodes(std::span<const build_box> references) {
        std::vector<build_box> boxes(nodes.size());
        double sum = 0;
        for (std::size_t i = nodes.size(); i-- > 0;) {
            wide_node& node = nodes[i];
            for (std::size_t j = 0; j < node_width; ++j) {
                if (node.planes[0][j] > node.planes[1][j]) continue;  // without a child
                const std::uint32_t c = node.child_at(j);
                build_box box;
                if (child::is_leaf(c)) {
                    leaves_type::with_kind(child::kind(c), [&](auto kind) {
                        const auto& own = std::get<kind()>(leaves.all);
                        const std::uint32_t block = child::block(c), used = own.used(block);
                        for (std::uint32_t left = used; left != 0; left &= left - 1) {
                            box.include(references[own.id(block, static_cast<unsigned>(std::countr_zero(left)))]);
                        }
                    });
                } else {
                    box = boxes[c];
                }
                node.set(j, box);
                boxes[i].include(box);
                sum += static_cast<double>(box.half_area());
            }
        }
        if (!nodes.empty()) cost = 1 + quotient(sum, static_cast<double>(boxes[0].half_area()), 0.0);
    }

    std::array<std::uint32_t, kind_count> first_id_{};
    std::uint32_t count_ = 0, placed_ = 0;
    bvh_options options_;
};

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
