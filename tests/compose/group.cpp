#include <raio/compose/group.hpp>

#include <doctest/doctest.h>

#include <array>
#include <span>
#include <vector>

#include <raio/compose/quick.hpp>
#include <raio/number/simd.hpp>
#include <raio/shape/box.hpp>
#include <raio/shape/plane.hpp>
#include <raio/shape/sphere.hpp>
#include <raio/shape/triangle.hpp>

#include "support/random.hpp"

namespace raio::test {

namespace {

template <class T>
struct without_bounds : sphere<T> {
    void bounds() const = delete;
};

}  // namespace

TEST_CASE_TEMPLATE("group: the nearest is hit, and counted through all members", T, RAIO_NUMBERS) {
    const plane<T> floor{{0, 0, -9}, {0, 0, 1}};
    const std::vector<sphere<T>> spheres{{{0, 0, 0}, 1}, {{5, 0, 0}, 1}, {{0, 0, 3}, 1}};
    const std::array<box<T>, 2> boxes{{{{4, -1, -1}, {6, 1, 3}}, {{-6, -1, -1}, {-4, 1, 1}}}};
    const group scene{floor, spheres, boxes, triangle<T>{{9, 0, 0}, {10, 0, 0}, {9, 1, 0}}};

    struct expected {
        T x;
        std::uint32_t index;
        T t;
    };
    for (const expected& e : {expected{0, 3, 6}, {5, 4, 7}, {-5, 5, 9}, {T(9.25), 6, 10}, {T(20), 0, 19}}) {
        const ray<T> down{{e.x, T(0.0), 10}, {0, 0, -1}};
        hit_record<T> rec{};
        REQUIRE(scene.hit(down, T(0), infinity<T>, rec));
        CHECK(rec.t == e.t);
        CHECK(rec.index == e.index);
        CHECK(scene.occluded(down, T(0), infinity<T>));
        CHECK(scene.occluded(down, e.t, e.t));
        CHECK(!scene.occluded(down, T(0), std::nextafter(e.t, T(0))));
    }
}

TEST_CASE_TEMPLATE("group: of equally near ones the first", T, RAIO_NUMBERS) {
    const sphere<T> sphere{{0, 0, 0}, 1};
    const box<T> box{{-1, -1, -1}, {1, 1, 1}};
    const ray<T> down{{0, 0, 5}, {0, 0, -1}};
    hit_record<T> rec{};
    REQUIRE(group{sphere, box}.hit(down, T(0), infinity<T>, rec));
    CHECK((rec.index == 0 && rec.uv != vec2<T>(0.5)));
    REQUIRE(group{box, sphere}.hit(down, T(0), infinity<T>, rec));
    CHECK((rec.index == 0 && rec.uv == vec2<T>(0.5)));
    REQUIRE(group{std::vector{sphere, sphere, sphere}}.hit(down, T(0), infinity<T>, rec));
    CHECK(rec.index == 0);
}

TEST_CASE_TEMPLATE("group: of equally near ones that which shows its front, in any order", T, RAIO_NUMBERS) {
    const triangle<T> up{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, down{up.a, up.c, up.b};
    struct without_side {
        T t;
        std::uint32_t index;
    };
    const auto check = [](const auto& scene, const ray<T>& ray, std::uint32_t index, bool front) {
        hit_record<T> rec{};
        without_side other{};
        REQUIRE(scene.hit(ray, T(0), infinity<T>, rec));
        CHECK((rec.index == index && rec.front_face == front));
        REQUIRE(scene.hit(ray, T(0), infinity<T>, other));
        CHECK((other.index == index && other.t == rec.t));
    };
    const ray<T> from_above{{T(0.25), T(0.25), 2}, {0, 0, -1}}, from_below{{T(0.25), T(0.25), -2}, {0, 0, 1}};
    using list = std::vector<triangle<T>>;
    check(group{list{up, down}}, from_above, 0, true);
    check(group{list{down, up}}, from_above, 1, true);
    check(group{list{up, down}}, from_below, 1, true);
    check(group{list{down, up}}, from_below, 0, true);
    check(group{list{down, up, down, up}}, from_above, 1, true);
    check(group{list{down, down, down}}, from_above, 0, false);
    check(group{down, list{down}, group{list{down, up}}}, from_above, 2, true);
    check(group{quick<triangle<T>>{down}, quick<triangle<T>>{up}}, from_above, 1, true);
    // A nearer one behind two that are as near as each other.
    const triangle<T> above{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    check(group{list{down, up, above}}, from_above, 2, true);
    check(group{list{down, up, {above.a, above.c, above.b}}}, from_above, 2, false);

    // Who leaves a block enters the next one, whichever comes first.
    const box<T> left{{0, 0, 0}, {1, 1, 1}}, right{{1, 0, 0}, {2, 1, 1}};
    const ray<T> to_right{{T(0.5), T(0.5), T(0.5)}, {1, 0, 0}}, to_left{{T(1.5), T(0.5), T(0.5)}, {-1, 0, 0}};
    check(group{left, right}, to_right, 1, true);
    check(group{right, left}, to_right, 0, true);
    check(group{left, right}, to_left, 0, true);
}

TEST_CASE_TEMPLATE("group: of equally near ones that which shows its front, in the lanes of packs", T, RAIO_NUMBERS) {
    using P = pack<T>;
    const triangle<P> up{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, down{up.a, up.c, up.b};
    ray<P> rays{{P(T(0.25)), P(T(0.25)), 0}, {0, 0, 0}};
    for (std::size_t lane = 0; lane < P::lanes; ++lane) {
        const T side = lane % 2 == 0 ? T(1) : T(-1);
        rays.origin.z.set(lane, side), rays.direction.z.set(lane, lane % 3 == 2 ? side : -side);
    }
    struct without_side {
        P t;
        index_t<P> index;
    };
    const auto check = [&](const auto& scene, auto index_of) {
        hit_record<P> rec{};
        without_side other{};
        const mask_t<P> hit = scene.hit(rays, P(0), P(infinity<T>), rec);
        CHECK(bits(scene.hit(rays, P(0), P(infinity<T>), other)) == bits(hit));
        for (std::size_t lane = 0; lane < P::lanes; ++lane) {
            CHECK(hit[lane] == (lane % 3 != 2));
            if (!hit[lane]) continue;
            CHECK((rec.index[lane] == index_of(lane) && other.index[lane] == index_of(lane)));
            CHECK((rec.t[lane] == 1 && other.t[lane] == 1));
        }
    };
    check(group{up, down}, [](std::size_t lane) { return lane % 2; });
    check(group{down, up}, [](std::size_t lane) { return 1 - lane % 2; });
    check(group{down, down, up, up}, [](std::size_t lane) { return lane % 2 == 0 ? 2u : 0u; });
}

TEST_CASE_TEMPLATE("group: a miss touches nothing", T, RAIO_NUMBERS) {
    const group scene{sphere<T>{{0, 0, 0}, 1}, std::vector<box<T>>{}};
    const ray<T> ahead{{0, 0, 5}, {0, 0, -1}};
    hit_record<T> rec{7, vec3<T>(7), vec3<T>(7), vec2<T>(7), vec3<T>(7), 7, true};
    CHECK(!scene.hit(ahead, T(7), infinity<T>, rec));
    CHECK(!scene.hit(ahead, T(0), T(3), rec));
    CHECK(!scene.hit(ahead, std::numeric_limits<T>::quiet_NaN(), infinity<T>, rec));
    CHECK(!scene.hit(ahead, T(0), std::numeric_limits<T>::quiet_NaN(), rec));
    CHECK(!scene.hit({{0, 0, 5}, {0, 0, 0}}, T(0), infinity<T>, rec));
    CHECK((rec.t == T(7) && rec.point == vec3<T>(7) && rec.index == 7 && rec.front_face && rec.error == vec3<T>(7)));
}

TEST_CASE_TEMPLATE("group: without members nothing is hit", T, RAIO_NUMBERS) {
    const group scene{std::vector<sphere<T>>{}, std::span<const box<T>>{}};
    hit_record<T> rec{};
    CHECK(!scene.hit({{0, 0, 5}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK(!scene.occluded({{0, 0, 5}, {0, 0, -1}}, T(0), infinity<T>));
    CHECK(!scene.bounds().contains({0, 0, 0}));
}

TEST_CASE_TEMPLATE("group: a group within it counts as one, and keeps to its window", T, RAIO_NUMBERS) {
    const group<std::vector<sphere<T>>> inner{std::vector<sphere<T>>{{{0, 0, 0}, 1}, {{0, 0, 4}, 1}}};
    const group scene{sphere<T>{{0, 0, -9}, 1}, inner, std::vector(2, inner)};
    hit_record<T> rec{};
    REQUIRE(scene.hit({{0, 0, 9}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK((rec.t == T(4) && rec.index == 1));
    REQUIRE(scene.hit({{0, 0, 9}, {0, 0, -1}}, T(11), infinity<T>, rec));
    CHECK((rec.t == T(17) && rec.index == 0));
}

TEST_CASE_TEMPLATE("group: bounds hold every member", T, RAIO_NUMBERS) {
    const aabb<T> bounds = group{sphere<T>{{-5, 0, 0}, 1}, std::vector<box<T>>{{{0, 0, 0}, {1, 2, 3}}}}.bounds();
    CHECK((bounds.contains({-6, -1, -1}) && bounds.contains({1, 2, 3})));
    CHECK((!bounds.contains({T(-6.01), 0, 0}) && !bounds.contains({0, 0, T(3.01)})));
}

TEST_CASE_TEMPLATE("group: inside is inside any of its members", T, RAIO_NUMBERS) {
    const std::vector<sphere<T>> spheres{{{0, 0, 0}, 1}, {{0, 0, 6}, 1}, {{0, 0, T(0.5)}, 1}};
    const group scene{box<T>{{-1, -1, 3}, {1, 1, 5}}, spheres};
    auto inside = scene.spans({{0, 0, -9}, {0, 0, 1}});
    REQUIRE(inside.count == 2);
    CHECK((inside.intervals[0] == interval<T>{8, 10.5} && inside.intervals[1] == interval<T>{12, 16}));
    static_assert(room_in<decltype(inside)> == any_number);
    CHECK(scene.spans({{5, 0, -9}, {0, 0, 1}}).empty());

    const group fixed{std::array<sphere<T>, 2>{spheres[1], spheres[0]}, spheres[2]};
    auto three = fixed.spans({{0, 0, -9}, {0, 0, 1}});
    REQUIRE(three.count == 2);
    CHECK((three.intervals[0] == interval<T>{8, 10.5} && three.intervals[1] == interval<T>{14, 16}));
    static_assert(room_in<decltype(three)> == 3);
    static_assert(solid<decltype(scene)> && !solid<group<sphere<T>, triangle<T>>>);
    static_assert(!solid<group<triangle<T>, sphere<T>>> && !solid<group<sphere<T>, triangle<T>, sphere<T>>>);
    static_assert(bounded<decltype(scene)> && !bounded<group<sphere<T>, without_bounds<T>, sphere<T>>>);
}

TEST_CASE_TEMPLATE("group: as the loop over its members", T, RAIO_NUMBERS) {
    random_numbers random(9);
    const auto anywhere = [&] { return vec3<T>(random.direction() * random.uniform(0, 10)); };
    std::vector<sphere<T>> spheres;
    std::vector<triangle<T>> triangles;
    for (int i = 0; i < 20; ++i) {
        spheres.push_back({anywhere(), static_cast<T>(random.uniform(0.1, 2))});
        triangles.push_back({anywhere(), anywhere(), anywhere()});
    }
    const group scene{spheres, std::span<const triangle<T>>(triangles)};
    for (int i = 0; i < at_least(10'000); ++i) {
        const ray<T> ray{anywhere(), anywhere()};
        hit_record<T> rec{}, nearest{}, candidate{};
        bool found = false;
        std::uint32_t index = 0;
        const auto ask = [&](const auto& shape) {
            if (shape.hit(ray, T(0), infinity<T>, candidate)) {
                candidate.index = index;
                if (!found || detail::comes_before(candidate, nearest)) nearest = candidate;
                found = true;
            }
            ++index;
        };
        for (const auto& sphere : spheres) ask(sphere);
        for (const auto& triangle : triangles) ask(triangle);
        REQUIRE(scene.hit(ray, T(0), infinity<T>, rec) == found);
        REQUIRE(scene.occluded(ray, T(0), infinity<T>) == found);
        if (!found) continue;
        REQUIRE((rec.t == nearest.t && rec.index == nearest.index && rec.front_face == nearest.front_face));
        REQUIRE((rec.point == nearest.point && rec.normal == nearest.normal && rec.uv == nearest.uv));
    }
}

static_assert(group{box<double>{{-1, -1, -1}, {1, 1, 1}}}.occluded({{0, 0, 5}, {0, 0, -1}}, 0, 9));

}  // namespace raio::test
