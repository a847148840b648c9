#pragma once

#include <concepts>
#include <functional>
#include <type_traits>
#include <variant>

#include <raio/shape/box.hpp>

#include "reading.hpp"

/// \file
/// What shapes are read with, and the shapes that are made of nothing but numbers, family by family.

namespace render {

/// Reads what follows the name of a shape, which stands in so many others.
using shape_reading = std::function<shape(tokens&, int depth)>;
using shape_readings = by_name<shape_reading>;

shape_readings flat_shapes();
shape_readings polyhedra();
shape_readings shapes_about_an_axis();
shape_readings algebraic_shapes();
shape_readings distance_shapes();

/// Shapes may stand in others only so deep that no ray runs out of stack.
void expect_not_too_deep(tokens& in, int depth);

/// A box that is more than a face.
raio::box<number> read_clip(tokens& in, std::string_view of);

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

/// A shape whose fields stand in the order that raio has them in.
template <class Shape, class... Fields>
shape_reading plain(std::string_view name, Fields... fields) {
    return [=](tokens& in, int) { return shape(Shape{fields(in, name)...}); };
}

/// A shape between two points, which have to differ, and then lengths.
template <class Shape, class... Lengths>
shape_reading upright(std::string_view name, point low, point high, Lengths... lengths) {
    return [=](tokens& in, int) {
        const vec3 base = low(in, name), top = high(in, name);
        if (base == top) in.fail(joined({name, " without height"}), "two points that differ");
        return shape(Shape{base, top, lengths(in, name)...});
    };
}

}  // namespace render
