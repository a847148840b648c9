#include <raio/compose/csg.hpp>
#include <raio/compose/transformed.hpp>

#include <cfenv>

#include "support/meshes.hpp"
#include "support/trees.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("bvh: of equally near ones that which shows its front, however it is asked", T, RAIO_NUMBERS) {
    // Sheets that show their fronts to both sides, in any order.
    random_numbers random(31);
    std::vector<triangle<T>> sheets;
    for (int i = 0; i < 40; ++i) {
        const triangle<T> up{{0, 0, T(i)}, {1, 0, T(i)}, {0, 1, T(i)}}, down{up.a, up.c, up.b};
        for (const auto& one : random.one_in(2) ? std::array{up, down} : std::array{down, up}) sheets.push_back(one);
    }
    std::vector<quick<triangle<T>>> quick_sheets;
    for (const triangle<T>& one : sheets) quick_sheets.push_back({one});
    const bvh tree(sheets);
    const bvh quick_tree(quick_sheets);
    struct without_side {
        T t;
        std::uint32_t index;
    };
    for (int i = 0; i < 40; ++i) {
        for (const T side : {T(1), T(-1)}) {
            const ray<T> ray{{T(0.25), T(0.25), T(i) + side / 2}, {0, 0, -side}};
            const auto first = static_cast<std::uint32_t>(2 * i);
            const bool up_first =
                cross(vec3<T>(sheets[first].b - sheets[first].a), vec3<T>(sheets[first].c - sheets[first].a)).z > 0;
            const std::uint32_t index = first + (up_first == (side > 0) ? 0 : 1);
            const auto check = [&](const auto& rec) { CHECK((rec.t == T(0.5) && rec.index == index)); };
            const auto check_all = [&](const auto& of) {
                hit_record<T> rec{};
                REQUIRE(of.hit(ray, T(0), infinity<T>, rec));
                check(rec);
                CHECK(rec.front_face);
                without_side other{};
                REQUIRE(of.hit(ray, T(0), infinity<T>, other));
                check(other);
                REQUIRE(transformed{&of, translation<T>({0, 0, 0})}.hit(ray, T(0), infinity<T>, other));
                check(other);
                std::array<hit_record<T>, 2> two{};
                REQUIRE(of.nearest_hits(ray, T(0), infinity<T>, two) == 2);
                check(two[0]);
                CHECK((two[1].index == (index ^ 1) && two[1].t == T(0.5) && !two[1].front_face));
                std::vector<raio::ray<T>> rays(64, ray);  // side by side
                for (std::size_t k = 0; k < 64; ++k) rays[k].origin.x += T(k) / 256;
                std::vector<hit_record<T>> recs(64);
                REQUIRE(of.hit(std::span<const raio::ray<T>>(rays), T(0), infinity<T>, recs) == ~std::uint64_t{0});
                for (const hit_record<T>& each : recs) check(each);
            };
            check_all(tree);
            check_all(quick_tree);
        }
    }
}

TEST_CASE_TEMPLATE("bvh: refit follows the shapes", T, RAIO_NUMBERS) {
    random_numbers random(17);
    auto shapes = random_shapes<sphere<T>>(random, 300);
    for (const bvh_quality quality : qualities) {
        bvh tree(std::span<const sphere<T>>(shapes), {.quality = quality});
        const double cost = tree.cost();
        tree.refit(shapes);
        CHECK(tree.cost() == doctest::Approx(cost));
        for (sphere<T>& s : shapes) s.center += within<T>(random, 2);
        tree.refit(shapes);
        check_like(tree, group{shapes}, random, 1000);
        CHECK(tree.cost() > cost);
        shapes[3].radius = -1;  // has no point any more
        tree.refit(shapes);
        check_like(tree, group{shapes}, random, 1000);
        shapes[3].radius = 1;
        tree.refit(shapes);
        check_like(tree, group{shapes}, random, 1000);
        shapes[5].radius = infinity<T>;
        CHECK_THROWS_AS(tree.refit(shapes), std::invalid_argument);
        shapes[5].radius = 1;
        CHECK_THROWS_AS(tree.refit(std::span(shapes).first(299)), std::invalid_argument);
    }
}

