#pragma once

#include <raio/math/vec.hpp>

namespace raio {

/// The two solutions of a t^2 - 2 b t + c = 0, the lower one first.
/// \param over_a  1 / a, above 0
/// \param c       infinite if it is not known
/// \param s       the root of b^2 - a c, found without that difference, which cancels
///
/// Of b - s and b + s one cancels where c is small: where the ray starts near the surface. Their product is a c, so the
/// last precision, which nobody comes to correct, finds that one from the other.
template <real W>
RAIO_FN constexpr vec2<W> quadratic_roots(const W& over_a, const W& b, const W& c, const W& s) {
    vec2<W> roots((b - s) * over_a, (b + s) * over_a);
    if constexpr (last_precision<W>) {
        W sum = b + copysign(s, b);
        if (abs(b) < s + s && is_finite(c)) (sum > W(0) ? roots.x : roots.y) = c / sum;
    }
    return roots;
}

}  // namespace raio
