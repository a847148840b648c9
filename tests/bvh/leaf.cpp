#include <raio/bvh/leaf.hpp>

#include <doctest/doctest.h>

#include <raio/shape/convex_polyhedron.hpp>
#include <raio/shape/sphere.hpp>
#include <raio/shape/triangle.hpp>

#include "support/random.hpp"

namespace raio::test {

static_assert(std::same_as<detail::leaves_of<sphere<float>>, detail::leaf_blocks<sphere<float>>>);
static_assert(std::same_as<detail::leaves_of<convex_polyhedron<float>>, detail::leaf_list<convex_polyhedron<float>>>);

TEST_CASE_TEMPLATE("leaf_blocks: shapes with their ids, each once, and nothing in the lanes that are left", T,
                   RAIO_NUMBERS) {
    detail::leaf_blocks<sphere<T>> leaves;
    const auto shape_of = [](std::uint32_t id) { return sphere<T>{{0, 0, -T(id)}, T(0.5)}; };
    const detail::leaf_range ranges[] = {{0, 4}, {4, 1}};
    const std::uint32_t ids[] = {7, 3, 7, 3, 5};
    leaves.resize(ranges);
    REQUIRE(leaves.size() == 2);
    CHECK((leaves.bytes() >= 2 * leaves.lanes * (sizeof(sphere<T>) + sizeof(std::uint32_t)) &&
           leaves.bytes() < 100 * sizeof(sphere<T>)));
    leaves.fill(0, std::span(ids).first(std::min<std::size_t>(leaves.lanes, 4)), shape_of);
    leaves.fill(1, std::span(ids).last(1), shape_of);
    CHECK(leaves.used(0) == 3);
    CHECK((leaves.id(0, 0) == 3 && leaves.id(0, 1) == 7));
    CHECK(leaves.shape(0, 1).center == vec3<T>(0, 0, -7));
    CHECK((leaves.used(1) == 1 && leaves.id(1, 0) == 5));

    const ray<T> r{{0, 0, 0}, {0, 0, -1}};
    auto found = leaves.find(0, r, T(0), infinity<T>);
    CHECK((found.sure == 3 && found.open == 0));
    CHECK((found.low[0] <= T(2.5) && T(2.5) <= found.high[0]));
    CHECK((found.low[1] <= T(6.5) && T(6.5) <= found.high[1]));
    found = leaves.find(0, r, T(4), infinity<T>);
    CHECK((found.sure == 2 && found.open == 0));
    found = leaves.find(1, r, T(0), infinity<T>);
    CHECK((found.sure == 1 && found.open == 0));
    found = leaves.find(1, r, T(6), infinity<T>);
    CHECK((found.sure == 0 && found.open == 0));
    found = leaves.find(1, r, T(4.5), infinity<T>);  // just there: of floats the plain shape has to say it
    constexpr bool knows = detail::keeps_all_digits<T>;
    CHECK((found.sure == (knows ? 1 : 0) && found.open == (knows ? 0 : 1)));

    leaves.set(1, 0, sphere<T>{{0, 0, -9}, T(0.5)});
    CHECK(leaves.shape(1, 0).center == vec3<T>(0, 0, -9));
    CHECK(leaves.find(1, r, T(6), infinity<T>).sure == 1);
}

TEST_CASE_TEMPLATE("leaf_blocks: a ray that was mapped, which has more digits than a number", T, RAIO_NUMBERS) {
    detail::leaf_blocks<triangle<T>> leaves;
    const detail::leaf_range ranges[] = {{0, 2}};
    const std::uint32_t ids[] = {0, 1};
    leaves.resize(ranges);
    leaves.fill(0, ids, [](std::uint32_t id) {
        const auto x = static_cast<T>(id);
        return triangle<T>{{x, 0, -2}, {x + 1, 0, -2}, {x, 1, -2}};
    });
    // Seen from the world the shapes are moved aside by `more`, and the ray is at x.
    const auto found_at = [&](T x, T more, T t_min = T(0), T t_max = infinity<T>) {
        const inverse_map<T> aside(translation<T>({-more, 0, 0}));
        return leaves.find(0, mapped_ray<T>({{x, T(0.25), 0}, {0, 0, -1}}, aside), t_min, t_max);
    };
    const T little = std::same_as<T, float> ? T(1e-12) : T(1e-20);
    CHECK((found_at(T(0.25), little).sure == 1 && found_at(T(0.25), little).open == 0));
    for (const T more : {-little, little}) {
        // Packs of doubles cannot tell 1e-20 from an edge, and leave it open; they can tell 1e-12.
        const auto found = found_at(T(0.75), more);
        const bool tells = std::same_as<T, float>;
        CHECK((found.sure == (tells && more < 0 ? 1 : 0) && found.open == (tells ? 0 : 1)));
        const inverse_map<T> aside(translation<T>({-more, 0, 0}));
        const ray<T> world{{T(0.75), T(0.25), 0}, {0, 0, -1}};
        CHECK(any_hit(leaves.shape(0, 0), mapped_ray<T>(world, aside), T(0), infinity<T>) == (more < 0));
    }
    CHECK((found_at(T(0.25), little, T(2.5)).sure == 0 && found_at(T(0.25), little, T(2.5)).open == 0));
    CHECK((found_at(T(0.25), little, T(0), T(1.5)).sure == 0 && found_at(T(0.25), little, T(0), T(1.5)).open == 0));

    // What packs are certain of is so, from wherever the ray comes.
    random_numbers random(3);
    int sure = 0, open = 0;
    for (int i = 0; i < at_least_a_tenth_of(20'000); ++i) {
        const transform<T> map = rotation(vec3<T>(random.direction()), T(random.uniform(-3, 3))) *
                                 scaling<T>(vec3<T>(vec3<double>(random.log_uniform(0.1, 10))));
        const inverse_map<T> inverse(map);
        const bool at_edge = random.one_in(8);
        const vec3<double> aim(random.uniform(-0.2, 2), at_edge ? 0 : random.uniform(-0.1, 0.5), -2);
        const vec3<double> from = aim + random.direction() * random.log_uniform(0.01, 1e6);
        const vec3<T> seen_from = map.point(vec3<T>(from)), seen_at = map.point(vec3<T>(aim));
        const ray<T> world{seen_from, seen_at - seen_from};
        const mapped_ray<T> r(world, inverse);
        const auto found = leaves.find(0, r, T(0), infinity<T>);
        for (unsigned lane = 0; lane < 2; ++lane) {
            const bool is_sure = (found.sure >> lane & 1) != 0, is_open = (found.open >> lane & 1) != 0;
            sure += is_sure ? 1 : 0, open += is_open ? 1 : 0;
            hit_record<T> rec{};
            const bool hit = first_hit(leaves.shape(0, lane), r, T(0), infinity<T>, rec);
            REQUIRE((is_open || hit == is_sure));
            REQUIRE((!is_sure || (found.low[lane] <= rec.t && rec.t <= found.high[lane])));
            if (is_sure && detail::keeps_all_digits<T>) REQUIRE(found.low[lane] == found.high[lane]);
        }
    }
    CHECK(sure > at_least_a_tenth_of(5'000));
    CHECK(open < at_least_a_tenth_of(4'000));
}

TEST_CASE_TEMPLATE("leaf_list: shapes with their ids, each a leaf", T, RAIO_NUMBERS) {
    detail::leaf_list<convex_polyhedron<T>> leaves;
    const auto shape_of = [](std::uint32_t id) {
        return convex_polyhedron<T>{std::vector<half_space<T>>(id, half_space<T>{{1, 0, 0}, 0})};
    };
    const detail::leaf_range ranges[] = {{0, 1}, {1, 1}};
    const std::uint32_t ids[] = {7, 5};
    leaves.resize(ranges);
    REQUIRE(leaves.size() == 2);
    for (std::uint32_t i = 0; i < 2; ++i) leaves.fill(i, std::span(ids).subspan(i, 1), shape_of);
    CHECK((leaves.bytes() >= 2 * (sizeof(shape_of(1)) + sizeof(std::uint32_t)) &&
           leaves.bytes() < 10 * sizeof(shape_of(1))));
    for (std::uint32_t i = 0; i < 2; ++i) {
        CHECK((leaves.used(i) == 1 && leaves.id(i, 0) == ids[i]));
        CHECK(leaves.shape(i, 0).planes.size() == ids[i]);
    }
    leaves.set(0, 0, shape_of(9));
    CHECK((leaves.shape(0, 0).planes.size() == 9 && leaves.shape(1, 0).planes.size() == 5));
}

}  // namespace raio::test
