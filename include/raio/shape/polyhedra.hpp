#pragma once

#include <raio/push_macros.hpp>

#include <array>

#include <raio/shape/convex_polyhedron.hpp>

/// \file
/// Solids that are bounded by planes, each made as the convex polyhedron that it is. Planes are found in the last
/// precision of T and rounded so that no corner is cut off but by a rounding of the offset.

namespace raio::inline RAIO_ABI {

/// A convex polyhedron that holds its planes itself.
template <real T, std::size_t Faces>
using polyhedron = convex_polyhedron<T, std::array<half_space<T>, Faces>>;

namespace detail {

/// What has no point behind it.
template <real T>
RAIO_FN constexpr half_space<T> nowhere_behind() {
    return {vec3<T>(T(0)), T(1)};
}

/// Everything on `inside`'s side of the plane through three corners; nothing, if they lie in a line or `inside` lies in
/// their plane.
template <real T, class X = exact_t<T>>
RAIO_FN constexpr half_space<T> half_space_through(const vec3<X>& a, const vec3<X>& b, const vec3<X>& c,
                                                   const vec3<X>& inside) {
    const vec3<X> across = scaled_into_range<X>(cross(b - a, c - a));
    const X depth = dot(across, inside - a), size = length(across);
    if (depth == X(0) || !(size > X(0))) return nowhere_behind<T>();
    const vec3<T> normal(across * (copysign(X(1), -depth) / size));
    const vec3<X> n(normal);
    return {normal, -T(max(max(dot(n, a), dot(n, b)), dot(n, c)))};
}

template <class X, real T, std::size_t N>
RAIO_FN constexpr vec3<X> mean(const std::array<vec3<T>, N>& points) {
    vec3<X> sum(X(0));
    for (const vec3<T>& p : points) sum += vec3<X>(p);
    return sum * (X(1) / X(N));
}

}  // namespace detail

/// The box, or any parallelepiped, of all `center` + x `half_x` + y `half_y` + z `half_z` with x, y, z in [-1, 1].
/// Faces are counted low x, high x, low y, high y, low z, high z.
template <real T>
RAIO_FN constexpr polyhedron<T, 6> oriented_box(const vec3<T>& center, const vec3<T>& half_x, const vec3<T>& half_y,
                                                const vec3<T>& half_z) {
    using X = exact_t<T>;
    polyhedron<T, 6> box;
    const vec3<X> middle(center), halves[] = {vec3<X>(half_x), vec3<X>(half_y), vec3<X>(half_z)};
    for (std::size_t i = 0; i < 3; ++i) {
        const vec3<X> across = halves[(i + 1) % 3], up = halves[(i + 2) % 3];
        const vec3<X> low = middle - halves[i], high = middle + halves[i];
        box.planes[2 * i] = detail::half_space_through<T>(low, low + across, low + up, middle);
        box.planes[2 * i + 1] = detail::half_space_through<T>(high, high + across, high + up, middle);
    }
    return box;
}

/// The tetrahedron with these corners, in any order. Face i lies opposite to corner i.
template <real T>
RAIO_FN constexpr polyhedron<T, 4> tetrahedron(const vec3<T>& a, const vec3<T>& b, const vec3<T>& c, const vec3<T>& d) {
    using X = exact_t<T>;
    const vec3<X> p(a), q(b), r(c), s(d);
    return {{detail::half_space_through<T>(q, r, s, p), detail::half_space_through<T>(r, s, p, q),
             detail::half_space_through<T>(s, p, q, r), detail::half_space_through<T>(p, q, r, s)}};
}

/// \param base  the corners of a flat convex polygon, in order around it. Face i stands on the edge from corner i on,
///              the last face is the base.
template <real T, std::size_t N>
requires(N >= 3) RAIO_FN
    constexpr polyhedron<T, N + 1> pyramid(const std::array<vec3<T>, N>& base, const vec3<T>& apex) {
    polyhedron<T, N + 1> result;
    using X = exact_t<T>;
    const vec3<X> tip(apex), middle = detail::mean<X>(base), inside = middle + (tip - middle) * X(0.5);
    const auto corner = [&](std::size_t i) { return vec3<X>(base[i % N]); };
    for (std::size_t i = 0; i < N; ++i) {
        result.planes[i] = detail::half_space_through<T>(corner(i), corner(i + 1), tip, inside);
    }
    result.planes[N] = detail::half_space_through<T>(corner(0), corner(1), corner(2), tip);
    return result;
}

/// \param base   the corners of a flat convex polygon, in order around it. Face i stands on the edge from corner i on,
///               the last two faces are base and top.
/// \param along  from the base to the top, not within the base's plane
template <real T, std::size_t N>
requires(N >= 3) RAIO_FN
    constexpr polyhedron<T, N + 2> prism(const std::array<vec3<T>, N>& base, const vec3<T>& along) {
    polyhedron<T, N + 2> result;
    using X = exact_t<T>;
    const vec3<X> up(along), inside = detail::mean<X>(base) + up * X(0.5);
    const auto corner = [&](std::size_t i) { return vec3<X>(base[i % N]); };
    for (std::size_t i = 0; i < N; ++i) {
        result.planes[i] = detail::half_space_through<T>(corner(i), corner(i + 1), corner(i) + up, inside);
    }
    result.planes[N] = detail::half_space_through<T>(corner(0), corner(1), corner(2), inside);
    result.planes[N + 1] = detail::half_space_through<T>(corner(0) + up, corner(1) + up, corner(2) + up, inside);
    return result;
}

/// The five Platonic solids by their number of faces, with the corners on the sphere of that radius: 4, 6, 8, 12 or 20.
/// Nothing, unless the radius is positive.
/// The cube is axis-aligned, and the others stand in it as Euclid has them (Elements XIII): corners of the tetrahedron
/// are corners of the cube, corners of the octahedron lie on the axes.
template <std::size_t Faces, real T>
requires(Faces == 4 || Faces == 6 || Faces == 8 || Faces == 12 || Faces == 20) RAIO_FN
    constexpr polyhedron<T, Faces> regular_solid(const vec3<T>& center, const T& radius) {
    using X = exact_t<T>;
    X golden = (X(1) + sqrt(X(5))) / X(2), zero(0), one(1);
    // Of all solids but the tetrahedron, opposite faces are parallel; the normals are the corners of the dual solid.
    std::array<vec3<X>, Faces> normals;
    std::size_t count = 0;
    const auto add_all_signs = [&](const vec3<X>& n) {
        for (int signs = 0; signs < 8; ++signs) {
            const X x = signs & 1 ? -n.x : n.x, y = signs & 2 ? -n.y : n.y, z = signs & 4 ? -n.z : n.z;
            const bool repeated =
                (n.x == zero && (signs & 1)) || (n.y == zero && (signs & 2)) || (n.z == zero && (signs & 4));
            const bool odd = Faces == 4 && (signs == 0 || signs == 3 || signs == 5 || signs == 6);
            if (!repeated && !odd) normals[count++] = {x, y, z};
        }
    };
    const auto add_cyclic = [&](const X& x, const X& y, const X& z) {
        add_all_signs({x, y, z}), add_all_signs({y, z, x}), add_all_signs({z, x, y});
    };
    if constexpr (Faces == 6) add_cyclic(one, zero, zero);
    if constexpr (Faces == 12) add_cyclic(zero, one, golden);
    if constexpr (Faces == 20) add_cyclic(zero, one / golden, golden);
    if constexpr (Faces == 4 || Faces == 8 || Faces == 20) add_all_signs({one, one, one});

    // The inscribed sphere over the circumscribed one.
    X inscribed = Faces == 4                 ? one / X(3)
                  : Faces == 6 || Faces == 8 ? one / sqrt(X(3))
                                             : sqrt((X(5) + X(2) * sqrt(X(5))) / X(15));
    polyhedron<T, Faces> solid;
    for (std::size_t i = 0; i < Faces; ++i) {
        const vec3<T> normal(normals[i]);
        const vec3<X> n(normal);
        solid.planes[i] = {normal, T(-(dot(n, vec3<X>(center)) + length(n) * inscribed * X(radius)))};
        if (!(radius > T(0))) solid.planes[i] = detail::nowhere_behind<T>();
    }
    return solid;
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
