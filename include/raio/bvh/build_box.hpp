#pragma once

#include <raio/push_macros.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <raio/aabb.hpp>
#include <raio/number/simd.hpp>

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// A box as the builders keep it: eight floats, the low corner and minus the high one, so that the hull of two boxes is
/// the smaller of each pair of numbers, in one instruction where there are eight lanes. After each corner there is room
/// for a number of something else's, which a hull leaves undefined.
struct build_box {
    using numbers = pack<float, 8>;
    static constexpr float none = std::numeric_limits<float>::infinity();

    numbers v{none};

    float low(unsigned axis) const { return v[axis]; }
    float high(unsigned axis) const { return -v[axis + 4]; }
    float extent(unsigned axis) const { return high(axis) - low(axis); }

    std::uint32_t id() const { return std::bit_cast<std::uint32_t>(v[3]); }
    void set_id(std::uint32_t id) { v.set(3, std::bit_cast<float>(id)); }
    std::uint32_t note() const { return std::bit_cast<std::uint32_t>(v[7]); }
    void set_note(std::uint32_t note) { v.set(7, std::bit_cast<float>(note)); }

    void include(const build_box& other) { v = numbers::min(v, other.v); }

    /// Half of the surface: what the probability is proportional to that a ray meets the box.
    float half_area() const {
        const float x = v[0] + v[4], y = v[1] + v[5], z = v[2] + v[6];  // each with a minus, of which two cancel
        return x * y + y * z + z * x;
    }

    unsigned largest_axis() const {
        const unsigned xy = extent(0) >= extent(1) ? 0 : 1;
        return extent(xy) >= extent(2) ? xy : 2;
    }

    /// The largest coordinate, by its magnitude.
    float reach() const {
        float most = 0;
        for (const unsigned i : {0u, 1u, 2u, 4u, 5u, 6u}) most = max(most, abs(v[i]));
        return most;
    }
};

inline build_box hull(build_box a, const build_box& b) {
    a.include(b);
    return a;
}

/// Twice the centre of a box, along one axis.
inline float center2(const build_box& box, unsigned axis) { return box.v[axis] - box.v[axis + 4]; }

/// What turns a distance of at most `extent` into one of so many equal cells, counted from 0. Two roundings may
/// lengthen the quotient by 2^-23 of it: without them the farthest place falls into the last cell. An extent too small
/// to divide by leaves everything in the first.
inline float cells_per_length(float cells, float extent) {
    return extent > 0x1p-100f ? cells * (1 - 0x1p-22f) / extent : 0;
}

/// The largest float that is not above x, up to one: floats are taken as they are.
template <class T>
float rounded_down(T x) {
    if constexpr (std::same_as<T, float>) return x;
    const float nearest = static_cast<float>(x);
    if (static_cast<T>(nearest) <= x) return nearest;
    return std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

template <class T>
float rounded_up(T x) {
    return -rounded_down(-x);
}

/// The box in floats, rounded outwards.
template <class T>
build_box to_build_box(const aabb<T>& box, std::uint32_t id = 0) {
    build_box b;
    const float corners[] = {
        rounded_down(box.min.x),  rounded_down(box.min.y),  rounded_down(box.min.z),  std::bit_cast<float>(id),
        rounded_down(-box.max.x), rounded_down(-box.max.y), rounded_down(-box.max.z), 0};
    b.v = build_box::numbers::load(corners);
    return b;
}

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
