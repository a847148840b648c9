#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "mesh.hpp"
#include "scene.hpp"
#include "tokens.hpp"

namespace render {

/// Loads the picture that a scene names, or throws an exception that says why it cannot be read.
using texture_loader = std::function<texture(const std::filesystem::path&)>;

/// How the other files of a scene are read.
struct loaders {
    texture_loader texture = read_texture;
    mesh_loader mesh = read_mesh;
};

/// Reads a scene; the format is described in README.md. Throws `scene_error` with the line that is wrong.
scene read_scene(const std::filesystem::path& file, const loaders& load = {});

/// The same for a scene that is in memory already. `file` names it in errors, and textures are looked for in its
/// folder.
scene parse_scene(std::string_view text, const std::filesystem::path& file, const loaders& load);

}  // namespace render
