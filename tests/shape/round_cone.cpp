#include <raio/shape/round_cone.hpp>

#include "support/cases.hpp"
#include "support/round_cones.hpp"
#include "support/sampling.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("round_cone: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    // Equal radii are a capsule; then 3 : 4 : 5, whose cone touches the spheres of 1 and 4 where y = -0.6 and 2.6.
    const round_cone<T> pill{{0, -1, 0}, {0, 1, 0}, 1, 1}, pear{{0, 0, 0}, {0, 5, 0}, 1, 4},
        turned{{0, 5, 0}, {0, 0, 0}, 4, 1}, inside{{0, 0, 0}, {0, 1, 0}, 1, 3}, within{{0, 0, 0}, {0, 2, 0}, 1, 3},
        slanted{{1, 2, 3}, {6, 14, 3}, 1, 6};
    const auto along_x = [](T y) { return ray<T>{{-9, y, 0}, {1, 0, 0}}; };
    check_cases<round_cone<T>>({
        {"a capsule, the side", pill, {{0, 0, 5}, {0, 0, -1}}, enters(4)},
        {"a capsule, the pole", pill, {{0, 5, 0}, {0, -1, 0}}, enters(3)},
        {"a capsule, parallel to the axis, in the surface", pill, {{1, 5, 0}, {0, -1, 0}}, enters(4)},
        {"a capsule, one number beyond the surface", pill, {{1 + eps, 5, 0}, {0, -1, 0}}, misses},
        {"pear, upper pole", pear, {{0, 20, 0}, {0, -1, 0}}, enters(11)},
        {"pear, lower pole", pear, {{0, -9, 0}, {0, 1, 0}}, enters(8)},
        {"pear, in at one pole, out at the other", pear, {{0, 20, 0}, {0, -1, 0}}, leaves(21), 12},
        {"pear, the side", pear, along_x(1), enters(7)},  // rho = 1.25 + 0.75 y
        {"pear, the side, out", pear, along_x(1), leaves(11), 8},
        {"pear, the upper sphere", pear, along_x(5), enters(5)},
        {"pear, the lower sphere", pear, {{-9, 0, 0.0}, {1, 0, 0}}, enters(7.75)},
        {"pear, from inside", pear, {{0, 1, 0}, {1, 0, 0}}, leaves(2)},
        {"pear, from the side inwards", pear, {{2, 1, 0}, {-1, 0, 0}}, enters(0)},
        {"pear, from the side outwards", pear, {{2, 1, 0}, {1, 0, 0}}, leaves(0)},
        {"of a 5, 12, 13, from the side inwards", slanted, {{0, 3, 3}, {2, -1, 1}}, enters(0)},
        {"of a 5, 12, 13, from the side outwards", slanted, {{0, 3, 3}, {-2, 1, -1}}, leaves(0)},
        {"pear, behind the ray", pear, {{9, 1, 0}, {1, 0, 0}}, misses},
        {"pear, tangent to the side", pear, {{2, 1, 5}, {0, 0, -1}}, enters(5)},
        {"pear, one number beyond the tangent", pear, {{2 + 2 * eps, 1, 5}, {0, 0, -1}}, misses},
        {"pear, along a generator", pear, {{-1, -3, 0}, {3, 4, 0}}, enters(0.6)},
        {"pear, beside a generator", pear, {{-1 + 4 * eps, -3, 0}, {3, 4, 0}}, misses},
        {"pear, where the other nappe would be", pear, along_x(-3), misses},
        {"pear, under the lower pole", pear, along_x(-1 - eps), misses},
        {"pear, turned around", turned, along_x(1), enters(7)},
        {"touching from inside: the larger sphere", within, {{0, 2, 9}, {0, 0, -1}}, enters(6)},
        {"touching from inside: the point", within, {{0, -5, 0}, {0, 1, 0}}, enters(4)},
        {"one in the other: the larger sphere", inside, {{0, 1, 9}, {0, 0, -1}}, enters(6)},
        {"one in the other, turned around", {{0, 1, 0}, {0, 0, 0}, 3, 1}, {{0, 1, 9}, {0, 0, -1}}, enters(6)},
        {"base is top: a sphere", {{0, 0, 0}, {0, 0, 0}, 1, 1}, {{0, 0, 5}, {0, 0, -1}}, enters(4)},
        {"base is top: the larger sphere", {{0, 0, 0}, {0, 0, 0}, 1, 2}, {{0, 0, 5}, {0, 0, -1}}, enters(3)},
        {"a radius of zero", {{0, 0, 0}, {0, 5, 0}, 0, 4}, along_x(5), misses},
        {"a radius below zero", {{0, 0, 0}, {0, 5, 0}, -1, 4}, along_x(5), misses},
        {"direction zero", pear, {{0, 1, 0}, {0, 0, 0}}, misses},
        {"direction of length 1e20", pear, {{-9, 1, 0}, {0x1p66, 0, 0}}, enters(7 * 0x1p-66)},
        {"window between the crossings", pear, along_x(1), misses, 8, 10},
        {"window that is not a number", pear, along_x(1), misses, nan<T>},
    });
}

