#include <raio/number/simd.hpp>

#include <array>

#include <raio/raio.hpp>

#include "peers/by_hand.hpp"
#include "peers/glm.hpp"
#include "peers/moeller_trumbore.hpp"
#include "peers/slabs.hpp"
#include "support.hpp"

/// \file
/// One ray against many shapes, which stay in cache: which is the nearest, and where? The shapes' own source in packs,
/// beside kernels that were written by hand, beside one shape at a time.

namespace {

inline constexpr std::size_t shape_count = 4096, ray_count = 64;

template <class Shape>
struct scene {
    std::vector<Shape> shapes;
    std::vector<raio::ray<float>> rays;
    double hits = 0;  ///< how many of all the tests are hits
};

/// Unit rays from four units away that pass the origin at a distance at which half of the tests are hits.
template <class Shape, class MakeShape>
scene<Shape> make_scene(MakeShape make_shape) {
    scene<Shape> made;
    bench::generator random;
    while (made.shapes.size() < shape_count) made.shapes.push_back(make_shape(random));
    double low = 0, high = 4;
    for (int step = 0; step < 12; ++step) {
        const double aside = (low + high) / 2;
        bench::generator same;
        made.rays.clear();
        std::size_t hits = 0;
        while (made.rays.size() < ray_count) {
            const raio::vec3<float> from = same.direction<float>() * 4.0f, target = same.point<float>(aside);
            made.rays.push_back({from, raio::normalize(target - from)});
            for (const Shape& shape : made.shapes) hits += shape.occluded(made.rays.back(), 0, raio::infinity<float>);
        }
        made.hits = double(hits) / double(ray_count * shape_count);
        (made.hits > 0.5 ? low : high) = aside;
    }
    return made;
}

/// Shapes side by side as they stand in a pack of them: all first numbers, all second numbers and so on.
template <class Shape>
std::vector<float> side_by_side(const std::vector<Shape>& shapes, std::size_t lanes) {
    constexpr std::size_t numbers = sizeof(Shape) / sizeof(float);
    std::vector<float> memory(shapes.size() * numbers);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        std::array<float, numbers> own;
        std::memcpy(own.data(), &shapes[i], sizeof(Shape));
        for (std::size_t n = 0; n < numbers; ++n) memory[(i / lanes * numbers + n) * lanes + i % lanes] = own[n];
    }
    return memory;
}

struct nearest {
    float t = raio::infinity<float>;
    std::size_t index = 0;

    void consider(float other_t, std::size_t other_index) {
        if (other_t < t) *this = {other_t, other_index};
    }
};

/// The shape's own source, N of them at a time.
template <template <class> class Shape, std::size_t N>
struct packed {
    using P = raio::pack<float, N>;
    std::vector<Shape<P>> shapes;

    explicit packed(const std::vector<Shape<float>>& plain) : shapes(plain.size() / N) {
        std::memcpy(static_cast<void*>(shapes.data()), side_by_side(plain, N).data(), plain.size() * sizeof(plain[0]));
    }

    nearest operator()(const raio::ray<float>& r, float t_min) const {
        raio::ray<P> ray{raio::vec3<P>(r.origin), raio::vec3<P>(r.direction)};
        const P first(t_min);
        P best(raio::infinity<P>);
        raio::index_t<P> block(0), best_block(0);
        for (const Shape<P>& shape : shapes) {
            auto c = shape.crossings(line_in<P>(ray));
            P t;
            raio::mask_t<P> hit;
            if constexpr (requires { c.near; }) {
                t = select(first <= c.near.t, c.near.t, c.far.t);
                hit = c.near.exists;
            } else {
                t = c.t;
                hit = c.exists;
            }
            raio::mask_t<P> nearer = raio::every(hit, first <= t, t < best);
            best = select(nearer, t, best);
            best_block = select(nearer, block, best_block);
            block += 1;
        }
        nearest found;
        for (std::size_t lane = 0; lane < N; ++lane) found.consider(best[lane], best_block[lane] * N + lane);
        return found;
    }
};

/// The same by hand.
template <template <class> class Kernel, class I, class Shape>
struct by_hand {
    std::vector<float> shapes;

    explicit by_hand(const std::vector<Shape>& plain) : shapes(side_by_side(plain, I::lanes)) {}

