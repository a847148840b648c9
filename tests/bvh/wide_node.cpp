#include <raio/bvh/wide_node.hpp>

#include "support/slabs.hpp"

namespace raio::test {

using detail::child;
using detail::node_ray;

static_assert(!child::is_leaf(0) && !child::is_leaf(child::leaf_bit - 1));
static_assert(child::is_leaf(child::leaf(0, 0)) && child::is_leaf(child::leaf(15, (1u << 27) - 1)));
static_assert(child::kind(child::leaf(15, 7)) == 15 && child::block(child::leaf(15, 7)) == 7);
static_assert(child::block(child::leaf(0, (1u << 27) - 1)) == (1u << 27) - 1);

TEST_CASE("wide_node: leaves have the first places, nodes stand side by side") {
    wide_node node;
    node.leaf_count = 2, node.first_node = 40;
    node.leaves[0] = child::leaf(1, 5), node.leaves[1] = child::leaf(0, 9);
    CHECK(node.child_at(0) == child::leaf(1, 5));
    CHECK(node.child_at(1) == child::leaf(0, 9));
    CHECK(node.child_at(2) == 40);
    CHECK(node.child_at(3) == 41);
    CHECK(reinterpret_cast<std::uintptr_t>(&node) % 64 == 0);
}

TEST_CASE("wide_node: boxes come out as they went in, places without one stay empty") {
    random_numbers random(1);
    for (std::size_t count = 0; count <= node_width; ++count) {
        std::vector<build_box> boxes(node_width);
        wide_node node;
        for (std::size_t i = 0; i < count; ++i) node.set(i, boxes[i] = random_box(random));
        for (std::size_t i = 0; i < node_width; ++i) {
            for (unsigned axis = 0; axis < 3; ++axis) {
                CHECK(node.box(i).low(axis) == boxes[i].low(axis));
                CHECK(node.box(i).high(axis) == boxes[i].high(axis));
            }
        }
    }
}

/// No child is lost that the ray meets, few are met that it passes at a distance, and no ray enters later than it does.
TEST_CASE_TEMPLATE("node_ray: meets what the ray meets", T, RAIO_NUMBERS) {
    random_numbers random(2);
    int met_by_ray = 0;
    for (int i = 0; i < at_least_a_tenth_of(100'000); ++i) {
        const auto count = static_cast<std::size_t>(random.integer(0, static_cast<int>(node_width)));
        const wide_node node = random_node(random, count);
        const ray<T> r = random_ray<T>(random);
        const double size = 1 / double(norm1(r.direction));
        const interval<double> window =
            random.one_in(2) ? interval<double>{0, infinity<double>}
                             : interval<double>{random.uniform(-20, 20) * size, random.uniform(0, 60) * size};
        const auto t_min = static_cast<float>(window.min), t_max = static_cast<float>(window.max);
        node_ray::numbers entry;
        const std::uint32_t met =
            node_ray(r, T(1), random_box_reach).meets(node, node_ray::numbers(t_min), node_ray::numbers(t_max), entry);
        REQUIRE((met >> count) == 0);
        for (std::size_t j = 0; j < count; ++j) {
            const interval<double> in_floats{double(t_min), double(t_max)};
            const interval<double> inside = within_box(r, node.box(j), in_floats);
            const bool is_met = (met >> j & 1) != 0;
            if (!inside.empty()) {
                ++met_by_ray;
                REQUIRE(is_met);
                REQUIRE(double(entry[j]) <= inside.min);
                REQUIRE(double(entry[j]) >= double(t_min));
            }
            const interval<double> a_little_more{in_floats.min - 1e-3 * size, in_floats.max + 1e-3 * size};
            if (is_met) REQUIRE(!within_box(r, node.box(j), a_little_more, 1e-3).empty());
        }
    }
    CHECK(met_by_ray > at_least_a_tenth_of(2000));
}

TEST_CASE_TEMPLATE("node_ray: boxes may be scaled, and t stays", T, RAIO_NUMBERS) {
    random_numbers random(3);
    for (int i = 0; i < at_least(1000); ++i) {
        const wide_node node = random_node(random, node_width);
        const ray<T> r = random_ray<T>(random), large{r.origin * T(0x1p50), r.direction * T(0x1p50)};
        node_ray::numbers entry, entry_of_large;
        const node_ray::numbers from(0), to(infinity<float>);
        const std::uint32_t met = node_ray(r, T(1), random_box_reach).meets(node, from, to, entry);
        CHECK(node_ray(large, T(0x1p-50), random_box_reach).meets(node, from, to, entry_of_large) == met);
        for (std::size_t j = 0; j < node_width; ++j) CHECK(entry[j] == entry_of_large[j]);
    }
}

TEST_CASE("node_ray: out of range every box is met") {
    random_numbers random(4);
    const wide_node node = random_node(random, node_width);
    const std::uint32_t all = (1u << node_width) - 1;
    const auto met = [&](const ray<float>& r, float size = random_box_reach) {
        node_ray::numbers entry;
        return node_ray(r, 1.0f, size).meets(node, {0}, {infinity<float>}, entry);
    };
    CHECK(met({{100, 100, 100}, {1, 0, 0}}) == 0);
    CHECK(met({{100, 100, 100}, {0x1p-91f, 0, 0}}) == all);
    CHECK(met({{100, 100, 100}, {0x1p101f, 0, 0}}) == all);
    CHECK(met({{0x1p-20f, 0, 0}, {0x1p-91f, 0, 0}}, 0x1p-20f) == all);
    CHECK(met({{0x1p91f, 100, 100}, {1, 0, 0}}) == all);
}

TEST_CASE("node_ray: what is no ray is out of range") {
    const auto fits = [](const ray<float>& r) { return node_ray(r, 1.0f, random_box_reach).fits(); };
    const ray<float> good{{1, 2, 3}, {0, -1, 2}};
    CHECK(fits(good));
    CHECK(!fits({good.origin, {0, 0, 0}}));
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        for (const float bad : {std::numeric_limits<float>::quiet_NaN(), infinity<float>, -infinity<float>}) {
            ray<float> from_nowhere = good, to_nowhere = good;
            from_nowhere.origin[axis] = bad, to_nowhere.direction[axis] = bad;
            CHECK((!fits(from_nowhere) && !fits(to_nowhere)));
        }
    }
}

}  // namespace raio::test
