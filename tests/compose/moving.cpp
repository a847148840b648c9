#include <raio/compose/moving.hpp>

#include <doctest/doctest.h>

#include <raio/bvh/bvh.hpp>
#include <raio/compose/csg.hpp>
#include <raio/compose/group.hpp>
#include <raio/shape/box.hpp>
#include <raio/shape/sphere.hpp>

#include "support/properties.hpp"
#include "support/random.hpp"

namespace raio::test {

template <class T>
transform<T> random_map(random_numbers& random) {
    const auto number = [&](double low, double high) { return static_cast<T>(random.uniform(low, high)); };
    return translation<T>({number(-3, 3), number(-3, 3), number(-3, 3)}) *
           rotation(vec3<T>(random.direction()), number(0, 1)) *
           scaling<T>({number(0.5, 1.5), number(0.5, 1.5), number(0.5, 1.5)});
}

template <class T>
timed_ray<T> aimed(random_numbers& random) {
    const vec3<double> from = random.direction() * 12.0;
    return {{vec3<T>(from), vec3<T>(random.direction() * 3.0 - from)}, static_cast<T>(random.uniform())};
}

template <class T>
moving<box<T>> random_mover(random_numbers& random, bool slides) {
    const transform<T> from = random_map<T>(random), by = translation(vec3<T>(random.direction() * 2.0));
    return {box<T>{{-1, -1, -1}, {1, 1, 1}}, from, slides ? by * from : random_map<T>(random)};
}

TEST_CASE_TEMPLATE("moving: what is met at a time is what is met of it standing where it is then", T, RAIO_NUMBERS) {
    random_numbers random(5);
    int hits = 0;
    for (int i = 0; i < at_least_a_tenth_of(1500); ++i) {
        const moving<box<T>> mover = random_mover<T>(random, i % 2 == 0);
        timed_ray<T> ray = aimed<T>(random);
        if (i % 8 == 0) ray.time = static_cast<T>(i / 8 % 2);
        const transformed standing{mover.primitive(), mover.map(ray.time)};
        hit_record<T> expected{}, rec{};
        const raio::ray<T>& plain = ray;
        const bool met = standing.hit(plain, T(0), infinity<T>, expected);
        REQUIRE(mover.hit(ray, T(0), infinity<T>, rec) == met);
        CHECK(mover.occluded(ray, T(0), infinity<T>) == met);
        CHECK(mover.spans(ray) == standing.spans(plain));
        CHECK(same_record(rec, expected));
        if (met) CHECK(mover.bounds().contains(rec.point));
        hits += met;
    }
    CHECK(hits > at_least_a_tenth_of(150));
}

TEST_CASE_TEMPLATE("moving: straight and evenly, from one end to the other", T, RAIO_NUMBERS) {
    const transform<T> from = translation<T>({1, 0, 0}), to = translation<T>({3, 8, 0}) * scaling<T>({2, 2, 2});
    const moving ball{sphere<T>{{0, 0, 0}, 1}, from, to};
    CHECK((ball.map(0).origin == from.origin && ball.map(0).x == from.x));
    CHECK((ball.map(1).origin == to.origin && ball.map(1).z == to.z));
    CHECK((ball.map(T(0.25)).origin == vec3<T>(T(1.5), 2, 0) && ball.map(T(0.25)).y == vec3<T>(0, T(1.25), 0)));
    hit_record<T> rec{};
    const ray<T> at_half{{2, 4, 9}, {0, 0, -1}};
    REQUIRE(ball.hit(timed_ray<T>{at_half, T(0.5)}, T(0), infinity<T>, rec));
    CHECK(rec.t == T(7.5));
    const T none = std::numeric_limits<T>::quiet_NaN();
    for (const T time : {T(0), T(1), T(-0.5), T(1.5), none}) {
        CHECK(!ball.hit(timed_ray<T>{at_half, time}, T(0), infinity<T>, rec));
        CHECK(!ball.occluded(timed_ray<T>{at_half, time}, T(0), infinity<T>));
        CHECK(raio::spans(ball.spans(timed_ray<T>{at_half, time})).empty());
    }
    // Before it starts and after it has ended it is nowhere, even where it stays.
    const moving still{sphere<T>{{0, 0, 0}, 1}, from, from};
    const ray<T> at_ball{{1, 0, 9}, {0, 0, -1}};
    for (const T time : {T(0), T(0.3), T(1)}) CHECK(still.occluded(timed_ray<T>{at_ball, time}, T(0), infinity<T>));
    for (const T time : {before(T(0)), after(T(1)), none})
        CHECK(!still.occluded(timed_ray<T>{at_ball, time}, T(0), infinity<T>));
}

TEST_CASE_TEMPLATE("moving: through trees, groups, maps and csg", T, RAIO_NUMBERS) {
    random_numbers random(6);
    std::vector<moving<box<T>>> movers;
    for (int i = 0; i < 40; ++i) movers.push_back(random_mover<T>(random, i % 2 == 0));
    std::vector<sphere<T>> still{{{0, 0, 0}, 1}, {{2, 2, 2}, T(0.5)}};
    const group loop{movers, still};
    const bvh tree{loop};
    const transform<T> map = random_map<T>(random);
    const transformed moved_tree{&tree, map};
    const transformed moved_loop{&loop, map};
    int hits = 0;
    for (int i = 0; i < at_least_a_tenth_of(1000); ++i) {
        const timed_ray<T> ray = aimed<T>(random);
        std::vector<transformed<box<T>>> standing;
        for (const auto& mover : movers) standing.emplace_back(mover.primitive(), mover.map(ray.time));
        const group now{standing, still};
        const auto check = [&](const auto& scene, const auto& expected_scene) {
            hit_record<T> expected{}, rec{};
            const bool met = expected_scene.hit(raio::ray<T>(ray), T(0), infinity<T>, expected);
            REQUIRE(scene.hit(ray, T(0), infinity<T>, rec) == met);
            CHECK(scene.occluded(ray, T(0), infinity<T>) == met);
            CHECK(same_record(rec, expected));
            hits += met;
        };
        check(loop, now);
        check(tree, now);
        check(moved_loop, transformed{&now, map});
        check(moved_tree, transformed{&now, map});
        check(difference_of(movers[0], still[0]), difference_of(standing[0], still[0]));
        check(difference_of(still[0], transformed{&movers[1], map}),
              difference_of(still[0], transformed{standing[1], map}));
    }
    CHECK(hits > at_least_a_tenth_of(2000));
}

}  // namespace raio::test
