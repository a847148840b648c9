#pragma once

#include <span>
#include <vector>

#include <raio/shape/triangle.hpp>

namespace render {

/// Appends the triangles of a face with three corners or more, in its own sense of rotation: two fewer than it has
/// corners, and no corner but its own. A convex face becomes a fan about its first corner. From others ears are clipped
/// (Meisters, "Polygons have ears", 1975), as they are seen along the axis along which their area is largest; holes
/// that a face reaches through an edge and back stay open. Of a face that crosses itself some triangles are made.
void append_triangles(std::span<const raio::vec3<double>> corners, std::vector<raio::triangle<double>>& triangles);

}  // namespace render
