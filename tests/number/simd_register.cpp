#include <raio/number/simd_register.hpp>

#include "support/lanes.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("pack: the products of strict doubles stand alone", P, pack<strict_double, 1>,
                   pack<strict_double, 2>, pack<strict_double, 3>, pack<strict_double, 4>, pack<strict_double, 16>) {
    volatile double known_late = 1 + 0x1p-30;
    const P x(known_late), most_of_its_square(1 + 0x1p-29);  // all but 2^-60, which the rounding takes away
    CHECK(all(x * x - most_of_its_square == P(0)));
    CHECK(all(most_of_its_square - x * x == P(0)));
    CHECK(all(x * x + x == P(2 + 3 * 0x1p-30)));
}

}  // namespace raio::test
