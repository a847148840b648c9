#pragma once

#include <raio/push_macros.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <raio/compose/closed_surface.hpp>
#include <raio/compose/group.hpp>
#include <raio/failure.hpp>
#include <raio/number/simd.hpp>
#include <raio/shape/triangle.hpp>

namespace raio::inline RAIO_ABI {

/// Triangles that share their corners: each is three indices of vertices, counter-clockwise from outside.
///
/// It is a range of triangles, made as they are asked for. To rays it is the loop over them, for few of them and for
/// tests; for many there is `bvh(mesh)`. A mesh is closed to rays if it is closed: triangles are exact, so that no ray
/// slips between two that share an edge. Of a closed one there is `contains` and `passages`.
///
/// What a vertex has beside its place is of no concern to rays, and is interpolated where one has hit.
template <real T>
struct mesh {
    using number = T;

    std::vector<vec3<T>> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<vec3<T>> normals = {};  ///< one for each vertex, or none at all; any length but zero
    std::vector<vec2<T>> uv = {};       ///< one for each vertex, or none at all

    std::size_t size() const { return triangles.size(); }
    triangle<T> operator[](std::size_t i) const {
        const auto& [a, b, c] = triangles[i];
        return {vertices[a], vertices[b], vertices[c]};
    }

    template <record Record>
    mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        if constexpr (!detail::keeps_t<Record, T>) {
            return detail::hit_in_between(*this, ray, t_min, t_max, rec);
        } else {
            return detail::hit_nearest(ray, t_min, t_max, rec, [&](auto visit) {
                for (std::size_t i = 0; i < size(); ++i) visit((*this)[i]);
            });
        }
    }

    mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        for (std::size_t i = 0; i < size(); ++i) {
            if ((*this)[i].occluded(ray, t_min, t_max)) return true;
        }
        return false;
    }

    /// All crossings, in order.
    std::vector<hit_record<T>> all_hits(const ray<T>& ray, T t_min, T t_max) const {
        std::vector<hit_record<T>> hits;
        for (std::size_t i = 0; i < size(); ++i) {
            hit_record<T> rec;
            if (!(*this)[i].hit(ray, t_min, t_max, rec)) continue;
            rec.index = static_cast<std::uint32_t>(i);
            hits.push_back(rec);
        }
        std::ranges::sort(hits, detail::comes_before<T>);
        return hits;
    }

    /// Vertices that no triangle has do not count.
    aabb<T> bounds() const {
        aabb<T> box;
        for (std::size_t i = 0; i < size(); ++i) box = hull(box, (*this)[i].bounds());
        return box;
    }

    /// \throws std::invalid_argument  for a triangle that has a vertex that there is not, named by its index, and for
    /// normals or uv that are not as many as the vertices
    void check() const {
        for (std::size_t i = 0; i < size(); ++i) {
            for (const std::uint32_t vertex : triangles[i]) {
                if (vertex >= vertices.size()) {
                    detail::fail(std::invalid_argument("raio::mesh: triangle " + std::to_string(i) + " has vertex " +
                                                       std::to_string(vertex) + " of " +
                                                       std::to_string(vertices.size())));
                }
            }
        }
        const auto fits = [&](std::size_t count) { return count == 0 || count == vertices.size(); };
        if (!fits(normals.size())) detail::fail(std::invalid_argument("raio::mesh: not as many normals as vertices"));
        if (!fits(uv.size())) detail::fail(std::invalid_argument("raio::mesh: not as many uv as vertices"));
    }

    /// The unit mean of the normals of the triangle's vertices where a ray has hit it, on the side that was hit; the
    /// triangle's own normal where there are none.
    vec3<T> normal_at(const hit_record<T>& rec) const {
        if (normals.empty()) return rec.normal;
        return normalize(mean_of(normals, rec)) * choose(rec.front_face, T(1), T(-1));
    }

    /// The mean of the uv of the triangle's vertices; where there are none, the triangle's own.
    vec2<T> uv_at(const hit_record<T>& rec) const { return uv.empty() ? rec.uv : mean_of(uv, rec); }

private:
    template <class V>
    V mean_of(const std::vector<V>& of, const hit_record<T>& rec) const {
        const auto& [a, b, c] = triangles[rec.index];
        return of[a] * (T(1) - rec.uv.x - rec.uv.y) + of[b] * rec.uv.x + of[c] * rec.uv.y;
    }
};

/// One triangle of a mesh, by its number; the mesh has to live longer. A tree of these, `bvh<mesh_triangle<T>>(mesh)`,
/// leaves the corners in the mesh: it takes less memory than one that has copied them, and more time.
template <real T>
struct mesh_triangle {
    using number = T;

    const mesh<T>* of;
    std::uint32_t index;

    template <record Record>
    mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return (*of)[index].hit(ray, t_min, t_max, rec);
    }
    mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const { return (*of)[index].occluded(ray, t_min, t_max); }
    aabb<T> bounds() const { return (*of)[index].bounds(); }

    template <class Line, class Wanted = every_crossing>
    auto crossings(const Line& line, const Wanted& wanted = {}) const {
        return (*of)[index].crossings(line, wanted);
    }
    template <class Point>
    void surface(Point& at) const {
        (*of)[index].surface(at);
    }

    /// Room for N triangles of the same mesh, whose corners are fetched as they are needed.
    template <std::size_t N>
    class lanes {
    public:
        void set(std::size_t lane, const mesh_triangle& shape) { of_ = shape.of, indices_[lane] = shape.index; }
        mesh_triangle get(std::size_t lane) const { return {of_, indices_[lane]}; }

        template <class Numbers = pack<T, N>>
        triangle<Numbers> shapes() const {
            std::array<std::array<T, N>, 9> numbers;
            for (std::size_t lane = 0; lane < N; ++lane) {
                const auto& corners = of_->triangles[indices_[lane]];
                for (std::size_t k = 0; k < 9; ++k) {
                    numbers[k][lane] = of_->vertices[corners[k / 3]][static_cast<int>(k % 3)];
                }
            }
            const auto corner = [&](std::size_t k) {
                return vec3<Numbers>(Numbers::load(numbers[k].data()), Numbers::load(numbers[k + 1].data()),
                                     Numbers::load(numbers[k + 2].data()));
            };
            return {corner(0), corner(3), corner(6)};
        }

    private:
        const mesh<T>* of_ = nullptr;
        std::array<std::uint32_t, N> indices_{};
    };
};

namespace detail {

/// The triangles of a mesh as shapes of P: by their numbers, or by corners a, b and c; and quick ones of these.
template <class P>
struct triangles_as {
    const mesh<number_t<P>>& of;

    std::size_t size() const { return of.size(); }
    P operator[](std::size_t i) const {
        if constexpr (requires { typename P::shape; }) {
            return {triangles_as<typename P::shape>{of}[i]};
        } else if constexpr (std::same_as<P, mesh_triangle<number_t<P>>>) {
            return {&of, static_cast<std::uint32_t>(i)};
        } else {
            const auto [a, b, c] = of[i];
            return {a, b, c};
        }
    }
};

}  // namespace detail

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
