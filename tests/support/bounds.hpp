#pragma once

#include <raio/proof/refine.hpp>

#include <doctest/doctest.h>

#include "support/oracle.hpp"
#include "support/random.hpp"

/// \file
/// Bounds of errors on their own: each has to hold, and to be no more than a few times the largest error that there is.

namespace raio::test {

/// The largest part of its bound that an error has been.
struct part_of_bound {
    double largest = 0;

    template <class Bound>
    void add(const oracle& error, const Bound& stated) {
        const oracle bound = exactly(stated);
        REQUIRE(abs(error) <= bound);
        if (bound > 0) largest = std::max(largest, rounded<double>(abs(error) / bound));
    }
};

inline vec3<double> some_vector(random_numbers& random) { return random.direction() * random.log_uniform(1e-3, 1e3); }

/// All but perpendicular to `v`: of their product nothing is left but what its terms were rounded by, now and then.
inline vec3<double> all_but_across(const vec3<double>& v, random_numbers& random) {
    return random.perpendicular(v) * random.log_uniform(1e-3, 1e3) + v * random.log_uniform(1e-18, 1);
}

inline vec3<oracle> exactly(const vec3<double_double>& v) { return {exactly(v.x), exactly(v.y), exactly(v.z)}; }

/// The double that each number rounds to, and what is left.
inline std::pair<vec3<double_double>, vec3<double_double>> in_two_parts(const vec3<oracle>& v) {
    const vec3<double> start{v};
    return {vec3<double_double>(start), vec3<double_double>(vec3<double>(v - vec3<oracle>(start)))};
}

/// A ray that has gone to all but a point, as a correction is asked with it, and just where it is.
struct gone_ray {
    nearby_ray<double_double, strict_double> nearby;
    ray<oracle> exact;
};

inline gone_ray gone_close_to(const vec3<oracle>& point, const vec3<double>& origin, const vec3<double>& direction) {
    const auto [start, last] = in_two_parts(point - vec3<oracle>(origin));
    const vec3<double_double> step = start + last;
    return {{vec3<strict_double>(origin), step, vec3<strict_double>(direction)},
            {vec3<oracle>(origin) + exactly(step), vec3<oracle>(direction)}};
}

/// Where a function is zero that is all but zero at 0 and changes over lengths of `scale`: by Newton's method.
template <class Function>
oracle zero_close_to_0(const Function& f, const oracle& scale) {
    const oracle apart = scale * oracle(1e-20);
    oracle t = 0;
    for (int i = 0; i < 4; ++i) t -= f(t) * 2 * apart / (f(oracle(t + apart)) - f(oracle(t - apart)));
    return t;
}

}  // namespace raio::test
