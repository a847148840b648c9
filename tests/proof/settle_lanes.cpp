#include <raio/proof/settle_lanes.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <raio/number/simd.hpp>
#include <raio/shape/box.hpp>
#include <raio/shape/sphere.hpp>

#include "support/random.hpp"

namespace raio::test {

namespace {

/// What may be known of a crossing and the window [1, 2].
enum class state { inside, before, beyond, nowhere, open };

struct known_crossing {
    bool exists, certain;
    double t, error;
    state is;
};
const known_crossing known_crossings[] = {
    {true, true, 1.5, 0.25, state::inside},   {true, true, 1.25, 0.25, state::inside},  // as far as the end
    {true, true, 1.75, 0.25, state::inside},  {true, true, 1, 0, state::inside},
    {true, true, 2, 0, state::inside},        {true, true, 0.5, 0.25, state::before},
    {true, true, 2.5, 0.25, state::beyond},   {true, true, 0.75, 0.25, state::open},  // up to the end
    {true, true, 2.25, 0.25, state::open},    {true, true, 1.5, 2, state::open},
    {true, true, 1.5, NAN, state::open},      {true, true, NAN, 0, state::open},
    {false, true, 1.5, 0.25, state::nowhere}, {false, true, NAN, NAN, state::nowhere},
    {true, false, 1.5, 0.25, state::open},    {false, false, 1.5, 0.25, state::open},
    {true, false, 0.5, 0.25, state::open},    {false, false, 2.5, 0.25, state::open},
};

template <class W>
crossing<W> in_every_lane(const known_crossing& k) {
    const mask_t<W> yes = W(0) == W(0), no = !yes;
    return {k.exists ? yes : no, k.certain ? yes : no, W(k.t), W(k.error), no};
}

template <class Mask>
void check_lanes(const Mask& lanes, bool expected) {
    CHECK((expected ? all(lanes) : none(lanes)));
}

}  // namespace

TEST_CASE("sift: what is known of a crossing") {
    using T = float;
    using W = pack<T, 4>;
    for (const known_crossing& k : known_crossings) {
        CAPTURE(&k - known_crossings);
        const detail::sifted<W> found = detail::sift(in_every_lane<W>(k), W(1), W(2));
        check_lanes(found.sure, k.is == state::inside);
        check_lanes(found.open, k.is == state::open);
        if (k.is == state::inside) CHECK((found.low[3] == T(k.t - k.error) && found.high[3] == T(k.t + k.error)));
    }
}

TEST_CASE("sift: of a chord the first in the window") {
    using T = float;
    using W = pack<T, 4>;
    for (const known_crossing& near : known_crossings) {
        for (const known_crossing& far : known_crossings) {
            CAPTURE(&near - known_crossings);
            CAPTURE(&far - known_crossings);
            if (near.is == state::before && far.is == state::nowhere) continue;  // only a far end stands alone
            // Nothing comes behind what is beyond; and what is passed leaves the far end to say it.
            const bool is_passed = near.is == state::before || near.is == state::nowhere;
            const known_crossing& decisive = is_passed ? far : near;
            const chord<W> c{in_every_lane<W>(near), in_every_lane<W>(far)};
            const detail::sifted<W> found = detail::sift(c, W(1), W(2));
            check_lanes(found.sure, decisive.is == state::inside);
            check_lanes(found.open, decisive.is == state::open);
            if (decisive.is == state::inside) {
                CHECK(found.low[3] == T(decisive.t - decisive.error));
                CHECK(found.high[3] == T(decisive.t + decisive.error));
                check_lanes(found.at_near, !is_passed);
            }
        }
    }
}

TEST_CASE("sift: of two chords the first in the window") {
    using T = float;
    using W = pack<T, 4>;
    const known_crossing before{true, true, 0.25, 0.125, state::before}, beyond{true, true, 4, 0.25, state::beyond},
        nowhere{false, true, 1.5, 0.25, state::nowhere}, in_first{true, true, 1.25, 0.125, state::inside};
    const auto chord_of = [](const known_crossing& near, const known_crossing& far) {
        return chord<W>{in_every_lane<W>(near), in_every_lane<W>(far)};
    };
    for (const known_crossing& near : known_crossings) {
        CAPTURE(&near - known_crossings);
        const chord<W> second = chord_of(near, beyond);
        const auto found_behind = [&](const known_crossing& n, const known_crossing& f) {
            return detail::sift(chord_pair<W>{chord_of(n, f), second}, W(1), W(2));
        };
        for (const known_crossing& far : {before, nowhere}) {  // the first chord is passed
            const detail::sifted<W> found = found_behind(far, far), alone = detail::sift(second, W(1), W(2));
            CHECK((bits(found.sure) == bits(alone.sure) && bits(found.open) == bits(alone.open)));
            check_lanes(found.in_first, false);
            if (near.is == state::inside) CHECK((found.low[3] == alone.low[3] && found.high[3] == alone.high[3]));
            if (near.is == state::inside) check_lanes(found.at_near, true);
        }
        const detail::sifted<W> found = found_behind(before, in_first);
        check_lanes(found.sure, true);
        check_lanes(found.in_first, true);
        check_lanes(found.at_near, false);
        CHECK((found.low[3] == T(1.125) && found.high[3] == T(1.375)));
        const detail::sifted<W> out = found_behind(before, beyond);
        CHECK((none(out.sure) && none(out.open)));
        for (const known_crossing& far : known_crossings) {  // whatever the second chord is
            if (far.is != state::open) continue;
            CHECK((none(found_behind(before, far).sure) && all(found_behind(before, far).open)));
        }
    }
}

TEST_CASE("sift: what double finds, for floats, is rounded to them before it counts") {
    using W = pack<double, 4>;
    using F = pack<float, 4>;
    const double u = 0x1p-24;  // half of what lies between two floats above 1
    const auto found = [&](double t, double error, float t_min, float t_max) {
        const mask_t<W> yes(true);
        return detail::sift(crossing<W>{yes, yes, W(t), W(error), yes}, F(t_min), F(t_max));
    };
    CHECK(all(found(1 + 0.5 * u, 0.1 * u, 0, 1).sure));  // it is beyond 1, and rounded to it
    CHECK(all(found(1 - 0.2 * u, 0.1 * u, 1, 2).sure));
    CHECK(none(found(1 + 2 * u, 0.1 * u, 0, 1).open));  // it is the next float
    CHECK(none(found(1 + 2 * u, 0.1 * u, 0, 1).sure));
    CHECK(all(found(1 + u, 0.1 * u, 0, 1).open));  // it may be either of them
    const auto between = found(1 + u, 0.1 * u, 0, 2);
    CHECK(all(between.sure));
    CHECK((between.low[2] == 1 && between.high[2] == 1 + 2 * static_cast<float>(u)));
}

TEST_CASE_TEMPLATE("first_hit, any_hit: nothing is met at either infinity, nor where the window is none", T,
                   RAIO_NUMBERS) {
    using P = pack<T, 4>;
    const box<P> around{vec3<P>(P(-1)), vec3<P>(P(1))};
    const ray<P> hardly_moving{vec3<P>(P(0)), vec3<P>(P(std::numeric_limits<T>::denorm_min()))};
    const ray<P> moving{vec3<P>(P(0)), vec3<P>(P(1))};
    hit_record<P> rec{};
    const P ever(infinity<T>), nan(std::numeric_limits<T>::quiet_NaN());
    CHECK(none(around.hit(hardly_moving, -ever, ever, rec)));
    CHECK(none(around.occluded(hardly_moving, -ever, ever)));
    CHECK((all(around.hit(moving, -ever, ever, rec)) && rec.t[2] == -1));
    CHECK(none(around.hit(moving, nan, ever, rec)));
    CHECK(none(around.occluded(moving, -ever, nan)));
}

TEST_CASE("sift: of doubles it is what is recorded, as far as that is known, and the window is asked of that") {
    using P = pack<double, 4>;
    using W = pack<strict_double, 4>;
    const auto of_plain = [](const auto& plain) {
        return in_every_lane<W>({plain.exists, plain.certain, double(plain.t), double(plain.error), state::open});
    };
    using plain = crossing<strict_double>;
    const auto at = [](double t, double error, bool exists = true, bool certain = true) {
        return plain{exists, certain, strict_double(t), strict_double(error), false};
    };
    const plain some[] = {at(1.5, 0.25),
                          at(1, 0.25),
                          at(2, 9),
                          at(0.5, 0.25),
                          at(2.5, 0.25),
                          at(0.25, 0.5),
                          at(0, 0),
                          at(0, 0x1p-1000),
                          at(1.5, NAN),
                          at(NAN, 0),
                          at(INFINITY, 0),
                          at(1.5, 0, false),
                          at(1.5, 0, true, false),
                          at(1.5, 0, false, false)};
    for (const plain& near : some) {
        for (const plain& far : some) {
            CAPTURE(&near - some);
            CAPTURE(&far - some);
            const chord<strict_double> one{near, far};
            const auto [first, known] = detail::settled_in_window<detail::question::where>(one, 1.0, 2.0);
            const auto found = detail::sift(chord<W>{of_plain(near), of_plain(far)}, P(1), P(2));
            check_lanes(found.sure, known && first.exists);
            check_lanes(found.open, !known);
            if (known && first.exists) CHECK((found.low[2] == double(first.t) && found.high[2] == found.low[2]));
        }
    }
}

TEST_CASE(
    "first_hit, any_hit: what is met near the largest number is met as by a plain ray (two doubles say infinity)") {
    using P = pack<double, 4>;
    const sphere<double> ball{{-0x1.f30600000d86cp+592, 0, 0}, 0x1.b2b2b2b2b2b2bp+707};
    const ray<double> along{{0, 0, 0}, {0x1.b2b2bp-333, 0x1.b2b2b2b2b2b2fp-317, 0}};
    const sphere<P> balls{vec3<P>(ball.center), P(ball.radius)};
    const ray<P> rays{vec3<P>(along.origin), vec3<P>(along.direction)};
    const P zero(0), ever(infinity<double>);
    hit_record<double> rec{};
    hit_record<P> recs{};
    check_lanes(balls.hit(rays, zero, ever, recs), ball.hit(along, 0.0, infinity<double>, rec));
    check_lanes(balls.occluded(rays, zero, ever), ball.occluded(along, 0.0, infinity<double>));
}

TEST_CASE_TEMPLATE(
    "first_hit, any_hit: a box whose faces are farther away than any number is met or missed as by a "
    "plain ray (missed)",
    T, RAIO_NUMBERS) {
    using P = pack<T, 4>;
    constexpr T most = std::numeric_limits<T>::max();
    const P zero(0), far(most / 2), ever(infinity<T>);
    const box<P> boxes{{zero, far, zero}, {far, P(most), far}};
    for (const T slope : {T(0.25), T(1)}) {  // the steeper ray is past the box before it has risen to it
        CAPTURE(slope);
        const ray<P> rays{{zero, P(-most / 4 * 3), zero}, vec3<P>(P(8 * slope), P(8), P(8 * slope))};
        hit_record<P> recs{};
        hit_record<T> rec{};
        const bool hit = detail::in_lane<P>(boxes, 1).hit(detail::in_lane<P>(rays, 1), 0, infinity<T>, rec);
        CHECK(hit == (std::same_as<T, float> && slope < 1));  // double has no wider numbers
        check_lanes(boxes.hit(rays, zero, ever, recs), hit);
        check_lanes(boxes.occluded(rays, zero, ever), hit);
        if (hit) CHECK(recs.t[1] == rec.t);
    }
}

TEST_CASE("retrieved: what a sieve is sure of is found again, or left open") {
    using F = pack<float, 4>;
    using W = pack<strict_double, 4>;
    constexpr detail::question where = detail::question::where, only_where = detail::question::only_where;
    const mask_t<W> yes(true), no(false);
    const F t_min(2);
    const double between_floats = 1 + 0x1p-24;
    const auto at = [&](double t, double error) { return crossing<W>{yes, yes, W(t), W(error), yes}; };
    const detail::sifted<F> near{F(1), F(1.5f), true, false, false, true},
        far{F(2.5f), F(3.5f), true, false, false, false};

    const crossing<W> found = detail::retrieved<where>(near, chord<W>{at(1.25, 0), at(3, 0)}, t_min);
    CHECK((all(found.exists) && found.t[3] == 1.25));
    CHECK(detail::retrieved<where>(far, chord<W>{at(1.25, 0), at(3, 0)}, t_min).t[3] == 3.0);
    const detail::sifted<F> unsure{F(1), F(1.5f), false, false, true, true};
    CHECK(none(detail::retrieved<where>(unsure, chord<W>{at(1.25, 0), at(3, 0)}, t_min).exists));

    const auto left_open = [&](const crossing<W>& c) {
        return none(detail::retrieved<where>(near, chord<W>{c, at(3, 0)}, t_min).exists);
    };
    CHECK(left_open(at(between_floats, 0x1p-28)));  // it may be rounded either way
    CHECK(left_open(at(0.5, 0)));                   // it is not the crossing that the sieve has found
    CHECK(left_open(at(2, 0)));
    CHECK(left_open(crossing<W>{yes, no, W(1.25), W(0), yes}));
    CHECK(left_open(crossing<W>{no, yes, W(1.25), W(0), yes}));

    // Or one number does not know that the near end is passed.
    const auto far_left_open = [&](const crossing<W>& c) {
        return none(detail::retrieved<where>(far, chord<W>{c, at(3, 0)}, t_min).exists);
    };
    CHECK(far_left_open(at(1.25, 1)));
    CHECK(far_left_open(crossing<W>{yes, no, W(1.25), W(0), yes}));
    CHECK(!far_left_open(crossing<W>{no, yes, W(2.25), W(0), yes}));

    // Of a crossing that is the only one, the sieve's error is taken; where there was no sieve, its own.
    const detail::sifted<F> close{F(1), F(1 + 0x1p-6f), true, false, false}, rough{F(1), F(1.5f), true, false, false};
    CHECK(all(detail::retrieved<where>(close, at(1, 1), t_min).exists));
    CHECK(none(detail::retrieved<where>(close, at(between_floats, 0), t_min).exists));
    CHECK(none(detail::retrieved<where>(rough, at(1, 0), t_min).exists));  // too rough for what is recorded of it
    CHECK(none(detail::retrieved<where>(detail::sifted<F>{F(1), F(1), false, false, true}, at(1, 0), t_min).exists));
    CHECK(all(detail::retrieved<only_where>(rough, at(1, 0), t_min).exists));
    CHECK(none(detail::retrieved<only_where>(rough, at(1.25, 1), t_min).exists));
    CHECK(none(detail::retrieved<only_where>(rough, at(INFINITY, 0), t_min).exists));
}

}  // namespace raio::test
