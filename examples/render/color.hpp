#pragma once

#include <cstdint>

#include <raio/math/vec.hpp>

namespace render {

/// Red, green and blue; 0 to 1 unless it is light.
using color = raio::vec3<double>;

/// What the numbers of a colour measure. The numbers of a scene file are taken as they stand, in either coding; texels
/// are encoded, and are decoded for those who compute with light. Pictures are written as encoded colours.
enum class coding {
    encoded,  ///< as screens and picture files have it, in sRGB: `flat`, `normals` and `whitted` compute with these
    linear,   ///< proportional to light, which can be added and scattered: `path` computes with these
};

/// The light that a level from 0 to 255 of a picture stands for, from 0 to 1, by the transfer function of sRGB
/// (IEC 61966-2-1, 1999).
double decoded(std::uint8_t level);

/// The inverse: how a picture shows this light. `decoded` levels come back, and light above 1 stays above 1.
color encoded(const color& light);

}  // namespace render
