#include <algorithm>
#include <span>
#include <string>

#include <glm/vector_relational.hpp>

#include <raio/shape/box.hpp>
#include <raio/shape/convex_polyhedron.hpp>
#include <raio/shape/polyhedra.hpp>

#include "shape_readings.hpp"

namespace render {
namespace {

shape read_box(tokens& in, int) {
    const raio::box<number> box{vector(in, "the minimum of a box"), vector(in, "the maximum of a box")};
    if (!glm::all(glm::lessThanEqual(box.min, box.max))) {
        in.fail("a minimum above the maximum of a box", "the lesser coordinates first");
    }
    if (box.area() == 0) in.fail("a box without area", "sizes that are 0 along one axis at most");
    return box;
}

shape read_polyhedron(tokens& in, int) {
    raio::convex_polyhedron<number> polyhedron;
    polyhedron.planes = section(in, "planes of a polyhedron", [&] {
        return raio::half_space<number>{direction(in, "the normal of a polyhedron's plane"),
                                        in.expect_number("the offset of a polyhedron's plane")};
    });
    if (polyhedron.planes.empty()) in.fail("a polyhedron without planes", "at least one");
    return polyhedron;
}

/// A polyhedron that was made of corners.
template <class Solid>
shape with_volume(tokens& in, const Solid& solid, std::string_view what) {
    if (!(solid.area() > 0)) in.fail(joined({what, " without volume"}), "corners that do not lie in one plane");
    return raio::convex_polyhedron<number>{{solid.planes.begin(), solid.planes.end()}};
}

shape read_oriented_box(tokens& in, int) {
    const vec3 center = vector(in, "the centre of an oriented box");
    constexpr auto what = "the half edges of an oriented box";
    const vec3 x = vector(in, what), y = vector(in, what), z = vector(in, what);
    return with_volume(in, raio::oriented_box(center, x, y, z), "an oriented box");
}

shape read_tetrahedron(tokens& in, int) {
    constexpr auto what = "the corners of a tetrahedron";
    const vec3 a = vector(in, what), b = vector(in, what), c = vector(in, what), d = vector(in, what);
    return with_volume(in, raio::tetrahedron(a, b, c, d), "a tetrahedron");
}

/// Calls `make` with an array of the corners that follow their number.
template <class Make, std::size_t N = 3>
shape over_polygon(tokens& in, std::span<const vec3> corners, Make make) {
    constexpr std::size_t most_corners = 12;
    if (corners.size() == N) {
        std::array<vec3, N> base;
        std::ranges::copy(corners, base.begin());
        return make(base);
    }
    if constexpr (N < most_corners) return over_polygon<Make, N + 1>(in, corners, make);
    in.fail(std::to_string(corners.size()) + " corners", "a base of 3 to " + std::to_string(most_corners));
}

shape read_pyramid(tokens& in, int) {
    const auto corners = section(in, "corners of a pyramid", [&] { return vector(in, "the corners of a pyramid"); });
    const vec3 apex = vector(in, "the apex of a pyramid");
    return over_polygon(in, corners,
                        [&](const auto& base) { return with_volume(in, raio::pyramid(base, apex), "a pyramid"); });
}

shape read_prism(tokens& in, int) {
    const auto corners = section(in, "corners of a prism", [&] { return vector(in, "the corners of a prism"); });
    const vec3 along = direction(in, "the edge of a prism");
    return over_polygon(in, corners,
                        [&](const auto& base) { return with_volume(in, raio::prism(base, along), "a prism"); });
}

shape read_regular_solid(tokens& in, int) {
    constexpr requirement platonic{"4, 6, 8, 12 or 20",
                                   [](double n) { return n == 4 || n == 6 || n == 8 || n == 12 || n == 20; }};
    const number faces = in.expect_number("the faces of a regular solid", platonic);
    const vec3 center = vector(in, "the centre of a regular solid");
    const number radius = in.expect_number("the radius of a regular solid", positive);
    const auto made = [&](const auto& solid) { return with_volume(in, solid, "a regular solid"); };
    if (faces == 4) return made(raio::regular_solid<4>(center, radius));
    if (faces == 6) return made(raio::regular_solid<6>(center, radius));
    if (faces == 8) return made(raio::regular_solid<8>(center, radius));
    if (faces == 12) return made(raio::regular_solid<12>(center, radius));
    return made(raio::regular_solid<20>(center, radius));
}

}  // namespace

shape_readings polyhedra() {
    return {
        {"box", read_box},
        {"polyhedron", read_polyhedron},
        {"oriented_box", read_oriented_box},
        {"tetrahedron", read_tetrahedron},
        {"pyramid", read_pyramid},
        {"prism", read_prism},
        {"regular_solid", read_regular_solid},
    };
}

}  // namespace render
