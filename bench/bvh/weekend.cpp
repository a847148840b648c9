#include <raio/bvh/bvh.hpp>
#include <raio/shape/sphere.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bvh/measure.hpp"
#include "peers/one_weekend_bvh.hpp"

// The final scene of Ray Tracing in One Weekend (Shirley, Black and Hollasch), 400 x 225, depth 20: one path-tracing
// loop on the book's list, on its sequel's tree, on both with raio's spheres in the place of the book's, and on raio's
// tree. weekend/NUMBER/CONTENDER is one measurement, in rays.

namespace {

template <class T>
using vec3 = raio::vec3<T>;

/// A stream of random numbers: splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
class random_numbers {
public:
    explicit random_numbers(std::uint64_t seed) : state_(seed) {}

    template <class T>
    T next() {
        state_ += 0x9e3779b97f4a7c15;
        std::uint64_t z = (state_ ^ (state_ >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return static_cast<T>((z ^ (z >> 31)) >> 40) * T(0x1p-24);
    }
    template <class T>
    T between(T low, T high) {
        return low + (high - low) * next<T>();
    }
    template <class T>
    vec3<T> color(T low, T high) {
        const T r = between(low, high), g = between(low, high);
        return {r, g, between(low, high)};
    }
    template <class T>
    vec3<T> unit_vector() {
        for (;;) {
            const vec3<T> p = color<T>(-1, 1);
            const T length2 = raio::dot(p, p);
            if (length2 <= 1 && length2 > T(1e-20)) return p / std::sqrt(length2);
        }
    }

private:
    std::uint64_t state_;
};

template <class T>
struct material {
    enum { matte, metal, glass } kind;
    vec3<T> albedo;
    T fuzz_or_index;

    /// The direction in which light goes on, unless it is swallowed. `incoming` and `normal` are unit, the normal
    /// against it.
    std::optional<vec3<T>> scatter(const vec3<T>& incoming, const vec3<T>& normal, bool front_face,
                                   random_numbers& random) const {
        if (kind == matte) {
            const vec3<T> direction = normal + random.unit_vector<T>();
            return raio::dot(direction, direction) < T(1e-12) ? normal : direction;
        }
        const T cosine = -raio::dot(incoming, normal);
        const vec3<T> reflected = incoming + normal * (2 * cosine);
        if (kind == metal) {
            const vec3<T> direction = reflected + random.unit_vector<T>() * fuzz_or_index;
            if (raio::dot(direction, normal) > 0) return direction;
            return {};
        }
        const T ratio = front_face ? 1 / fuzz_or_index : fuzz_or_index, sine2 = ratio * ratio * (1 - cosine * cosine);
        if (sine2 > 1) return reflected;
        const T r0 = (1 - ratio) / (1 + ratio), x = 1 - cosine;
        const T schlick = r0 * r0 + (1 - r0 * r0) * (x * x * x * x * x);
        if (schlick > random.next<T>()) return reflected;
        return (incoming + normal * cosine) * ratio - normal * std::sqrt(1 - sine2);
    }
};

template <class T>
struct ball {
    raio::sphere<T> shape;
    material<T> made_of;
};

template <class T>
std::vector<ball<T>> final_scene() {
    using kinds = material<T>;
    random_numbers random(1);
    std::vector<ball<T>> balls{{{{0, -1000, 0}, 1000}, {kinds::matte, vec3<T>(T(0.5)), 0}},
                               {{{0, 1, 0}, 1}, {kinds::glass, vec3<T>(1), T(1.5)}},
                               {{{-4, 1, 0}, 1}, {kinds::matte, {T(0.4), T(0.2), T(0.1)}, 0}},
                               {{{4, 1, 0}, 1}, {kinds::metal, {T(0.7), T(0.6), T(0.5)}, 0}}};
    for (int a = -11; a < 11; ++a) {
        for (int b = -11; b < 11; ++b) {
            const T choice = random.next<T>(), x = T(a) + T(0.9) * random.next<T>();
            const vec3<T> center(x, T(0.2), T(b) + T(0.9) * random.next<T>());
            if (raio::length(vec3<T>(center - vec3<T>(4, T(0.2), 0))) <= T(0.9)) continue;
            const auto add = [&](const kinds& m) { balls.push_back({{center, T(0.2)}, m}); };
            if (choice < T(0.8)) {
                const vec3<T> once = random.color<T>(0, 1);
                add({kinds::matte, once * random.color<T>(0, 1), 0});
            } else if (choice < T(0.95)) {
                const vec3<T> albedo = random.color<T>(T(0.5), 1);
                add({kinds::metal, albedo, random.between<T>(0, T(0.5))});
            } else {
                add({kinds::glass, vec3<T>(1), T(1.5)});
            }
        }
    }
    return balls;
}

template <class T>
using hittable = peers::one_weekend::hittable<T, material<T>>;

/// A shape of raio's in the place of one of the book's: the first step of moving a program over.
/// \tparam Shape  an exact sphere or a quick one
template <class Shape>
class raio_object final : public hittable<raio::number_t<Shape>> {
public:
    using T = raio::number_t<Shape>;
    using typename hittable<T>::hit_record;

    raio_object(const raio::sphere<T>& shape, std::shared_ptr<const material<T>> made_of)
        : shape_{shape}, material_(std::move(made_of)) {}

    bool hit(const raio::ray<T>& ray, T t_min, T t_max, hit_record& rec) const override {
        if (!shape_.hit(ray, t_min, t_max, rec)) return false;
        rec.material = material_;
        return true;
    }
    raio::aabb<T> bounding_box() const override { return shape_.bounds(); }

private:
    Shape shape_;
    std::shared_ptr<const material<T>> material_;
};

/// The book's worlds. Its rays start a thousandth away from where they were scattered.
/// \tparam World   a list or a tree of pointers to objects
/// \tparam Object  what the spheres are
template <class World, class Object>
struct of_the_book {
    using record = typename World::hit_record;
    using T = decltype(record::t);
    std::shared_ptr<const World> world;

    of_the_book() {
        peers::one_weekend::objects<T, material<T>> objects;
        for (const auto& [shape, made_of] : final_scene<T>()) {
            objects.push_back(std::make_shared<Object>(shape, std::make_shared<const material<T>>(made_of)));
        }
        world = std::make_shared<const World>(std::move(objects));
    }
    bool hit(const raio::ray<T>& ray, record& rec) const { return world->hit(ray, T(0.001), raio::infinity<T>, rec); }
    const material<T>& material_at(const record& rec) const { return *rec.material; }
    static raio::ray<T> leave(const record& rec, const vec3<T>& direction) { return {rec.point, direction}; }
};

/// raio's tree, and materials by number. Rays start as near to where they were scattered as the bound of that allows.
template <class Sphere>
struct of_raio {
    using T = raio::number_t<Sphere>;
    struct record {  // what the book's has, and what rays leave by
        T t;
        vec3<T> point, normal, error;
        std::uint32_t index;
        bool front_face;
    };
    std::vector<material<T>> materials;
    raio::bvh<Sphere> world;

    of_raio() {
        std::vector<Sphere> spheres;
        for (const auto& [shape, made_of] : final_scene<T>()) {
            spheres.push_back(Sphere{shape});
            materials.push_back(made_of);
        }
        world = raio::bvh<Sphere>(spheres, raio::bvh_options{.quality = raio::bvh_quality::high});
    }
    bool hit(const raio::ray<T>& ray, record& rec) const { return world.hit(ray, 0, raio::infinity<T>, rec); }
    const material<T>& material_at(const record& rec) const { return materials[rec.index]; }
    static raio::ray<T> leave(const record& rec, const vec3<T>& direction) { return raio::spawn_ray(rec, direction); }
};

template <class World, class T = typename World::T>
vec3<T> radiance(const World& world, raio::ray<T> ray, random_numbers& random, std::int64_t& rays) {
    constexpr int depth = 20;
    vec3<T> throughput(1);
    for (int bounce = 0; bounce < depth; ++bounce) {
        typename World::record rec;
        const vec3<T> incoming = ray.direction / raio::length(ray.direction);
        ++rays;
        if (!world.hit(ray, rec)) {
            const T height = (incoming.y + 1) / 2;
            return throughput * (vec3<T>(1 - height) + vec3<T>(T(0.5), T(0.7), 1) * height);
        }
        const material<T>& made_of = world.material_at(rec);
        const auto direction = made_of.scatter(incoming, rec.normal, rec.front_face, random);
        if (!direction) break;
        throughput *= made_of.albedo;
        ray = World::leave(rec, *direction);
    }
    return vec3<T>(0);
}

/// The book's camera, as it looks through pixel (x, y), both in [-1, 1] in units of half the height.
template <class T>
raio::ray<T> view(T x, T y, random_numbers& random) {
    const vec3<T> eye(13, 2, 3), back = raio::normalize(eye),
                                 right = raio::normalize(raio::cross(vec3<T>(0, 1, 0), back));
    const vec3<T> up = raio::cross(back, right);
    constexpr T focus = 10, degree = raio::pi<T> / 180;
    const T height = focus * std::tan(10 * degree), lens = focus * std::tan(T(0.3) * degree);
    T lens_x, lens_y;
    do {
        lens_x = random.between<T>(-1, 1), lens_y = random.between<T>(-1, 1);
    } while (lens_x * lens_x + lens_y * lens_y >= 1);
    const vec3<T> from = right * (lens * lens_x) + up * (lens * lens_y);
    return {eye + from, right * (x * height) + up * (y * height) - back * focus - from};
}

/// One sample of every pixel is an iteration; five repetitions are the 50 samples of the picture.
template <class World>
void render(benchmark::State& state, const World& world) {
    using T = typename World::T;
    constexpr int width = 400, height = 225;
    static std::uint64_t sample = 0;
    std::int64_t rays = 0;
    T sum(0);
    for (auto _ : state) {
        random_numbers random(++sample << 32);
        for (int row = 0; row < height; ++row) {
            for (int column = 0; column < width; ++column) {
                const T x = T(column) + random.next<T>() - T(0.5) * width;
                const T y = T(0.5) * height - T(row) - random.next<T>();
                sum += radiance(world, view<T>(x * T(2.0 / height), y * T(2.0 / height), random), random, rays).y;
            }
        }
    }
    state.SetItemsProcessed(rays);
    state.counters["green"] = static_cast<double>(sum) / (double(state.iterations()) * width * height);
}

template <class World>
void add(const std::string& contender) {
    const bench::lazy world([] { return std::make_unique<World>(); });
    const std::string name = std::string("weekend/") + bench::number_name<typename World::T> + '/' + contender;
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { render(state, *world); })
        ->Iterations(10)
        ->Unit(benchmark::kMillisecond);
}

/// The book's world as it is, and with raio's spheres, quick and exact.
template <class World, class T>
void add_of_the_book(const std::string& contender) {
    add<of_the_book<World, peers::one_weekend::sphere<T, material<T>>>>(contender);
    add<of_the_book<World, raio_object<raio::quick<raio::sphere<T>>>>>(contender + "_of_quick");
    add<of_the_book<World, raio_object<raio::sphere<T>>>>(contender + "_of_exact");
}

template <class T>
void add_all() {
    add_of_the_book<peers::one_weekend::hittable_list<T, material<T>>, T>("list");
    add_of_the_book<peers::one_weekend::bvh_node<T, material<T>>, T>("bvh");
    add<of_raio<raio::quick<raio::sphere<T>>>>("raio_quick");
    add<of_raio<raio::sphere<T>>>("raio");
}

}  // namespace

int main(int argc, char** argv) {
    add_all<double>();
    add_all<float>();
    return bench::run(argc, argv);
}
