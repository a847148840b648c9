#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <render/shape_readings.hpp>

#include "reader_text.hpp"
#include "scenes.hpp"

using namespace render;

// The path integrator draws at random: the mean of many paths is compared with what the physics says, within five
// standard errors.

namespace {

const background white{color(1), color(1)};

raio::convex_polyhedron<number> polyhedron_of(const raio::box<number>& box) {
    return {{{{-1, 0, 0}, box.min.x},
             {{1, 0, 0}, -box.max.x},
             {{0, -1, 0}, box.min.y},
             {{0, 1, 0}, -box.max.y},
             {{0, 0, -1}, box.min.z},
             {{0, 0, 1}, -box.max.z}}};
}

void check_red(const estimate& found, number expected) {
    CAPTURE(found.mean.x);
    CAPTURE(found.standard_error);
    CAPTURE(expected);
    CHECK(std::abs(found.mean.x - expected) <= 5 * found.standard_error + 1e-12);
}

}  // namespace

TEST_CASE("white furnace: a convex matte thing under a sky of 1 shows just its albedo") {
    for (const number albedo : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        const color hue(albedo, albedo / 2, 0);
        for (const shape& s : {shape(raio::sphere<number>{origin, 1}), shape(raio::box<number>{vec3(-1), vec3(1)}),
                               shape(raio::cylinder<number>{{-1, 0, 0}, {1, 0, 0}, 1})}) {
            const estimate found = path_estimate(world(scene_of({{s, hue, lambertian{}}}, white)), forward, 256);
            CHECK(raio::length(found.mean - hue) < 1e-12);
        }
    }
}

TEST_CASE("white furnace: among things that lose no light, everything is as bright as the sky") {
    const std::vector<painted> things{
        {raio::sphere<number>{{0, 0, 0}, 1}, color(1), lambertian{}},
        {raio::sphere<number>{{1.5, 0, -1}, 0.75}, color(1), lambertian{}},
        {raio::sphere<number>{{-1.5, 0.5, -1}, 0.75}, color(1), dielectric{1.5}},
        {raio::box<number>{{-1, -2, -3}, {1, -1, 1}}, color(1), metal{0}},
        {polyhedron_of({{-0.5, 1.25, -2}, {0.5, 2, -1}}), color(1), dielectric{1.5}},
    };
    SUBCASE("that shines from afar") {
        const world world(scene_of(things, white));
        for (const number x : {0.0, 0.1, 0.3, -0.4})
            check_red(path_estimate(world, {{0, 0, -4}, {x, 0.05, 1}}, 4096, 1000), 1);
    }
    SUBCASE("that is an emitter around them: found in two ways, and counted once") {
        std::vector<painted> enclosed = things;
        enclosed.push_back({raio::sphere<number>{origin, 20}, color(0), emissive{color(1)}});
        const world world(scene_of(enclosed));
        for (const number x : {0.0, 0.1, 0.3, -0.4})
            check_red(path_estimate(world, {{0, 0, -4}, {x, 0.05, 1}}, 4096, 1000), 1);
    }
}

TEST_CASE("inside a closed sphere, light is what the series of its reflections adds up to") {
    // Every point of a matte sphere about an emitter gets the same light. The emitter of radius r fills the share (r /
    // R)^2 of what a point sees, weighted by the cosine, and the sphere itself the rest: L = albedo (share e + (1 -
    // share) L).
    const number r = 0.25, R = 2, albedo = 0.5, share = r * r / (R * R);
    const world lit(scene_of({{raio::sphere<number>{origin, R}, color(albedo), lambertian{}},
                              {raio::sphere<number>{origin, r}, color(0), emissive{color(3)}}}));
    const number expected = albedo * 3 * share / (1 - albedo * (1 - share));
    check_red(path_estimate(lit, {{1, 0, 0}, {0.1, 0.2, 1}}, 1 << 15, 1000), expected);
}

