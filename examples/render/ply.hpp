#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <raio/shape/triangle.hpp>

namespace render {

/// Is this the text of a PLY file?
bool is_ply(std::string_view text);

/// The faces of a PLY file (Turk, The PLY polygon file format, 1994), ASCII or binary of either byte order, as
/// triangles, and those of its strips of triangles; a face with more corners is cut into triangles (polygon.hpp).
/// Everything else that such a file can say is passed over. Throws `scene_error` with the line that is wrong; of binary
/// data, that is the line of the header that announced them. \param file  the name in errors
std::vector<raio::triangle<double>> parse_ply(std::string_view text, const std::string& file);

}  // namespace render
