#include <tiny_obj_loader.h>

#include <stdexcept>

#include "bvh/scenes.hpp"

namespace bench {

mesh read_model(const std::string& file) {
    tinyobj::ObjReader reader;
    if (!reader.ParseFromFile(file)) throw std::runtime_error(file + ": " + reader.Error());
    const std::vector<tinyobj::real_t>& coordinates = reader.GetAttrib().vertices;
    mesh model;
    for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
        model.vertices.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
    }
    for (const tinyobj::shape_t& shape : reader.GetShapes()) {
        const std::vector<tinyobj::index_t>& corners = shape.mesh.indices;  // the reader has made triangles of them
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
            const auto vertex = [&](std::size_t corner) {
                return static_cast<std::uint32_t>(corners[i + corner].vertex_index);
            };
            model.triangles.push_back({vertex(0), vertex(1), vertex(2)});
        }
    }
    return model;
}

}  // namespace bench
