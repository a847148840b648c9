#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include <raio/shape/signed_distance.hpp>

#include "shape_readings.hpp"

namespace render {
namespace {

/// Below 0 inside of a solid, above 0 outside, and nowhere steeper than a distance. What is made of such functions here
/// is again not steeper, so that none has to state how steep it is.
using distance_function = std::function<number(const vec3&)>;
using distance_reading = std::function<distance_function(tokens&, int depth)>;

distance_function read_function(tokens& in, int depth);

number distance_to_block(const vec3& half_edges, const vec3& from_center) {
    const vec3 beyond = glm::abs(from_center) - half_edges;
    return raio::length(glm::max(beyond, vec3(0))) + std::min(std::max({beyond.x, beyond.y, beyond.z}), 0.0);
}

/// The lesser of both, and less where they are nearly equal, so that the joint is round (a quadratic there, as in
/// Quilez, "Smooth minimum", 2013). Its slope is a mean of both slopes.
number blended(number a, number b, number width) {
    const number overlap = std::max(width - std::abs(a - b), 0.0);
    return std::min(a, b) - overlap * overlap / (4 * width);
}

distance_function read_ball(tokens& in, int) {
    const vec3 center = vector(in, "the centre of a ball");
    const number radius = in.expect_number("the radius of a ball", positive);
    return [=](const vec3& p) { return raio::length(p - center) - radius; };
}

distance_function read_block(tokens& in, int) {
    const vec3 center = vector(in, "the centre of a block");
    const vec3 half_edges = vector(in, "the half edges of a block", positive);
    return [=](const vec3& p) { return distance_to_block(half_edges, p - center); };
}

/// Schoen's gyroid, nearly: sin x cos y + sin y cos z + sin z cos x, whose slope is sqrt(3) at most (Cauchy and Schwarz
/// for each of its components).
distance_function read_gyroid(tokens& in, int) {
    const number frequency = 2 * raio::pi<number> / in.expect_number("the period of a gyroid", positive);
    return [=](const vec3& p) {
        const vec3 angle = p * frequency, s = glm::sin(angle), c = glm::cos(angle);
        return (s.x * c.y + s.y * c.z + s.z * c.x) / (std::sqrt(3.0) * frequency);
    };
}

distance_function read_offset(tokens& in, int depth) {
    const number reach = in.expect_number("the distance of an offset");
    return [reach, of = read_function(in, depth + 1)](const vec3& p) { return of(p) - reach; };
}

distance_function read_shell(tokens& in, int depth) {
    const number thickness = in.expect_number("the thickness of a shell", positive);
    return [thickness, of = read_function(in, depth + 1)](const vec3& p) { return std::abs(of(p)) - thickness / 2; };
}

/// What `join` makes of the values of several functions, one after the other.
template <class Join>
distance_function read_joined(tokens& in, int depth, Join join) {
    auto parts = section(in, "distance functions", [&] { return read_function(in, depth + 1); });
    if (parts.size() < 2) in.fail("less than two distance functions to join", "at least two");
    return [parts = std::move(parts), join](const vec3& p) {
        number joined = parts.front()(p);
        for (const distance_function& part : std::span(parts).subspan(1)) joined = join(joined, part(p));
        return joined;
    };
}

distance_function read_blend(tokens& in, int depth) {
    const number width = in.expect_number("the width of a blend", positive);
    return read_joined(in, depth, [width](number a, number b) { return blended(a, b, width); });
}

const by_name<distance_reading> functions{
    {"ball", read_ball},
    {"block", read_block},
    {"gyroid", read_gyroid},
    {"offset", read_offset},
    {"shell", read_shell},
    {"blend", read_blend},
    {"union",
     [](auto& in, int depth) { return read_joined(in, depth, [](number a, number b) { return std::min(a, b); }); }},
    {"intersection",
     [](auto& in, int depth) { return read_joined(in, depth, [](number a, number b) { return std::max(a, b); }); }},
    {"difference",
     [](auto& in, int depth) { return read_joined(in, depth, [](number a, number b) { return std::max(a, -b); }); }},
};

distance_function read_function(tokens& in, int depth) {
    expect_not_too_deep(in, depth);
    return choose(in, functions, "a distance function")(in, depth);
}

shape read_signed_distance(tokens& in, int depth) {
    const auto [min, max] = read_clip(in, "the box of a signed distance");
    const distance_function inner = read_function(in, depth + 1);
    const vec3 center = (min + max) * 0.5, half_edges = (max - min) * 0.5;
    const auto clipped = [=](const vec3& p) { return std::max(inner(p), distance_to_block(half_edges, p - center)); };
    const number tolerance = raio::length(max - min) * 1e-5;
    return raio::signed_distance{raio::aabb<number>{min, max}, tolerance, number(1), clipped};
}

}  // namespace

shape_readings distance_shapes() { return {{"signed_distance", read_signed_distance}}; }

}  // namespace render
