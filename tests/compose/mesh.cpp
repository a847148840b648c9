#include <raio/compose/mesh.hpp>

#include <doctest/doctest.h>

#include "support/random.hpp"

namespace raio::test {

namespace {

/// The unit square in the plane z = 0, seen from above, as two triangles.
template <class T>
mesh<T> square() {
    return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

}  // namespace

TEST_CASE_TEMPLATE("mesh: the nearest triangle is hit, of equally near ones the first", T, RAIO_NUMBERS) {
    const mesh<T> m = square<T>();
    struct expected {
        vec2<T> at;
        bool hit;
        std::uint32_t index;
    };
    for (const expected& e :
         {expected{{0.75, 0.25}, true, 0}, {{0.25, 0.75}, true, 1}, {{0.5, 0.5}, true, 0}, {{1.5, 0.5}, false, 0}}) {
        const ray<T> down{{e.at.x, e.at.y, 2}, {0, 0, -1}};
        hit_record<T> rec{};
        CHECK(m.hit(down, T(0), infinity<T>, rec) == e.hit);
        CHECK(m.occluded(down, T(0), infinity<T>) == e.hit);
        CHECK(rec.t == (e.hit ? T(2) : T(0)));
        CHECK(rec.index == e.index);
    }
    CHECK((m.bounds().contains({1, 1, 0}) && !m.bounds().contains({1, 1, T(0.01)})));
}

TEST_CASE_TEMPLATE("mesh: triangles in lanes", T, RAIO_NUMBERS) {
    const mesh<T> m{{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}}, {{0, 1, 2}, {3, 2, 0}, {1, 3, 0}}};
    constexpr std::size_t lanes = pack<T>::lanes;
    typename mesh_triangle<T>::template lanes<lanes> room;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        room.set(lane, {&m, static_cast<std::uint32_t>((lane + 1) % 3)});
    }
    const auto all = room.shapes();
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const std::size_t index = (lane + 1) % 3;
        CHECK(room.get(lane).index == index);
        for (std::size_t k = 0; k < 3; ++k) {
            const vec3<pack<T>>& corner = k == 0 ? all.a : k == 1 ? all.b : all.c;
            const vec3<T> expected = m.vertices[m.triangles[index][k]];
            CHECK(vec3<T>(corner.x[lane], corner.y[lane], corner.z[lane]) == expected);
        }
    }
}

TEST_CASE_TEMPLATE("mesh: what the vertices have is interpolated", T, RAIO_NUMBERS) {
    mesh<T> m = square<T>();
    hit_record<T> above{}, below{};
    REQUIRE(m.hit({{0.75, 0.25, 2}, {0, 0, -1}}, T(0), infinity<T>, above));
    REQUIRE(m.hit({{0.75, 0.25, -2}, {0, 0, 1}}, T(0), infinity<T>, below));
    CHECK(m.normal_at(above) == above.normal);
    CHECK(m.uv_at(above) == above.uv);
    m.normals = {{0, 0, 2}, {0, 0, 2}, {0, 0, 2}, {0, 0, 2}};
    m.uv = {{1, 1}, {3, 1}, {3, 5}, {1, 5}};
    CHECK(m.normal_at(above) == vec3<T>(0, 0, 1));
    CHECK(m.normal_at(below) == vec3<T>(0, 0, -1));
    CHECK(m.uv_at(above) == vec2<T>(2.5, 2));
}

TEST_CASE_TEMPLATE("mesh: what does not fit together is refused", T, RAIO_NUMBERS) {
    mesh<T> m = square<T>();
    CHECK_NOTHROW(m.check());
    m.triangles[1][2] = 4;
    CHECK_THROWS_WITH_AS(m.check(), "raio::mesh: triangle 1 has vertex 4 of 4", std::invalid_argument);
    m = square<T>();
    m.normals.resize(3);
    CHECK_THROWS_AS(m.check(), std::invalid_argument);
    m.normals.clear();
    m.uv.resize(5);
    CHECK_THROWS_AS(m.check(), std::invalid_argument);
    m.normals.resize(4), m.uv.resize(4);
    CHECK_NOTHROW(m.check());
}

TEST_CASE_TEMPLATE("mesh: the nearest of its triangles, in any order, and the first of those that are as near", T,
                   RAIO_NUMBERS) {
    const mesh<T> layers{{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 1}, {3, 0, 1}, {0, 3, 1}},
                         {{0, 1, 2}, {3, 4, 5}, {3, 4, 5}, {0, 1, 2}}};
    hit_record<T> rec{};
    REQUIRE(layers.hit({{1, 1, 9}, {0, 0, -1}}, 0, infinity<T>, rec));
    CHECK((rec.t == 8 && rec.index == 1));
    REQUIRE(layers.hit({{1, 1, -9}, {0, 0, 1}}, 0, infinity<T>, rec));
    CHECK((rec.t == 9 && rec.index == 0));
}

}  // namespace raio::test