TEST_CASE("emitters light a matte point as the textbook says") {
    const raio::disc<number> floor{{0, 0, 0}, {0, 1, 0}, 0.5};
    const ray view{{0.1, 0.1, 0.1}, {-1, -1, -1}};  // meets the floor in the origin
    const auto seen_under = [&](const shape& lamp, int paths = 1 << 14) {
        const world world(scene_of({{floor, color(0.5), lambertian{}}, {lamp, color(0), emissive{color(2)}}}));
        return path_estimate(world, view, paths, 1);
    };
    SUBCASE("disc on the axis: E = pi L r^2 / (r^2 + h^2)") {
        check_red(seen_under(raio::disc<number>{{0, 2, 0}, {0, 1, 0}, 1}), 0.5 * 2 * 1 / 5.0);
        check_red(seen_under(raio::disc<number>{{0, 2, 0}, {0, -3, 0}, 1}), 0.5 * 2 * 1 / 5.0);
    }
    SUBCASE("sphere above the horizon: E = pi L (r / d)^2 cos") {
        check_red(seen_under(raio::sphere<number>{{0, 3, 0}, 1}), 0.5 * 2 / 9.0);
        check_red(seen_under(raio::sphere<number>{{3, 3, 0}, 1}), 0.5 * 2 / 18.0 / std::sqrt(2.0));
    }
    SUBCASE("right triangle at height 1: half of the unit square whose corner is over the point") {
        // Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-3, with a = b = c.
        const number square = std::sqrt(2.0) * std::atan(std::sqrt(0.5)) / (2 * raio::pi<number>);
        check_red(seen_under(raio::triangle<number>{{0, 1, 0}, {1, 1, 0}, {1, 1, 1}}), 0.5 * 2 * square / 2);
    }
}

TEST_CASE("every shape with an area is an area light, transformed ones as well: the same light as found by chance") {
    const raio::disc<number> floor{{0, 0, 0}, {0, 1, 0}, 0.5};
    const ray view{{0.1, 0.1, 0.1}, {-1, -1, -1}};  // meets the floor in the origin
    const auto lit_by = [&](const shape& lamp) {
        return world(scene_of({{floor, color(0.5), lambertian{}}, {lamp, color(0), emissive{color(2)}}}));
    };
    const auto forgotten = [](const shape& lamp) {
        return std::visit([](const auto& s) { return any_shape(raio::group{std::vector{s}}); }, lamp);
    };
    for (
        const std::string words : {
            "sphere 0.5 2 0  0.5",
            "disc 0.5 1.5 0  1 2 0  1",
            "parallelogram 0 1 0  1 0.5 0  0 0.5 1",
            "triangle 0 1 0  1 1.5 0  1 1 1",
            "box 0.5 1 -1  1.5 2 1",
            "cylinder 0 1 0  1 1 0  0.5 1",
            "open_cylinder 0 1 0  1 1 0  0.5 1",
            "polyhedron 4  1 1 1 -3  -1 0 0 0  0 -1 0 1  0 0 -1 0",
            "torus 0.2 1.5 0  1 0.4 0  1 0.4",  // hides a part of itself twice over
            "ring 0.5 1.5 0  1 2 0  0.5 1",
            "capsule 0 1.5 0  1 2 0.5  0.5",
            "round_cone 0 1.5 0  1 2 0.5  0.5 0.25",
            "cone 1 1.5 0  -0.2 1 0  0.75",
            "open_cone -0.2 1 0  1 1.5 0  0.75",
            "frustum 0 1 0  1 1.5 0  0.5 1",
            "open_frustum 0 1.2 0  1 1.5 0  0.5 1",
            "paraboloid 0 1 0  1 1.5 0  1",
            "open_paraboloid 1 1.5 0  0 1 0  0.75",
            "hyperboloid -0.5 1.5 0  1 1.5 0  0.25 0.75",
            "open_hyperboloid -0.5 1.5 0  1 1.5 0  0.25 0.75",
            "two_sheet_hyperboloid -0.5 1.5 0  1 1.5 0  0.25 0.75",
            "open_two_sheet_hyperboloid -0.5 1.5 0  1 1.5 0  0.25 0.75",
            "surface_of_revolution 0 1 0  0 1 0  4  0 0.5  0.5 1  1 0  0.75 0",
            "prism 3  0 1 0  1 1 0  0 1 1  0.2 1 0",
            "regular_solid 8  0.5 2 0  0.75",
            // Under maps: similar, mirrored, and uneven, which stretches some places more than others.
            "translate 0.5 2 0  rotate 1 2 3 40  scale 0.5 0.5 0.5  sphere 0 0 0 1",
            "translate 0.5 2 0  scale -0.5 0.5 0.5  cone 0 -1 0  0 1 0  1",
            "translate 0.5 1.5 0  rotate 1 2 3 40  scale 1 0.25 0.5  sphere 0 0 0 1",
            "translate 0.5 1.5 0  rotate 0 0 1 50  scale 0.3 -1 0.5  torus 0 0 0  1 0 0  1 0.4",
            "translate 0.5 1.5 0  rotate 0 0 1 50  scale 0.5 1.5 0.5  rotate 1 0 0 30  box -0.5 -0.5 -0.5  0.5 0.5 0.5",
            "translate 0 1.5 0  rotate 0 0 1 50  scale 0.5 1.5 0.5  open_cone -0.5 0 0  0.5 0 0  1",
        }) {
        CAPTURE(words);
        const shape lamp = read({.objects = "1  0 0 " + words}).objects.at(0).shape;
        const world sampled = lit_by(lamp), by_chance = lit_by(forgotten(lamp));
        CHECK(sampled.emitters().size() == 1);
        CHECK(by_chance.emitters().size() == 0);
        const estimate found = path_estimate(sampled, view, 1 << 14, 1),
                       expected = path_estimate(by_chance, view, 1 << 16, 1);
        CAPTURE(expected.mean.x);
        CHECK(std::abs(found.mean.x - expected.mean.x) < 5 * (found.standard_error + expected.standard_error));
        CHECK(found.standard_error < 2 * expected.standard_error);  // with a quarter of the paths
    }
}

