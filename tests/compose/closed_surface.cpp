#include <raio/compose/closed_surface.hpp>

#include <doctest/doctest.h>

#include <raio/bvh/bvh.hpp>
#include <raio/shape/box.hpp>

#include "support/meshes.hpp"
#include "support/random.hpp"

namespace raio::test {

namespace {

template <class T>
mesh<T> meshed(const std::vector<triangle<T>>& triangles) {
    mesh<T> m;
    for (const triangle<T>& t : triangles) {
        const auto first = static_cast<std::uint32_t>(m.vertices.size());
        m.vertices.insert(m.vertices.end(), {t.a, t.b, t.c});
        m.triangles.push_back({first, first + 1, first + 2});
    }
    return m;
}

template <class T>
mesh<T> tetrahedron(const std::array<vec3<T>, 4>& corners) {
    return {{corners.begin(), corners.end()}, {{{0, 1, 2}}, {{0, 3, 1}}, {{1, 3, 2}}, {{0, 2, 3}}}};
}

/// What a mesh and its trees answer, which is the same.
template <class T>
std::vector<hit_record<T>> passages_of(const mesh<T>& m, const bvh<triangle<T>>& tree, const ray<T>& ray, T t_min,
                                       T t_max) {
    const auto found = passages(m, ray, t_min, t_max), of_tree = passages(tree, ray, t_min, t_max);
    REQUIRE(found.size() == of_tree.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        CHECK((found[i].t == of_tree[i].t && found[i].index == of_tree[i].index));
        CHECK(found[i].point == of_tree[i].point);
        if (i > 0) CHECK((found[i - 1].t <= found[i].t && found[i - 1].front_face != found[i].front_face));
    }
    return found;
}

}  // namespace

TEST_CASE_TEMPLATE("passages: of a cube, through its faces, edges and corners", T, RAIO_NUMBERS) {
    const auto fans = cube_of_fans<triangle<T>>();
    const mesh<T> m = meshed(fans);
    const bvh tree(m);
    const box<T> block{{-1, -1, -1}, {1, 1, 1}};
    random_numbers random(3);
    const auto number = [&] { return T(random.integer(-6, 6)) / 2; };
    int through = 0, many = 0, touched = 0;
    for (int i = 0; i < share_of(20'000); ++i) {
        const vec3<T> from(number(), number(), number()), to(number(), number(), number());
        if (from == to) continue;
        const ray<T> ray{from, to - from};
        const auto found = passages_of<T>(m, tree, ray, -infinity<T>, infinity<T>);
        const interval<T> inside = block.spans(ray);
        const auto hits = tree.all_hits(ray, -infinity<T>, infinity<T>);
        many += hits.size() > 2;
        if (inside.empty() || inside.min == inside.max) {  // passed by, or an edge or a corner was touched
            CHECK(found.empty());
            touched += !hits.empty();
            continue;
        }
        bool in_face = false;
        for (glm::length_t k = 0; k < 3; ++k) in_face |= ray.direction[k] == 0 && std::abs(from[k]) == 1;
        if (in_face && found.empty()) continue;  // it runs along a face or an edge
        REQUIRE(found.size() == 2);
        CHECK((found[0].front_face && !found[1].front_face));
        CHECK(found[0].t == doctest::Approx(inside.min).epsilon(1e-6));
        CHECK(found[1].t == doctest::Approx(inside.max).epsilon(1e-6));
        ++through;
        // What is in a window does not depend on it.
        CHECK(passages_of<T>(m, tree, ray, found[0].t, found[1].t).size() == 2);
        CHECK(passages_of<T>(m, tree, ray, after(found[0].t), infinity<T>).size() == 1);
        CHECK(passages_of<T>(m, tree, ray, -infinity<T>, before(found[1].t)).size() == 1);
        CHECK(passages_of<T>(m, tree, ray, after(found[0].t), before(found[1].t)).empty());
    }
    CHECK((through > share_of(1000) && many > share_of(1000) && touched > share_of(100)));
}

TEST_CASE_TEMPLATE("passages: of a sphere of triangles, through its vertices and edges", T, RAIO_NUMBERS) {
    const auto triangles = icosphere<triangle<T>>();
    for (const bool turned : {false, true}) {
        mesh<T> m = meshed(triangles);
        if (turned) {
            for (auto& t : m.triangles) std::swap(t[1], t[2]);
        }
        const bvh tree(m);
        const auto check = [&](const vec3<T>& p) {
            for (const T from : {T(4), T(-0.5), T(1)}) {
                const ray<T> ray{p * from, -p};  // from outside, from within, and from the surface
                const auto found = passages_of<T>(m, tree, ray, from == 1 ? -infinity<T> : T(0), infinity<T>);
                REQUIRE(found.size() == (from == T(-0.5) ? 1 : 2));
                CHECK(found.back().front_face == turned);
            }
        };
        const std::size_t step = test_rays < 100'000 ? 7 : 1;
        for (std::size_t i = 0; i < triangles.size(); i += step) {
            const triangle<T>& t = triangles[i];
            check(t.a), check((t.a + t.b) * T(0.5)), check((t.a + t.b + t.c) / T(3));
        }
        // Past a vertex, where the surface may be touched.
        random_numbers random(5);
        for (int i = 0; i < share_of(2000); ++i) {
            const vec3<T> p = triangles[static_cast<std::size_t>(random.integer(0, int(triangles.size()) - 1))].b;
            const vec3<T> along(cross(to_double(p), random.direction()));
            CHECK(passages_of<T>(m, tree, {p - along, along}, -infinity<T>, infinity<T>).size() % 2 == 0);
            const vec3<T> other = triangles[static_cast<std::size_t>(random.integer(0, int(triangles.size()) - 1))].c;
            if (other == p) continue;
            // Along an edge, or through two vertices. (In double the t of those may differ where the ray starts.)
            const auto chord = passages(tree, {p, other - p}, -infinity<T>, infinity<T>);
            CHECK((chord.empty() || chord.size() == 2));
        }
    }
}

TEST_CASE_TEMPLATE("passages: where a vertex does not tell whether it is passed", T, RAIO_NUMBERS) {
    // Around its middle, which is at the origin, the roof goes up and down by turns: a saddle.
    mesh<T> m{{{0, 0, 0}}, {}};
    for (int k = 0; k < 8; ++k) {
        const T x[] = {1, 1, 0, -1, -1, -1, 0, 1}, y[] = {0, 1, 1, 1, 0, -1, -1, -1};
        m.vertices.push_back({x[k], y[k], T(k % 4 == 0 ? 1 : k % 4 == 2 ? -1 : 0)});
    }
    m.vertices.push_back({0, 0, -4});
    for (std::uint32_t k = 0; k < 8; ++k) {
        const std::uint32_t here = 1 + k, next = 1 + (k + 1) % 8;
        m.triangles.push_back({0, here, next});
        m.triangles.push_back({9, next, here});
    }
    const bvh tree(m);
    const auto expect = [&](const vec3<T>& direction, std::size_t count) {
        const auto found = passages_of<T>(m, tree, {-direction, direction}, T(0.5), T(1.5));
        CHECK(found.size() == count);
        for (const auto& rec : found) CHECK(rec.t == 1);
    };
    expect({0, 0, -1}, 1);            // eight fronts
    expect({0, 0, 1}, 1);             // eight backs
    expect({T(0.25), 0, T(0.5)}, 1);  // fronts and backs, from inside to outside
    expect({T(0.25), T(0.125), T(-0.5)}, 1);
    expect({1, T(0.125), 0}, 0);  // inside before and behind
    expect({T(0.125), 1, 0}, 0);  // outside before and behind
    CHECK(tree.all_hits({{0, 0, 1}, {0, 0, -1}}, T(0.5), T(1.5)).size() == 8);
}

TEST_CASE_TEMPLATE("passages, contains: through the middle of an edge", T, RAIO_NUMBERS) {
    random_numbers random(7);
    const vec3<T> direction = detail::any_directions<T>[0];
    int shared = 0;
    for (int i = 0; i < share_of(5000); ++i) {
        const auto corner = [&] { return vec3<T>(random.direction() * random.uniform(0.3, 1)); };
        const vec3<T> v = corner();
        mesh<T> m = tetrahedron<T>({v, -v, corner(), corner()});  // an edge runs through the origin
        const vec3<T> from = direction * T(-4);
        shared += m.all_hits({from, direction}, T(0), infinity<T>).size() == 3;
        CHECK(!contains(m, from));
        CHECK(passages(m, {from, direction}, T(0), infinity<T>).size() % 2 == 0);
        const auto inside = m.vertices[2] * T(0.25) + m.vertices[3] * T(0.25);
        CHECK(contains(m, inside));
        CHECK(passages(m, {inside, direction}, T(0), infinity<T>).size() == 1);
    }
    CHECK(shared > share_of(5000) / 4);
}

TEST_CASE_TEMPLATE("passages: of no surface, and of a ray that goes nowhere", T, RAIO_NUMBERS) {
    const ray<T> along{{0, 0, 0}, {1, 0, 0}};
    CHECK(passages(mesh<T>{}, along, T(0), infinity<T>).empty());
    CHECK(passages(bvh<triangle<T>>{}, along, T(0), infinity<T>).empty());
    const mesh<T> m = meshed(icosphere<triangle<T>>());
    CHECK(passages(m, {{0, 0, 0}, {0, 0, 0}}, T(0), infinity<T>).empty());
    CHECK(passages(m, along, T(2), infinity<T>).empty());
    CHECK(passages(m, along, T(2), T(1)).empty());
    static_assert(surface_of_many<bvh<mesh_triangle<T>>> && !surface_of_many<bvh<box<T>>>);
}

}  // namespace raio::test
