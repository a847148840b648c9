#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <locale>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <raio/raio.hpp>
#include <render/reader.hpp>

#include "reader_text.hpp"

namespace {

using namespace render;

template <class Shape>
Shape only_shape(const std::string& description) {
    const scene s = read({.objects = "1  0 0 " + description});
    REQUIRE(s.objects.size() == 1);
    const shape& only = s.objects[0].shape;
    if constexpr (std::same_as<Shape, raio::triangle<number>>) {
        return std::get<Shape>(only);
    } else {
        const auto& any = std::get<any_shape>(only);
        if constexpr (std::same_as<Shape, raio::any_primitive<number>>) {
            return any;
        } else if constexpr (std::same_as<Shape, raio::any_solid<number>>) {
            return any.solid().value();
        } else {
            const Shape* kept = any.as<Shape>();
            REQUIRE(kept);
            return *kept;
        }
    }
}

template <class Material>
Material only_material(const std::string& description) {
    const scene s = read({.materials = "1  " + description});
    REQUIRE(s.materials.size() == 1);
    REQUIRE(std::holds_alternative<Material>(s.materials[0]));
    return std::get<Material>(s.materials[0]);
}

bool same(const raio::spans<number, raio::any_number>& found, const std::vector<raio::interval<number>>& expected) {
    return std::ranges::equal(found, expected, [](const auto& a, const auto& b) {
        return std::abs(a.min - b.min) < 1e-12 && std::abs(a.max - b.max) < 1e-12;
    });
}

}  // namespace

TEST_CASE("the camera is read in the order eye, look-at, up, field of view") {
    const camera_description camera = read({.camera = "0 30 -400\n0 10 -100\n0 1 0\n60.5"}).camera;
    CHECK(camera.eye == vec3(0, 30, -400));
    CHECK(camera.look_at == vec3(0, 10, -100));
    CHECK(camera.up == vec3(0, 1, 0));
    CHECK(camera.vertical_field_of_view == 60.5);
    CHECK(camera.aperture == 0);
}

TEST_CASE("lights have position, colour and attenuation") {
    const auto lights = read({.lights = "2\n1 2 3  .4 .5 .6  1 0.001 0.000001\n-1 -2 -3  1 1 1  0 0 1"}).lights;
    REQUIRE(lights.size() == 2);
    CHECK(lights[0].position == vec3(1, 2, 3));
    CHECK(lights[0].intensity == color(.4, .5, .6));
    CHECK(lights[0].attenuation == std::array{1.0, 0.001, 0.000001});
    CHECK(lights[1].position == vec3(-1, -2, -3));
    CHECK(lights[1].attenuation == std::array{0.0, 0.0, 1.0});
}

TEST_CASE("pigments are solid, checker or texture") {
    std::vector<std::filesystem::path> loaded;
    const auto load = [&](const std::filesystem::path& path) {
        loaded.push_back(path);
        return texture{1, 1, {10, 20, 30}};
    };
    const scene_text text{.pigments =
                              "4 solid .44 .25 .04\n"
                              "checker .8 .7 .6  1 1 .9  40\n"
                              "texture pictures/wood.png  0 0.012 0.006 0  0.013 0 0.006 1\n"
                              "texture pictures/wood.png  1 2 3 4  5 6 7 8"};
    const auto pigments = parse_scene(text.joined(), "scenes/test.txt", {load, square}).pigments;
    REQUIRE(pigments.size() == 4);
    CHECK(std::get<solid>(pigments[0]).value == color(.44, .25, .04));
    CHECK(std::get<checker>(pigments[1]).even == color(.8, .7, .6));
    CHECK(std::get<checker>(pigments[1]).odd == color(1, 1, .9));
    CHECK(std::get<checker>(pigments[1]).size == 40);

    const auto &first = std::get<textured>(pigments[2]), &second = std::get<textured>(pigments[3]);
    CHECK(first.p == std::array{0.0, 0.012, 0.006, 0.0});
    CHECK(first.q == std::array{0.013, 0.0, 0.006, 1.0});
    CHECK(first.image->texels == std::vector<std::uint8_t>{10, 20, 30});
    // A picture is looked for in the scene's folder, and read once.
    CHECK(loaded == std::vector<std::filesystem::path>{"scenes/pictures/wood.png"});
    CHECK(first.image == second.image);
}

