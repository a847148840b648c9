#pragma once

#include <raio/bvh/bvh.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <raio/shape/box.hpp>
#include <raio/shape/convex_polyhedron.hpp>
#include <raio/shape/cylinder.hpp>
#include <raio/shape/disc.hpp>
#include <raio/shape/sphere.hpp>
#include <raio/shape/triangle.hpp>

#include "support/random.hpp"

/// \file
/// Many random shapes, the rays that are sent among them, and what a tree over them answers.

namespace raio::test {

inline constexpr bvh_quality qualities[] = {bvh_quality::low, bvh_quality::standard, bvh_quality::high};

template <class T>
vec3<T> within(random_numbers& random, double size) {
    return {static_cast<T>(random.uniform(-size, size)), static_cast<T>(random.uniform(-size, size)),
            static_cast<T>(random.uniform(-size, size))};
}

/// One shape of a random size, at a random place, that shares its corners and sides with others now and then.
template <class Shape>
struct random_shape;
template <class T>
struct random_shape<triangle<T>> {
    static triangle<T> make(random_numbers& random) {
        const vec3<T> a = floor(within<T>(random, 8));
        return {a, a + floor(within<T>(random, 3)), a + floor(within<T>(random, 3))};
    }
    static vec3<T> floor(const vec3<T>& v) { return {std::floor(v.x), std::floor(v.y), std::floor(v.z)}; }
};
template <class T>
struct random_shape<sphere<T>> {
    static sphere<T> make(random_numbers& random) {
        return {within<T>(random, 8), static_cast<T>(random.log_uniform(0.01, 2))};
    }
};
template <class T>
struct random_shape<box<T>> {
    static box<T> make(random_numbers& random) {
        const vec3<T> low = random_shape<triangle<T>>::floor(within<T>(random, 8));
        return {low, low + vec3<T>(static_cast<T>(random.integer(0, 2)), 1, static_cast<T>(random.uniform(0, 1)))};
    }
};
template <class T>
struct random_shape<cylinder<T>> {
    static cylinder<T> make(random_numbers& random) {
        const vec3<T> base = within<T>(random, 8);
        return {base, base + within<T>(random, 2), static_cast<T>(random.log_uniform(0.01, 1))};
    }
};
template <class T>
struct random_shape<open_cylinder<T>> {
    static open_cylinder<T> make(random_numbers& random) {
        const cylinder<T> closed = random_shape<cylinder<T>>::make(random);
        return {closed.base, closed.top, closed.radius};
    }
};
template <class T>
struct random_shape<disc<T>> {
    static disc<T> make(random_numbers& random) {
        return {within<T>(random, 8), within<T>(random, 1), static_cast<T>(random.log_uniform(0.01, 2))};
    }
};
template <class T>
struct random_shape<convex_polyhedron<T>> {
    static convex_polyhedron<T> make(random_numbers& random) {
        const vec3<T> p = within<T>(random, 8), q = p + vec3<T>(1);
        return {{{{1, 0, 0}, -q.x},
                 {{-1, 0, 0}, p.x},
                 {{0, 1, 0}, -q.y},
                 {{0, -1, 0}, p.y},
                 {{0, 0, 1}, -q.z},
                 {{0, 0, -1}, p.z}}};
    }
};

template <class Shape>
std::vector<Shape> random_shapes(random_numbers& random, int count) {
    std::vector<Shape> shapes;
    for (int i = 0; i < count; ++i) {
        // One in ten stands there twice: of both the first is hit. Of triangles some show the other side.
        shapes.push_back(i > 0 && random.one_in(10) ? shapes[static_cast<std::size_t>(random.integer(0, i - 1))]
                                                    : random_shape<Shape>::make(random));
        if constexpr (requires { shapes.back().c; }) {
            if (random.one_in(3)) std::swap(shapes.back().b, shapes.back().c);
        }
    }
    return shapes;
}

/// A ray that starts anywhere, along an axis now and then, of any length, and the window that is asked for.
template <class T>
struct question {
    raio::ray<T> ray;
    T t_min, t_max;

    explicit question(random_numbers& random) {
        ray.origin = within<T>(random, random.one_in(3) ? 4 : 30);
        vec3<T> target = within<T>(random, 8);
        if (random.one_in(2)) target = random_shape<triangle<T>>::floor(target);
        ray.direction =
            random.one_in(4) ? target - ray.origin : vec3<T>(random.direction() * random.log_uniform(1e-3, 1e3));
        if (random.one_in(4)) {
            const int axis = random.integer(0, 2);
            ray.direction = vec3<T>(0);
            ray.direction[axis] = random.one_in(2) ? T(1) : T(-1);
            ray.origin = random_shape<triangle<T>>::floor(ray.origin);
        }
        t_min = random.one_in(4) ? static_cast<T>(random.uniform(-1, 10)) : T(0);
        t_max = random.one_in(4) ? t_min + static_cast<T>(random.uniform(0, 10)) : infinity<T>;
    }
};

template <class T>
bool same(const hit_record<T>& a, const hit_record<T>& b) {
    return a.t == b.t && a.point == b.point && a.normal == b.normal && a.uv == b.uv && a.error == b.error &&
           a.index == b.index && a.front_face == b.front_face;
}

/// The tree answers what the loop over all shapes answers.
template <class Tree, class Loop>
void check_like(const Tree& tree, const Loop& loop, random_numbers& random, int rays = test_rays / 10) {
    using T = number_t<Tree>;
    int hits = 0;
    for (int i = 0; i < rays; ++i) {
        const question<T> q(random);
        hit_record<T> expected{}, found{};
        const bool hit = loop.hit(q.ray, q.t_min, q.t_max, expected);
        REQUIRE(tree.hit(q.ray, q.t_min, q.t_max, found) == hit);
        REQUIRE(same(found, expected));
        REQUIRE(tree.occluded(q.ray, q.t_min, q.t_max) == hit);
        if (hit) {  // the window may end just there
            REQUIRE(tree.hit(q.ray, expected.t, expected.t, found));
            REQUIRE(same(found, expected));
            REQUIRE(tree.occluded(q.ray, expected.t, expected.t));
        }
        hits += hit ? 1 : 0;
    }
    CHECK(hits > rays / 40);
}

template <class Shape>
void check_shape(int count) {
    random_numbers random(11);
    const std::vector<Shape> shapes = random_shapes<Shape>(random, count);
    for (const bvh_quality quality : qualities) {
        check_like(bvh<Shape>(shapes, {.quality = quality, .threads = 1}), group{shapes}, random);
    }
}

}  // namespace raio::test
