#include <raio/compose/any_primitive.hpp>

#include <raio/compose/group.hpp>
#include <raio/compose/transformed.hpp>

#include "support/properties.hpp"
#include "support/spheres.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("any_primitive: answers as the primitive does, bit for bit", T, RAIO_NUMBERS) {
    random_numbers random(19);
    for (int i = 0; i < at_least_a_tenth_of(10'000); ++i) {
        const probe<sphere<T>> p = random_probe<sphere<T>>(random);
        const any_primitive<T> any = p.shape;
        const any_solid<T> any_with_inside = p.shape;
        hit_record<T> rec = untouched_record<T>(), by_any = rec, by_solid = rec;
        const bool hit = p.hit(rec);
        REQUIRE(any.hit(p.ray, p.t_min, p.t_max, by_any) == hit);
        REQUIRE(any_with_inside.hit(p.ray, p.t_min, p.t_max, by_solid) == hit);
        REQUIRE((same_record(rec, by_any) && same_record(rec, by_solid)));
        REQUIRE(any.occluded(p.ray, p.t_min, p.t_max) == hit);
        REQUIRE((any.bounds().min == p.shape.bounds().min && any.bounds().max == p.shape.bounds().max));
        const auto inside = any_with_inside.spans(p.ray);
        REQUIRE(inside.empty() == p.shape.spans(p.ray).empty());
        if (!inside.empty()) REQUIRE((inside.count == 1 && inside.intervals[0] == p.shape.spans(p.ray)));
    }
}

TEST_CASE_TEMPLATE("any_primitive: under a map the ray keeps its digits", T, RAIO_NUMBERS) {
    random_numbers random(20);
    int hits = 0;
    for (int i = 0; i < at_least_a_tenth_of(2'000); ++i) {
        const sphere<T> ball{vec3<T>(random.direction()), T(1)};
        const auto map = rotation(vec3<T>(random.direction()), T(1)) * scaling<T>({3, T(0.1), -2});
        const transformed fixed{ball, map};
        const transformed any{any_solid<T>(ball), map};
        const ray<T> ray{vec3<T>(random.direction() * 1e3), vec3<T>(random.direction())};
        const raio::ray<T> aimed{ray.origin, vec3<T>(map.point(ball.center) - ray.origin) + ray.direction};
        hit_record<T> a{}, b{};
        const bool hit = fixed.hit(aimed, T(0), infinity<T>, a);
        REQUIRE(any.hit(aimed, T(0), infinity<T>, b) == hit);
        REQUIRE(any.occluded(aimed, T(0), infinity<T>) == hit);
        REQUIRE(any.spans(aimed).empty() == fixed.spans(aimed).empty());
        if (!hit) continue;
        REQUIRE(same_record(a, b));
        REQUIRE(any.spans(aimed).intervals[0] == fixed.spans(aimed));
        ++hits;
    }
    CHECK(hits > at_least_a_tenth_of(500));
}

TEST_CASE_TEMPLATE("any_primitive: a scene of all kinds, which share what they hold", T, RAIO_NUMBERS) {
    const any_primitive<T> floor = plane<T>{{0, 0, -3}, {0, 0, 1}}, ball = sphere<T>{{0, 0, 0}, 1};
    const group scene{std::vector<any_primitive<T>>{floor, ball, any_primitive<T>(group{ball, floor})}};
    hit_record<T> rec{};
    REQUIRE(scene.hit({{0, 0, 9}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK((rec.t == T(8) && rec.index == 1));
    REQUIRE(scene.hit({{5, 0, 9}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK((rec.t == T(12) && rec.index == 0));
    CHECK((floor.bounds().max.x == infinity<T> && scene.bounds().max.x == infinity<T>));
    static_assert(!solid<any_primitive<T>> && solid<any_solid<T>> &&
                  std::is_convertible_v<any_solid<T>, any_primitive<T>>);
}

/// Something that somebody else wrote, without bounds, for its own numbers only.
template <class T>
struct homemade {
    using number = T;
    bool hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        return sphere<T>{{0, 0, 0}, 1}.hit(ray, t_min, t_max, rec);
    }
    bool occluded(const ray<T>& ray, T t_min, T t_max) const {
        return sphere<T>{{0, 0, 0}, 1}.occluded(ray, t_min, t_max);
    }
};

TEST_CASE_TEMPLATE("any_primitive: of what knows only its own numbers, without bounds", T, RAIO_NUMBERS) {
    const any_primitive<T> any = homemade<T>{};
    CHECK(any.bounds().min.x == -infinity<T>);
    hit_record<T> rec{};
    REQUIRE(transformed{any, scaling<T>({2, 2, 2})}.hit({{0, 0, 9}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK((rec.t == T(7) && rec.normal.z == T(1) && rec.front_face));
    CHECK(transformed{homemade<T>{}, scaling<T>({2, 2, 2})}.occluded({{0, 0, 9}, {0, 0, -1}}, T(7), T(7)));
}

}  // namespace raio::test
