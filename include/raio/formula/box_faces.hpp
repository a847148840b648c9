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

/// What a surface in a box, whose faces may close it, says of a point that has been recorded. Its own face is 0.
/// \param axis      that the box's face is across; beyond 2 on the surface itself
/// \param gradient  answers with that of the surface at a point; to be asked only where it counts
template <class Point, real T, class Index, class Gradient>
RAIO_FN constexpr void clipped_surface(Point& at, const aabb<T>& box, const Index& axis, Gradient gradient) {
    using W = typename Point::number;
    const mask_t<T> on_surface = at.face() == index_t<W>(0);
    at.keep_between(box);
    at.put_on_face(box, axis);
    // Where the box closes it, the point has no error; but what leaves it has to be certain in double_double that it is
    // not on the surface.
    at.add_error(select(on_surface, T(0), least_apart(norm1(box.max - box.min))));
    if (any(on_surface)) at.record_gradient(gradient(at.position()), on_surface);
    at.record_uv([&] { return uv_across(box, axis, at.point()); });
}

}  // namespace raio::inline RAIO_ABI::detail

#include <raio/pop_macros.hpp>
