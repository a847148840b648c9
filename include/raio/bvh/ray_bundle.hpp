#pragma once

#include <raio/push_macros.hpp>

#include <span>

#include <raio/aabb.hpp>
#include <raio/bvh/wide_node.hpp>
#include <raio/proof/lanes.hpp>

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// The rays of a bundle, in lanes, group after group. Lanes without a ray repeat the last one.
template <class T>
class rays_in_lanes {
public:
    static constexpr std::size_t lanes = node_width, most_groups = 4;
    using numbers = pack<T, lanes>;

    /// \param rays  at least one, at most as many as there are lanes in all groups
    explicit rays_in_lanes(std::span<const ray<T>> rays) : count_((rays.size() + lanes - 1) / lanes) {
        for (std::size_t g = 0; g < count_; ++g) {
            const std::span<const ray<T>> own = rays.subspan(g * lanes, std::min(lanes, rays.size() - g * lanes));
            for (std::size_t lane = 0; lane < own.size(); ++lane) set(g, lane, own[lane]);
            for (std::size_t lane = own.size(); lane < lanes; ++lane) set(g, lane, own.back());
        }
    }

    std::span<const ray<numbers>> groups() const { return std::span(groups_).first(count_); }

private:
    void set(std::size_t g, std::size_t lane, const ray<T>& from) {
        set_lane(groups_[g].origin, lane, from.origin), set_lane(groups_[g].direction, lane, from.direction);
    }

    std::array<ray<numbers>, most_groups> groups_;
    std::size_t count_;
};

/// Rays that run side by side, in the same octant.
///
/// A node's boxes are asked about the bundle, of which is known in what intervals 1 / direction and the origin lie
/// along each axis: most are out at once. The box of a leaf that is met is then asked about all rays, as `node_ray`
/// asks.
///
/// Of (p - o) r, with p - o and r in intervals of one sign of r, the extremes are at the ends of both. It is rounded
/// twice, and r once: by no more than 3 u (|p| + |o|) |r|, for which there is the slack of `slab_numbers`.
class ray_bundle {
public:
    using numbers = node_ray::numbers;
    static constexpr std::size_t most = rays_in_lanes<float>::lanes * rays_in_lanes<float>::most_groups;

    /// \param scale  of the boxes, a power of two, over what they stand for
    /// \param size   the largest coordinate of all boxes
    template <class T>
    ray_bundle(const rays_in_lanes<T>& rays, T scale, float size) {
        using given = typename rays_in_lanes<T>::numbers;
        std::array<numbers, 3> low, high, low_origin, high_origin, slack;
        for (const ray<given>& from : rays.groups()) {
            group& to = groups_[group_count_++];
            const auto scaled = [&](const vec3<given>& v) {
                return vec3<numbers>(numbers(v.x * scale), numbers(v.y * scale), numbers(v.z * scale));
            };
            const vec3<numbers> origin = scaled(from.origin), direction = scaled(from.direction);
            const numbers length = norm1(direction), reach = numbers(size) + norm1(origin);
            is_coherent_ = is_coherent_ && all(slab_numbers<numbers>::fits(length, reach));
            if (!is_coherent_) return;
            for (unsigned axis = 0; axis < 3; ++axis) {
                const auto at = static_cast<glm::length_t>(axis);
                const slab_numbers<numbers> slabs(origin[at], direction[at], length, reach);
                to.over_direction[axis] = slabs.over_direction, to.enter[axis] = slabs.enter;
                to.leave[axis] = slabs.leave;
                const bool first = group_count_ == 1;
                const auto lower = [&](numbers& n, const numbers& x) { n = first ? x : numbers::min(n, x); };
                const auto raise = [&](numbers& n, const numbers& x) { n = first ? x : numbers::max(n, x); };
                lower(low[axis], slabs.over_direction), raise(high[axis], slabs.over_direction);
                lower(low_origin[axis], origin[at]), raise(high_origin[axis], origin[at]);
                raise(slack[axis], slabs.slack);
            }
        }
        for (unsigned axis = 0; axis < 3; ++axis) {
            const float least = extremes(low[axis]).min, greatest = extremes(high[axis]).max;
            const bool forward = least > 0;
            is_coherent_ = is_coherent_ && (forward || greatest < 0);
            near_[axis] = 2 * axis + (forward ? 0 : 1);
            const float from = extremes(low_origin[axis]).min, to = extremes(high_origin[axis]).max;
            slabs_[axis] = {least, greatest, forward ? to : from, forward ? from : to, extremes(slack[axis]).max};
        }
    }
    template <class T>
    ray_bundle(std::span<const ray<T>> rays, T scale, float size) : ray_bundle(rays_in_lanes<T>(rays), scale, size) {}

