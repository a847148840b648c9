#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/vec.hpp>

namespace raio::inline RAIO_ABI {

/// A point that was chosen on a surface, every piece of the area as likely as any other of the same size.
template <real T>
struct surface_sample {
    vec3<T> point;
    vec3<T> normal;  ///< unit, outward
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
