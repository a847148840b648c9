#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <raio/bvh/gather.hpp>
#include <raio/compose/quick.hpp>

#include "peers/record.hpp"

/// \file
/// What every benchmark shares: the rays, the loop, and the names that the results go by.

namespace bench {

/// How many pairs of a shape and a ray one pass goes through: few enough for the cache. A power of two.
inline constexpr std::size_t trial_count = 1024;

/// The same numbers in every run and with every standard library, whose distributions differ.
class generator {
public:
    template <class T>
    T between(double low, double high) {
        const double unit = static_cast<double>(engine_() >> 11) * 0x1p-53;
        return static_cast<T>(low + (high - low) * unit);
    }

    /// A point of the cube about the origin whose side is 2 `half`.
    template <class T>
    raio::vec3<T> point(double half) {
        const T x = between<T>(-half, half), y = between<T>(-half, half);
        return {x, y, between<T>(-half, half)};
    }

    /// A unit vector, every direction as likely as any other.
    template <class T>
    raio::vec3<T> direction() {
        for (;;) {
            const raio::vec3<T> p = point<T>(1.0);
            if (raio::dot(p, p) > T(0.01) && raio::dot(p, p) < T(1)) return raio::normalize(p);
        }
    }

    std::size_t below(std::size_t end) { return engine_() % end; }

private:
    std::mt19937_64 engine_{20240607};
};

/// A ray, and whom it is put to.
template <class Asked, class T>
struct trial {
    Asked asked;
    raio::ray<T> ray;
};
template <class Shape>
using trials_of = std::vector<trial<Shape, raio::number_t<Shape>>>;

/// Shapes of about unit size near the origin, each with a ray of unit direction that comes from four units away and
/// passes within two. `hit_percent` of the rays hit, in an order that cannot be foreseen.
template <class Shape, class MakeShape>
trials_of<Shape> make_trials(MakeShape make_shape, std::size_t hit_percent) {
    using T = raio::number_t<Shape>;
    generator random;
    trials_of<Shape> trials;
    while (trials.size() < trial_count) {
        const bool wanted = trials.size() * 100 < trial_count * hit_percent;
        const raio::vec3<T> origin = random.direction<T>() * T(4), target = random.point<T>(1.5);
        trial<Shape, T> candidate{make_shape(random), {origin, raio::normalize(target - origin)}};
        const bool hits = candidate.asked.occluded(candidate.ray, T(0), raio::infinity<T>);
        if (hits == wanted) trials.push_back(std::move(candidate));
    }
    for (std::size_t i = trial_count - 1; i > 0; --i) std::swap(trials[i], trials[random.below(i + 1)]);
    return trials;
}

/// What is measured: a type with a `name`, made from the shape, that answers a ray. `result` is all that it finds out
/// beyond yes or no.
template <class Shape>
struct hit {
    static constexpr const char* name = "hit";
    using T = raio::number_t<Shape>;
    using result = raio::hit_record<T>;
    Shape shape;

    static auto ask(const Shape& shape, const raio::ray<T>& ray, T t_min, T t_max, result& rec) {
        return shape.hit(ray, t_min, t_max, rec);
    }
    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        return ask(shape, ray, t_min, t_max, rec);
    }
};

/// Does it fill any record? What calls a function that is known at run time only fills raio's own.
template <class Shape, class T = raio::number_t<Shape>>
concept fills_any_record = requires(const Shape& shape, const raio::ray<T>& ray, peers::record<T>& rec) {
    shape.hit(ray, T(0), T(1), rec);
};

/// The same, and of the hit what textbooks find.
template <class Shape>
struct record_hit {
    static constexpr const char* name = "record_hit";
    using T = raio::number_t<Shape>;
    using result = peers::record<T>;
    Shape shape;

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        return shape.hit(ray, t_min, t_max, rec);
    }
};

template <class Shape>
struct occluded {
    static constexpr const char* name = "occluded";
    using T = raio::number_t<Shape>;
    struct result {};
    Shape shape;

    static auto ask(const Shape& shape, const raio::ray<T>& ray, T t_min, T t_max, result&) {
        return shape.occluded(ray, t_min, t_max);
    }
    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& found) const {
        return ask(shape, ray, t_min, t_max, found);
    }
};

/// The shape's formula, believed, and the same record.
template <class Shape>
struct quick_hit {
    static constexpr const char* name = "quick_hit";
    using T = raio::number_t<Shape>;
    using result = peers::record<T>;
    raio::quick<Shape> shape;

    explicit quick_hit(const Shape& of) : shape{of} {}
    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        return shape.hit(ray, t_min, t_max, rec);
    }
};
template <class Shape>
struct quick_occluded {
    static constexpr const char* name = "quick_occluded";
    using T = raio::number_t<Shape>;
    struct result {};
    raio::quick<Shape> shape;

    explicit quick_occluded(const Shape& of) : shape{of} {}
    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result&) const {
        return shape.occluded(ray, t_min, t_max);
    }
};

/// What is said of every measurement: how long a test took, and whether it recorded a normal.
template <class Result>
void count_tests(benchmark::State& state) {
    const double tests = static_cast<double>(state.iterations()) * static_cast<double>(trial_count);
    using benchmark::Counter;
    state.SetItemsProcessed(static_cast<std::int64_t>(tests));
    state.counters["test"] = Counter(tests, Counter::kIsRate | Counter::kInvert);
    constexpr bool has_normal = requires(Result r) { r.normal; };
    state.counters["record"] = has_normal ? 1 : 0;
}

