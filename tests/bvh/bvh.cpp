#include <raio/compose/csg.hpp>
#include <raio/compose/transformed.hpp>
#include <raio/shape/torus.hpp>

#include "support/trees.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("bvh: as the loop over its shapes", T, RAIO_NUMBERS) {
    check_shape<triangle<T>>(300);
    check_shape<sphere<T>>(300);
    check_shape<box<T>>(300);
    check_shape<cylinder<T>>(300);
    check_shape<open_cylinder<T>>(300);  // was lost where a ray enters through its missing cap
    check_shape<disc<T>>(300);
}

TEST_CASE_TEMPLATE("bvh: shapes without a shape of packs", T, RAIO_NUMBERS) { check_shape<convex_polyhedron<T>>(100); }

TEST_CASE_TEMPLATE("bvh: shapes of several types", T, RAIO_NUMBERS) {
    random_numbers random(12);
    const group shapes{random_shapes<triangle<T>>(random, 100), random_shapes<sphere<T>>(random, 100),
                       random_shape<box<T>>::make(random), random_shapes<convex_polyhedron<T>>(random, 30),
                       random_shapes<sphere<T>>(random, 50)};
    for (const bvh_quality quality : qualities) check_like(bvh{shapes, {.quality = quality}}, shapes, random);
}

TEST_CASE_TEMPLATE("bvh: trees of trees", T, RAIO_NUMBERS) {
    random_numbers random(13);
    std::vector<bvh<triangle<T>>> trees;
    std::vector<group<std::vector<triangle<T>>>> loops;
    for (int i = 0; i < 20; ++i) {
        const std::vector<triangle<T>> shapes = random_shapes<triangle<T>>(random, i);  // the first has none
        trees.emplace_back(shapes);
        loops.emplace_back(shapes);
    }
    check_like(bvh{trees}, group{loops}, random);
}

TEST_CASE_TEMPLATE("bvh: instances of one tree, in a tree", T, RAIO_NUMBERS) {
    random_numbers random(17);
    const std::vector<triangle<T>> shapes = random_shapes<triangle<T>>(random, 100);
    const bvh<triangle<T>> tree(shapes);
    const group<std::vector<triangle<T>>> loop(shapes);
    std::vector<transformed<const bvh<triangle<T>>*>> trees;
    std::vector<transformed<const group<std::vector<triangle<T>>>*>> loops;
    for (int i = 0; i < 30; ++i) {
        const vec3<T> factors(static_cast<T>(random.uniform(0.1, 0.5)), static_cast<T>(random.uniform(-0.5, -0.1)), 1);
        const transform<T> map = translation(within<T>(random, 8)) *
                                 rotation(vec3<T>(random.direction()), static_cast<T>(random.uniform(0, 6))) *
                                 scaling(factors);
        trees.emplace_back(&tree, map);
        loops.emplace_back(&loop, map);
    }
    check_like(bvh{trees}, group{loops}, random, 2000);
}

/// At the middle of each sphere, or of 300 of many (30 in a short run), from near it: the tree answers what the loop
/// answers.
template <class T>
void check_aimed(const std::vector<sphere<T>>& shapes) {
    std::vector<bvh<sphere<T>>> trees;
    for (const bvh_quality quality : qualities)
        trees.emplace_back(std::span<const sphere<T>>(shapes), bvh_options{.quality = quality});
    const group loop{shapes};
    const std::size_t step = 1 + shapes.size() / std::size_t(std::min(300, at_least_a_tenth_of(300)));
    for (std::size_t i = 0; i < shapes.size(); i += step) {
        const sphere<T>& s = shapes[i];
        for (const vec3<T>& side : {vec3<T>(1, 2, 3), vec3<T>(-3, 0, 0), vec3<T>(0, 0, 0)}) {
            const ray<T> ray{s.center + side * s.radius, vec3<T>(-1, -2, -3) * s.radius};
            hit_record<T> expected{};
            const bool hit = loop.hit(ray, T(0), infinity<T>, expected);
            for (const bvh<sphere<T>>& tree : trees) {
                hit_record<T> found{};
                REQUIRE(tree.hit(ray, T(0), infinity<T>, found) == hit);
                REQUIRE(same(found, expected));
                REQUIRE(tree.occluded(ray, T(0), infinity<T>) == hit);
            }
        }
    }
}

