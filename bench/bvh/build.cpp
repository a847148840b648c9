#include "bvh/contenders.hpp"

// How long a tree over a million triangles takes to build, and how large it is. THREADS/CONTENDER is one measurement.

namespace {

/// Measures `make(state)`, which returns the tree that it has built.
template <class Make>
void add(unsigned threads, const std::string& contender, const bench::lazy_mesh& mesh, Make make) {
    const auto measure = [=](benchmark::State& state) {
        const auto count = mesh.triangles->size();
        std::int64_t bytes = 0;
        for (auto _ : state) bytes = static_cast<std::int64_t>(make(state)->bytes());
        state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
        state.counters["bytes"] = static_cast<double>(bytes) / static_cast<double>(count);
    };
    benchmark::RegisterBenchmark((std::to_string(threads) + '/' + contender).c_str(), measure)
        ->Iterations(1)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
    const bench::lazy_mesh mesh([] { return bench::bumpy_sphere(1'000'000); });
    for (const unsigned threads : {1u, 2u}) {
        const auto add_raio = [&](const char* name, raio::bvh_quality quality) {
            add(threads, name, mesh,
                [=](benchmark::State&) { return bench::raio_tree(*mesh.triangles, quality, threads); });
        };
        add_raio("raio_low", raio::bvh_quality::low);
        add_raio("raio", raio::bvh_quality::standard);
        add_raio("raio_high", raio::bvh_quality::high);
        add(threads, "raio_compact", mesh,
            [=](benchmark::State&) { return bench::raio_compact_tree(*mesh.mesh, threads); });
#ifdef RAIO_BENCH_EMBREE
        for (const char* isa : bench::embree_isas) {
            const auto add_embree = [&](const char* name, RTCBuildQuality quality) {
                add(threads, bench::name_with_isa(name, isa), mesh, [=](benchmark::State& state) {
                    state.PauseTiming();
                    auto tree = bench::embree_tree(*mesh.mesh, {.isa = isa, .quality = quality, .threads = threads});
                    state.ResumeTiming();
                    tree->build();
                    return tree;
                });
            };
            add_embree("embree_low", RTC_BUILD_QUALITY_LOW);
            add_embree("embree", RTC_BUILD_QUALITY_MEDIUM);
            add_embree("embree_high", RTC_BUILD_QUALITY_HIGH);
        }
#endif
    }
    return bench::run(argc, argv);
}
