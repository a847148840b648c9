#include <raio/compose/quick.hpp>

#include <algorithm>

#include <doctest/doctest.h>

#include <raio/bvh/bvh.hpp>
#include <raio/number/simd.hpp>
#include <raio/raio.hpp>

#include "support/portable_shapes.hpp"
#include "support/random.hpp"

namespace raio::test {

/// Quick and exact answers to the same rays.
struct comparison {
    int hits = 0;       ///< of the exact shape
    int unlike = 0;     ///< rays of which one says that they hit, and the other that they miss
    int elsewhere = 0;  ///< both hit, but not where the errors of both allow it
    int turned = 0;     ///< the same point, and another normal

    template <class T>
    void add(bool exact_met, const hit_record<T>& exact, bool quick_met, const hit_record<T>& quick) {
        hits += exact_met;
        unlike += exact_met != quick_met;
        if (!exact_met || !quick_met) return;
        const vec3<T> apart = abs(exact.point - quick.point), off = exact.error + quick.error;
        const bool same = apart.x <= off.x && apart.y <= off.y && apart.z <= off.z;
        elsewhere += !same;
        turned += same && !(dot(exact.normal, quick.normal) > T(0.99));
    }
};

TEST_CASE_TEMPLATE("quick: what the exact shape answers, but for a few rays that only just hit or miss", T, float,
                   double) {
    for_every_portable_shape<T>([](const char* name, auto make) {
        using P = decltype(make(std::declval<portable_numbers&>()));
        if constexpr (detail::has_plain_formula<P>) {
            portable_numbers numbers;
            comparison found;
            const int rays = at_least_a_tenth_of(3'000);
            for (int i = 0; i < rays; ++i) {
                const quick<P> shape{make(numbers)};
                const P& exact = shape;
                const ray<T> ray = numbers.aimed_ray<T>();
                hit_record<T> rec{}, expected{};
                const bool met = shape.hit(ray, T(0), infinity<T>, rec);
                REQUIRE(shape.occluded(ray, T(0), infinity<T>) == met);
                found.add(exact.hit(ray, T(0), infinity<T>, expected), expected, met, rec);
            }
            INFO(std::string(name));
            // Where on a thick curve a point lies, and whether a blob's polynomial is zero, floats know badly.
            const bool is_hard = std::same_as<P, bezier_curve<float>> || std::same_as<P, blob<float, 3>>;
            const int few = is_hard ? rays / 10 : 1 + rays / 500;
            CHECK(found.hits > rays / 100);
            CHECK(found.unlike <= few);
            CHECK(found.elsewhere <= few);
            CHECK(found.turned <= few);
        }
    });
}

static_assert(std::is_aggregate_v<quick<sphere<float>>> && sizeof(quick<sphere<float>>) == sizeof(sphere<float>));
static_assert(solid<quick<sphere<float>>> && bounded<quick<torus<double>>> && sampleable<quick<disc<float>>>);
static_assert(!solid<quick<triangle<float>>>);

TEST_CASE("quick: known when compiling, as other shapes are") {
    constexpr quick floor{plane<double>{{0, -1, 0}, {0, 2, 0}}};
    static_assert(floor.occluded(ray<double>{{0, 0, 0}, {0, -2, 1}}, 0.0, 1.0));
    static_assert(!floor.occluded(ray<double>{{0, 0, 0}, {0, -2, 1}}, 0.0, 0.25));
    CHECK(floor.occluded(ray<double>{{0, 0, 0}, {0, -2, 1}}, 0.5, 0.5));
}

TEST_CASE("quick: a window, a miss and a record of one's own") {
    struct seen {
        double t;
        glm::vec3 normal;
        int material;
    };
    const quick<sphere<float>> ball{{{0, 0, -3}, 1}};
    const ray<float> through{{0, 0, 0}, {0, 0, -1}}, beside{{2, 0, 0}, {0, 0, -1}};
    seen rec{-1, {}, 7};
    CHECK(!ball.hit(beside, 0.0f, 10.0f, rec));
    CHECK(!ball.hit(through, 0.0f, 1.5f, rec));
    CHECK(!ball.hit(through, 2.5f, 3.5f, rec));
    CHECK((rec.t == -1 && rec.material == 7));
    REQUIRE(ball.hit(through, 2.5f, 10.0f, rec));
    CHECK((rec.t == 4 && rec.normal == glm::vec3(0, 0, 1) && rec.material == 7));
    REQUIRE(ball.hit(through, 2.0f, 10.0f, rec));
    CHECK((rec.t == 2 && rec.normal == glm::vec3(0, 0, 1)));
}

TEST_CASE("quick: rays that leave a surface do not meet it again") {
    random_numbers random(1);
    const quick<sphere<float>> ball{{{1, 2, 3}, 2}};
    const quick<triangle<float>> flat{{{0, 0, 0}, {4, 1, 0}, {1, 5, 2}}};
    const auto check = [&](const auto& shape) {
        int left = 0, met_again = 0;
        for (int i = 0; i < at_least_a_tenth_of(10'000); ++i) {
            const vec3<float> from(random.direction() * 9.0), to(random.direction() * 2.0 + vec3<double>(1, 2, 1));
            hit_record<float> rec{};
            if (!shape.hit(ray<float>{from, to - from}, 0.0f, infinity<float>, rec)) continue;
            vec3<float> away(random.direction());
            if (dot(away, rec.normal) < 0) away = -away;
            ++left;
            met_again += shape.occluded(spawn_ray(rec, away), 0.0f, infinity<float>);
        }
        CHECK(left > at_least_a_tenth_of(1000));
        CHECK(met_again == 0);
    };
    check(ball), check(flat);
}

TEST_CASE_TEMPLATE("quick: in packs, lane by lane", T, float, double) {
    constexpr std::size_t lanes = 4;
    using P = pack<T, lanes>;
    for_every_portable_shape<T>([](const char* name, auto make) {
        using Shape = decltype(make(std::declval<portable_numbers&>()));
        if constexpr (detail::has_plain_formula<Shape>) {
            if constexpr (detail::gatherable<quick<Shape>>) {
                portable_numbers numbers;
                int unlike = 0, hits = 0;
                const int rounds = at_least_a_tenth_of(4'000) / int(lanes);
                for (int i = 0; i < rounds; ++i) {
                    detail::gathered<quick<Shape>, lanes> shapes;
                    ray<P> along;
                    std::array<hit_record<T>, lanes> expected{};
                    std::array<bool, lanes> met{};
                    for (std::size_t lane = 0; lane < lanes; ++lane) {
                        const quick<Shape> shape{make(numbers)};
                        const ray<T> r = numbers.aimed_ray<T>();
                        shapes.set(lane, shape);
                        detail::set_lane(along.origin, lane, r.origin);
                        detail::set_lane(along.direction, lane, r.direction);
                        met[lane] = shape.hit(r, T(0), infinity<T>, expected[lane]);
                    }
                    hit_record<P> rec{};
                    const auto hit = shapes.shapes().hit(along, P(0), P(infinity<T>), rec);
                    for (std::size_t lane = 0; lane < lanes; ++lane) {
                        hits += met[lane];
                        // The compiler may fuse products with sums in one of both.
                        const bool same =
                            !met[lane] || abs(rec.t[lane] - expected[lane].t) <= T(1e-3) * expected[lane].t;
                        unlike += hit[lane] != met[lane] || !same;
                    }
                }
                INFO(std::string(name));
                CHECK(hits > rounds / 40);
                CHECK(unlike <= rounds / 80);
            }
        }
    });
}

/// How many of the rays find another shape, or another place.
template <class A, class B>
int answered_otherwise(const A& a, const B& b, int rays) {
    portable_numbers numbers;
    int unlike = 0, hits = 0;
    for (int i = 0; i < rays; ++i) {
        const ray<float> ray = numbers.aimed_ray<float>();
        hit_record<float> x{}, y{};
        const bool met = a.hit(ray, 0.0f, infinity<float>, x);
        hits += met;
        const bool same =
            b.hit(ray, 0.0f, infinity<float>, y) == met &&
            (!met || (x.index == y.index && x.front_face == y.front_face && abs(x.t - y.t) <= 1e-4f * (1 + x.t)));
        unlike += !same || b.occluded(ray, 0.0f, infinity<float>) != met;
    }
    CHECK(hits > rays / 20);
    return unlike;
}

/// Many small ones.
template <class P, class Make>
std::vector<P> scattered(int count, Make make) {
    portable_numbers numbers;
    std::vector<P> shapes;
    for (int i = 0; i < count; ++i) shapes.push_back(make(numbers));
    return shapes;
}

TEST_CASE("quick: through trees, one by one and in bundles, as through the loop") {
    const auto check = [](const auto& shapes) {
        using Q = std::remove_cvref_t<decltype(shapes[0])>;
        const bvh<Q> tree(shapes);
        CHECK(answered_otherwise(group(shapes), tree, at_least_a_tenth_of(2000)) <= 4);
        portable_numbers numbers;
        int unlike = 0;
        for (int i = 0; i < 50; ++i) {
            std::array<ray<float>, 64> rays;
            const vec3<float> from = numbers.point<float>(4);
            for (ray<float>& r : rays) r = {from, numbers.point<float>(0.0625) - from};
            std::array<hit_record<float>, 64> recs{};
            const std::uint64_t met = tree.hit(rays, 0.0f, infinity<float>, recs);
            for (std::size_t k = 0; k < 64; ++k) {
                hit_record<float> rec{};
                const bool alone = tree.hit(rays[k], 0.0f, infinity<float>, rec);
                unlike += alone != ((met >> k & 1) != 0) ||
                          (alone && (rec.index != recs[k].index || abs(rec.t - recs[k].t) > 1e-4f * rec.t));
            }
        }
        CHECK(unlike <= 4);
    };
    using numbers = portable_numbers;
    check(scattered<quick<sphere<float>>>(300, [](numbers& n) {
        return quick<sphere<float>>{{n.point<float>(), n.length<float>() * 0.25f}};
    }));
    check(scattered<quick<triangle<float>>>(300, [](numbers& n) {
        const vec3<float> a = n.point<float>();
        return quick<triangle<float>>{{a, a + n.point<float>(0.25), a + n.point<float>(0.25)}};
    }));
    check(scattered<quick<torus<float>>>(60, [](numbers& n) {
        return quick<torus<float>>{{n.point<float>(), n.point<float>(), n.length<float>(), n.length<float>() * 0.25f}};
    }));
}

TEST_CASE("quick: a tree of a mesh, with the corners copied or left in the mesh") {
    mesh<float> of;
    portable_numbers numbers;
    numbers.uniform();  // or the rays below would be aimed at its vertices
    for (int i = 0; i < 300; ++i) of.vertices.push_back(numbers.point<float>());
    for (std::uint32_t i = 0; i < 300; ++i) of.triangles.push_back({i, (i + 1) % 300, (i + 7) % 300});
    CHECK(answered_otherwise(bvh(of), bvh<quick<triangle<float>>>(of), at_least_a_tenth_of(2000)) <= 4);
    CHECK(answered_otherwise(bvh(of), bvh<quick<mesh_triangle<float>>>(of), at_least_a_tenth_of(2000)) <= 4);
}

TEST_CASE("quick: under maps, in CSG, in groups and behind any_primitive") {
    const sphere<float> ball{{0, 0, 0}, 1};
    const box<float> block{{-0.5f, -0.7f, -2}, {0.6f, 0.7f, 2}};
    const torus<float> ring{{0, 0, 0}, {0, 1, 0.5f}, 1, 0.4f};
    const transform<float> map =
        rotation<float>({1, 2, 3}, 0.7f) * translation<float>({0.3f, 0, 0}) * scaling<float>({1, 2, 0.5f});
    const int rays = at_least_a_tenth_of(5000), few = 10;
    CHECK(answered_otherwise(transformed(ring, map), transformed(quick{ring}, map), rays) <= few);
    CHECK(answered_otherwise(difference_of(ball, block), difference_of(quick{ball}, quick{block}), rays) <= few);
    CHECK(answered_otherwise(union_of(ring, ball), union_of(quick{ring}, quick{ball}), rays) <= few);
    CHECK(answered_otherwise(intersection_of(ball, ring), intersection_of(quick{ball}, ring), rays) <= few);
    CHECK(answered_otherwise(transformed(difference_of(ball, block), map),
                             transformed(difference_of(quick{ball}, quick{block}), map), rays) <= few);
    CHECK(answered_otherwise(group(ball, ring), group(quick{ball}, quick{ring}), rays) <= few);
    CHECK(answered_otherwise(any_primitive<float>(ring), any_primitive<float>(quick{ring}), rays) <= few);
    CHECK(answered_otherwise(bvh<transformed<sphere<float>>>(std::vector{transformed(ball, map)}),
                             bvh<transformed<quick<sphere<float>>>>(std::vector{transformed(quick{ball}, map)}),
                             rays) <= few);
}

TEST_CASE("quick: what is recorded again is the crossing at t, whichever of them that is") {
    const ray<double> ray{{0, 0, 5}, {0, 0, -1}};
    const auto recorded_again = [&](const auto& shape) {
        int count = 0;
        hit_record<double> rec{}, again{};
        for (double from = 0; shape.hit(ray, from, infinity<double>, rec); from = rec.t + 0.1, ++count) {
            shape.record_at(ray, rec.t, again);
            CHECK((again.t == rec.t && again.point == rec.point && again.normal == rec.normal));
            CHECK(again.front_face == rec.front_face);
        }
        return count;
    };
    CHECK(recorded_again(quick<triangle<double>>{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}}) == 1);
    CHECK(recorded_again(quick<sphere<double>>{{{0, 0, 0}, 1}}) == 2);
    CHECK(recorded_again(quick<torus<double>>{{{0, 0, 0}, {0, 1, 0}, 2, 0.5}}) == 4);
}

}  // namespace raio::test
