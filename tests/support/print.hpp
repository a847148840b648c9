#pragma once

#include <span>
#include <sstream>
#include <string>

#include "support/subject.hpp"

/// \file
/// Failing inputs in C++ as it stands in a table of cases, in hexadecimal, so that no bit is lost.

namespace raio::test {

template <class T>
requires(std::is_floating_point_v<T>) std::string literal(T x) {
    if (x != x) return "nan<T>";
    if (x - x != 0) return x < 0 ? "-infinity<T>" : "infinity<T>";
    std::ostringstream text;
    text << std::hexfloat << x << (std::is_same_v<T, float> ? "f" : "");
    return text.str();
}

/// Braces around what the numbers of something stand in.
template <class... Items>
std::string braced(const Items&... items) {
    std::string text;
    ((text += (text.empty() ? "{" : ", ") + items), ...);
    return text + "}";
}

template <class T>
std::string literal(const vec3<T>& v) {
    return braced(literal(v.x), literal(v.y), literal(v.z));
}
template <class T>
std::string literal(const vec2<T>& v) {
    return braced(literal(v.x), literal(v.y));
}
template <class T>
std::string literal(const ray<T>& r) {
    return braced(literal(r.origin), literal(r.direction));
}
template <class T>
std::string literal(const transform<T>& m) {
    return braced(literal(m.x), literal(m.y), literal(m.z), literal(m.origin));
}
template <class T>
std::string literal(const half_space<T>& h) {
    return braced(literal(h.normal), literal(h.offset));
}
template <class T>
std::string literal(const algebraic_term<T>& term) {
    return braced(literal(term.coefficient), std::to_string(term.x), std::to_string(term.y), std::to_string(term.z));
}
template <class T>
std::string literal(const metaball<T>& m) {
    return braced(literal(m.center), literal(m.radius), literal(m.strength), literal(m.axis));
}
/// Braces around all of them.
template <class Items>
std::string list_of_literals(const Items& items) {
    std::string text;
    for (const auto& item : items) text += (text.empty() ? "{" : ", ") + literal(item);
    return text + "}";
}
template <template <class> class Item, class T>
std::string literal(const std::vector<Item<T>>& items) {
    return list_of_literals(items);
}
template <class T>
std::string literal(const std::array<metaball<T>, 8>& components) {
    return list_of_literals(std::span(components).template first<3>());
}
template <primitive Shape>
std::string literal(const Shape& shape) {
    return std::apply([](const auto&... field) { return braced(literal(field)...); }, subject<Shape>::fields(shape));
}

template <class T>
std::string literal(const hit_record<T>& rec) {
    return ".t = " + literal(rec.t) + ", .point = " + literal(rec.point) + ", .normal = " + literal(rec.normal) +
           ", .uv = " + literal(rec.uv) + ", .error = " + literal(rec.error) +
           ", .front_face = " + (rec.front_face ? "true" : "false");
}

}  // namespace raio::test
