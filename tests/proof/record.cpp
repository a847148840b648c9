#include <raio/proof/record.hpp>

#include <doctest/doctest.h>

#include <raio/bvh/bvh.hpp>
#include <raio/compose/any_primitive.hpp>
#include <raio/compose/csg.hpp>
#include <raio/compose/group.hpp>
#include <raio/compose/transformed.hpp>
#include <raio/shape/cylinder.hpp>
#include <raio/shape/sphere.hpp>
#include <raio/shape/torus.hpp>

#include "support/random.hpp"

namespace raio::test {

/// Records as programs have them: of other types, in another order, with members that raio knows nothing of.
struct only_t {
    double t;
};
struct shading {
    int material;
    glm::dvec3 normal;
    float t;
    bool front_face;
};
struct texel {
    float t;
    glm::vec2 uv;
    long index;
};
struct place {
    glm::vec3 error, point;
    float t;
};
struct without_t {
    glm::vec3 point;
};

static_assert(record<only_t> && record<shading> && record<texel> && record<place>);
static_assert(!record<without_t>);

/// Are the members of such a record those of a hit_record? On a miss nothing is written.
template <class P>
int fills_own_records(const P& shape, const ray<float>& ray, float t_max) {
    hit_record<float> rec{};
    only_t t{-1};
    shading shade{7, {5, 5, 5}, -1, false};
    texel texture{-1, {-1, -1}, -1};
    place where{{9, 9, 9}, {9, 9, 9}, -1};
    const bool met = shape.hit(ray, 0.0f, t_max, rec);
    REQUIRE(shape.hit(ray, 0.0f, t_max, t) == met);
    REQUIRE(shape.hit(ray, 0.0f, t_max, shade) == met);
    REQUIRE(shape.hit(ray, 0.0f, t_max, texture) == met);
    REQUIRE(shape.hit(ray, 0.0f, t_max, where) == met);
    REQUIRE(shade.material == 7);
    if (met) {
        REQUIRE((t.t == static_cast<double>(rec.t) && shade.t == rec.t && texture.t == rec.t && where.t == rec.t));
        REQUIRE((shade.normal == glm::dvec3(rec.normal) && shade.front_face == rec.front_face));
        REQUIRE((texture.uv == rec.uv && texture.index == rec.index));
        REQUIRE((where.point == rec.point && where.error == rec.error));
    } else {
        REQUIRE((t.t == -1 && shade.t == -1 && texture.t == -1 && where.t == -1));
        REQUIRE((shade.normal == glm::dvec3(5, 5, 5) && texture.index == -1 && where.point == glm::vec3(9, 9, 9)));
    }
    return met ? 1 : 0;
}

TEST_CASE("record: a hit fills what a record has, through every composition") {
    const sphere<float> ball{{0, 0, 0}, 1};
    const cylinder<float> rod{{0, -2, 0}, {0, 2, 0}, 0.5f};
    const torus<float> ring{{0, 0, 0}, {0, 1, 0}, 1.5f, 0.4f};
    const std::vector<sphere<float>> balls{ball, {{2, 0, 0}, 0.5f}, {{0, 2, 1}, 0.7f}};
    const transform<float> map = translation<float>({0.3f, 0, 0}) * scaling<float>({1, 2, 0.5f});
    random_numbers random(1);
    int met = 0;
    for (int i = 0; i < 400; ++i) {
        const vec3<float> from(random.direction() * 4.0), to(random.direction() * 1.5);
        const ray<float> ray{from, to - from};
        for (const float t_max : {0.7f, 100.0f}) {
            met += fills_own_records(ball, ray, t_max) + fills_own_records(rod, ray, t_max) +
                   fills_own_records(ring, ray, t_max) + fills_own_records(group(ball, balls), ray, t_max) +
                   fills_own_records(difference_of(ball, rod), ray, t_max) +
                   fills_own_records(transformed(ring, map), ray, t_max) +
                   fills_own_records(transformed(difference_of(ball, rod), map), ray, t_max) +
                   fills_own_records(any_primitive<float>(ring), ray, t_max) +
                   fills_own_records(bvh<sphere<float>>(balls), ray, t_max);
        }
    }
    CHECK(met > 2000);
}

TEST_CASE("record_point: a ray that leaves a ground of doubles needs no closer look") {
    const sphere<double> ground{{0, -1000, 0}, 1000};
    random_numbers random(77);
    for (int i = 0; i < 1000; ++i) {
        const vec3<double> target(random.uniform(-5, 5), 0, random.uniform(-5, 5)),
            eye = target + vec3<double>(1, 2, 3);
        hit_record<double> rec;
        REQUIRE(ground.hit(ray<double>{eye, target - eye}, 0.0, infinity<double>, rec));
        const ray<double> leaves = spawn_ray(rec, random.direction());
        const auto found = ground.crossings(line_in<strict_double>(leaves));
        REQUIRE((detail::is_known<double>(found.near) && detail::is_known<double>(found.far)));
    }
}

TEST_CASE_TEMPLATE("keep_in: points lie within the bounds, however far away their rays begin", T, float, double) {
    const sphere<T> ball{{0, 0, 0}, 1};
    random_numbers random(78);
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        // Head on along an axis, where the ball touches its bounds.
        vec3<T> origin(static_cast<T>(random.uniform(-1e-9, 1e-9)));
        origin[i % 3] = static_cast<T>((i % 2 == 0 ? 1 : -1) * random.log_uniform(1, 1e12));
        hit_record<T> rec;
        if (!ball.hit(ray<T>{origin, origin * T(-0.3)}, T(0), infinity<T>, rec)) continue;
        ++hits;
        REQUIRE(nearest_in(ball.bounds(), rec.point) == rec.point);
    }
    CHECK(hits > 2900);
}

}  // namespace raio::test
