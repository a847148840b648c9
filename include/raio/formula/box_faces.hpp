#pragma once

#include <raio/push_macros.hpp>

#include <raio/aabb.hpp>

/// \file
/// What a box and the surfaces that a box clips say of a point.

namespace raio::inline RAIO_ABI::detail {

/// Where a point is in a box, in both other coordinates than that of `axis`, in their order: from 0 at `min` to 1 at
/// `max`. Without an axis, beyond 2, they are x and y.
template <real T, class Index>
RAIO_FN constexpr vec2<T> uv_across(const aabb<T>& box, const Index& axis, const vec3<T>& p) {
    const mask_t<T> x = axis == Index(0), xy = some(x, mask_t<T>(axis == Index(1)));
    const auto along = [](T at, T low, T high) { return max(T(0), min(T(1), quotient(at - low, high - low, T(0)))); };
    return {along(choose(x, p.y, p.x), choose(x, box.min.y, box.min.x), choose(x, box.max.y, box.max.x)),
            along(choose(xy, p.z, p.y), choose(xy, box.min.z, box.min.y), choose(xy, box.max.z, box.max.y))};
}

/// Puts the point onto a face of a box, of which one coordinate is known without any error, and records the normal.
/// \param axis  that the face is across; beyond 2 the point stays where it is, and the normal is 0
template <class Point, real T, class Index>
RAIO_FN constexpr void put_on_face(Point& at, const aabb<T>& box, const Index& axis) {
    const mask_t<T> enters = at.entering();
    vec3<T>& point = at.point();
    if constexpr (Point::is_mapped) {
        if (axis > 2) return;
        const auto i = static_cast<glm::length_t>(axis);
        const bool at_low = enters == (at.direction()[i] > typename Point::number(0));
        point[i] = at_low ? box.min[i] : box.max[i];
        vec3<T> outward(T(0));
        outward[i] = T(at_low ? -1 : 1);
        at.record_normal(outward);
    } else {
        vec3<T> d = at.ray().direction;
        const auto put = [&](mask_t<T> on, const T& d_i, T low, T high, T& p_i, T& error_i, T& normal_i) {
            const mask_t<T> forward = d_i > T(0), at_low = enters == forward;
            p_i = choose(on, choose(at_low, low, high), p_i);
            error_i = choose(on, T(0), error_i);
            normal_i = choose(on, choose(forward, T(-1), T(1)), T(0));
        };
        put(axis == Index(0), d.x, box.min.x, box.max.x, point.x, at.error().x, at.normal().x);
        put(axis == Index(1), d.y, box.min.y, box.max.y, point.y, at.error().y, at.normal().y);
        put(axis == Index(2), d.z, box.min.z, box.max.z, point.z, at.error().z, at.normal().z);
    }
}

/// What a surface in a box, whose faces may close it, says of a point that has been recorded. Its own face is 0.
/// \param axis      that the box's face is across; beyond 2 on the surface itself
/// \param gradient  answers with that of the surface at a point; to be asked only where it counts
template <class Point, real T, class Index, class Gradient>
RAIO_FN constexpr void clipped_surface(Point& at, const aabb<T>& box, const Index& axis, Gradient gradient) {
    using W = typename Point::number;
    const mask_t<T> on_surface = at.face() == index_t<W>(0);
    at.keep_between(box);
    put_on_face(at, box, axis);
    // Where the box closes it, the point has no error; but what leaves it has to be certain in double_double that it is
    // not on the surface.
    at.add_error(select(on_surface, T(0), least_apart(norm1(box.max - box.min))));
    if (any(on_surface)) at.record_gradient(gradient(at.position()), on_surface);
    at.record_uv([&] { return uv_across(box, axis, at.point()); });
}

}  // namespace raio::inline RAIO_ABI::detail

#include <raio/pop_macros.hpp>
