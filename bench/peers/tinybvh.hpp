#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <tiny_bvh.h>
#include <raio/ray.hpp>

/// \file
/// The triangles of a mesh in tinybvh's BVH8_CPU, its fastest layout for single rays. Needs AVX2 and FMA.

namespace peers {

/// One mesh. Nothing is hit before `build`.
class tinybvh {
public:
    using vec3 = raio::vec3<float>;
    using ray = raio::ray<float>;

    /// What it finds: t, two barycentric coordinates, and which triangle.
    using record = ::tinybvh::Intersection;

    void add_triangles(std::span<const vec3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles) {
        for (const auto& triangle : triangles) {
            for (const std::uint32_t i : triangle) {
                corners_.emplace_back(vertices[i].x, vertices[i].y, vertices[i].z, 0.0f);
            }
        }
    }

    /// \param high  by spatial splits
    void build(bool high = false) {
        const auto count = static_cast<std::uint32_t>(corners_.size() / 3);
        if (high) {
            tree_.BuildHQ(corners_.data(), count);
        } else {
            tree_.Build(corners_.data(), count);
        }
    }

    /// t counts in lengths of a unit direction, from 0 on.
    bool hit(const ray& r, float, float t_max, record& rec) const {
        ::tinybvh::Ray asked = from(r, t_max);
        const float end = asked.hit.t;
        tree_.Intersect(asked);
        rec = asked.hit;
        return rec.t < end;
    }

    bool occluded(const ray& r, float, float t_max) const { return tree_.IsOccluded(from(r, t_max)); }

private:
    static ::tinybvh::Ray from(const ray& r, float t_max) {
        const auto vector = [](const vec3& v) { return ::tinybvh::bvhvec3(v.x, v.y, v.z); };
        return {vector(r.origin), vector(r.direction), std::min(t_max, BVH_FAR)};
    }

    std::vector<::tinybvh::bvhvec4> corners_;  // has to outlive the tree
    ::tinybvh::BVH8_CPU tree_;
};

}  // namespace peers