TEST_CASE_TEMPLATE("bvh: few shapes, one, or none", T, RAIO_NUMBERS) {
    for (const int count : {100, 200, 300, 800, 900, 1700}) check_shape<sphere<T>>(count);
    random_numbers random(18);
    for (const int count : {1, 2, 3, 8, 9, 17}) {  // a tree of one triangle was a bug that others shipped
        const std::vector<sphere<T>> shapes = random_shapes<sphere<T>>(random, count);
        check_aimed(shapes);
    }
    const bvh<sphere<T>> none(std::span<const sphere<T>>{});
    hit_record<T> rec{};
    CHECK(!none.hit({{0, 0, 5}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK(!none.occluded({{0, 0, 5}, {0, 0, -1}}, T(0), infinity<T>));
    CHECK(!none.bounds().contains({0, 0, 0}));
}

TEST_CASE_TEMPLATE("bvh: from whatever range stands in one piece", T, RAIO_NUMBERS) {
    const sphere<T> a{{0, 0, 0}, 1}, b{{5, 0, 0}, 2};
    const std::vector<sphere<T>> shapes{a, b};
    const auto check = [&]<class Tree>(const Tree& tree) {
        static_assert(std::same_as<Tree, bvh<sphere<T>>>);
        hit_record<T> rec;
        CHECK(tree.bounds().max == bvh(shapes).bounds().max);
        REQUIRE(tree.hit({{5, 0, 9}, {0, 0, -1}}, T(0), infinity<T>, rec));
        CHECK((rec.t == 7 && rec.index == 1));
    };
    const sphere<T> array[]{a, b};
    sphere<T> unlocked[]{a, b};
    std::vector<sphere<T>> vector{a, b};
    const std::initializer_list<sphere<T>> list{a, b};
    check(bvh(shapes));
    check(bvh(vector));
    check(bvh(array));
    check(bvh(unlocked));
    check(bvh(std::array{a, b}));
    check(bvh(std::span(shapes)));
    check(bvh(std::span(unlocked)));
    check(bvh(std::span<const sphere<T>, 2>(array)));
    check(bvh(list));
    check(bvh({a, b}));
    check(bvh{{a, b}});
    check(bvh({a, b}, {.quality = bvh_quality::low}));
    check(bvh<sphere<T>>({a, b}));
    check(bvh<sphere<T>>({sphere<T>{{0, 0, 0}, 1}, {{5, 0, 0}, 2}}));
    check(bvh<sphere<T>>(vector, {.quality = bvh_quality::low}));
    // A single primitive in braces is not one of a list.
    static_assert(std::same_as<decltype(bvh{group{shapes, array[0]}}), bvh<sphere<T>, sphere<T>>>);
    static_assert(std::same_as<decltype(bvh{mesh<T>{}}), bvh<triangle<T>>>);
}

TEST_CASE_TEMPLATE("bvh: numbers far from 1", T, RAIO_NUMBERS) {
    random_numbers random(14);
    std::vector<sphere<T>> shapes = random_shapes<sphere<T>>(random, 200);
    const T most = std::same_as<T, float> ? T(0x1p100) : T(0x1p300);
    for (const T by : {most, 1 / most}) {
        std::vector<sphere<T>> scaled = shapes;
        for (sphere<T>& s : scaled) s.center *= by, s.radius *= by;
        const bvh tree{scaled};
        const group loop{scaled};
        for (int i = 0; i < at_least(2000); ++i) {
            question<T> q(random);
            q.ray.origin *= by;
            if (random.one_in(2)) q.ray.direction *= by;
            hit_record<T> expected{}, found{};
            const bool hit = loop.hit(q.ray, T(0), infinity<T>, expected);
            REQUIRE(tree.hit(q.ray, T(0), infinity<T>, found) == hit);
            REQUIRE(same(found, expected));
        }
    }
}

TEST_CASE_TEMPLATE("bvh: what has no finite bounds is refused by its index (one NaN box emptied a tree)", T,
                   RAIO_NUMBERS) {
    std::vector<sphere<T>> shapes(20, sphere<T>{{1, 2, 3}, 1});
    for (const T bad : {std::numeric_limits<T>::quiet_NaN(), infinity<T>}) {
        shapes[17].center.y = bad;
        CHECK_THROWS_WITH_AS(bvh{shapes}, "raio::bvh: shape 17 has no finite bounds", std::invalid_argument);
    }
    const T nan = std::numeric_limits<T>::quiet_NaN();
    shapes[17] = {{nan, 0, 0}, -1};  // of another axis the box is inside out: that is no shape without points
    CHECK_THROWS_WITH_AS(bvh{shapes}, "raio::bvh: shape 17 has no finite bounds", std::invalid_argument);
    shapes[17] = {{0, 0, 0}, -1};  // without any point: left out
    hit_record<T> rec{};
    CHECK(!bvh{shapes}.hit({{0, 0, 5}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK(bvh{shapes}.hit({{1, 2, 9}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK(rec.index == 0);

    for (const vec3<T>& high : {vec3<T>(-1, 1, 1), vec3<T>(1, -1, 1), vec3<T>(1, 1, -1)}) {  // inside out
        CHECK(!bvh{std::vector{box<T>{{0, 0, 0}, high}}}.bounds().contains({0, 0, 0}));
    }
    for (const vec3<T>& high : {vec3<T>(infinity<T>, 1, 1), vec3<T>(1, infinity<T>, 1), vec3<T>(1, 1, infinity<T>)}) {
        CHECK_THROWS_AS((bvh{std::vector{box<T>{{0, 0, 0}, high}}}), std::invalid_argument);
    }
}

TEST_CASE_TEMPLATE("bvh: a NaN is refused in whatever number of a shape it is (it was in the first vertex only)", T,
                   RAIO_NUMBERS) {
    const T nan = std::numeric_limits<T>::quiet_NaN();
    const std::vector<triangle<T>> sound(20, triangle<T>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    bvh tree{sound};
    for (int place = 0; place < 9; ++place) {
        auto shapes = sound;
        triangle<T>& bad = shapes[13];
        (place < 3 ? bad.a : place < 6 ? bad.b : bad.c)[place % 3] = nan;
        CHECK_THROWS_WITH_AS(bvh{shapes}, "raio::bvh: shape 13 has no finite bounds", std::invalid_argument);
        CHECK_THROWS_WITH_AS(tree.refit(shapes), "raio::bvh: shape 13 has no finite bounds", std::invalid_argument);
        CHECK(tree.occluded({{T(0.25), T(0.25), 1}, {0, 0, -1}}, T(0), infinity<T>));
    }
    mesh<T> m{{{0, 0, 0}, {1, 0, 0}, {0, nan, 0}, {1, 1, 0}}, {{0, 1, 3}, {0, 1, 2}}};
    for (int turn = 0; turn < 3; ++turn) {
        CHECK(is_nan(m.bounds()));
        CHECK_THROWS_WITH_AS(bvh{m}, "raio::bvh: shape 1 has no finite bounds", std::invalid_argument);
        CHECK_THROWS_WITH_AS(bvh<mesh_triangle<T>>{m}, "raio::bvh: shape 1 has no finite bounds",
                             std::invalid_argument);
        std::rotate(m.triangles[1].begin(), m.triangles[1].begin() + 1, m.triangles[1].end());
    }
    m.triangles.pop_back();  // no triangle has the vertex
    CHECK_NOTHROW(bvh{m});
    const sphere<T> ball{{0, 0, 0}, 1}, none{{0, 0, 0}, nan};
    const std::vector balls{ball, ball};
    CHECK_THROWS_AS((bvh{std::vector{group{ball, none}}}), std::invalid_argument);
    CHECK_THROWS_AS((bvh{std::vector{difference_of(ball, none)}}), std::invalid_argument);
    CHECK_THROWS_AS((bvh{std::vector{union_of(ball, none)}}), std::invalid_argument);
    CHECK_THROWS_AS((bvh{std::vector{intersection_of(ball, none)}}), std::invalid_argument);
    transform<T> map = translation(vec3<T>(1, 2, 3));
    map.y.z = nan;
    CHECK_THROWS_AS((bvh{std::vector{transformed{ball, map}}}), std::invalid_argument);
}

TEST_CASE_TEMPLATE(
    "bvh: shapes all in one place (equal centroids: a tree that never ended), one within the other, in a row", T,
    RAIO_NUMBERS) {
    random_numbers random(15);
    std::vector<sphere<T>> equal(100, sphere<T>{{0, 0, 0}, 4}), nested;
    std::vector<box<T>> flat;
    for (int i = 0; i < 100; ++i) {
        nested.push_back({{0, 0, 0}, static_cast<T>(std::ldexp(8, -i / 2))});
        flat.push_back({{T(i) / 8 - 6, -5, 0}, {T(i) / 8 - 5, 5, 0}});
    }
    for (const bvh_quality quality : qualities) {
        check_like(bvh(std::span<const sphere<T>>(equal), {.quality = quality}), group{equal}, random, 1000);
        check_like(bvh(std::span<const sphere<T>>(nested), {.quality = quality}), group{nested}, random, 1000);
        check_like(bvh(std::span<const box<T>>(flat), {.quality = quality}), group{flat}, random, 1000);
    }
}

TEST_CASE_TEMPLATE("bvh: shapes without a size, an area or a direction are missed, and have bounds", T, RAIO_NUMBERS) {
    const std::vector<sphere<T>> points(100, sphere<T>{{0, 0, 0}, 0});
    const vec3<T> zero(0);
    const std::vector<disc<T>> discs(100, disc<T>{zero, zero, 1});
    const std::vector<torus<T>> tori(100, torus<T>{zero, zero, 2, 1});
    const auto check_missed = [](auto tree, const auto& shapes) {
        CHECK(std::isfinite(tree.cost()));
        tree.refit(shapes);
        CHECK(std::isfinite(tree.cost()));
        CHECK(!tree.occluded({{0, 0, 5}, {0, 0, -1}}, T(0), infinity<T>));
    };
    for (const bvh_quality quality : qualities) {
        check_missed(bvh(std::span<const sphere<T>>(points), {.quality = quality}), points);
        check_missed(bvh(std::span<const disc<T>>(discs), {.quality = quality}), discs);
        check_missed(bvh(std::span<const torus<T>>(tori), {.quality = quality}), tori);
    }
}

TEST_CASE("bvh: more shapes than a tree has room for are refused before any is read") {
    const sphere<float> one{{0, 0, 0}, 1};
    const std::span<const sphere<float>> too_many(&one, (std::size_t{1} << 27) + 1);
    CHECK_THROWS_WITH_AS(bvh<sphere<float>>{too_many}, "raio::bvh: more than 2^27 shapes", std::length_error);
}

TEST_CASE_TEMPLATE("bvh: as deep a tree as shapes of ever smaller sizes make, and no stack overrun", T, RAIO_NUMBERS) {
    std::vector<sphere<T>> shapes;
    for (int i = 0; i < (std::same_as<T, float> ? 100 : 900); ++i) {
        const T size = std::ldexp(T(1), -i);
        shapes.push_back({vec3<T>(size, size, 0), size / 4});
    }
    check_aimed(shapes);
}

TEST_CASE_TEMPLATE("bvh: a crossing at infinity is none (packs took it for one before the end of the window)", T,
                   RAIO_NUMBERS) {
    constexpr bool is_float = std::same_as<T, float>;
    const T far = is_float ? T(0x1p70) : T(0x1p600), slow = is_float ? T(0x1p-60) : T(0x1p-500);
    const std::vector<sphere<T>> shapes{{{far, 0, 0}, far / 2}, {{-far, 0, 0}, 1}};
    const ray<T> along{{0, 0, 0}, {slow, 0, 0}};
    hit_record<T> rec{};
    CHECK(!group{shapes}.hit(along, T(0), infinity<T>, rec));
    CHECK(!bvh{shapes}.hit(along, T(0), infinity<T>, rec));
    CHECK(!bvh{shapes}.occluded(along, T(0), infinity<T>));
}

TEST_CASE_TEMPLATE("bvh: nor is one at minus infinity (packs took that for the one where the window begins)", T,
                   RAIO_NUMBERS) {
    const std::vector<box<T>> shapes{{{-1, -1, -1}, {1, 1, 1}}, {{-2, -2, -2}, {2, 2, 2}}};
    const ray<T> hardly_moving{{0, 0, 0}, vec3<T>(std::numeric_limits<T>::denorm_min())};
    hit_record<T> rec{};
    CHECK(!bvh{shapes}.hit(hardly_moving, -infinity<T>, T(1), rec));
    CHECK(!bvh{shapes}.occluded(hardly_moving, -infinity<T>, T(1)));
}

TEST_CASE("bvh: a sphere whose radius has no square is met as one of its own (the tree met it, the loop did not)") {
    const std::vector<sphere<double>> shapes{{{0, -0x1p531, 0}, 0x1.4p567}, {{0x1p567, 0, 0x1p567}, 1}};
    const ray<double> along{{0x1p-349, 0x1p-349, 0}, {0x1p-351, 0, 0}};
    hit_record<double> expected{}, found{};
    REQUIRE(group{shapes}.hit(along, 0.0, infinity<double>, expected));
    REQUIRE(bvh{shapes}.hit(along, 0.0, infinity<double>, found));
    CHECK((same(found, expected) && found.t == doctest::Approx(0x1.4p918)));
}

TEST_CASE_TEMPLATE("bvh: a hundred thousand shapes, and ten million in a long run", T, RAIO_NUMBERS) {
    random_numbers random(19);
    std::vector<triangle<T>> shapes;
    const double size = 63 / std::sqrt(double(test_rays));  // as many hits, however many there are
    for (int i = 0; i < test_rays; ++i) {
        const vec3<T> a = within<T>(random, 8);
        shapes.push_back({a, a + within<T>(random, size), a + within<T>(random, size)});
    }
    for (const bvh_quality quality : qualities)
        check_like(bvh{shapes, {.quality = quality}}, group{shapes}, random, 40);
}

TEST_CASE("bvh: the same tree from any number of threads") {
    random_numbers random(16);
    const auto shapes = random_shapes<triangle<float>>(random, 50'000);
    for (const bvh_quality quality : qualities) {
        const bvh one(std::span<const triangle<float>>(shapes), {.quality = quality, .threads = 1});
        for (const unsigned threads : {2u, 3u, 7u}) {
            const bvh several(std::span<const triangle<float>>(shapes), {.quality = quality, .threads = threads});
            CHECK(several.cost() == one.cost());
            CHECK(several.bytes() == one.bytes());
        }
    }
}

}  // namespace raio::test
