#include <raio/proof/parabola.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/polynomials.hpp"

namespace raio::test {

namespace {

/// A number that is known up to a bound, and what it stands for.
template <class W>
struct known_number {
    bounded_number<W> number;
    oracle exact;

    /// \param size  of the terms that it was added up from: what it is off by is a part of that
    known_number(const oracle& x, const oracle& size, double part, random_numbers& random) : exact(x) {
        number = number_for<W>(x + size * oracle(part * random.uniform(-1, 1)));
        number.error += bound_t<W>(rounded<double>(size) * part * (1 + 0x1p-20));
    }
};

/// a t^2 - 2 b t + c, all of it as far off as it says.
template <class W>
struct parabola {
    static constexpr double extent = 4;

    known_number<W> a, b, c, square;

    parabola(const oracle& exact_a, const oracle& exact_b, const oracle& exact_c, double part, random_numbers& random)
        : a(exact_a, abs(exact_a), part, random),
          b(exact_b, abs(exact_b), part, random),
          c(exact_c, abs(exact_c), part, random),
          square(exact_b * exact_b - exact_a * exact_c, exact_b * exact_b + abs(exact_a * exact_c), part, random) {}

    oracle operator()(const oracle& t) const { return (a.exact * t - 2 * b.exact) * t + c.exact; }

