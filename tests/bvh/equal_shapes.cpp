#include <raio/bvh/equal_shapes.hpp>

#include <doctest/doctest.h>

#include <raio/compose/any_primitive.hpp>

#include "support/trees.hpp"

namespace raio::test {
namespace {

/// A ball that counts how often it is asked.
struct counted_ball {
    using number = float;

    sphere<float> ball;
    int* asked;

    template <record Record>
    bool hit(const ray<float>& ray, float t_min, float t_max, Record& rec) const {
        ++*asked;
        return ball.hit(ray, t_min, t_max, rec);
    }
    bool occluded(const ray<float>& ray, float t_min, float t_max) const {
        ++*asked;
        return ball.occluded(ray, t_min, t_max);
    }
    aabb<float> bounds() const { return ball.bounds(); }
};

/// Random shapes, among them two hundred of each of three.
template <class Shape>
std::vector<Shape> crowded(random_numbers& random) {
    std::vector<Shape> shapes = random_shapes<Shape>(random, 900);
    for (std::size_t i = 0; i < 600; ++i) shapes[i * 3 / 2] = shapes[899 - i % 3];
    return shapes;
}

template <class Tree, class Loop, class T = number_t<Tree>>
void check_all_hits(const Tree& tree, const Loop& loop, random_numbers& random) {
    int several = 0;
    for (int i = 0; i < at_least_a_tenth_of(1000); ++i) {
        question<T> q(random);
        const aabb<T> crowd = loop[loop.size() - 1 - std::size_t(random.integer(0, 2))].bounds();
        if (random.one_in(2)) q.ray.direction = (crowd.min + crowd.max) / T(2) - q.ray.origin;
        std::vector<hit_record<T>> expected;
        for (std::uint32_t j = 0; j < loop.size(); ++j) {
            hit_record<T> rec{};
            for (T from = q.t_min; loop[j].hit(q.ray, from, q.t_max, rec); from = after(rec.t)) {
                rec.index = j;
                expected.push_back(rec);
            }
        }
        std::ranges::sort(expected, detail::comes_before<T>);
        several += expected.size() > 100 ? 1 : 0;
        REQUIRE(std::ranges::equal(tree.all_hits(q.ray, q.t_min, q.t_max), expected, test::same<T>));
        std::array<hit_record<T>, 5> few;
        const std::size_t count = std::min(few.size(), expected.size());
        REQUIRE(tree.nearest_hits(q.ray, q.t_min, q.t_max, few) == count);
        REQUIRE(std::equal(few.begin(), few.begin() + std::ptrdiff_t(count), expected.begin(), test::same<T>));
        const auto late = [](const hit_record<T>& rec) { return rec.index > 700; };
        const auto first = std::ranges::find_if(expected, late);
        hit_record<T> rec{};
        REQUIRE(tree.hit(q.ray, q.t_min, q.t_max, rec, late) == (first != expected.end()));
        REQUIRE(test::same(rec, first != expected.end() ? *first : hit_record<T>{}));
        REQUIRE(tree.occluded(q.ray, q.t_min, q.t_max, late) == (first != expected.end()));
    }
    CHECK(several * 25 >= at_least_a_tenth_of(1000));
}

}  // namespace

TEST_CASE("bvh: of many equal shapes one is asked (200,000 equal triangles were as slow as their loop)") {
    int asked = 0;
    const std::vector<counted_ball> balls(10'000, counted_ball{{{1, 2, 3}, 4}, &asked});
    for (const bvh_quality quality : qualities) {
        const bvh tree(std::span<const counted_ball>(balls), {.quality = quality});
        asked = 0;
        hit_record<float> rec{};
        CHECK(tree.hit({{9, 2, 3}, {-1, 0, 0}}, 0, infinity<float>, rec));
        CHECK((rec.t == 4 && rec.index == 0));
        CHECK(!tree.occluded({{9, 2, 3}, {1, 0, 0}}, 0, infinity<float>));
        CHECK(asked < 10);
        CHECK(tree.all_hits({{9, 2, 3}, {-1, 0, 0}}, 0, infinity<float>).size() == 20'000);
    }
}

TEST_CASE_TEMPLATE("bvh: among many equal shapes all queries answer as the loop", T, RAIO_NUMBERS) {
    random_numbers random(71);
    const auto spheres = crowded<sphere<T>>(random);
    const auto triangles = crowded<triangle<T>>(random);
    for (const bvh_quality quality : qualities) {
        const bvh tree(std::span<const sphere<T>>(spheres), {.quality = quality});
        check_like(tree, group{spheres}, random, at_least_a_tenth_of(1000));
        check_all_hits(tree, spheres, random);
        check_all_hits(bvh(std::span<const triangle<T>>(triangles), {.quality = quality}), triangles, random);
    }
    check_like(bvh{group{triangles, spheres}}, group{triangles, spheres}, random, at_least_a_tenth_of(1000));
    const std::vector<any_primitive<T>> owned(spheres.begin(), spheres.end());
    check_like(bvh(owned, {.quality = bvh_quality::low}), group{spheres}, random, at_least_a_tenth_of(1000));

    mesh<T> fans;
    for (const triangle<T>& t : triangles) {
        const auto first = static_cast<std::uint32_t>(fans.vertices.size());
        fans.vertices.insert(fans.vertices.end(), {t.a, t.b, t.c});
        fans.triangles.push_back({first, first + 1, first + 2});
    }
    check_all_hits(bvh{fans}, triangles, random);
    check_all_hits(bvh<mesh_triangle<T>>(fans), triangles, random);
}

TEST_CASE_TEMPLATE("bvh: equal shapes may differ when they move", T, RAIO_NUMBERS) {
    random_numbers random(72);
    auto spheres = crowded<sphere<T>>(random);
    bvh tree{spheres};
    const std::size_t bytes = tree.bytes();
    for (sphere<T>& s : spheres) s.center += vec3<T>(1, 2, 3);
    tree.refit(spheres);
    CHECK(tree.bytes() == bytes);
    check_all_hits(tree, spheres, random);
    for (sphere<T>& s : spheres) s.center += within<T>(random, 2);
    tree.refit(spheres);
    CHECK(tree.bytes() > bytes);
    check_like(tree, group{spheres}, random, at_least_a_tenth_of(1000));
}

}  // namespace raio::test