TEST_CASE("a material of seven numbers is the course's") {
    const auto finish = only_material<phong>("0.2 0.8 0.6 80  0.3 0.4 1.06");
    CHECK(finish.ambient == 0.2);
    CHECK(finish.diffuse == 0.8);
    CHECK(finish.specular == 0.6);
    CHECK(finish.exponent == 80);
    CHECK(finish.reflected == 0.3);
    CHECK(finish.transmitted == 0.4);
    CHECK(finish.refractive_index == 1.06);
    CHECK(only_material<phong>("1 0 0 0  0 0 0").refractive_index == 0);  // of no meaning where nothing is transmitted
}

TEST_CASE("lines may end with \\n, \\r\\n or \\r: a comment ends there, and errors count them") {
    const std::string text = scene_text{.camera = "0 0 5  0 0 0  0 1 0  60  # from the front"}.joined();
    for (const std::string_view end : {"\n", "\r\n", "\r"}) {
        std::string lines;
        for (const char c : text) c == '\n' ? lines += end : lines += c;
        CHECK(parse_scene(lines, "test.txt", no_files).objects.size() == 1);
        CHECK_THROWS_WITH(parse_scene(lines + "end", "test.txt", no_files),
                          doctest::Contains("test.txt:6: found 'end'"));
    }
}

TEST_CASE("materials may be given by name") {
    only_material<lambertian>("lambertian");
    CHECK(only_material<metal>("metal 0.25").fuzz == 0.25);
    CHECK(only_material<dielectric>("dielectric 1.5").refractive_index == 1.5);
    CHECK(only_material<emissive>("emissive 4 3 0").radiance == color(4, 3, 0));
}

TEST_CASE("objects have the pigment and material of their indices") {
    const auto objects = read({.pigments = "2 solid 1 0 0 solid 0 1 0",
                               .materials = "3 lambertian metal 0 1 0 0 0 0 0 0",
                               .objects = "2  1 2 sphere 0 0 0 1  0 1 sphere 0 0 0 2"})
                             .objects;
    REQUIRE(objects.size() == 2);
    CHECK(objects[0].pigment == 1);
    CHECK(objects[0].material == 2);
    CHECK(objects[1].pigment == 0);
    CHECK(objects[1].material == 1);
}

TEST_CASE("every shape of the course is read") {
    const auto sphere = only_shape<raio::sphere<number>>("sphere 1 2 3 4");
    CHECK(sphere.center == vec3(1, 2, 3));
    CHECK(sphere.radius == 4);

    const auto plane = only_shape<raio::plane<number>>("plane 1 2 3  4 5 6");
    CHECK(plane.point == vec3(1, 2, 3));
    CHECK(plane.normal == vec3(4, 5, 6));

    const auto circle = only_shape<raio::disc<number>>("circle 1 2 3  4 5 6  7");
    CHECK(circle.center == vec3(1, 2, 3));
    CHECK(circle.normal == vec3(4, 5, 6));
    CHECK(circle.radius == 7);

    const auto triangle = only_shape<raio::triangle<number>>("triangle 1 2 3  4 5 6  7 8 0");
    CHECK(triangle.a == vec3(1, 2, 3));
    CHECK(triangle.b == vec3(4, 5, 6));
    CHECK(triangle.c == vec3(7, 8, 0));

    const auto cylinder = only_shape<raio::cylinder<number>>("cylinder 1 2 3  0 -8 0  0.5 10");
    CHECK(cylinder.base == vec3(1, 2, 3));
    CHECK(cylinder.top == vec3(1, -8, 3));
    CHECK(cylinder.radius == 0.5);

    const auto polyhedron = only_shape<raio::convex_polyhedron<number>>("polyhedron 2  0 1 0 -5  1 2 3 4");
    REQUIRE(polyhedron.planes.size() == 2);
    CHECK(polyhedron.planes[0].normal == vec3(0, 1, 0));
    CHECK(polyhedron.planes[0].offset == -5);
    CHECK(polyhedron.planes[1].normal == vec3(1, 2, 3));
    CHECK(polyhedron.planes[1].offset == 4);
}

