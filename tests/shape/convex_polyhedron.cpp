#include <raio/shape/convex_polyhedron.hpp>

#include "support/cases.hpp"

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

template <class T>
std::vector<half_space<T>> cube_and(std::vector<half_space<T>> more) {
    for (const T sign : {T(1), T(-1)}) {
        more.push_back({{sign, 0, 0}, -1});
        more.push_back({{0, sign, 0}, -1});
        more.push_back({{0, 0, sign}, -1});
    }
    return more;
}

TEST_CASE_TEMPLATE("convex_polyhedron: named cases", T, float, double) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    using solid = convex_polyhedron<T>;
    const solid cube{cube_and<T>({})};
    const ray<T> ahead{{0, 0, 5}, {0, 0, -1}};
    check_cases<solid>({
        {"a face", cube, ahead, enters(4)},
        {"behind the ray", cube, {{0, 0, 5}, {0, 0, 1}}, misses},
        {"from inside", cube, {{0.5, 0, 0}, {1, 0, 0}}, leaves(0.5)},
        {"beside", cube, {{1.5, 0, 5}, {0, 0, -1}}, misses},
        {"past an edge", cube, {{3, 0, 0}, {-1, 1, 0}}, misses},
        {"through two corners", cube, {{2, 2, 2}, {-1, -1, -1}}, enters(1)},
        {"touches an edge", cube, {{2, 0, 0}, {-1, 1, 0}}, enters(1)},
        {"touches a corner", cube, {{2, 0, 1}, {-1, 1, 0}}, enters(1)},
        {"touches an edge where t is a third", cube, {{-2, 2, 0.5}, {3, 3, 0}}, misses},
        {"in a face", cube, {{1, 0, 5}, {0, 0, -1}}, enters(4)},
        {"one number beyond the face", cube, {{1 + eps, 0, 5}, {0, 0, -1}}, misses},
        {"from a face inwards", cube, {{1, 0, 0}, {-1, 0, 0}}, enters(0)},
        {"from a face outwards", cube, {{1, 0, 0}, {1, 0, 0}}, leaves(0)},
        {"a redundant plane", {cube_and<T>({{{0, 0, 1}, -7}})}, ahead, enters(4)},
        {"a plane twice, with another length", {cube_and<T>({{{0, 0, 2}, -2}})}, ahead, enters(4)},
        {"a plane through a corner only", {cube_and<T>({{{1, 1, 1}, -3}})}, {{2, 2, 2}, {-1, -1, -1}}, enters(1)},
        {"a corner cut off", {cube_and<T>({{{1, 1, 1}, -1.5}})}, {{2, 2, 2}, {-1, -1, -1}}, enters(1.5)},
        {"contradictory planes", {cube_and<T>({{{0, 0, 1}, 2}})}, ahead, misses},
        {"contradictory planes, across them", {cube_and<T>({{{0, 0, 1}, 2}})}, {{5, 0, 0}, {-1, 0, 0}}, misses},
        {"only one plane", {{{{0, 1, 0}, 0}}}, {{0, 2, 0}, {0, -1, 0}}, enters(2)},
        {"only one plane, from within", {{{{0, 1, 0}, 0}}}, {{0, -2, 0}, {0, 1, 0}}, leaves(2)},
        {"only one plane, parallel within", {{{{0, 1, 0}, 0}}}, {{0, -2, 0}, {1, 0, 0}}, misses},
        {"only one plane, parallel in it", {{{{0, 1, 0}, 0}}}, {{0, 0, 0}, {1, 0, 0}}, misses},
        {"a slab, along it", {{{{0, 1, 0}, -1}, {{0, -1, 0}, -1}}}, {{0, 0, 0}, {1, 0, 0}}, misses},
        {"a slab, across it", {{{{0, 1, 0}, -1}, {{0, -1, 0}, -1}}}, {{0, 5, 0}, {0, -1, 0}}, enters(4)},
        {"no plane at all", {{}}, ahead, misses},
        {"normal zero", {cube_and<T>({{{0, 0, 0}, -1}})}, ahead, enters(4)},
        {"normal zero, nothing inside", {cube_and<T>({{{0, 0, 0}, 1}})}, ahead, misses},
        {"direction zero, from inside", cube, {{0, 0, 0}, {0, 0, 0}}, misses},
        {"first crossing before the window", cube, ahead, leaves(6), 4.5},
        {"both crossings behind the window", cube, ahead, misses, 0, 3.5},
        {"window between the crossings", cube, ahead, misses, 4.5, 5.5},
        {"window that is not a number", cube, ahead, misses, nan<T>},
    });
}

TEST_CASE_TEMPLATE("convex_polyhedron: properties of every shape", T, float, double) {
    check_properties<convex_polyhedron<T>>();
}

TEST_CASE_TEMPLATE("convex_polyhedron: as exact arithmetic", T, float, double) {
    check_oracle<convex_polyhedron<T>>();
    check_accuracy<convex_polyhedron<T>>(normal_run);
    check_bounds_of_errors<convex_polyhedron<T>>(normal_run / 5);
}

TEST_CASE_TEMPLATE("convex_polyhedron: as exact arithmetic, ten million times" * doctest::test_suite("nightly"), T,
                   float, double) {
    check_accuracy<convex_polyhedron<T>>(nightly_run);
}

}  // namespace raio::test