    hollow_chord<W> below_zero() const {
        const verdict<bool> sound{true, true, true};
        return where_below_zero(
            a.number, b.number, square.number, sound, false, [&] { return c.number; },
            [] { return bound_t<W>(extent); });
    }
};

/// Of any sort: curved up or down, all but linear, all but constant, all but touching zero.
template <class W>
parabola<W> random_parabola(random_numbers& random) {
    const auto number = [&] { return oracle(random.uniform(-1, 1)); };
    const double part = random.log_uniform(unit_roundoff<W>, 0x1p10 * unit_roundoff<W>);
    oracle a = number(), b = number(), c = number();
    if (random.one_in(3)) a *= oracle(random.one_in(3) ? 0.0 : random.log_uniform(1e-40, 1));
    if (random.one_in(8)) b *= oracle(random.log_uniform(1e-40, 1));
    if (random.one_in(8)) c *= oracle(random.log_uniform(1e-40, 1));
    if (random.one_in(4) && a != 0) c = b * b / a * (1 + number() * oracle(random.log_uniform(1e-40, 1)));
    return {a, b, c, part, random};
}

/// Is the chord right about f <= 0 at t, unless t is as close to one of its ends as that may be off?
template <class W>
bool is_right(const parabola<W>& f, const hollow_chord<W>& found, const oracle& t) {
    const crossing<W>&near = found.ends.near, &far = found.ends.far;
    const auto beside = [&](const crossing<W>& end) {
        return abs(t - exactly(end.t)) <= exactly(end.error) * oracle(1 + 0x1p-40);
    };
    if (near.exists && (beside(near) || beside(far))) return true;
    const bool after = exactly(near.t) <= t, before = t <= exactly(far.t);
    const bool inside = near.exists && (found.hollow ? !after || !before : after && before);
    return inside == (f(t) <= 0);
}

}  // namespace

TEST_CASE_TEMPLATE("parabola: where it is known beyond doubt, that is where it is below zero", W, strict_double,
                   double_double) {
    random_numbers random(1);
    int hits = 0, misses = 0, hollow = 0, open = 0, linear = 0;
    for (int i = 0; i < at_least_a_tenth_of(20'000); ++i) {
        const parabola<W> f = random_parabola<W>(random);
        const hollow_chord<W> found = f.below_zero();
        const crossing<W>&near = found.ends.near, &far = found.ends.far;
        REQUIRE((near.exists == far.exists && near.certain == far.certain));
        if (!near.certain) {
            ++open;
            continue;
        }
        for (int k = 0; k < 8; ++k) {
            REQUIRE(is_right(f, found, oracle(random.uniform(-parabola<W>::extent, parabola<W>::extent))));
        }
        for (const crossing<W>& end : {near, far}) {  // and just beside both ends
            const oracle t = exactly(end.t), off = exactly(end.error) * 2 + abs(t) * oracle(0x1p-60);
            if (!near.exists || abs(t) > oracle(parabola<W>::extent)) continue;
            for (const oracle& beside : {t - off, t + off}) REQUIRE(is_right(f, found, beside));
        }
        const bool one_end = std::max(std::abs(double(near.t)), std::abs(double(far.t))) >= parabola<W>::extent;
        hits += near.exists, misses += !near.exists, hollow += near.exists && found.hollow;
        linear += near.exists && one_end && abs(f.a.exact) < oracle(1e-10);
    }
    const auto at_least = at_least_a_tenth_of;
    CHECK((hits > at_least(5'000) && misses > at_least(1'000) && hollow > at_least(500) && linear > at_least(100)));
    CHECK(open > 0);
    CHECK(open < at_least(6'000));
}

TEST_CASE("parabola: what is above zero, beyond doubt, is missed before anything else is asked") {
    using E = bound_t<strict_double>;
    const auto number = [](double x, double error) {
        return bounded_number<strict_double>(strict_double(x), E(error));
    };
    CHECK(is_above_zero(number(1, 0.25), number(-1, 0.5)));
    CHECK(!is_above_zero(number(1, 0.5), number(-1, 0.5)));  // a may be next to nothing
    CHECK(!is_above_zero(number(1, 0.25), number(-1, 1)));
    CHECK(!is_above_zero(number(-1, 0), number(-1, 0)));
}

TEST_CASE("parabola: t is counted from elsewhere, and in another unit") {
    using W = strict_double;
    const auto chord_at = [](double near, double far) {
        return hollow_chord<W>{{{true, true, W(near), 0x1p-30, true}, {true, true, W(far), 0x1p-30, false}}, false};
    };
    const auto starts = [](bool on_surface) {
        return [=] { return bounded_number<W>(W(on_surface ? 0.0 : 1.0), bound_t<W>(0)); };
    };
    hollow_chord<W> c = chord_at(-1, 2);
    move_on(c, bounded_number<W>(W(10), bound_t<W>(0x1p-20)), starts(false));
    CHECK((c.ends.near.t == W(9) && c.ends.far.t == W(12)));
    CHECK((c.ends.near.error > 0x1p-20 && c.ends.near.error < 0x1.1p-20));
    c = chord_at(-1, 2);
    move_on(c, given_number<W>{W(10)}, given_number<W>{W(0.5)}, starts(false));
    CHECK((c.ends.near.t == W(9.5) && c.ends.far.t == W(11)));
    CHECK((c.ends.near.error >= 0x1p-31 && c.ends.near.error < 0x1p-29));

    // An end that cannot be told from t = 0 is there, if the line starts on the surface.
    for (const bool on_surface : {false, true}) {
        c = chord_at(-0x1p-31, 1);
        move_on(c, bounded_number<W>(W(0), bound_t<W>(0)), starts(on_surface));
        CHECK((c.ends.near.t == W(0)) == on_surface);
        CHECK(c.ends.far.t == W(1));
    }
}

TEST_CASE("parabola: of a hollow solid a convex one leaves a part before it and a part behind it") {
    using W = strict_double;
    const auto end = [](double t, bool entering) { return crossing<W>{true, true, W(t), 0x1p-30, entering}; };
    const chord<W> convex{end(-4, true), end(4, false)};
    const hollow_chord<W> solid{{end(-1, true), end(2, false)}, false}, hollow{{end(-1, false), end(2, true)}, true};

    const chord_pair<W> one = intersect(solid, convex, every_crossing{}),
                        two = intersect(hollow, convex, every_crossing{});
    CHECK((one.first.near.t == W(-1) && one.first.far.t == W(2) && !one.second.near.exists));
    CHECK((two.first.near.t == W(-4) && two.first.far.t == W(-1) && two.second.near.t == W(2) &&
           two.second.far.t == W(4)));
    CHECK((two.first.near.entering && !two.first.far.entering && two.second.near.entering && !two.second.far.entering));
    for (const bool is_first : {true, false}) {
        const chord<W> wanted = intersect(hollow, convex, known_chord<bool>{is_first});
        const chord<W>& same = is_first ? two.first : two.second;
        CHECK((wanted.near.t == same.near.t && wanted.far.t == same.far.t));
    }
    const chord_pair<W> beside = intersect(hollow, chord<W>{end(0, true), end(1, false)}, every_crossing{});
    CHECK((!beside.first.near.exists && !beside.second.near.exists && missed(beside)));
}

}  // namespace raio::test
