#pragma once

#include <raio/proof/crossing.hpp>

/// \file
/// What is recorded of a point close to the apex of a cone, where the cone has no normal, and an error of the point
/// turns that of its side.

namespace raio {

namespace detail {

/// What of a way out of a cone is not along the ray: seen along its axis the apex looks like a plane, and a ray that
/// only touches it comes from the side.
template <class W>
RAIO_FN constexpr vec3<W> turned_from(const vec3<W>& d, const mask_t<W>& entering, const vec3<W>& outward) {
    const W side = select(entering, W(1), W(-1));
    W forward = max(W(0), dot(outward, d) * side) * side;
    return outward - d * (forward / dot(d, d));
}

}  // namespace detail

/// The normal of a cone, of any length: `outward`, unless the point is so close to the apex that its error turns that
/// by a sixteenth of the slope or more.
/// \param widening   how much the radius grows along the axis
/// \param from_axis  to the point
template <class Point, class W>
RAIO_FN constexpr vec3<W> turned_at_apex(const Point& at, const vec3<W>& axis, const W& widening,
                                         const vec3<W>& from_axis, const vec3<W>& outward) {
    using E = bound_t<W>;
    const E size = norm1(vec3<E>(axis)), lean = min(abs(E(widening)), size);
    const E rounding = E(8 * unit_roundoff<W>) * size, error = at.blur() + rounding;
    // An error turns the normal by its share of the distance from the axis.
    const mask_t<W> doubtful = every(widening != W(0), norm1(vec3<E>(from_axis)) * lean <= E(16) * error * size);
    if (none(doubtful)) return outward;
    // The height may be off by all that is left of the cone. The way from the axis is not, where the ray runs along it,
    // and says the radius as well.
    const W axis2 = dot(axis, axis);
    const auto across = [&](const vec3<W>& v) { return v - axis * (dot(v, axis) / axis2); };
    vec3<W> beside = across(from_axis), tip = axis * copysign(W(1), -widening), d = at.direction();
    const mask_t<W> on_axis = norm1(vec3<E>(beside)) <= norm1(vec3<E>(across(d))) * at.crossing().error + rounding;
    vec3<W> turned = select(on_axis, tip, beside + tip * (abs(widening) * length(beside) / axis2));
    return select(doubtful, detail::turned_from(d, at.entering(), turned), outward);
}

/// Is the point so close to the axis that a double has no digits to spare for the normal?
/// \param reach  how far the shape goes along the axis from the base, in lengths of that
template <class Point, real T, class W>
RAIO_FN constexpr auto is_close_to_axis(const Point& at, const vec3<T>& base, const vec3<W>& axis, const T& reach) {
    using E = bound_t<W>;
    const vec3<W> from_base = at.from(base);
    const E size = norm1(vec3<E>(axis)), farthest = norm1(vec3<E>(from_base)) + size * E(W(reach));
    return norm1(vec3<E>(cross(from_base, axis))) < E(0x1p-8) * size * farthest;
}

}  // namespace raio
