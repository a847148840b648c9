#include <raio/math/frame.hpp>

#include <doctest/doctest.h>

#include "support/subject.hpp"

namespace raio::test {

template <class T>
void check_frame(const vec3<T>& z) {
    const T tolerance = T(8) * std::numeric_limits<T>::epsilon();
    const frame<T> f = frame_about(z);
    REQUIRE(f.z == z);
    for (const vec3<T>& axis : {f.x, f.y}) REQUIRE(std::abs(dot(axis, axis) - T(1)) < tolerance);
    for (const T product : {dot(f.x, f.y), dot(f.y, f.z), dot(f.z, f.x)}) REQUIRE(std::abs(product) < tolerance);
    const vec3<T> right_handed = cross(f.x, f.y) - f.z;
    REQUIRE(dot(right_handed, right_handed) < tolerance * tolerance);

    const vec3<T> v(T(0.5), T(-2), T(3)), back = f.to_world(f.to_local(v)) - v;
    REQUIRE(dot(back, back) < tolerance * tolerance * dot(v, v));
    REQUIRE(f.to_local(z).z == doctest::Approx(1));
}

TEST_CASE_TEMPLATE("frame_about: three unit vectors at right angles, right-handed", T, RAIO_NUMBERS) {
    random_numbers random(4);
    for (int i = 0; i < at_least(10'000); ++i) check_frame(vec3<T>(random.direction()));
}

TEST_CASE_TEMPLATE("frame_about: at the poles and where z changes its sign", T, RAIO_NUMBERS) {
    const T zero(0), one(1), tiny = std::numeric_limits<T>::denorm_min(), small = std::numeric_limits<T>::epsilon();
    for (const T sign : {one, -one}) {
        check_frame<T>({zero, zero, sign});
        check_frame<T>({-zero, zero, sign});
        check_frame<T>({small, -small, sign});
        for (const T z : {zero, -zero, tiny, -tiny, small, -small}) {  // -0 was a bug that others shipped
            check_frame<T>({sign, zero, z});
            check_frame<T>({zero, sign, z});
            check_frame<T>({T(0.6) * sign, T(0.8), z});
        }
    }
}

}  // namespace raio::test
