#include <doctest/doctest.h>

#include "scenes.hpp"

using namespace render;

namespace {

color light(const scene& s, const ray& view, int depth = 6, std::string_view name = "whitted") {
    sampler sampler(0, 0, 0);
    return integrator_named(name).radiance(world(s), view, sampler, depth);
}

void check_close(const color& found, const color& expected) {
    CAPTURE(found.x);
    CAPTURE(found.y);
    CAPTURE(found.z);
    CHECK(raio::length(found - expected) < 1e-12);
}

}  // namespace

TEST_CASE("flat shows the pigment of the nearest surface, and black where there is none") {
    const scene s = scene_of({{raio::sphere<number>{{0, 0, 2}, 1}, color(0, 1, 0), lambertian{}},
                              {raio::disc<number>{origin, {0, 0, 1}, 0.5}, color(1, 0, 0), emissive{color(5)}}},
                             {color(1), color(1)});
    CHECK(light(s, forward, 0, "flat") == color(1, 0, 0));
    CHECK(light(s, {{0.75, 0, -4}, {0, 0, 1}}, 0, "flat") == color(0, 1, 0));
    CHECK(light(s, {{3, 0, -4}, {0, 0, 1}}, 0, "flat") == color(0));
}

TEST_CASE("checkers change at every multiple of the size, below zero as well") {
    scene s = scene_of({{raio::plane<number>{{0, 0, 0.5}, {0, 0, 1}}, color(0), lambertian{}}});
    s.pigments[0] = checker{color(1, 0, 0), color(0, 0, 1), 2};
    for (int x = -5; x < 5; ++x) {
        for (int y = -5; y < 5; ++y) {
            const int cubes = (x + 10) / 2 + (y + 10) / 2;  // the ten is even, and lifts all above zero
            const color expected = cubes % 2 == 0 ? color(1, 0, 0) : color(0, 0, 1);
            CHECK(light(s, {{x + 0.5, y + 0.5, -4}, {0, 0, 1}}, 0, "flat") == expected);
        }
    }
}

TEST_CASE("normals are shown against the ray, from [-1, 1] to [0, 1]") {
    const scene s = scene_of({{raio::sphere<number>{origin, 1}, color(1), lambertian{}}});
    CHECK(light(s, forward, 0, "normals") == color(0.5, 0.5, 0));
    CHECK(light(s, {origin, {1, 0, 0}}, 0, "normals") == color(0, 0.5, 0.5));
    CHECK(light(s, {{5, 0, -4}, {0, 0, 1}}, 0, "normals") == color(0));
}

TEST_CASE("Phong's model: ambient, diffuse and specular, divided by the attenuation") {
    scene s = scene_of({{raio::plane<number>{origin, {0, 0, -1}}, color(0.5, 0.25, 0),
                         phong{.ambient = 0.1, .diffuse = 0.6, .specular = 0.3, .exponent = 4}}});
    s.lights.push_back({{3, 0, -4}, color(1, 0.5, 1), {1, 0.5, 0.1}});
    // The lamp is 5 away, with cosine 4/5; its mirror image is 3/5, 4/5 away from a view along the normal.
    const color pigment(0.5, 0.25, 0), lamp = color(1, 0.5, 1) / 6.0;
    check_close(light(s, forward), pigment * 0.1 + lamp * (pigment * 0.6 * 0.8 + 0.3 * std::pow(0.8, 4)));
    // From the other side the lamp is behind the surface.
    check_close(light(s, {{0, 0, 4}, {0, 0, -1}}), pigment * 0.1);
}

TEST_CASE("a lamp casts a shadow of what is between, not of what is behind it or behind the surface") {
    const auto with = [](const raio::sphere<number>& thing) {
        scene s = scene_of(
            {{raio::plane<number>{origin, {0, 0, -1}}, color(1), phong{.diffuse = 0.5}}, {thing, color(0), phong{}}});
        s.lights.push_back({{0, 4, -3}, color(1), {1, 0, 0}});
        return light(s, forward).x;
    };
    const number lit = with({{100, 100, 100}, 1});
    CHECK(lit == doctest::Approx(0.3));
    CHECK(with({{0, 2, -1.5}, 0.5}) == 0);
    CHECK(with({{0, 6, -4.5}, 0.5}) == lit);
    CHECK(with({{0, -2, 1.5}, 0.5}) == lit);
}

