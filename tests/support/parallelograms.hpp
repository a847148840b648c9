#pragma once

#include "support/subject.hpp"

namespace raio::test {

template <class T>
struct subject<parallelogram<T>> {
    static auto fields(auto& s) { return std::tie(s.corner, s.edge_u, s.edge_v); }

    /// One in four is a sliver.
    static parallelogram<T> random(random_numbers& random, double size, const vec3<double>& place) {
        const vec3<double> u = random.direction() * (size * random.log_uniform(0.1, 10));
        const vec3<double> v =
            random.one_in(4) ? u * random.uniform() + random.direction() * (size * 1e-3) : random.direction() * size;
        return {vec3<T>(place), vec3<T>(u), vec3<T>(v)};
    }
    static vec3<double> at(const parallelogram<T>& s, double u, double v) {
        return to_double(s.corner) + to_double(s.edge_u) * u + to_double(s.edge_v) * v;
    }
    static vec3<double> inner_point(const parallelogram<T>& s, random_numbers& random) {
        const double u = random.uniform(0.01, 0.99);
        return at(s, u, random.uniform(0.01, 0.99));
    }
    /// On an edge, or a corner.
    static vec3<double> special_point(const parallelogram<T>& s, const vec3<double>&, random_numbers& random) {
        const double along = random.one_in(2) ? 0 : random.uniform(), side = random.integer(0, 1);
        return random.one_in(2) ? at(s, along, side) : at(s, side, along);
    }
    /// The height above the plane, or how far the point is beyond the edge that it is farthest beyond.
    static oracle distance(const parallelogram<oracle>& s, const vec3<oracle>& p) {
        const vec3<oracle> normal = cross(s.edge_u, s.edge_v), n = normalize(normal), from_corner = p - s.corner;
        const auto beyond = [&](const vec3<oracle>& edge, const vec3<oracle>& other) {
            const vec3<oracle> across = normalize(cross(n, edge));
            const oracle x = dot(from_corner, across), width = dot(other, across);
            return width > 0 ? max(oracle(-x), oracle(x - width)) : max(x, oracle(width - x));
        };
        const oracle height = abs(dot(n, from_corner));
        return max(height, max(beyond(s.edge_u, s.edge_v), beyond(s.edge_v, s.edge_u)));
    }
};

}  // namespace raio::test
