#pragma once

#include <cmath>
#include <variant>

#include "scene.hpp"

namespace render {

inline color color_at(const solid& s, const vec3&, coding) { return s.value; }

inline color color_at(const checker& c, const vec3& point, coding) {
    const vec3 cube = point / c.size;
    const number count = std::floor(cube.x) + std::floor(cube.y) + std::floor(cube.z);
    return std::fmod(count, 2) == 0 ? c.even : c.odd;
}

inline color color_at(const textured& t, const vec3& point, coding as) {
    const auto along = [&](const std::array<number, 4>& k) {
        return k[0] * point.x + k[1] * point.y + k[2] * point.z + k[3];
    };
    return t.image->at(along(t.p), along(t.q), as);
}

/// The colour that a pigment has at a point.
inline color color_at(const pigment& p, const vec3& point, coding as) {
    return std::visit([&](const auto& kind) { return color_at(kind, point, as); }, p);
}

}  // namespace render
