// A program that imports raio and includes nothing of it: module.cmake compiles the module, this, and with BESIDE a
// second time as a file that includes raio, for both may be in one program.
#include <cmath>
#include <cstdio>
#include <glm/ext/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>  // for any_primitive, with g++ 14 and 15
#include <vector>

#if defined(BESIDE)
#include <raio/bvh/bvh.hpp>
#include <raio/shape/triangle.hpp>
#else
import raio;
#endif

using triangle_tree = raio::bvh<raio::triangle<float>>;

/// What a user wants of a hit, and has beside it.
struct own_record {
    double t;
    glm::dvec3 normal;
    int material;
};

raio::aabb<float> bounds_in_the_file_beside(const triangle_tree& tree);

#if defined(BESIDE)

raio::aabb<float> bounds_in_the_file_beside(const triangle_tree& tree) { return tree.bounds(); }

#else

namespace {

int failures = 0;

void check(bool right, const char* what) {
    if (right) return;
    std::printf("wrong: %s\n", what);
    ++failures;
}

void check_shapes() {
    // The README's lines.
    const raio::sphere<float> sphere{{0, 0, -3}, 1};
    const raio::ray<float> ray{{0, 0, 0}, {0, 0.2f, -1}};
    raio::hit_record<float> rec;
    if (sphere.hit(ray, 0, raio::infinity<float>, rec))
        std::printf("met at t = %g, normal (%g, %g, %g)\n", rec.t, rec.normal.x, rec.normal.y, rec.normal.z);

    const glm::vec3 point = ray.origin + rec.t * ray.direction;  // GLM's own types and operators
    check(std::abs(point.z - rec.point.z) < 1e-6f, "the point");
    check(!sphere.occluded(spawn_ray(rec, rec.normal), 0, raio::infinity<float>), "a spawned ray");

    own_record mine{.t = 0, .normal = {}, .material = 7};
    check(raio::sphere<double>{{0, 0, -3}, 1}.hit({{0, 0, 0}, {0, 0, -1}}, 0, raio::infinity<double>, mine) &&
              mine.t == 2 && mine.normal == glm::dvec3(0, 0, 1) && mine.material == 7,
          "a user's own record");

    const raio::quick<raio::torus<double>> torus{{{0, 0, -3}, {0, 0, 1}, 1, 0.25}};
    check(torus.hit({{1, 0, 0}, {0, 0, -1}}, 0, 10, mine) && std::abs(mine.t - 2.75) < 1e-12, "quick");

    const raio::box<double> box{{-1, -1, -4}, {1, 1, -2}};
    const auto bitten = raio::difference_of(box, raio::sphere<double>{{0, 0, -2}, 0.5});
    check(bitten.hit({{0, 0, 0}, {0, 0, -1}}, 0, raio::infinity<double>, mine) && mine.t == 2.5, "csg");
    check(contains(bitten, {0, 0, -3}) && !contains(bitten, {0, 0, -2.25}), "contains");

    const raio::group group{std::vector{box}, torus};  // of two types, which are deduced
    const raio::any_primitive<double> any = raio::transformed{group, glm::translate(glm::dmat4(1), {0, 0, -1})};
    check(any.hit({{0, 0, 0}, {0, 0, -1}}, 0, raio::infinity<double>, mine) && mine.t == 3, "any_primitive");
}

void check_trees() {
    std::vector<raio::triangle<float>> triangles;
    for (int i = 0; i < 100; ++i) {
        const auto x = static_cast<float>(i % 10), y = static_cast<float>(i / 10), z = -1 - x - y;
        triangles.push_back({{x, y, z}, {x + 1, y, z}, {x, y + 1, z}});
    }
    const triangle_tree tree(triangles);
    const raio::ray<float> ray{{3.25f, 4.25f, 0}, {0, 0, -1}};
    raio::hit_record<float> rec;
    check(tree.hit(ray, 0, raio::infinity<float>, rec) && rec.t == 8 && rec.index == 43, "a tree");
    check(!tree.occluded(ray, 0, 7) && tree.occluded(ray, 0, 8), "a tree, occluded");
    const raio::bvh deduced(triangles);
    check(deduced.occluded(ray, 0, 8), "a tree whose type is deduced");
#if defined(HAS_FILE_BESIDE)
    check(bounds_in_the_file_beside(tree).min.z == tree.bounds().min.z, "the same tree where it is included");
#endif
}

void check_packs() {
    using pack = raio::pack<float, 4>;
    using std::abs, std::sqrt, std::floor, std::sin, std::cos, std::atan2, std::copysign;
    const float numbers[]{-1.5f, 0.25f, 2, 3.75f};
    const auto same = [&](auto f, const char* what) {
        const pack all = f(pack::load(numbers), pack(0.5f));
        float found[4];
        all.store(found);
        for (int i = 0; i < 4; ++i) check(std::abs(found[i] - f(numbers[i], 0.5f)) < 1e-6f, what);
    };
    same([](auto x, auto y) { return (x + y) * x - x / y; }, "pack: arithmetic");
    same([](auto x, auto y) { return sqrt(abs(x)) + floor(x * y); }, "pack: sqrt, abs, floor");
    same([](auto x, auto y) { return sin(x) + cos(y) + atan2(x, y); }, "pack: sin, cos, atan2");
    same([](auto x, auto y) { return copysign(y, x); }, "pack: copysign");
    check(bits(pack::load(numbers) < pack(1)) == 3, "pack: comparison");
    check(std::numeric_limits<pack>::max() == std::numeric_limits<float>::max(), "pack: numeric_limits");

    const raio::sphere<pack> spheres{{pack::load(numbers), pack(0), pack(-3)}, pack(1)};
    const raio::ray<pack> rays{{pack(0), pack(0), pack(0)}, {pack(0), pack(0), pack(-1)}};
    raio::hit_record<pack> rec;
    check(bits(spheres.hit(rays, 0, raio::infinity<pack>, rec)) == 2, "spheres of a pack");
}

}  // namespace

int main() {
    check_shapes();
    check_trees();
    check_packs();
    return failures;
}

#endif
