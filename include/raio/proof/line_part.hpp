#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/polynomial.hpp>
#include <raio/proof/crossing_list.hpp>
#include <raio/proof/line.hpp>

namespace raio::inline RAIO_ABI {

/// Is a point known to less than a 2^13th of a size? So far away that it is not, places cannot be told apart.
template <class W>
RAIO_FN constexpr verdict<mask_t<W>> is_located(const bounded_vector<W>& p, const given_number<W>& size) {
    const mask_t<W> known = p.error < bound_t<W>(0x1p-13) * size_of(size);
    return {known, W(0) == W(0), known};
}

/// A part of a line. The point at x, as seen from some base, is from + x along; it is that of the ray at t = middle + x
/// half. Middle and half are given: whatever they were rounded to, that is the part that is meant.
template <class W>
struct line_part {
    using E = bound_t<W>;

    bool exists, certain;  ///< is there one, and is that right whatever the rounding errors were?
    vec3<W> from{W(0)}, along{W(0)};
    vec3<E> error{E(0)};  ///< how far `from` may be off
    W middle{0}, half{0};
    W reach{1};  ///< all that counts lies between x = -reach and reach
    E turn{0};   ///< how far each component of `along` may be off, besides its rounding

    /// Is there one?
    RAIO_FN constexpr verdict<bool> is_there() const { return {exists && certain, exists || !certain, exists}; }

    /// One coordinate of the point, as a polynomial in x.
    RAIO_FN constexpr polynomial<W, 1> coordinate(glm::length_t axis) const {
        return {{from[axis], along[axis]}, {error[axis], E(unit_roundoff<W>) * abs(E(along[axis])) + turn}};
    }

    RAIO_FN constexpr polynomial_vector<W, 1> point() const { return {coordinate(0), coordinate(1), coordinate(2)}; }

    /// The same where a polynomial touches zero: at an extremum, which is known to a thousand roundings.
    RAIO_FN constexpr bounded_number<W> coordinate_where_touched(const polynomial_root<W>& root,
                                                                 glm::length_t axis) const {
        const E rounding = E(0x1p10 * unit_roundoff<W>) * abs(E(along[axis]));
        return {from[axis] + along[axis] * root.t, error[axis] + rounding + E(reach) * turn};
    }

    template <class Wanted>
    RAIO_FN constexpr wanted_roots<W> roots_for(const Wanted& wanted) const {
        return raio::roots_for(wanted, bounded_number<W>(middle, E(0)), given_number<W>{half});
    }

    RAIO_FN constexpr crossing<W> at(const polynomial_root<W>& root, bool entering) const {
        const bounded_number<W> t = given_number<W>{middle} + given_number<W>{half} * root.place();
        return {true, true, t.value, t.error * E(1 + 8 * unit_roundoff<E>), entering};
    }
};

/// The part of a line about `middle` on which something may be met that has a size, if it passes that. So far away that
/// the place cannot be told from others by that size, nobody knows.
template <class W, class Line, real T>
RAIO_FN constexpr line_part<W> part_of(const Line& line, const verdict<bool>& passes, const vec3<T>& base,
                                       const given_number<W>& size, const given_number<W>& middle,
                                       const given_number<W>& half, const W& reach) {
    using E = bound_t<W>;
    const auto origin = line.origin();
    const auto direction = line.direction();
    const auto to_origin = line.from(base);
    const auto step = direction * middle;
    const auto along = direction * half;
    bounded_vector<W> from{to_origin.x + step.x, to_origin.y + step.y, to_origin.z + step.z, E(0)};
    // Each component is off by a few roundings of what it is made of, and by what the ray is.
    const vec3<E> sizes = abs(vec3<E>(E(origin.x), E(origin.y), E(origin.z))) + abs(vec3<E>(vec3<W>(base))) +
                          abs(vec3<E>(E(step.x), E(step.y), E(step.z)));
    vec3<E> error = sizes * E(4 * unit_roundoff<W>);
    E turn(0);
    if constexpr (!Line::is_exact) {
        error += vec3<E>(origin.error + direction.error * size_of(middle));
        turn = direction.error * size_of(half);
    }
    from.error = norm1(error) + E(3) * E(reach) * turn;
    const verdict<bool> found = every(passes, is_located(from, size));
    return {found.yes,
            is_settled(found),
            {from.x, from.y, from.z},
            {along.x, along.y, along.z},
            error,
            middle.value,
            half.value,
            reach,
            turn};
}

/// The part of a line that passes a ball; the point at x is seen from `base`, where the shape's x = y = z = 0.
/// \param center  of the ball, as near to it as 2^-12 of the radius
template <class W, class Line, real T>
RAIO_FN constexpr line_part<W> part_near(const Line& line, const vec3<T>& base, const vec3<W>& center,
                                         const W& radius) {
    const auto d = line.direction();
    const auto l = line.to(center);
    // A little more than the ball, so that whatever it contains is clearly within.
    const auto size = line.given(radius * W(1 + 0x1p-8));
    const auto d2 = square(d);
    const auto size2 = square(size);
    const auto passes = every(is_positive(size), is_positive(d2), d2 * size2 >= square(cross(l, d)));
    if (!passes.yes) return {false, is_settled(passes)};

    // A line that starts within the ball is seen from its origin: what is close to it keeps its digits.
    const bool starts_within = (square(l) <= size2).yes;
    const auto middle = starts_within ? line.given(W(0)) : as_given(dot(l, d) * inverse(d2));
    const auto half = as_given(size * inverse(sqrt(d2)));
    return part_of(line, every(passes, is_positive(half)), base, size, middle, half, W(starts_within ? 2 : 1));
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
