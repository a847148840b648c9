#include <raio/shape/bilinear_patch.hpp>
#include <raio/shape/disc.hpp>
#include <raio/shape/heightfield.hpp>
#include <raio/shape/parallelogram.hpp>
#include <raio/shape/plane.hpp>
#include <raio/shape/ring.hpp>
#include <raio/shape/triangle.hpp>

#include "shape_readings.hpp"

namespace render {
namespace {

shape read_ring(tokens& in, int) {
    const vec3 center = vector(in, "the centre of a ring"), normal = direction(in, "the normal of a ring");
    const number inner = in.expect_number("the inner radius of a ring", not_negative);
    const number outer = in.expect_number("the outer radius of a ring", positive);
    if (!(inner < outer)) in.fail("an inner radius that is not below the outer one", "the smaller radius first");
    return raio::ring<number>{center, normal, inner, outer};
}

shape read_triangle(tokens& in, int) {
    constexpr auto what = "the corners of a triangle";
    const raio::triangle<number> triangle{vector(in, what), vector(in, what), vector(in, what)};
    if (triangle.area() == 0) in.fail("a triangle without area", "corners that are not on one line");
    return triangle;
}

shape read_parallelogram(tokens& in, int) {
    const vec3 corner = vector(in, "the corner of a parallelogram");
    constexpr auto what = "the edges of a parallelogram";
    const vec3 u = vector(in, what), v = vector(in, what);
    const raio::parallelogram<number> parallelogram{corner, u, v};
    if (parallelogram.area() == 0) in.fail("a parallelogram without area", "edges that are not on one line");
    return parallelogram;
}

shape read_bilinear_patch(tokens& in, int) {
    constexpr auto what = "the corners of a bilinear patch";
    const vec3 p00 = vector(in, what), p10 = vector(in, what), p01 = vector(in, what), p11 = vector(in, what);
    const vec3 middle = raio::cross(p11 - p00, p01 - p10), side = raio::cross(p10 - p00, p01 - p00);
    if (middle == vec3(0) && side == vec3(0)) {
        in.fail("a bilinear patch without area", "corners that are not on one line");
    }
    return raio::bilinear_patch<number>{p00, p10, p01, p11};
}

shape read_heightfield(tokens& in, int) {
    const auto [min_x, min_y, max_x, max_y] = numbers<4>(in, "the corners of a heightfield");
    if (!(min_x < max_x && min_y < max_y)) in.fail("a heightfield without width", "the lesser coordinates first");
    const std::size_t columns = in.expect_count("columns of a heightfield"),
                      rows = in.expect_count("rows of a heightfield");
    if (columns < 2 || rows < 2) in.fail("a heightfield without a cell", "two columns and two rows at least");
    raio::heightfield<number> field{{min_x, min_y}, {max_x, max_y}, static_cast<std::uint32_t>(columns), {}};
    for (std::size_t left = columns * rows; left > 0; --left) {
        field.heights.push_back(in.expect_number("a height of a heightfield"));
    }
    return field;
}

}  // namespace

shape_readings flat_shapes() {
    const shape_reading read_disc =
        plain<raio::disc<number>>("a disc", point{"centre"}, axis{"normal"}, measure{"radius"});
    return {
        {"plane", plain<raio::plane<number>>("a plane", point{"point"}, axis{"normal"})},
        {"circle", read_disc},
        {"disc", read_disc},
        {"ring", read_ring},
        {"triangle", read_triangle},
        {"parallelogram", read_parallelogram},
        {"bilinear_patch", read_bilinear_patch},
        {"heightfield", read_heightfield},
    };
}

}  // namespace render
