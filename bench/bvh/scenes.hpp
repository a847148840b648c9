#pragma once

#include <functional>
#include <string>
#include <vector>

#include <raio/compose/mesh.hpp>

/// \file
/// What is traced: meshes of many kinds, all float, and a camera for each.

namespace bench {

using mesh = raio::mesh<float>;

/// The triangles one by one.
std::vector<raio::triangle<float>> soup(const mesh& from);

/// Where the rays come from. The picture is square.
struct camera {
    raio::vec3<float> eye, look_at;
    float half_width;  ///< tangent of half the angle of view
};

/// The camera one and a half diagonals away from the middle of these points in that direction, whose picture they fill.
camera filled_with(const std::vector<raio::vec3<float>>& points, const raio::vec3<float>& direction);

/// A scene that is made when it is asked for.
struct scene {
    std::string name;
    std::function<bench::mesh()> mesh;
    std::function<bench::camera(const bench::mesh&)> camera;
};

/// The scenes that are compared. Those that are models stand in the folder RAIO_BENCH_MODELS, which the build is told
/// of, or the environment; one that is not there is left out, and standard error says so.
std::vector<scene> scenes();

/// A sphere with bumps of all sizes, of about that many triangles of one size.
mesh bumpy_sphere(std::size_t triangle_count);

/// Houses, each a turned box with smaller ones on top, round trees, and a ground of two triangles for it all.
mesh city();

/// A room whose walls are two triangles each, full of long thin planks that lean in every direction.
mesh room();

/// Reads a Wavefront OBJ file; throws `std::runtime_error` if there is none.
mesh read_model(const std::string& file);

}  // namespace bench
