#include <cmath>
#include <cstdio>
#include <optional>
#include <span>

#include "bvh/contenders.hpp"
#include "support/oracle.hpp"

// Do raio and Embree give the same answers? Every ray of the benchmark is put to both; where they differ, a search
// through all triangles with 75 digits says who is right. Prints a table, and with --list every difference. The name of
// a scene asks for that one only. The exit status is 1 if raio was wrong.

namespace {

using raio::test::oracle;
using ray = raio::ray<float>;
using vec3 = raio::vec3<float>;

/// t, or nothing where the ray misses. Where only a yes was asked for, t is 0.
using answer = std::optional<float>;

/// Embree states no error; a t that is off by this much, relative to t, counts as the same.
constexpr float forgiven = 1e-5f;

bool same(const answer& a, const answer& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    return std::fabs(*a - *b) <= forgiven * std::fabs(*a);
}

/// Can the ray come near the box? Sure of every no, since the box is made larger by far more than a rounding.
bool comes_near(const raio::aabb<float>& box, const ray& r) {
    double enter = -raio::infinity<double>, leave = raio::infinity<double>;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const double o = r.origin[axis], d = r.direction[axis], margin = 1e-6 + 1e-5 * (1 + std::fabs(o));
        const double low = (double(box.min[axis]) - margin - o) / d, high = (double(box.max[axis]) + margin - o) / d;
        if (d == 0) continue;
        enter = std::max(enter, std::min(low, high));
        leave = std::min(leave, std::max(low, high));
    }
    return enter <= leave && leave >= 0;
}

raio::vec3<oracle> exact(const vec3& v) { return {oracle(v.x), oracle(v.y), oracle(v.z)}; }

answer truth(std::span<const bench::triangle> triangles, const ray& r, const bench::ray_set& set) {
    const raio::ray<oracle> exact_ray{exact(r.origin), exact(r.direction)};
    raio::hit_record<oracle> nearest;
    nearest.t = oracle(set.t_max);
    bool found = false;
    for (const bench::triangle& t : triangles) {
        if (!comes_near(t.bounds(), r)) continue;
        const raio::triangle<oracle> exact_triangle{exact(t.a), exact(t.b), exact(t.c)};
        found |= exact_triangle.hit(exact_ray, oracle(0), nearest.t, nearest);
    }
    if (!found) return {};
    return set.any ? 0 : raio::test::rounded<float>(nearest.t);
}

answer ask(const bench::triangle_tree& tree, const ray& r, const bench::ray_set& set) {
    if (set.any) return tree.occluded(r, 0, set.t_max) ? answer(0.0f) : answer();
    raio::hit_record<float> rec;
    return tree.hit(r, 0, set.t_max, rec) ? answer(rec.t) : answer();
}

answer ask(const peers::embree& tree, const ray& r, const bench::ray_set& set) {
    if (set.any) return tree.occluded(r, 0, set.t_max) ? answer(0.0f) : answer();
    RTCRayHit rec;
    return tree.hit(r, 0, set.t_max, rec) ? answer(rec.ray.tfar) : answer();
}

/// Returns whether raio was always right.
bool compare(const std::string& name, const bench::triangle_tree& tree, const peers::embree& peer,
             std::span<const bench::triangle> triangles, const bench::ray_set& set, bool list) {
    std::size_t differ = 0, raio_right = 0, peer_right = 0;
    for (const ray& r : set.rays) {
        const answer ours = ask(tree, r, set), theirs = ask(peer, r, set);
        if (same(ours, theirs)) continue;
        const answer exactly = truth(triangles, r, set);
        ++differ;
        raio_right += ours == exactly ? 1u : 0u;
        peer_right += same(exactly, theirs) ? 1u : 0u;
        if (!list) continue;
        const auto text = [](const answer& a) { return a ? std::to_string(*a) : std::string("none"); };
        std::printf("%s %s: origin %a %a %a, direction %a %a %a: raio %s, Embree %s, exact %s\n", name.c_str(),
                    set.name.c_str(), r.origin.x, r.origin.y, r.origin.z, r.direction.x, r.direction.y, r.direction.z,
                    text(ours).c_str(), text(theirs).c_str(), text(exactly).c_str());
    }
    std::printf("| %s | %s | %zu | %zu | %zu | %zu |\n", name.c_str(), set.name.c_str(), set.rays.size(), differ,
                raio_right, peer_right);
    std::fflush(stdout);
    return raio_right == differ;
}

}  // namespace

int main(int argc, char** argv) {
    bool list = false;
    std::string only;  // scene; empty: all of them
    for (const std::string word : std::span(argv + 1, argv + argc)) {
        if (word == "--list") {
            list = true;
        } else {
            only = word;
        }
    }
    bool right = true;
    std::puts("| scene, Embree | rays | asked | differ | raio right | Embree right |\n|---|---|---:|---:|---:|---:|");
    for (const bench::scene& scene : bench::scenes()) {
        if (!only.empty() && scene.name != only) continue;
        const bench::mesh mesh = scene.mesh();
        const auto triangles = bench::soup(mesh);
        const auto tree = bench::raio_tree(triangles, raio::bvh_quality::standard);
        const auto sets = bench::ray_sets(scene.camera(mesh), *tree);
        for (const bool robust : {false, true}) {
            const auto peer = bench::embree_tree(mesh, {.isa = "avx2", .robust = robust});
            peer->build();
            const std::string name = scene.name + (robust ? ", robust" : ", default");
            for (const auto& set : sets) right &= compare(name, *tree, *peer, triangles, set, list);
        }
    }
    return right ? 0 : 1;
}
