#include <atomic>

#include <doctest/doctest.h>
#include <render/camera.hpp>
#include <render/reader.hpp>

#include "scenes.hpp"

using namespace render;

namespace {

scene glass_and_light() {
    return scene_of({{raio::sphere<number>{origin, 1}, color(0.9, 1, 0.9), dielectric{1.5}},
                     {raio::plane<number>{{0, -1, 0}, {0, 1, 0}}, color(0.6), lambertian{}},
                     {raio::disc<number>{{0, 3, 0}, {0, 1, 0}, 1}, color(0), emissive{color(4)}}},
                    {color(0.2), color(0.5)});
}

}  // namespace

TEST_CASE("pixels are the same for any number of threads, and again with the same seed, and others with another") {
    const world world(glass_and_light());
    for (const integrator& integrator : integrators()) {
        CAPTURE(integrator.name);
        const auto picture = [&](int threads, std::uint64_t seed) {
            return rendered(world, integrator,
                            {.width = 40, .height = 30, .samples = 4, .depth = 8, .threads = threads, .seed = seed});
        };
        const film once = picture(1, 7);
        CHECK(same_pixels(once, picture(3, 7)));
        CHECK(same_pixels(once, picture(16, 7)));
        CHECK_FALSE(same_pixels(once, picture(1, 8)));
    }
}

TEST_CASE("every row is reported once") {
    std::atomic<int> rows = 0;
    rendered(world(scene{}), integrator_named("flat"), {.width = 2, .height = 29, .threads = 4}, [&] { ++rows; });
    CHECK(rows == 29);
}

TEST_CASE("what is rendered when it is stopped is kept, and the rest is black") {
    const scene s = scene_of({{raio::plane<number>{origin, {0, 0, 1}}, color(1), lambertian{}}});
    const world world(s);
    for (const int threads : {1, 4}) {
        std::atomic<int> rows = 0;
        const film picture = rendered(
            world, integrator_named("flat"), {.width = 4, .height = 1000, .threads = threads}, [&] { ++rows; },
            [&] { return rows >= 3; });
        CHECK(rows >= 3);
        CHECK(rows < 1000);
        CHECK(picture.at(3, 0) == color(1));
        CHECK(picture.at(3, 999) == color(0));
    }
}

TEST_CASE("whether anything lights a scene is known before") {
    const auto lit = [](const scene& s) {
        std::string by;
        for (const integrator& i : integrators()) by += i.is_lit(s) ? std::string(i.name) + " " : "";
        return by;
    };
    const auto ball = [](const material& m) { return scene_of({{raio::sphere<number>{origin, 1}, color(1), m}}); };
    scene dark = ball(phong{.diffuse = 1});
    CHECK(lit(dark) == "flat normals ");
    CHECK(lit(ball(emissive{color(0)})) == "flat normals whitted ");
    CHECK(lit(ball(lambertian{})) == "flat normals whitted ");  // Phong's model has it glow a little by itself
    CHECK(lit(ball(emissive{color(0, 0, 1)})) == "flat normals whitted path ");
    CHECK(lit(ball(phong{.ambient = 1})) == "flat normals whitted path ");
    dark.lights.push_back({{0, 4, -3}, color(0), {1, 0, 0}});
    CHECK(lit(dark) == "flat normals ");
    dark.lights[0].intensity = color(1);
    CHECK(lit(dark) == "flat normals whitted path ");
    dark.lights.clear();
    dark.fog = {color(1), 0};
    CHECK(lit(dark) == "flat normals ");
    dark.fog.density = 1;
    CHECK(lit(dark) == "flat normals whitted path ");
    dark.fog = {};
    dark.background.top = color(1);
    CHECK(lit(dark) == "flat normals whitted path ");
}

TEST_CASE("a pixel with one sample shows its corner, through the middle of the lens") {
    scene s = scene_of({{raio::sphere<number>{origin, 1}, color(1), lambertian{}}});
    s.camera.aperture = 0.5;
    const world world(s);
    const integrator& normals = integrator_named("normals");
    const film picture = rendered(world, normals, {.width = 12, .height = 9, .samples = 1});
    const camera camera(s.camera, 12, 9);
    for (int row = 0; row < 9; ++row) {
        for (int column = 0; column < 12; ++column) {
            sampler unused(0, 0, 0);
            const ray corner = camera.through(column, row, {0, 0}, {0, 0});
            CHECK(picture.at(column, row) == normals.radiance(world, corner, unused, 0));
        }
    }
}

TEST_CASE("a pixel with more samples shows their mean over its area") {
    // Half of the only pixel is covered by a disc so large that its edge is as good as straight.
    const scene s = scene_of({{raio::disc<number>{{1e4, 0, 0}, {0, 0, 1}, 1e4}, color(1), lambertian{}}});
    const film picture = rendered(world(s), integrator_named("flat"), {.width = 1, .height = 1, .samples = 256});
    CHECK(picture.at(0, 0).x == doctest::Approx(0.5).epsilon(0.01));
}

TEST_CASE("a lens is sharp at the distance of the focus and nowhere else") {
    const auto edge = [](number depth) {
        scene s = scene_of({{raio::box<number>{{0, -9, depth}, {9, 9, depth}}, color(1), lambertian{}}});
        s.camera.aperture = 1;
        s.camera.focus_distance = 4;
        return rendered(world(s), integrator_named("flat"), {.width = 64, .height = 64, .samples = 16});
    };
    const auto grey = [](const film& picture) {
        int count = 0;
        for (int column = 0; column < picture.width(); ++column) {
            const number level = picture.at(column, 32).x;
            if (level > 0.05 && level < 0.95) ++count;
        }
        return count;
    };
    CHECK(grey(edge(0)) <= 1);
    CHECK(grey(edge(-2)) > 2);
    CHECK(grey(edge(8)) > 2);
}

TEST_CASE("the scenes that come with the renderer are read, and show something to every integrator") {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(RAIO_SCENES)) {
        if (entry.path().extension() != ".txt") continue;
        CAPTURE(entry.path().string());
        const world world(read_scene(entry.path()));
        for (const integrator& integrator : integrators()) {
            const film picture = rendered(world, integrator, {.width = 16, .height = 9, .samples = 1, .depth = 4});
            color sum(0);
            for (int row = 0; row < 9; ++row) {
                for (int column = 0; column < 16; ++column) sum += picture.at(column, row);
            }
            CHECK(raio::length(sum) > 1);
        }
        ++count;
    }
    CHECK(count >= 4);
}
