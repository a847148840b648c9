#include <raio/bvh/presplit.hpp>

#include <map>
#include <optional>

#include <raio/shape/triangle.hpp>

#include "support/binary_trees.hpp"

namespace raio::test {

namespace {

bool contains(const build_box& box, const vec3<double>& p) {
    for (unsigned axis = 0; axis < 3; ++axis) {
        const double x = p[static_cast<glm::length_t>(axis)];
        if (!(double(box.low(axis)) <= x && x <= double(box.high(axis)))) return false;
    }
    return true;
}

bool contains(const build_box& outer, const build_box& inner) { return same_corners(hull(outer, inner), outer); }

detail::corners random_corners(random_numbers& random) {
    detail::corners t;
    for (vec3<double>& corner : t) {
        for (glm::length_t axis = 0; axis < 3; ++axis) corner[axis] = random.integer(-8, 8);
    }
    return t;
}

build_box box_of(const detail::corners& t, std::uint32_t id) {
    aabb<double> box;
    for (const vec3<double>& corner : t) box = hull(box, corner);
    return detail::to_build_box(box, id);
}

vec3<double> point_of(const detail::corners& t, random_numbers& random) {
    const double u = random.uniform(), v = random.uniform(0, 1 - u);
    return t[0] + (t[1] - t[0]) * u + (t[2] - t[0]) * v;
}

}  // namespace

TEST_CASE("split_box: what is on each side of the plane, within the box, and no more than there is") {
    random_numbers random(1);
    for (int i = 0; i < at_least(2000); ++i) {
        const detail::corners t = random_corners(random);
        const build_box box = box_of(t, 7);
        const unsigned axis = box.largest_axis();
        if (!(box.extent(axis) > 0)) continue;
        const float plane = box.low(axis) + box.extent(axis) * static_cast<float>(random.integer(1, 7)) / 8;
        const auto parts = detail::split_box(box, t, axis, plane);
        for (unsigned side = 0; side < 2; ++side) {
            REQUIRE(parts[side].id() == 7);
            REQUIRE(contains(box, parts[side]));
        }
        REQUIRE(parts[0].high(axis) <= plane);
        REQUIRE(parts[1].low(axis) >= plane);
        for (int k = 0; k < 20; ++k) {
            const vec3<double> p = point_of(t, random);
            REQUIRE(contains(parts[p[static_cast<glm::length_t>(axis)] <= double(plane) ? 0 : 1], p));
        }
    }
}

TEST_CASE("split_plane: within the box, and where the scene is halved, if that is there") {
    const auto of = [](float low, float high) {
        return detail::to_build_box(aabb<float>{vec3<float>(low), vec3<float>(high)});
    };
    const build_box scene = of(0, 64);
    CHECK(detail::split_plane(of(10, 40), scene, 0) == 32);
    CHECK(detail::split_plane(of(1, 30), scene, 1) == 16);
    CHECK(detail::split_plane(of(33, 63), scene, 2) == 48);
    CHECK(detail::split_plane(of(16, 32), scene, 0) == 24);  // its sides are such planes: the middle
    const float low = 5, high = std::nextafter(std::nextafter(5.0f, 6.0f), 6.0f);  // too small for the scene
    const float plane = detail::split_plane(of(low, high), scene, 0);
    CHECK((low < plane && plane < high));
}

TEST_CASE("presplit: pieces hold all of their triangles, are not too many, and other shapes stay whole") {
    random_numbers random(2);
    std::vector<detail::corners> triangles;
    std::vector<build_box> references;
    for (std::uint32_t i = 0; i < 10'000; ++i) {
        triangles.push_back(random_corners(random));
        references.push_back(box_of(triangles.back(), i));
    }
    const auto corners_of = [&](std::uint32_t id) {
        return id % 5 == 0 ? std::optional<detail::corners>() : std::optional(triangles[id]);
    };
    const auto pieces = detail::presplit(references, 0.5f, 1, corners_of);
    CHECK(pieces.size() > 12'000);
    CHECK(pieces.size() <= 15'000);
    std::map<std::uint32_t, std::vector<build_box>> of;
    for (const build_box& piece : pieces) of[piece.id()].push_back(piece);
    for (std::uint32_t i = 0; i < 10'000; ++i) {
        REQUIRE(!of[i].empty());
        if (i % 5 == 0) REQUIRE((of[i].size() == 1 && same_corners(of[i][0], references[i])));
        for (const build_box& piece : of[i]) REQUIRE(contains(references[i], piece));
        for (int k = 0; k < 10; ++k) {
            const vec3<double> p = point_of(triangles[i], random);
            REQUIRE(std::ranges::any_of(of[i], [&](const build_box& piece) { return contains(piece, p); }));
        }
    }
    for (const unsigned threads : {2u, 5u}) {
        REQUIRE(std::ranges::equal(
            pieces, detail::presplit(references, 0.5f, threads, corners_of),
            [](const build_box& a, const build_box& b) { return a.id() == b.id() && same_corners(a, b); }));
    }
    const auto many = detail::presplit(references, 4.0f, 1, corners_of);  // several cuts each
    CHECK((many.size() > 30'000 && many.size() <= 50'000));
    CHECK(detail::presplit(references, 0.0f, 1, corners_of).size() == references.size());
    CHECK(detail::presplit(std::span<const build_box>(), 0.5f, 1, corners_of).empty());
}

TEST_CASE("presplit: no piece is empty, however coarsely boxes are rounded") {
    random_numbers random(5);
    std::vector<detail::corners> triangles;
    std::vector<build_box> references;
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const auto somewhere = [&] {
            return vec3<double>(random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-20, 20));
        };
        vec3<double> far(1e6);
        far[static_cast<glm::length_t>(i % 3)] = 0;
        const vec3<double> from = far + somewhere(), along = somewhere();
        const triangle<float> t{vec3<float>(from), vec3<float>(from + along),
                                vec3<float>(from + along * 0.5 + somewhere())};
        triangles.push_back(detail::corners{vec3<double>(t.a), vec3<double>(t.b), vec3<double>(t.c)});
        references.push_back(detail::to_build_box(t.bounds(), i));
    }
    const auto corners_of = [&](std::uint32_t id) { return std::optional(triangles[id]); };
    for (const build_box& piece : detail::presplit(references, 20.0f, 1, corners_of)) {
        for (unsigned axis = 0; axis < 3; ++axis) REQUIRE(piece.low(axis) <= piece.high(axis));
    }
}

}  // namespace raio::test
