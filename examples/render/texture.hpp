#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "color.hpp"

namespace render {

/// A picture that surfaces are coloured with, as its file stores it: encoded.
struct texture {
    int width = 0, height = 0;         ///< at least 1 each
    std::vector<std::uint8_t> texels;  ///< red, green, blue from 0 to 255, row by row from the top left

    /// The colour at (s, t): the nearest texel, the picture repeated beyond [0, 1).
    color at(double s, double t, coding as) const;
};

/// Reads a PNG, JPEG, BMP, TGA, GIF or PPM file. Throws `std::runtime_error` that says why the file cannot be read (its
/// name not included).
texture read_texture(const std::filesystem::path& path);

}  // namespace render
