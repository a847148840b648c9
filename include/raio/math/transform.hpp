#pragma once

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

/// The inverse of a linear map: the rows of its matrix, which are the reciprocal basis of the images of the unit
/// vectors. Zero where the map is singular.
template <real W>
struct linear_inverse {
    vec3<W> x, y, z;

    /// Determinants and quotients are computed in the last precision of T and rounded to W.
    template <real T>
    RAIO_FN constexpr explicit linear_inverse(const transform<T>& map) {
        using X = exact_t<T>;
        vec3<X> a(map.x), b(map.y), c(map.z), b_c = cross(b, c), c_a = cross(c, a), a_b = cross(a, b);
        X over_det = quotient(X(1), dot(a, b_c), X(0));
        x = vec3<W>(b_c * over_det), y = vec3<W>(c_a * over_det), z = vec3<W>(a_b * over_det);
    }

    template <real V>
    RAIO_FN constexpr vec3<W> operator()(const vec3<V>& v) const {
        const auto along = [&](const vec3<W>& row) {
            return product_as<W>(v.x, row.x) + product_as<W>(v.y, row.y) + product_as<W>(v.z, row.z);
        };
        return {along(x), along(y), along(z)};
    }
    /// How normals go the other way: by the transpose.
    RAIO_FN constexpr vec3<W> transposed(const vec3<W>& n) const { return x * n.x + y * n.y + z * n.z; }
};

}  // namespace raio
