#include <doctest/doctest.h>

#include <raio/bvh/bvh.hpp>
#include <raio/raio.hpp>

#include "support/oracle.hpp"
#include "support/random.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("contains: of a sphere, as exact arithmetic", T, RAIO_NUMBERS) {
    random_numbers random(3);
    int inside = 0, on = 0;
    const int points = at_least_a_tenth_of(20'000);
    for (int i = 0; i < points; ++i) {
        const auto number = [&] { return static_cast<T>(random.uniform(-1, 1)); };
        sphere<T> ball{{number(), number(), number()}, static_cast<T>(random.uniform(0.1, 2))};
        vec3<T> p(number(), number(), number());
        if (i % 2 == 0) p = ball.center + vec3<T>(random.direction()) * ball.radius;  // within roundings of the surface
        if (i % 8 == 1) ball = {{0, 0, 0}, 3}, p = {i % 3 == 0 ? -1 : 1, 2, i % 5 < 2 ? -2 : 2};  // on it
        oracle distance(0), radius(ball.radius);
        for (glm::length_t k = 0; k < 3; ++k) {
            distance += (oracle(p[k]) - oracle(ball.center[k])) * (oracle(p[k]) - oracle(ball.center[k]));
        }
        CHECK(contains(ball, p) == (distance <= radius * radius));
        inside += contains(ball, p), on += distance == radius * radius;
    }
    CHECK((inside > points / 4 && inside < points * 3 / 4 && on >= points / 8));
}

TEST_CASE_TEMPLATE("contains: boxes, with faces, edges and corners; what has no inside", T, RAIO_NUMBERS) {
    const box<T> block{{0, 0, 0}, {1, 2, 3}};
    for (const T x : {T(0), T(0.5), T(1)})
        for (const T y : {T(0), T(1.5), T(2)})
            for (const T z : {T(0), T(2.5), T(3)}) CHECK(contains(block, {x, y, z}));
    for (const vec3<T>& p :
         {vec3<T>(before(T(0)), 1, 1), {after(T(1)), 2, 3}, {1, after(T(2)), 3}, {0, 0, after(T(3))}})
        CHECK(!contains(block, p));
    const T none = std::numeric_limits<T>::quiet_NaN();
    CHECK(!contains(block, {none, 1, 1}));
    CHECK(!contains(block, {infinity<T>, 1, 1}));
    CHECK(!contains(box<T>{{0, 0, 0}, {-1, 1, 1}}, {0, 0, 0}));
    static_assert(!requires(const disc<T> d, vec3<T> p) { contains(d, p); });
}

TEST_CASE_TEMPLATE("contains: what is made of solids", T, RAIO_NUMBERS) {
    const sphere<T> a{{0, 0, 0}, 2}, b{{1, 0, 0}, 1};
    const auto moon = difference_of(a, b);
    CHECK((contains(moon, {-1, 0, 0}) && !contains(moon, {1, 0, 0}) && !contains(moon, {3, 0, 0})));
    const group both{a, sphere<T>{{9, 0, 0}, 1}};
    CHECK((contains(both, {9, 0, 0}) && contains(both, {0, 0, 0}) && !contains(both, {5, 0, 0})));
    const bvh tree{both};
    CHECK((contains(tree, {9, 0, 0}) && contains(tree, {0, 0, 0}) && !contains(tree, {5, 0, 0})));
    const transformed needle{a, scaling<T>({1, 1, 100})};
    CHECK((contains(needle, {0, 0, 199}) && !contains(needle, {0, 0, 201}) && !contains(needle, {3, 0, 0})));
    CHECK(contains(any_solid<T>(moon), {-1, 0, 0}));
    const torus<T> ring{{0, 0, 0}, {0, 0, 1}, 3, 1};
    CHECK((contains(ring, {3, 0, 0}) && !contains(ring, {0, 0, 0}) && contains(ring, {0, T(-3.5), 0})));
}

