#include <algorithm>
#include <string>
#include <string_view>

#include <doctest/doctest.h>
#include <raio/shape/sphere.hpp>
#include <render/mesh.hpp>
#include <render/world.hpp>

#include "errors.hpp"
#include "reader_text.hpp"

using namespace render;

namespace {

std::string mesh_error(std::string_view text) {
    return error_of([&] { parse_mesh(text, "test.obj"); });
}

constexpr std::string_view four_vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

}  // namespace

TEST_CASE("the faces of a mesh are triangles, and larger ones are cut") {
    std::string mac = joined({four_vertices, "f 1 2 3 4\r"}), dos;
    for (const char c : mac) c == '\n' ? dos += "\r\n" : dos += c;
    std::ranges::replace(mac, '\n', '\r');
    for (const std::string& text : {
             joined({four_vertices, "f 1 2 3 4"}),
             joined({four_vertices, "f 1/1 2/2 3/3 4/4\n"}),
             joined({four_vertices, "f 1//9 2//9 3//9 4//9\r\n"}),
             joined({four_vertices, "f 1/1/1 2/1/1 3/1/1 4/1/1"}),
             joined({four_vertices, "f -4 -3 -2 -1"}),
             joined({four_vertices, "  f\t1 2\t3 4  "}),
             joined({four_vertices, "f 1 2\v3\f4"}),
             joined({four_vertices, "f 1 2 3\nf 1 3 4"}),
             joined({four_vertices, "f 1 2 3 4 # one face"}),
             joined({four_vertices, "f 1 2 3\\\n4\n"}),
             joined({four_vertices, "f 1 \\\r\n2 3 \\\r\n  4"}),
             joined({four_vertices, "# of C:\\meshes\\\nf 1 2 3 4"}),
             joined({"\xef\xbb\xbf", four_vertices, "f 1 2 3 4"}),  // the first vertex was lost, and all others shifted
             mac,                                                   // drew nothing
             dos,
         }) {
        CAPTURE(text);
        const auto triangles = parse_mesh(text, "test.obj");
        REQUIRE(triangles.size() == 2);
        CHECK(triangles[0].b == vec3(1, 0, 0));
        CHECK(triangles[0].c == vec3(1, 1, 0));
        CHECK(triangles[1].a == vec3(0, 0, 0));
        CHECK(triangles[1].c == vec3(0, 1, 0));
    }
}

TEST_CASE("what else a mesh says is passed over, and its numbers are the nearest doubles") {
    const auto triangles = parse_mesh(
        "# a comment\nmtllib none.mtl\no name\nv 0.1 1e-7 -.3 1 0.5 0.5 0.5\nvn 0 0 1\nvt 0 0\n"
        "v 1 0 0\n\ns off\nusemtl none\ng group\nv 0 1 0\nf 1 2 3\nl 1 2",
        "test.obj");
    REQUIRE(triangles.size() == 1);
    CHECK(triangles[0].a == vec3(0.1, 1e-7, -0.3));
}

