#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <render/reader.hpp>

namespace render {

/// A scene of one red sphere, one line a section, so that a test names only the section that it is about.
struct scene_text {
    std::string camera = "0 0 5  0 0 0  0 1 0  60";
    std::string lights = "1  0 9 0  1 1 1  1 0 0";
    std::string pigments = "1  solid 1 0 0";
    std::string materials = "1  0.1 0.8 0 0  0 0 0";
    std::string objects = "1  0 0 sphere 0 0 0 1";
    std::string statements = "";

    std::string joined() const {
        return camera + "\n" + lights + "\n" + pigments + "\n" + materials + "\n" + objects + "\n" + statements;
    }
};

/// Knows no picture, and touches no file.
inline texture no_picture(const std::filesystem::path&) { throw std::runtime_error("no such picture"); }

/// Knows one mesh, of two triangles.
inline std::vector<raio::triangle<number>> square(const std::filesystem::path& file) {
    if (file != "scenes/square.obj") throw scene_error(file.string() + ":1: found no such file, expected a mesh");
    return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
}

inline const loaders no_files{no_picture, square};

inline scene read(const scene_text& text) { return parse_scene(text.joined(), "scenes/test.txt", no_files); }

}  // namespace render
