#pragma once

#include <filesystem>
#include <vector>

#include "mesh.hpp"
#include "scene.hpp"
#include "tokens.hpp"

namespace render {

/// Where the meshes of a scene lie, and how they are read.
struct meshes {
    std::filesystem::path folder;
    mesh_loader load;
};

/// Reads a shape: the transforms before its name, the name, and what follows it. A mesh is as many shapes as it has
/// triangles.
std::vector<shape> read_shapes(tokens& in, const meshes& known);

}  // namespace render
