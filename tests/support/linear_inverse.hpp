#pragma once

#include <raio/math/transform.hpp>

namespace raio::test {

/// The inverse of a linear map, as a textbook computes it: the rows of its matrix, which are the reciprocal basis of
/// the images of the unit vectors. Zero where the map is singular.
template <real W>
struct linear_inverse {
    vec3<W> x, y, z;

    explicit linear_inverse(const transform<W>& map) {
        const vec3<W> b_c = cross(map.y, map.z), c_a = cross(map.z, map.x), a_b = cross(map.x, map.y);
        const W over_det = quotient(W(1), dot(map.x, b_c), W(0));
        x = b_c * over_det, y = c_a * over_det, z = a_b * over_det;
    }

    vec3<W> operator()(const vec3<W>& v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
    /// How normals go the other way: by the transpose.
    vec3<W> transposed(const vec3<W>& n) const { return x * n.x + y * n.y + z * n.z; }
};

}  // namespace raio::test
