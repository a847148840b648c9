#include <raio/ray.hpp>

#include <doctest/doctest.h>

#include "support/oracle.hpp"
#include "support/random.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("ray: the point at t", T, RAIO_NUMBERS) {
    const ray<T> ray{{1, 2, 3}, {0, -1, T(0.5)}};
    CHECK(ray.at(0) == vec3<T>(1, 2, 3));
    CHECK(ray.at(4) == vec3<T>(1, -2, 5));
    CHECK(ray.at(-2) == vec3<T>(1, 4, 2));
}

TEST_CASE_TEMPLATE("ray: of the point at t no more is lost than a rounding, however much cancels", T, RAIO_NUMBERS) {
    random_numbers random(51);
    const T eps = std::numeric_limits<T>::epsilon();
    for (int i = 0; i < 10'000; ++i) {
        const auto number = [&] { return static_cast<T>(random.uniform(-1, 1)); };
        const T t = number();
        ray<T> ray{{number(), number(), number()}, {number(), number(), number()}};
        if (i % 2 == 0) ray.origin = ray.direction * -t;  // nothing but the rounding of that is left
        for (glm::length_t k = 0; k < 3; ++k) {
            const oracle expected = oracle(ray.origin[k]) + oracle(ray.direction[k]) * oracle(t);
            CHECK(abs(oracle(ray.at(t)[k]) - expected) <= abs(expected) * oracle(eps));
        }
    }
}

static_assert(ray<float>{{0, 0, 1}, {0, 0, -2}}.at(3).z == -5);

}  // namespace raio::test
