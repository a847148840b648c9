#pragma once

#include <raio/push_macros.hpp>

#include <raio/proof/polynomial_crossings.hpp>

/// \file
/// Where a line crosses an algebraic surface f(p) = 0, whose solid is where f is negative.
///
/// Along a line f is a polynomial. Its coefficients are those of a part of the line that lies near the shape and has
/// its size: p(x) = from + x along, t = middle + x half. So no power of a far origin cancels, and all that counts lies
/// between x = -1 and 1. The coordinates of p(x) are polynomials of degree 1, and f is computed with them as with
/// numbers (math/polynomial.hpp); its roots are isolated (math/polynomial_roots.hpp).

namespace raio {

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

}  // namespace raio

#include <raio/pop_macros.hpp>
