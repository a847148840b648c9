#include <raio/formula/sweep.hpp>

#include <doctest/doctest.h>

#include "support/bounds.hpp"
#include "support/polynomials.hpp"

namespace raio::test {

namespace {

/// b and -s with the coefficients that they stand for, and a place u.
template <class W>
struct extremes {
    known_polynomial<W, 3> b;
    known_polynomial<W, 6> minus_s;
    oracle u;

    root_pair<W> near(const bounded_number<W>& place) const {
        return detail::extremes_near(detail::differentiated<W, 3>{b.number},
                                     detail::differentiated<W, 6>{minus_s.number}, place);
    }
    oracle root() const { return sqrt(max(-minus_s(u), oracle(0))); }

    /// Lets b - sqrt(s) have an extremum at u.
    void turn_there() {
        const oracle slope = -minus_s.derivative(u) / (2 * root());
        b.exact[1] += slope - b.derivative(u);
        b.number = known_polynomial<W, 3>::number_for(b.exact);
    }
};

template <class W>
extremes<W> random_extremes(random_numbers& random) {
    return {known_polynomial<W, 3>::any(random), known_polynomial<W, 6>::any(random), oracle(random.uniform())};
}

}  // namespace

TEST_CASE_TEMPLATE("sweep: both ends at a place that is known exactly", W, strict_double, double_double) {
    random_numbers random(1);
    part_of_bound of_ends;
    int without_root = 0;
    for (int i = 0; i < at_least_a_tenth_of(5'000); ++i) {
        extremes<W> e = random_extremes<W>(random);
        const W u(random.uniform());
        e.u = exactly(u);
        const oracle middle = e.b(e.u), root = e.root();
        const root_pair<W> ends = e.near({u, bound_t<W>(0)});
        of_ends.add(exactly(ends.near.value) - (middle - root), ends.near.error);
        of_ends.add(exactly(ends.far.value) - (middle + root), ends.far.error);
        without_root += root == 0;
    }
    CHECK(without_root > 100);
    CHECK(of_ends.largest > 0.001);
}

TEST_CASE_TEMPLATE("sweep: the end that turns there is off by the square of what the place is off by", W, strict_double,
                   double_double) {
    random_numbers random(2);
    part_of_bound of_end;
    int flat = 0, seen = 0;
    for (int i = 0; i < at_least_a_tenth_of(5'000); ++i) {
        extremes<W> e = random_extremes<W>(random);
        if (e.root() == 0) continue;
        if (random.one_in(4)) {  // a root that all but vanishes
            e.minus_s.exact[0] += -e.minus_s(e.u) * (1 - oracle(random.log_uniform(1e-30, 1)));
            e.minus_s.number = known_polynomial<W, 6>::number_for(e.minus_s.exact);
        }
        e.turn_there();
        const double off = random.log_uniform(1e-12, 1e-3);
        const W place = nearest<W>(e.u + oracle(off * random.uniform(-1, 1)));
        const root_pair<W> ends = e.near({place, bound_t<W>(off)});
        of_end.add(exactly(ends.near.value) - (e.b(e.u) - e.root()), ends.near.error);
        ++seen;
        flat += double(ends.near.error) < off * 1e-2;
    }
    CHECK(flat > seen / 4);
    CHECK(of_end.largest > 0.01);
}

}  // namespace raio::test
