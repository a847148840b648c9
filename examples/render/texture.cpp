#include "texture.hpp"

#include <cerrno>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>
#include <system_error>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#include <stb/stb_image.h>

namespace render {
namespace {

/// Which of `count` texels lies at `s` of a picture that repeats with period 1.
std::size_t nearest(double s, int count) {
    const double place = (s - std::floor(s)) * count;
    if (!(place >= 0)) return 0;  // NaN: the point is infinitely far away
    return place < count ? static_cast<std::size_t>(place) : static_cast<std::size_t>(count - 1);
}

}  // namespace

color texture::at(double s, double t, coding as) const {
    const std::size_t texel = nearest(t, height) * static_cast<std::size_t>(width) + nearest(s, width);
    const std::uint8_t red = texels[3 * texel], green = texels[3 * texel + 1], blue = texels[3 * texel + 2];
    if (as == coding::linear) return {decoded(red), decoded(green), decoded(blue)};
    return color(red, green, blue) / 255.0;
}

texture read_texture(const std::filesystem::path& path) {
    std::error_code ignored;  // what is not there is found out by reading it
    const auto kind = std::filesystem::status(path, ignored).type();
    if (kind != std::filesystem::file_type::regular && kind != std::filesystem::file_type::not_found) {
        throw std::runtime_error("is not a file");  // a device may have no end
    }
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> content(std::istreambuf_iterator<char>(file), {});
    if (content.empty()) throw std::runtime_error("cannot be read, or is empty");
    if (content.size() > std::numeric_limits<int>::max()) throw std::runtime_error("is larger than 2 GB");

    texture result;
    int channels = 0;
    const auto* bytes = reinterpret_cast<const stbi_uc*>(content.data());
    const std::unique_ptr<stbi_uc, void (*)(void*)> texels(
        stbi_load_from_memory(bytes, static_cast<int>(content.size()), &result.width, &result.height, &channels, 3),
        stbi_image_free);
    if (!texels) throw std::runtime_error(std::string("is not a picture that can be read: ") + stbi_failure_reason());
    const std::size_t count = 3 * static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height);
    result.texels.assign(texels.get(), texels.get() + count);
    return result;
}

}  // namespace render
