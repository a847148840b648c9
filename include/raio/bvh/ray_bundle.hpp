#pragma once

#include <span>

#include <raio/bvh/wide_node.hpp>

namespace raio::detail {

/// Rays that run side by side, in the same octant, as many as there are lanes.
///
/// A node's boxes are asked twice. First all of them together about the bundle, of which is known in what intervals
/// 1 / direction and the origin lie along each axis: most are out at once. Of the others each is then asked about all
/// rays together, as `node_ray` asks.
///
/// Of (p - o) r, with p - o and r in intervals of one sign of r, the extremes are at the ends of both. It is rounded
/// twice, and r once: by no more than 3 u (|p| + |o|) |r|, for which there is the slack of `slab_numbers`.
class ray_bundle {
public:
    using numbers = node_ray::numbers;
    static constexpr std::size_t most = node_width;

    /// \param rays   at least one, at most `most`
    /// \param scale  of the boxes, a power of two, over what they stand for
    /// \param size   the largest coordinate of all boxes
    template <class T>
    ray_bundle(std::span<const ray<T>> rays, T scale, float size) {
        std::array<std::array<float, most>, 3> origin, direction;
        for (std::size_t i = 0; i < most; ++i) {
            const ray<T>& ray = rays[std::min(i, rays.size() - 1)];  // lanes without a ray repeat the last
            for (unsigned axis = 0; axis < 3; ++axis) {
                const auto at = static_cast<glm::length_t>(axis);
                origin[axis][i] = static_cast<float>(ray.origin[at] * scale);
                direction[axis][i] = static_cast<float>(ray.direction[at] * scale);
            }
        }
        const auto sum_of = [](const auto& v) {
            const auto size_of = [&](unsigned axis) { return abs(numbers::load(v[axis].data())); };
            return size_of(0) + size_of(1) + size_of(2);
        };
        numbers length = sum_of(direction), reach = numbers(size) + sum_of(origin);
        for (std::size_t i = 0; i < most; ++i) {
            is_coherent_ = is_coherent_ && slab_numbers<numbers>::fits(length[i], reach[i]);
        }
        if (!is_coherent_) return;
        for (unsigned axis = 0; axis < 3; ++axis) {
            const slab_numbers<numbers> slabs(numbers::load(origin[axis].data()), numbers::load(direction[axis].data()),
                                              length, reach);
            over_direction_[axis] = slabs.over_direction, enter_[axis] = slabs.enter, leave_[axis] = slabs.leave;
            const auto [low_origin, high_origin] = std::ranges::minmax(origin[axis]);
            const auto [low, high] = extremes(slabs.over_direction);
            is_coherent_ = is_coherent_ && (low > 0 || high < 0);
            low_over_direction_[axis] = numbers(low), high_over_direction_[axis] = numbers(high);
            near_[axis] = 2 * axis + (low > 0 ? 0 : 1);
            near_origin_[axis] = numbers(low > 0 ? high_origin : low_origin);
            far_origin_[axis] = numbers(low > 0 ? low_origin : high_origin);
            slack_[axis] = numbers(extremes(slabs.slack).max);
        }
    }

    /// Do the rays run through one octant? Nothing else may be asked where they do not.
    bool is_coherent() const { return is_coherent_; }

    /// Which children may be met by any of the rays between `t_min` and `t_max`, one bit for each, and where the first
    /// of them may enter.
    std::uint32_t children_met(const wide_node& node, const numbers& t_min, const numbers& t_max,
                               numbers& entry) const {
        numbers exit = t_max;
        entry = t_min;
        for (unsigned axis = 0; axis < 3; ++axis) {
            const auto distance = [&](unsigned plane, const numbers& origin) {
                return numbers::load(node.planes[plane].data()) - origin;
            };
            numbers near = distance(near_[axis], near_origin_[axis]),
                    far = distance(near_[axis] ^ 1, far_origin_[axis]);
            const numbers &low = low_over_direction_[axis], &high = high_over_direction_[axis];
            entry = numbers::max(entry, numbers::min(near * low, near * high) - slack_[axis]);
            exit = numbers::min(exit, numbers::max(far * low, far * high) + slack_[axis]);
        }
        return bits(entry <= exit);
    }

    /// Which rays meet the child at that place between `t_min` and `t_max`, one bit for each.
    std::uint32_t rays_met(const wide_node& node, std::size_t place, const numbers& t_min, const numbers& t_max) const {
        numbers entry = t_min, exit = t_max;
        for (unsigned axis = 0; axis < 3; ++axis) {
            numbers near(node.planes[near_[axis]][place]), far(node.planes[near_[axis] ^ 1][place]);
            entry = numbers::max(entry, near * over_direction_[axis] - enter_[axis]);
            exit = numbers::min(exit, far * over_direction_[axis] - leave_[axis]);
        }
        return bits(entry <= exit);
    }

private:
    static std::ranges::minmax_result<float> extremes(const numbers& n) {
        std::array<float, most> all;
        n.store(all.data());
        return std::ranges::minmax(all);
    }

    std::array<numbers, 3> over_direction_, enter_, leave_;  // lane by lane
    std::array<numbers, 3> low_over_direction_, high_over_direction_, near_origin_, far_origin_, slack_;  // of all
    std::array<unsigned, 3> near_;
    bool is_coherent_ = true;
};

}  // namespace raio::detail
