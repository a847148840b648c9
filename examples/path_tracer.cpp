// The final scene of Peter Shirley's "Ray Tracing in One Weekend": path_tracer PICTURE.ppm [WIDTH [SAMPLES [THREADS]]]

#include <raio/bvh/bvh.hpp>
#include <raio/shape/sphere.hpp>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <glm/glm.hpp>
#include <thread>
#include <variant>
#include <vector>

using glm::vec2, glm::vec3;

struct hit_record {  // what is wanted of a hit: raio fills what there is
    float t;
    vec3 point, normal, error;
    bool front_face;
    std::uint32_t index;
};

// SplitMix64 (Steele, Lea and Flood 2014). Every pixel has its own: the picture is the same on any number of threads.
struct random_numbers {
    std::uint64_t state;
    explicit random_numbers(std::uint64_t seed) : state(seed * 0xd1342543de82ef95) {}
    float operator()() {  // in [0, 1)
        std::uint64_t x = state += 0x9e3779b97f4a7c15;
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
        x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
        return float((x ^ (x >> 31)) >> 40) * 0x1p-24f;
    }
    vec2 in_unit_disc() {
        const float radius = std::sqrt((*this)()), angle = glm::radians(360 * (*this)());
        return {radius * std::cos(angle), radius * std::sin(angle)};
    }
    vec3 on_unit_sphere() {  // Marsaglia 1972
        const vec2 p = in_unit_disc();
        return vec3(p * (2 * std::sqrt(std::max(0.0f, 1 - dot(p, p)))), 1 - 2 * dot(p, p));
    }
};

// Materials say where a path goes on that arrives in direction `in`, a unit vector, and with what share of the light.
using scattered = std::pair<vec3, vec3>;
struct lambertian {
    vec3 albedo;
    scattered scatter(const vec3&, const hit_record& rec, random_numbers& random) const {
        return {rec.normal + 0.9999f * random.on_unit_sphere(), albedo};  // never 0
    }
};
struct metal {
    vec3 albedo;
    float fuzz;
    scattered scatter(const vec3& in, const hit_record& rec, random_numbers& random) const {
        const vec3 out = reflect(in, rec.normal) + fuzz * random.on_unit_sphere();
        return {out, dot(out, rec.normal) > 0 ? albedo : vec3(0)};
    }
};
struct dielectric {
    float refractive_index;
    scattered scatter(const vec3& in, const hit_record& rec, random_numbers& random) const {
        const float eta = rec.front_face ? 1 / refractive_index : refractive_index;
        const float r0 = glm::pow((1 - eta) / (1 + eta), 2.0f), cosine = std::min(1.0f, -dot(in, rec.normal));
        const float reflectance = r0 + (1 - r0) * glm::pow(1 - cosine, 5.0f);  // Schlick 1994
        const vec3 through = refract(in, rec.normal, eta);                     // 0 where all is reflected
        return {through == vec3(0) || random() < reflectance ? reflect(in, rec.normal) : through, vec3(1)};
    }
};
using material = std::variant<lambertian, metal, dielectric>;

struct scene {
    std::vector<raio::sphere<float>> spheres;
    std::vector<material> materials;  // one for each sphere
    scene() {
        random_numbers random(1);
        add({0, -1000, 0}, 1000, lambertian{vec3(0.5f)});
        for (int i = 0; i < 22 * 22; ++i) {
            const vec3 center{float(i / 22 - 11) + 0.9f * random(), 0.2f, float(i % 22 - 11) + 0.9f * random()};
            const vec3 u{random(), random(), random()}, v{random(), random(), random()};
            const float choice = random();
            if (distance(center, vec3(4, 0.2f, 0)) <= 0.9f) continue;
            add(center, 0.2f,
                choice < 0.8f    ? material(lambertian{u * v})
                : choice < 0.95f ? material(metal{0.5f + 0.5f * u, 0.5f * v.x})
                                 : material(dielectric{1.5f}));
        }
        add({0, 1, 0}, 1, dielectric{1.5f});
        add({-4, 1, 0}, 1, lambertian{{0.4f, 0.2f, 0.1f}});
        add({4, 1, 0}, 1, metal{{0.7f, 0.6f, 0.5f}, 0});
    }
    void add(vec3 center, float radius, material of) { spheres.push_back({center, radius}), materials.push_back(of); }
};

// The light that arrives along a ray.
vec3 light(const scene& world, const auto& tree, raio::ray<float> ray, random_numbers& random) {
    vec3 share(1);
    for (int bounce = 0; bounce < 50 && share != vec3(0); ++bounce) {
        const vec3 in = normalize(ray.direction);
        hit_record rec;
        if (!tree.hit(ray, 0, raio::infinity<float>, rec))
            return share * mix(vec3(1), vec3(0.5f, 0.7f, 1), 0.5f + 0.5f * in.y);  // the sky
        const auto scatter = [&](const auto& of) { return of.scatter(in, rec, random); };
        const auto [out, part] = std::visit(scatter, world.materials[rec.index]);
        share *= part;
        ray = raio::spawn_ray(rec, out);  // starts beside the surface, and so t_min is 0
    }
    return vec3(0);
}

int main(int argc, char** argv) {
    const auto refuse = [](const char* what, const char* why) { return std::fprintf(stderr, "%s %s\n", what, why), 1; };
    if (argc < 2 || *argv[1] == '-') return refuse("usage: path_tracer", "PICTURE.ppm [WIDTH [SAMPLES [THREADS]]]");
    std::ofstream file(argv[1], std::ios::binary);
    if (!file) return refuse(argv[1], "cannot be written");
    const auto number = [&](int i, int other) { return argc > i ? std::clamp(std::atoi(argv[i]), 1, 9999) : other; };
    const int width = number(2, 1200), height = std::max(1, width * 9 / 16), samples = number(3, 100);
    const scene world;
    const raio::bvh tree(world.spheres);

    // A thin lens: what is 10 away is in focus.
    const vec3 eye(13, 2, 3), forward = normalize(-eye);
    const vec3 right = normalize(cross(forward, vec3(0, 1, 0))), up = cross(right, forward);
    const float half_height = glm::tan(glm::radians(20.0f / 2)), lens_radius = 10 * glm::tan(glm::radians(0.6f / 2));
    std::vector<glm::u8vec3> picture(std::size_t(width) * std::size_t(height));
    std::atomic<int> next = 0;
    const auto work = [&] {
        for (int i; (i = next++) < width * height;) {
            random_numbers random{std::uint64_t(i)};
            vec3 sum(0);
            for (int sample = 0; sample < samples; ++sample) {
                const vec2 pixel = vec2(i % width, i / width) + vec2{random(), random()};
                const vec2 p = half_height / float(height) * (2.0f * pixel - vec2(width, height)) * vec2(1, -1);
                const vec2 lens = lens_radius * random.in_unit_disc();
                const vec3 from = right * lens.x + up * lens.y, to = 10.0f * (forward + right * p.x + up * p.y);
                sum += light(world, tree, {eye + from, to - from}, random);
            }
            picture[std::size_t(i)] = 255.99f * sqrt(sum / float(samples));  // a gamma of 2
        }
    };
    std::vector<std::jthread> threads;
    for (int i = number(4, int(std::thread::hardware_concurrency())); i > 1; --i) threads.emplace_back(work);
    work();
    threads.clear();  // waits for them
    file << "P6\n" << width << ' ' << height << "\n255\n";
    for (const glm::u8vec3& pixel : picture) file << pixel.r << pixel.g << pixel.b;
    if (!file.flush()) return refuse(argv[1], "cannot be written");
}
