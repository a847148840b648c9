#pragma once

#include <raio/push_macros.hpp>

#include <raio/proof/record.hpp>

/// \file
/// What is recorded where few digits are left of a normal: close to an apex, beside folds.

namespace raio::inline RAIO_ABI {

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

/// Is what is left of a sum no more than a few thousand roundings of its terms?
template <class Q>
RAIO_FN constexpr mask_t<Q> is_mostly_rounding(const vec3<Q>& sum, const Q& terms) {
    return norm1(sum) <= Q(0x1p12 * unit_roundoff<Q>) * terms;
}

/// A vector across a surface, mirrored where errors have turned it along the ray.
/// \param direction  unit
/// \param side       1 if the ray enters, -1 if it leaves
template <class Q>
RAIO_FN constexpr vec3<Q> mirrored_against(const vec3<Q>& outward, const vec3<Q>& direction, const Q& side) {
    return outward - direction * (Q(2) * max(Q(0), dot(outward, direction) * side) * side);
}

namespace detail {

/// A shape that asks for more digits than T has, close to a tip.
template <class Shape, class At>
concept has_tips = requires(const Shape shape, const At at) {
    shape.is_close_to_tip(at);
};

/// What the shape records of a crossing.
template <class Shape, class Ray, class W, record Record>
RAIO_FN constexpr void record_crossing(const Shape& shape, const Ray& ray, const crossing<W>& crossing, Record& rec);

/// The same with all digits that there are. Close to a tip only, so that it is out of line.
template <class Shape, class Ray, class W, record Record>
RAIO_RARELY RAIO_FN constexpr void record_closer(const Shape& shape, const Ray& ray, const crossing<W>& c,
                                                 Record& rec) {
    using X = exact_t<typename Shape::number>;
    const auto wider = [](const W& x) { return X(bound_t<X>(x)); };
    const crossing<X> same{c.exists,   c.certain,  wider(c.t), bound_t<X>(c.error), c.entering, c.face,
                           wider(c.u), wider(c.v), c.shared};
    record_crossing(shape, ray, same, rec);
}

template <class Shape, class Ray, class W, record Record>
RAIO_FN constexpr void record_crossing(const Shape& shape, const Ray& ray, const crossing<W>& crossing, Record& rec) {
    using T = typename Shape::number;
    using point = surface_point<W, T, Ray, Record>;
    point at(ray, crossing, rec);
    shape.surface(at);
    at.fill(rec);
    if constexpr (lacks_digits<T, W> && has_tips<Shape, point>) {
        const mask_t<T> close(shape.is_close_to_tip(at));
        if (any(close)) [[unlikely]] {
            Record closer;
            record_closer(shape, ray, crossing, closer);
            assign(close, rec, closer);
        }
    }
}

}  // namespace detail

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
