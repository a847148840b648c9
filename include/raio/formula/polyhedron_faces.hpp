#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/interval.hpp>
#include <raio/math/vec.hpp>

namespace raio::inline RAIO_ABI {

/// The points p with normal.p + offset <= 0: everything behind a plane.
template <real T>
struct half_space {
    vec3<T> normal;  ///< outward, any length
    T offset;        ///< minus the normal times any point of the plane
};

/// A part of a face, whose normal it has.
template <real T>
struct face_triangle {
    vec3<exact_t<T>> a, b, c;
    exact_t<T> area;
    vec3<T> normal;
};

/// The edges and faces of the solid behind all planes of a range, found where the planes meet. Each edge asks all
/// planes, so that the cost of all grows with the cube of their number.
template <real T, class Planes>
struct polyhedron_faces {
    using exact = exact_t<T>;

    const Planes& planes;

    /// Calls `visit` with the ends of every edge. Answers whether all of them have an end.
    template <class Visit>
    RAIO_FN constexpr bool for_each_edge(Visit visit) const {
        for (std::size_t i = 0; i < std::size(planes); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const auto [point, direction, s] = edge(i, j);
                if (s.empty()) continue;
                if (!is_finite(s.min) || !is_finite(s.max)) return false;
                visit(point + direction * s.min, point + direction * s.max);
            }
        }
        return true;
    }

    /// Calls `visit` with triangles that all faces are made of. Answers whether the faces have an end.
    template <class Visit>
    RAIO_FN constexpr bool for_each_triangle(Visit visit) const {
        bool ends = true;
        for (std::size_t i = 0; i < std::size(planes); ++i) {
            if (!repeats_an_earlier_plane(i)) ends = for_each_triangle_of(i, visit) && ends;
        }
        return ends;
    }

private:
    /// Planes that meet at a smaller angle count as parallel, and a point as on a plane that is nearer, as a part of
    /// the numbers that it is found from.
    static constexpr double least_angle = 1024 * unit_roundoff<exact>, least_distance = 0x1p20 * unit_roundoff<exact>;

    /// The line in which two planes meet, and the part of it that belongs to the polyhedron.
    struct edge_line {
        vec3<exact> point, direction;
        interval<exact> s;
    };

    RAIO_FN constexpr edge_line edge(std::size_t i, std::size_t j) const {
        exact zero(0), tiny(least_angle);
        const vec3<exact> a(planes[i].normal), b(planes[j].normal), direction = cross(a, b);
        exact length2 = dot(direction, direction);
        if (!(length2 > tiny * dot(a, a) * dot(b, b))) return {direction, direction, {}};  // parallel planes

        const vec3<exact> point =
            (cross(direction, b) * exact(planes[i].offset) - cross(direction, a) * exact(planes[j].offset)) / length2;
        interval<exact> s{-infinity<exact>, infinity<exact>};
        for (std::size_t k = 0; k < std::size(planes); ++k) {
            if (k == i || k == j) continue;
            const vec3<exact> n(planes[k].normal);
            exact height = dot(n, point) + exact(planes[k].offset), speed = dot(n, direction);
            exact touching = tiny * (dot(abs(n), abs(point)) + abs(exact(planes[k].offset)));
            if (!(abs(speed) > tiny * dot(abs(n), abs(direction)))) {  // or numbers out of range
                if (height > touching) return {point, direction, {}};
            } else if (speed > zero) {
                s.max = min(s.max, (touching - height) / speed);
            } else {
                s.min = max(s.min, (touching - height) / speed);
            }
        }
        return {point, direction, s};
    }

    /// Whichever of its sides is inside.
    RAIO_FN constexpr bool is_same_plane(std::size_t i, std::size_t k) const {
        const vec3<exact> n(planes[i].normal), m(planes[k].normal), turn = cross(n, m);
        const vec3<exact> apart = n * exact(planes[k].offset) - m * exact(planes[i].offset);
        return dot(turn, turn) == exact(0) && dot(apart, apart) == exact(0);
    }
    RAIO_FN constexpr bool repeats_an_earlier_plane(std::size_t i) const {
        const vec3<exact> n(planes[i].normal);
        for (std::size_t k = 0; k < i; ++k) {
            if (dot(n, vec3<exact>(planes[k].normal)) > exact(0) && is_same_plane(i, k)) return true;
        }
        return false;
    }

    RAIO_FN constexpr bool touches(std::size_t k, const vec3<exact>& p) const {
        const vec3<exact> n(planes[k].normal);
        exact offset(planes[k].offset);
        return abs(dot(n, p) + offset) <= exact(least_distance) * (dot(abs(n), abs(p)) + abs(offset));
    }

    /// Is all of plane i a face, without an edge: does it lie behind all others, which run parallel to it?
    RAIO_FN constexpr bool is_face_without_end(std::size_t i) const {
        const exact zero(0), tiny(least_angle);
        const vec3<exact> n(planes[i].normal);
        exact length2 = dot(n, n);
        if (!(length2 > zero)) return false;
        const vec3<exact> foot = n * (-exact(planes[i].offset) / length2);
        for (std::size_t k = 0; k < std::size(planes); ++k) {
            const vec3<exact> m(planes[k].normal), turn = cross(n, m);
            if (dot(turn, turn) > tiny * length2 * dot(m, m)) return false;
            if (dot(m, foot) + exact(planes[k].offset) > zero && !touches(k, foot)) return false;
        }
        return true;
    }

    /// Calls `visit` with the triangles between the edges of face i and the first corner that is met. Answers whether
    /// the face has an end.
    template <class Visit>
    RAIO_FN constexpr bool for_each_triangle_of(std::size_t i, Visit visit) const {
        bool started = false;
        vec3<exact> corner(exact(0));
        for (std::size_t j = 0; j < std::size(planes); ++j) {
            if (j == i) continue;
            const auto [point, direction, s] = edge(i, j);
            if (s.empty()) continue;
            if (!is_finite(s.min) || !is_finite(s.max)) return false;
            const vec3<exact> from = point + direction * s.min, to = point + direction * s.max;
            bool seen = false;  // an edge that more than two planes go through counts once
            for (std::size_t k = 0; k < j; ++k) {
                seen = seen || (!is_same_plane(i, k) && touches(k, from) && touches(k, to));
            }
            if (seen) continue;
            if (!started) corner = from;
            started = true;
            const vec3<exact> twice_area = cross(from - corner, to - corner);
            visit(face_triangle<T>{corner, from, to, sqrt(dot(twice_area, twice_area)) / exact(2), planes[i].normal});
        }
        return !is_face_without_end(i);
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
