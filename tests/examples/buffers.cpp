#include <array>
#include <string>

#include <doctest/doctest.h>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <render/camera.hpp>

#include "scenes.hpp"

// Depth, normal and index of every pixel of a small picture, compared with an analytic answer that shares nothing with
// the renderer: the camera looks along +z from (0, 0, -4), so that directions are (x, y, 1) and t is the depth along z.

namespace {

using namespace render;
using exact = boost::multiprecision::cpp_bin_float_50;

constexpr int width = 48, height = 36;

struct buffers {
    std::string index;  // one letter for each pixel, '.' where nothing is hit
    std::vector<number> depth;
    std::vector<vec3> normal;
};

/// The letters are given in the order of the file.
buffers rendered_buffers(const scene& s, const std::string& letters) {
    const world world(s);
    const camera camera(s.camera, width, height);
    // The world sorts its objects by shape; their pigments still tell which one each was.
    buffers result;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            hit_record rec;
            const bool met = world.hit(camera.through(column, row, {0, 0}, {0, 0}), 0, raio::infinity<number>, rec);
            result.index += met ? letters[world.scene().objects[rec.index].pigment] : '.';
            result.depth.push_back(met ? rec.t : raio::infinity<number>);
            result.normal.push_back(met ? rec.normal : vec3(0));
        }
    }
    return result;
}

/// The direction of a pixel: the picture is 2 tan(30 degrees) high, row 0 at its top, column 0 at its left where x is
/// least.
vec3 direction_of(int column, int row) {
    const number tall = 2 * std::tan(60.0 * raio::pi<number> / 360), wide = tall * width / height;
    return {wide / 2 - wide * (width - 1 - column) / width, tall * (height - 1 - row) / height - tall / 2, 1};
}

}  // namespace

TEST_CASE("a camera that looks along z sends every pixel's ray where the course's formula says") {
    const camera camera(camera_description{.eye = {0, 0, -4}, .look_at = origin}, width, height);
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const ray r = camera.through(column, row, {0, 0}, {0, 0});
            CHECK(r.origin == vec3(0, 0, -4));
            CHECK(r.direction == direction_of(column, row));
        }
    }
}

TEST_CASE("a disc, a box and a plane across the view have exactly the depth, normal and index of similar triangles") {
    const raio::disc<number> disc{{-1, 0.5, -1}, {0, 0, -1}, 0.75};
    const raio::box<number> box{{0.25, -1, 0}, {1.75, 1, 1}};
    const raio::plane<number> wall{{0, 0, 5}, {0, 0, 3}};
    const buffers found = rendered_buffers(
        scene_of({{wall, color(1), lambertian{}}, {box, color(1), lambertian{}}, {disc, color(1), lambertian{}}}),
        "wbd");

    std::array<int, 3> pixels{};
    for (std::size_t i = 0; i < found.depth.size(); ++i) {
        const vec3 d = direction_of(static_cast<int>(i % width), static_cast<int>(i / width));
        const auto coordinate = [&](number x, int depth) { return exact(x) * depth; };
        const exact dx = coordinate(d.x, 3) + 1, dy = coordinate(d.y, 3) - exact(0.5);
        const exact x = coordinate(d.x, 4), y = coordinate(d.y, 4);
        const bool in_disc = dx * dx + dy * dy <= exact(0.75) * exact(0.75);
        const bool in_front = x >= exact(0.25) && x <= exact(1.75) && abs(y) <= 1;
        // The left side of the box, x = 0.25, is seen where the ray gets there between its front and its back.
        const exact side_t = d.x > 0 ? exact(0.25) / exact(d.x) : exact(0);
        const bool in_side = !in_front && side_t >= 4 && side_t <= 5 && abs(exact(d.y) * side_t) <= 1;

        const char letter = in_disc ? 'd' : in_front || in_side ? 'b' : 'w';
        CHECK(found.index[i] == letter);
        CHECK(found.depth[i] == (in_disc ? 3 : in_front ? 4 : in_side ? static_cast<number>(side_t) : 9));
        CHECK(found.normal[i] == (in_side && !in_disc ? vec3(-1, 0, 0) : vec3(0, 0, -1)));
        ++pixels[letter == 'd' ? 0 : letter == 'b' ? 1 : 2];
    }
    for (const int count : pixels) CHECK(count > 50);  // each is seen
}

TEST_CASE("spheres have the depth of the quadratic formula in 75 digits, to 4 ulp, and the normal to 2") {
    struct ball {
        raio::sphere<number> sphere;
        char letter;
    };
    const std::vector<ball> balls{
        {{{0.5, 0.25, 0}, 1}, 'a'}, {{{-0.75, -0.5, 0.5}, 1.25}, 'b'}, {{{0, 0, 1e3}, 997}, 'c'}};
    std::vector<painted> objects;
    std::string letters;
    for (const ball& b : balls) {
        objects.push_back({b.sphere, color(1), lambertian{}});
        letters += b.letter;
    }
    const buffers found = rendered_buffers(scene_of(objects), letters);

    for (std::size_t i = 0; i < found.depth.size(); ++i) {
        using exact3 = std::array<exact, 3>;
        const vec3 direction = direction_of(static_cast<int>(i % width), static_cast<int>(i / width));
        const exact3 d{direction.x, direction.y, 1};
        char letter = '.';
        exact nearest = 0;
        exact3 normal{};
        for (const ball& b : balls) {
            const exact3 o{-exact(b.sphere.center.x), -exact(b.sphere.center.y), -4 - exact(b.sphere.center.z)};
            const auto dot = [](const exact3& p, const exact3& q) -> exact {
                return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
            };
            const exact a = dot(d, d), half_b = dot(o, d),
                        c = dot(o, o) - exact(b.sphere.radius) * exact(b.sphere.radius);
            const exact discriminant = half_b * half_b - a * c;
            if (discriminant < 0) continue;
            const exact t = (-half_b - sqrt(discriminant)) / a;
            if (letter != '.' && t >= nearest) continue;
            letter = b.letter;
            nearest = t;
            for (std::size_t axis = 0; axis < 3; ++axis)
                normal[axis] = (o[axis] + t * d[axis]) / exact(b.sphere.radius);
        }
        CHECK(found.index[i] == letter);
        if (letter == '.') continue;
        const auto depth = static_cast<number>(nearest);
        // (The ground is a thousand in radius, and its roundings are of that size.)
        CHECK(std::abs(found.depth[i] - depth) <= 0x1p-52 * (4 * depth + 1000));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const number component = found.normal[i][static_cast<glm::length_t>(axis)];
            CHECK(std::abs(component - static_cast<number>(normal[axis])) <= 0x1p-49);
        }
    }
}