template <class Contender, class Shape>
void measure(benchmark::State& state, const trials_of<Shape>& trials) {
    using T = raio::number_t<Shape>;
    std::vector<trial<Contender, T>> own;
    for (const auto& [shape, ray] : trials) own.push_back({Contender{shape}, ray});

    volatile T from(0), to = raio::infinity<T>;
    const T t_min = from, t_max = to;  // not known when the call is compiled
    typename Contender::result result{};
    std::size_t hits = 0;
    for (const auto& [asked, ray] : own) hits += asked(ray, t_min, t_max, result) ? 1u : 0u;

    generator random;
    for (auto _ : state) {
        // Each pass goes in another order: one that came back would be learned by heart, by the branch predictor.
        const std::size_t stride = 2 * random.below(trial_count) + 1;
        for (std::size_t i = 0; i < trial_count; ++i) {
            const auto& [asked, ray] = own[i * stride % trial_count];
            const bool answer = asked(ray, t_min, t_max, result);
            benchmark::DoNotOptimize(answer);
            // Written to memory, not only computed. As a constant: g++ may lose the value of what this could have
            // changed.
            benchmark::DoNotOptimize(std::as_const(result));
        }
    }
    count_tests<decltype(result)>(state);
    state.counters["hits"] = 100.0 * static_cast<double>(hits) / static_cast<double>(trial_count);
}

/// The same calls, with as many of the pairs at a time as registers have lanes.
template <class Shape>
class packs_of_trials {
public:
    using T = raio::number_t<Shape>;
    using P = raio::pack<T>;
    using packed = raio::detail::rebind_t<Shape, P>;
    static constexpr std::size_t count = trial_count / P::lanes;

    explicit packs_of_trials(const trials_of<Shape>& trials) : packs_(count) {
        for (std::size_t i = 0; i < trial_count; ++i) {
            trial<raio::detail::gathered_numbers<Shape, P::lanes>, P>& to = packs_[i / P::lanes];
            to.asked.set(i % P::lanes, trials[i].asked);
            raio::detail::set_lane(to.ray.origin, i % P::lanes, trials[i].ray.origin);
            raio::detail::set_lane(to.ray.direction, i % P::lanes, trials[i].ray.direction);
        }
    }

    const packed& shapes(std::size_t i) const { return packs_[i].asked.shapes(); }
    const raio::ray<P>& rays(std::size_t i) const { return packs_[i].ray; }

private:
    std::vector<trial<raio::detail::gathered_numbers<Shape, P::lanes>, P>> packs_;
};

/// \tparam Call  `hit` or `occluded`
template <template <class> class Call, class Shape>
void measure_packs(benchmark::State& state, const trials_of<Shape>& trials) {
    using packs = packs_of_trials<Shape>;
    using T = typename packs::T;
    using P = typename packs::P;
    const packs own(trials);
    volatile T from(0), to = raio::infinity<T>;
    const P t_min(from), t_max(to);
    typename Call<typename packs::packed>::result result{};
    generator random;
    for (auto _ : state) {
        const std::size_t stride = 2 * random.below(packs::count) + 1;
        for (std::size_t i = 0; i < packs::count; ++i) {
            const std::size_t at = i * stride % packs::count;
            const auto answer = Call<typename packs::packed>::ask(own.shapes(at), own.rays(at), t_min, t_max, result);
            benchmark::DoNotOptimize(answer);
            benchmark::DoNotOptimize(std::as_const(result));
        }
    }
    count_tests<decltype(result)>(state);
    state.counters["lanes"] = static_cast<double>(P::lanes);
}

template <class T>
inline constexpr const char* number_name = "float";
template <>
inline constexpr const char* number_name<double> = "double";

/// Registers SHAPE/CALL/NUMBER/PERCENT for the shape's own two calls, for `hit` into a textbook's record, for the same
/// of the quick shape, and in packs if there is a shape of packs, and for each of the peers, at 0, 50 and 100 % hits.
template <class Shape, class... Peers, class MakeShape>
void add(const std::string& shape_name, MakeShape make_shape) {
    for (const std::size_t hit_percent : {0u, 50u, 100u}) {
        const auto trials = make_trials<Shape>(make_shape, hit_percent);
        const auto add_as = [&](const std::string& call, auto measured) {
            const std::string name =
                shape_name + '/' + call + '/' + number_name<raio::number_t<Shape>> + '/' + std::to_string(hit_percent);
            benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { measured(state, trials); });
        };
        const auto add_one = [&]<class Contender>(std::type_identity<Contender>) {
            add_as(Contender::name, measure<Contender, Shape>);
        };
        add_one(std::type_identity<hit<Shape>>{});
        if constexpr (fills_any_record<Shape>) {
            add_one(std::type_identity<record_hit<Shape>>{});
        }
        add_one(std::type_identity<occluded<Shape>>{});
        if constexpr (raio::detail::has_plain_formula<Shape>) {
            add_one(std::type_identity<quick_hit<Shape>>{});
            add_one(std::type_identity<quick_occluded<Shape>>{});
        }
        if constexpr (raio::detail::gatherable_as<Shape, raio::pack<raio::number_t<Shape>>>) {
            add_as("hit_in_packs", measure_packs<hit, Shape>);
            add_as("occluded_in_packs", measure_packs<occluded, Shape>);
        }
        (add_one(std::type_identity<Peers>{}), ...);
    }
}

/// The rest of `main`.
inline int run(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}

}  // namespace bench
