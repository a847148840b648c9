#include <raio/formula/quadric.hpp>

#include <doctest/doctest.h>

#include "support/bounds.hpp"
#include "support/subject.hpp"

namespace raio::test {

using W = strict_double;
using X = double_double;

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

TEST_CASE("quadric_crossing: the bounds of t and of what is missing, from above as well") {
    part_of_bound of_t, of_missing, of_level, of_place;
    int seen = 0;
    for (int i = 0; i < at_least(20'000); ++i) {
        // The same numbers in each precision.
        const auto seed = static_cast<std::uint64_t>(i);
        random_numbers random(seed), again(seed), exactly_so(seed);
        const auto quadric = some_quadric<W>(random);
        const auto fine = some_quadric<X>(again);
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

            const vec3<X> step = vec3<X>(direction) * X(at.t), place = step - vec3<X>(center);
            const W rounding = W(4 * unit_roundoff<X>) * (norm1(vec3<W>(step)) + norm1(vec3<W>(center)));
            const auto missing = correct_quadric(fine, nearby_point<X>{place, rounding}, vec3<W>(direction), at);
            if (!missing.certain) continue;
            of_missing.add(t + test::exactly(missing.t) - root, missing.error);
            ++seen;

            // From a point so near that it is the level's own error that counts, or, moved, that of the point.
            const auto [start, last] = in_two_parts(from + d * root);
            const vec3<X> nearest = start + last;
            crossing<W> met = at;
            met.error = W(0);
            const auto rest = correct_quadric(fine, nearby_point<X>{nearest, W(0)}, vec3<W>(direction), met);
            const oracle slope = 2 * (a * root - b), level = exact.level(exactly(nearest));
            of_level.add(test::exactly(rest.t) + level / slope, rest.error);
            const vec3<double> moved = random.direction() * 1e-24;
            const nearby_point<X> near_by{nearest + vec3<X>(moved), norm1(vec3<W>(moved))};
            const auto from_there = correct_quadric(fine, near_by, vec3<W>(direction), met);
            of_place.add(test::exactly(from_there.t) + level / slope, from_there.error);
        }
    }
    CHECK(seen > 10'000);
    CHECK((of_t.largest > 0.02 && of_missing.largest > 0.001));
    CHECK((of_level.largest > 1e-4 && of_place.largest > 0.2));
}

}  // namespace raio::test
