#include <raio/bvh/assemble.hpp>

#include <limits>

#include "support/binary_trees.hpp"
#include "support/trees.hpp"

namespace raio::test {

namespace {

/// Each shape stands in a leaf, or several times if it was cut to pieces, as it was given; each child has one parent;
/// boxes are around what is below them.
template <class Tree, class... Shapes>
struct assembled_check {
    using T = typename Tree::T;

    const Tree& tree;
    const std::tuple<std::vector<Shapes>...>& shapes;
    bool tight;  ///< boxes are no larger than that
    std::vector<int> seen = std::vector<int>(count());
    std::vector<int> visited = std::vector<int>(tree.nodes.size());
    double sum = 0;

    std::size_t count() const {
        return std::apply([](const auto&... s) { return (s.size() + ...); }, shapes);
    }

    build_box check(std::uint32_t i) {
        ++visited[i];
        const detail::wide_node& node = tree.nodes[i];
        build_box all;
        for (std::size_t place = 0; place < detail::node_width; ++place) {
            const build_box box = node.box(place);
            if (box.low(0) > box.high(0)) continue;
            const std::uint32_t child = node.child_at(place);
            build_box below;
            if (detail::child::is_leaf(child)) {
                Tree::leaves_type::with_kind(detail::child::kind(child), [&](auto kind) {
                    const auto& leaves = std::get<kind()>(tree.leaves.all);
                    const std::uint32_t block = detail::child::block(child), used = leaves.used(block);
                    REQUIRE(used != 0);
                    for (std::uint32_t left = used; left != 0; left &= left - 1) {
                        below.include(check_shape<kind()>(leaves, block, std::countr_zero(left)));
                    }
                });
            } else {
                REQUIRE((i < child && child < tree.nodes.size()));
                below = check(child);
            }
            sum += double(box.half_area());
            if (tight) REQUIRE(same_corners(below, box));
            all.include(box);
        }
        return all;
    }

    template <std::size_t Kind, class Leaves>
    build_box check_shape(const Leaves& leaves, std::uint32_t block, int lane) {
        std::size_t first = 0;
        [&]<std::size_t... I>(std::index_sequence<I...>) { ((first += std::get<I>(shapes).size()), ...); }
        (std::make_index_sequence<Kind>());
        const std::uint32_t id = leaves.id(block, static_cast<unsigned>(lane));
        REQUIRE((first <= id && id - first < std::get<Kind>(shapes).size()));
        ++seen[id];
        const aabb<T> given = std::get<Kind>(shapes)[id - first].bounds();
        const aabb<T> box = leaves.shape(block, static_cast<unsigned>(lane)).bounds();
        REQUIRE((box.min == given.min && box.max == given.max));
        return detail::to_build_box(aabb<T>{box.min * tree.scale, box.max * tree.scale}, id);
    }

