#pragma once

#include <raio/push_macros.hpp>

#include <vector>

#include <raio/concepts.hpp>
#include <raio/formula/plane.hpp>
#include <raio/formula/polyhedron_faces.hpp>
#include <raio/math/angle.hpp>
#include <raio/math/frame.hpp>
#include <raio/proof/lanes.hpp>
#include <raio/proof/line.hpp>
#include <raio/surface_sample.hpp>

namespace raio::inline RAIO_ABI {

namespace detail {

/// A range of planes of packs P, as one lane has them.
template <class P, class Planes>
struct planes_in_lane {
    struct iterator {
        const planes_in_lane* of;
        std::size_t i;

        RAIO_FN auto operator*() const { return (*of)[i]; }
        RAIO_FN iterator& operator++() { return ++i, *this; }
        RAIO_FN bool operator!=(const iterator& other) const { return i != other.i; }
    };

    const Planes* planes;
    std::size_t lane;

    RAIO_FN std::size_t size() const { return std::size(*planes); }
    RAIO_FN auto operator[](std::size_t i) const { return in_lane<P>((*planes)[i], lane); }
    RAIO_FN iterator begin() const { return {this, 0}; }
    RAIO_FN iterator end() const { return {this, size()}; }
};

}  // namespace detail

/// The points behind all of its planes. Any number of planes, in any order; redundant ones do no harm, contradictory
/// ones leave nothing, and too few leave a solid without end.
///
/// A line enters through the planes whose normals are against it and leaves through the others. It is inside from the
/// last plane entered to the first plane left, if these come in that order (Cyrus and Beck 1978; Haines, Graphics Gems
/// II, 1991).
///
/// The planes stand in any contiguous range: a vector that the polyhedron owns, an array, or a span of somebody else's.
/// Faces are counted as the planes are. uv: the two coordinates of the point in the plane of the face, without their
/// whole parts.
template <real T, class Planes = std::vector<half_space<T>>>
struct convex_polyhedron {
    using number = T;

    Planes planes;

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr interval<T> spans(const ray<T>& ray) const { return inside_of(*this, ray); }

    /// The box around all edges; the cost grows with the cube of the number of planes. A polyhedron without end is
    /// bounded by everything.
    RAIO_FN constexpr aabb<T> bounds() const requires(std::same_as<mask_t<T>, bool>) {
        aabb<T> box;
        bool has_vertex = false;
        const bool ends = faces().for_each_edge([&](const vec3<exact>& from, const vec3<exact>& to) {
            has_vertex = true;
            box = hull(hull(box, vec3<T>(from)), vec3<T>(to));
        });
        box = ends && has_vertex ? padded(box) : unbounded<T>();
        for (const half_space<T>& plane : planes) box = unless_nan(box, plane.normal, plane.offset);
        return box;
    }

    /// Infinite for a polyhedron without end.
    RAIO_FN constexpr T area() const requires(std::same_as<mask_t<T>, bool>) {
        exact total(0);
        const bool ends = faces().for_each_triangle([&](const face_triangle<T>& part) { total += part.area; });
        return ends ? T(total) : infinity<T>;
    }

    /// Of one that has an end, and takes as long as `area`. The triangles that its faces are made of stand side by side
    /// along u.x, the last one first; what is left of it within one, and u.y, choose the point.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const requires(std::same_as<mask_t<T>, bool>) {
        exact total(0), left(u.x), one(1);
        face_triangle<T> chosen{};
        faces().for_each_triangle([&](const face_triangle<T>& part) {
            if (!(part.area > exact(0))) return;
            total += part.area;
            const exact share = part.area / total;
            const bool here = left < share;
            left = here ? left / share : (left - share) / (one - share);
            if (here) chosen = part;
        });
        const auto& [a, b, c, area, normal] = chosen;
        const vec3<exact> across = (b - a) * (one - exact(u.y)) + (c - a) * exact(u.y);
        return {vec3<T>(a + across * sqrt(min(left, one))), normalize(normal)};
    }

    template <class Line>
    RAIO_FORMULA constexpr chord<typename Line::number> crossings(const Line& line) const {
        auto c = inside(line);
        keep_if_in_range<T>(line, c);  // no point beyond the largest number
        return c;
    }

    /// The part of the line that is inside. Where that does not begin, or does not end, t is infinite.
    template <class Line>
    RAIO_FORMULA constexpr chord<typename Line::number> inside(const Line& line) const {
        using W = typename Line::number;
        const auto origin = line.from(vec3<T>(T(0)));
        chord<W> c = everywhere<W>();
        index_t<W> face{};
        for (const half_space<T>& plane : planes) {
            const auto n = line.given(plane.normal);
            const auto height = dot(n, origin) + line.given(plane.offset);
            const auto speed = dot(n, line.direction());
            c = intersect(c, cross_half_space(height, speed, face));
            if (missed(c)) break;
            face = face + index_t<W>(1);
        }
        return c;
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        const half_space<T> plane = plane_of(at.face());
        const vec3<T>& n = plane.normal;
        at.record_point();
        const auto axis_at = [&](const T& n_i) { return quotient(-plane.offset, n_i, T(0)); };
        put_onto_plane(at, n, {axis_at(n.x), axis_at(n.y), axis_at(n.z)});
        at.record_normal(n);
        at.record_uv([&] {
            vec3<T> up(normalize_from<T>(vec3<typename Point::precise>(n)));
            vec3<T> local = frame_about(up).to_local(at.point());
            return vec2<T>(fraction(local.x), fraction(local.y));
        });
    }

    /// What is in one lane of packs.
    RAIO_FN auto in_lane(std::size_t lane) const requires detail::has_lanes<T> {
        using own = detail::planes_in_lane<T, Planes>;
        return convex_polyhedron<scalar_t<T>, own>{own{&planes, lane}};
    }

private:
    using exact = exact_t<T>;

    RAIO_FN constexpr polyhedron_faces<T, Planes> faces() const { return {planes}; }

    /// Of the lanes of a pack each may have met another face.
    template <class Index>
    RAIO_FN constexpr half_space<T> plane_of(const Index& face) const {
        if constexpr (requires { planes[face]; }) {
            return planes[face];
        } else {
            half_space<T> met{vec3<T>(T(0)), T(0)};
            Index index(0);
            for (const half_space<T>& plane : planes) {
                const auto is_met = face == index;
                met = {select(is_met, plane.normal, met.normal), select(is_met, plane.offset, met.offset)};
                index = index + Index(1);
            }
            return met;
        }
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
