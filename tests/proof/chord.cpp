#include <raio/proof/chord.hpp>
#include <raio/proof/line.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "support/random.hpp"

namespace raio::test {

namespace {

/// An end of a chord at a small whole number, off by up to 2.
crossing<double> random_end(random_numbers& random) {
    crossing<double> c{true, !random.one_in(8), double(random.integer(0, 9)), double(random.integer(0, 2)), false};
    c.face = static_cast<std::uint32_t>(random.integer(0, 9)), c.shared = random.one_in(8);
    return c;
}
chord<double> random_chord(random_numbers& random) {
    chord<double> c{random_end(random), random_end(random)};
    c.far.t += c.near.t;
    c.near.entering = true;
    if (random.one_in(8)) c.near.exists = c.far.exists = false;
    c.far.certain = c.near.certain;
    return c;
}

bool overlap(const crossing<double>& a, const crossing<double>& b) {
    return a.t - a.error <= b.t + b.error && b.t - b.error <= a.t + a.error;
}

/// How far t may be off at the most, if `choose` chooses among what a and b may be.
template <class Choose>
double farthest_off(const crossing<double>& a, const crossing<double>& b, double t, Choose choose) {
    double off = 0;
    for (const double x : {a.t - a.error, a.t + a.error}) {
        for (const double y : {b.t - b.error, b.t + b.error}) off = std::max(off, std::abs(choose(x, y) - t));
    }
    return off;
}

}  // namespace

TEST_CASE("chord: what two solids share, whatever the ends are off by") {
    const auto later = [](double x, double y) { return std::max(x, y); };
    const auto earlier = [](double x, double y) { return std::min(x, y); };
    random_numbers random(1);
    int certain_hits = 0, certain_misses = 0;
    for (int i = 0; i < at_least(20'000); ++i) {
        const chord<double> a = random_chord(random), b = random_chord(random), both = intersect(a, b);
        REQUIRE(both.near.t == later(a.near.t, b.near.t));
        REQUIRE(both.far.t == earlier(a.far.t, b.far.t));
        REQUIRE(both.near.error == farthest_off(a.near, b.near, both.near.t, later));
        REQUIRE(both.far.error == farthest_off(a.far, b.far, both.far.t, earlier));
        REQUIRE(both.near.face == (b.near.t > a.near.t ? b.near : a.near).face);
        REQUIRE(both.far.face == (b.far.t < a.far.t ? b.far : a.far).face);
        REQUIRE(both.near.shared == (overlap(a.near, b.near) || (b.near.t > a.near.t ? b.near : a.near).shared));
        REQUIRE(both.far.shared == (overlap(a.far, b.far) || (b.far.t < a.far.t ? b.far : a.far).shared));

        const bool exist = a.near.exists && b.near.exists;
        REQUIRE(both.near.exists == (exist && both.near.t <= both.far.t));
        REQUIRE((both.far.exists == both.near.exists && both.far.certain == both.near.certain));
        // One that is not there leaves nothing to share.
        const bool nothing = (!a.near.exists && a.near.certain) || (!b.near.exists && b.near.certain);
        const double inside = both.far.t - both.near.t, slack = both.near.error + both.far.error;
        REQUIRE(both.near.certain == (nothing || (a.near.certain && b.near.certain && std::abs(inside) > slack)));
        certain_hits += both.near.certain && both.near.exists, certain_misses += both.near.certain && !both.near.exists;
    }
    CHECK((certain_hits > 1000 && certain_misses > 1000));
}

TEST_CASE("chord: of numbers that are believed all is certain, whatever they are off by") {
    using W = plain<float>;
    const W off(1000);
    const auto from_to = [&](float near, float far) {
        return chord<W>{{true, true, W(near), off, true}, {true, true, W(far), off, false}};
    };
    const auto is = [](const crossing<W>& c, bool exists, float t) {
        return c.certain && c.exists == exists && (!exists || float(c.t) == t);
    };
    const chord<W> both = intersect(from_to(1, 3), from_to(2, 4)), none = intersect(from_to(1, 2), from_to(3, 4));
    CHECK((is(both.near, true, 2) && is(both.far, true, 3)));
    CHECK((is(none.near, false, 0) && is(none.far, false, 0)));
    CHECK(missed(none));
    const chord<W> side = cut<false>(from_to(1, 3), from_to(2, 4));
    CHECK((is(side.near, false, 0) && is(side.far, true, 3)));
    CHECK(float(both.near.error) >= 1000);  // which is still reckoned
}

TEST_CASE("chord: two solids that are convex together, whatever the ends are off by") {
    const auto later = [](double x, double y) { return std::max(x, y); };
    const auto earlier = [](double x, double y) { return std::min(x, y); };
    random_numbers random(2);
    for (int i = 0; i < at_least(20'000); ++i) {
        const chord<double> a = random_chord(random), b = random_chord(random), all = unite(a, b);
        REQUIRE((all.near.exists == (a.near.exists || b.near.exists) && all.far.exists == all.near.exists));
        REQUIRE(all.near.certain == (a.near.certain && b.near.certain));
        REQUIRE(all.far.certain == all.near.certain);
        if (!a.near.exists || !b.near.exists) {
            const chord<double>& only = a.near.exists ? a : b;
            if (!only.near.exists) continue;
            REQUIRE((all.near.t == only.near.t && all.near.error == only.near.error));
            REQUIRE((all.far.t == only.far.t && all.far.error == only.far.error));
            REQUIRE((all.near.shared == only.near.shared && all.far.shared == only.far.shared));
            REQUIRE((all.near.face == only.near.face && all.far.face == only.far.face));
            continue;
        }
        REQUIRE(all.near.t == earlier(a.near.t, b.near.t));
        REQUIRE(all.far.t == later(a.far.t, b.far.t));
        REQUIRE(all.near.error == farthest_off(a.near, b.near, all.near.t, earlier));
        REQUIRE(all.far.error == farthest_off(a.far, b.far, all.far.t, later));
        REQUIRE(all.near.shared == (overlap(a.near, b.near) || (b.near.t < a.near.t ? b.near : a.near).shared));
        REQUIRE(all.far.shared == (overlap(a.far, b.far) || (b.far.t > a.far.t ? b.far : a.far).shared));
        REQUIRE(all.near.face == (b.near.t < a.near.t ? b.near : a.near).face);
        REQUIRE(all.far.face == (b.far.t > a.far.t ? b.far : a.far).face);
    }
}

TEST_CASE("chord: nothing is left to find out where both are missed beyond doubt") {
    for (const bool exists : {false, true}) {
        for (const bool certain : {false, true}) {
            chord<double> c = nowhere<double>(true);
            REQUIRE(missed(c));
            c.near.exists = exists, c.near.certain = certain;
            CHECK(missed(c) == (!exists && certain));
            std::swap(c.near, c.far);
            CHECK(missed(c) == (!exists && certain));
        }
    }
}

/// Half of the largest float is 1.7e38.
TEST_CASE("chord: an end is kept as far as the ray reaches it in numbers of its type") {
    struct row {
        float origin, t;
        bool exists, certain;
    };
    for (const row& r : {row{0, 5e37f, true, true},
                         {0, -5e37f, true, true},
                         {0, 1e38f, true, false},
                         {0, 2e38f, false, false},
                         {0, -2e38f, false, false},
                         {1e38f, 1e38f, false, false}}) {
        INFO(r.origin << ", " << r.t);
        const ray<float> ray{{r.origin, 0, 0}, {0, -1, 0}};
        const crossing<float> here{true, true, 0, 0, true}, there{true, true, r.t, 0, false};
        for (const bool first : {false, true}) {
            chord<float> c = first ? chord<float>{there, here} : chord<float>{here, there};
            keep_if_in_range<float>(line_in<float>(ray), c);
            const crossing<float>&far_off = first ? c.near : c.far, &near_by = first ? c.far : c.near;
            CHECK((far_off.exists == r.exists && far_off.certain == r.certain));
            CHECK((near_by.exists && near_by.certain == (std::abs(r.origin) < 8e37f)));
        }
    }
}

TEST_CASE("chord: what cannot be told from a point is one, where that is known best") {
    using W = double_double;
    const auto ends = [](double near, double near_error, double far, double far_error) {
        return chord<W>{{true, true, W(near), near_error, true}, {true, true, W(far), far_error, false}};
    };
    const double apart = 0x1p-50;
    // Entered at 1, which is known well, and left a little before that, which is not; and the other way round.
    const chord<W> entered = intersect(ends(1, 0x1p-90, 3, 0), ends(-1, 0, 1 - apart, 0x1p-49));
    const chord<W> left = intersect(ends(1 + apart, 0x1p-49, 3, 0), ends(-1, 0, 1, 0x1p-90));
    for (const chord<W>& c : {entered, left}) {
        CHECK((c.near.exists && c.far.exists && !c.near.certain && c.near.entering && !c.far.entering));
        CHECK((c.near.t == W(1) && c.far.t == W(1)));
        CHECK((c.near.error >= strict_double(apart) && c.far.error >= strict_double(apart)));
    }
    const chord<W> none = intersect(ends(1, 0x1p-90, 3, 0), ends(-1, 0, 1 - apart, 0x1p-52));
    CHECK((!none.near.exists && none.near.certain));
}

TEST_CASE("chord: an end that cannot be told from the ray's origin is there, if the ray starts on the surface") {
    const auto moved = [](double near, double far, bool starts) {
        chord<double> c{{true, true, near, 0.5, true}, {true, true, far, 0.25, false}};
        start_on_surface(c, [&] { return starts; });
        return c;
    };
    const chord<double> at_near = moved(-0.5, 2, true), at_far = moved(-2, 0.125, true), off = moved(-0.5, 2, false);
    CHECK((at_near.near.t == 0 && at_near.near.error == 1 && at_near.far.t == 2 && at_near.far.error == 0.25));
    CHECK((at_far.near.t == -2 && at_far.near.error == 0.5 && at_far.far.t == 0 && at_far.far.error == 0.375));
    CHECK((off.near.t == -0.5 && off.near.error == 0.5));
    chord<double> elsewhere{{true, true, 1, 0.5, true}, {true, true, 2, 0.5, false}};
    bool asked = false;
    start_on_surface(elsewhere, [&] { return asked = true; });
    CHECK((!asked && elsewhere.near.t == 1 && elsewhere.far.t == 2));
}

TEST_CASE_TEMPLATE("chord: an open side has its rims, and what is closer to them than its error is open", N,
                   strict_double, double_double, double) {
    using E = bound_t<N>;
    const auto slab_off_by = [](double error) {
        return chord<N>{{true, true, N(2), E(error), true}, {true, true, N(4), E(error), false}};
    };
    const auto kept = [&](double t, double error = 0.125, bool exists = true) {
        return within(slab_off_by(0), crossing<N>{exists, true, N(t), E(error), true});
    };
    CHECK((kept(3).exists && kept(3).certain));
    for (const double t : {1.5, 4.5}) CHECK((!kept(t).exists && kept(t).certain));
    for (const double t : {1.9375, 2.0625, 3.9375, 4.0625}) CHECK(!kept(t).certain);
    for (const double t : {2.0, 4.0}) CHECK((kept(t).exists && !kept(t).certain));
    for (const double t : {2 - 0x1p-20, 4 + 0x1p-20}) CHECK(kept(t).exists == std::same_as<N, double_double>);
    for (const double t : {1.9375, 4.0625}) CHECK(!kept(t).exists);  // a part of the slab is no error of its rim
    for (const double t : {1.9375, 2.0625, 3.9375, 4.0625}) {        // the planes may be off as well
        CHECK(!within(slab_off_by(0.125), crossing<N>{true, true, N(t), E(0), true}).certain);
    }
    CHECK((!kept(2, 0.125, false).exists && kept(2, 0.125, false).certain));
    const crossing<N> beside = within(nowhere<N>(), crossing<N>{true, true, N(3), E(0), true});
    CHECK((!beside.exists && beside.certain));
}

TEST_CASE("chord: of a closed surface a convex solid leaves a chord, of an open one each crossing on its own") {
    const auto end = [](double t, bool entering) { return crossing<double>{true, true, t, 0, entering}; };
    const chord<double> side{end(1, true), end(3, false)}, slab{end(2, true), end(4, false)};
    const chord<double> closed = cut<true>(side, slab), open = cut<false>(side, slab);
    CHECK((closed.near.exists && closed.near.t == 2 && closed.far.exists && closed.far.t == 3));
    CHECK((!open.near.exists && open.far.exists && open.far.t == 3));
}

}  // namespace raio::test