TEST_CASE("what a map makes of a surface is sampled as densely as it says") {
    // The mean of f / density over the chosen points is the integral of f over the surface: here of 1, the area, and of
    // the height, of an ellipsoid of radii 1, 1, 2 (a prolate spheroid), whose middle is at the height of 3.
    const scene s = read({.objects = "1  0 0  translate 0 3 0  scale 1 1 -2  sphere 0 0 0 1"});
    const auto surface = std::get<any_shape>(s.objects.at(0).shape).sampler();
    const number e = std::sqrt(0.75), area = 2 * raio::pi<number> * (1 + 2 / e * std::asin(e));
    number sum = 0, heights = 0;
    constexpr int n = 1 << 14;
    for (std::uint32_t i = 0; i < n; ++i) {
        const auto [point, normal] = surface->sample(sampler(2, 0, i).next_2d());
        const vec3 outward = raio::normalize(vec3(point.x, point.y - 3, point.z / 4));
        REQUIRE(raio::length(outward - normal) < 1e-12);
        const number density = surface->density(normal);
        REQUIRE(surface->density(-normal) == density);
        sum += 1 / density / n;
        heights += point.y / density / n;
    }
    CHECK(sum == doctest::Approx(area).epsilon(1e-3));
    CHECK(heights == doctest::Approx(3 * area).epsilon(1e-3));
}

TEST_CASE("a lamp without size lights a matte floor as it does in Whitted's model") {
    scene s = scene_of({{raio::plane<number>{origin, {0, 1, 0}}, color(0.8), phong{.diffuse = 0.5}}});
    s.lights.push_back({{1, 2, 0}, color(0.9), {1, 0.1, 0.01}});
    const world world(s);
    const ray view{{0, 1, -1}, {0, -1, 1}};
    sampler sampler(0, 0, 0);
    const color expected = whitted::radiance(world, view, sampler, 1);
    CHECK(expected.x > 0.1);
    CHECK(raio::length(path_estimate(world, view, 64, 1).mean - expected) < 1e-12);
}

TEST_CASE("fog that shines as bright as the sky hides nothing and changes nothing") {
    scene s = scene_of({{raio::sphere<number>{origin, 1}, color(1), lambertian{}}}, white);
    s.fog = {color(1), 0.3};
    check_red(path_estimate(world(s), forward), 1);
    s.fog = {color(0), 0.3};  // black fog only weakens: here by exp(-0.3 * 3)
    check_red(path_estimate(world(s), forward), std::exp(-0.9));
    s.materials[0] = emissive{color(2)};
    check_red(path_estimate(world(s), forward, 4), 2 * std::exp(-0.9));
}

TEST_CASE("depth is how often light may bounce") {
    const world world(scene_of({{raio::sphere<number>{origin, 1}, color(0.5), lambertian{}}}, white));
    CHECK(path_estimate(world, forward, 16, 0).mean == color(0));
    CHECK(path_estimate(world, forward, 16, 1).mean == color(0.5));
}
