#pragma once

#include <raio/push_macros.hpp>

#include <raio/bvh/traverse.hpp>

/// \file
/// Many rays at once: those that run side by side go through a tree together.

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// Calls `answer` with as many rays at a time as go through a tree together, and with the number of the first of them;
/// puts together what it answers, one bit for each.
template <class T, class Answer>
std::uint64_t for_each_bundle(std::span<const ray<T>> rays, Answer answer) {
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < rays.size(); i += ray_bundle::most) {
        all |= answer(rays.subspan(i, std::min(ray_bundle::most, rays.size() - i)), i) << i;
    }
    return all;
}

/// One bit for each of `count` answers.
template <class Answer>
std::uint64_t bits_of(std::size_t count, Answer answer) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < count; ++i) bits |= std::uint64_t{answer(i)} << i;
    return bits;
}

/// The answers for rays that do not go together: of two halves, which may run in one octant each, or one by one.
template <class T, class Part, class One>
std::uint64_t answer_apart(std::span<const ray<T>> rays, Part part, One one) {
    if (rays.size() <= rays_in_lanes<T>::lanes) return bits_of(rays.size(), one);
    const std::size_t half = rays.size() / 2;
    return part(0, half) | part(half, rays.size() - half) << half;
}

/// Calls `visit` with all leaves that the rays of a bundle may meet, with one bit for each ray that may, and with a
/// function that says of boxes in lanes which of them any ray may meet. Answers false, and does nothing, if the rays do
/// not run side by side.
/// \param far_of  answers how far a ray still has to be followed
template <class Tree, class T, class Visit, class Far>
bool visit_leaves_together(const Tree& tree, const rays_in_lanes<T>& lanes, std::size_t count, T t_min, T t_max,
                           Visit visit, Far far_of) {
    using leaves = typename Tree::leaves_type;
    if (tree.nodes.empty() || !(t_min <= t_max)) return false;
    const ray_bundle bundle(lanes, tree.scale, tree.size);
    if (!bundle.is_coherent()) return false;
    std::array<float, ray_bundle::most> far;
    far.fill(-infinity<float>);
    std::fill_n(far.begin(), count, rounded_up(t_max));
    const float from = rounded_down(t_min);
    const auto visit_leaf = [&](std::uint32_t leaf, std::uint64_t of, float farthest) {
        const auto near = [&]<std::size_t N>(const aabb<pack<T, N>>& boxes) {
            using numbers = pack<float, N>;
            const auto scaled = [&](const vec3<pack<T, N>>& v) {
                return vec3<numbers>(numbers(v.x * tree.scale), numbers(v.y * tree.scale), numbers(v.z * tree.scale));
            };
            return bundle.boxes_met(aabb<numbers>{scaled(boxes.min), scaled(boxes.max)}, from, farthest);
        };
        leaves::with_kind(child::kind(leaf), [&](auto kind) {
            visit(kind, child::block(leaf), of, near);
            for (; of != 0; of &= of - 1) {
                const auto i = static_cast<std::size_t>(std::countr_zero(of));
                far[i] = rounded_up(far_of(i));
            }
        });
    };
    traverse(tree.nodes, bundle, from, far, visit_leaf);
    return true;
}

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
