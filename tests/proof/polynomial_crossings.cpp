#include <raio/proof/polynomial_crossings.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "support/bounds.hpp"
#include "support/polynomials.hpp"

namespace raio::test {

using W = strict_double;

namespace {

const line_part<W> along{true, true, vec3<W>(W(0)), vec3<W>(W(0)), vec3<double>(0), W(3), W(2)};

/// A piece c + s x.
struct piece {
    double constant, slope, low, high;
};

/// What is crossed from x = -1 on, from outside; t is 3 + 2 x.
struct walked {
    crossing_list<W, 8> list;
    bool is_done;

    explicit walked(std::initializer_list<piece> pieces, double from = INFINITY) {
        piecewise_walk<W, 8> walk{along, {.from = from}, list};
        for (const piece& p : pieces) {
            const polynomial<W, 4> f{{W(p.constant), W(p.slope), W(0), W(0), W(0)}, {}};
            walk.cross(f, W(p.low), W(p.high));
        }
        is_done = walk.is_done;
    }

    bool at(std::size_t i, double t, bool entering) const {
        const crossing<W>& c = list.crossings[i];
        return i < list.count && std::abs(static_cast<double>(c.t) - t) <= c.error && c.error < 1e-9 &&
               c.entering == entering;
    }
};

}  // namespace

namespace {

/// A cubic along the part t = 3 + 2 x, and the places where it is zero.
template <class X>
struct cubic_along {
    line_part<X> part{true, true, vec3<X>(X(0)), vec3<X>(X(0)), vec3<double>(0), X(3), X(2)};
    known_polynomial<X, 3> f;
    std::array<oracle, 3> t;  ///< of its roots, in order
    bool begins_inside;

    explicit cubic_along(random_numbers& random) {
        std::array<oracle, 3> x;
        for (oracle& root : x) root = oracle(random.uniform(-1.5, 1.5));
        std::sort(x.begin(), x.end());
        begins_inside = random.one_in(2);
        f = known_polynomial<X, 3>::with_roots(x, oracle((begins_inside ? 1 : -1) * random.uniform(0.5, 1)));
        for (std::size_t i = 0; i < 3; ++i) t[i] = 3 + 2 * x[i];
    }

