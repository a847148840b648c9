#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "color.hpp"

namespace render {

/// The picture while it is made: an encoded colour for each pixel. Row 0 is at the top, column 0 at the
/// left.
class film {
public:
    film(int width, int height)
        : width_(width), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), color(0)) {}

    int width() const { return width_; }
    int height() const { return static_cast<int>(pixels_.size()) / width_; }

    color& at(int column, int row) { return pixels_[index(column, row)]; }
    const color& at(int column, int row) const { return pixels_[index(column, row)]; }

private:
    int width_;
    std::vector<color> pixels_;

    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
    }
};

/// How a picture's file has one channel of a colour: `min(int(255 c), 255)`, 0 for NaN and what is below 0. A c that is
/// a level but for the last digits is that level.
std::uint8_t level(double channel);

/// Throws what `write_image` would throw for this path, so that one knows before the picture is rendered. Leaves
/// nothing behind.
void expect_writable(const std::filesystem::path& path);

/// Throws if the path leads to one of these files, by whatever name, which the picture would overwrite.
void expect_other_file(const std::filesystem::path& path, std::span<const std::filesystem::path> used);

/// Writes the picture as PPM (P6) or PNG, as the path ends, the `level` of each channel. The file is there whole
/// or not at all: it is written under another name beside `path` and renamed. A symbolic link is followed. Throws
/// `std::runtime_error` that begins with the path and says what is wrong and what was expected.
void write_image(const film& picture, const std::filesystem::path& path);

}  // namespace render
