#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <raio/shape/triangle.hpp>

namespace render {

/// Loads the triangles of a mesh that a scene names, or throws a `scene_error` with the mesh's own line.
using mesh_loader = std::function<std::vector<raio::triangle<double>>(const std::filesystem::path&)>;

/// Reads the faces of a Wavefront OBJ or PLY file as triangles; a face with more corners is cut into them
/// (polygon.hpp). Everything else that such a file can say is passed over, but for free-form surfaces, which are
/// refused. Throws `scene_error` with the line that is wrong.
std::vector<raio::triangle<double>> read_mesh(const std::filesystem::path& file);

/// The same for a file that is in memory already, and its name in errors.
std::vector<raio::triangle<double>> parse_mesh(std::string_view text, const std::string& file);

}  // namespace render
