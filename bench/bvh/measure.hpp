#pragma once

#include <benchmark/benchmark.h>

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bvh/rays.hpp"

/// \file
/// How trees are measured: with all rays of a set, one after the other, on one thread.

namespace bench {

/// Something that is made when it is first asked for, so that a run makes only what its filter selects. Copies share
/// it.
template <class Value>
class lazy {
public:
    template <class Make>
    explicit lazy(Make make) : state_(std::make_shared<state>(state{std::move(make), nullptr})) {}

    const Value& operator*() const {
        if (!state_->value) state_->value = state_->make();
        return *state_->value;
    }
    const Value* operator->() const { return &**this; }

private:
    struct state {
        std::function<std::unique_ptr<Value>()> make;
        std::unique_ptr<Value> value;
    };
    std::shared_ptr<state> state_;
};
template <class Make>
lazy(Make) -> lazy<typename std::invoke_result_t<Make>::element_type>;

/// Asks the tree about every ray of the set; `Record` is what it fills.
template <class Record, class Tree>
void trace(benchmark::State& state, const Tree& tree, const ray_set& set) {
    std::size_t hits = 0;
    for (auto _ : state) {
        hits = 0;
        for (const auto& ray : set.rays) {
            if (set.any) {
                hits += tree.occluded(ray, 0, set.t_max) ? 1u : 0u;
            } else {
                Record rec;
                hits += tree.hit(ray, 0, set.t_max, rec) ? 1u : 0u;
                benchmark::DoNotOptimize(std::as_const(rec));
            }
        }
        benchmark::DoNotOptimize(hits);
    }
    const auto count = static_cast<std::int64_t>(set.rays.size());
    state.SetItemsProcessed(state.iterations() * count);
    state.counters["hits"] = 100.0 * static_cast<double>(hits) / static_cast<double>(count);
}

inline constexpr std::array ray_kinds{"primary", "bounce", "shuffled", "occlusion"};

/// Registers SCENE/RAYS/CONTENDER for every kind of rays. One pass through all rays is one repetition.
template <class Record, class Tree>
void add_tree(const std::string& scene, const std::string& contender, const lazy<Tree>& tree,
              const lazy<std::vector<ray_set>>& rays) {
    for (std::size_t kind = 0; kind < ray_kinds.size(); ++kind) {
        const std::string name = scene + '/' + ray_kinds[kind] + '/' + contender;
        benchmark::RegisterBenchmark(name.c_str(),
                                     [=](benchmark::State& state) { trace<Record>(state, *tree, (*rays)[kind]); })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    }
}

/// Registers SCENE/packets/CONTENDER: the rays of a picture, so many at a time.
/// \param ask  answers with how many of these rays hit, given the tree, the rays and where they end
template <std::size_t Count, class Tree, class Ask>
void add_packets(const std::string& scene, const std::string& contender, const lazy<Tree>& tree,
                 const lazy<std::vector<ray_set>>& rays, Ask ask) {
    const auto trace_packets = [=](benchmark::State& state) {
        const ray_set& set = (*rays)[ray_kinds.size()];
        const Tree& asked = *tree;  // which is made before the time counts
        for (auto _ : state) {
            std::size_t hits = 0;
            for (std::size_t i = 0; i < set.rays.size(); i += Count) {
                hits += ask(asked, std::span<const raio::ray<float>, Count>(&set.rays[i], Count), set.t_max);
            }
            benchmark::DoNotOptimize(hits);
        }
        state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(set.rays.size()));
    };
    benchmark::RegisterBenchmark((scene + "/packets/" + contender).c_str(), trace_packets)
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
}

}  // namespace bench
