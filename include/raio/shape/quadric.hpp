#pragma once

#include <raio/shape/algebraic.hpp>

namespace raio {

/// The points of a box at which a polynomial of degree 2
///
///     f = squares.(x^2, y^2, z^2) + products.(yz, zx, xy) + linear.(x, y, z) + constant
///
/// is zero or below: a solid that the faces of the box close, or, if it is not `Closed`, only the surface f = 0 as far
/// as it lies in the box. As a symmetric matrix (Blinn, The Algebraic Properties of Homogeneous Second Order Surfaces,
/// 1984) f has the squares and the constant on the diagonal, and half of the others beside it.
///
/// Whatever the matrix is, it is a surface: ellipsoids and paraboloids, cylinders and cones with elliptic sections,
/// hyperboloids, two planes, one, or none. A cone's tip, where the gradient of f vanishes, has the normal against the
/// ray. x, y, z and uv are as for `algebraic`.
template <real T, bool Closed = true>
struct quadric {
    using number = T;

    vec3<T> min, max;  ///< opposite corners of the box; missed unless each size is positive
    vec3<T> squares{T(0)}, products{T(0)}, linear{T(0)};
    T constant{0};  ///< missed if all ten are zero

    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr auto spans(const ray<T>& ray) const requires(Closed) { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const { return padded(aabb<T>{min, max}); }

    /// The same by its terms.
    RAIO_FN constexpr auto terms() const {
        const std::array<algebraic_term<T>, 10> terms{{{squares.x, 2, 0, 0},
                                                       {squares.y, 0, 2, 0},
                                                       {squares.z, 0, 0, 2},
                                                       {products.x, 0, 1, 1},
                                                       {products.y, 1, 0, 1},
                                                       {products.z, 1, 1, 0},
                                                       {linear.x, 1, 0, 0},
                                                       {linear.y, 0, 1, 0},
                                                       {linear.z, 0, 0, 1},
                                                       {constant, 0, 0, 0}}};
        return algebraic<T, 2, Closed, std::array<algebraic_term<T>, 10>>{min, max, terms};
    }

    /// f at a point.
    template <class W>
    RAIO_FN constexpr W value(const vec3<W>& p) const {
        return terms().value(p);
    }

    template <class W>
    RAIO_FN constexpr vec3<W> gradient(const vec3<W>& p) const {
        return terms().gradient(p);
    }

    template <class W, real R>
    RAIO_FORMULA constexpr crossings_of_degree<W, 2> crossings(const ray<R>& ray) const {
        return terms().template crossings<W>(ray);
    }

    template <class X, class W>
    RAIO_FN constexpr crossing<W> correction(const nearby_ray<X, W>& ray, const crossing<W>& c) const {
        return terms().correction(ray, c);
    }

    template <class W, real R, real N>
    RAIO_FN constexpr void surface(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec) const {
        terms().surface(ray, c, rec);
    }
};

/// The surface alone.
template <real T>
using open_quadric = quadric<T, false>;

}  // namespace raio
