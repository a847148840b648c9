#include <raio/proof/crossing_list.hpp>

#include <doctest/doctest.h>

namespace raio::test {

using detail::question;

namespace {

crossing<double> at(double t, double error = 0, bool entering = true) { return {true, true, t, error, entering}; }

}  // namespace

TEST_CASE("crossing_list: takes over what there is, as far as it has room") {
    crossing_list<double, 3> list;
    list.append(chord<double>{at(1), at(2, 0, false)});
    CHECK((list.count == 2 && list.certain && list.crossings[0].entering && !list.crossings[1].entering));
    list.append(nowhere<double>(true));
    CHECK((list.count == 2 && list.certain));
    list.append(chord<double>{at(3), at(4)});
    CHECK((list.count == 3 && list.crossings[2].t == 3));
    list.append(nowhere<double>(false));
    CHECK(!list.certain);
    for (const bool near : {false, true}) {
        crossing_list<double, 3> one;
        chord<double> c{at(1), at(2)};
        (near ? c.near : c.far).certain = false;
        (near ? c.near : c.far).exists = false;
        one.append(c);
        CHECK((one.count == 1 && !one.certain && one.crossings[0].t == (near ? 2 : 1)));
    }
}

TEST_CASE("crossing_list: two chords as a list") {
    const auto at = [](double t, bool exists, bool certain) { return crossing<double>{exists, certain, t, 0, true}; };
    const chord<double> there{at(1, true, true), at(2, true, true)}, later{at(3, true, true), at(4, true, true)},
        nowhere{at(0, false, true), at(0, false, true)}, unknown{at(0, false, false), at(0, false, false)};
    const auto both = listed(chord_pair<double>{there, later});
    REQUIRE(both.count == 4);
    CHECK(both.certain);
    for (std::size_t i = 0; i < 4; ++i) CHECK(both.crossings[i].t == double(i + 1));
    CHECK((listed(chord_pair<double>{there, nowhere}).count == 2 &&
           listed(chord_pair<double>{nowhere, later}).count == 2));
    CHECK(listed(chord_pair<double>{there, nowhere}).certain);
    CHECK(!listed(chord_pair<double>{there, unknown}).certain);
}

TEST_CASE("crossing_list: roots are crossed as the signs beside them say, and tangents twice") {
    struct sides {
        int before, after;
        std::size_t count;
        bool entering;
    };
    for (const sides& s : {sides{1, -1, 1, true},
                           {-1, 1, 1, false},
                           {0, -1, 1, true},
                           {0, 1, 1, false},
                           {0, 0, 1, false},
                           {1, 1, 2, true},
                           {-1, -1, 2, false}}) {
        crossing_list<double, 4> list;
        polynomial_root<double> root{};
        root.sign_before = s.before, root.sign_after = s.after;
        list.append(at(5, 0.5), root);
        REQUIRE(list.count == s.count);
        CHECK((list.crossings[0].entering == s.entering && list.crossings[0].t == 5));
        if (s.count == 2) CHECK((list.crossings[1].entering != s.entering && list.crossings[1].error == 0.5));
    }
}

TEST_CASE("crossing_list: what cannot be told from the ray's origin is there") {
    crossing_list<double, 4> list;
    const auto asks = [&](bool starts) {
        bool asked = false;
        start_on_surface(list, [&] { return asked = true, starts; });
        return asked;
    };
    CHECK(!asks(true));
    list.append(at(-3, 1)), list.append(at(2, 1));
    CHECK(!asks(true));
    list.append(at(0.5, 0.5));
    CHECK((asks(false) && list.crossings[2].t == 0.5));
    CHECK(asks(true));
    CHECK((list.crossings[0].t == -3 && list.crossings[1].t == 2 && list.crossings[2].t == 0));
}

TEST_CASE("crossing_list: which roots are wanted for the crossings that are") {
    const bounded_number<strict_double> middle(3, 0.125), known(3, 0);
    const given_number<strict_double> half{0.5};
    const auto all = roots_for(every_crossing{}, middle, half);
    CHECK((all.before == -infinity<double> && all.from == infinity<double> && all.to == -infinity<double>));
    for (const bool roughly : {false, true}) {
        const auto roots = roots_for(first_from<float>{2, 4, roughly}, middle, half);
        // t = 2 is at x = -2, but for the error over a half, and t = 4 at 2.
        CHECK((-2.26 < double(roots.before) && double(roots.before) < -2.25));
        CHECK((-1.75 < double(roots.from) && double(roots.from) < -1.74));
        CHECK((roughly ? 1.74 < double(roots.to) && double(roots.to) < 1.75 : double(roots.to) == -infinity<double>));
    }
    // What t rounds to may be 2 if it is a little less.
    CHECK(double(roots_for(first_from<float>{2, 4, false}, known, half).before) < -2 - 0x1p-24);
    const auto without_end = roots_for(first_from<float>{0, infinity<float>, true}, middle, half);
    CHECK((double(without_end.from) < -5 && without_end.to == infinity<double>));
    const auto without_begin = roots_for(first_from<float>{-infinity<float>, 1, false}, middle, half);
    CHECK(!(without_begin.before > -infinity<double>));
    CHECK(!(without_begin.from > -infinity<double>));
}

TEST_CASE("crossing_list: the first in the window, and whether that is settled") {
    crossing_list<strict_double, 4> list;
    for (const double t : {1.0, 3.0, 5.0}) list.append(crossing<strict_double>{true, true, t, 0.25, true});
    const auto settled = [&](float t_min, float t_max) {
        return settled_in_window<question::whether>(list, t_min, t_max);
    };
    const auto first = [&](float t_min, float t_max) { return first_in_window(list, t_min, t_max); };
    CHECK((settled(0, 9).known && settled(0, 9).first.t == 1.0));
    CHECK((settled(2, 9).known && settled(2, 9).first.t == 3.0));  // the one before is passed for certain
    CHECK(!settled(1, 9).known);                                   // of that at the end of the window it is not
    CHECK((settled(6, 9).known && !settled(6, 9).first.exists));
    CHECK((first(1, 9).exists && first(1, 9).t == 1.0));
    CHECK((first(2, 4).exists && first(2, 4).t == 3.0));
    CHECK(!first(3.5f, 4.5f).exists);
    // One that exists is not all that is asked: where it is, to the last bit.
    CHECK(!settled_in_window<question::where>(list, 0.0f, 9.0f).known);
    list.crossings[1].certain = false;
    CHECK((!settled(2, 9).known && !settled(4, 9).known && settled(0, 9).known));  // from there on, not before
    list.certain = false;
    CHECK((!settled(0, 9).known && !settled(6, 9).known));
}

}  // namespace raio::test