TEST_CASE("shapes that the course has not are read") {
    const auto disc = only_shape<raio::disc<number>>("disc 1 2 3  4 5 6  7");
    CHECK(disc.center == vec3(1, 2, 3));
    CHECK(disc.normal == vec3(4, 5, 6));
    CHECK(disc.radius == 7);

    const auto box = only_shape<raio::box<number>>("box -1 0 -3  1 0 3");  // flat, which is a wall
    CHECK(box.min == vec3(-1, 0, -3));
    CHECK(box.max == vec3(1, 0, 3));

    const auto tube = only_shape<raio::open_cylinder<number>>("open_cylinder 1 2 3  0 0 2  0.5 10");
    CHECK(tube.base == vec3(1, 2, 3));
    CHECK(tube.top == vec3(1, 2, 13));
    CHECK(tube.radius == 0.5);

    const auto saddle = only_shape<raio::any_primitive<number>>("bilinear_patch 0 0 0  1 0 0  0 1 0  1 1 1");
    CHECK(saddle.occluded(ray{{0.5, 0.25, 0}, {0, 0, 1}}, 0.125, 0.125));

    const auto hill = only_shape<raio::any_primitive<number>>("heightfield 0 0 4 2  3 2  0 0 0  2 2 2");
    CHECK(hill.occluded(ray{{3, 1, 5}, {0, 0, -1}}, 4, 4));

    const auto pear = only_shape<raio::any_solid<number>>("round_cone 0 0 0  0 0 5  1 4");
    CHECK(same(pear.spans(ray{{0, 0, -5}, {0, 0, 1}}), {{4, 14}}));

    const auto wall = only_shape<raio::parallelogram<number>>("parallelogram 1 2 3  4 5 6  7 8 10");
    CHECK(wall.corner == vec3(1, 2, 3));
    CHECK(wall.edge_u == vec3(4, 5, 6));
    CHECK(wall.edge_v == vec3(7, 8, 10));

    const auto torus = only_shape<raio::torus<number>>("torus 1 2 3  4 5 6  7 0.5");
    CHECK(torus.center == vec3(1, 2, 3));
    CHECK(torus.axis == vec3(4, 5, 6));
    CHECK(torus.major_radius == 7);
    CHECK(torus.minor_radius == 0.5);
}