TEST_CASE_TEMPLATE("round_cone: properties of every shape", T, RAIO_NUMBERS) { check_properties<round_cone<T>>(); }

TEST_CASE_TEMPLATE("round_cone: from a point of the surface, in any direction", T, RAIO_NUMBERS) {
    check_starts_on_surface([](random_numbers& random) {
        // Of a 3, 4, 5 along an axis of the coordinates, and of a 5, 12, 13 that is slanted.
        const T r = static_cast<T>(random.integer(1, 1 << 18)), k = static_cast<T>(random.integer(0, 2));
        const round_cone<T> upright{{0, 0, 0}, {0, 5 * r, 0}, r, 4 * r},
            slanted{{r, 2 * r, 0}, {6 * r, 14 * r, 0}, r, 6 * r};
        return random.one_in(2) ? std::pair(upright, vec3<T>(r * (T(1.25) + T(0.75) * k), r * k, 0))
                                : std::pair(slanted, vec3<T>(0, (3 + k) * r, 0));
    });
}

TEST_CASE_TEMPLATE("round_cone: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<round_cone<T>>();
    check_accuracy<round_cone<T>>(test_rays);
    check_bounds_of_errors<round_cone<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("round_cone: area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    const double pi = std::numbers::pi;
    const round_cone<T> pear{{1, 2, 3}, {1, 2, 8}, 1, 4};  // of a 3, 4, 5
    CHECK(pear.area() == doctest::Approx(0.8 * pi + 16 * pi + 51.2 * pi));
    CHECK(round_cone<T>{{1, 2, 3}, {3, 3, 5}, 2, 2}.area() == doctest::Approx(28 * pi));
    CHECK(round_cone<T>{{0, 0, 0}, {0, 0, 1}, 1, 3}.area() == doctest::Approx(36 * pi));
    CHECK(round_cone<T>{{0, 0, 0}, {0, 0, 1}, 3, 1}.area() == doctest::Approx(36 * pi));
    CHECK(round_cone<T>{{1, 1, 1}, {1, 1, 1}, 3, 3}.area() == doctest::Approx(36 * pi));
    const auto check = [](const round_cone<T>& shape) {
        const double r = double(shape.base_radius), s = double(shape.top_radius);
        const vec3<double> axis = to_double(shape.top) - to_double(shape.base);
        const double size = length(axis), sine = std::clamp(size > 0 ? (s - r) / size : 1, -1.0, 1.0);
        const double low = 2 * r * r * (1 - sine), side = (r + s) * size * (1 - sine * sine),
                     high = 2 * s * s * (1 + sine), all = low + side + high;
        check_sampling(shape, [=](const hit_record<T>& rec) {
            const double height = double(rec.uv.y) * (size + r + s) - r, seam = -sine * r, rim = size - sine * s;
            double below = low + side + 2 * s * (height - rim);
            if (height < rim) {
                const double which = (height - seam) / (rim - seam);
                below = low + side * which * (2 * r + (s - r) * which) / (r + s);
            }
            if (height < seam) below = 2 * r * (height + r);
            return vec2<T>(rec.uv.x, T(below / all));
        });
    };
    check(pear);
    check({{1, 2, 3}, {3, 3, 5}, 2, 1});
    check({{1, 2, 3}, {3, 3, 5}, 2, 2});
    check({{1, 1, 1}, {1, 1, 1}, 3, 3});
}

TEST_CASE_TEMPLATE("round_cone: uv", T, RAIO_NUMBERS) {
    const round_cone<T> pear{{0, 0, 0}, {0, 0, 5}, 1, 4};
    const auto v = [&](const ray<T>& ray) {
        hit_record<T> rec{};
        REQUIRE(pear.hit(ray, T(0), infinity<T>, rec));
        return rec.uv.y;
    };
    CHECK(v({{0, 0, -9}, {0, 0, 1}}) == T(0));
    CHECK(v({{9, 0, T(1.5)}, {-1, 0, 0}}) == T(0.25));
    CHECK(v({{9, 0, 4}, {-1, 0, 0}}) == T(0.5));
    CHECK(v({{0, 0, 19}, {0, 0, -1}}) == T(1));
}

}  // namespace raio::test