TEST_CASE("a wrong mesh is named with its line") {
    struct {
        std::string name, text, message;
    } const rows[] = {
        {"nothing", "", "1: found no face, expected a Wavefront OBJ or PLY file with faces"},
        {"no face", std::string(four_vertices), "4: found no face, expected a Wavefront OBJ or PLY file with faces"},
        {"a word", "v 0 0 0\nv 1 y 0\n", "2: found 'y', expected a number for a coordinate of a vertex"},
        {"two coordinates", "\nv 0 0\nv 0 0 0\n",
         "2: found the end of the line, expected three coordinates of a vertex"},
        {"infinity", "v inf 0 0", "1: found 'inf', expected a number for a coordinate of a vertex"},
        {"two corners", "v 0 0 0\nf 1 1", "2: found a face with fewer than three corners, expected three or more"},
        {"a corner too far", "v 0 0 0\nf 1 1 2",
         "2: found a face with the corner 2, expected the number of one of the 1 vertices above"},
        {"a corner too far back", "v 0 0 0\nf 1 1 -2",
         "2: found a face with the corner -2, expected the number of one of the 1 vertices above"},
        {"a word for a corner", "v 0 0 0\nf 1 1 one",
         "2: found 'one', expected a corner of a face: the number of a vertex, alone or before slashes"},
        {"the corner 0", "v 0 0 0\nf 1 1 0",
         "2: found a face with the corner 0, expected the number of one of the 1 vertices above"},
        {"bytes", std::string("\0\xff\x01 f 1 2", 9),
         "1: found '\\x00\\xff\\x01', expected a statement of a polygonal Wavefront OBJ file, such as v or f"},
        {"a free-form surface", "v 0 0 0\nsurf 0 1 0 1 1 1 1 1",
         "2: found 'surf', expected a statement of a polygonal Wavefront OBJ file, such as v or f"},
        {"no corner", "v 0 0 0\nf\n", "2: found a face without corners, expected three or more"},
        {"no coordinate", "v\n", "1: found the end of the line, expected three coordinates of a vertex"},
        {"a word behind a vertex", "v 0 0 0 zero\n",
         "1: found 'zero', expected a number for what follows the coordinates of a vertex"},
        {"a continuation of nothing", "v 0 0 0\nf 1 1 1\\",
         "2: found '1\\', expected a corner of a face: the number of a vertex, alone or before slashes"},
        {"a backslash in a line", "v 0 0 0\nf 1 1 1\\ 1\n",
         "2: found '1\\', expected a corner of a face: the number of a vertex, alone or before slashes"},
        {"a fraction for a corner", "v 0 0 0\nf 1 1 1.5\n",
         "2: found '1.5', expected a corner of a face: the number of a vertex, alone or before slashes"},
        {"a slash too many", "v 0 0 0\nf 1 1 1/1/1/1\n",
         "2: found '1/1/1/1', expected a corner of a face: the number of a vertex, alone or before slashes"},
        {"the line after a continuation, and \\r alone", "v 0 \\\r0 0\r\rf 1 1 2\r",
         "4: found a face with the corner 2, expected the number of one of the 1 vertices above"},
    };
    for (const auto& row : rows) {
        CAPTURE(row.name);
        CHECK(mesh_error(row.text) == "test.obj:" + row.message);
    }
    CHECK_THROWS_WITH(read_mesh("none.obj"), "none.obj:1: found no such file, expected a Wavefront OBJ or PLY file");
}

TEST_CASE("a mesh is one object of the file and as many of the scene as it has triangles") {
    const scene s = read({.objects = "2  0 0 mesh square.obj  10 0 0  2   0 0 sphere 0 0 0 1"});
    REQUIRE(s.objects.size() == 3);
    const auto& triangle = std::get<raio::triangle<number>>(s.objects[1].shape);
    CHECK(triangle.a == vec3(10, 0, 0));
    CHECK(triangle.b == vec3(12, 2, 0));
    CHECK(std::get<any_shape>(s.objects[2].shape).as<raio::sphere<number>>());

    const world world(s);
    hit_record rec;
    REQUIRE(world.hit({{10.5, 1, 5}, {0, 0, -1}}, 0, raio::infinity<number>, rec));
    CHECK(rec.t == 5);
    CHECK(rec.index == 1);  // behind the other triangle; the sphere comes after those of a mesh
}

TEST_CASE("a mesh may be transformed, after its own scale and offset, and is never inside out") {
    const auto first = [](const std::string& words) {
        return std::get<raio::triangle<number>>(read({.objects = "1  0 0 " + words}).objects.at(0).shape);
    };
    const auto turned = first("translate 0 0 1  rotate 1 0 0 180  mesh square.obj  10 0 0  2");
    CHECK(raio::length(turned.a - vec3(10, 0, 1)) < 1e-14);
    CHECK(raio::length(turned.c - vec3(12, -2, 1)) < 1e-14);
    // From the side that was outside, where x and y are right-handed, both are entered.
    const ray from_outside{{0.5, 0.25, 5}, {0, 0, -1}}, to_the_mirrored{{-0.5, 0.25, 5}, {0, 0, -1}};
    hit_record rec;
    REQUIRE(first("mesh square.obj  0 0 0  1").hit(from_outside, 0, raio::infinity<number>, rec));
    CHECK(rec.front_face);
    REQUIRE(first("scale -1 1 1  mesh square.obj  0 0 0  1").hit(to_the_mirrored, 0, raio::infinity<number>, rec));
    CHECK(rec.front_face);
}
