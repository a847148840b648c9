#pragma once

#include <array>
#include <tuple>
#include <vector>

#include <raio/raio.hpp>

#include "support/oracle.hpp"
#include "support/random.hpp"

/// \file
/// What the shared tests know of a shape.

namespace raio::test {

/// Each test of a shape specialises this for every number type at once:
///
///     static auto fields(auto& shape);  // std::tie of its fields
///     static Shape random(random_numbers&, double size, vec3<double> place);  // one of that size at that place
///     static vec3<double> inner_point(const Shape&, random_numbers&);
///         // inside the solid, or on the surface: not at its edge
///     static vec3<double> special_point(const Shape&, vec3<double> from, random_numbers&);
///         // on a silhouette as seen from there, an edge, a vertex, a rim, an axis
///     static oracle distance(const Shape&, const vec3<oracle>&);
///         // to the surface, below 0 in a solid; for a shape in oracle numbers
///     static Shape grown(Shape);                       // optional, as the next ones: see accuracy.hpp
///     static constexpr bool touching_parts_are_one = true;
///     static bool lies_in_side(Shape, ray<oracle>);
///     static bool is_apex(Shape, vec3<oracle> point, oracle near);
template <class Shape>
struct subject;

/// Solids are entered and left; what is no solid is left for good, but for a tube, which is hit from within.
template <class Shape>
inline constexpr bool is_flat = !solid<Shape>;
template <class T>
inline constexpr bool is_flat<open_cylinder<T>> = false;
template <class T>
inline constexpr bool is_flat<open_cone<T>> = false;
template <class T>
inline constexpr bool is_flat<open_frustum<T>> = false;
template <class T>
inline constexpr bool is_flat<open_hyperboloid<T>> = false;
template <class T>
inline constexpr bool is_flat<open_two_sheet_hyperboloid<T>> = false;
template <class T>
inline constexpr bool is_flat<open_paraboloid<T>> = false;

/// Does a line that has left the shape never meet it again?
template <class Shape>
inline constexpr bool is_convex = true;
template <class T>
inline constexpr bool is_convex<torus<T>> = false;
template <class T>
inline constexpr bool is_convex<hyperboloid<T>> = false;
template <class T>
inline constexpr bool is_convex<open_hyperboloid<T>> = false;
template <class T>
inline constexpr bool is_convex<two_sheet_hyperboloid<T>> = false;
template <class T>
inline constexpr bool is_convex<open_two_sheet_hyperboloid<T>> = false;

template <class T>
vec3<double> to_double(const vec3<T>& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

// Calls `visit` with every number that something is made of, in order.
template <real T, class Visit>
void for_each_number(T& x, Visit visit) {
    visit(x);
}
template <class T, class Visit>
void for_each_number(vec3<T>& v, Visit visit) {
    visit(v.x), visit(v.y), visit(v.z);
}
template <class T, class Visit>
void for_each_number(half_space<T>& h, Visit visit) {
    for_each_number(h.normal, visit), visit(h.offset);
}
template <class T, class Visit>
void for_each_number(algebraic_term<T>& term, Visit visit) {
    visit(term.coefficient);
}
// A blob of two or three components; the others have no effect.
template <class T, class Visit>
void for_each_number(std::array<metaball<T>, 8>& components, Visit visit) {
    for (std::size_t i = 0; i < 3; ++i) {
        for_each_number(components[i].center, visit), visit(components[i].radius), visit(components[i].strength);
        for_each_number(components[i].axis, visit);
    }
}
template <class T, class Visit>
void for_each_number(ray<T>& r, Visit visit) {
    for_each_number(r.origin, visit), for_each_number(r.direction, visit);
}
template <class T, class Visit>
void for_each_number(transform<T>& m, Visit visit) {
    for (vec3<T>* v : {&m.x, &m.y, &m.z, &m.origin}) for_each_number(*v, visit);
}
template <class Item, class Visit>
void for_each_number(std::vector<Item>& items, Visit visit) {
    for (Item& item : items) for_each_number(item, visit);
}
template <primitive Shape, class Visit>
void for_each_number(Shape& shape, Visit visit) {
    std::apply([&](auto&... field) { (for_each_number(field, visit), ...); }, subject<Shape>::fields(shape));
}

// The same thing made of other numbers.
template <class U, class T>
requires(std::is_arithmetic_v<T>) U converted(const T& x) { return U(x); }
template <class U, class T>
vec3<U> converted(const vec3<T>& v) {
    return vec3<U>(v);
}
template <class U, class T>
ray<U> converted(const ray<T>& r) {
    return {vec3<U>(r.origin), vec3<U>(r.direction)};
}
template <class U, class T>
transform<U> converted(const transform<T>& m) {
    return {vec3<U>(m.x), vec3<U>(m.y), vec3<U>(m.z), vec3<U>(m.origin)};
}
template <class U, class T>
half_space<U> converted(const half_space<T>& h) {
    return {vec3<U>(h.normal), U(h.offset)};
}
template <class U, class T>
algebraic_term<U> converted(const algebraic_term<T>& term) {
    return {U(term.coefficient), term.x, term.y, term.z};
}
template <class U, class T>
metaball<U> converted(const metaball<T>& m) {
    return {vec3<U>(m.center), U(m.radius), U(m.strength), vec3<U>(m.axis)};
}
template <class U, template <class> class Item, class T>
std::vector<Item<U>> converted(const std::vector<Item<T>>& items) {
    std::vector<Item<U>> result;
    for (const Item<T>& item : items) result.push_back(converted<U>(item));
    return result;
}
template <class U, template <class> class Item, class T, std::size_t N>
std::array<Item<U>, N> converted(const std::array<Item<T>, N>& items) {
    std::array<Item<U>, N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = converted<U>(items[i]);
    return result;
}
template <class U, template <real, auto...> class Shape, real T, auto... Options>
auto converted(const Shape<T, Options...>& shape) {
    return std::apply([](const auto&... field) { return Shape<U, Options...>{converted<U>(field)...}; },
                      subject<Shape<T, Options...>>::fields(shape));
}
/// The same triangle; that 75 digits round as well does not matter where nothing is divided.
template <std::same_as<oracle> U, real T>
triangle<U> converted(const watertight_triangle<T>& s) {
    return {vec3<U>(s.a), vec3<U>(s.b), vec3<U>(s.c)};
}
template <class U, real T, std::size_t Degree, bool Closed>
algebraic<U, Degree, Closed> converted(const algebraic<T, Degree, Closed>& shape) {
    return {converted<U>(shape.min), converted<U>(shape.max), converted<U>(shape.terms)};
}
template <class U, real T>
convex_polyhedron<U> converted(const convex_polyhedron<T>& shape) {
    return {converted<U>(shape.planes)};
}

}  // namespace raio::test
