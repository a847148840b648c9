#include <raio/math/transform.hpp>

#include <doctest/doctest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "support/oracle.hpp"
#include "support/random.hpp"

namespace raio::test {

template <class T>
bool same(const transform<T>& a, const transform<T>& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.origin == b.origin;
}

TEST_CASE_TEMPLATE("transform: where points and vectors go", T, RAIO_NUMBERS) {
    const vec3<T> p(1, 2, 3);
    CHECK(transform<T>{}.point(p) == p);
    CHECK(translation<T>({5, 6, 7}).point(p) == vec3<T>(6, 8, 10));
    CHECK(translation<T>({5, 6, 7}).vector(p) == p);
    CHECK(scaling<T>({2, -1, 0}).point(p) == vec3<T>(2, -2, 0));
    const transform<T> shear{{1, 0, 0}, {4, 1, 0}, {0, 0, 1}, {0, 0, 1}};
    CHECK(shear.point(p) == vec3<T>(9, 2, 4));
    CHECK(shear.vector(p) == vec3<T>(9, 2, 3));
}

TEST_CASE_TEMPLATE("transform: the right factor goes first", T, RAIO_NUMBERS) {
    const transform<T> move = translation<T>({1, 2, 3}), grow = scaling<T>({2, 3, 4});
    CHECK((move * grow).point({1, 1, 1}) == vec3<T>(3, 5, 7));
    CHECK((grow * move).point({1, 1, 1}) == vec3<T>(4, 9, 16));
    CHECK(same(move * transform<T>{}, move));
    CHECK(same(transform<T>{} * grow, grow));
}

TEST_CASE_TEMPLATE("rotation: counter-clockwise about an axis of any length", T, RAIO_NUMBERS) {
    const T eps = std::numeric_limits<T>::epsilon(), quarter = static_cast<T>(std::numbers::pi / 2);
    const auto close = [&](const vec3<T>& a, const vec3<T>& b) { return length(vec3<T>(a - b)) < 4 * eps * length(b); };
    CHECK(close(rotation<T>({0, 0, 9}, quarter).point({1, 0, 0}), {0, 1, 0}));
    CHECK(close(rotation<T>({0, 0, -9}, quarter).point({1, 0, 0}), {0, -1, 0}));
    CHECK(close(rotation<T>({T(0.01), 0, 0}, quarter).point({5, 1, 0}), {5, 0, 1}));
    CHECK(close(rotation<T>({1, 1, 1}, quarter * 4 / 3).point({1, 2, 3}), {3, 1, 2}));
    CHECK(same(rotation<T>({1, 2, 3}, 0), transform<T>{}));
}

TEST_CASE_TEMPLATE("transform: from GLM's matrices", T, RAIO_NUMBERS) {
    using mat4 = glm::mat<4, 4, T>;
    const vec3<T> p(1, 2, 3);
    CHECK(same(transform<T>(mat4(1)), transform<T>{}));
    CHECK(transform<T>(glm::translate(mat4(1), vec3<T>(5, 6, 7))).point(p) == vec3<T>(6, 8, 10));
    CHECK(transform<T>(glm::scale(mat4(1), vec3<T>(2, -1, 4))).point(p) == vec3<T>(2, -2, 12));
    const mat4 both = glm::rotate(glm::translate(mat4(1), vec3<T>(4, 5, 6)), static_cast<T>(0.3), vec3<T>(1, 2, 2));
    CHECK(length(vec3<T>(transform(both).point(p) - vec3<T>(both * glm::vec<4, T>(p, 1)))) <
          32 * std::numeric_limits<T>::epsilon());
    CHECK(same(transform(glm::mat<4, 3, T>(both)), transform(both)));

    // Of another number type only where that is said.
    CHECK(same(transform<T>(glm::mat4(2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4, 0, 5, 6, 7, 1)),
               translation<T>({5, 6, 7}) * scaling<T>({2, 3, 4})));
    CHECK(same(transform<T>(glm::dmat4(1)), transform<T>{}));
    static_assert(std::convertible_to<mat4, transform<T>>);
    static_assert(!std::convertible_to<glm::mat<4, 4, long double>, transform<T>>);

    // What is not affine.
    CHECK_THROWS_WITH_AS(transform<T>(glm::perspective(T(1), T(1), T(1), T(9))),
                         "raio::transform: a matrix whose last row is not 0 0 0 1", std::invalid_argument);
    for (glm::length_t i = 0; i < 4; ++i) {
        for (const T wrong : {T(2), std::numeric_limits<T>::quiet_NaN()}) {
            mat4 bad(1);
            bad[i][3] = wrong;
            CHECK_THROWS_AS(transform<T>{bad}, std::invalid_argument);
        }
    }
}

static_assert(transform<double>{{0, 1, 0}, {-1, 0, 0}}.point({2, 0, 0}) == vec3<double>(0, 2, 0));

}  // namespace raio::test