    nearest operator()(const raio::ray<float>& ray, float t_min) const {
        constexpr std::size_t stride = sizeof(Shape) / sizeof(float) * I::lanes;
        const Kernel<I> kernel(ray);
        const auto first = I::all(t_min);
        auto best = I::all(raio::infinity<float>), block = I::all(0), best_block = block;
        for (std::size_t at = 0; at < shapes.size(); at += stride) {
            const auto [hit, t] = kernel(shapes.data() + at, first);
            const auto nearer = I::both(hit, I::less_equal(t, best));
            best = I::select(nearer, t, best);
            best_block = I::select(nearer, block, best_block);
            block = I::add(block, I::all(1));
        }
        std::array<float, I::lanes> t, blocks;
        I::store(t.data(), best), I::store(blocks.data(), best_block);
        nearest found;
        for (std::size_t lane = 0; lane < I::lanes; ++lane)
            found.consider(t[lane], static_cast<std::size_t>(blocks[lane]) * I::lanes + lane);
        return found;
    }
};

/// One shape after the other, by whatever answers a ray and leaves t in its result.
template <class Contender>
struct one_by_one {
    std::vector<Contender> shapes;

    template <class Shape>
    explicit one_by_one(const std::vector<Shape>& plain) {
        for (const Shape& shape : plain) shapes.push_back(Contender{shape});
    }

    nearest operator()(const raio::ray<float>& ray, float t_min) const {
        nearest found;
        typename Contender::result result{};
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            const bool hit = shapes[i](ray, t_min, raio::infinity<float>, result);
            if constexpr (requires { result.t; }) {
                if (hit) found.consider(result.t, i);
            } else {
                found.index += hit;  // how many, where t is not asked for
            }
        }
        return found;
    }
};

template <class Contender, class Shape>
void add(const std::string& name, const scene<Shape>& made) {
    const auto measure = [made](benchmark::State& state) {
        const Contender contender(made.shapes);
        volatile float from = 0;
        std::size_t next = 0;
        for (auto _ : state) benchmark::DoNotOptimize(contender(made.rays[next++ % ray_count], from));
        const double tests = static_cast<double>(state.iterations()) * double(shape_count);
        state.counters["test"] = benchmark::Counter(tests, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
        state.counters["hits"] = 100 * made.hits;
    };
    benchmark::RegisterBenchmark(name.c_str(), measure);
}

template <template <class> class Shape, template <class> class Kernel, class Peer, class MakeShape>
void add_all(const std::string& name, MakeShape make_shape) {
    const auto made = make_scene<Shape<float>>(make_shape);
    const std::string path = "simd/" + name;
#if defined(__AVX512F__)
    add<packed<Shape, 16>>(path + "/pack/16", made);
    add<by_hand<Kernel, peers::avx512, Shape<float>>>(path + "/by_hand/16", made);
#endif
#if defined(__AVX2__) && defined(__FMA__)
    add<packed<Shape, 8>>(path + "/pack/8", made);
    add<by_hand<Kernel, peers::avx2, Shape<float>>>(path + "/by_hand/8", made);
#endif
    add<packed<Shape, 4>>(path + "/pack/4", made);
    add<one_by_one<Peer>>(path + '/' + Peer::name + "/1", made);
    add<one_by_one<bench::hit<Shape<float>>>>(path + "/hit/1", made);
    add<one_by_one<bench::occluded<Shape<float>>>>(path + "/occluded/1", made);
}

}  // namespace

int main(int argc, char** argv) {
    using bench::generator;
    add_all<raio::sphere, peers::sphere_by_hand, peers::glm_sphere<float>>("sphere", [](generator& random) {
        const auto center = random.point<float>(0.5);
        return raio::sphere<float>{center, random.between<float>(0.5, 1.0)};
    });
    add_all<raio::plane, peers::plane_by_hand, peers::glm_plane<float>>("plane", [](generator& random) {
        const auto point = random.point<float>(0.5);
        return raio::plane<float>{point * 8.0f, random.direction<float>()};
    });
    add_all<raio::triangle, peers::triangle_by_hand, peers::moeller_trumbore<float>>("triangle", [](generator& random) {
        const auto a = random.point<float>(1.5), b = random.point<float>(1.5), c = random.point<float>(0.5);
        return raio::triangle<float>{a, b, c - a - b};
    });
    add_all<raio::box, peers::box_by_hand, peers::slabs<float>>("box", [](generator& random) {
        const auto center = random.point<float>(0.5);
        const raio::vec3<float> half(random.between<float>(0.3, 1), random.between<float>(0.3, 1),
                                     random.between<float>(0.3, 1));
        return raio::box<float>{center - half, center + half};
    });
    return bench::run(argc, argv);
}
