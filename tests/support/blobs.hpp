#pragma once

#include "support/subject.hpp"

namespace raio::test {

template <class T>
std::string literal(const std::array<metaball<T>, 8>& components);

}  // namespace raio::test

#include "support/algebraics.hpp"

namespace raio::test {

// A blob of two or three components; the others have no effect.
template <class T, class Visit>
void for_each_number(std::array<metaball<T>, 8>& components, Visit visit) {
    for (std::size_t i = 0; i < 3; ++i) {
        for_each_number(components[i].center, visit), visit(components[i].radius), visit(components[i].strength);
        for_each_number(components[i].axis, visit);
    }
}

template <class T>
std::string literal(const std::array<metaball<T>, 8>& components) {
    std::string text;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& [center, radius, strength, axis] = components[i];
        text +=
            (text.empty() ? "{" : ", ") + braced(literal(center), literal(radius), literal(strength), literal(axis));
    }
    return text + "}";
}

template <class U, class T>
blob<U> converted(const blob<T>& s) {
    blob<U> result{{}, U(s.threshold)};
    for (std::size_t i = 0; i < 8; ++i) {
        result.components[i] = {vec3<U>(s.components[i].center), U(s.components[i].radius), U(s.components[i].strength),
                                vec3<U>(s.components[i].axis)};
    }
    return result;
}

template <class T>
inline constexpr bool is_convex<blob<T>> = false;

}  // namespace raio::test
