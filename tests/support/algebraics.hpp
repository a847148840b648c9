#pragma once

#include <algorithm>

#include "support/subject.hpp"

/// \file
/// Surfaces that are known by a function only: where they are is found by asking it.

namespace raio::test {

template <class T, std::size_t Degree, bool Closed>
inline constexpr bool is_flat<algebraic<T, Degree, Closed>> = false;
template <class T, std::size_t Degree, bool Closed>
inline constexpr bool is_convex<algebraic<T, Degree, Closed>> = false;

/// Any point of a box.
inline vec3<double> point_between(const vec3<double>& low, const vec3<double>& high, random_numbers& random) {
    vec3<double> p;
    for (glm::length_t axis = 0; axis < 3; ++axis) p[axis] = random.uniform(low[axis], high[axis]);
    return p;
}

/// Between a place where the answer is yes and one where it is no: the last yes, to so many bits.
template <class Ask>
vec3<double> last_yes(vec3<double> yes, vec3<double> no, int bits, Ask ask) {
    for (int i = 0; i < bits; ++i) {
        const vec3<double> middle = (yes + no) * 0.5;
        (ask(middle) ? yes : no) = middle;
    }
    return yes;
}

/// A point that a ray from there only just hits, or, if none is found, one in sight.
template <class Shape>
vec3<double> grazed_point(const Shape& s, const vec3<double>& from, const vec3<double>& inside, double size,
                          random_numbers& random) {
    using T = number_t<Shape>;
    const auto in_sight = [&](const vec3<double>& p) {
        return s.occluded({vec3<T>(from), vec3<T>(p - from)}, T(0), infinity<T>);
    };
    if (inside == from) return inside;
    const vec3<double> beside = inside + random.perpendicular(inside - from) * (2 * size);
    if (!in_sight(inside) || in_sight(beside)) return inside;
    return last_yes(inside, beside, random.integer(8, 52), in_sight);
}

/// To the surface f = 0, to first order, which is all of it near the surface; f itself where it has no gradient.
inline oracle distance_by_gradient(const oracle& f, const vec3<oracle>& gradient) {
    const oracle steep = length(gradient);
    return steep > 0 ? f / steep : f;
}

/// To the faces of a box, below 0 inside.
inline oracle distance_to_box(const vec3<oracle>& low, const vec3<oracle>& high, const vec3<oracle>& p) {
    oracle most = -infinity<oracle>;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        most = max(most, max(low[axis] - p[axis], p[axis] - high[axis]));
    }
    return most;
}

/// What stands in a box: the origin, too, which is inside of it.
template <class Shape>
struct boxed_subject {
    static double value(const Shape& s, const vec3<double>& p) { return s.template value<double>(p); }

    /// In the solid, or on the surface if that is all there is.
    static vec3<double> inner_point(const Shape& s, random_numbers& random) {
        const auto inside = [&](const vec3<double>& p) { return value(s, p) < 0; };
        for (int tries = 0;; ++tries) {
            const vec3<double> p = point_between(to_double(s.min), to_double(s.max), random) * 0.99, origin(0);
            if (solid<Shape>) return inside(p) ? p : last_yes(origin, p, 30, inside);
            if (!inside(p)) return last_yes(origin, p, 60, inside);
            if (tries == 1000) return last_yes(p, to_double(s.max), 60, inside);
        }
    }
    /// On a silhouette, at a corner or an edge of the box, or where the surface meets a face.
    static vec3<double> special_point(const Shape& s, const vec3<double>& from, random_numbers& random) {
        const vec3<double> low = to_double(s.min), high = to_double(s.max), inside = inner_point(s, random);
        vec3<double> p = point_between(low, high, random);
        const int kind = random.integer(0, 5);
        if (kind > 2) return grazed_point(s, from, inside, length(high - low), random);
        for (glm::length_t axis = 0; axis <= kind; ++axis) p[axis] = random.one_in(2) ? low[axis] : high[axis];
        if (kind > 0) return p;
        vec3<double> on_face = inside;
        on_face.x = p.x;
        return last_yes(on_face, p, 60,
                        [&](const vec3<double>& q) { return (value(s, q) < 0) == (value(s, on_face) < 0); });
    }
    template <class Exact>
    static oracle distance(const Exact& s, const vec3<oracle>& p) {
        const oracle off = distance_by_gradient(s.value(p), s.gradient(p)), beyond = distance_to_box(s.min, s.max, p);
        // A surface ends where it leaves the box: beyond, it is not as far as the box.
        return solid<Shape> ? max(beyond, off) : max(oracle(beyond / 2), oracle(abs(off)));
    }
};

}  // namespace raio::test
