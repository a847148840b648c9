#pragma once

#include "support/subject.hpp"

namespace raio::test {

template <class T>
struct subject<convex_polyhedron<T>> {
    static auto fields(auto& s) { return std::tie(s.planes); }

    /// A box and a few planes more, each as far from the centre as random chance would have it.
    static convex_polyhedron<T> random(random_numbers& random, double size, const vec3<double>& place) {
        convex_polyhedron<T> s;
        for (int i = random.integer(6, 9); i > 0; --i) {
            vec3<double> n = random.direction() * random.uniform(0.5, 2);
            if (i <= 6) n = vec3<double>(0), n[(i - 1) / 2] = i % 2 ? 1 : -1;
            const double offset = -(dot(n, place) + length(n) * size * random.uniform(0.5, 1));
            s.planes.push_back({vec3<T>(n), static_cast<T>(offset)});
        }
        return s;
    }
    static convex_polyhedron<T> lattice(random_numbers& random) {
        convex_polyhedron<T> s = subject::random(random, 1, vec3<double>(0));
        for (half_space<T>& plane : s.planes) {
            if (random.one_in(4)) for_each_number(plane.normal, [&](T& x) { x = T(random.integer(-2, 2)); });
            plane.offset = T(random.integer(-3, 0));
        }
        return s;
    }
    /// Where three planes meet; the origin if that is nowhere.
    static vec3<double> vertex(const half_space<T>& a, const half_space<T>& b, const half_space<T>& c) {
        const vec3<double> n = to_double(a.normal), m = to_double(b.normal), k = to_double(c.normal);
        const double det = dot(n, cross(m, k));
        if (std::abs(det) < 1e-3) return vec3<double>(0);
        return (cross(m, k) * static_cast<double>(a.offset) + cross(k, n) * static_cast<double>(b.offset) +
                cross(n, m) * static_cast<double>(c.offset)) *
               (-1 / det);
    }
    static double height(const convex_polyhedron<T>& s, const vec3<double>& p) {
        double highest = -infinity<double>;
        for (const half_space<T>& plane : s.planes) {
            const vec3<double> n = to_double(plane.normal);
            highest = std::max(highest, (dot(n, p) + static_cast<double>(plane.offset)) / length(n));
        }
        return highest;
    }
    static vec3<double> random_vertex(const convex_polyhedron<T>& s, random_numbers& random) {
        const auto any = [&] {
            return s.planes[static_cast<std::size_t>(random.integer(0, int(s.planes.size()) - 1))];
        };
        return vertex(any(), any(), any());
    }
    /// The box's centre lies inside, and so does whatever is near enough to it.
    static vec3<double> inner_point(const convex_polyhedron<T>& s, random_numbers& random) {
        const std::size_t n = s.planes.size();
        const vec3<double> a = vertex(s.planes[n - 1], s.planes[n - 3], s.planes[n - 5]);
        const vec3<double> b = vertex(s.planes[n - 2], s.planes[n - 4], s.planes[n - 6]);
        const vec3<double> center = (a + b) * 0.5;
        const double room = -height(s, center);
        return room > 0 ? center + random.direction() * (0.99 * room * random.uniform()) : center;
    }
    /// A vertex, or a point on the line between two of them.
    static vec3<double> special_point(const convex_polyhedron<T>& s, const vec3<double>&, random_numbers& random) {
        const vec3<double> a = random_vertex(s, random), b = random_vertex(s, random);
        return random.one_in(2) ? a : a + (b - a) * random.uniform();
    }
    static oracle distance(const convex_polyhedron<oracle>& s, const vec3<oracle>& p) {
        oracle highest = -infinity<oracle>;
        for (const auto& plane : s.planes) {
            highest = max(highest, oracle((dot(plane.normal, p) + plane.offset) / length(plane.normal)));
        }
        return highest;
    }
    static convex_polyhedron<oracle> grown(convex_polyhedron<oracle> s) {
        for (auto& plane : s.planes) plane.offset -= (abs(plane.offset) + norm1(plane.normal)) * oracle(1e-40);
        return s;
    }
};

}  // namespace raio::test
