#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/vec.hpp>

namespace raio::inline RAIO_ABI {

/// An axis-aligned bounding box: all points with `min <= point <= max` in every coordinate. Without points when it is
/// new.
template <real T>
struct aabb {
    vec3<T> min{infinity<T>};
    vec3<T> max{-infinity<T>};

    RAIO_FN constexpr mask_t<T> contains(const vec3<T>& point) const {
        return min.x <= point.x && point.x <= max.x && min.y <= point.y && point.y <= max.y && min.z <= point.z &&
               point.z <= max.z;
    }

    /// Half of the surface area: what the surface area heuristic compares. Zero for a box without points.
    RAIO_FN constexpr T half_area() const {
        vec3<T> size = max - min;
        const T area = size.x * size.y + size.y * size.z + size.z * size.x;
        return select(min.x <= max.x, area, T(0));
    }
};

/// Is one of the sides no number?
template <real T>
RAIO_FN constexpr mask_t<T> is_nan(const aabb<T>& box) {
    return some(is_nan(box.min), is_nan(box.max));
}

/// The box of what is made of these numbers, vectors and boxes. If one of them is NaN, so is every side: minimum and
/// maximum of a NaN depend on its place, and a box that leaves it out would hide it from trees, which refuse NaN.
template <real T, class... Made>
RAIO_FN constexpr aabb<T> unless_nan(const aabb<T>& box, const Made&... made_of) {
    const mask_t<T> nan = (is_nan(made_of) || ...);
    const vec3<T> none{T(std::numeric_limits<scalar_t<T>>::quiet_NaN())};
    return {select(nan, none, box.min), select(nan, none, box.max)};
}

/// The smallest box that contains both, if all sides are numbers, which is not asked.
template <real T>
RAIO_FN constexpr aabb<T> hull_of_numbers(const aabb<T>& a, const aabb<T>& b) {
    return {min(a.min, b.min), max(a.max, b.max)};
}
template <real T>
RAIO_FN constexpr aabb<T> hull_of_numbers(const aabb<T>& box, const vec3<T>& point) {
    return hull_of_numbers(box, aabb<T>{point, point});
}

/// The smallest box that contains both; NaN, if one is.
template <real T>
RAIO_FN constexpr aabb<T> hull(const aabb<T>& a, const aabb<T>& b) {
    return unless_nan(hull_of_numbers(a, b), a, b);
}

template <real T>
RAIO_FN constexpr aabb<T> hull(const aabb<T>& box, const vec3<T>& point) {
    return hull(box, aabb<T>{point, point});
}

/// The points that both contain.
template <real T>
RAIO_FN constexpr aabb<T> overlap(const aabb<T>& a, const aabb<T>& b) {
    return unless_nan(aabb<T>{max(a.min, b.min), min(a.max, b.max)}, a, b);
}

/// The point of the box that is nearest to this one. A side of the box that is no number bounds nothing.
template <real T>
RAIO_FN constexpr vec3<T> nearest_in(const aabb<T>& box, const vec3<T>& point) {
    return max(min(point, box.max), box.min);
}

/// `x` moved by at least one ulp in the direction of `towards`, and by at most two.
template <real T>
RAIO_FN constexpr T outward(const T& x, const T& towards) {
    using S = scalar_t<T>;
    return x + copysign(abs(x) * T(std::numeric_limits<S>::epsilon()) + T(std::numeric_limits<S>::min()), towards);
}

/// How much room `padded` leaves for what points are off by before they are rounded to T, in roundings of the largest
/// coordinate. Those of floats are found in double: a 32nd is enough from a million sizes away. Those of doubles are
/// found in double as well, and off by a few dozen roundings of the ray's way: 2^10 is enough from some ten sizes away.
template <real T>
inline constexpr double padding = unit_roundoff<T> <= unit_roundoff<working_t<T>> ? 0x1p10 : 0x1p-5;

/// The box with every side moved outwards by an ulp or two, so that a point that was rounded onto it stays inside; and
/// by the `padding`, which is of the largest coordinate: a side at 0 has no ulp of its own to speak of.
template <real T>
RAIO_FN constexpr aabb<T> padded(const aabb<T>& box) {
    const auto largest = [](const vec3<T>& v) {
        const auto size = [](const T& x) { return select(is_finite(x), abs(x), T(0)); };
        return max(max(size(v.x), size(v.y)), size(v.z));
    };
    const T up(1), down(-1), blur = max(largest(box.min), largest(box.max)) * T(padding<T> * unit_roundoff<T>);
    return {vec3<T>(outward(box.min.x, down), outward(box.min.y, down), outward(box.min.z, down)) - vec3<T>(blur),
            vec3<T>(outward(box.max.x, up), outward(box.max.y, up), outward(box.max.z, up)) + vec3<T>(blur)};
}

/// How far a disc reaches along each axis: the radius times the sine of the angle between the axis and the normal.
/// Nowhere, if there is no normal. The same bits from every build, which a point may be put back to.
template <real T>
RAIO_FN constexpr vec3<T> disc_reach(const vec3<T>& normal, const T& radius) {
    using W = working_t<T>;
    vec3<W> n = scaled_into_range<T>(vec3<W>(normal)), n2 = n * n;
    const W over = quotient(W(1), n2.x + n2.y + n2.z, W(0)), reach = W(radius) * W(1 + 8 * unit_roundoff<T>);
    vec3<W> sines(sqrt((n2.y + n2.z) * over), sqrt((n2.z + n2.x) * over), sqrt((n2.x + n2.y) * over));
    return vec3<T>(sines * reach);
}

/// The everything box, of shapes without end.
template <real T>
RAIO_FN constexpr aabb<T> unbounded() {
    return {vec3<T>(-infinity<T>), vec3<T>(infinity<T>)};
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