TEST_CASE_TEMPLATE("bvh: refit to another scale, and of a tree without shapes", T, RAIO_NUMBERS) {
    random_numbers random(24);
    auto shapes = random_shapes<sphere<T>>(random, 100);
    bvh tree{shapes};
    const T by = T(0x1p60);
    for (sphere<T>& s : shapes) s.center *= by, s.radius *= by;
    tree.refit(shapes);
    int hits = 0;
    for (int i = 0; i < at_least(1000); ++i) {
        question<T> q(random);
        q.ray.origin *= by;
        hit_record<T> expected{}, found{};
        const bool hit = group{shapes}.hit(q.ray, T(0), infinity<T>, expected);
        REQUIRE(tree.hit(q.ray, T(0), infinity<T>, found) == hit);
        REQUIRE(same(found, expected));
        hits += hit ? 1 : 0;
    }
    CHECK(hits > 50);

    bvh<sphere<T>> none;
    none.refit(std::span<const sphere<T>>{});
    CHECK(!none.occluded({{0, 0, 5}, {0, 0, -1}}, T(0), infinity<T>));
}

TEST_CASE("bvh: small triangles make no subnormal numbers, which cost a trap each") {
    random_numbers random(31);
    for (const double size : {1.0, 0.05, 0.001}) {
        const bvh tree{moved(icosphere<triangle<float>>(), size, {0, 0, 0})};
        int hits = 0;
        for (int i = 0; i < 1000; ++i) {
            ray<float> ray{within<float>(random, 4 * size), {0, 0, 0}};
            ray.direction = within<float>(random, size) - ray.origin;
            hit_record<float> rec{};
            std::feclearexcept(FE_UNDERFLOW);
            hits += tree.hit(ray, 0, infinity<float>, rec) ? 1 : 0;
            REQUIRE_MESSAGE(std::fetestexcept(FE_UNDERFLOW) == 0, size, ", ", i);
        }
        CHECK(hits > 300);
    }
}

TEST_CASE_TEMPLATE("bvh: rays that run nowhere miss, and those beside them do not", T, RAIO_NUMBERS) {
    const std::vector<sphere<T>> shapes(3, sphere<T>{{0, 0, 0}, 1});
    const bvh tree{shapes};
    const ray<T> good{{0, 0, 5}, {0, 0, -1}};
    std::array<hit_record<T>, 3> recs;
    CHECK(tree.hit(good, T(0), infinity<T>, recs[0]));
    const T nan = std::numeric_limits<T>::quiet_NaN();
    for (const ray<T>& bad :
         {ray<T>{{0, 0, 5}, {0, 0, 0}}, ray<T>{{0, 0, 5}, {0, 0, nan}}, ray<T>{{0, 0, 5}, {0, 0, -infinity<T>}},
          ray<T>{{0, 0, nan}, {0, 0, -1}}, ray<T>{{0, 0, infinity<T>}, {0, 0, -1}}}) {
        CHECK(!tree.hit(bad, T(0), infinity<T>, recs[0]));
        CHECK(!tree.occluded(bad, T(0), infinity<T>));
        CHECK(tree.all_hits(bad, T(0), infinity<T>).empty());
        const std::array rays{good, bad, good};
        CHECK(tree.hit(std::span<const ray<T>>(rays), T(0), infinity<T>, recs) == 5);
        CHECK(tree.occluded(std::span<const ray<T>>(rays), T(0), infinity<T>) == 5);
    }
    const std::array rays{good, good, good};
    const auto check_window = [&](T t_min, T t_max) {
        CHECK(!tree.hit(good, t_min, t_max, recs[0]));
        CHECK(!tree.occluded(good, t_min, t_max));
        CHECK(tree.hit(std::span<const ray<T>>(rays), t_min, t_max, recs) == 0);
        CHECK(tree.occluded(std::span<const ray<T>>(rays), t_min, t_max) == 0);
    };
    check_window(5, 3), check_window(nan, infinity<T>), check_window(0, nan);
    CHECK(bvh<sphere<T>>().hit(std::span<const ray<T>>(rays), T(0), infinity<T>, recs) == 0);
    CHECK(tree.nearest_hits(good, T(0), infinity<T>, {}) == 0);
}

