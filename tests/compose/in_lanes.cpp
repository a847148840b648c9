#include <raio/compose/in_lanes.hpp>

#include <doctest/doctest.h>

#include <raio/bvh/bvh.hpp>
#include <raio/number/simd.hpp>
#include <raio/raio.hpp>

#include "support/packs.hpp"
#include "support/profiles.hpp"

namespace raio::test {

/// Rays about a shape that is about one unit large; one lane in eight is no ray, and windows end anywhere.
template <class S, class Shape, std::size_t N>
void check_each_lane(const std::array<const Shape*, N>& shapes) {
    using P = pack<S, N>;
    const in_lanes<P, Shape> packed{shapes};
    random_numbers random(20261123);
    int hits = 0;
    for (int i = 0; i < 200; ++i) {
        std::array<ray<S>, N> rays;
        std::array<S, N> starts, ends;
        ray<P> together;
        P t_min(0), t_max(0);
        for (std::size_t lane = 0; lane < N; ++lane) {
            const vec3<double> from = random.direction() * 4.0, to = random.direction() * random.uniform(0, 1.5);
            rays[lane] = {vec3<S>(from), vec3<S>(to - from)};
            if (random.integer(0, 7) == 0) rays[lane].direction.y = std::numeric_limits<S>::quiet_NaN();
            starts[lane] = S(random.uniform(-1, 1)), ends[lane] = S(random.uniform(0.5, 3));
            detail::set_lane(together.origin, lane, rays[lane].origin);
            detail::set_lane(together.direction, lane, rays[lane].direction);
            t_min.set(lane, starts[lane]), t_max.set(lane, ends[lane]);
        }
        hit_record<P> rec{P(7), vec3<P>(7), vec3<P>(7), vec2<P>(7), vec3<P>(7), 7, true};
        const auto hit = packed.hit(together, t_min, t_max, rec), occluded = packed.occluded(together, t_min, t_max);
        for (std::size_t lane = 0; lane < N; ++lane) {
            hit_record<S> expected{S(7), vec3<S>(7), vec3<S>(7), vec2<S>(7), vec3<S>(7), 7, true};
            const bool expected_hit = shapes[lane]->hit(rays[lane], starts[lane], ends[lane], expected);
            INFO(literal(rays[lane]));
            REQUIRE(hit[lane] == expected_hit);
            REQUIRE(occluded[lane] == expected_hit);
            REQUIRE(same_record(detail::in_lane<P>(rec, lane), expected));
            hits += expected_hit;
        }
    }
    CHECK(hits > 50);
}

template <class S, class Shape>
void check_same_in_each_lane(const Shape& shape) {
    check_each_lane<S>(in_every_lane<pack<S, 4>>(shape).shapes);
}

TEST_CASE_TEMPLATE("in_lanes: what has no shape of packs, each lane as the plain one", T, RAIO_NUMBERS) {
    check_same_in_each_lane<T>(surface_of_revolution<T>{{0, -1, 0}, {0, 1, 0}, {{0, 0}, {1, T(0.5)}, {T(0.3), 2}}});
    check_same_in_each_lane<T>(
        curved_surface_of_revolution<T>{{0, -1, 0}, {0, 1, 0}, {{1, 0}, {0, T(0.5)}, {2, 1}, {T(0.5), 2}}});
    check_same_in_each_lane<T>(heightfield<T>{{-1, -1}, {1, 1}, 3, {0, T(0.5), 0, 1, T(-0.5), 1, 0, T(0.5), T(0.25)}});
    check_same_in_each_lane<T>(
        algebraic<T, 4>{vec3<T>(-1), vec3<T>(1), {{1, 4, 0, 0}, {1, 0, 4, 0}, {1, 0, 0, 4}, {T(-0.5), 0, 0, 0}}});
    check_same_in_each_lane<T>(signed_distance{aabb<T>{vec3<T>(-1), vec3<T>(1)}, T(1e-3), T(1),
                                               [](const vec3<T>& p) { return length(p) - T(0.75); }});
    const sphere<T> left{{T(-0.5), 0, 0}, T(0.6)}, right{{T(0.5), 0, 0}, T(0.6)};
    check_same_in_each_lane<T>(difference_of(left, right));
    check_same_in_each_lane<T>(bvh(std::vector{left, right}));
}

TEST_CASE_TEMPLATE("in_lanes: another one in each lane", T, RAIO_NUMBERS) {
    std::vector<any_primitive<T>> some{sphere<T>{{0, 0, 0}, 1}, box<T>{vec3<T>(-1), vec3<T>(1)},
                                       torus<T>{{0, 0, 0}, {0, 0, 1}, 1, T(0.5)}};
    check_each_lane<T>(std::array<const any_primitive<T>*, 3>{&some[0], &some[1], &some[2]});

    const in_lanes<pack<T, 3>, any_primitive<T>> lanes{{&some[0], &some[1], &some[2]}};
    static_assert(bounded<in_lanes<pack<T, 3>, any_primitive<T>>>);
    const aabb<pack<T, 3>> boxes = lanes.bounds();
    for (std::size_t i = 0; i < 3; ++i) {
        const aabb<T> own = some[i].bounds();
        CHECK(detail::in_lane<pack<T, 3>>(ray<pack<T, 3>>{boxes.min, boxes.max}, i).origin == own.min);
        CHECK(detail::in_lane<pack<T, 3>>(ray<pack<T, 3>>{boxes.min, boxes.max}, i).direction == own.max);
    }
}

// What does not live long enough is refused, and so are doubles in lanes of floats.
template <class Shape>
concept fits_lanes_of_floats = requires {
    in_every_lane<pack<float, 4>>(std::declval<Shape>());
};
static_assert(fits_lanes_of_floats<const sphere<float>&>);
static_assert(!fits_lanes_of_floats<sphere<float>> && !fits_lanes_of_floats<const sphere<double>&>);

}  // namespace raio::test
