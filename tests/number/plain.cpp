#include <raio/number/plain.hpp>

#include <doctest/doctest.h>

#include <raio/number/bounded_vector.hpp>
#include <raio/number/comparison.hpp>
#include <raio/number/simd.hpp>

namespace raio::test {

static_assert(real<plain<float>> && real<plain<double>> && real<plain<pack<float>>>);
static_assert(sizeof(plain<float>) == sizeof(float) && std::is_trivially_copyable_v<plain<float>>);
static_assert(unit_roundoff<plain<float>> == unit_roundoff<float>);
static_assert(unit_roundoff<plain<pack<double>>> == unit_roundoff<double>);
static_assert(!has_closer_look<plain<float>> && !last_precision<plain<float>> && !only_sieves<plain<pack<float>>>);

TEST_CASE_TEMPLATE("plain: computes what its number computes", T, float, double) {
    const T x = T(1) / 3, y = T(-7) / 9;
    const plain<T> a(x), b(y);
    CHECK(T(a + b) == x + y);
    CHECK(T(a - b) == x - y);
    CHECK(T(a * b) == x * y);
    CHECK(T(a / b) == x / y);
    CHECK(T(-a) == -x);
    CHECK(T(sqrt(a)) == std::sqrt(x));
    CHECK(T(abs(b)) == -y);
    CHECK(T(floor(b)) == -1);
    CHECK(T(copysign(a, b)) == -x);
    CHECK(T(flip(a, b)) == -x);
    CHECK(T(atan2(a, b)) == std::atan2(x, y));
    CHECK(T(min(a, b)) == y);
    CHECK(T(max(a, b)) == x);
    CHECK((b < a && b <= a && a > b && a >= b && a != b && a == a));
    CHECK(T(select(a < b, a, b)) == y);
    CHECK(static_cast<double>(a) == static_cast<double>(x));
    CHECK(T(plain<T>(double_double(0.5))) == T(0.5));
}

TEST_CASE("plain: of packs, lane by lane") {
    using P = pack<float, 4>;
    P x(2), y(3);
    x.set(1, 5);
    const plain<P> a(x), b(y);
    const P sum(a + b), least(min(a, b)), chosen(select(a < b, a, b));
    CHECK((sum[0] == 5 && sum[1] == 8));
    CHECK((least[0] == 2 && least[1] == 3));
    CHECK((chosen[0] == 2 && chosen[1] == 3));
    CHECK(P(plain<P>(infinity<plain<P>>))[3] == infinity<float>);
}

TEST_CASE("plain: what is decided with it is beyond doubt, and its errors are reckoned all the same") {
    using W = plain<float>;
    const given_number<W> a_third{W(1.0f / 3)}, one{W(1)};
    const auto sum = a_third + a_third + a_third;
    const auto is_one = sum >= one;
    CHECK((is_one.certainly == is_one.yes && is_one.possibly == is_one.yes));
    const auto is_nothing = is_positive(sum - sum);
    CHECK((!is_nothing.certainly && !is_nothing.possibly && !is_nothing.yes));
    CHECK(float(sum.error) > 0);
    CHECK(float(sum.error) < 1e-6f);
    const auto anywhere = unknown_number<W>();
    CHECK(is_settled_at(is_one, anywhere));  // though nothing is known of the place
    CHECK(float(detail::doubt_of(anywhere)) == 0);
}

}  // namespace raio::test
