#include <raio/refine.hpp>

#include <doctest/doctest.h>

#include "support/bounds.hpp"

namespace raio::test {

using W = strict_double;
using X = double_double;

namespace {

/// A shape that says just this is missing.
struct told {
    crossing<W> missing;

    crossing<W> correction(const nearby_ray<X, W>&, const crossing<W>&) const { return missing; }
};

const ray<double> any{{0, 0, 1}, {0, 0, -1}};

}  // namespace

TEST_CASE("refine: what is missing is added, and what cannot be told from a number of fewer digits is that") {
    random_numbers random(1);
    const int count = at_least(20'000);
    int simple = 0;
    for (int i = 0; i < count; ++i) {
        const double t = random.uniform(-2, 2), more = t * random.uniform(-1e-16, 1e-16),
                     error = std::abs(more) * random.uniform(0, 2);
        crossing<W> c{true, true, W(t), W(1), true, 3, W(0.25), W(0.75)}, missing{true, true, W(more), W(error), false};
        missing.u = W(0x1p-60), missing.v = W(-0x1p-61);
        const crossing<X> fine = refined<X>(told{missing}, any, c);
        const oracle sum = oracle(t) + oracle(more), stated = exactly(fine.error);
        const oracle nearest(rounded<double>(sum)), beyond = abs(sum - nearest);
        const bool is_simple = exactly(fine.t) == nearest;
        REQUIRE((is_simple || exactly(fine.t) == sum));
        REQUIRE(stated >= error + (is_simple ? beyond : oracle(0)));
        REQUIRE(stated <= error + beyond + abs(sum) * 0x1p-98);
        if (beyond < error) REQUIRE(is_simple);
        if (beyond > error + abs(sum) * 0x1p-98) REQUIRE(!is_simple);
        simple += is_simple;
        REQUIRE((exactly(fine.u) == oracle(0.25) + 0x1p-60 && exactly(fine.v) == oracle(0.75) - 0x1p-61));
        REQUIRE((fine.exists && fine.certain && fine.entering && fine.face == 3));
    }
    CHECK((simple > count / 10 && simple < count / 10 * 9));
}

TEST_CASE("refine: certain is what was, of one surface alone, and if what is missing is") {
    for (int bits = 0; bits < 16; ++bits) {
        const crossing<W> missing{(bits & 1) != 0, (bits & 2) != 0, W(0), W(0), true};
        crossing<W> c{true, (bits & 4) != 0, W(1), W(0), true};
        c.shared = (bits & 8) != 0;
        CHECK(refined<X>(told{missing}, any, c).certain == (bits == 7));
    }
}

}  // namespace raio::test