TEST_CASE_TEMPLATE("bvh: many rays at once, as each of them alone", T, RAIO_NUMBERS) {
    random_numbers random(23);
    const bvh tree{group{random_shapes<triangle<T>>(random, 300), random_shapes<sphere<T>>(random, 50),
                         random_shapes<convex_polyhedron<T>>(random, 20)}};
    int hits = 0;
    const int bundles = std::max(50, test_rays / 100);
    for (int i = 0; i < bundles; ++i) {
        // From one point, or side by side, or neither; and some that run nowhere.
        const question<T> first(random);
        std::vector<ray<T>> rays(static_cast<std::size_t>(random.integer(1, 64)), first.ray);
        const T spread = static_cast<T>(random.log_uniform(1e-4, 1));
        for (ray<T>& r : rays) {
            if (random.one_in(2)) r.direction += within<T>(random, spread * norm1(first.ray.direction));
            if (random.one_in(2)) r.origin += within<T>(random, spread);
        }
        if (random.one_in(20)) rays.back().direction = vec3<T>(0);
        if (random.one_in(20)) rays.back().origin.x = std::numeric_limits<T>::quiet_NaN();
        if (random.one_in(20)) rays.back() = question<T>(random).ray;
        std::vector<hit_record<T>> found(rays.size());
        const std::uint64_t hit = tree.hit(std::span<const ray<T>>(rays), first.t_min, first.t_max, found);
        const std::uint64_t occluded = tree.occluded(std::span<const ray<T>>(rays), first.t_min, first.t_max);
        for (std::size_t j = 0; j < rays.size(); ++j) {
            hit_record<T> expected{};
            REQUIRE(tree.hit(rays[j], first.t_min, first.t_max, expected) == ((hit >> j & 1) != 0));
            REQUIRE(same(found[j], expected));
            REQUIRE(tree.occluded(rays[j], first.t_min, first.t_max) == ((occluded >> j & 1) != 0));
        }
        REQUIRE((rays.size() == 64 || (hit | occluded) >> rays.size() == 0));
        hits += std::popcount(hit);
    }
    CHECK(hits > bundles);
    CHECK(tree.hit(std::span<const ray<T>>(), T(0), infinity<T>, {}) == 0);
}

TEST_CASE_TEMPLATE("bvh: a mesh is the loop over its triangles, and closed", T, RAIO_NUMBERS) {
    random_numbers random(18);
    mesh<T> ball;
    for (const triangle<T>& t : icosphere<triangle<T>>()) {
        std::array<std::uint32_t, 3> indices{};
        for (unsigned k = 0; k < 3; ++k) {
            const vec3<T> corner = k == 0 ? t.a : k == 1 ? t.b : t.c;
            const auto at = std::ranges::find(ball.vertices, corner);
            indices[k] = static_cast<std::uint32_t>(at - ball.vertices.begin());
            if (at == ball.vertices.end()) ball.vertices.push_back(corner);
        }
        ball.triangles.push_back(indices);
    }
    CHECK(ball.vertices.size() == 162);
    for (const bvh_quality quality : qualities) {
        const bvh tree(ball, {.quality = quality});
        const bvh<mesh_triangle<T>> compact(ball, {.quality = quality});
        CHECK(compact.bytes() < tree.bytes() * 3 / 4);
        for (int i = 0; i < test_rays / 10; ++i) {
            // From within, through a vertex, or the middle of an edge or a face: it is never outside.
            const std::array<std::uint32_t, 3>& t = ball.triangles[static_cast<std::size_t>(random.integer(0, 319))];
            const int corners = random.integer(1, 3);
            vec3<T> target = ball.vertices[t[0]];
            for (std::size_t k = 1; k < std::size_t(corners); ++k) target += ball.vertices[t[k]];
            target /= T(corners);
            const vec3<T> from = within<T>(random, 0.5);
            hit_record<T> expected{}, found{};
            REQUIRE(tree.hit({from, target - from}, T(0), infinity<T>, found));
            REQUIRE(ball.hit({from, target - from}, T(0), infinity<T>, expected));
            REQUIRE(same(found, expected));
            REQUIRE(!found.front_face);
            REQUIRE(compact.hit({from, target - from}, T(0), infinity<T>, found));
            REQUIRE(same(found, expected));
            REQUIRE(compact.occluded({from, target - from}, T(0), infinity<T>));
        }
    }
    bvh<mesh_triangle<T>> moving(ball);
    for (vec3<T>& v : ball.vertices) v *= T(2);
    moving.refit(ball);
    hit_record<T> rec{};
    REQUIRE(moving.hit({{0, 0, 0}, ball.vertices[0]}, T(0), infinity<T>, rec));
    CHECK(rec.t == doctest::Approx(1));
    ball.triangles[7][1] = 162;
    CHECK_THROWS_WITH_AS(bvh{ball}, "raio::mesh: triangle 7 has vertex 162 of 162", std::invalid_argument);
}

