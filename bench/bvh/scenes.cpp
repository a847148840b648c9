#include "bvh/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>

#include "support.hpp"

namespace bench {
namespace {

using vec3 = raio::vec3<float>;

/// The point of an octahedron's face, seen from the centre as one of a sphere.
vec3 on_sphere(const std::array<vec3, 3>& corners, int i, int j, int n) {
    const float u = float(i) / float(n), v = float(j) / float(n);
    return raio::normalize(corners[0] * (1 - u - v) + corners[1] * u + corners[2] * v);
}

/// Appends an octahedron whose faces are split into n^2 triangles each, every vertex moved to where `place` says.
template <class Place>
void add_octasphere(mesh& to, int n, Place place) {
    for (int face = 0; face < 8; ++face) {
        const float x = face & 1 ? -1.0f : 1.0f, y = face & 2 ? -1.0f : 1.0f, z = face & 4 ? -1.0f : 1.0f;
        std::array<vec3, 3> corners{vec3(x, 0, 0), vec3(0, y, 0), vec3(0, 0, z)};
        if (x * y * z < 0) std::swap(corners[1], corners[2]);  // counter-clockwise from outside
        const auto first = static_cast<std::uint32_t>(to.vertices.size());
        // Row j has n + 1 - j vertices, and so begins behind j (2n + 3 - j) / 2 others.
        const auto index = [&](int i, int j) {
            return first + static_cast<std::uint32_t>(j * (2 * n + 3 - j) / 2 + i);
        };
        for (int j = 0; j <= n; ++j) {
            for (int i = 0; i + j <= n; ++i) to.vertices.push_back(place(on_sphere(corners, i, j, n)));
        }
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i + j < n; ++i) {
                to.triangles.push_back({index(i, j), index(i + 1, j), index(i, j + 1)});
                if (i + j + 2 <= n) to.triangles.push_back({index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
            }
        }
    }
}

/// Appends a box with these three half axes.
void add_box(mesh& to, const vec3& center, const std::array<vec3, 3>& axes) {
    const auto first = static_cast<std::uint32_t>(to.vertices.size());
    for (int corner = 0; corner < 8; ++corner) {
        vec3 at = center;
        for (int axis = 0; axis < 3; ++axis) {
            at += axes[static_cast<std::size_t>(axis)] * (corner >> axis & 1 ? 1.0f : -1.0f);
        }
        to.vertices.push_back(at);
    }
    for (const std::array<std::uint32_t, 4> face : std::initializer_list<std::array<std::uint32_t, 4>>{
             {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
        const auto [a, b, c, d] = face;
        to.triangles.push_back({first + a, first + b, first + c});
        to.triangles.push_back({first + a, first + c, first + d});
    }
}

/// Axes of these half lengths, turned about the vertical.
std::array<vec3, 3> upright(const vec3& half, float angle) {
    const float c = std::cos(angle), s = std::sin(angle);
    return {vec3(c, 0, -s) * half.x, vec3(0, half.y, 0), vec3(s, 0, c) * half.z};
}

/// The folder of the models: the environment's, or else the build's; empty if there is none.
std::string models() {
    if (const char* folder = std::getenv("RAIO_BENCH_MODELS")) return folder;
    return RAIO_BENCH_MODELS;
}

}  // namespace

std::vector<raio::triangle<float>> soup(const mesh& from) {
    std::vector<raio::triangle<float>> triangles;
    triangles.reserve(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) triangles.push_back(from[i]);
    return triangles;
}

mesh bumpy_sphere(std::size_t triangle_count) {
    const int n = std::max(1, static_cast<int>(std::lround(std::sqrt(double(triangle_count) / 8))));
    mesh sphere;
    add_octasphere(sphere, n, [](const vec3& p) {
        float radius = 1;
        for (float frequency = 4, height = 0.06f; frequency < 200; frequency *= 2.1f, height *= 0.5f) {
            radius +=
                height * std::sin(frequency * p.x + 1) * std::sin(frequency * p.y + 2) * std::sin(frequency * p.z + 3);
        }
        return p * radius;
    });
    return sphere;
}

mesh city() {
    constexpr int blocks = 40;
    generator random;
    mesh town;
    const float far = 20 * blocks;
    add_box(town, {0, -1, 0}, upright({far, 1, far}, 0));
    for (int row = 0; row < blocks; ++row) {
        for (int column = 0; column < blocks; ++column) {
            const float x = float(2 * column - blocks + 1), z = float(2 * row - blocks + 1);
            const float height = 0.4f + random.between<float>(0, 1) * random.between<float>(0, 5);
            const float turn = random.between<float>(0, 1.5);
            add_box(town, {x, height, z}, upright({0.5f, height, random.between<float>(0.3, 0.6)}, turn));
            for (int i = 0; i < 8; ++i) {
                const vec3 half = vec3(0.02f) + (random.point<float>(1.0) + vec3(1)) * 0.04f;
                const float across = random.between<float>(-0.35, 0.35), along = random.between<float>(-0.25, 0.25);
                add_box(town, {x + across, 2 * height + half.y, z + along}, upright(half, turn));
            }
            for (int i = 0; i < 2; ++i) {
                const float radius = random.between<float>(0.08, 0.2), side = random.between<float>(-0.8, 0.8);
                const vec3 center(x + (i == 0 ? 0.85f : side), radius, z + (i == 0 ? side : 0.85f));
                add_octasphere(town, 6, [&](const vec3& p) { return center + p * radius; });
            }
        }
    }
    return town;
}

mesh room() {
    constexpr int planks = 4000;
    generator random;
    mesh inside;
    add_box(inside, {0, 2, 0}, upright({5, 2, 5}, 0));
    for (int i = 0; i < planks; ++i) {
        const vec3 along = random.direction<float>();
        const vec3 across = raio::normalize(raio::cross(along, random.direction<float>()));
        const float length = random.between<float>(0.2, 2), width = random.between<float>(0.01, 0.06);
        const vec3 half = along * length,
                   center(random.between<float>(-5, 5), random.between<float>(0, 4), random.between<float>(-5, 5));
        add_box(inside, center, {half, across * width, raio::cross(along, across) * 0.01f});
    }
    return inside;
}

camera filled_with(const std::vector<vec3>& points, const vec3& direction) {
    raio::aabb<float> box;
    for (const vec3& point : points) box = hull(box, point);
    const vec3 middle = (box.min + box.max) * 0.5f, back = raio::normalize(direction);
    const vec3 right = raio::normalize(raio::cross(vec3(0, 1, 0), back)), up = raio::cross(back, right);
    camera view{middle + back * (1.5f * raio::length(box.max - box.min)), middle, 0};
    for (const vec3& point : points) {
        const vec3 seen = point - view.eye;
        const float depth = -raio::dot(seen, back);
        view.half_width = std::max(
            {view.half_width, std::fabs(raio::dot(seen, right)) / depth, std::fabs(raio::dot(seen, up)) / depth});
    }
    return view;
}

std::vector<scene> scenes() {
    std::vector<scene> all;
    const auto from = [](const vec3& direction) {
        return [=](const mesh& seen) { return filled_with(seen.vertices, direction); };
    };
    const auto inside = [](const camera& view) { return [=](const mesh&) { return view; }; };
    const auto add_model = [&](const char* name, const char* file, const vec3& direction) {
        const auto path = std::filesystem::path(models()) / file;
        if (models().empty() || !std::filesystem::exists(path)) {
            std::fprintf(stderr, "%s is left out: no %s in the folder RAIO_BENCH_MODELS\n", name, file);
            return;
        }
        all.push_back({name, [path] { return read_model(path.string()); }, from(direction)});
    };
    add_model("bunny", "stanford-bunny.obj", {0.3f, 0.4f, 1});
    add_model("ogre", "ogre.obj", {0.5f, 0.3f, 1});
    all.push_back({"bumpy_sphere", [] { return bumpy_sphere(1'000'000); }, from({1, 0.6f, 2})});
    all.push_back({"city", city, inside({{-44, 16, -40}, {0, 0, 0}, 0.45f})});
    all.push_back({"room", room, inside({{-4.8f, 3.6f, -4.8f}, {1, 1, 1}, 0.8f})});
    return all;
}

}  // namespace bench
