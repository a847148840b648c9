#include <raio/bvh/bvh.hpp>
#include <raio/compose/group.hpp>
#include <raio/compose/transformed.hpp>
#include <raio/shape/box.hpp>
#include <raio/shape/cylinder.hpp>
#include <raio/shape/disc.hpp>
#include <raio/shape/sphere.hpp>
#include <raio/shape/triangle.hpp>

#include <memory>
#include <span>
#include <vector>

#include "bvh/measure.hpp"
#include "bvh/scenes.hpp"
#ifdef RAIO_BENCH_EMBREE
#include "peers/closest_approach.hpp"
#include "peers/embree.hpp"
#include "peers/glm.hpp"
#include "peers/quadratic_cylinder.hpp"
#include "peers/slabs.hpp"
#endif

// Other shapes than triangles: 100,000 of one type, 20,000 of each of five, or 1,000 instances of one mesh, strewn in a
// cube so that a third of the view gets through. SHAPES/RAYS/CONTENDER is one measurement.

namespace {

using vec3 = raio::vec3<float>;
using sphere = raio::sphere<float>;
using box = raio::box<float>;
using cylinder = raio::cylinder<float>;
using disc = raio::disc<float>;
using triangle = raio::triangle<float>;
using rays = bench::lazy<std::vector<bench::ray_set>>;
template <class Shape>
using lazy_shapes = bench::lazy<std::vector<Shape>>;

void make(bench::generator& random, sphere& s) {
    s.center = random.point<float>(1);
    s.radius = random.between<float>(0.001, 0.006);
}
void make(bench::generator& random, box& b) {
    const vec3 center = random.point<float>(1), half = vec3(0.0035f) + random.point<float>(0.0025);
    b = {center - half, center + half};
}
void make(bench::generator& random, cylinder& c) {
    c.base = random.point<float>(1);
    c.top = c.base + random.direction<float>() * random.between<float>(0.01, 0.03);
    c.radius = random.between<float>(0.0005, 0.0025);
}
void make(bench::generator& random, disc& d) {
    d.center = random.point<float>(1);
    d.normal = random.direction<float>();
    d.radius = random.between<float>(0.002, 0.007);
}
void make(bench::generator& random, triangle& t) {
    t.a = random.point<float>(1);
    t.b = t.a + random.point<float>(0.013);
    t.c = t.a + random.point<float>(0.013);
}

using mesh_tree = raio::bvh<triangle>;
using instance = raio::transformed<const mesh_tree*>;
void make(bench::generator& random, raio::transform<float>& map) {
    const vec3 axis = random.direction<float>(), size(random.between<float>(0.03, 0.06));
    const float angle = random.between<float>(0, 6);
    map = raio::translation(random.point<float>(1)) * raio::rotation(axis, angle) * raio::scaling(size);
}

template <class Shape>
lazy_shapes<Shape> strewn(std::size_t count) {
    return bench::lazy([=] {
        bench::generator random;
        auto shapes = std::make_unique<std::vector<Shape>>(count);
        for (Shape& shape : *shapes) make(random, shape);
        return shapes;
    });
}

/// Registers raio's tree over `make_group()`, and returns the rays that it is asked about.
template <class MakeGroup>
rays add_raio(const std::string& scene, MakeGroup make_group) {
    const bench::lazy tree([=] {
        const raio::bvh made(make_group(), raio::bvh_options{.threads = 1});
        return std::make_unique<std::remove_const_t<decltype(made)>>(made);
    });
    const rays sets([=] {
        const auto bounds = tree->bounds();
        const auto view = bench::filled_with({bounds.min, bounds.max}, {0.4f, 0.3f, 1});
        return std::make_unique<std::vector<bench::ray_set>>(bench::ray_sets(view, *tree));
    });
    bench::add_tree<raio::hit_record<float>>(scene, "raio", tree, sets);
    return sets;
}

#ifdef RAIO_BENCH_EMBREE
/// `fill(peer)` puts the shapes into the scene.
template <class Fill>
void add_embree(const std::string& scene, const std::string& name, const rays& sets, Fill fill) {
    for (const std::string isa : {"", "avx2"}) {
        const bench::lazy built([=] {
            auto peer = std::make_unique<peers::embree>(peers::embree_options{.isa = isa.c_str()});
            fill(*peer);
            peer->build();
            return peer;
        });
        bench::add_tree<RTCRayHit>(scene, isa.empty() ? name : name + '_' + isa, built, sets);
    }
}

void add_sphere_points(peers::embree& to, const std::vector<sphere>& spheres) {
    std::vector<std::array<float, 4>> points;
    for (const auto& [center, radius] : spheres) points.push_back({center.x, center.y, center.z, radius});
    to.add_spheres(points);
}

void add_triangles(peers::embree& to, const std::vector<triangle>& triangles) {
    std::vector<vec3> corners;
    std::vector<peers::embree::index3> indices;
    for (const auto& [a, b, c] : triangles) {
        const auto first = static_cast<std::uint32_t>(corners.size());
        corners.insert(corners.end(), {a, b, c});
        indices.push_back({first, first + 1, first + 2});
    }
    to.add_triangles(corners, indices);
}

template <class Kernel, class Shape>
void add_user_geometry(peers::embree& to, const lazy_shapes<Shape>& shapes) {
    to.add<Kernel>(std::span<const Shape>(*shapes));
}

using sphere_kernel = peers::closest_approach_sphere<float>;
using box_kernel = peers::with_record<peers::slabs<float>>;
using cylinder_kernel = peers::quadratic_cylinder<float>;
using disc_kernel = peers::with_record<peers::glm_disc<float>>;
#endif

}  // namespace

