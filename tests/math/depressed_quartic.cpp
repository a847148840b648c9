#include <raio/math/depressed_quartic.hpp>

#include <doctest/doctest.h>

#include <raio/math/polynomial_roots.hpp>

#include "support/oracle.hpp"
#include "support/random.hpp"

namespace raio::test {

namespace {

/// What is wrong with what is known of the first root of one in [-1, 1], where it is positive at both ends.
template <class W>
std::string wrong_first_root(const polynomial<W, 4>& p, const first_root<W>& first) {
    polynomial<oracle, 4> exact;
    for (std::size_t k = 0; k <= 4; ++k) exact.coefficient[k] = test::exactly(p.coefficient[k]);
    const auto roots = roots_between(exact, oracle(-1), oracle(1));
    if (!first.known) return "";
    if (first.exists != (roots.count > 0)) return first.exists ? "a root that is none" : "a lost root";
    if (!first.exists) return "";
    const oracle low = test::exactly(first.low), high = test::exactly(first.high), root = roots.begin()->t;
    if (!(exact(low) > 0 && exact(high) < 0)) return "other signs";
    if (!(low < root && root < high)) return "not the first root";
    if (roots.count > 1 && !(high < roots.begin()[1].t)) return "more than one root";
    return first.low <= first.guess && first.guess <= first.high ? "" : "guessed elsewhere";
}

/// Of the two quadratics with these roots' middles at -m and m, and these squares of half of their distances.
template <class W>
polynomial<W, 4> quartic(double m, double first_square, double second_square, double leading) {
    const double q = m * m - first_square, s = m * m - second_square;  // (x^2 + 2 m x + q) (x^2 - 2 m x + s)
    return {{W(leading * q * s), W(leading * 2 * m * (s - q)), W(leading * (q + s - 4 * m * m)), W(0), W(leading)}};
}

}  // namespace

TEST_CASE_TEMPLATE("depressed_quartic: the first root, or that there is none", W, strict_double, double_double) {
    random_numbers random(20261124);
    int known = 0, with_root = 0, asked = 0;
    for (int i = 0; i < at_least_a_tenth_of(20'000); ++i) {
        // Two roots, none, or all but one place where it touches zero, on each side; or with both pairs together.
        const auto square = [&] {
            const double size = random.one_in(3) ? random.log_uniform(1e-12, 1e-3) : random.uniform(0, 0.3);
            return random.one_in(2) ? size : -size;
        };
        const double m = random.one_in(4) ? random.log_uniform(1e-6, 0.1) : random.uniform(0, 0.8);
        auto p = quartic<W>(m, square(), square(), random.log_uniform(1e-3, 10));
        if (random.one_in(4)) {  // all but a quadratic
            const double other = random.uniform(-1, 1), constant = random.uniform(-0.2, 1);
            p = {{W(constant), W(random.uniform(-0.2, 0.2)), W(other), W(0), W(random.log_uniform(1e-16, 1e-3))}};
        }
        if (!(p(W(-1)) > W(0) && p(W(1)) > W(0))) continue;
        const first_root<W> first = depressed_quartic<W>(p).between(W(-1), W(1));
        const std::string wrong = wrong_first_root(p, first);
        REQUIRE_MESSAGE(wrong == "", i);
        ++asked, known += first.known, with_root += first.exists;
    }
    CHECK(known > asked * 4 / 5);  // all but those that all but touch zero
    CHECK((with_root > asked / 5 && with_root < asked * 4 / 5));
}

TEST_CASE("depressed_quartic: what it does not know") {
    using W = strict_double;
    const auto known = [](const polynomial<W, 4>& p, double low = -1, double high = 1) {
        return depressed_quartic<W>(p).between(W(low), W(high)).known;
    };
    const polynomial<W, 4> above{{W(1), W(0), W(0), W(0), W(1)}};
    CHECK(known(above));
    CHECK(!known(above, -2, 2));                                          // beyond what its noise is known for
    CHECK(!known({{W(1), W(0), W(0), W(0x1p-10), W(1)}}));                // a cubic term
    CHECK(!known({{W(1), W(0), W(0), W(0), W(1)}, {0, 0, 0, 1e-9, 0}}));  // one that may be there
    CHECK(!known({{W(1), W(0), W(0), W(0), W(0x1p-46)}}));                // all but a constant
    CHECK(!known({{W(1), W(0), W(0), W(0), W(-2)}}));
    CHECK(!known({{W(-1), W(0), W(0), W(0), W(0.5)}}));  // below zero at an end
    CHECK(!known({{W(-0.5), W(1), W(0), W(0), W(0.5)}}));
    CHECK(!known({{W(1.0 / 16), W(0), W(-0.5), W(0), W(1)}}));  // it touches zero twice
    CHECK(!known({{W(NAN), W(0), W(0), W(0), W(1)}}));
    CHECK(!known({{W(0x1p-1070), W(0), W(0), W(0), W(0x1p-1070)}}));  // which has no noise but what underflows
}

}  // namespace raio::test
