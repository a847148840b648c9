#pragma once

/// \file
/// Everything.

#include <raio/compose/group.hpp>
#include <raio/shape/box.hpp>
#include <raio/shape/convex_polyhedron.hpp>
#include <raio/shape/cylinder.hpp>
#include <raio/shape/disc.hpp>
#include <raio/shape/plane.hpp>
#include <raio/shape/sphere.hpp>
#include <raio/shape/triangle.hpp>
#include <raio/shape/watertight_triangle.hpp>
