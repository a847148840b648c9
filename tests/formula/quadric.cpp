#include <raio/formula/quadric.hpp>

#include <doctest/doctest.h>

#include "support/bounds.hpp"
#include "support/subject.hpp"

namespace raio::test {

using W = strict_double;

TEST_CASE("quadric: the bound of t, from above as well") {
    part_of_bound of_t;
    int seen = 0;
    random_numbers random(1);
    const auto number = [](double x) { return given_number<W>{W(x)}; };
    for (int i = 0; i < at_least(20'000); ++i) {
        const double c0 = random.uniform(-1, 1), c = random.uniform(-1, 1);
        const vec3<double> axis = random.direction() * random.log_uniform(0.1, 1);
        const vec3<double> center = random.direction() * random.uniform(0, 2), inside = random.direction() * 0.5;
        const vec3<double> direction = (center + inside) * random.log_uniform(1e-3, 1e3);
        const auto given = [](const vec3<double>& v) { return rounded_vector<W, 1>{W(v.x), W(v.y), W(v.z)}; };
        // One with a term of the first degree, or with one of the second.
        const bool is_first = random.one_in(2);
        const given_vector<W> d{W(direction.x), W(direction.y), W(direction.z)};
        const zero_number<W> none;
        const auto found =
            is_first ? cross_quadric(d, given(center), given(axis),
                                     turned_conic{number(c0), number(c), none, number(c) * number(c)}, number(4))
                     : cross_quadric(d, given(center), given(axis),
                                     turned_conic{number(c0), none, number(c), -(number(c0) * number(c))}, number(4));

        // rho^2 - c0 - 2 c1 h - c2 h^2 along the line, from its values at -1, 0 and 1.
        const vec3<oracle> from(-center), step(direction), a(axis);
        const auto level = [&](const vec3<oracle>& p) {
            const oracle h = dot(p, a) / dot(a, a), rho2 = dot(p, p) - h * h * dot(a, a);
            return rho2 - oracle(c0) - (is_first ? 2 * oracle(c) * h : oracle(c) * h * h);
        };
        const oracle here = level(from), ahead = level(from + step), behind = level(from - step);
        const oracle of_2 = (ahead + behind) / 2 - here, of_1 = (behind - ahead) / 4;
        const oracle square = of_1 * of_1 - of_2 * here;
        if (square <= 0) continue;
        const oracle first = (of_1 - sqrt(square)) / of_2, second = (of_1 + sqrt(square)) / of_2;
        if (max(abs(first), abs(second)) * length(step) > 8) continue;  // out of reach: only where it lies is told
        for (const crossing<W>& at : {found.ends.near, found.ends.far}) {
            if (!at.certain || !at.exists) continue;
            const oracle t = exactly(at.t), root = abs(first - t) < abs(second - t) ? first : second;
            of_t.add(t - root, at.error);
            ++seen;
        }
    }
    CHECK(seen > 10'000);
    CHECK(of_t.largest > 0.02);
}

}  // namespace raio::test