    void operator()() {
        const build_box all = check(0);
        for (std::size_t id = 0; id < seen.size(); ++id) REQUIRE((seen[id] == 1 || (!tight && seen[id] > 1)));
        for (const int times : visited) REQUIRE(times == 1);
        const bool is_leaf = tree.nodes.size() == 1 && tree.nodes[0].leaf_count == 1;
        REQUIRE(tree.cost == doctest::Approx(1 + sum / double(all.half_area()) - (is_leaf ? 1 : 0)).epsilon(1e-3));
        REQUIRE(tree.size == all.reach());
        aabb<T> bounds;
        const auto add = [&](const auto& some) {
            for (const auto& s : some) bounds = hull(bounds, s.bounds());
        };
        std::apply([&](const auto&... some) { (add(some), ...); }, shapes);
        REQUIRE((tree.bounds.min == bounds.min && tree.bounds.max == bounds.max));
    }
};

template <class... Shapes>
void check_assembled(const detail::assembled<Shapes...>& tree, const std::tuple<std::vector<Shapes>...>& shapes,
                     bool tight) {
    assembled_check<detail::assembled<Shapes...>, Shapes...>{tree, shapes, tight}();
}

template <class T>
auto shapes_of_several_types(random_numbers& random, int count) {
    return std::tuple(random_shapes<sphere<T>>(random, count), random_shapes<triangle<T>>(random, 2 * count),
                      random_shapes<convex_polyhedron<T>>(random, count / 2));
}
template <class T>
using of_several_types = detail::assembled<sphere<T>, triangle<T>, convex_polyhedron<T>>;

}  // namespace

TEST_CASE_TEMPLATE("assembled: each shape once, in boxes that are just around it, and what they cost", T,
                   RAIO_NUMBERS) {
    random_numbers random(1);
    for (const int count : {1, 2, 5, 40, 3000}) {
        const auto shapes = shapes_of_several_types<T>(random, count);
        for (const bvh_quality quality : qualities) {
            of_several_types<T> tree;
            tree.build(shapes, {.quality = quality, .threads = 2});
            CHECK(tree.scale == T(1));
            CHECK(tree.bytes() >= tree.nodes.size() * sizeof(tree.nodes[0]) + 64 * unsigned(count));
            check_assembled(tree, shapes, quality != bvh_quality::high);
            tree.refit(shapes);
            check_assembled(tree, shapes, quality != bvh_quality::high);
        }
    }
}

TEST_CASE_TEMPLATE("assembled: what is far from 1 is scaled by a power of two to near 1, what is near it is not", T,
                   RAIO_NUMBERS) {
    random_numbers random(2);
    const auto scale_of = [&](T by) {
        std::tuple shapes{random_shapes<sphere<T>>(random, 100)};
        for (sphere<T>& s : std::get<0>(shapes)) s.center *= by, s.radius *= by;
        detail::assembled<sphere<T>> tree;
        tree.build(shapes, {});
        check_assembled(tree, shapes, true);
        if (tree.scale != T(1)) CHECK((tree.size >= 0.5f && tree.size <= 1.0f));
        int exponent = 0;
        CHECK(std::frexp(tree.scale, &exponent) == T(0.5));
        return tree.scale;
    };
    CHECK((scale_of(T(0x1p30)) == T(1) && scale_of(T(0x1p-20)) == T(1)));
    CHECK((scale_of(T(0x1p38)) < T(1) && scale_of(T(0x1p-25)) > T(1)));
    const T most = std::same_as<T, float> ? T(0x1p100) : T(0x1p1000);
    CHECK((scale_of(most) < T(1) && scale_of(1 / most) > T(1)));

    // As far as numbers go; a scale has an inverse.
    const T largest = std::numeric_limits<T>::max() / 4, least = std::numeric_limits<T>::denorm_min();
    for (const T reach : {largest, least}) {
        detail::assembled<box<T>> tree;
        tree.build(std::tuple(std::vector{box<T>{{0, 0, 0}, vec3<T>(reach)}}), {});
        CHECK((std::isnormal(tree.scale) && std::isnormal(1 / tree.scale)));
        CHECK((tree.size > 0 && tree.size <= 8));
    }
}

TEST_CASE_TEMPLATE("assembled: what is far away along one axis is scaled as well", T, RAIO_NUMBERS) {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        for (const T side : {T(-1), T(1)}) {
            std::tuple shapes{std::vector<sphere<T>>(3, {{0, 0, 0}, 1})};
            for (const int i : {0, 1, 2}) std::get<0>(shapes)[std::size_t(i)].center[axis] = side * T(i) * T(0x1p50);
            detail::assembled<sphere<T>> tree;
            tree.build(shapes, {});
            CHECK((tree.size >= 0.5f && tree.size <= 1.0f));
            check_assembled(tree, shapes, true);
        }
    }
}

