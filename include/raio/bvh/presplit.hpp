#pragma once

#include <raio/push_macros.hpp>

#include <raio/bvh/binning.hpp>
#include <raio/bvh/gather.hpp>
#include <raio/bvh/large_pages.hpp>
#include <raio/bvh/parallel.hpp>

#include <limits>
#include <span>

/// \file
/// Triangles whose boxes are mostly empty are cut to pieces before the tree is built, each piece with a box of its own
/// (Karras and Aila, Fast parallel construction of high-quality bounding volume hierarchies, 2013, section 4.3).

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// The corners, in the scale of the boxes.
using corners = std::array<vec3<double>, 3>;

/// How much of a box is empty, in a measure that evens out what is gained by the next cut.
inline float split_priority(const build_box& box, const corners& t) {
    const vec3<double> normal = cross(t[1] - t[0], t[2] - t[0]);
    const double ideal = 0.5 * norm1(normal);  // the boxes of ever smaller pieces come to that
    return static_cast<float>(std::cbrt(std::max(0.0, static_cast<double>(box.half_area()) - ideal)));
}

/// The plane, of those that halve the scene, halve the halves and so on, that comes first and cuts the box.
inline float split_plane(const build_box& box, const build_box& scene, unsigned axis) {
    const float low = box.low(axis), high = box.high(axis), per_cell = scene.extent(axis) * 0x1p-20f;
    const auto cell = [&](float x) { return static_cast<std::uint32_t>((x - scene.low(axis)) / per_cell); };
    const std::uint32_t first = cell(low), last = cell(high);
    const float plane =
        scene.low(axis) + static_cast<float>(last & ~(std::bit_floor(std::max(1u, first ^ last)) - 1)) * per_cell;
    return first != last && low < plane && plane < high ? plane : low + (high - low) / 2;
}

/// The parts of a box on both sides of a plane, no larger than what is there of the triangle.
inline std::array<build_box, 2> split_box(const build_box& box, const corners& t, unsigned axis, float plane) {
    const auto at = static_cast<glm::length_t>(axis);
    const auto position = static_cast<double>(plane);
    std::array<aabb<double>, 2> sides;
    for (unsigned i = 0; i < 3; ++i) {
        const vec3<double>&p = t[i], &q = t[(i + 1) % 3];
        if (p[at] <= position) sides[0] = hull(sides[0], p);
        if (p[at] >= position) sides[1] = hull(sides[1], p);
        if ((p[at] < position) == (q[at] < position)) continue;
        const vec3<double> between = p + (q - p) * std::clamp((position - p[at]) / (q[at] - p[at]), 0.0, 1.0);
        sides[0] = hull(sides[0], between), sides[1] = hull(sides[1], between);
    }
    std::array<build_box, 2> parts;
    for (unsigned side = 0; side < 2; ++side) {
        // What is here is inside both boxes.
        const build_box tight = to_build_box(padded(sides[side]), box.id());
        parts[side].v = build_box::numbers::max(box.v, tight.v);
        parts[side].set_id(box.id());
        const unsigned limit = side == 0 ? axis + 4 : axis;  // minus the high side, or the low one
        parts[side].v.set(limit, max(box.v[limit], side == 0 ? -plane : plane));
    }
    return parts;
}

/// \param corners_of  the corners of a reference's triangle; nothing for other shapes
/// \param budget      how many pieces more there may be, for each reference
template <class CornersOf>
large_vector<build_box> presplit(std::span<const build_box> references, float budget, unsigned threads,
                                 CornersOf corners_of) {
    constexpr std::size_t part_size = 4096;
    const std::size_t n = references.size(), parts = parts_of(part_size, n);
    build_box scene;
    for (const build_box& r : references) scene.include(r);
    std::vector<float> priority(n);
    std::vector<double> sums(parts, 0);
    const auto for_each_part = [&](auto work) {
        parallel_for(parts, threads, [&](std::size_t i) {
            const part p = part_of(i, part_size, n);
            for (std::size_t j = p.begin; j < p.end; ++j) work(i, j);
        });
    };
    for_each_part([&](std::size_t i, std::size_t j) {
        const auto own = corners_of(references[j].id());
        priority[j] = own ? split_priority(references[j], *own) : 0;
        sums[i] += static_cast<double>(priority[j]);
    });
    double sum = 0;
    for (const double s : sums) sum += s;

    // How many cuts a priority is worth: found by halving, since they are whole numbers.
    double low = 0, high = sum > 0 ? 2 * static_cast<double>(budget) * static_cast<double>(n) / sum : 0;
    std::vector<std::uint64_t> counts(parts);
    for (int step = 0; step < 12; ++step) {
        const double worth = (low + high) / 2;
        std::ranges::fill(counts, 0u);
        for_each_part([&](std::size_t i, std::size_t j) {
            counts[i] += static_cast<std::uint64_t>(worth * static_cast<double>(priority[j]));
        });
        std::uint64_t count = 0;
        for (const std::uint64_t c : counts) count += c;
        (static_cast<double>(count) <= static_cast<double>(budget) * static_cast<double>(n) ? low : high) = worth;
    }

    struct open_piece {
        build_box box;
        std::uint64_t cuts;
    };
    std::vector<std::vector<build_box>> pieces(parts);
    parallel_for(parts, threads, [&](std::size_t i) {
        const part p = part_of(i, part_size, n);
        std::vector<open_piece> stack;
        for (std::size_t j = p.begin; j < p.end; ++j) {
            const auto cuts = static_cast<std::uint64_t>(low * static_cast<double>(priority[j]));
            stack.push_back({references[j], cuts});
            while (!stack.empty()) {
                const open_piece piece = stack.back();
                stack.pop_back();
                if (piece.cuts == 0) {  // as of each that has no extent
                    pieces[i].push_back(piece.box);
                    continue;
                }
                const unsigned axis = piece.box.largest_axis();
                const auto halves =
                    split_box(piece.box, *corners_of(piece.box.id()), axis, split_plane(piece.box, scene, axis));
                std::array<float, 2> extent{};
                for (unsigned side = 0; side < 2; ++side) {
                    extent[side] = max(0.0f, halves[side].extent(halves[side].largest_axis()));
                }
                // Along that axis the triangle is as long as the box, so one half at least has an extent.
                const float both = std::max(extent[0] + extent[1], std::numeric_limits<float>::min());
                const float share = extent[0] / both;
                const auto left = std::min(
                    piece.cuts - 1, static_cast<std::uint64_t>(static_cast<float>(piece.cuts - 1) * share + 0.5f));
                for (unsigned side = 0; side < 2; ++side) {
                    // Far off, where boxes are rounded coarsely, one side may hold nothing of the triangle.
                    const build_box& half = halves[side];
                    const bool empty =
                        half.low(0) > half.high(0) || half.low(1) > half.high(1) || half.low(2) > half.high(2);
                    if (!empty) stack.push_back({half, side == 0 ? left : piece.cuts - 1 - left});
                }
            }
        }
    });
    std::vector<std::size_t> begin;
    std::size_t total = 0;
    for (const auto& some : pieces) begin.push_back(std::exchange(total, total + some.size()));
    large_vector<build_box> all(total);
    parallel_for(parts, threads, [&](std::size_t i) { std::ranges::copy(pieces[i], all.data() + begin[i]); });
    return all;
}

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
