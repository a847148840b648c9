#include <raio/formula/quadric.hpp>

#include <doctest/doctest.h>

#include "support/bounds.hpp"
#include "support/subject.hpp"

namespace raio::test {

using W = strict_double;

namespace {

/// One with a term of the first degree, or with one of the second.
template <class N>
revolved_quadric<N> some_quadric(random_numbers& random) {
    const N c0(random.uniform(-1, 1)), c(random.uniform(-1, 1)), zero(0), v(random.uniform(0.5, 1));
    const vec3<N> axis(random.direction() * random.log_uniform(0.1, 1));
    if (random.one_in(2)) return {axis, v, c0, c, zero, c * c * N(0.25), N(4)};
    return {axis, v, c0, zero, c, -(c0 * c), N(4)};
}

}  // namespace

TEST_CASE("quadric_crossing: the bound of t, from above as well") {
    part_of_bound of_t;
    int seen = 0;
    for (int i = 0; i < at_least(20'000); ++i) {
        // The same numbers in each precision.
        const auto seed = static_cast<std::uint64_t>(i);
        random_numbers random(seed), exactly_so(seed);
        const auto quadric = some_quadric<W>(random);
        const auto exact = some_quadric<oracle>(exactly_so);
        const vec3<double> center = random.direction() * random.uniform(0, 2), inside = random.direction() * 0.5;
        const vec3<double> direction = (center + inside) * random.log_uniform(1e-3, 1e3);
        const vec3<oracle> from(-center), d(direction);
        const auto [ends, hollow] = cross_quadric(quadric, vec3<W>(center), W(norm1(center)), vec3<W>(direction));

        // The level along the line, from its values at -1, 0 and 1.
        const oracle c = exact.level(from), ahead = exact.level(from + d), behind = exact.level(from - d);
        const oracle a = (ahead + behind) / 2 - c, b = (behind - ahead) / 4, square = b * b - a * c;
        if (square <= 0) continue;
        const oracle first = (b - sqrt(square)) / a, second = (b + sqrt(square)) / a;
        if (max(abs(first), abs(second)) * length(d) > 8) continue;  // out of reach: only where it lies is told
        for (const crossing<W>& at : {ends.near, ends.far}) {
            if (!at.certain || !at.exists) continue;
            const oracle t = test::exactly(at.t), root = abs(first - t) < abs(second - t) ? first : second;
            of_t.add(t - root, at.error);
            ++seen;
        }
    }
    CHECK(seen > 10'000);
    CHECK(of_t.largest > 0.02);
}

}  // namespace raio::test