    /// Of those within low and high, what is found of them.
    std::size_t roots_within(const oracle& low, const oracle& high) const {
        return static_cast<std::size_t>(
            std::count_if(t.begin(), t.end(), [&](const oracle& root) { return low < root && root < high; }));
    }
    bool is_inside(const oracle& at) const { return (roots_within(oracle(-1000), at) % 2 == 0) == begins_inside; }
};

template <class X>
chord<X> clip_between(double low, double high) {
    return {{true, true, X(low), bound_t<X>(0), true}, {true, true, X(high), bound_t<X>(0), false}};
}

}  // namespace

TEST_CASE_TEMPLATE("polynomial_crossings: the crossings are where the roots are, and as far off as they say", X,
                   strict_double, double_double) {
    random_numbers random(1);
    part_of_bound of_open, of_closed;
    int certain = 0;
    for (int i = 0; i < at_least(3'000); ++i) {
        const cubic_along<X> c(random);
        const double low = random.uniform(1, 3), high = low + random.uniform(0, 2);
        const chord<X> clip = clip_between<X>(low, high);
        const auto open = open_crossings(c.f.number, c.part, clip, {});
        const auto closed = closed_crossings(c.f.number, c.part, clip, {});
        if (!open.certain || !closed.certain) continue;
        ++certain;

        REQUIRE(open.count == c.roots_within(oracle(low), oracle(high)));
        std::size_t first = c.roots_within(oracle(-1000), oracle(low));
        for (std::size_t k = 0; k < open.count; ++k) {
            of_open.add(exactly(open.crossings[k].t) - c.t[first + k], open.crossings[k].error);
            const bool after_even = (first + k) % 2 == 0;
            REQUIRE(open.crossings[k].entering == (after_even != c.begins_inside));
        }

        // The solid: the same roots, and the ends of the clip where the line is inside there.
        std::vector<oracle> ends;
        if (c.is_inside(oracle(low))) ends.push_back(oracle(low));
        for (std::size_t k = 0; k < open.count; ++k) ends.push_back(c.t[first + k]);
        if (c.is_inside(oracle(high))) ends.push_back(oracle(high));
        REQUIRE(closed.count == ends.size());
        for (std::size_t k = 0; k < ends.size(); ++k) {
            of_closed.add(exactly(closed.crossings[k].t) - ends[k], closed.crossings[k].error);
            REQUIRE(closed.crossings[k].entering == (k % 2 == 0));
        }
    }
    CHECK(certain > 2'000);
    CHECK(of_open.largest > 0.001);
    CHECK(of_closed.largest > 0.001);
}

TEST_CASE(
    "polynomial_crossings: of an open surface counts what is within a convex solid, as far as its ends are known") {
    const polynomial<W, 1> f{{W(0), W(-1)}, {}};  // t = 3
    const auto within = [&](double near, double far, bool certain = true) {
        const chord<W> clip{{true, certain, W(near), 0x1p-6, true}, {true, true, W(far), 0x1p-6, false}};
        return open_crossings(f, along, clip, {});
    };
    CHECK((within(2, 4).count == 1 && within(2, 4).certain && within(2, 4).crossings[0].entering));
    CHECK(!within(2, 4, false).certain);
    const chord<W> all = everywhere<W>();
    CHECK(open_crossings(f, along, all, {}, [](const auto&) { return false; }).count == 0);
    CHECK(open_crossings(polynomial<W, 1>{}, along, all, {}).count == 0);  // a line in the surface
    for (const double end : {3 - 0x1p-7, 3 + 0x1p-7}) {
        CHECK((within(end, 5).count == 1 && !within(end, 5).certain));
        CHECK((within(1, end).count == 1 && !within(1, end).certain));
    }
    CHECK((within(3 + 0x3p-7, 5).count == 0 && within(3 + 0x3p-7, 5).certain));
    CHECK((within(1, 3 - 0x3p-7).count == 0 && within(1, 3 - 0x3p-7).certain));
}

TEST_CASE("polynomial_crossings: a walk enters and leaves, in one piece or between two") {
    const walked once({{0, -1, -1, 1}}), at_an_end({{0, -1, -1, 0}, {0, -1, 0, 1}});
    for (const walked& w : {once, at_an_end}) CHECK((w.list.count == 1 && w.at(0, 3, true)));
    const walked through({{-0.5, -1, -1, 0}, {-0.5, 1, 0, 1}});
    CHECK((through.list.count == 2 && through.at(0, 2, true) && through.at(1, 4, false)));
    CHECK((once.list.certain && walked({{1, 0, -1, 1}}).list.certain && walked({{1, 0, -1, 1}}).list.count == 0));
}

TEST_CASE("polynomial_crossings: where pieces meet at zero a walk touches, from outside or from inside") {
    const walked outside({{0, -1, -1, 0}, {0, 1, 0, 1}});
    CHECK((outside.list.count == 2 && outside.at(0, 3, true) && outside.at(1, 3, false)));
    const walked inside({{-0.75, -1, -1, -0.5}, {0, 0.5, -0.5, 0}, {0, -0.5, 0, 1}});
    CHECK((inside.list.count == 3 && inside.at(0, 1.5, true) && inside.at(1, 3, false) && inside.at(2, 3, true)));
}

TEST_CASE("polynomial_crossings: a line in the surface belongs to the solid from where that begins to where it ends") {
    const piece zero{0, 0, -0.5, 0.5};
    const walked in({{-0.5, -1, -1, -0.5}, zero, {0.5, -1, 0.5, 1}}),
        past({{-0.5, -1, -1, -0.5}, zero, {-0.5, 1, 0.5, 1}});
    CHECK((in.list.count == 1 && in.at(0, 2, true) && !in.list.certain));
    CHECK((past.list.count == 2 && past.at(0, 2, true) && past.at(1, 4, false)));
    const piece enters{-0.75, -1, -1, -0.625}, back{0.5, 1, -0.625, -0.5};
    const walked out({enters, back, zero, {-0.5, 1, 0.5, 1}}), stays({enters, back, zero, {0.5, -1, 0.5, 1}});
    CHECK((out.list.count == 2 && out.at(0, 1.5, true) && out.at(1, 4, false)));
    CHECK((stays.list.count == 3 && stays.at(0, 1.5, true) && stays.at(1, 2, false) && stays.at(2, 2, true)));
}

TEST_CASE("polynomial_crossings: a line that cannot be told from one in the surface for long is one for as long") {
    for (const double sign : {-1, 1}) {
        crossing_list<W, 8> list;
        piecewise_walk<W, 8> walk{along, {}, list};
        walk.cross({{W(-0.5), W(-1), W(0), W(0), W(0)}, {}}, W(-1), W(-0.5));
        // Zero at first, and cannot be told from it up to x = -1/4.
        walk.cross({{W(sign * 0x1p-20), W(sign * 0x1p-19), W(0), W(0), W(0)}, {0x1p-21}}, W(-0.5), W(0.5));
        walk.reach(1);
        REQUIRE((list.count >= 1 && list.crossings[0].entering && list.crossings[0].t == W(2)));
        CHECK((list.crossings[0].error < 1e-9 && !list.certain));
    }
    crossing_list<W, 8> list;
    piecewise_walk<W, 8> walk{along, {}, list};
    // Zero at last, and cannot be told from it from x = 1/4 on.
    walk.cross({{W(0x1p-20), W(-0x1p-19), W(0), W(0), W(0)}, {0x1p-21}}, W(-0.5), W(0.5));
    walk.reach(1);
    REQUIRE((list.count == 2 && list.crossings[0].entering && !list.crossings[1].entering));
    CHECK((list.crossings[0].t <= W(3.5) && list.crossings[0].t >= W(2) && list.crossings[1].t == W(4)));
    CHECK((list.crossings[1].error < 1e-9 && !list.certain));
}

TEST_CASE("polynomial_crossings: what two pieces cross where they meet is one crossing, as far off as either") {
    const double off = 0x1p-20;
    for (const double later : {-off, 0.0, off}) {
        crossing_list<W, 8> list;
        piecewise_walk<W, 8> walk{along, {}, list};
        walk.meet({W(0.5), off, 1, 0, 0});
        walk.meet({W(0.5 + later), off, 0, -1, 0});
        walk.reach(-1);
        REQUIRE((list.count == 1 && list.crossings[0].entering && list.crossings[0].t == W(4)));
        const double error = 2 * (std::max(later, 0.0) + off);
        CHECK((list.crossings[0].error >= error && list.crossings[0].error <= error + 0x1p-40));
    }
}

TEST_CASE("polynomial_crossings: a walk is done when it has crossed beyond what is wanted") {
    for (const double from : {-0.25, 0.25}) CHECK(walked({{0, -1, -1, 1}}, from).is_done == (from < 0));
    CHECK(!walked({{1, 0, -1, 1}}, -0.25).is_done);
    for (const double from : {0.125, 0.375}) {  // 1/2 may be 1/4
        crossing_list<W, 8> list;
        piecewise_walk<W, 8> walk{along, {.from = from}, list};
        walk.meet({W(0.5), 0.25, 1, -1, 0});
        walk.reach(-1);
        CHECK(walk.is_done == (from < 0.25));
    }
}

}  // namespace raio::test
