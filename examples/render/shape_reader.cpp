#include "shape_reader.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <string>

#include <glm/vector_relational.hpp>

#include "reading.hpp"

namespace render {
namespace {

using any_solid = raio::any_solid<number>;
using transform = raio::transform<number>;

/// Shapes may stand in others only so deep that no ray runs out of stack.
constexpr int deepest = 100;

shape read_shape(tokens& in, int depth);

/// Shapes that only some scenes have are kept as what they can do.
template <class Shape>
shape kept(Shape s) {
    if constexpr (std::constructible_from<shape, Shape>) {
        return s;
    } else if constexpr (raio::solid<Shape>) {
        return any_solid(std::move(s));
    } else {
        return raio::any_primitive<number>(std::move(s));
    }
}

// How one field of a shape is read; `name` says which, `of` whose.
struct point {
    std::string_view name;
    vec3 operator()(tokens& in, std::string_view of) const { return vector(in, joined({"the ", name, " of ", of})); }
};
struct axis {
    std::string_view name;
    vec3 operator()(tokens& in, std::string_view of) const { return direction(in, joined({"the ", name, " of ", of})); }
};
struct measure {
    std::string_view name;
    requirement must_be = positive;
    number operator()(tokens& in, std::string_view of) const {
        return in.expect_number(joined({"the ", name, " of ", of}), must_be);
    }
};

struct lengths {
    std::string_view name;
    vec3 operator()(tokens& in, std::string_view of) const {
        return vector(in, joined({"the ", name, " of ", of}), positive);
    }
};

using shape_reading = std::function<shape(tokens&, int depth)>;

/// A shape whose fields stand in the order that raio has them in.
template <class Shape, class... Fields>
shape_reading plain(std::string_view name, Fields... fields) {
    return [=](tokens& in, int) { return kept(Shape{fields(in, name)...}); };
}

constexpr requirement fraction{"a number between 0 and 1", [](double x) { return x > 0 && x < 1; }};

/// A shape between two points, which have to differ, and then lengths.
template <class Shape, class... Lengths>
shape_reading upright(std::string_view name, point low, point high, Lengths... lengths) {
    return [=](tokens& in, int) {
        const vec3 base = low(in, name), top = high(in, name);
        if (base == top) in.fail(joined({name, " without height"}), "two points that differ");
        return kept(Shape{base, top, lengths(in, name)...});
    };
}

template <class Cylinder>
shape read_cylinder(tokens& in, int) {
    const vec3 base = vector(in, "the base of a cylinder"), axis = direction(in, "the axis of a cylinder");
    const number radius = in.expect_number("the radius of a cylinder", positive);
    const number height = in.expect_number("the height of a cylinder", positive);
    const vec3 top = base + raio::normalize(axis) * height;
    if (top == base) in.fail("a height that is lost in the rounding of the base", "a higher cylinder");
    return Cylinder{base, top, radius};
}

shape read_ring(tokens& in, int) {
    const vec3 center = vector(in, "the centre of a ring"), normal = direction(in, "the normal of a ring");
    const number inner = in.expect_number("the inner radius of a ring", not_negative);
    const number outer = in.expect_number("the outer radius of a ring", positive);
    if (!(inner < outer)) in.fail("an inner radius that is not below the outer one", "the smaller radius first");
    return kept(raio::ring<number>{center, normal, inner, outer});
}

shape read_triangle(tokens& in, int) {
    constexpr auto what = "the corners of a triangle";
    const raio::triangle<number> triangle{vector(in, what), vector(in, what), vector(in, what)};
    if (triangle.area() == 0) in.fail("a triangle without area", "corners that are not on one line");
    return triangle;
}

shape read_bilinear_patch(tokens& in, int) {
    constexpr auto what = "the corners of a bilinear patch";
    const vec3 p00 = vector(in, what), p10 = vector(in, what), p01 = vector(in, what), p11 = vector(in, what);
    const vec3 middle = raio::cross(p11 - p00, p01 - p10), side = raio::cross(p10 - p00, p01 - p00);
    if (middle == vec3(0) && side == vec3(0)) {
        in.fail("a bilinear patch without area", "corners that are not on one line");
    }
    return kept(raio::bilinear_patch<number>{p00, p10, p01, p11});
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
    return kept(std::move(field));
}

shape read_parallelogram(tokens& in, int) {
    const vec3 corner = vector(in, "the corner of a parallelogram");
    constexpr auto what = "the edges of a parallelogram";
    const vec3 u = vector(in, what), v = vector(in, what);
    const raio::parallelogram<number> parallelogram{corner, u, v};
    if (parallelogram.area() == 0) in.fail("a parallelogram without area", "edges that are not on one line");
    return parallelogram;
}

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

/// A box that is more than a face.
raio::box<number> read_clip(tokens& in, std::string_view of) {
    const vec3 min = vector(in, joined({"the minimum of ", of})), max = vector(in, joined({"the maximum of ", of}));
    if (!glm::all(glm::lessThan(min, max))) {
        in.fail(joined({"a minimum that is not below the maximum of ", of}), "the lesser coordinates first");
    }
    return {min, max};
}

template <bool Closed>
shape read_quadric(tokens& in, int) {
    const auto [min, max] = read_clip(in, "the box of a quadric");
    constexpr auto what = "the coefficients of a quadric";
    const vec3 squares = vector(in, what), products = vector(in, what), linear = vector(in, what);
    const number constant = in.expect_number(what);
    if (squares == vec3(0) && products == vec3(0) && linear == vec3(0)) {
        in.fail("a quadric that is the same everywhere", "coefficients that are not all 0");
    }
    return kept(raio::quadric<number, Closed>{min, max, squares, products, linear, constant});
}

template <bool Closed>
shape read_algebraic(tokens& in, int) {
    constexpr unsigned highest = 8;
    const auto [min, max] = read_clip(in, "the box of an algebraic surface");
    unsigned degree = 0;
    const auto terms = section(in, "terms of an algebraic surface", [&] {
        raio::algebraic_term<number> term{};
        term.coefficient = in.expect_number("a coefficient of an algebraic surface");
        for (unsigned* power : {&term.x, &term.y, &term.z}) {
            constexpr requirement whole{"a whole number from 0 to 8",
                                        [](double x) { return x >= 0 && x <= highest && x == std::floor(x); }};
            *power = static_cast<unsigned>(in.expect_number("a power of an algebraic surface", whole));
        }
        const unsigned sum = term.x + term.y + term.z;
        if (sum > highest) in.fail("a term of degree " + std::to_string(sum), "at most 8");
        if (term.coefficient != 0) degree = std::max(degree, sum);
        return term;
    });
    if (degree == 0) in.fail("an algebraic surface that is the same everywhere", "a term with a power above 0");
    if (degree <= 4) return kept(raio::algebraic<number, 4, Closed>{min, max, terms});
    return kept(raio::algebraic<number, highest, Closed>{min, max, terms});
}

shape read_surface_of_revolution(tokens& in, int) {
    raio::surface_of_revolution<number> surface{
        vector(in, "the base of a surface of revolution"), direction(in, "the axis of a surface of revolution"), {}};
    surface.profile = section(in, "points of a profile", [&] {
        const number radius = in.expect_number("the radius of a profile's point", not_negative);
        return vec2{radius, in.expect_number("the height of a profile's point")};
    });
    if (!(surface.area() > 0)) in.fail("a profile that sweeps no area", "two points or more, not all on the axis");
    return kept(std::move(surface));
}

shape read_teardrop(tokens& in, int) {
    const vec3 bottom = vector(in, "the bottom of a teardrop"), tip = vector(in, "the tip of a teardrop");
    if (bottom == tip) in.fail("the bottom again", "another tip of a teardrop");
    return kept(raio::teardrop<number>{bottom, tip, in.expect_number("the radius of a teardrop", positive)});
}

shape read_blob(tokens& in, int) {
    raio::blob<number, 16> blob{{}, in.expect_number("the threshold of a blob", positive)};
    const auto components = section(in, "components of a blob", [&] {
        raio::metaball<number> m{vector(in, "the centre of a blob's component"), {}};
        m.radius = in.expect_number("the radius of a blob's component", positive);
        m.strength = in.expect_number("the strength of a blob's component");
        return m;
    });
    if (components.empty() || components.size() > blob.components.size()) {
        in.fail(std::to_string(components.size()) + " components", "a blob of 1 to 16");
    }
    std::ranges::copy(components, blob.components.begin());
    return kept(blob);
}

/// What several solids are together, two by two, so that the tree of them is as flat as it can be.
any_solid combined(std::span<const any_solid> parts, any_solid (*combine)(any_solid, any_solid)) {
    if (parts.size() == 1) return parts.front();
    const std::size_t half = parts.size() / 2;
    return combine(combined(parts.first(half), combine), combined(parts.subspan(half), combine));
}

any_solid united(any_solid a, any_solid b) { return raio::union_of(std::move(a), std::move(b)); }
any_solid intersected(any_solid a, any_solid b) { return raio::intersection_of(std::move(a), std::move(b)); }

any_solid read_solid(tokens& in, int depth) {
    return std::visit(
        [&]<class Shape>(const Shape& s) -> any_solid {
            if constexpr (raio::solid<Shape>) return s;
            in.fail("a shape without an inside", "a solid to combine with others");
        },
        read_shape(in, depth + 1));
}

std::vector<any_solid> read_solids(tokens& in, int depth, std::string_view what) {
    auto parts = section(in, what, [&] { return read_solid(in, depth); });
    if (parts.size() < 2) in.fail(joined({"less than two ", what}), "at least two");
    return parts;
}

shape read_union(tokens& in, int depth) { return combined(read_solids(in, depth, "solids of a union"), united); }

shape read_intersection(tokens& in, int depth) {
    return combined(read_solids(in, depth, "solids of an intersection"), intersected);
}

shape read_difference(tokens& in, int depth) {
    const std::vector<any_solid> parts = read_solids(in, depth, "solids of a difference");
    return any_solid(raio::difference_of(parts.front(), combined(std::span(parts).subspan(1), united)));
}

const shape_reading read_disc = plain<raio::disc<number>>("a disc", point{"centre"}, axis{"normal"}, measure{"radius"});

const by_name<shape_reading> shapes{
    {"sphere", plain<raio::sphere<number>>("a sphere", point{"centre"}, measure{"radius"})},
    {"ellipsoid", plain<raio::ellipsoid<number>>("an ellipsoid", point{"centre"}, lengths{"radii"})},
    {"plane", plain<raio::plane<number>>("a plane", point{"point"}, axis{"normal"})},
    {"circle", read_disc},
    {"disc", read_disc},
    {"ring", read_ring},
    {"triangle", read_triangle},
    {"box", read_box},
    {"cylinder", read_cylinder<raio::cylinder<number>>},
    {"open_cylinder", read_cylinder<raio::open_cylinder<number>>},
    {"bilinear_patch", read_bilinear_patch},
    {"heightfield", read_heightfield},
    {"parallelogram", read_parallelogram},
    {"polyhedron", read_polyhedron},
    {"round_cone", plain<raio::round_cone<number>>("a round cone", point{"base"}, point{"top"}, measure{"base radius"},
                                                   measure{"top radius"})},
    {"capsule", plain<raio::capsule<number>>("a capsule", point{"base"}, point{"top"}, measure{"radius"})},
    {"cone", upright<raio::cone<number>>("a cone", point{"base"}, point{"apex"}, measure{"radius"})},
    {"open_cone", upright<raio::open_cone<number>>("a cone", point{"base"}, point{"apex"}, measure{"radius"})},
    {"frustum", upright<raio::frustum<number>>("a frustum", point{"base"}, point{"top"}, measure{"base radius"},
                                               measure{"top radius", not_negative})},
    {"open_frustum", upright<raio::open_frustum<number>>("a frustum", point{"base"}, point{"top"},
                                                         measure{"base radius"}, measure{"top radius", not_negative})},
    {"paraboloid", upright<raio::paraboloid<number>>("a paraboloid", point{"vertex"}, point{"top"}, measure{"radius"})},
    {"open_paraboloid",
     upright<raio::open_paraboloid<number>>("a paraboloid", point{"vertex"}, point{"top"}, measure{"radius"})},
    {"hyperboloid", upright<raio::hyperboloid<number>>("a hyperboloid", point{"base"}, point{"top"},
                                                       measure{"waist radius"}, measure{"end radius"})},
    {"open_hyperboloid", upright<raio::open_hyperboloid<number>>("a hyperboloid", point{"base"}, point{"top"},
                                                                 measure{"waist radius"}, measure{"end radius"})},
    {"two_sheet_hyperboloid",
     upright<raio::two_sheet_hyperboloid<number>>("a hyperboloid", point{"base"}, point{"top"},
                                                  measure{"gap", fraction}, measure{"end radius"})},
    {"open_two_sheet_hyperboloid",
     upright<raio::open_two_sheet_hyperboloid<number>>("a hyperboloid", point{"base"}, point{"top"},
                                                       measure{"gap", fraction}, measure{"end radius"})},
    {"torus", plain<raio::torus<number>>("a torus", point{"centre"}, axis{"axis"}, measure{"major radius"},
                                         measure{"minor radius"})},
    {"oriented_box", read_oriented_box},
    {"tetrahedron", read_tetrahedron},
    {"pyramid", read_pyramid},
    {"prism", read_prism},
    {"regular_solid", read_regular_solid},
    {"quadric", read_quadric<true>},
    {"open_quadric", read_quadric<false>},
    {"algebraic", read_algebraic<true>},
    {"open_algebraic", read_algebraic<false>},
    {"surface_of_revolution", read_surface_of_revolution},
    {"steiner", plain<raio::steiner<number>>("a Steiner surface", point{"centre"}, measure{"size"})},
    {"teardrop", read_teardrop},
    {"blob", read_blob},
    {"union", read_union},
    {"intersection", read_intersection},
    {"difference", read_difference},
    {"mesh",
     [](tokens& in, int) -> shape {
         in.fail("a mesh inside of another shape", "one that stands alone, and has its own offset and scale");
     }},
};

const by_name<transform (*)(tokens&)> transforms{
    {"translate", [](tokens& in) { return raio::translation(vector(in, "the offset of a translation")); }},
    {"rotate",
     [](tokens& in) {
         const vec3 axis = direction(in, "the axis of a rotation");
         return raio::rotation(axis, in.expect_number("the angle of a rotation") * raio::pi<number> / 180);
     }},
    {"scale",
     [](tokens& in) {
         constexpr requirement not_zero{"a number other than 0", [](double x) { return x != 0; }};
         return raio::scaling(vector(in, "the factors of a scale", not_zero));
     }},
};

/// The transforms that stand before a shape, the last one applied first.
transform read_transforms(tokens& in) {
    transform map;
    while (transforms.contains(in.peek())) map = map * choose(in, transforms, "a transform")(in);
    const number volume = std::abs(raio::dot(map.x, raio::cross(map.y, map.z)));
    if (!(volume > 1e-150 && volume < 1e150 && raio::norm1(map.origin) < 1e150)) {
        in.fail("transforms that lead out of the range of numbers", "scales nearer to 1");
    }
    return map;
}

/// The shape under a map; still a solid if it is one.
shape transformed(const shape& bare, const transform& map) {
    return std::visit(
        [&]<class Shape>(const Shape& s) -> shape {
            if constexpr (raio::solid<Shape>)
                return any_solid(raio::transformed(any_solid(s), map));
            else
                return raio::any_primitive<number>(raio::transformed(raio::any_primitive<number>(s), map));
        },
        bare);
}

shape read_shape(tokens& in, int depth) {
    if (depth > deepest)
        in.fail(joined({"a shape that stands in more than ", std::to_string(deepest), " others"}), "fewer");
    const bool moved = transforms.contains(in.peek());
    const transform map = read_transforms(in);
    const shape bare = choose(in, shapes, "a shape")(in, depth);
    return moved ? transformed(bare, map) : bare;
}

/// The triangles of a mesh, scaled and then moved.
std::vector<shape> read_mesh(tokens& in, const meshes& known) {
    const std::string name(in.expect_word("the file of a mesh"));
    const vec3 offset = vector(in, "the offset of a mesh");
    const number scale = in.expect_number("the scale of a mesh", positive);
    const auto placed = [&](const vec3& p) {
        const vec3 at = p * scale + offset;
        if (raio::norm1(at) > 1e50) in.fail("a mesh that reaches beyond 1e50", "a lesser scale or offset");
        return at;
    };
    std::vector<shape> triangles;
    for (const auto& [a, b, c] : known.load(known.folder / name)) {
        triangles.push_back(raio::triangle<number>{placed(a), placed(b), placed(c)});
    }
    return triangles;
}

}  // namespace

std::vector<shape> read_shapes(tokens& in, const meshes& known) {
    if (in.peek() != "mesh") return {read_shape(in, 0)};
    in.expect_word("a mesh");
    return read_mesh(in, known);
}

}  // namespace render
