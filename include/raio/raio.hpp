#pragma once

/// \file
/// Everything.

#include <raio/bvh/bvh.hpp>
#include <raio/compose/any_primitive.hpp>
#include <raio/compose/csg.hpp>
#include <raio/compose/group.hpp>
#include <raio/compose/mesh.hpp>
#include <raio/compose/transformed.hpp>
#include <raio/math/simd.hpp>
#include <raio/shape/algebraic.hpp>
#include <raio/shape/box.hpp>
#include <raio/shape/capsule.hpp>
#include <raio/shape/convex_polyhedron.hpp>
#include <raio/shape/cylinder.hpp>
#include <raio/shape/disc.hpp>
#include <raio/shape/parallelogram.hpp>
#include <raio/shape/plane.hpp>
#include <raio/shape/polyhedra.hpp>
#include <raio/shape/quadric.hpp>
#include <raio/shape/ring.hpp>
#include <raio/shape/sphere.hpp>
#include <raio/shape/torus.hpp>
#include <raio/shape/triangle.hpp>
#include <raio/shape/watertight_triangle.hpp>