    /// Do the rays run through one octant? Nothing else may be asked where they do not.
    bool is_coherent() const { return is_coherent_; }

    /// Which children may be met by any of the rays between `t_min` and `t_max`, one bit for each, and where the first
    /// of them may enter.
    std::uint32_t children_met(const wide_node& node, const numbers& t_min, const numbers& t_max,
                               numbers& entry) const {
        return met_by_any([&](unsigned plane) { return numbers::load(node.planes[plane].data()); }, t_min, t_max,
                          entry);
    }

    /// Which boxes may be, lane by lane.
    template <std::size_t N>
    std::uint32_t boxes_met(const aabb<pack<float, N>>& boxes, float t_min, float t_max) const {
        pack<float, N> entry;
        const auto plane = [&](unsigned i) {
            return (i % 2 == 0 ? boxes.min : boxes.max)[static_cast<glm::length_t>(i / 2)];
        };
        return met_by_any(plane, pack<float, N>(t_min), pack<float, N>(t_max), entry);
    }

    /// Which rays meet the child at that place between `t_min` and their own `t_max`, one bit for each.
    std::uint64_t rays_met(const wide_node& node, std::size_t place, const numbers& t_min,
                           const std::array<float, most>& t_max) const {
        std::uint64_t met = 0;
        std::array<numbers, 3> near, far;
        for (unsigned axis = 0; axis < 3; ++axis) {
            near[axis] = numbers(node.planes[near_[axis]][place]);
            far[axis] = numbers(node.planes[near_[axis] ^ 1][place]);
        }
        for (std::size_t g = 0; g < group_count_; ++g) {
            const group& rays = groups_[g];
            numbers entry = t_min, exit = numbers::load(&t_max[g * numbers::lanes]);
            for (unsigned axis = 0; axis < 3; ++axis) {
                entry = numbers::max(entry, near[axis] * rays.over_direction[axis] - rays.enter[axis]);
                exit = numbers::min(exit, far[axis] * rays.over_direction[axis] - rays.leave[axis]);
            }
            met |= std::uint64_t{bits(entry <= exit)} << (g * numbers::lanes);
        }
        return met;
    }

private:
    /// \param plane  answers with the low and high planes of the boxes along x, y and z
    template <class Plane, class Numbers>
    std::uint32_t met_by_any(Plane plane, const Numbers& t_min, const Numbers& t_max, Numbers& entry) const {
        Numbers exit = t_max;
        entry = t_min;
        for (unsigned axis = 0; axis < 3; ++axis) {
            const slab& along = slabs_[axis];
            Numbers near = plane(near_[axis]) - Numbers(along.near_origin),
                    far = plane(near_[axis] ^ 1) - Numbers(along.far_origin);
            const Numbers low(along.low), high(along.high), slack(along.slack);
            entry = Numbers::max(entry, Numbers::min(near * low, near * high) - slack);
            exit = Numbers::min(exit, Numbers::max(far * low, far * high) + slack);
        }
        return bits(entry <= exit);
    }

    struct group {
        std::array<numbers, 3> over_direction, enter, leave;  // lane by lane
    };

    /// What is known of all rays along an axis: the extremes of 1 / direction, and the origins from which that matters.
    struct slab {
        float low, high, near_origin, far_origin, slack;
    };

    static std::ranges::minmax_result<float> extremes(const numbers& n) {
        std::array<float, numbers::lanes> all;
        n.store(all.data());
        return std::ranges::minmax(all);
    }

    std::array<group, rays_in_lanes<float>::most_groups> groups_;
    std::size_t group_count_ = 0;
    std::array<slab, 3> slabs_;
    std::array<unsigned, 3> near_;
    bool is_coherent_ = true;
};

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
