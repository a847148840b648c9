#include <raio/compose/quick.hpp>

#include <memory>

#include <raio/shape/sphere.hpp>

#include "peers/one_weekend.hpp"
#include "support.hpp"

namespace {

/// Many spheres behind a virtual call, as in *One Weekend*, and the nearest of those that a ray hits. The rays bounce:
/// they start on one of the spheres. Nearly all of the others are missed, one is five thousand times as large as the
/// rest, and the window shrinks with each that is hit.
template <class T>
struct spheres {
    std::vector<raio::sphere<T>> all;
    std::vector<raio::ray<T>> rays;

    spheres() {
        bench::generator random;
        all.push_back({{0, -1000, 0}, 1000});
        for (int x = -11; x < 11; ++x) {
            for (int z = -11; z < 11; ++z) {
                const T dx = random.between<T>(0, 0.9), dz = random.between<T>(0, 0.9);
                all.push_back({{T(x) + dx, T(0.2), T(z) + dz}, T(0.2)});
            }
        }
        while (rays.size() < 1024) {
            const raio::sphere<T>& from = all[random.below(all.size())];
            const auto [point, normal] = from.sample({random.between<T>(0, 1), random.between<T>(0, 1)});
            if (point.y < 0 || raio::length(point) > 15) continue;
            rays.push_back({point, normal + random.direction<T>()});
        }
    }
};

template <class T>
struct surface {
    virtual ~surface() = default;
    virtual bool hit(const raio::ray<T>& ray, T t_min, T t_max, peers::record<T>& rec) const = 0;
};

template <class T, class Shape>
struct as_surface final : surface<T> {
    Shape shape;

    explicit as_surface(const raio::sphere<T>& of) : shape{of} {}
    bool hit(const raio::ray<T>& ray, T t_min, T t_max, peers::record<T>& rec) const final {
        if constexpr (requires { shape.hit(ray, t_min, t_max, rec); }) {
            return shape.hit(ray, t_min, t_max, rec);
        } else {
            return shape(ray, t_min, t_max, rec);
        }
    }
};

template <class T, class Shape>
void add(const char* name) {
    const std::string full = std::string("bouncing_list/") + name + '/' + bench::number_name<T> + "/5";
    benchmark::RegisterBenchmark(full.c_str(), [](benchmark::State& state) {
        const spheres<T> scene;
        std::vector<std::unique_ptr<surface<T>>> list;
        for (const raio::sphere<T>& s : scene.all) list.push_back(std::make_unique<as_surface<T, Shape>>(s));
        for (auto _ : state) {
            for (const raio::ray<T>& ray : scene.rays) {
                peers::record<T> nearest{}, rec;
                T far = raio::infinity<T>;
                for (const auto& one : list) {
                    if (one->hit(ray, T(0.001), far, rec)) far = rec.t, nearest = rec;
                }
                benchmark::DoNotOptimize(std::as_const(nearest));
            }
        }
        const double tests = double(state.iterations()) * double(scene.rays.size() * list.size());
        using benchmark::Counter;
        state.counters["test"] = Counter(tests, Counter::kIsRate | Counter::kInvert);
        state.counters["record"] = 1;
    });
}

template <class T>
void add_all() {
    add<T, raio::sphere<T>>("record_hit");
    add<T, raio::quick<raio::sphere<T>>>("quick_hit");
    add<T, peers::one_weekend_sphere<T>>("one_weekend");
}

}  // namespace

int main(int argc, char** argv) {
    add_all<float>();
    add_all<double>();
    return bench::run(argc, argv);
}
