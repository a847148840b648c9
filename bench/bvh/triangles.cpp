#include <algorithm>
#include <array>
#include <bit>
#include <span>

#include "bvh/contenders.hpp"

// Triangles: SCENE/RAYS/CONTENDER is one measurement.

namespace {

constexpr std::size_t square = bench::square_side * bench::square_side;

template <class Tree>
std::size_t hits_of_square(const Tree& tree, std::span<const raio::ray<float>, square> rays, float t_max) {
    std::array<raio::hit_record<float>, square> recs;
    const std::uint64_t hits = tree.hit(rays, 0, t_max, recs);
    benchmark::DoNotOptimize(std::as_const(recs));
    return static_cast<std::size_t>(std::popcount(hits));
}

#ifdef RAIO_BENCH_EMBREE
constexpr std::size_t quarter = bench::quarter_side * bench::quarter_side;

std::size_t hits_of_embree(const peers::embree& tree, std::span<const raio::ray<float>, quarter> rays, float t_max) {
    RTCRayHit16 recs;
    tree.hit_coherent(rays, 0, t_max, recs);
    benchmark::DoNotOptimize(std::as_const(recs));
    return quarter - static_cast<std::size_t>(std::ranges::count(recs.hit.geomID, RTC_INVALID_GEOMETRY_ID));
}
#endif

void add(const bench::scene& scene) {
    using raio::bvh_quality;
    const bench::lazy_mesh mesh(scene.mesh);
    const auto standard = bench::lazy_raio_tree(mesh.triangles, bvh_quality::standard);
    const auto rays = bench::lazy_ray_sets(mesh, standard, scene.camera);
    const auto add_raio = [&](const char* name, const auto& tree) {
        bench::add_tree<raio::hit_record<float>>(scene.name, name, tree, rays);
    };
    add_raio("raio", standard);
    bench::add_packets<square>(scene.name, "raio", standard, rays, hits_of_square<bench::triangle_tree>);
    add_raio("raio_high", bench::lazy_raio_tree(mesh.triangles, bvh_quality::high));
    add_raio("raio_compact", bench::lazy([of = mesh.mesh] { return bench::raio_compact_tree(*of); }));
    struct seen {
        float t;
        raio::vec2<float> uv;
        raio::vec3<float> normal;
        std::uint32_t index;
    };
    using quick_tree = raio::bvh<raio::quick<raio::triangle<float>>>;
    const bench::lazy quick(
        [of = mesh.mesh] { return std::make_unique<quick_tree>(*of, raio::bvh_options{.threads = 1}); });
    bench::add_tree<seen>(scene.name, "quick", quick, rays);
    bench::add_packets<square>(scene.name, "quick", quick, rays, hits_of_square<quick_tree>);
#ifdef RAIO_BENCH_EMBREE
    for (const char* isa : bench::embree_isas) {
        const auto add_embree = [&](const char* name, const peers::embree_options& options) {
            bench::add_tree<RTCRayHit>(scene.name, bench::name_with_isa(name, isa),
                                       bench::lazy_embree_tree(mesh.mesh, options), rays);
        };
        add_embree("embree", {.isa = isa});
        bench::add_packets<quarter>(scene.name, bench::name_with_isa("embree", isa),
                                    bench::lazy_embree_tree(mesh.mesh, {.isa = isa}), rays, hits_of_embree);
        add_embree("embree_high", {.isa = isa, .quality = RTC_BUILD_QUALITY_HIGH});
        add_embree("embree_robust", {.isa = isa, .robust = true});
    }
#endif
#ifdef RAIO_BENCH_TINYBVH
    const auto add_tinybvh = [&](const char* name, bool high) {
        bench::add_tree<peers::tinybvh::record>(scene.name, name, bench::lazy_tinybvh(mesh.mesh, high), rays);
    };
    add_tinybvh("tinybvh", false);
    add_tinybvh("tinybvh_high", true);
#endif
}

}  // namespace

int main(int argc, char** argv) {
    for (const bench::scene& scene : bench::scenes()) add(scene);
    return bench::run(argc, argv);
}
