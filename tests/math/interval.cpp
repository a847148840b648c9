#include <raio/math/any_number_of_spans.hpp>
#include <raio/math/interval.hpp>

#include <doctest/doctest.h>

#include "support/random.hpp"

namespace raio::test {

static_assert(interval<float>{}.empty());
static_assert(interval<double>{}.length() == 0);
static_assert(!interval<double>{1, 1}.empty());
static_assert(interval<double>{1, 3}.length() == 2);
static_assert(interval<double>{3, 1}.empty() && interval<double>{3, 1}.length() == 0);
static_assert(interval<double>{1, 3}.contains(1) && interval<double>{1, 3}.contains(3));
static_assert(!interval<double>{1, 3}.contains(0.5) && !interval<double>{1, 3}.contains(3.5));
static_assert(interval<double>{1, 3} == interval<double>{1, 3} && interval<double>{1, 3} != interval<double>{1, 4});

TEST_CASE_TEMPLATE("interval: a NaN is in none, and none has a NaN for an end", T, RAIO_NUMBERS) {
    const T nan = std::numeric_limits<T>::quiet_NaN();
    CHECK(!interval<T>{0, 1}.contains(nan));
    CHECK(interval<T>{nan, 1}.empty());
    CHECK(interval<T>{0, nan}.empty());
    CHECK(interval<T>{0, nan}.length() == T(0));
    CHECK(interval<T>{-infinity<T>, infinity<T>}.contains(T(7)));
    CHECK((interval<T>{0, nan} != interval<T>{0, nan} && interval<T>{nan, 1} != interval<T>{nan, 1}));
}

template <std::size_t N>
spans<double, N> listed(std::initializer_list<interval<double>> intervals) {
    spans<double, N> list;
    for (const interval<double>& i : intervals) list.append(i);
    return list;
}

template <std::size_t N>
bool same(const spans<double, N>& list, std::initializer_list<interval<double>> expected) {
    return std::equal(list.begin(), list.end(), expected.begin(), expected.end());
}

TEST_CASE("spans: of one interval, or of none") {
    CHECK(same(spans<double, 1>(interval<double>{1, 2}), {{1, 2}}));
    CHECK(spans<double, 1>(interval<double>{2, 1}).empty());
    CHECK(spans<double, 0>().empty());
    CHECK(spans(interval<float>{1, 2}).count == 1);
    CHECK(spans<float, 3>(interval<float>{1, 2}).count == 1);
}

TEST_CASE("spans: what meets becomes one, what is empty is not added") {
    CHECK(same(listed<3>({{1, 2}, {3, 4}}), {{1, 2}, {3, 4}}));
    CHECK(same(listed<3>({{1, 2}, {2, 4}}), {{1, 4}}));
    CHECK(same(listed<3>({{1, 5}, {2, 4}}), {{1, 5}}));
    CHECK(same(listed<3>({{1, 2}, {4, 3}, {5, 5}}), {{1, 2}, {5, 5}}));
}

TEST_CASE("spans: what is made of each of them") {
    const auto in_floats = [](const interval<double>& i) { return interval<float>{float(i.min), float(i.max)}; };
    const spans<float, 4> made = listed<4>({{0, 1}, {2, 3}}).each(in_floats);
    REQUIRE(made.count == 2);
    CHECK((made.intervals[0] == interval<float>{0, 1} && made.intervals[1] == interval<float>{2, 3}));
    CHECK(spans<double, 4>().each(in_floats).empty());
}

TEST_CASE_TEMPLATE("spans: inserted anywhere, what meets becomes one", Spans, spans<double, 4>,
                   spans<double, any_number>) {
    Spans list;
    const auto insert = [&](double min, double max, std::initializer_list<interval<double>> expected) {
        list.insert({min, max});
        CHECK(std::equal(list.begin(), list.end(), expected.begin(), expected.end()));
    };
    insert(5, 6, {{5, 6}});
    insert(1, 2, {{1, 2}, {5, 6}});
    insert(9, 8, {{1, 2}, {5, 6}});
    insert(3, 4, {{1, 2}, {3, 4}, {5, 6}});
    insert(8, 9, {{1, 2}, {3, 4}, {5, 6}, {8, 9}});
    insert(2, 2.5, {{1, 2.5}, {3, 4}, {5, 6}, {8, 9}});
    insert(3.5, 5.5, {{1, 2.5}, {3, 6}, {8, 9}});
    insert(0, 7, {{0, 7}, {8, 9}});
    insert(-2, -1, {{-2, -1}, {0, 7}, {8, 9}});
    insert(-0.5, 0, {{-2, -1}, {-0.5, 7}, {8, 9}});
    insert(-3, 10, {{-3, 10}});
}

TEST_CASE("spans: of any number") {
    spans<double, any_number> many;
    for (int i = 0; i < 1000; ++i) many.append({2.0 * i, 2.0 * i + 1});
    CHECK(many.count == 1000);
    CHECK(unite(many, spans<double, 1>(interval<double>{1, 2})).count == 999);
    CHECK(intersect(many, many).count == 1000);
    CHECK(subtract(spans<double, 1>(interval<double>{0, 2000}), many).count == 1000);
    static_assert(room<2, any_number> == any_number && room<2, 3> == 5);
}

TEST_CASE("unite, intersect, subtract: named cases") {
    const spans<double, 2> a = listed<2>({{0, 2}, {4, 6}}), b = listed<2>({{1, 5}}), none;
    CHECK(same(unite(a, b), {{0, 6}}));
    CHECK(same(intersect(a, b), {{1, 2}, {4, 5}}));
    CHECK(same(subtract(a, b), {{0, 1}, {5, 6}}));
    CHECK(same(subtract(b, a), {{2, 4}}));
    CHECK(same(unite(a, none), {{0, 2}, {4, 6}}));
    CHECK(intersect(a, none).empty());
    CHECK(same(subtract(a, none), {{0, 2}, {4, 6}}));
    CHECK(subtract(none, a).empty());
    CHECK(subtract(a, a).empty());
    CHECK(same(intersect(a, a), {{0, 2}, {4, 6}}));

    // Neighbours that touch share a point: together they are one, in common they have that point, and neither takes
    // anything from the other.
    const spans<double, 1> left = listed<1>({{0, 1}}), right = listed<1>({{1, 2}});
    CHECK(same(unite(left, right), {{0, 2}}));
    CHECK(same(intersect(left, right), {{1, 1}}));
    CHECK(same(subtract(left, right), {{0, 1}}));
    CHECK(same(subtract(right, left), {{1, 2}}));

    // A point is an interval as well: of a tangent. It is there if the others do not have it.
    const spans<double, 1> point = listed<1>({{3, 3}}), end = listed<1>({{1, 1}});
    CHECK(same(subtract(point, left), {{3, 3}}));
    CHECK(same(subtract(left, point), {{0, 1}}));
    CHECK(same(subtract(left, end), {{0, 1}}));
    CHECK(subtract(end, left).empty());
    CHECK(subtract(end, right).empty());
    CHECK(subtract(end, end).empty());

    // All the room that the type has is used, and no more.
    const spans<double, 3> odd = listed<3>({{1, 2}, {3, 4}, {5, 6}}),
                           even = listed<3>({{2.25, 2.75}, {4.25, 4.75}, {6.25, 6.75}});
    CHECK(unite(odd, even).count == 6);
    CHECK(same(subtract(listed<1>({{0, 7}}), odd), {{0, 1}, {2, 3}, {4, 5}, {6, 7}}));

    const double inf = infinity<double>;
    CHECK(same(subtract(listed<1>({{-inf, inf}}), left), {{-inf, 0}, {1, inf}}));
}

/// Up to three intervals with ends at whole numbers, so that many of them meet.
spans<double, 3> random_spans(random_numbers& random) {
    spans<double, 3> list;
    int end = random.integer(0, 3);
    for (int i = random.integer(0, 3); i > 0; --i) {
        const int begin = end + random.integer(0, 2);
        end = begin + random.integer(0, 3);
        list.append({double(begin), double(end)});
    }
    return list;
}

template <std::size_t N>
bool in_order(const spans<double, N>& list) {
    for (std::size_t i = 0; i < list.count; ++i) {
        if (list.intervals[i].empty()) return false;
        if (i > 0 && !(list.intervals[i - 1].max < list.intervals[i].min)) return false;
    }
    return list.count <= N;
}

TEST_CASE("unite, intersect, subtract: as the same question asked of every point") {
    random_numbers random(10);
    for (int i = 0; i < at_least(10'000); ++i) {
        const spans<double, 3> a = random_spans(random), b = random_spans(random);
        const auto sum = unite(a, b), common = intersect(a, b), rest = subtract(a, b);
        REQUIRE((in_order(sum) && in_order(common) && in_order(rest)));
        REQUIRE(subtract(a, a).empty());
        for (double t = -0.5; t < 20; t += 0.5) {
            const bool in_a = a.contains(t), in_b = b.contains(t);
            REQUIRE(sum.contains(t) == (in_a || in_b));
            REQUIRE(common.contains(t) == (in_a && in_b));
            // The ends of what is taken are a matter of convention; between them, and elsewhere, there is no doubt.
            if (!in_b || t != std::floor(t)) REQUIRE(rest.contains(t) == (in_a && !in_b));
            if (!in_a) REQUIRE(!rest.contains(t));
        }
    }
}

constexpr bool constant = [] {
    const spans<double, 1> a(interval<double>{0, 2}), b(interval<double>{1, 3});
    return unite(a, b).count == 1 && intersect(a, b).contains(1.5) && !subtract(a, b).contains(1.5);
}();
static_assert(constant);

}  // namespace raio::test