TEST_CASE("shapes are read as the fields that raio has") {
    const auto solid = [](const std::string& words, const ray& r) {
        return only_shape<raio::any_solid<number>>("scale 1 1 1 " + words).spans(r);
    };
    const ray up{{0, -8, 0}, {0, 1, 0}}, beside{{1, -8, 1}, {0, 1, 0}};
    CHECK(same(solid("capsule 0 -1 0  0 2 0  0.5", up), {{6.5, 10.5}}));
    CHECK(same(solid("bezier_curve 0 -1 0  0 0 0  0 1 0  0 2 0  0.5 0.5 0.5 1", up), {{6.5, 11}}));
    CHECK(same(solid("cone 0 -1 0  0 2 0  3", up), {{7, 10}}));
    CHECK(same(solid("paraboloid 0 -1 0  0 1 0  2", beside), {{8, 9}}));
    CHECK(same(solid("hyperboloid 0 -1 0  0 1 0  3 5", beside), {{7, 9}}));
    CHECK(same(solid("two_sheet_hyperboloid 0 -1 0  0 1 0  0.5 3", up), {{7, 7.5}, {8.5, 9}}));
    CHECK(same(solid("ellipsoid 0 1 0  1 3 2", up), {{6, 12}}));
    CHECK(same(solid("frustum 0 -1 0  0 2 0  3 1", up), {{7, 10}}));
    CHECK(same(solid("oriented_box 0 1 0  2 0 2  -2 0 2  0 1 0", beside), {{8, 10}}));
    CHECK(same(solid("tetrahedron -1 0 -1  3 0 -1  -1 0 3  -1 4 -1", up), {{8, 10}}));
    CHECK(same(solid("pyramid 4  -2 0 -2  2 0 -2  2 0 2  -2 0 2  0 2 0", beside), {{8, 9}}));
    CHECK(same(solid("prism 3  -2 0 -2  4 0 -2  -2 0 4  0 5 0", beside), {{8, 13}}));
    CHECK(same(solid("regular_solid 8  0 1 0  2", up), {{7, 11}}));

    CHECK(same(solid("quadric -3 -3 -3  3 3 3  1 1 1  0 0 0  0 0 0  -4", up), {{6, 10}}));
    CHECK(same(solid("quadric -9 -9 -9  9 9 9  0 0 0  0 0 1  0 1 0  0", up), {{-1, 8}}));
    CHECK(same(solid("algebraic -3 -3 -3  3 3 3  2  1 0 4 0  -1 0 0 0", up), {{7, 9}}));
    CHECK(same(solid("algebraic -3 -3 -3  3 3 3  2  -1 0 8 0  1 0 0 0", up), {{5, 7}, {9, 11}}));

    CHECK(same(solid("steiner 1 0 1  9", {{8, 7, 8}, {-1, -1, -1}}), {{4, 7}}));
    CHECK(same(solid("blob 0.5625 2  0 -3 0 2 1  0 3 0 2 1", up), {{4, 6}, {10, 12}}));
    CHECK(same(solid("blob 0.5625 2  capsule 0 -3 0  0 1 0  2 1  0 6 0 2 1", up), {{4, 10}, {13, 15}}));
    CHECK(same(solid("teardrop 0 -1 0  0 3 0  1", up), {{7, 11}}));

    const auto saddle =
        only_shape<raio::any_primitive<number>>("open_quadric -3 -3 -3  3 3 3  0 0 0  0 0 1  0 -1 0  0");
    CHECK_FALSE(saddle.occluded(ray{{0, 0, -8}, {0, 1, 0}}, 0, 9));
    CHECK(saddle.occluded(ray{{2, -8, 1}, {0, 1, 0}}, 0, 9));
    const auto plane = only_shape<raio::any_primitive<number>>("open_algebraic -3 -3 -3  3 3 3  1  1 0 1 0");
    CHECK(plane.occluded(up, 8, 8));

    const auto pot = only_shape<raio::any_primitive<number>>("surface_of_revolution 0 1 0  0 2 0  3  0 0  2 0  1 1.5");
    CHECK(pot.occluded(ray{{-8, 1, 0}, {1, 0, 0}}, 6, 6));
    CHECK(pot.occluded(ray{{-8, 4, 0}, {1, 0, 0}}, 7, 7));
    CHECK_FALSE(pot.occluded(ray{{-8, 4.5, 0}, {1, 0, 0}}, 0, 100));

    const auto dish =
        only_shape<raio::any_primitive<number>>("curved_surface_of_revolution 0 1 0  0 2 0  4  0 0  1 0  2 3  3 9");
    CHECK(dish.occluded(ray{{-8, 9, 0}, {1, 0, 0}}, 6, 6));
    CHECK_FALSE(dish.occluded(ray{{-8, 0.5, 0}, {1, 0, 0}}, 0, 100));

    const auto ring = only_shape<raio::any_primitive<number>>("ring 0 1 0  0 2 0  1 3");
    CHECK(ring.occluded(ray{{2, 0, 0}, {0, 1, 0}}, 1, 1));
    CHECK_FALSE(ring.occluded(ray{{0.5, 0, 0}, {0, 1, 0}}, 0, 10));
}

