#include <raio/math/bezier.hpp>

#include <doctest/doctest.h>

#include "support/oracle.hpp"
#include "support/random.hpp"

namespace raio::test {

TEST_CASE("bezier_polynomial: named cases") {
    const auto coefficients = [](double a, double b, double c, double d) {
        return bezier_polynomial<double>(a, b, c, d).coefficient;
    };
    CHECK(coefficients(5, 5, 5, 5) == std::array<double, 4>{5, 0, 0, 0});
    CHECK(coefficients(5, 6, 7, 8) == std::array<double, 4>{5, 3, 0, 0});
    CHECK(coefficients(0, 0, 1, 3) == std::array<double, 4>{0, 0, 3, 0});
    CHECK(coefficients(-1, -1, -1, 0) == std::array<double, 4>{-1, 0, 0, 1});
}

TEST_CASE_TEMPLATE("bezier_from_start: de Casteljau's mean of means, within the error that it states", W, strict_double,
                   double_double) {
    random_numbers random(51);
    for (int i = 0; i < at_least(1000); ++i) {
        const double far = random.log_uniform(1, 1e9);
        std::array<double, 4> v;
        for (double& x : v) x = far + random.uniform(-1, 1);
        const auto p = bezier_from_start<W>(v[0], v[1], v[2], v[3]);
        for (const double u : {0.0, 0.25, random.uniform(), 1.0}) {
            std::array<oracle, 4> mean;
            for (std::size_t k = 0; k < 4; ++k) mean[k] = v[k];
            for (std::size_t n = 3; n > 0; --n) {
                for (std::size_t k = 0; k < n; ++k) mean[k] += (mean[k + 1] - mean[k]) * oracle(u);
            }
            oracle value = 0, error = 0, power = 1;
            for (std::size_t k = 0; k < 4; ++k, power *= oracle(u)) {
                value += exactly(p.coefficient[k]) * power;
                error += exactly(p.error[k]) * power;
            }
            REQUIRE(abs(value - (mean[0] - oracle(v[0]))) <= error + oracle(1e-40) * far);
        }
    }
}

}  // namespace raio::test
