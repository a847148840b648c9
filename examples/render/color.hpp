#pragma once

#include <raio/raio.hpp>

namespace render {

/// Red, green and blue, linear; 0 to 1 unless it is light.
using color = raio::vec3<double>;

}  // namespace render
