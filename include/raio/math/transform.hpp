#pragma once

#include <raio/push_macros.hpp>

#include <stdexcept>

#include <raio/failure.hpp>
#include <raio/math/vec.hpp>

namespace raio::inline RAIO_ABI {

/// An affine map of space: p goes to origin + x p.x + y p.y + z p.z. Mirrored, sheared and unevenly scaled as it may
/// be; the identity when it is new.
template <real T>
struct transform {
    vec3<T> x{T(1), T(0), T(0)}, y{T(0), T(1), T(0)}, z{T(0), T(0), T(1)};  ///< where the unit vectors go
    vec3<T> origin{T(0)};                                                   ///< where the origin goes

    transform() = default;
    RAIO_FN constexpr transform(const vec3<T>& x_to, const vec3<T>& y_to, const vec3<T>& z_to = {T(0), T(0), T(1)},
                                const vec3<T>& origin_to = {T(0), T(0), T(0)})
        : x(x_to), y(y_to), z(z_to), origin(origin_to) {}

    /// A matrix of four columns, as GLM's own `translate`, `rotate` and `scale` make them: a mat4 or a mat4x3.
    /// \throws std::invalid_argument  for a projection, whose last row is not 0 0 0 1
    template <glm::length_t Rows, real U, glm::qualifier Q>
    requires(Rows == 3 || Rows == 4) constexpr explicit(!std::same_as<U, T>)
        transform(const glm::mat<4, Rows, U, Q>& columns)
        : x(columns[0]), y(columns[1]), z(columns[2]), origin(columns[3]) {
        if constexpr (Rows == 4) {
            const bool affine =
                columns[0][3] == U(0) && columns[1][3] == U(0) && columns[2][3] == U(0) && columns[3][3] == U(1);
            if (!affine) detail::fail(std::invalid_argument("raio::transform: a matrix whose last row is not 0 0 0 1"));
        }
    }

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

template <glm::length_t Rows, real U, glm::qualifier Q>
transform(const glm::mat<4, Rows, U, Q>&) -> transform<U>;

template <real T>
RAIO_FN constexpr transform<T> translation(const vec3<T>& by) {
    return {{T(1), T(0), T(0)}, {T(0), T(1), T(0)}, {T(0), T(0), T(1)}, by};
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

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
