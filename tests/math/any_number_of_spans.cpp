#include <raio/math/any_number_of_spans.hpp>

#include <doctest/doctest.h>

namespace {

using namespace raio;

TEST_CASE("spans of any number hold as many as are put in, in order, and join those that meet") {
    spans<double, any_number> many;
    for (int i = 100; i-- > 0;) many.insert({3.0 * i, 3.0 * i + 1});
    REQUIRE(many.count == 100);
    for (std::size_t i = 0; i < 100; ++i) {
        const double from = 3.0 * static_cast<double>(i);
        CHECK(many.intervals[i] == interval<double>{from, from + 1});
    }
    many.insert({1, 297});
    CHECK(many.count == 1);
    CHECK(*many.begin() == interval<double>{0, 298});
}

TEST_CASE("what is made of spans of any number has any number") {
    spans<double, any_number> many;
    for (int i = 0; i < 10; ++i) many.append({2.0 * i, 2.0 * i + 1});
    const spans<double, 1> one(interval<double>{0.5, 18.5});
    CHECK(unite(many, one).count == 1);
    CHECK(intersect(one, many).count == 10);
    CHECK(subtract(one, many).count == 9);
    static_assert(std::same_as<decltype(subtract(one, many)), spans<double, any_number>>);
    const spans<double, any_number> moved = many.each([](const auto& i) {
        return interval<double>{i.min + 1, i.max + 1};
    });
    REQUIRE(moved.count == 10);
    CHECK(moved.intervals[9] == interval<double>{19, 20});
}

}  // namespace
