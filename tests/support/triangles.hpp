#pragma once

#include "support/cases.hpp"
#include "support/sampling.hpp"

namespace raio::test {

/// What the tests know of both triangles.
template <class Triangle>
struct triangle_subject {
    using T = number_t<Triangle>;

    static auto fields(auto& s) { return std::tie(s.a, s.b, s.c); }

    /// One in four is a sliver.
    static Triangle random(random_numbers& random, double size, const vec3<double>& place) {
        const vec3<double> a = place + random.direction() * size, b = place + random.direction() * size;
        const vec3<double> c = random.one_in(4) ? a + (b - a) * random.uniform() + random.direction() * (size * 1e-3)
                                                : place + random.direction() * size;
        return {vec3<T>(a), vec3<T>(b), vec3<T>(c)};
    }
    static vec3<double> at(const Triangle& s, double u, double v) {
        const vec3<double> a = to_double(s.a);
        return a + (to_double(s.b) - a) * u + (to_double(s.c) - a) * v;
    }
    static vec3<double> inner_point(const Triangle& s, random_numbers& random) {
        const double u = random.uniform(0.01, 0.98);
        return at(s, u, random.uniform(0.01, 0.99 - u));
    }
    /// On an edge, or a vertex.
    static vec3<double> special_point(const Triangle& s, const vec3<double>&, random_numbers& random) {
        const double along = random.one_in(2) ? 0 : random.uniform();
        const int edge = random.integer(0, 2);
        return edge == 0 ? at(s, along, 0) : edge == 1 ? at(s, 1 - along, along) : at(s, 0, 1 - along);
    }
    /// The height above the plane, or how far the point is beyond the edge that it is farthest beyond.
    static oracle distance(const triangle<oracle>& s, const vec3<oracle>& p) {
        const vec3<oracle> n = normalize(cross(vec3<oracle>(s.b - s.a), vec3<oracle>(s.c - s.a)));
        oracle worst = abs(dot(n, vec3<oracle>(p - s.a)));
        const vec3<oracle> corners[] = {s.a, s.b, s.c};
        for (int i = 0; i < 3; ++i) {
            const vec3<oracle> edge = corners[(i + 1) % 3] - corners[i], from_edge = p - corners[i];
            worst = max(worst, oracle(-dot(cross(edge, from_edge), n) / length(edge)));
        }
        return worst;
    }
};

template <class T>
struct subject<triangle<T>> : triangle_subject<triangle<T>> {};
template <class T>
struct subject<watertight_triangle<T>> : triangle_subject<watertight_triangle<T>> {};

/// The cases of both triangles.
template <class Triangle>
void check_triangle_cases() {
    using T = number_t<Triangle>;
    constexpr T eps = std::numeric_limits<T>::epsilon(), tiny = T(0x1p-40);
    const Triangle unit{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const auto from = [](T x, T y) { return ray<T>{{x, y, 5}, {0, 0, -1}}; };
    const ray<T> ahead = from(0.25, 0.25);
    check_cases<Triangle>({
        {"from the front", unit, ahead, enters(5)},
        {"from the back", unit, {{0.25, 0.25, -5}, {0, 0, 1}}, leaves(5)},
        {"wound the other way", {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, ahead, leaves(5)},
        {"behind the ray", unit, {{0.25, 0.25, 5}, {0, 0, 1}}, misses},
        {"from a point of the triangle", unit, {{0.25, 0.25, 0}, {0, 0, -1}}, enters(0)},
        {"on vertex a", unit, from(0, 0), enters(5)},
        {"on vertex b", unit, from(1, 0), enters(5)},
        {"on vertex c", unit, from(0, 1), enters(5)},
        {"on edge ab", unit, from(0.5, 0), enters(5)},
        {"on edge ca", unit, from(0, 0.5), enters(5)},
        {"on edge bc", unit, from(0.5, 0.5), enters(5)},
        {"on edge bc, obliquely", unit, {{1, 1, 1}, {-1, -1, -2}}, enters(0.5)},
        {"on vertex b, where t is a third", unit, {{0, 1, 1}, {3, -3, -3}}, enters(1.0 / 3)},
        {"on edge bc, where t is a third", unit, {{0.5, 1.5, 1}, {0, -3, -3}}, enters(1.0 / 3)},
        {"by a hair beyond edge ab", unit, from(0.5, -0x1p-80), misses},
        {"by a hair beyond edge ca", unit, from(-0x1p-80, 0.5), misses},
        {"one number beyond edge bc", unit, from(0.5 + eps / 2, 0.5), misses},
        {"one number within edge bc", unit, from(0.5 - eps / 4, 0.5), enters(5)},
        {"u and v small, their sum too large (barycentrics beyond [0, 1])", unit, from(0.75, 0.75), misses},
        {"u above 1", unit, from(1.5, 0.25), misses},
        {"v below 0", unit, from(0.25, -0.5), misses},
        {"in its plane", unit, {{-5, 0.25, 0}, {1, 0, 0}}, misses},
        {"in its plane, along an edge", unit, {{-5, 0, 0}, {1, 0, -0.0}}, misses},
        {"in its slanted plane", {{0, 0, 0}, {1, 2, 3}, {3, 1, 2}}, {{5, 5, 7}, {-4, -3, -5}}, misses},
        {"in its slanted plane, from a vertex", {{0, 0, 0}, {1, 2, 3}, {3, 1, 2}}, {{0, 0, 0}, {4, 3, 5}}, misses},
        {"parallel to its plane", unit, {{-5, 0.25, 1}, {1, 0, 0}}, misses},
        {"of the size of a millimetre (absolute epsilon)",
         {{0, 0, 0}, {0x1p-10, 0, 0}, {0, 0x1p-10, 0}},
         from(0x1p-12, 0x1p-12),
         enters(5)},
        {"of the size of an atom (absolute epsilon)",
         {{0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}},
         from(tiny / 4, tiny / 4),
         enters(5)},
        {"sliver", {{0, 0, 0}, {1, 0, 0}, {0.5, tiny, 0}}, from(0.5, tiny / 2), enters(5)},
        {"beside the sliver", {{0, 0, 0}, {1, 0, 0}, {0.5, tiny, 0}}, from(0.5, tiny * 2), misses},
        {"corners in a line", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, from(0.5, 0), misses},
        {"corners in a slanted line", {{0, 0, 0}, {1, 3, 7}, {3, 9, 21}}, {{1, 3, 12}, {0, 0, -1}}, misses},
        {"two corners in one", {{0, 0, 0}, {1, 1, 0}, {1, 1, 0}}, from(0.5, 0.5), misses},
        {"three corners in one", {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, from(0, 0), misses},
        {"direction zero", unit, {{0.25, 0.25, 0}, {0, 0, 0}}, misses},
        {"direction of length 1e-20", unit, {{0.25, 0.25, 5}, {0, 0, -0x1p-66}}, enters(5 * 0x1p66)},
        {"direction of length 1e20", unit, {{0.25, 0.25, 5}, {0, 0, -0x1p66}}, enters(5 * 0x1p-66)},
        {"window ends at the crossing", unit, ahead, enters(5), 0, 5},
        {"window that is not a number", unit, ahead, misses, nan<T>},
    });
}

template <class Triangle>
void check_triangle_sampling() {
    using T = number_t<Triangle>;
    CHECK(Triangle{{1, 1, 1}, {4, 1, 1}, {1, 5, 1}}.area() == T(6));
    CHECK(Triangle{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}}.area() == T(0));
    const auto to_square = [](const hit_record<T>& rec) {
        const T sum = rec.uv.x + rec.uv.y;
        return vec2<T>(sum * sum, rec.uv.y / sum);
    };
    check_sampling(Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, to_square);
    check_sampling(Triangle{{1, 2, 3}, {4, 0, 7}, {-3, 1, 1}}, to_square);
}

}  // namespace raio::test