int main(int argc, char** argv) {
    constexpr std::size_t one_type = 100'000, of_five = 20'000;
    const auto spheres = strewn<sphere>(one_type), some_spheres = strewn<sphere>(of_five);
    const auto cylinders = strewn<cylinder>(one_type), some_cylinders = strewn<cylinder>(of_five);
    const auto discs = strewn<disc>(one_type), some_discs = strewn<disc>(of_five);
    const auto some_boxes = strewn<box>(of_five);
    const auto some_triangles = strewn<triangle>(of_five);

    const bench::lazy mesh([] { return std::make_unique<bench::mesh>(bench::bumpy_sphere(20'000)); });
    const bench::lazy tree_of_mesh([=] { return std::make_unique<mesh_tree>(*mesh); });
    const auto maps = strewn<raio::transform<float>>(1'000);

    const rays at_spheres = add_raio("spheres", [=] { return *spheres; });
    const rays at_cylinders = add_raio("cylinders", [=] { return *cylinders; });
    const rays at_discs = add_raio("discs", [=] { return *discs; });
    const rays at_five = add_raio("five_types", [=] {
        return raio::group(*some_spheres, *some_boxes, *some_cylinders, *some_discs, *some_triangles);
    });
    const rays at_instances = add_raio("instances", [=] {
        std::vector<instance> instances;
        for (const auto& map : *maps) instances.emplace_back(&*tree_of_mesh, map);
        return instances;
    });
#ifdef RAIO_BENCH_EMBREE
    using peers::embree;
    add_embree("spheres", "embree_points", at_spheres, [=](embree& to) { add_sphere_points(to, *spheres); });
    add_embree("spheres", "embree_user", at_spheres,
               [=](embree& to) { add_user_geometry<sphere_kernel>(to, spheres); });
    add_embree("cylinders", "embree_user", at_cylinders,
               [=](embree& to) { add_user_geometry<cylinder_kernel>(to, cylinders); });
    add_embree("discs", "embree_user", at_discs, [=](embree& to) { add_user_geometry<disc_kernel>(to, discs); });
    add_embree("five_types", "embree", at_five, [=](embree& to) {
        add_user_geometry<sphere_kernel>(to, some_spheres);
        add_user_geometry<box_kernel>(to, some_boxes);
        add_user_geometry<cylinder_kernel>(to, some_cylinders);
        add_user_geometry<disc_kernel>(to, some_discs);
        add_triangles(to, *some_triangles);
    });
    add_embree("instances", "embree", at_instances,
               [=](embree& to) { to.add_instances(mesh->vertices, mesh->triangles, *maps); });
#endif
    return bench::run(argc, argv);
}