TEST_CASE("assembled: shapes are cut to pieces where that pays") {
    random_numbers random(6);
    const auto cost_of = [&](bool some_large, bvh_quality quality) {
        random = random_numbers(7);
        std::vector<triangle<float>> triangles;
        for (int i = 0; i < 300; ++i) {
            const vec3<float> a = within<float>(random, 20),
                              ab = vec3<float>(random.direction()) * (some_large && i % 10 == 0 ? 20.0f : 0.1f);
            triangles.push_back({a, a + ab, a + ab + vec3<float>(random.direction()) * 0.1f});
        }
        detail::assembled<triangle<float>> tree;
        tree.build(std::tuple(std::move(triangles)), {.quality = quality});
        return tree.cost;
    };
    CHECK(cost_of(true, bvh_quality::high) < cost_of(true, bvh_quality::standard));
    CHECK(cost_of(false, bvh_quality::high) <= cost_of(false, bvh_quality::standard));
}

TEST_CASE_TEMPLATE("assembled: shapes without a point stand in no leaf, and keep their number", T, RAIO_NUMBERS) {
    random_numbers random(3);
    std::tuple shapes{random_shapes<sphere<T>>(random, 30), random_shapes<box<T>>(random, 30)};
    auto& [spheres, boxes] = shapes;
    glm::length_t axis = 0;
    for (const std::size_t i : {0u, 7u, 29u})
        spheres[i].radius = -1, boxes[i].max[axis] = boxes[i].min[axis] - 1, ++axis;
    detail::assembled<sphere<T>, box<T>> tree;
    tree.build(shapes, {});
    std::vector<int> seen(60);
    const auto look = [&](const auto& leaves) {
        for (std::uint32_t i = 0; i < leaves.size(); ++i) {
            for (std::uint32_t left = leaves.used(i); left != 0; left &= left - 1) {
                ++seen[leaves.id(i, static_cast<unsigned>(std::countr_zero(left)))];
            }
        }
    };
    std::apply([&](const auto&... leaves) { (look(leaves), ...); }, tree.leaves.all);
    for (std::size_t id = 0; id < 60; ++id) {
        const std::size_t i = id % 30;
        CHECK(seen[id] == (i == 0 || i == 7 || i == 29 ? 0 : 1));
    }
    spheres.clear(), boxes.clear();
    tree.build(shapes, {});
    CHECK((tree.nodes.empty() && tree.bytes() == 0 && !(tree.bounds.min.x <= tree.bounds.max.x)));
}

TEST_CASE_TEMPLATE("assembled: refit follows each shape, boxes as well, or makes a new tree, or changes nothing", T,
                   RAIO_NUMBERS) {
    random_numbers random(4);
    auto shapes = shapes_of_several_types<T>(random, 500);
    auto& spheres = std::get<0>(shapes);
    of_several_types<T> tree;
    tree.build(shapes, {});
    const std::size_t nodes = tree.nodes.size();
    for (sphere<T>& s : spheres) s.center += within<T>(random, 4);
    tree.refit(shapes);
    CHECK(tree.nodes.size() == nodes);
    check_assembled(tree, shapes, true);

    const double cost = tree.cost;
    const auto check_unchanged = [&](const char* why, const auto& refused) {
        CHECK_THROWS_WITH_AS(tree.refit(refused), why, std::invalid_argument);
        CHECK((tree.cost == cost && tree.nodes.size() == nodes));
        check_assembled(tree, shapes, true);
    };
    auto refused = shapes;
    std::get<0>(refused).pop_back();
    check_unchanged("raio::bvh: refit with another number of shapes", refused);
    refused = shapes;
    std::get<0>(refused).front().center.x = 99;  // comes before the one that is refused
    std::get<2>(refused).back().planes[0].offset = infinity<T>;
    check_unchanged("raio::bvh: shape 1749 has no finite bounds", refused);

    auto far_apart = shapes;
    for (sphere<T>& s : std::get<0>(far_apart)) s.center *= T(0x1p60), s.radius *= T(0x1p60);
    tree.refit(far_apart);
    CHECK(tree.scale < T(1));
    check_assembled(tree, far_apart, true);
    tree.refit(shapes);
    CHECK(tree.scale == T(1));
    check_assembled(tree, shapes, true);
}

}  // namespace raio::test
