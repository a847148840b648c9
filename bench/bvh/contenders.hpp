#pragma once

#include <raio/bvh/bvh.hpp>

#include <memory>
#include <vector>

#include "bvh/measure.hpp"
#include "bvh/scenes.hpp"
#ifdef RAIO_BENCH_EMBREE
#include "peers/embree.hpp"
#endif
#ifdef RAIO_BENCH_TINYBVH
#include "peers/tinybvh.hpp"
#endif

/// \file
/// Trees over the triangles of a mesh, each made when it is first asked for.

namespace bench {

using triangle = raio::triangle<float>;
using triangle_tree = raio::bvh<triangle>;

/// A mesh, and its triangles one by one.
struct lazy_mesh {
    lazy<bench::mesh> mesh;
    lazy<std::vector<triangle>> triangles;

    template <class Make>
    explicit lazy_mesh(Make make)
        : mesh([=] { return std::make_unique<bench::mesh>(make()); }),
          triangles([of = mesh] { return std::make_unique<std::vector<triangle>>(soup(*of)); }) {}
};

inline std::unique_ptr<triangle_tree> raio_tree(const std::vector<triangle>& triangles, raio::bvh_quality quality,
                                                unsigned threads = 1) {
    return std::make_unique<triangle_tree>(triangles, raio::bvh_options{.quality = quality, .threads = threads});
}

/// Leaves the corners of the triangles in the mesh.
using compact_tree = raio::bvh<raio::mesh_triangle<float>>;
inline std::unique_ptr<compact_tree> raio_compact_tree(const bench::mesh& of, unsigned threads = 1) {
    return std::make_unique<compact_tree>(of, raio::bvh_options{.threads = threads});
}

#ifdef RAIO_BENCH_EMBREE
/// Not built yet.
inline std::unique_ptr<peers::embree> embree_tree(const bench::mesh& of, const peers::embree_options& options) {
    auto tree = std::make_unique<peers::embree>(options);
    tree->add_triangles(of.vertices, of.triangles);
    return tree;
}
inline lazy<peers::embree> lazy_embree_tree(const lazy<bench::mesh>& of, const peers::embree_options& options) {
    return lazy([=] {
        auto tree = embree_tree(*of, options);
        tree->build();
        return tree;
    });
}

inline constexpr const char* embree_isas[] = {"", "avx2"};

/// What a contender is called in the results.
inline std::string name_with_isa(const std::string& name, const std::string& isa) {
    return isa.empty() ? name : name + '_' + isa;
}
#endif

#ifdef RAIO_BENCH_TINYBVH
inline lazy<peers::tinybvh> lazy_tinybvh(const lazy<bench::mesh>& of, bool high) {
    return lazy([=] {
        auto tree = std::make_unique<peers::tinybvh>();
        tree->add_triangles(of->vertices, of->triangles);
        tree->build(high);
        return tree;
    });
}
#endif

inline lazy<triangle_tree> lazy_raio_tree(const lazy<std::vector<triangle>>& of, raio::bvh_quality quality) {
    return lazy([=] { return raio_tree(*of, quality); });
}

/// The rays of a camera that `view` makes for the mesh.
template <class View>
lazy<std::vector<ray_set>> lazy_ray_sets(const lazy_mesh& of, const lazy<triangle_tree>& tree, View view) {
    return lazy([=] { return std::make_unique<std::vector<ray_set>>(ray_sets(view(*of.mesh), *tree)); });
}

}  // namespace bench
