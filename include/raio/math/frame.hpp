#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/vec.hpp>

namespace raio::inline RAIO_ABI {

/// Three unit vectors, each perpendicular to the others, right-handed: cross(x, y) = z.
template <real T>
struct frame {
    vec3<T> x, y, z;

    /// The components of `v` along the three.
    RAIO_FN constexpr vec3<T> to_local(const vec3<T>& v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
    RAIO_FN constexpr vec3<T> to_world(const vec3<T>& v) const { return x * v.x + y * v.y + z * v.z; }
};

/// A frame about the unit vector `z`, without branches or roots, continuous but at z.z = 0 (Duff et al., JCGT 6(1),
/// 2017). About a vector of another length, if that is given: three vectors of that length.
template <real T>
RAIO_FN constexpr frame<T> frame_about(const vec3<T>& z, const T& length = T(1)) {
    const T sign = copysign(T(1), z.z);
    const T a = T(-1) / (sign * length + z.z);
    const T b = z.x * z.y * a;
    return {{length + sign * z.x * z.x * a, sign * b, -sign * z.x}, {b, sign * length + z.y * z.y * a, -z.y}, z};
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
