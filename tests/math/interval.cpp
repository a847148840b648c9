#include <raio/math/interval.hpp>

#include <doctest/doctest.h>

namespace raio::test {

static_assert(interval<float>{}.empty());
static_assert(interval<double>{}.length() == 0);
static_assert(!interval<double>{1, 1}.empty());
static_assert(interval<double>{1, 3}.length() == 2);
static_assert(interval<double>{3, 1}.empty() && interval<double>{3, 1}.length() == 0);
static_assert(interval<double>{1, 3}.contains(1) && interval<double>{1, 3}.contains(3));
static_assert(!interval<double>{1, 3}.contains(0.5) && !interval<double>{1, 3}.contains(3.5));
static_assert(interval<double>{1, 3} == interval<double>{1, 3} && interval<double>{1, 3} != interval<double>{1, 4});

TEST_CASE_TEMPLATE("interval: a NaN is in none, and none has a NaN for an end", T, float, double) {
    const T nan = std::numeric_limits<T>::quiet_NaN();
    CHECK(!interval<T>{0, 1}.contains(nan));
    CHECK(interval<T>{nan, 1}.empty());
    CHECK(interval<T>{0, nan}.empty());
    CHECK(interval<T>{0, nan}.length() == T(0));
    CHECK(interval<T>{-infinity<T>, infinity<T>}.contains(T(7)));
}

}  // namespace raio::test
