#include <raio/number/comparison.hpp>

#include "support/proven.hpp"

namespace raio::test {

/// Every verdict is in order, and right of exact numbers wherever it is beyond doubt.
/// \return in how many lanes it is
template <class Mask, class Exact>
int right_beyond_doubt(const verdict<Mask>& v, std::size_t lanes, Exact exact) {
    int settled = 0;
    for (std::size_t i = 0; i < lanes; ++i) {
        const bool certainly = lane(v.certainly, i), possibly = lane(v.possibly, i), yes = lane(v.yes, i);
        REQUIRE((certainly <= yes && yes <= possibly));
        if (certainly) REQUIRE(exact(i));
        if (!possibly) REQUIRE(!exact(i));
        settled += certainly || !possibly;
    }
    return settled;
}

TEST_CASE_TEMPLATE("comparison: a comparison beyond doubt is right", W, RAIO_PRECISIONS) {
    random_numbers random(4);
    for_each_kind<W>([&]<class A>() {
        for_each_kind<W>([&]<class B>() {
            int settled = 0, all = 0;
            for (int i = 0; i < share_of_lanes<W>(1000); ++i) {
                const auto a = maker<A>::any(random, 10);
                const auto b = maker<B>::any(random, 10, &a.number.value);
                const std::size_t lanes = lanes_of<W>;
                const auto check = [&](const auto& v, auto f) {
                    settled += right_beyond_doubt(v, lanes, [&](auto j) { return f(a.exact[j], b.exact[j]); });
                    all += static_cast<int>(lanes);
                };
                check(a.number >= b.number, std::greater_equal<>{});
                check(a.number <= b.number, std::less_equal<>{});
                check(a.number > b.number, std::greater<>{});
                check(a.number < b.number, std::less<>{});
                const oracle zero(0);
                right_beyond_doubt(is_positive(a.number), lanes, [&](auto j) { return a.exact[j] > zero; });
                right_beyond_doubt(is_positive(a.number - b.number), lanes,
                                   [&](auto j) { return a.exact[j] > b.exact[j]; });
            }
            CHECK(settled > all / 2);
            CHECK((settled < all || (is_given<A> && is_given<B>)));
        });
    });
}

template <class Mask>
std::string said(const verdict<Mask>& v) {
    const char* yes = lane(v.yes, 0) ? "" : "?";
    return lane(v.certainly, 0) ? "yes" : !lane(v.possibly, 0) ? "no" : *yes == 0 ? "perhaps" : "perhaps not";
}

TEST_CASE_TEMPLATE("comparison: what is in doubt is a tie in the last precision", W, RAIO_PRECISIONS) {
    using bounded = bounded_number<W>;
    using E = bound_t<W>;
    const auto number = [](double value, double error) { return bounded(W(value), E(error)); };
    const double bit = 0x1p-40;
    const bounded low = number(1, bit), one = number(1 + bit, bit), high = number(1 + 3 * bit, 0.75 * bit);
    const char *for_last = last_precision<W> ? "perhaps" : "perhaps not",
               *not_for_last = last_precision<W> ? "perhaps not" : "perhaps";
    if (!std::same_as<scalar_t<W>, float>) {
        CHECK((said(one >= low) == "perhaps" && said(low <= one) == "perhaps"));
        CHECK((said(low >= one) == for_last && said(one <= low) == for_last));
        CHECK((said(one > low) == not_for_last && said(low < one) == not_for_last));
        CHECK((said(low > one) == "perhaps not" && said(one < low) == "perhaps not"));
        CHECK((said(high >= low) == "yes" && said(high > low) == "yes" && said(low <= high) == "yes"));
        CHECK((said(low >= high) == "no" && said(low > high) == "no" && said(high < low) == "no"));
    }
    CHECK((said(one >= one) == "perhaps" && said(one <= one) == "perhaps"));
    CHECK((said(one > one) == "perhaps not" && said(one < one) == "perhaps not"));
    // Numbers that are hardly known are no tie unless they are all but the same.
    CHECK((said(number(1, 1) >= number(1.5, 1)) == "perhaps not" && said(number(1.5, 1) > number(1, 1)) == "perhaps"));
    CHECK((said(is_positive(number(1, 0.25))) == (last_precision<W> ? "perhaps not" : "yes")));
    CHECK((said(is_positive(number(1, 2))) == (last_precision<W> ? "perhaps not" : "perhaps")));
    CHECK((said(is_positive(number(-1, 2))) == "perhaps not"));
    CHECK((said(is_positive(number(1, 0x1p-33))) == "yes" && said(is_positive(number(-1, 0x1p-33))) == "no"));
    CHECK(said(is_positive(number(0, 0))) == "perhaps not");
}

TEST_CASE_TEMPLATE("comparison: a given number is positive or not, beyond doubt", W, RAIO_PRECISIONS) {
    using limits = std::numeric_limits<scalar_t<W>>;
    const auto given = [](auto x) { return given_number<W>{W(x)}; };
    for (const auto above : {static_cast<double>(limits::denorm_min()), 1.0, static_cast<double>(limits::max())}) {
        CHECK((said(is_positive(given(above))) == "yes" && said(is_positive(given(-above))) == "no"));
        CHECK((said(is_positive(-given(above))) == "no" && said(is_positive(abs(-given(above)))) == "yes"));
    }
    CHECK((said(is_positive(given(0.0))) == "no" && said(is_positive(given(-0.0))) == "no"));
    // Of a product that is too small it is not known.
    const double least = static_cast<double>(limits::min());
    CHECK(said(is_positive(given(least) * given(least))) == "perhaps not");
    CHECK(said(is_positive(given(-least) * given(least))) == "perhaps not");
    CHECK((said(is_positive(given(2) * given(3))) == "yes" && said(is_positive(given(-2) * given(3))) == "no"));
}

TEST_CASE_TEMPLATE("comparison: nothing is certain of what is no number, nor of infinities", W, RAIO_PRECISIONS) {
    using bounded = bounded_number<W>;
    using E = bound_t<W>;
    const scalar_t<W> inf = std::numeric_limits<scalar_t<W>>::infinity();
    const auto given = [](auto x) { return given_number<W>{W(x)}; };
    const auto in_doubt = [](const auto& v) { return !lane(v.certainly, 0) && lane(v.possibly, 0); };
    const auto no_answer = [&](const auto& v) { return in_doubt(v) && !lane(v.yes, 0) && in_doubt(!v); };
    const auto check = [&](const auto& x) {
        for (const auto& other : {given(1), given(-1), given(0)}) {
            CHECK((in_doubt(x >= other) && in_doubt(x <= other) && in_doubt(x < other) && in_doubt(x > other)));
            CHECK((in_doubt(other >= x) && in_doubt(other <= x) && in_doubt(other < x) && in_doubt(other > x)));
            for (const auto& most : {max(x, other), max(other, x), min(x, other), min(other, x)}) {
                CHECK((in_doubt(most >= given(7)) && in_doubt(most < given(-7))));
            }
            const bounded either = select(given(1) >= given(1) * given(1), other, x);
            CHECK((in_doubt(either >= given(7)) && in_doubt(either < given(-7))));
        }
        const auto check_made = [&](const auto&... made) {
            CHECK((in_doubt(made >= given(7)) && ...));
            CHECK((in_doubt(made < given(-7)) && ...));
        };
        check_made(x + given(1), x * given(-1), inverse(x - given(1)), given(1) - square(x), x, -x, bounded(x), abs(x),
                   given(0) * x + given(1));
    };
    const auto check_nan = [&](const auto& x) {
        check(x);
        for (const auto& other : {bounded(given(1)), bounded(x)}) {
            CHECK((no_answer(x >= other) && no_answer(x <= other) && no_answer(x < other) && no_answer(x > other)));
        }
        CHECK(no_answer(is_positive(x)));
        CHECK(no_answer(is_positive(sqrt(x))));
        CHECK(no_answer(is_positive(inverse(x))));
    };
    const scalar_t<W> nan = std::numeric_limits<scalar_t<W>>::quiet_NaN();
    check_nan(given(nan));
    check_nan(rounded_number<W, 2>{W(nan)});
    check_nan(bounded(W(nan), E(0)));
    for (const W& x : {W(inf), W(-inf)}) {
        check(rounded_number<W, 2>{x});
        check(bounded(x, E(infinity<E>)));
        CHECK(in_doubt(is_positive(bounded(x, E(infinity<E>)))));
        // What was out of range may have been anything large: times what was not, its inverse may be.
        CHECK(in_doubt(inverse(rounded_number<W, 2>{x}) < given(7)));
    }
    check(inverse(bounded(W(0), E(1))));
    check(-inverse(bounded(W(0), E(1))));
    check_nan(inverse(given(0)));
}

}  // namespace raio::test