TEST_CASE("a mirror shows what is there, weighted, as often as light may bounce") {
    scene s =
        scene_of({{raio::plane<number>{origin, {0, 0, -1}}, color(0), phong{.reflected = 0.5}},
                  {raio::plane<number>{{0, 0, -10}, {0, 0, 1}}, color(0.2), phong{.ambient = 1, .reflected = 0.5}}});
    check_close(light(s, forward, 0), color(0));
    check_close(light(s, forward, 1), color(0.1));
    check_close(light(s, forward, 2), color(0.1));
    check_close(light(s, forward, 3), color(0.1 + 0.1 / 4));
}

TEST_CASE("every bounce is clamped to [0, 1]") {
    const scene s = scene_of({{raio::plane<number>{origin, {0, 0, -1}}, color(0), phong{.reflected = 0.5}},
                              {raio::plane<number>{{0, 0, -10}, {0, 0, 1}}, color(0), emissive{color(8, 0.5, 0)}}});
    check_close(light(s, forward), color(0.5, 0.25, 0));
}

TEST_CASE("glass bends the view to where Snell's law says, and reflects it all beyond the critical angle") {
    // A wall of checkers behind a thick plate: through it one looks as far aside as in the textbook.
    scene s = scene_of({{raio::box<number>{{-100, -100, 0}, {100, 100, 3}}, color(1),
                         phong{.transmitted = 1, .refractive_index = 1.5}},
                        {raio::plane<number>{{0, 0, 3.5}, {0, 0, 1}}, color(1), phong{.ambient = 1}}});
    s.pigments[1] = checker{color(1), color(0), 0.125};
    const number sine = 0.6, cosine = 0.8, sine_inside = sine / 1.5;
    const number x =
        0.5 * sine / cosine + 3 * sine_inside / std::sqrt(1 - sine_inside * sine_inside);  // where the wall is met
    for (const number aside : {-0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3}) {
        const number cubes = std::floor((x + aside) / 0.125) + std::floor(3.5 / 0.125) + std::floor(0.01 / 0.125);
        const color expected = std::fmod(cubes, 2) == 0 ? color(1) : color(0);
        check_close(light(s, {{aside - 3 * sine / cosine, 0.01, -3}, {sine, 0, cosine}}), expected);
    }

    // From inside a glass block, a view that meets its side at 45 degrees sees the far face reflected, and nothing of
    // the outside.
    scene block = scene_of(
        {{raio::box<number>{{-1, -1, -1}, {1, 1, 1}}, color(0), phong{.transmitted = 1, .refractive_index = 1.5}},
         {raio::sphere<number>{{0.5, 0, 0}, 0.25}, color(0.25), phong{.ambient = 1}}},
        {color(1), color(1)});
    check_close(light(block, {{-0.5, 0, 0}, {1, 1, 0}}), color(0.25));
}

TEST_CASE("fog takes over with the distance, but not before the sky") {
    scene s = scene_of({{raio::sphere<number>{origin, 1}, color(1, 0, 0), phong{.ambient = 1}}},
                       {color(0, 0, 1), color(0, 0, 1)});
    s.fog = {color(0, 1, 0), 0.25};
    const number clear = std::exp(-0.75);
    check_close(light(s, forward), {clear, 1 - clear, 0});
    check_close(light(s, {{0, 0, -4}, {0, 0, 7}}), {clear, 1 - clear, 0});  // a distance, not a count of directions
    check_close(light(s, {{5, 0, -4}, {0, 0, 1}}), {0, 0, 1});
}

TEST_CASE("the sky goes from its lower to its upper colour with the height of the direction") {
    const scene s = scene_of({}, {color(1, 0, 0), color(0, 0, 1)});
    for (const std::string_view name : {"whitted", "path"}) {
        check_close(light(s, {origin, {0, -2, 0}}, 6, name), {1, 0, 0});
        check_close(light(s, {origin, {3, 0, 4}}, 6, name), {0.5, 0, 0.5});
        check_close(light(s, {origin, {4, 3, 0}}, 6, name), {0.2, 0, 0.8});
    }
}
