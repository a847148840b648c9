#pragma once

#include <raio/push_macros.hpp>

#include <raio/bvh/ray_bundle.hpp>

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// No tree is deeper.
inline constexpr std::size_t deepest = 96;

/// Does the ray go anywhere? No other is asked of a tree.
template <class T>
bool runs(const ray<T>& ray) {
    return norm1(ray.direction) > T(0) && is_finite(ray.direction) && is_finite(ray.origin);
}
template <class T>
bool runs(const mapped_ray<T>& ray) {
    return runs(values_of(ray));
}

/// Calls `visit` with the leaves that the ray may meet between `t_min` and `t_max`, the nearer mostly before the
/// farther.
/// \param t_max  may be brought nearer by `visit`, which answers whether to go on
template <class Visit>
void traverse(std::span<const wide_node> nodes, const node_ray& ray, float t_min, const float& t_max, Visit visit) {
    struct open_child {
        float t;
        std::uint32_t child;
    };
    using numbers = node_ray::numbers;
    std::array<open_child, deepest*(node_width - 1) + 1> stack;
    std::size_t open = 0;
    std::uint32_t current = 0;
    const auto pop = [&] {
        do {
            if (open == 0) return false;
            --open;
        } while (!(stack[open].t <= t_max));
        current = stack[open].child;
        return true;
    };
    numbers from(t_min);
    do {
        while (!child::is_leaf(current)) {
            const wide_node& node = nodes[current];
            numbers entry;
            std::uint32_t met = ray.meets(node, from, numbers(t_max), entry);
            if (met == 0) {
                if (!pop()) return;
                continue;
            }
            const auto first = static_cast<unsigned>(std::countr_zero(met));
            met &= met - 1;
            current = node.child_at(first);
            if (met == 0) continue;
            open_child nearest{entry[first], current};
            const std::size_t bottom = open;
            for (; met != 0; met &= met - 1) {
                const auto i = static_cast<unsigned>(std::countr_zero(met));
                open_child next{entry[i], node.child_at(i)};
                if (next.t < nearest.t) std::swap(next, nearest);
                std::size_t at = open++;
                for (; at > bottom && stack[at - 1].t < next.t; --at) stack[at] = stack[at - 1];
                stack[at] = next;
            }
            current = nearest.child;
        }
    } while (visit(current) && pop());
}

/// Calls `visit` with the leaves that the ray may meet between `t_min` and `t_max`, in no order, as long as it answers
/// true. Children that are left wait in groups: a node, and a bit for each.
template <class Visit>
void traverse_any(std::span<const wide_node> nodes, const node_ray& ray, float t_min, float t_max, Visit visit) {
    struct group {
        const wide_node* node;
        std::uint32_t met;
    };
    using numbers = node_ray::numbers;
    std::array<group, deepest + 1> stack;
    group* top = stack.data();
    const numbers from(t_min), to(t_max);
    numbers entry;
    const wide_node* node = nodes.data();
    std::uint32_t met = ray.meets(*node, from, to, entry), next = 0;
    do {
        for (;;) {
            while (met == 0) {
                if (top == stack.data()) return;
                --top;
                node = top->node, met = top->met;
            }
            next = node->child_at(static_cast<unsigned>(std::countr_zero(met)));
            met &= met - 1;
            if (child::is_leaf(next)) break;
            *top = {node, met};
            top += met != 0 ? 1 : 0;
            node = nodes.data() + next;
            met = ray.meets(*node, from, to, entry);
        }
    } while (visit(next));
}

/// The largest of them.
inline float greatest(const std::array<float, ray_bundle::most>& all) {
    using four = pack<float, 4>;
    four most = four::load(all.data());
    for (std::size_t i = 4; i < all.size(); i += 4) most = four::max(most, four::load(&all[i]));
    return std::max({most[0], most[1], most[2], most[3]});
}

/// Calls `visit` with the leaves that rays of a bundle may meet between `t_min` and the ray's own `t_max`, with one
/// bit for each of these rays, and with how far any ray is followed.
/// \param t_max  may be brought nearer by `visit`: below `t_min` if the ray wants no more
template <class Visit>
void traverse(std::span<const wide_node> nodes, const ray_bundle& bundle, float t_min,
              const std::array<float, ray_bundle::most>& t_max, Visit visit) {
    struct open_child {
        float t;
        std::uint32_t node, place;  ///< whose child
    };
    using numbers = ray_bundle::numbers;
    std::array<open_child, deepest*(node_width - 1) + 1> stack;
    std::size_t open = 0;
    std::uint32_t current = 0;
    const numbers from(t_min);
    float farthest = greatest(t_max);
    for (;;) {
        const wide_node& node = nodes[current];
        numbers entry;
        const std::size_t bottom = open;
        for (std::uint32_t met = bundle.children_met(node, from, numbers(farthest), entry); met != 0; met &= met - 1) {
            const auto i = static_cast<unsigned>(std::countr_zero(met));
            const open_child next{entry[i], current, i};
            std::size_t at = open++;
            for (; at > bottom && stack[at - 1].t < next.t; --at) stack[at] = stack[at - 1];
            stack[at] = next;
        }
        for (;;) {
            if (open == 0) return;
            const open_child next = stack[--open];
            if (!(next.t <= farthest)) continue;
            const wide_node& parent = nodes[next.node];
            const std::uint32_t child = parent.child_at(next.place);
            if (!child::is_leaf(child)) {
                current = child;
                break;
            }
            const std::uint64_t rays = bundle.rays_met(parent, next.place, from, t_max);
            if (rays == 0) continue;
            visit(child, rays, farthest);
            farthest = greatest(t_max);
        }
    }
}

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
