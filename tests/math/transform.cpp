#include <raio/math/transform.hpp>

#include <doctest/doctest.h>

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

TEST_CASE_TEMPLATE("linear_inverse: as in 75 digits", T, RAIO_NUMBERS) {
    using W = wider_t<T>;
    random_numbers random(11);
    for (int i = 0; i < at_least(1000); ++i) {
        transform<T> map = rotation(vec3<T>(random.direction()), T(2));
        for (vec3<T>* axis : {&map.x, &map.y, &map.z}) *axis *= static_cast<T>(random.log_uniform(1e-6, 1e6));
        map = rotation(vec3<T>(random.direction()), T(1)) * map;
        const transform<oracle> exact_map{vec3<oracle>(map.x), vec3<oracle>(map.y), vec3<oracle>(map.z)};
        const linear_inverse<W> inverse(map);
        const linear_inverse<oracle> exact(exact_map);
        const oracle size = norm1(exact_map.x) + norm1(exact_map.y) + norm1(exact_map.z);
        const oracle condition = size * (norm1(exact.x) + norm1(exact.y) + norm1(exact.z));
        const auto close = [&](const vec3<W>& row, const vec3<oracle>& exact_row) {
            const vec3<oracle> off(exactly(row.x) - exact_row.x, exactly(row.y) - exact_row.y,
                                   exactly(row.z) - exact_row.z);
            const oracle computed = 64 * oracle(unit_roundoff<exact_t<T>>) * condition;
            return norm1(off) <= (computed + oracle(unit_roundoff<W>)) * norm1(exact_row);
        };
        REQUIRE((close(inverse.x, exact.x) && close(inverse.y, exact.y) && close(inverse.z, exact.z)));
    }
}

TEST_CASE_TEMPLATE("linear_inverse: there and back, and sideways for normals", T, RAIO_NUMBERS) {
    const transform<T> shear{{1, 0, 0}, {4, 2, 0}, {0, 0, -8}};
    const linear_inverse<T> inverse(shear);
    CHECK(inverse(shear.vector({1, 2, 3})) == vec3<T>(1, 2, 3));
    // The plane y = 0 stays where it is, the plane x = 0 leans over.
    CHECK(inverse.transposed({0, 1, 0}) == vec3<T>(0, T(0.5), 0));
    CHECK(dot(inverse.transposed({1, 0, 0}), shear.vector({0, 1, 0})) == T(0));
    CHECK(inverse.transposed({0, 0, 1}) == vec3<T>(0, 0, T(-0.125)));
}

TEST_CASE_TEMPLATE("linear_inverse: a singular map has none", T, RAIO_NUMBERS) {
    for (const transform<T>& flat : {scaling<T>({1, 0, 1}), transform<T>{{1, 2, 3}, {2, 4, 6}, {0, 0, 1}}}) {
        CHECK(linear_inverse<T>(flat)(vec3<T>(1, 2, 3)) == vec3<T>(0));
    }
}

static_assert(transform<double>{{0, 1, 0}, {-1, 0, 0}}.point({2, 0, 0}) == vec3<double>(0, 2, 0));

}  // namespace raio::test
