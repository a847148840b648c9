#include "shape_reader.hpp"

#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <glm/vector_relational.hpp>
#include <raio/compose/csg.hpp>
#include <raio/shape/box.hpp>

#include "shape_readings.hpp"

namespace render {
namespace {

using any_solid = raio::any_solid<number>;
using transform = raio::transform<number>;

shape read_shape(tokens& in, int depth);

/// What several solids are together, two by two, so that the tree of them is as flat as it can be.
any_solid combined(std::span<const any_solid> parts, any_solid (*combine)(any_solid, any_solid)) {
    if (parts.size() == 1) return parts.front();
    const std::size_t half = parts.size() / 2;
    return combine(combined(parts.first(half), combine), combined(parts.subspan(half), combine));
}

any_solid united(any_solid a, any_solid b) { return raio::union_of(std::move(a), std::move(b)); }
any_solid intersected(any_solid a, any_solid b) { return raio::intersection_of(std::move(a), std::move(b)); }

any_solid read_solid(tokens& in, int depth) {
    const shape s = read_shape(in, depth + 1);
    const auto* any = std::get_if<any_shape>(&s);
    if (!any || !any->solid()) in.fail("a shape without an inside", "a solid to combine with others");
    return *any->solid();
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

shape_readings all_shapes() {
    shape_readings all{
        {"union", read_union},
        {"intersection", read_intersection},
        {"difference", read_difference},
        {"mesh", [](tokens& in, int) -> shape { in.fail("a mesh inside of another shape", "one that stands alone"); }},
    };
    all.merge(flat_shapes());
    all.merge(polyhedra());
    all.merge(shapes_about_an_axis());
    all.merge(algebraic_shapes());
    all.merge(distance_shapes());
    return all;
}

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

number determinant(const transform& map) { return raio::dot(map.x, raio::cross(map.y, map.z)); }

/// The transforms that stand before a shape, if there are any, the last one applied first.
std::optional<transform> read_transforms(tokens& in) {
    if (!transforms.contains(in.peek())) return {};
    transform map;
    while (transforms.contains(in.peek())) map = map * choose(in, transforms, "a transform")(in);
    const number volume = std::abs(determinant(map));
    if (!(volume > 1e-150 && volume < 1e150 && raio::norm1(map.origin) < 1e150)) {
        in.fail("transforms that lead out of the range of numbers", "scales nearer to 1");
    }
    return map;
}

shape read_shape_under(const std::optional<transform>& map, tokens& in, int depth) {
    static const shape_readings shapes = all_shapes();
    static const std::string otherwise = joined({"; or a transform: ", names_of(transforms)});
    const shape bare = choose(in, shapes, "a shape", otherwise)(in, depth);
    if (!map) return bare;
    return std::visit([&](const auto& s) { return any_shape(s).under(*map); }, bare);
}

shape read_shape(tokens& in, int depth) {
    expect_not_too_deep(in, depth);
    const auto map = read_transforms(in);
    return read_shape_under(map, in, depth);
}

/// The triangles of a mesh, scaled, then moved, then mapped.
std::vector<shape> read_mesh(tokens& in, const meshes& known, const transform& map) {
    const std::string name(in.expect_word("the file of a mesh"));
    const vec3 offset = vector(in, "the offset of a mesh");
    const number scale = in.expect_number("the scale of a mesh", positive);
    const auto placed = [&](const vec3& p) {
        const vec3 at = map.point(p * scale + offset);
        if (raio::norm1(at) > 1e50) in.fail("a mesh that reaches beyond 1e50", "a lesser scale or offset");
        return at;
    };
    const bool mirrored = determinant(map) < 0;  // corners change places, so that what was outside stays there
    std::vector<shape> triangles;
    for (const auto& [a, b, c] : known.load(known.folder / name)) {
        triangles.push_back(raio::triangle<number>{placed(a), placed(mirrored ? c : b), placed(mirrored ? b : c)});
    }
    return triangles;
}

}  // namespace

void expect_not_too_deep(tokens& in, int depth) {
    constexpr int deepest = 100;
    if (depth > deepest)
        in.fail(joined({"a shape that stands in more than ", std::to_string(deepest), " others"}), "fewer");
}

/// A box that is more than a face.
raio::box<number> read_clip(tokens& in, std::string_view of) {
    const vec3 min = vector(in, joined({"the minimum of ", of})), max = vector(in, joined({"the maximum of ", of}));
    if (!glm::all(glm::lessThan(min, max))) {
        in.fail(joined({"a minimum that is not below the maximum of ", of}), "the lesser coordinates first");
    }
    return {min, max};
}

std::vector<shape> read_shapes(tokens& in, const meshes& known) {
    const auto map = read_transforms(in);
    if (in.peek() != "mesh") return {read_shape_under(map, in, 0)};
    in.expect_word("a mesh");
    return read_mesh(in, known, map.value_or(transform{}));
}

}  // namespace render
