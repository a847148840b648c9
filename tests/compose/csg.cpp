#include <raio/compose/csg.hpp>

#include <raio/compose/any_primitive.hpp>
#include <raio/compose/group.hpp>
#include <raio/compose/quick.hpp>
#include <raio/compose/transformed.hpp>
#include <raio/shape/cylinder.hpp>

#include "support/properties.hpp"

namespace raio::test {

/// What a case expects: nothing, or the first crossing, the leaf and the x of the normal.
struct csg_expectation {
    bool hit;
    double t = 0;
    bool front_face = false;
    std::uint32_t leaf = 0;
    double normal_x = 0;
};

template <class Solid>
void check_case(const char* name, const Solid& solid, const ray<number_t<Solid>>& ray, const csg_expectation& expected,
                number_t<Solid> t_min = 0) {
    using T = number_t<Solid>;
    INFO(std::string(name));
    hit_record<T> rec = untouched_record<T>();
    const bool hit = solid.hit(ray, t_min, infinity<T>, rec);
    CHECK(hit == expected.hit);
    CHECK(solid.occluded(ray, t_min, infinity<T>) == hit);
    if (!hit) CHECK(same_record(rec, untouched_record<T>()));
    if (!hit || !expected.hit) return;
    CHECK(rec.t == T(expected.t));
    CHECK((rec.front_face == expected.front_face && rec.index == expected.leaf));
    CHECK(rec.normal.x == T(expected.normal_x));
    CHECK(unsound_fields(rec) == "");
}

TEST_CASE_TEMPLATE("csg: named cases", T, RAIO_NUMBERS) {
    const box<T> cube{{-2, -2, -2}, {2, 2, 2}};
    const sphere<T> ball{{0, 0, 0}, 1}, bite{{2, 0, 0}, 1};
    const ray<T> along{{-9, 0, 0}, {1, 0, 0}}, back{{9, 0, 0}, {-1, 0, 0}};

    const auto both = union_of(cube, bite);
    check_case("union: the outside of the left", both, along, {true, 7, true, 0, -1});
    check_case("union: the outside of the right", both, back, {true, 6, true, 1, 1});
    check_case("union: from inside both, the far side of all", both, {{1.5, 0, 0}, {1, 0, 0}},
               {true, 1.5, false, 1, -1});
    check_case("union: nothing of the surface that is inside the other", both, {{0, 0, 0}, {1, 0, 0}},
               {true, 3, false, 1, -1});
    check_case("union: beside both", both, {{-9, 5, 0}, {1, 0, 0}}, {false});

    const auto common = intersection_of(cube, bite);
    check_case("intersection: in through the right", common, along, {true, 10, true, 1, -1});
    check_case("intersection: in through the left", common, back, {true, 7, true, 0, 1});
    check_case("intersection: out through the left", common, {{1.5, 0, 0}, {1, 0, 0}}, {true, 0.5, false, 0, -1});
    check_case("intersection: through one alone", common, {{-9, 1.5, 0}, {1, 0, 0}}, {false});

    const auto bitten = difference_of(cube, bite);
    check_case("difference: where nothing was taken away", bitten, along, {true, 7, true, 0, -1});
    check_case("difference: the hole shows its inside as front", bitten, back, {true, 8, true, 1, 1});
    check_case("difference: out into the hole", bitten, {{0, 0, 0}, {1, 0, 0}}, {true, 1, false, 1, -1});
    check_case("difference: from within the hole", bitten, {{1.5, 0, 0}, {-1, 0, 0}}, {true, 0.5, true, 1, 1});
    check_case("difference: out of the hole", bitten, {{1.5, 0, 0}, {1, 0, 0}}, {false});

    const auto hollow = difference_of(cube, ball);
    check_case("difference: into the wall", hollow, along, {true, 7, true, 0, -1});
    check_case("difference: out into the hollow", hollow, along, {true, 8, false, 1, -1}, 7.5);
    check_case("difference: in again", hollow, along, {true, 10, true, 1, -1}, 8.5);
    check_case("difference: out for good", hollow, along, {true, 11, false, 0, -1}, 10.5);

    check_case("A - A is empty", difference_of(ball, ball), along, {false});
    check_case("A - A is empty, beside the centre", difference_of(ball, ball), {{-9, 0.3, 0.7}, {3, 0.1, -0.2}},
               {false});
    check_case("a point is all that touching solids have in common",
               intersection_of(sphere<T>{{-1, 0, 0}, 1}, sphere<T>{{1, 0, 0}, 1}), along, {true, 9, true, 1, -1});
    check_case("of touching solids neither takes from the other", difference_of(ball, bite), along,
               {true, 8, true, 0, -1});
    check_case("of touching solids the left is left", difference_of(bite, ball), along, {true, 10, true, 0, -1});
    check_case("faces in one plane: the left is recorded", union_of(cube, box<T>{{-2, -1, -1}, {0, 1, 1}}), along,
               {true, 7, true, 0, -1});
    const box<T> beam{{-2, -1, -1}, {2, 1, 1}};
    check_case("faces in one plane: out of the left", union_of(cube, beam), along, {true, 11, false, 0, -1}, 8);
    check_case("common to faces in one plane: the left", intersection_of(cube, beam), along, {true, 7, true, 0, -1});
    check_case("common to faces in one plane: out of the left", intersection_of(cube, beam), along,
               {true, 11, false, 0, -1}, 8);
    check_case("up to a face: out of the left", difference_of(cube, box<T>{{2, -1, -1}, {3, 1, 1}}), along,
               {true, 11, false, 0, -1}, 8);
    check_case("cut along a face: nothing thin is left", difference_of(box<T>{{0, -1, -1}, {2, 1, 1}}, cube), along,
               {false});
    check_case("tangent to the left", union_of(ball, bite), {{0, 1, 5}, {0, 0, -1}}, {true, 5, true, 0, 0});
    check_case("tangent to the left, from which something is taken elsewhere",
               difference_of(sphere<T>{{0, 0, 0}, 1}, sphere<T>{{5, 0, 0}, 1}), {{0, 1, 5}, {0, 0, -1}},
               {true, 5, true, 0, 0});
    check_case("tangent to the left, where it is taken away", difference_of(ball, bite), {{1, 0, 5}, {0, 0, -1}},
               {false});
    check_case("direction zero", bitten, {{0, 0, 0}, {0, 0, 0}}, {false});
    check_case("window that is not a number", bitten, along, {false}, std::numeric_limits<T>::quiet_NaN());
    check_case("a leaf that is not there", union_of(ball, sphere<T>{{0, 0, 0}, 0}), along, {true, 8, true, 0, -1});
    check_case("a leaf that is not a number", union_of(sphere<T>{{0, 0, 0}, std::numeric_limits<T>::quiet_NaN()}, ball),
               along, {true, 8, true, 1, -1});
}

TEST_CASE_TEMPLATE("csg: leaves are counted through the tree, a map or a group counts as one", T, RAIO_NUMBERS) {
    const auto ball = [](T x) { return sphere<T>{{x, 0, 0}, 1}; };
    const auto left = union_of(ball(0), ball(3));
    const auto right = difference_of(ball(6), ball(9));
    const auto tree = union_of(union_of(left, group{ball(12), ball(15)}),
                               union_of(transformed{left, translation<T>({18, 0, 0})}, right));
    CHECK(tree.leaves() == 6);
    const std::pair<T, std::uint32_t> expected[] = {{0, 0}, {3, 1}, {12, 2}, {15, 2}, {18, 3}, {21, 3}, {6, 4}};
    for (const auto& [x, leaf] : expected) {
        hit_record<T> rec{};
        REQUIRE(tree.hit({{x, 0, 9}, {0, 0, -1}}, T(0), infinity<T>, rec));
        CHECK((rec.t == T(8) && rec.index == leaf));
    }
    CHECK(!tree.occluded({{9.5, 0, 9}, {0, 0, -1}}, T(0), infinity<T>));
}

/// Solids of many kinds at random, each the left or right part of the next.
template <class T>
struct random_solids {
    random_numbers& random;

