#include "bvh/contenders.hpp"

// How cost grows from a thousand triangles to ten million: TRIANGLES/RAYS/CONTENDER, and TRIANGLES/build/CONTENDER on
// one thread.

namespace {

template <class Make>
void add_build(const std::string& scene, const std::string& contender, const bench::lazy_mesh& mesh, Make make) {
    const auto measure = [=](benchmark::State& state) {
        const auto count = static_cast<std::int64_t>(mesh.triangles->size());
        for (auto _ : state) benchmark::DoNotOptimize(make());
        state.SetItemsProcessed(state.iterations() * count);
    };
    benchmark::RegisterBenchmark((scene + "/build/" + contender).c_str(), measure)->Unit(benchmark::kMillisecond);
}

void add(std::size_t triangle_count) {
    const std::string scene = std::to_string(triangle_count);
    const bench::lazy_mesh mesh([=] { return bench::bumpy_sphere(triangle_count); });
    const auto tree = bench::lazy_raio_tree(mesh.triangles, raio::bvh_quality::standard);
    const auto rays = bench::lazy_ray_sets(mesh, tree, [](const bench::mesh& seen) {
        return bench::filled_with(seen.vertices, {1, 0.6f, 2});
    });
    bench::add_tree<raio::hit_record<float>>(scene, "raio", tree, rays);
    add_build(scene, "raio", mesh, [=] { return bench::raio_tree(*mesh.triangles, raio::bvh_quality::standard); });
#ifdef RAIO_BENCH_EMBREE
    constexpr peers::embree_options options{.isa = "avx2"};
    bench::add_tree<RTCRayHit>(scene, "embree_avx2", bench::lazy_embree_tree(mesh.mesh, options), rays);
    add_build(scene, "embree_avx2", mesh, [=] {
        auto built = bench::embree_tree(*mesh.mesh, options);
        built->build();
        return built;
    });
#endif
}

}  // namespace

int main(int argc, char** argv) {
    for (std::size_t count = 1000; count <= 10'000'000; count *= 10) add(count);
    return bench::run(argc, argv);
}
