#include <raio/proof/refine.hpp>

#include <optional>

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

/// The same of a ray of more digits, in two steps, of which it says how the second was asked.
struct told_twice {
    using W = rounded_double;
    struct question {
        nearby_ray<X, W> nearby;
        crossing<W> c;
    };

    crossing<W> first, then;
    std::optional<question>* second;

    crossing<W> correction(const nearby_ray<X, W>& nearby, const crossing<W>& c) const {
        if (c.error == strict_double(1)) return first;
        *second = question{nearby, c};
        return then;
    }
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

TEST_CASE("refine: what a ray of more digits misses is found in a second step, where one has left too much") {
    using R = rounded_double;
    const ray<X> ray{{X(3) + X(0x1p-70), X(0), X(0)}, {X(1) - X(0x1p-60), X(0), X(0)}};
    const crossing<R> c{true, true, R(-1), W(1), true, 0, R(0.25), R(0.5)};
    // From 3 it is a step of 1 back: 2^-88 of both together is how much one step may leave.
    for (const double left : {0x1p-86, 0x1.01p-86}) {
        crossing<R> first{true, true, R(0x1p-40), W(left), true}, then{true, true, R(-0x1p-90), W(0x1p-95), true};
        first.u = R(0x1p-30), first.v = R(0x1p-31), then.u = R(0x1p-70), then.v = R(0x1p-72);
        std::optional<told_twice::question> second;
        const crossing<X> fine = refined<X>(told_twice{first, then, &second}, ray, c);
        const bool in_two = left > 0x1p-86;
        CAPTURE(left);
        REQUIRE(second.has_value() == in_two);
        CHECK((fine.certain && fine.exists));
        const X one_step = X(-1) + X(0x1p-40);
        CHECK(fine.t == (in_two ? one_step - X(0x1p-90) : one_step));
        CHECK(fine.u == X(0.25 + 0x1p-30) + X(in_two ? 0x1p-70 : 0.0));
        CHECK(fine.v == X(0.5 + 0x1p-31) + X(in_two ? 0x1p-72 : 0.0));
        CHECK(exactly(fine.error) >= oracle(in_two ? 0x1p-95 : left));
        CHECK(exactly(fine.error) <= oracle(in_two ? 0x1p-95 : left) * 1.5);
        if (!in_two) continue;
        const auto& [nearby, closer] = *second;
        CHECK((closer.t == R(-1 + 0x1p-40) && closer.u == R(0.25 + 0x1p-30) && closer.v == R(0.5 + 0x1p-31)));
        CHECK((closer.error >= W(left) && closer.error <= W(left * 1.01)));
        CHECK((nearby.origin.x == ray.origin.x && nearby.step.x == one_step * ray.direction.x));
    }
    // If the second one leaves as much, t is not certain.
    const crossing<R> much{true, true, R(0), W(0x1p-80), true};
    std::optional<told_twice::question> second;
    CHECK((!refined<X>(told_twice{much, much, &second}, ray, c).certain && second.has_value()));
}

TEST_CASE("refine: a point that is seen from another is no farther off than is said") {
    random_numbers random(2);
    part_of_bound part;
    for (int i = 0; i < at_least(20'000); ++i) {
        const vec3<double> base = some_vector(random);
        const vec3<oracle> to = vec3<oracle>(some_vector(random)) + vec3<oracle>(some_vector(random) * 0x1p-60);
        const auto [nearby, exact] = gone_close_to(to, some_vector(random), vec3<double>(1, 0, 0));
        const auto [place, error] = nearby.seen_from(base);
        const vec3<oracle> off = exactly(place) - (exact.origin - vec3<oracle>(base));
        part.add(norm1(off), error);
    }
    CHECK(part.largest > 0.005);
}

TEST_CASE("refine: a step of Newton's method makes up for what underflows") {
    const crossing<W> step = newton_step(X(0), W(0), W(1), W(0));
    CHECK((step.exists && step.certain && step.t == W(0)));
    CHECK(step.error >= W(least_normal<X>));
}

}  // namespace raio::test
