#pragma once

/// \file
/// Every shape, and what is composed of them. Who wants trees or packs as well asks for them, since they are much to
/// compile: `raio/bvh/bvh.hpp`, `raio/number/simd.hpp`.

#include <raio/compose/any_primitive.hpp>
#include <raio/compose/closed_surface.hpp>
#include <raio/compose/csg.hpp>
#include <raio/compose/group.hpp>
#include <raio/compose/in_lanes.hpp>
#include <raio/compose/mesh.hpp>
#include <raio/compose/moving.hpp>
#include <raio/compose/quick.hpp>
#include <raio/compose/transformed.hpp>
#include <raio/shape/algebraic.hpp>
#include <raio/shape/bezier_curve.hpp>
#include <raio/shape/bilinear_patch.hpp>
#include <raio/shape/blob.hpp>
#include <raio/shape/box.hpp>
#include <raio/shape/capsule.hpp>
#include <raio/shape/cone.hpp>
#include <raio/shape/convex_polyhedron.hpp>
#include <raio/shape/curved_surface_of_revolution.hpp>
#include <raio/shape/cylinder.hpp>
#include <raio/shape/disc.hpp>
#include <raio/shape/ellipsoid.hpp>
#include <raio/shape/frustum.hpp>
#include <raio/shape/heightfield.hpp>
#include <raio/shape/hyperboloid.hpp>
#include <raio/shape/paraboloid.hpp>
#include <raio/shape/parallelogram.hpp>
#include <raio/shape/plane.hpp>
#include <raio/shape/polyhedra.hpp>
#include <raio/shape/quadric.hpp>
#include <raio/shape/ring.hpp>
#include <raio/shape/round_cone.hpp>
#include <raio/shape/signed_distance.hpp>
#include <raio/shape/sphere.hpp>
#include <raio/shape/steiner.hpp>
#include <raio/shape/surface_of_revolution.hpp>
#include <raio/shape/teardrop.hpp>
#include <raio/shape/torus.hpp>
#include <raio/shape/triangle.hpp>
#include <raio/shape/two_sheet_hyperboloid.hpp>
#include <raio/shape/watertight_triangle.hpp>
