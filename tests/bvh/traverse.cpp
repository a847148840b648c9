#include <raio/bvh/traverse.hpp>

#include "support/slabs.hpp"

namespace raio::test {

using detail::node_ray;
using detail::ray_bundle;

namespace {

/// Any tree over random boxes, each of which is a leaf.
struct random_tree {
    std::vector<build_box> boxes;
    std::vector<wide_node> nodes;

    random_tree(random_numbers& random, std::size_t count) : random_tree(random, some_boxes(random, count)) {}
    random_tree(random_numbers& random, std::vector<build_box> over) : boxes(std::move(over)), nodes(1) {
        fill(random, 0, 0, boxes.size());
    }

private:
    static std::vector<build_box> some_boxes(random_numbers& random, std::size_t count) {
        std::vector<build_box> some;
        for (std::size_t i = 0; i < count; ++i) some.push_back(random_box(random));
        return some;
    }

    void fill(random_numbers& random, std::size_t node, std::size_t first, std::size_t count) {
        std::vector<std::size_t> sizes(std::min<std::size_t>(count, node_width), 1);
        for (std::size_t i = sizes.size(); i < count; ++i) {
            ++sizes[static_cast<std::size_t>(random.integer(0, static_cast<int>(sizes.size()) - 1))];
        }
        std::ranges::sort(sizes);  // leaves first
        const auto leaf_count = static_cast<std::size_t>(std::ranges::count(sizes, 1u));
        const std::size_t first_node = nodes.size();
        nodes[node].leaf_count = static_cast<std::uint32_t>(leaf_count);
        nodes[node].first_node = static_cast<std::uint32_t>(first_node);
        nodes.resize(first_node + sizes.size() - leaf_count);
        for (std::size_t i = 0; i < sizes.size(); first += sizes[i++]) {
            build_box all;
            for (std::size_t j = first; j < first + sizes[i]; ++j) all.include(boxes[j]);
            nodes[node].set(i, all);
            if (i < leaf_count) {
                nodes[node].leaves[i] = detail::child::leaf(1, static_cast<std::uint32_t>(first));
            } else {
                fill(random, first_node + i - leaf_count, first, sizes[i]);
            }
        }
    }
};

/// The boxes that the ray meets, or those that it comes close to.
std::vector<bool> boxes_met(const std::vector<build_box>& boxes, const ray<float>& r, float t_min, float t_max,
                            double outwards = 0) {
    const double more = outwards / double(norm1(r.direction));
    std::vector<bool> met;
    for (const build_box& box : boxes) {
        met.push_back(!within_box(r, box, {double(t_min) - more, double(t_max) + more}, outwards).empty());
    }
    return met;
}

/// Which have been visited, none of them twice.
struct visits {
    std::vector<bool> of;
    int count = 0;