TEST_CASE_TEMPLATE("bvh: crossings in order, the nearest few, and a filter", T, RAIO_NUMBERS) {
    random_numbers random(19);
    const auto shapes = random_shapes<sphere<T>>(random, 200);
    for (const bvh_quality quality : qualities) {
        const bvh tree(std::span<const sphere<T>>(shapes), {.quality = quality});
        for (int i = 0; i < at_least(1000); ++i) {
            const question<T> q(random);
            std::vector<hit_record<T>> expected;
            for (std::uint32_t j = 0; j < shapes.size(); ++j) {
                hit_record<T> rec{};
                for (T from = q.t_min; shapes[j].hit(q.ray, from, q.t_max, rec);
                     from = std::nextafter(rec.t, infinity<T>)) {
                    rec.index = j;
                    expected.push_back(rec);
                }
            }
            std::ranges::stable_sort(expected, {}, &hit_record<T>::t);
            REQUIRE(std::ranges::equal(tree.all_hits(q.ray, q.t_min, q.t_max), expected, same<T>));
            std::array<hit_record<T>, 3> few;
            REQUIRE(tree.nearest_hits(q.ray, q.t_min, q.t_max, few) == std::min<std::size_t>(3, expected.size()));
            for (std::size_t j = 0; j < std::min<std::size_t>(3, expected.size()); ++j)
                REQUIRE(same(few[j], expected[j]));

            const auto even = [](const hit_record<T>& rec) { return rec.index % 2 == 0 && !rec.front_face; };
            const auto first = std::ranges::find_if(expected, even);
            hit_record<T> rec{};
            REQUIRE(tree.hit(q.ray, q.t_min, q.t_max, rec, even) == (first != expected.end()));
            REQUIRE(tree.occluded(q.ray, q.t_min, q.t_max, even) == (first != expected.end()));
            REQUIRE(same(rec, first != expected.end() ? *first : hit_record<T>{}));
        }
    }
}

TEST_CASE_TEMPLATE("bvh: spans are those of the group, and csg takes the tree for one solid", T, RAIO_NUMBERS) {
    random_numbers random(29);
    const auto spheres = random_shapes<sphere<T>>(random, 200);
    const auto boxes = random_shapes<box<T>>(random, 100);
    const group shapes{spheres, boxes};
    const box<T> block{vec3<T>(-6), vec3<T>(5)};
    const auto holes = difference_of(block, shapes);
    static_assert(solid<bvh<sphere<T>, box<T>>> && !solid<bvh<triangle<T>>> && !solid<bvh<sphere<T>, disc<T>>>);
    for (const bvh_quality quality : qualities) {
        const bvh tree(shapes, {.quality = quality});
        const auto holes_of_tree = difference_of(block, &tree);
        int found = 0, hits = 0;
        for (int i = 0; i < at_least(2000); ++i) {
            const question<T> q(random);
            const auto inside = tree.spans(q.ray), expected = shapes.spans(q.ray);
            REQUIRE(std::ranges::equal(inside, expected));
            found += int(inside.count);

            hit_record<T> rec{}, of_group{};
            REQUIRE(holes_of_tree.hit(q.ray, q.t_min, q.t_max, rec) == holes.hit(q.ray, q.t_min, q.t_max, of_group));
            REQUIRE(same(rec, of_group));
            hits += rec.t > 0;
        }
        CHECK(found > 500);
        CHECK(hits > 100);
        CHECK(tree.spans({{0, 0, 0}, {0, 0, 0}}).empty());
    }
    CHECK(bvh<sphere<T>>().spans({{0, 0, 5}, {0, 0, -1}}).empty());
}

TEST_CASE_TEMPLATE("bvh: spans along rays that were mapped", T, RAIO_NUMBERS) {
    random_numbers random(30);
    const auto spheres = random_shapes<sphere<T>>(random, 200);
    const group shapes{spheres};
    const bvh tree{spheres};
    const transform<T> turned{{1, 2, 0}, {-2, 1, 0}, {0, 0, 3}, {1, 2, 3}};
    const transformed in_tree(&tree, turned);
    const transformed in_group(&shapes, turned);
    int found = 0;
    for (int i = 0; i < 500; ++i) {
        const question<T> q(random);
        REQUIRE(std::ranges::equal(in_tree.spans(q.ray), in_group.spans(q.ray)));
        found += int(in_tree.spans(q.ray).count);
    }
    CHECK(found > 100);
}

}  // namespace raio::test