TEST_CASE("distance functions are read, and what is made of them") {
    const ray up{{0, -8, 0}, {0, 1, 0}};
    const auto inside = [&](const std::string& words) {
        const auto solid =
            only_shape<raio::any_solid<number>>("scale 1 1 1 signed_distance -4 -4 -4  4 4 4 " + words).spans(up);
        return std::vector(solid.begin(), solid.end());
    };
    // A crossing is where the function is within 1e-5 of the box's diagonal, and left at most as much beyond.
    const auto near = [](const auto& found, const std::vector<raio::interval<number>>& expected) {
        return std::ranges::equal(found, expected, [](const auto& a, const auto& b) {
            return std::abs(a.min - b.min) < 3e-4 && std::abs(a.max - b.max) < 3e-4;
        });
    };
    CHECK(near(inside("ball 0 1 0 2"), {{7, 11}}));
    CHECK(near(inside("ball 0 4 0 2"), {{10, 12}}));  // as far as the box goes
    CHECK(near(inside("block 0 1 0  5 2 1"), {{7, 11}}));
    CHECK(near(inside("offset 0.5 block 0 1 0  1 2 1"), {{6.5, 11.5}}));
    CHECK(near(inside("offset -0.5 ball 0 1 0 2"), {{7.5, 10.5}}));
    CHECK(near(inside("shell 1 ball 0 0 0 2"), {{5.5, 6.5}, {9.5, 10.5}}));
    CHECK(near(inside("union 3 ball 0 -2 0 1  ball 9 9 9 1  ball 0 2 0 1"), {{5, 7}, {9, 11}}));
    CHECK(near(inside("intersection 2 ball 0 0 0 3  block 0 2 0  1 1 1"), {{9, 11}}));
    CHECK(near(inside("difference 3 ball 0 0 0 3  ball 0 0 0 1  ball 0 3 0 1"), {{5, 7}, {9, 10}}));
    // Along the y axis a gyroid is a sine.
    CHECK(near(inside("intersection 2 block 0 0 0  1 3 1  gyroid 4"), {{6, 8}, {10, 11}}));
    // Halfway between two equal balls a blend adds a quarter of its width to both.
    CHECK(near(inside("blend 1 2 ball 0 -1 0 1  ball 0 1 0 1"), {{6, 10}}));
    CHECK(near(inside("blend 1 2 ball 0 -1.24 0 1  ball 0 1.24 0 1"), {{5.76, 10.24}}));
    // With 0.45 to both it is 0.2 - s^2 at s from there.
    const double s = std::sqrt(0.2);
    CHECK(near(inside("blend 1 2 ball 0 -1.45 0 1  ball 0 1.45 0 1"), {{5.55, 8 - s}, {8 + s, 10.45}}));
    CHECK(near(inside("blend 1 2 ball 0 -1.5 0 1  ball 0 1.5 0 1"), {{5.5, 7.5}, {8.5, 10.5}}));
    // Where the box cuts, its face is the surface.
    const auto half = only_shape<raio::any_solid<number>>("signed_distance -4 -4 -4  4 4 4  ball 0 4 0 2");
    hit_record rec;
    REQUIRE(half.hit(ray{{0.5, 9, 0}, {0, -1, 0}}, 0, raio::infinity<number>, rec));
    CHECK(std::abs(rec.t - 5) < 3e-4);
    CHECK(rec.normal.y > 0.999);
}

TEST_CASE("transforms stand before any shape, and the last one is applied first") {
    // Twice as long along z, which is then turned to x, and moved.
    const auto ellipsoid =
        only_shape<raio::any_solid<number>>("translate 1 2 3  rotate 0 2 0 90  scale 1 1 2  sphere 0 0 0 1");
    CHECK(same(ellipsoid.spans(ray{{0, 2, 3}, {1, 0, 0}}), {{-1, 3}}));
    CHECK(same(ellipsoid.spans(ray{{1, 0, 3}, {0, 1, 0}}), {{1, 3}}));
    CHECK(same(ellipsoid.spans(ray{{1, 2, 0}, {0, 0, 1}}), {{2, 4}}));

    const auto disc = only_shape<raio::any_primitive<number>>("scale 1 -1 1 translate 0 3 0 disc 0 0 0  0 1 0  1");
    CHECK(disc.occluded(ray{{0, 0, 0}, {0, -1, 0}}, 2.9, 3.1));
    CHECK_FALSE(disc.occluded(ray{{0, 0, 0}, {0, 1, 0}}, 0, 10));
}

