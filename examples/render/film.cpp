#include "film.hpp"

#include <cctype>
#include <cstdint>
#include <fstream>
#include <random>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace render {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
    throw std::runtime_error(path.string() + ": " + reason);
}

/// Where symbolic links lead, be there a file or not.
std::filesystem::path followed(const std::filesystem::path& path) {
    std::filesystem::path target = path;
    for (int links = 0; std::filesystem::is_symlink(target); ++links) {
        if (links == 40) fail(path, "is a link that leads to itself, expected one to a file");
        target = target.parent_path() / std::filesystem::read_symlink(target);
    }
    return target;
}

/// A file beside what `name` leads to that vanishes unless it is renamed to that.
class unfinished_file {
public:
    explicit unfinished_file(const std::filesystem::path& name) : name_(name), target_(followed(name)), path_(target_) {
        std::ostringstream suffix;
        suffix << ".unfinished-" << std::hex << std::random_device{}();
        path_ += suffix.str();
        stream_.open(path_, std::ios::binary);
        if (!stream_)
            fail(name_, "cannot be written, expected a file name in a folder that is there and may be written to");
    }
    unfinished_file(const unfinished_file&) = delete;
    unfinished_file& operator=(const unfinished_file&) = delete;

    ~unfinished_file() {
        stream_.close();
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);  // after a rename there is nothing to remove
    }

    void finish(const std::string& content) {
        stream_.write(content.data(), static_cast<std::streamsize>(content.size()));
        stream_.close();
        if (!stream_)
            fail(name_,
                 "could not be written to its end, expected room for " + std::to_string(content.size()) + " bytes");
        std::error_code error;
        std::filesystem::rename(path_, target_, error);
        if (error) fail(name_, "cannot be replaced (" + error.message() + "), expected the name of a file");
    }

private:
    std::filesystem::path name_, target_, path_;
    std::ofstream stream_;
};

std::string bytes(const film& picture) {
    std::string result;
    result.reserve(3 * static_cast<std::size_t>(picture.width()) * static_cast<std::size_t>(picture.height()));
    for (int row = 0; row < picture.height(); ++row) {
        for (int column = 0; column < picture.width(); ++column) {
            const color& c = picture.at(column, row);
            for (int channel = 0; channel < 3; ++channel) {
                result += static_cast<char>(level(c[channel]));
            }
        }
    }
    return result;
}

std::string ppm(const film& picture) {
    return "P6\n" + std::to_string(picture.width()) + ' ' + std::to_string(picture.height()) + "\n255\n" +
           bytes(picture);
}

std::string png(const film& picture) {
    std::string result;
    const auto append = [](void* context, void* data, int size) {
        static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
    };
    stbi_write_png_to_func(append, &result, picture.width(), picture.height(), 3, bytes(picture).data(),
                           3 * picture.width());
    if (result.empty()) throw std::bad_alloc();
    return result;
}

using encoder = std::string (*)(const film&);

encoder encoder_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (extension == ".ppm") return ppm;
    if (extension == ".png") return png;
    fail(path, "has an unknown kind of picture, expected a name that ends in .png or .ppm");
}

}  // namespace

std::uint8_t level(double channel) {
    const double exact = channel > 0 ? 255 * (1 + 1e-12) * channel : 0;
    return static_cast<std::uint8_t>(exact < 255 ? exact : 255);
}

void expect_writable(const std::filesystem::path& path) {
    encoder_of(path);
    if (std::filesystem::is_directory(path)) fail(path, "is a folder, expected the name of a file");
    unfinished_file{path};
}

void expect_other_file(const std::filesystem::path& path, std::span<const std::filesystem::path> used) {
    for (const std::filesystem::path& other : used) {
        std::error_code missing;  // neither is the same then
        if (!std::filesystem::equivalent(path, other, missing)) continue;
        fail(path, "is a file that the scene is made of, expected another name for the picture");
    }
}

void write_image(const film& picture, const std::filesystem::path& path) {
    const std::string content = encoder_of(path)(picture);
    unfinished_file(path).finish(content);
}

}  // namespace render