    vec3<T> near() { return vec3<T>(random.direction() * random.uniform(0, 1.5)); }
    T size() { return static_cast<T>(random.uniform(0.3, 1.5)); }
    sphere<T> ball() { return {near(), size()}; }
    cylinder<T> can() {
        const vec3<T> base = near();
        return {base, base + vec3<T>(random.direction() * 2.0), size()};
    }
    /// Its corners are whole numbers, so that faces coincide.
    box<T> crate() {
        const auto whole = [&](int low, int high) { return static_cast<T>(random.integer(low, high)); };
        return {{whole(-2, 0), whole(-2, 0), whole(-2, 0)}, {whole(0, 2), whole(0, 2), whole(0, 2)}};
    }
    auto tree() {
        const auto carved = difference_of(union_of(crate(), ball()), can());
        const auto lens = intersection_of(ball(), transformed{ball(), scaling<T>({1, size(), -size()})});
        return difference_of(union_of(carved, union_of(lens, crate())), intersection_of(crate(), group{ball(), can()}));
    }
    ray<T> line() {
        const vec3<double> from = random.direction() * random.uniform(0, 6), to = random.direction() * 1.5;
        ray<T> ray{vec3<T>(from), vec3<T>(to - from)};
        if (random.one_in(4)) {  // along the faces of the boxes
            for_each_number(ray.origin, [&](T& x) { x = std::round(x); });
            for_each_number(ray.direction, [&](T& x) { x = std::round(x); });
            if (ray.direction == vec3<T>(0)) ray.direction.x = 1;
        }
        return ray;
    }
};

/// The point-wise Boolean, of what the leaves say themselves.
template <class Solid, class T>
bool is_inside(const Solid& solid, const ray<T>& ray, T t) {
    return spans(solid.spans(ray)).contains(t);
}
template <set_operation Operation, class A, class B, class T>
bool is_inside(const csg<Operation, A, B>& tree, const ray<T>& ray, T t) {
    const bool in_a = is_inside(tree.a, ray, t), in_b = is_inside(tree.b, ray, t);
    return Operation == set_operation::unite       ? in_a || in_b
           : Operation == set_operation::intersect ? in_a && in_b
                                                   : in_a && !in_b;
}

/// Every t at which any leaf is entered or left.
template <class Solid, class T>
void collect_ends(const Solid& solid, const ray<T>& ray, std::vector<T>& ends) {
    for (const interval<T>& i : spans(solid.spans(ray))) ends.insert(ends.end(), {i.min, i.max});
}
template <set_operation Operation, class A, class B, class T>
void collect_ends(const csg<Operation, A, B>& tree, const ray<T>& ray, std::vector<T>& ends) {
    collect_ends(tree.a, ray, ends);
    collect_ends(tree.b, ray, ends);
}

TEST_CASE_TEMPLATE("csg: inside is the point-wise Boolean of the leaves", T, RAIO_NUMBERS) {
    random_numbers random(14);
    random_solids<T> some{random};
    int inside_count = 0;
    for (int i = 0; i < at_least_a_tenth_of(10'000); ++i) {
        const auto tree = some.tree();
        const ray<T> ray = some.line();
        const auto inside = tree.spans(ray);
        std::vector<T> ends;
        collect_ends(tree, ray, ends);
        std::sort(ends.begin(), ends.end());
        for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
            const T between = ends[k] + (ends[k + 1] - ends[k]) / 2;
            if (!(ends[k] < between && between < ends[k + 1])) continue;
            REQUIRE(inside.contains(between) == is_inside(tree, ray, between));
            inside_count += inside.contains(between);
        }
    }
    CHECK(inside_count > at_least_a_tenth_of(1'000));
}

TEST_CASE_TEMPLATE("csg: hits are the ends of the spans, one after the other, in and out", T, RAIO_NUMBERS) {
    random_numbers random(15);
    random_solids<T> some{random};
    int hits = 0;
    for (int i = 0; i < at_least_a_tenth_of(10'000); ++i) {
        const auto tree = some.tree();
        const ray<T> ray = some.line();
        T t_min = -infinity<T>;
        for (const interval<T>& span : tree.spans(ray)) {
            for (const bool entering : {true, false}) {
                const T end = entering ? span.min : span.max;
                if (!entering && span.min == span.max) continue;  // a single point is entered and left at once
                hit_record<T> rec{};
                REQUIRE(tree.hit(ray, t_min, infinity<T>, rec));
                REQUIRE(tree.occluded(ray, t_min, end));
                REQUIRE(!tree.occluded(ray, t_min, std::nextafter(end, -infinity<T>)));
                REQUIRE((rec.t == end && rec.front_face == entering && rec.index < tree.leaves()));
                REQUIRE(unsound_fields(rec) == "");
                REQUIRE(tree.bounds().contains(rec.point));
                REQUIRE(dot(rec.normal, ray.direction) <=
                        4 * std::numeric_limits<T>::epsilon() * length(ray.direction));
                t_min = std::nextafter(end, infinity<T>);
                ++hits;
            }
        }
        REQUIRE(!tree.occluded(ray, t_min, infinity<T>));
    }
    CHECK(hits > at_least_a_tenth_of(3'000));
}

TEST_CASE_TEMPLATE("csg: the record is that of the leaf, but for side and index", T, RAIO_NUMBERS) {
    random_numbers random(16);
    random_solids<T> some{random};
    int flipped = 0;
    for (int i = 0; i < at_least_a_tenth_of(10'000); ++i) {
        const auto a = some.ball();
        const auto b = some.can();
        const auto tree = difference_of(a, b);
        const ray<T> ray = some.line();
        hit_record<T> rec{}, own{};
        if (!tree.hit(ray, T(0), infinity<T>, rec)) continue;
        REQUIRE((rec.index == 0 ? a.hit(ray, rec.t, rec.t, own) : b.hit(ray, rec.t, rec.t, own)));
        flipped += own.front_face != rec.front_face;
        REQUIRE(((own.front_face != rec.front_face) == (rec.index == 1) || own.t == tree.spans(ray).intervals[0].max));
        own.index = rec.index, own.front_face = rec.front_face;
        REQUIRE(same_record(rec, own));
    }
    CHECK(flipped > at_least_a_tenth_of(500));
}

TEST_CASE_TEMPLATE("csg: from a point of the surface, in any direction", T, RAIO_NUMBERS) {
    check_starts_on_surface([](random_numbers& random) {
        const auto bitten = difference_of(sphere<T>{{0, 0, 0}, 3}, box<T>{{0, 0, 0}, {4, 4, 4}});
        const T y = T(random.integer(1, 15)) / 8, z = T(random.integer(1, 15)) / 8;
        return std::pair(bitten, random.one_in(2) ? vec3<T>(0, y, z) : vec3<T>(-1, 2, -2));
    });
}

TEST_CASE_TEMPLATE("csg: laws", T, RAIO_NUMBERS) {
    random_numbers random(17);
    random_solids<T> some{random};
    const auto same = [](const auto& a, const auto& b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); };
    for (int i = 0; i < at_least_a_tenth_of(2'000); ++i) {
        const auto a = some.tree();
        const auto b = union_of(some.ball(), some.crate());
        const ray<T> ray = some.line();
        REQUIRE(difference_of(a, a).spans(ray).empty());
        REQUIRE(same(union_of(a, a).spans(ray), a.spans(ray)));
        REQUIRE(same(intersection_of(a, a).spans(ray), a.spans(ray)));
        REQUIRE(same(union_of(a, b).spans(ray), union_of(b, a).spans(ray)));
        REQUIRE(same(intersection_of(a, b).spans(ray), intersection_of(b, a).spans(ray)));
        // Nothing but the points in which a and b touch.
        for (const interval<T>& left : intersection_of(difference_of(a, b), difference_of(b, a)).spans(ray)) {
            REQUIRE(left.min == left.max);
        }
    }
}

TEST_CASE_TEMPLATE("csg: solids are shared, mapped and grouped like any other", T, RAIO_NUMBERS) {
    const sphere<T> ball{{0, 0, 0}, 1};
    const auto shell = difference_of(&ball, sphere<T>{{0, 0, 0}, T(0.5)});
    CHECK(&*shell.a == &ball);
    const transformed mirrored{&shell, scaling<T>({-2, 2, 2})};
    const group scene{mirrored, ball};
    hit_record<T> rec{};
    REQUIRE(scene.hit({{-9, 0, 0}, {1, 0, 0}}, T(7.5), infinity<T>, rec));
    CHECK((rec.t == T(8) && rec.index == 1 && rec.front_face));  // the ball begins where the shell ends
    REQUIRE(mirrored.hit({{-9, 0, 0}, {1, 0, 0}}, T(7.5), infinity<T>, rec));
    CHECK((rec.t == T(8) && !rec.front_face));
    REQUIRE(scene.spans({{-9, 0, 0}, {1, 0, 0}}).count == 1);
    CHECK(mirrored.spans({{-9, 0, 0}, {1, 0, 0}}).count == 2);
    CHECK((shell.bounds().contains({T(0.9), 0, 0}) && !shell.bounds().contains({T(1.1), 0, 0})));
}

TEST_CASE_TEMPLATE("csg: a tree that is built while the program runs", T, RAIO_NUMBERS) {
    random_numbers random(18);
    random_solids<T> some{random};
    for (int i = 0; i < 500; ++i) {
        const auto a = some.tree();
        const auto b = some.can();
        const auto fixed = difference_of(a, b);
        const any_solid<T> built = difference_of(any_solid<T>(a), any_solid<T>(b));
        const ray<T> ray = some.line();
        hit_record<T> r{}, s{};
        const bool hit = fixed.hit(ray, T(0), infinity<T>, r);
        REQUIRE(built.hit(ray, T(0), infinity<T>, s) == hit);
        REQUIRE(built.occluded(ray, T(0), infinity<T>) == hit);
        if (hit) REQUIRE((r.t == s.t && r.normal == s.normal && r.point == s.point && r.front_face == s.front_face));
        REQUIRE(built.spans(ray).count == fixed.spans(ray).count);
    }
}

TEST_CASE_TEMPLATE("csg: of solids without an end, along which the line stays inside (it met nothing)", T,
                   RAIO_NUMBERS) {
    const T inf = infinity<T>, t = T(5) - std::sqrt(T(0.75));
    const sphere<T> ball{{0, 0, 0}, 1};
    const convex_polyhedron<T, std::array<half_space<T>, 1>> below{{half_space<T>{{0, 0, 1}, 0}}};
    const ray<T> along{{-5, 0, T(-0.5)}, {1, 0, 0}}, above{{-5, 0, T(0.5)}, {1, 0, 0}};
    const auto check_met = [&](const auto& met, const ray<T>& ray, bool front, std::uint32_t index) {
        hit_record<T> rec{};
        REQUIRE(met.hit(ray, -inf, inf, rec));
        CHECK(rec.t == doctest::Approx(t));
        CHECK((rec.front_face == front && rec.index == index && rec.point.z == ray.origin.z));
        CHECK(met.occluded(ray, T(0), inf));
        CHECK(spans(met.spans(ray)).begin()[0].contains(rec.t));
    };
    const auto check_missed = [&](const auto& missed, const ray<T>& ray) {
        hit_record<T> rec{};
        CHECK_FALSE(missed.hit(ray, -inf, inf, rec));
        CHECK_FALSE(missed.occluded(ray, -inf, inf));
    };
    const transform<T> still{};
    const auto check_all = [&](const auto& b, const auto& p) {
        check_met(intersection_of(b, p), along, true, 0);
        check_met(intersection_of(p, b), along, true, 1);
        check_missed(intersection_of(b, p), above);
        check_missed(difference_of(b, p), along);
        check_met(difference_of(b, p), above, true, 0);
        check_met(difference_of(p, b), along, false, 1);
        check_missed(difference_of(p, b), above);
        check_missed(union_of(p, b), along);
        check_met(union_of(p, b), above, true, 1);
        check_met(difference_of(ball, difference_of(p, b)), along, true, 0);
    };
    check_all(ball, below);
    check_all(transformed{ball, still}, transformed{below, still});
    check_all(any_solid<T>{ball}, any_solid<T>{below});
    check_all(ball, group{below});
    check_all(quick<sphere<T>>{ball}, quick<std::remove_const_t<decltype(below)>>{below});
    check_met(transformed{intersection_of(ball, below), still}, along, true, 0);
    // Turned by the map, and left by nothing: the tube of a square along the x axis.
    const convex_polyhedron<T> tube{{{{1, 0, 0}, -1}, {{-1, 0, 0}, -1}, {{0, 1, 0}, -1}, {{0, -1, 0}, -1}}};
    const transform<T> turn{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 0}};
    check_met(intersection_of(ball, transformed{tube, turn}), along, true, 0);
    const auto nowhere = spans(transformed{tube, turn}.spans(ray<T>{{0, 0, 3}, {1, 0, 0}}));
    CHECK(nowhere.empty());
    CHECK(spans(group{tube, below}.spans(ray<T>{{0, 0, 7}, {0, 0, 1}})).begin()[0] == interval<T>{-inf, inf});
}

}  // namespace raio::test