/// The sides of it meet at many vertices, and the octahedron is cut out of the box.
template <class T>
mesh<T> box_with_a_hole() {
    const auto signs = {T(-1), T(1)};
    mesh<T> m;
    for (const T x : signs)
        for (const T y : signs)
            for (const T z : signs) m.vertices.push_back({x, y, z});
    m.triangles = {{{0, 1, 3}}, {{0, 3, 2}}, {{4, 6, 7}}, {{4, 7, 5}}, {{0, 4, 5}}, {{0, 5, 1}},
                   {{2, 3, 7}}, {{2, 7, 6}}, {{0, 2, 6}}, {{0, 6, 4}}, {{1, 5, 7}}, {{1, 7, 3}}};
    for (const T s : signs)
        for (glm::length_t k = 0; k < 3; ++k) {
            m.vertices.push_back(vec3<T>(0));
            m.vertices.back()[k] = s / 2;
        }
    for (const std::uint32_t x : {0u, 3u})
        for (const std::uint32_t y : {1u, 4u})
            for (const std::uint32_t z : {2u, 5u}) {
                const bool odd = ((x / 3 + y / 4 + z / 5) & 1) != 0;  // fronts look into the hole
                m.triangles.push_back(odd ? std::array{8 + x, 8 + y, 8 + z} : std::array{8 + x, 8 + z, 8 + y});
            }
    std::ranges::for_each(m.triangles, [](auto& t) {
        if (t[0] >= 8) std::swap(t[1], t[2]);
    });
    return m;
}

TEST_CASE_TEMPLATE("contains: a closed mesh and its tree, where rays meet edges and vertices", T, RAIO_NUMBERS) {
    mesh<T> m = box_with_a_hole<T>();
    const auto expected = [](const vec3<T>& p) {
        const T most = max(abs(p.x), max(abs(p.y), abs(p.z)));
        return most <= 1 && !(norm1(p) < T(0.5));
    };
    const auto check = [&](const vec3<T>& p) {
        CHECK(contains(m, p) == expected(p));
        CHECK(contains(bvh(m), p) == expected(p));
        CHECK(contains(bvh<mesh_triangle<T>>(m), p) == expected(p));
    };
    for (int turned = 0; turned < 2; ++turned) {
        for (const T x : {T(-2), T(-1), T(-0.5), T(-0.25), T(0), T(0.125), T(0.25), T(0.5), T(1), T(1.5)})
            for (const T y : {T(-1), T(-0.125), T(0), T(0.25), T(0.5), T(1)})
                for (const T z : {T(-1), T(0), T(0.125), T(0.5), T(3)}) check({x, y, z});
        // From where the first ray meets a vertex or the middle of an edge.
        for (const T back : {T(0.125), T(0.5), T(1), T(2)}) {
            for (const vec3<T>& corner : m.vertices) check(corner - detail::any_directions<T>[0] * back);
            for (const auto& [a, b, c] : m.triangles) {
                const vec3<T> middle = (m.vertices[a] + m.vertices[b]) * T(0.5);
                check(middle - detail::any_directions<T>[0] * back);
            }
        }
        for (auto& t : m.triangles) std::swap(t[0], t[1]);  // and with all fronts inside
    }
}

TEST_CASE_TEMPLATE("contains: a point beside the surface of a mesh", T, RAIO_NUMBERS) {
    const mesh<T> m = box_with_a_hole<T>();
    CHECK(contains(m, {1, T(0.3), T(0.2)}));
    CHECK(contains(m, {before(T(1)), T(0.3), T(0.2)}));
    CHECK(!contains(m, {after(T(1)), T(0.3), T(0.2)}));
    CHECK(!contains(m, {std::numeric_limits<T>::quiet_NaN(), 0, 0}));
    CHECK(!contains(mesh<T>{}, {0, 0, 0}));
}

static_assert(contains(box<double>{{0, 0, 0}, {1, 1, 1}}, {0.5, 0, 0}));

}  // namespace raio::test
