#include <raio/compose/any_primitive.hpp>
#include <raio/compose/csg.hpp>
#include <raio/compose/transformed.hpp>
#include <raio/shape/torus.hpp>

#include <thread>

#include "support/meshes.hpp"
#include "support/trees.hpp"

/// \file
/// What is const may be asked from many threads at once, and nobody need lock anything. The preset `thread` runs these
/// tests under the thread sanitizer.

namespace raio::test {

namespace {

/// All that a thread is told about one ray.
template <class T>
struct answer {
    bool hit, occluded;
    hit_record<T> rec{};

    template <class Scene>
    answer(const Scene& scene, const question<T>& q)
        : hit(scene.hit(q.ray, q.t_min, q.t_max, rec)), occluded(scene.occluded(q.ray, q.t_min, q.t_max)) {}

    bool operator==(const answer& other) const {
        return hit == other.hit && occluded == other.occluded && same(rec, other.rec);
    }
};

/// Eight threads put the same questions at the same time, each beginning with another one, and are all told what one
/// thread is told.
template <class Scene>
void check_from_eight_threads(const Scene& scene, random_numbers& random) {
    using T = number_t<Scene>;
    constexpr std::size_t threads = 8;
    std::vector<question<T>> questions;
    std::vector<answer<T>> expected;
    for (int i = 0; i < test_rays / 50; ++i) expected.emplace_back(scene, questions.emplace_back(random));
    const auto hits = std::ranges::count_if(expected, &answer<T>::hit);
    CHECK(hits > test_rays / 500);

    std::array<std::size_t, threads> same{};
    {
        std::vector<std::jthread> all;
        for (std::size_t thread = 0; thread < threads; ++thread) {
            all.emplace_back([&, thread] {
                for (std::size_t i = 0; i < questions.size(); ++i) {
                    const std::size_t j = (i + thread * questions.size() / threads) % questions.size();
                    same[thread] += answer<T>(scene, questions[j]) == expected[j] ? 1u : 0u;
                }
            });
        }
    }
    for (const std::size_t count : same) CHECK(count == questions.size());
}

template <class T>
mesh<T> some_mesh() {
    mesh<T> ball;
    for (const triangle<T>& t : icosphere<triangle<T>>()) {
        const auto first = static_cast<std::uint32_t>(ball.vertices.size());
        ball.vertices.insert(ball.vertices.end(), {t.a * T(3), t.b * T(3), t.c * T(3)});
        ball.triangles.push_back({first, first + 1, first + 2});
    }
    return ball;
}

}  // namespace

TEST_CASE_TEMPLATE("bvh: eight threads ask one scene of trees, solids and meshes", T, RAIO_NUMBERS) {
    random_numbers random(30);
    const any_primitive<T> tree = bvh{random_shapes<triangle<T>>(random, 1'000)};
    const any_primitive<T> ball = bvh{some_mesh<T>()};
    const any_solid<T> ring = torus<T>{{0, 0, 0}, {0, 0, 1}, 2, 1};
    const any_primitive<T> bitten =
        difference_of(any_solid<T>(union_of(ring, sphere<T>{{2, 0, 0}, 2})), box<T>{{-1, -1, -1}, {1, 1, 1}});
    std::vector<any_primitive<T>> members;
    for (const vec3<T>& place : {vec3<T>(-6, 0, 0), vec3<T>(5, 5, 1), vec3<T>(0, -6, 4)}) {
        for (const any_primitive<T>& member : {ball, bitten})
            members.push_back(transformed{member, translation(place)});
    }
    members.push_back(tree);
    members.push_back(any_primitive<T>(some_mesh<T>()));
    check_from_eight_threads(bvh{members}, random);
}

TEST_CASE_TEMPLATE("bvh: a tree that eight threads build answers as one that one thread builds", T, RAIO_NUMBERS) {
    random_numbers random(31);
    const std::vector<triangle<T>> shapes = random_shapes<triangle<T>>(random, 20'000);
    for (const bvh_quality quality : qualities) {
        const bvh<triangle<T>> alone(shapes, {.quality = quality, .threads = 1});
        const bvh<triangle<T>> together(shapes, {.quality = quality, .threads = 8});
        for (int i = 0; i < test_rays / 50; ++i) {
            const question<T> q(random);
            REQUIRE(answer<T>(alone, q) == answer<T>(together, q));
        }
    }
}

TEST_CASE("bvh: what one of eight threads refuses is refused, and named") {
    random_numbers random(32);
    std::vector<sphere<float>> shapes = random_shapes<sphere<float>>(random, 20'000);
    shapes[12'345].center.x = infinity<float>;
    CHECK_THROWS_WITH_AS((bvh<sphere<float>>(shapes, {.threads = 8})), "raio::bvh: shape 12345 has no finite bounds",
                         std::invalid_argument);
}

}  // namespace raio::test
