#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/vec.hpp>

namespace raio {

/// An affine map of space: p goes to origin + x p.x + y p.y + z p.z. Mirrored, sheared and unevenly scaled as it may
/// be; the identity when it is new.
template <real T>
struct transform {
    vec3<T> x{T(1), T(0), T(0)}, y{T(0), T(1), T(0)}, z{T(0), T(0), T(1)};  ///< where the unit vectors go
    vec3<T> origin{T(0)};                                                   ///< where the origin goes

    RAIO_FN constexpr vec3<T> point(const vec3<T>& p) const {
        using W = wider_t<T>;
        return vec3<T>(linear(vec3<W>(p)) + vec3<W>(origin));
    }
    /// What a difference of two points becomes.
    RAIO_FN constexpr vec3<T> vector(const vec3<T>& v) const { return vec3<T>(linear(vec3<wider_t<T>>(v))); }

    /// x v.x + y v.y + z v.z in the precision of W.
    template <real W>
    RAIO_FN constexpr vec3<W> linear(const vec3<W>& v) const {
        return product_as<W>(x, v.x) + product_as<W>(y, v.y) + product_as<W>(z, v.z);
    }

    /// First `b`, then `a`; what is between them is not rounded to T.
    RAIO_FN friend constexpr transform operator*(const transform& a, const transform& b) {
        return {a.vector(b.x), a.vector(b.y), a.vector(b.z), a.point(b.origin)};
    }
};

template <real T>
RAIO_FN constexpr transform<T> translation(const vec3<T>& by) {
    return {.origin = by};
}

/// \param factors  along the axes; a negative one mirrors
template <real T>
RAIO_FN constexpr transform<T> scaling(const vec3<T>& factors) {
    return {{factors.x, T(0), T(0)}, {T(0), factors.y, T(0)}, {T(0), T(0), factors.z}};
}

/// Counter-clockwise about an axis through the origin, as seen from its tip (Rodrigues 1840).
/// \param axis   any length but zero
/// \param angle  in radians
template <real T>
RAIO_FN constexpr transform<T> rotation(const vec3<T>& axis, const T& angle) {
    vec3<T> a = normalize(axis);
    const T cosine = cos(angle), sine = sin(angle);
    const auto turned = [&](const vec3<T>& v) {
        return v * cosine + cross(a, v) * sine + a * (dot(a, v) * (T(1) - cosine));
    };
    return {turned({T(1), T(0), T(0)}), turned({T(0), T(1), T(0)}), turned({T(0), T(0), T(1)})};
}

}  // namespace raio

#include <raio/pop_macros.hpp>
