#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/vec.hpp>

namespace raio {

/// The points `origin + t * direction`.
template <real T>
struct ray {
    vec3<T> origin;
    vec3<T> direction;  ///< need not be unit: t counts in lengths of it
};

}  // namespace raio

#include <raio/pop_macros.hpp>