    std::size_t add(std::uint32_t leaf) {
        REQUIRE(detail::child::is_leaf(leaf));
        REQUIRE(detail::child::kind(leaf) == 1);
        const std::size_t i = detail::child::block(leaf);
        REQUIRE(i < of.size());
        REQUIRE(!of[i]);
        of[i] = true;
        ++count;
        return i;
    }
};

void check_between(const std::vector<bool>& least, const std::vector<bool>& found, const std::vector<bool>& most) {
    for (std::size_t i = 0; i < found.size(); ++i) REQUIRE((least[i] <= found[i] && found[i] <= most[i]));
}

}  // namespace

TEST_CASE("traverse: each leaf once that the ray meets, until it is enough") {
    random_numbers random(1);
    int seen = 0;
    for (const std::size_t count : {0u, 1u, 2u, 5u, 16u, 17u, 100u, 1000u}) {
        const random_tree tree(random, count);
        for (int i = 0; i < 300; ++i) {
            const ray<float> r = random_ray<float>(random);
            const float t_min = 0, t_max = random.one_in(2) ? infinity<float> : 20 / norm1(r.direction);
            const node_ray boxes(r, 1.0f, random_box_reach);
            const auto least = boxes_met(tree.boxes, r, t_min, t_max),
                       most = boxes_met(tree.boxes, r, t_min, t_max, 1e-3);
            visits found{std::vector<bool>(count)}, found_any = found;
            detail::traverse(tree.nodes, boxes, t_min, t_max,
                             [&](std::uint32_t leaf) { return found.add(leaf), true; });
            check_between(least, found.of, most);
            detail::traverse_any(tree.nodes, boxes, t_min, t_max,
                                 [&](std::uint32_t leaf) { return found_any.add(leaf), true; });
            REQUIRE(found.of == found_any.of);
            seen += found.count;

            const int enough = random.integer(1, 4);
            visits some{std::vector<bool>(count)}, some_of_any = some;
            detail::traverse(tree.nodes, boxes, t_min, t_max,
                             [&](std::uint32_t leaf) { return some.add(leaf), some.count < enough; });
            detail::traverse_any(tree.nodes, boxes, t_min, t_max,
                                 [&](std::uint32_t leaf) { return some_of_any.add(leaf), some_of_any.count < enough; });
            REQUIRE(some.count == std::min(enough, found.count));
            REQUIRE(some_of_any.count == std::min(enough, found.count));
        }
    }
    CHECK(seen > 5'000);
}

TEST_CASE("traverse: as deep a tree as any, in which all children wait but the nearest, a node") {
    std::vector<wide_node> nodes(detail::deepest);
    constexpr std::uint32_t width = node_width;
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        const bool is_last = i + 1 == nodes.size();
        nodes[i].leaf_count = width - (is_last ? 0 : 1);
        nodes[i].first_node = i + 1;
        for (std::uint32_t j = 0; j < width; ++j) {
            const float x = j < nodes[i].leaf_count ? 1 : 0;
            nodes[i].set(j, detail::to_build_box(aabb<float>{{x, -1, -1}, {8, 1, 1}}));
            nodes[i].leaves[j] = detail::child::leaf(1, i * width + j);
        }
    }
    const std::size_t leaf_count = detail::deepest * (node_width - 1) + 1;
    const ray<float> r{{-1, 0, 0}, {1, 0, 0}};
    const std::vector<ray<float>> rays(2, r);
    visits found{std::vector<bool>(nodes.size() * node_width)}, found_any = found, found_together = found;
    const node_ray boxes(r, 1.0f, random_box_reach);
    detail::traverse(nodes, boxes, 0, infinity<float>, [&](std::uint32_t leaf) { return found.add(leaf), true; });
    detail::traverse_any(nodes, boxes, 0, infinity<float>,
                         [&](std::uint32_t leaf) { return found_any.add(leaf), true; });
    std::array<float, ray_bundle::most> far;
    far.fill(infinity<float>);
    detail::traverse(nodes, ray_bundle(std::span(rays), 1.0f, random_box_reach), 0, far,
                     [&](std::uint32_t leaf, std::uint64_t, float) { found_together.add(leaf); });
    for (const visits* v : {&found, &found_any, &found_together}) CHECK(v->count == static_cast<int>(leaf_count));
}

TEST_CASE("traverse: a window of one point is a window") {
    std::vector<wide_node> nodes(1);
    nodes[0].leaf_count = 1;
    nodes[0].set(0, detail::to_build_box(aabb<float>{{1, -1, -1}, {8, 1, 1}}));
    nodes[0].leaves[0] = detail::child::leaf(0, 0);
    const std::vector<ray<float>> rays(2, ray<float>{{-1, 0, 0}, {1, 0, 0}});
    const node_ray boxes(rays[0], 1.0f, 8.0f);
    for (const float t : {1.0f, 4.0f, 12.0f}) {
        const int leaves = t == 4 ? 1 : 0;
        int found = 0, found_any = 0, found_together = 0;
        detail::traverse(nodes, boxes, t, t, [&](std::uint32_t) { return ++found, true; });
        detail::traverse_any(nodes, boxes, t, t, [&](std::uint32_t) { return ++found_any, true; });
        std::array<float, ray_bundle::most> far;
        far.fill(t);
        detail::traverse(nodes, ray_bundle(std::span(rays), 1.0f, 8.0f), t, far,
                         [&](std::uint32_t, std::uint64_t of, float) { found_together += std::popcount(of & 3); });
        CHECK((found == leaves && found_any == leaves && found_together == 2 * leaves));
    }
}

TEST_CASE("traverse: of a node's children the nearer first") {
    random_numbers random(4);
    for (int i = 0; i < 300; ++i) {
        std::vector<build_box> row;  // one behind the other, at any place of the node
        for (std::size_t j = 0; j < node_width; ++j) {
            const float x = 2 * static_cast<float>(j) - 8;
            row.push_back(detail::to_build_box(aabb<float>{{x, -8, -8}, {x + 1, 8, 8}}));
            std::swap(row[static_cast<std::size_t>(random.integer(0, static_cast<int>(j)))], row.back());
        }
        const random_tree tree(random, row);
        const bool is_forward = random.one_in(2);
        const ray<float> r{{is_forward ? -20.0f : 40.0f, 0, 0}, {is_forward ? 1.0f : -1.0f, 0.01f, 0.02f}};
        std::vector<float> order;
        const float t_max = infinity<float>;
        detail::traverse(tree.nodes, node_ray(r, 1.0f, 40.0f), 0, t_max, [&](std::uint32_t leaf) {
            order.push_back(tree.boxes[detail::child::block(leaf)].low(0) * r.direction.x);
            return true;
        });
        REQUIRE(order.size() == node_width);
        REQUIRE(std::ranges::is_sorted(order));

        const std::vector<ray<float>> rays(2, r);
        std::vector<float> order_together;
        std::array<float, ray_bundle::most> far;
        far.fill(t_max);
        detail::traverse(tree.nodes, ray_bundle(std::span(rays), 1.0f, 40.0f), 0, far,
                         [&](std::uint32_t leaf, std::uint64_t, float) {
                             order_together.push_back(tree.boxes[detail::child::block(leaf)].low(0) * r.direction.x);
                         });
        REQUIRE(order_together == order);
    }
}

TEST_CASE("traverse: what goes nowhere, or is no number, is not asked of a tree") {
    const vec3<float> some(1, 2, 3), none(0), endless(1, infinity<float>, 0), no_number(NAN, 0, 0);
    CHECK(detail::runs(ray<float>{none, some}));
    CHECK(detail::runs(ray<float>{some, {0, 0, -1e-45f}}));
    for (const vec3<float>& wrong : {endless, no_number}) {
        CHECK(!detail::runs(ray<float>{some, wrong}));
        CHECK(!detail::runs(ray<float>{wrong, some}));
    }
    CHECK(!detail::runs(ray<float>{some, none}));
}

TEST_CASE("traverse: what is beyond the nearest so far is left alone, and nothing before it") {
    random_numbers random(2);
    const random_tree tree(random, 1000);
    int visited = 0, met = 0;
    for (int i = 0; i < at_least(1000); ++i) {
        const ray<float> r = random_ray<float>(random);
        const float size = 1 / norm1(r.direction);
        float t_max = infinity<float>;
        visits found{std::vector<bool>(1000)};
        detail::traverse(tree.nodes, node_ray(r, 1.0f, random_box_reach), 0, t_max, [&](std::uint32_t leaf) {
            const build_box& box = tree.boxes[found.add(leaf)];
            REQUIRE(!within_box(r, box, {-1e-3 * size, double(t_max) + 1e-3 * size}, 1e-3).empty());
            // A hit somewhere in the box.
            const interval<double> inside = within_box(r, box, {0, double(t_max)});
            if (!inside.empty()) t_max = static_cast<float>(random.uniform(inside.min, inside.max));
            return true;
        });
        const std::vector<bool> before = boxes_met(tree.boxes, r, 0, t_max);
        for (std::size_t j = 0; j < before.size(); ++j) REQUIRE(before[j] <= found.of[j]);
        visited += found.count;
        met += static_cast<int>(std::ranges::count(boxes_met(tree.boxes, r, 0, infinity<float>), true));
    }
    CHECK(visited < met / 2);  // it goes the shortest way
}

TEST_CASE("traverse: leaves with all rays of a bundle that meet them, each as far as it goes") {
    random_numbers random(3);
    int bundles = 0;
    for (int i = 0; i < at_least(2000); ++i) {
        const random_tree tree(random, static_cast<std::size_t>(random.integer(0, 100)));
        const ray<float> first = random_ray<float>(random);
        std::vector<ray<float>> rays(static_cast<std::size_t>(random.integer(1, static_cast<int>(ray_bundle::most))),
                                     first);
        for (ray<float>& r : rays) {
            r.direction += vec3<float>(random.direction() * 0.1 * double(norm1(first.direction)));
        }
        const ray_bundle bundle(std::span<const ray<float>>(rays), 1.0f, random_box_reach);
        if (!bundle.is_coherent()) continue;
        ++bundles;
        const float size = 1 / norm1(first.direction), t_min = 0;
        std::array<float, ray_bundle::most> t_max;
        t_max.fill(-infinity<float>);
        for (std::size_t k = 0; k < rays.size(); ++k) {
            t_max[k] = random.one_in(2) ? infinity<float> : static_cast<float>(random.uniform(-5, 30)) * size;
        }
        const std::array<float, ray_bundle::most> asked = t_max;
        // One ray has enough once it has seen a leaf, the others never have.
        const auto content = static_cast<std::size_t>(random.integer(0, static_cast<int>(rays.size()) - 1));
        visits found{std::vector<bool>(tree.boxes.size())};
        std::vector<std::uint64_t> rays_at(tree.boxes.size(), 0);
        detail::traverse(tree.nodes, bundle, t_min, t_max, [&](std::uint32_t leaf, std::uint64_t of, float farthest) {
            REQUIRE((of & ~(~std::uint64_t{0} >> (64 - rays.size()))) == 0);
            REQUIRE(farthest == std::ranges::max(t_max));
            rays_at[found.add(leaf)] = of;
            if ((of >> content & 1) != 0) t_max[content] = -infinity<float>;
        });
        for (std::size_t k = 0; k < rays.size(); ++k) {
            std::vector<bool> at;
            for (const std::uint64_t of : rays_at) at.push_back((of >> k & 1) != 0);
            const auto least = boxes_met(tree.boxes, rays[k], t_min, asked[k]);
            if (k != content) {
                check_between(least, at, boxes_met(tree.boxes, rays[k], t_min, asked[k], 1e-3));
            } else {
                REQUIRE(std::ranges::count(at, true) <= 1);
                REQUIRE((std::ranges::count(at, true) == 1 || std::ranges::count(least, true) == 0));
            }
        }
    }
    CHECK(bundles > 300);
}

}  // namespace raio::test
