#include <raio/number/verdict.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>

#include <raio/number/simd.hpp>

namespace raio::test {

/// Kleene's three values, in the order in which `every` takes the least and `some` the greatest.
enum kleene { no, doubt, yes };
constexpr std::array values{no, doubt, yes};

kleene opposite(kleene a) { return static_cast<kleene>(2 - a); }

/// As a verdict; what is in doubt may be answered either way.
verdict<bool> as_verdict(kleene a, bool answer) { return {a == yes, a != no, a == doubt ? answer : a == yes}; }
kleene as_value(const verdict<bool>& v) { return v.certainly ? yes : v.possibly ? doubt : no; }

TEST_CASE("verdict: the tables of Kleene's logic") {
    constexpr kleene both[3][3] = {{no, no, no}, {no, doubt, doubt}, {no, doubt, yes}};
    constexpr kleene either[3][3] = {{no, doubt, yes}, {doubt, doubt, yes}, {yes, yes, yes}};
    for (const kleene a : values) {
        for (const bool answer : {false, true}) {
            const verdict<bool> x = as_verdict(a, answer);
            CHECK((as_value(!x) == opposite(a) && (!x).yes == !x.yes && as_value(!!x) == a && (!!x).yes == x.yes));
            CHECK((as_value(every(x)) == a && as_value(some(x)) == a));
            for (const kleene b : values) {
                const verdict<bool> y = as_verdict(b, answer);
                CHECK((as_value(every(x, y)) == both[a][b] && as_value(some(x, y)) == either[a][b]));
            }
        }
    }
}

/// A pair of verdicts that are to be the same.
bool same_verdict(const verdict<bool>& a, const verdict<bool>& b) {
    return as_value(a) == as_value(b) && a.yes == b.yes;
}

TEST_CASE("verdict: of three and four, whatever their order, and as De Morgan says") {
    for (std::size_t i = 0; i < 81 * 16; ++i) {
        const kleene a = values[i % 3], b = values[i / 3 % 3], c = values[i / 9 % 3], d = values[i / 27 % 3];
        const std::size_t answers = i / 81;
        const verdict<bool> w = as_verdict(a, answers % 2 == 1), x = as_verdict(b, answers / 2 % 2 == 1),
                            y = as_verdict(c, answers / 4 % 2 == 1), z = as_verdict(d, answers / 8 % 2 == 1);
        REQUIRE(as_value(every(w, x, y)) == std::min({a, b, c}));
        REQUIRE(as_value(some(w, x, y)) == std::max({a, b, c}));
        REQUIRE(as_value(every(w, x, y, z)) == std::min({a, b, c, d}));
        REQUIRE(as_value(some(w, x, y, z)) == std::max({a, b, c, d}));
        REQUIRE(every(w, x, y, z).yes == (w.yes && x.yes && y.yes && z.yes));
        REQUIRE(some(w, x, y, z).yes == (w.yes || x.yes || y.yes || z.yes));
        REQUIRE(same_verdict(every(w, x, y, z), every(every(z, y), every(x, w))));
        REQUIRE(same_verdict(some(w, x, y, z), some(z, some(y, some(x, w)))));
        REQUIRE(same_verdict(!every(w, x, y), some(!w, !x, !y)));
        REQUIRE(same_verdict(!some(w, x, y, z), every(!w, !x, !y, !z)));
        REQUIRE(same_verdict(every(w, some(x, y)), some(every(w, x), every(w, y))));
        for (const auto& v : {every(w, x, y, z), some(w, x, y, z), !every(w, !x), !some(!w, x)}) {
            REQUIRE((v.certainly <= v.yes && v.yes <= v.possibly));
        }
    }
}

TEST_CASE_TEMPLATE("verdict: of packs it is that of each lane", P, pack<float, 16>, pack<double, 16>) {
    using mask = mask_t<P>;
    // Each pair of the values, of which that in doubt is answered either way.
    const auto bits_that = [](auto f) {
        P x(0);
        for (std::size_t i = 0; i < P::lanes; ++i) x.set(i, f(i) ? scalar_t<P>(1) : scalar_t<P>(0));
        return x > P(0);
    };
    const auto one = [](std::size_t i) { return as_verdict(values[i == 3 ? 1 : i], i == 3); };
    const auto first = [&](std::size_t lane) { return one(lane / 4); };
    const auto second = [&](std::size_t lane) { return one(lane % 4); };
    const auto packed = [&](auto of_lane) {
        return verdict<mask>{bits_that([&](auto i) { return of_lane(i).certainly; }),
                             bits_that([&](auto i) { return of_lane(i).possibly; }),
                             bits_that([&](auto i) { return of_lane(i).yes; })};
    };
    const verdict<mask> a = packed(first), b = packed(second);
    const auto check = [&](const verdict<mask>& found, auto expected) {
        for (std::size_t i = 0; i < P::lanes; ++i) {
            const verdict<bool> in_lane{found.certainly[i], found.possibly[i], found.yes[i]};
            CHECK(same_verdict(in_lane, expected(first(i), second(i))));
        }
    };
    check(every(a, b), [](const auto& x, const auto& y) { return every(x, y); });
    check(some(a, b), [](const auto& x, const auto& y) { return some(x, y); });
    check(every(a, b, !a), [](const auto& x, const auto& y) { return every(x, y, !x); });
    check(!a, [](const auto& x, const auto&) { return !x; });
}

static_assert(every(verdict<bool>{true, true, true}, verdict<bool>{false, true, true}).yes);

}  // namespace raio::test
