#pragma once

#include <raio/proof/settle.hpp>

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

}  // namespace raio::test
