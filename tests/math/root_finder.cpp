#include <raio/math/root_finder.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "support/oracle.hpp"
#include "support/random.hpp"

namespace raio::test {

namespace {

/// (t + 1) (t - 1) (t - 2), whose turns are at (2 +- sqrt(7)) / 3.
template <class W>
polynomial<W, 3> three_roots() {
    return {{W(2), W(-1), W(-2), W(1)}};
}

template <class W, std::size_t N>
std::vector<polynomial_root<W>> roots_found(const polynomial<W, N>& p, double low, double high,
                                            std::size_t most = 100) {
    std::vector<polynomial_root<W>> found;
    const detail::root_finder<W, N> finder(p, W(low), W(high));
    REQUIRE(finder.is_sound());
    const bool to_the_end = finder.find(1e-8, 1e-8, [&](const detail::enclosure<W>& about, auto approached) {
        found.push_back(approached());
        CHECK(about.is_one);
        CHECK((about.sign_before == found.back().sign_before && about.sign_after == found.back().sign_after));
        CHECK((about.low <= found.back().t && found.back().t <= about.high));
        return found.size() < most;
    });
    CHECK(to_the_end == (found.size() < most));
    return found;
}

}  // namespace

TEST_CASE_TEMPLATE("root_finder: one enclosure after the other", W, strict_double, double_double) {
    const auto found = roots_found(three_roots<W>(), -4, 4);
    REQUIRE(found.size() == 3);
    const double roots[] = {-1, 1, 2};
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(abs(exactly(found[i].t) - oracle(roots[i])) <= exactly(found[i].error));
        CHECK(found[i].error < 1e-13);
        CHECK(found[i].sign_before == (i % 2 == 0 ? -1 : 1));
    }
    CHECK(roots_found(three_roots<W>(), -4, 4, 2).size() == 2);
    CHECK(roots_found(three_roots<W>(), 0, 1.5).size() == 1);
    CHECK(roots_found(three_roots<W>(), 1.25, 1.75).empty());
}

TEST_CASE("root_finder: wherever it looks first, it finds the root that is enclosed") {
    using W = strict_double;
    const auto p = three_roots<W>();
    const detail::root_finder<W, 3> finder(p, W(-4), W(4));
    const detail::enclosure<W> about{W(1.5), W(4), -1, 1, true};
    for (const double guess : {1.5, 1.501, 1.9, 2.0, 2.5, 3.9, 4.0}) {
        const auto root = finder.approach(about, W(guess), 1e-8);
        CHECK(std::abs(static_cast<double>(root.t) - 2) <= root.error);
        CHECK(root.error < 1e-13);
        CHECK((root.sign_before == -1 && root.sign_after == 1));
    }
}

TEST_CASE_TEMPLATE("root_finder: a root at an end is within the error, which was a rounding short of it", W,
                   strict_double, double_double) {
    random_numbers random(5);
    for (int i = 0; i < at_least(1000); ++i) {
        const W low(-random.log_uniform(1e-30, 1)), high(random.log_uniform(1e-30, 1)), t(random.uniform(0, 1));
        const oracle error = exactly(detail::farthest_from(t, low, max(t, high)));
        REQUIRE(exactly(t) - exactly(low) <= error);
        REQUIRE(exactly(high) - exactly(t) <= error);
    }
}

TEST_CASE("root_finder: what cannot be evaluated everywhere") {
    using W = strict_double;
    const auto is_sound = [](const W& c, double low, double high) {
        const polynomial<W, 2> p{{W(1), W(1), c}};
        return detail::root_finder<W, 2>(p, W(low), W(high)).is_sound();
    };
    CHECK(is_sound(W(1), -1, 1));
    CHECK(!is_sound(W(1), 1, 1));
    CHECK(!is_sound(W(1), 1, -1));
    CHECK(!is_sound(W(1), -1e160, 1));
    CHECK(!is_sound(W(1), -1, 1e160));
    CHECK(!is_sound(W(NAN), -1, 1));
    CHECK(!is_sound(W(1e300), -1e10, 1e10));
}

}  // namespace raio::test
