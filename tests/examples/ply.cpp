#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <string_view>

#include <doctest/doctest.h>
#include <render/ply.hpp>

#include <raio/math/vec.hpp>

#include "errors.hpp"

using namespace render;

namespace {

using vec3 = raio::vec3<double>;

std::string ply_error(std::string_view text) {
    return error_of([&] { parse_ply(text, "test.ply"); });
}

/// The header of four vertices and some faces, eleven lines.
std::string header(std::string_view format, std::string_view faces = "1") {
    return joined({"ply\nformat ", format, " 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\n",
                   "property double y\nproperty short z\nproperty uchar red\nelement face ", faces,
                   "\nproperty list uchar int vertex_indices\nend_header\n"});
}
const std::string vertices = "0 0 0 255\n1 0 0 255\n1 1 -2 0\n0 1 0 0\n";

template <class Number>
void put(std::string& bytes, Number value, bool big) {
    char raw[sizeof(Number)];
    std::memcpy(raw, &value, sizeof(Number));
    std::string stored(raw, sizeof(Number));
    if (big != (std::endian::native == std::endian::big)) stored.assign(stored.rbegin(), stored.rend());
    bytes += stored;
}

std::string binary(bool big, std::int32_t last_corner = 3) {
    std::string bytes = header(big ? "binary_big_endian" : "binary_little_endian");
    const double corners[][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, -2}, {0, 1, 0}};
    for (const auto& [x, y, z] : corners) {
        put(bytes, static_cast<float>(x), big), put(bytes, y, big), put(bytes, static_cast<std::int16_t>(z), big);
        put(bytes, std::uint8_t{255}, big);
    }
    put(bytes, std::uint8_t{4}, big);
    for (const std::int32_t corner : {0, 1, 2, last_corner}) put(bytes, corner, big);
    return bytes;
}

}  // namespace

TEST_CASE("a PLY file says the same in text and in bytes of either order") {
    for (const std::string& text : {header("ascii") + vertices + "4 0 1 2 3\n", binary(false), binary(true)}) {
        REQUIRE(is_ply(text));
        const auto triangles = parse_ply(text, "test.ply");
        REQUIRE(triangles.size() == 2);
        CHECK(triangles[0].b == vec3(1, 0, 0));
        CHECK(triangles[0].c == vec3(1, 1, -2));
        CHECK(triangles[1].a == vec3(0, 0, 0));
        CHECK(triangles[1].c == vec3(0, 1, 0));
    }
    CHECK_FALSE(is_ply("v 0 0 0\n"));
    CHECK_FALSE(is_ply("plywood\n"));
}

TEST_CASE("lines of a PLY file may end with \\r alone, also before data that begin with \\n") {
    std::string text = header("ascii") + vertices + "4 0 1 2 3\n";
    std::ranges::replace(text, '\n', '\r');
    REQUIRE(is_ply(text));
    CHECK(parse_ply(text, "test.ply").size() == 2);

    std::string bytes =
        "ply\rformat binary_little_endian 1.0\relement vertex 3\rproperty uchar x\rproperty uchar y\r"
        "property uchar z\relement face 1\rproperty list uchar uchar vertex_indices\rend_header\r";
    bytes += {'\n', 0, 0, 1, 0, 0, 0, 1, 0, 3, 0, 1, 2};
    CHECK(parse_ply(bytes, "test.ply").at(0).a == vec3(10, 0, 0));
}

TEST_CASE("strips of triangles turn the same way, -1 ends them, and what is without area is left out") {
    const auto strip = [&](std::string_view corners) {
        return parse_ply(joined({"ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                                 "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
                                 "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n",
                                 corners}),
                         "test.ply");
    };
    const auto area = [](const raio::triangle<double>& t) { return raio::cross(t.b - t.a, t.c - t.a).z; };
    for (const std::string_view corners : {"4 0 1 2 3", "7 0 1 2 -1 1 3 2", "9 0 0 0 1 2 3 3 3 3", "5 0 0 1 2 3"}) {
        CAPTURE(corners);
        const auto triangles = strip(corners);
        REQUIRE(triangles.size() == 2);
        CHECK(area(triangles[0]) == (corners.starts_with("5") ? -1 : 1));  // a corner more turns it over
        CHECK(area(triangles[1]) == area(triangles[0]));
    }
    CHECK(error_of([&] { strip("3 0 1 4"); }) ==
          "test.ply:14: found a corner that is no vertex in the tristrips 0, expected the number of one of the 4 "
          "vertices before it, from 0");
    CHECK(error_of([&] { strip("2 0 1"); }) == "test.ply:9: found no face, expected a PLY file with faces");
}

