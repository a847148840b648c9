#pragma once

#include <raio/bvh/bvh.hpp>

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

/// \file
/// What a tree of triangles would cost that believes its floats: raio's own nodes in raio's own order, and at the
/// leaves Moeller and Trumbore 1997 as it is printed. Nothing states an error, nothing is settled, and of the nearest
/// is recorded what Embree records.

namespace peers {

class inexact_tree {
public:
    using triangle = raio::triangle<float>;
    using vec3 = raio::vec3<float>;

    struct record {
        float t, u, v;
        vec3 normal;  ///< of any length
        std::uint32_t index;
    };

    explicit inexact_tree(std::span<const triangle> triangles) {
        tree_.build(std::tuple(triangles), {.threads = 1});
        const auto& leaves = std::get<0>(tree_.leaves.all);
        blocks_.resize(leaves.size());
        for (std::uint32_t i = 0; i < leaves.size(); ++i) {
            for (unsigned lane = 0; lane < lanes; ++lane) {
                const triangle t = leaves.shape(i, lane);
                set(blocks_[i].a, lane, t.a);
                set(blocks_[i].e1, lane, t.b - t.a);
                set(blocks_[i].e2, lane, t.c - t.a);
                blocks_[i].ids[lane] = leaves.id(i, lane);
            }
        }
    }

    [[gnu::flatten]] bool hit(const raio::ray<float>& ray, float t_min, float t_max, record& rec) const {
        const raio::detail::node_ray boxes(ray, tree_.scale, tree_.size);
        bool exists = false;
        raio::detail::traverse(tree_.nodes, boxes, t_min, t_max, [&](std::uint32_t leaf) {
            const block& b = blocks_[raio::detail::child::block(leaf)];
            const crossings found(b, ray, t_min, t_max);
            if (found.met == 0) return true;
            const numbers t = found.t();
            for (std::uint32_t met = found.met; met != 0; met &= met - 1) {
                const auto lane = static_cast<unsigned>(std::countr_zero(met));
                if (t[lane] > t_max) continue;
                t_max = t[lane], exists = true;
                const float over_size = 1 / found.size[lane];
                rec = {t_max, found.u[lane] * over_size, found.v[lane] * over_size,
                       raio::cross(get(b.e1, lane), get(b.e2, lane)), b.ids[lane]};
            }
            return true;
        });
        return exists;
    }

    [[gnu::flatten]] bool occluded(const raio::ray<float>& ray, float t_min, float t_max) const {
        const raio::detail::node_ray boxes(ray, tree_.scale, tree_.size);
        bool found = false;
        raio::detail::traverse_any(tree_.nodes, boxes, t_min, t_max, [&](std::uint32_t leaf) {
            found = crossings(blocks_[raio::detail::child::block(leaf)], ray, t_min, t_max).met != 0;
            return !found;
        });
        return found;
    }

private:
    static constexpr std::size_t lanes = raio::detail::leaf_blocks<triangle>::lanes;
    using numbers = raio::pack<float, lanes>;

    struct block {
        raio::vec3<numbers> a, e1, e2;
        std::array<std::uint32_t, lanes> ids;
    };

    /// Before anything is divided.
    struct crossings {
        numbers size, u, v, way;
        std::uint32_t met;  ///< a bit for each lane

        crossings(const block& b, const raio::ray<float>& ray, float t_min, float t_max) {
            const raio::vec3<numbers> d(ray.direction), s = raio::vec3<numbers>(ray.origin) - b.a;
            const raio::vec3<numbers> p = raio::cross(d, b.e2), q = raio::cross(s, b.e1);
            const numbers det = raio::dot(b.e1, p);
            size = abs(det), u = raio::flip(raio::dot(s, p), det), v = raio::flip(raio::dot(d, q), det);
            way = raio::flip(raio::dot(b.e2, q), det);
            const numbers inside = raio::min(raio::min(u, v), size - (u + v));
            met = bits(raio::every(inside >= numbers(0), size > numbers(0), way >= numbers(t_min) * size,
                                   way <= numbers(t_max) * size));
        }

        numbers t() const { return way / size; }
    };

    static void set(raio::vec3<numbers>& to, unsigned lane, const vec3& v) {
        to.x.set(lane, v.x), to.y.set(lane, v.y), to.z.set(lane, v.z);
    }
    static vec3 get(const raio::vec3<numbers>& v, unsigned lane) { return {v.x[lane], v.y[lane], v.z[lane]}; }

    raio::detail::assembled<triangle> tree_;
    raio::detail::large_vector<block> blocks_;
};

}  // namespace peers
