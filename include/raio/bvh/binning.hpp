#pragma once

#include <raio/push_macros.hpp>

#include <span>

#include <raio/bvh/build_box.hpp>

/// \file
/// Where to cut a set of boxes in two: between two of the bins that their centres fall into, where the surface area
/// heuristic is smallest (Wald, On fast construction of SAH-based bounding volume hierarchies, 2007).

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

inline constexpr int bin_count = 16;

/// The box around twice the centre alone: what bins and their extent are counted in.
inline build_box center_box(const build_box& box) {
    // As a whole: a register that is put together from single numbers waits until they have reached memory.
    const auto v = std::bit_cast<std::array<float, 8>>(box.v);
    const std::array<float, 8> swapped{v[4], v[5], v[6], v[7], v[0], v[1], v[2], v[3]};
    build_box b;
    b.v = box.v - std::bit_cast<build_box::numbers>(swapped);
    return b;
}

/// The box around all the centres.
inline build_box centers_of(std::span<const build_box> boxes) {
    build_box centers;
    for (const build_box& box : boxes) centers.include(center_box(box));
    return centers;
}

/// Which bin a centre falls into: the extent of all the centres, axis by axis, in equal parts.
struct bin_scale {
    std::array<float, 3> low, scale;

    explicit bin_scale(const build_box& centers) {
        for (unsigned axis = 0; axis < 3; ++axis) {
            low[axis] = centers.low(axis);
            scale[axis] = cells_per_length(bin_count, centers.extent(axis));
        }
    }

    unsigned operator()(const build_box& box, unsigned axis) const {
        return static_cast<unsigned>(static_cast<int>((center2(box, axis) - low[axis]) * scale[axis]));
    }
};

struct bin_split {
    float cost = build_box::none;  ///< the half areas of both sides, each times what its boxes count
    unsigned axis = 3;             ///< 3: the boxes cannot be told apart
    unsigned last = 0;             ///< the last bin of the left side
    std::uint32_t left_count = 0;
};

/// What has fallen into the bins of each axis.
struct bins {
    std::array<std::array<build_box, bin_count>, 3> box;
    std::array<std::array<std::uint32_t, bin_count>, 3> count{};

    void add(const build_box& reference, const bin_scale& bin_of) {
        for (unsigned axis = 0; axis < 3; ++axis) {
            const unsigned b = bin_of(reference, axis);
            box[axis][b].include(reference);
            ++count[axis][b];
        }
    }

    void add(std::span<const build_box> references, const bin_scale& bin_of) {
        // From both halves in turn: neighbours fall into the same bin, and would wait for each other.
        const std::size_t half = references.size() / 2;
        for (std::size_t i = 0; i < half; ++i) {
            add(references[i], bin_of);
            add(references[half + i], bin_of);
        }
        if (2 * half < references.size()) add(references.back(), bin_of);
    }

    void add(const bins& other) {
        for (unsigned axis = 0; axis < 3; ++axis) {
            for (unsigned b = 0; b < bin_count; ++b) {
                box[axis][b].include(other.box[axis][b]);
                count[axis][b] += other.count[axis][b];
            }
        }
    }

    /// \param leaf  how many boxes a leaf has room for, a power of two. A place that stays empty counts a quarter of a
    /// box: trees are smaller then, and as fast. (Measured: of a million triangles 57.7 instead of 64.7 bytes each; if
    /// it counts a half, or as much as a box, long triangles that lie across each other are found up to a seventh
    /// slower.)
    bin_split best_split(std::uint32_t leaf) const {
        const auto weight = [&](std::uint32_t boxes) {
            const std::uint32_t empty = (0 - boxes) & (leaf - 1);
            return static_cast<float>(boxes) + 0.25f * static_cast<float>(empty);
        };
        bin_split best;
        for (unsigned axis = 0; axis < 3; ++axis) {
            std::array<float, bin_count> right_cost;
            build_box side;
            std::uint32_t beyond = 0;
            for (unsigned b = bin_count - 1; b > 0; --b) {
                side.include(box[axis][b]);
                beyond += count[axis][b];
                right_cost[b] = side.half_area() * weight(beyond);
            }
            side = {};
            std::uint32_t before = 0;
            const std::uint32_t total = beyond + count[axis][0];
            for (unsigned b = 0; b + 1 < bin_count; ++b) {
                side.include(box[axis][b]);
                before += count[axis][b];
                if (before == total) break;  // the lowest bin holds the lowest centre, so before > 0
                const float cost = side.half_area() * weight(before) + right_cost[b + 1];
                if (cost < best.cost) {
                    best = {cost, axis, b, before};
                }
            }
        }
        return best;
    }
};

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