TEST_CASE("elements that no surface is made of are passed over") {
    const auto triangles = parse_ply(
        "ply\r\nformat ascii 1.0\r\nobj_info none\r\nelement vertex 3\r\nproperty uint32 id\r\nproperty float32 z\r\n"
        "property float64 y\r\nproperty float64 x\r\nelement edge 1\r\nproperty list uint8 float weights\r\n"
        "element face 1\r\nproperty list uint int vertex_index\r\nend_header\r\n"
        "7 3 2 1\r\n8 0 0 1e-7\r\n9 1 0 0\r\n2 .5 .5\r\n3 0 1 2\r\n",
        "test.ply");
    REQUIRE(triangles.size() == 1);
    CHECK(triangles[0].a == vec3(1, 2, 3));
    CHECK(triangles[0].b == vec3(1e-7, 0, 0));
}

TEST_CASE("a wrong PLY file is named with its line") {
    struct {
        std::string name, text, message;
    } const rows[] = {
        {"only a name", "ply\n", "1: found the end of the file, expected end_header"},
        {"no format", "ply\nelement vertex 0\nend_header\n",
         "3: found no format, expected a line that says which, before end_header"},
        {"an unknown format", header("text"),
         "2: found 'text', expected a format: ascii, binary_big_endian, binary_little_endian"},
        {"an unknown statement", "ply\nelements vertex 3\n",
         "2: found 'elements', expected a comment, element, end_header, format or property"},
        {"a property of nothing", "ply\nproperty float x\n",
         "2: found a property of nothing, expected an element before it"},
        {"an unknown type", "ply\nelement vertex 1\nproperty real x\n",
         "3: found 'real', expected a type: char, double, float, float32, float64, int, int16, int32, int8, short, "
         "uchar, uint, uint16, uint32, uint8, ushort"},
        {"more faces than bytes", header("ascii", "1000000") + vertices,
         "9: found a count of face that the file has no room for, expected at most 87"},
        {"half a face", header("ascii", "0.5"),
         "9: found a count of face that the file has no room for, expected at most 50"},
        {"no face", header("ascii", "0") + vertices, "11: found no face, expected a PLY file with faces"},
        {"a vertex without height",
         "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
         "end_header\n0 0\n",
         "3: found a vertex without the property z, expected that one"},
        {"a list for a coordinate",
         "ply\nformat ascii 1.0\nelement vertex 1\nproperty list int float x\n"
         "property float y\nproperty float z\nend_header\n1 0 0 0\n",
         "3: found a list of coordinates, expected one number for each"},
        {"an element of nothing", "ply\nformat ascii 1.0\nelement material 1\nend_header\n0\n",
         "3: found an element without properties, expected some"},
        {"a word", header("ascii") + "0 0 0 255\n1 0 zero 255\n",
         "13: found 'zero', expected a number for a property of the vertex 1"},
        {"two corners", header("ascii") + vertices + "2 0 1\n",
         "16: found fewer than three corners in the face 0, expected three or more"},
        {"a corner too far", header("ascii") + vertices + "3 0 1 4\n",
         "16: found a corner that is no vertex in the face 0, "
         "expected the number of one of the 4 vertices before it, from 0"},
        {"half a corner", header("ascii") + vertices + "3 0 1 0.5\n",
         "16: found a corner that is no vertex in the face 0, "
         "expected the number of one of the 4 vertices before it, from 0"},
        {"a list without end", header("ascii") + vertices + "1000000 0 1 2\n",
         "16: found a list that the file has no room for in the face 0, expected a count of what follows"},
        {"a list below nothing", header("ascii") + vertices + "-3 0 1 2\n",
         "16: found a list that the file has no room for in the face 0, expected a count of what follows"},
        {"the end of the text", header("ascii") + vertices + "3 0 1",
         "16: found the end of the file, expected a number for a property of the face 0"},
        {"the end of the bytes", binary(false).substr(0, binary(false).size() - 2),
         "9: found the end of the file in the face 0, expected more of it"},
        {"a corner too far, in bytes", binary(true, 4),
         "9: found a corner that is no vertex in the face 0, "
         "expected the number of one of the 4 vertices before it, from 0"},
        {"a coordinate beyond the numbers of scenes", header("ascii") + "0 0 1e60 0\n",
         "12: found '1e60', expected 0 or a magnitude from 1e-50 to 1e50 for a property of the vertex 0"},
    };
    for (const auto& row : rows) {
        CAPTURE(row.name);
        CHECK(ply_error(row.text) == "test.ply:" + row.message);
    }
    std::string not_a_number = binary(false);
    not_a_number.replace(header("binary_little_endian").size(), 4, "\xff\xff\xff\x7f");
    CHECK(ply_error(not_a_number) ==
          "test.ply:4: found a coordinate out of range in the vertex 0, expected 0 or a magnitude from 1e-50 to 1e50");
}
