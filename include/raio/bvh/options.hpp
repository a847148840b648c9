#pragma once

#include <raio/push_macros.hpp>

#include <raio/config.hpp>

namespace raio::inline RAIO_ABI {

/// How much time goes into a tree, and how much of it comes back with every ray.
enum class bvh_quality {
    low,       ///< sorted along a curve through space: for shapes that are new in every frame
    standard,  ///< split where the surface area heuristic says
    high  ///< twice, the second time with large triangles cut to pieces; the better one stays: for scenes that stay
};

struct bvh_options {
    bvh_quality quality = bvh_quality::standard;
    unsigned threads = 0;  ///< how many build it; 0: as many as the machine has. The tree is the same for any number
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