TEST_CASE("solids are combined, and combinations again") {
    const ray along{{0, 0, 0}, {1, 0, 0}};
    const auto inside = [&](const std::string& words) {
        return only_shape<raio::any_solid<number>>(words).spans(along);
    };
    CHECK(same(inside("union 3 sphere 1 0 0 1  sphere 2 0 0 1  sphere 6 0 0 1"), {{0, 3}, {5, 7}}));
    CHECK(same(inside("intersection 3 sphere 1 0 0 1  sphere 2 0 0 1  box 1.5 -1 -1 9 1 1"), {{1.5, 2}}));
    CHECK(
        same(inside("difference 3 box 0 -1 -1 9 1 1  sphere 2 0 0 1  sphere 8 0 0 0.5"), {{0, 1}, {3, 7.5}, {8.5, 9}}));
    CHECK(same(inside("difference 2 union 2 sphere 1 0 0 1 sphere 4 0 0 1 "
                      "translate 1 0 0 intersection 2 sphere 0 0 0 0.5 polyhedron 1 1 0 0 0"),
               {{0, 0.5}, {1, 2}, {3, 5}}));
    CHECK(same(inside("difference 2 sphere 1 0 0 1 sphere 1 0 0 1"), {}));
    CHECK(same(inside("union 2 torus 0 0 0 0 0 1 4 1 sphere 0 0 0 1"), {{-5, -3}, {-1, 1}, {3, 5}}));
}

TEST_CASE("statements after the objects may come in any order") {
    const scene s = read({.statements = "aperture 0.1 12\nfog .5 .6 .7  0.01\nbackground .1 .2 .3"});
    CHECK(s.camera.aperture == 0.1);
    CHECK(s.camera.focus_distance == 12);
    CHECK(s.fog.value == color(.5, .6, .7));
    CHECK(s.fog.density == 0.01);
    CHECK(s.background.bottom == color(.1, .2, .3));
    CHECK(s.background.top == color(.1, .2, .3));

    const scene outdoors = read({.statements = "sky 1 1 1  .5 .7 1"});
    CHECK(outdoors.background.bottom == color(1, 1, 1));
    CHECK(outdoors.background.top == color(.5, .7, 1));
}

TEST_CASE("objects beyond their count are left out") {
    const scene s = read({.statements = "0 0 sphere 0 0 0 2\nbackground 1 1 1\n0 0 plane 0 0 0 0 1 0"});
    CHECK(s.objects.size() == 1);
    CHECK(s.background.top == color(1, 1, 1));
}

TEST_CASE("a scene without statements is black, clear and sharp") {
    const scene s = read({});
    CHECK(s.background.bottom == color(0));
    CHECK(s.background.top == color(0));
    CHECK(s.fog.density == 0);
    CHECK(s.camera.aperture == 0);
}

TEST_CASE("sections may be empty") {
    const scene s = read({.lights = "0", .pigments = "0", .materials = "0", .objects = "0"});
    CHECK(s.lights.empty());
    CHECK(s.pigments.empty());
    CHECK(s.materials.empty());
    CHECK(s.objects.empty());
}

TEST_CASE("any white space separates, and comments reach to the end of their line") {
    const std::string text =
        "# a scene\n\r\n0 0 5\r\n0 0 0\t0 1 0 # up\n60\f 0 #no light\v 7\n1 solid 1 0 0 1 lambertian\n#\n"
        "1 0 0 sphere 0 0 0 2 # without a line's end";
    const scene s = parse_scene(text, "test.txt", no_files);
    CHECK(s.camera.vertical_field_of_view == 60);
    CHECK(s.lights.empty());
    REQUIRE(s.objects.size() == 1);
    CHECK(std::get<any_shape>(s.objects[0].shape).as<raio::sphere<number>>()->radius == 2);
}

TEST_CASE("a byte order mark is skipped") {
    CHECK(read({.camera = "\xef\xbb\xbf"
                          "1 2 3  0 0 0  0 1 0  60"})
              .camera.eye == vec3(1, 2, 3));
}

TEST_CASE("numbers are written in any common way, whatever the locale") {
    struct comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale(), new comma));
    const vec3 eye = read({.camera = "+1.5 -.5e1 7.  0 0 0  0 1 0  6E+1"}).camera.eye;
    std::locale::global(before);
    CHECK(eye == vec3(1.5, -5, 7));
    CHECK(read({.camera = "1e50 1e-50 -0  0 0 0  0 1 0  60"}).camera.eye == vec3(1e50, 1e-50, 0));
}
