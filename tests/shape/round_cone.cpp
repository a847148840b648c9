#include <raio/shape/round_cone.hpp>

#include "support/cases.hpp"

namespace raio::test {

template <class T>
struct subject<round_cone<T>> {
    static auto fields(auto& s) { return std::tie(s.base, s.top, s.base_radius, s.top_radius); }

    /// One in eight is a sphere, one in eight a capsule; of some one sphere is inside of the other.
    static round_cone<T> random(random_numbers& random, double size, const vec3<double>& place) {
        const double height = random.one_in(8) ? 0 : size * random.log_uniform(0.1, 10);
        const T base = static_cast<T>(size * random.log_uniform(0.1, 1)),
                top = static_cast<T>(size * random.log_uniform(0.1, 1));
        return {vec3<T>(place), vec3<T>(place + random.direction() * height), base, random.one_in(8) ? base : top};
    }
    /// One of the spheres that were swept.
    static sphere<double> swept(const round_cone<T>& s, double which) {
        const vec3<double> base = to_double(s.base);
        const double low = static_cast<double>(s.base_radius), high = static_cast<double>(s.top_radius);
        return {base + (to_double(s.top) - base) * which, low + (high - low) * which};
    }
    static vec3<double> inner_point(const round_cone<T>& s, random_numbers& random) {
        const auto [center, radius] = swept(s, random.uniform());
        return center + random.direction() * (random.uniform(0, 0.99) * radius);
    }
    /// On the axis, at a pole, or on the silhouette of one of the spheres inside: at the ends, that is on a seam.
    static vec3<double> special_point(const round_cone<T>& s, const vec3<double>& from, random_numbers& random) {
        const auto [center, radius] = swept(s, random.one_in(2) ? random.integer(0, 1) : random.uniform());
        const vec3<double> axis = to_double(s.top) - to_double(s.base), to_center = center - from;
        const double size = length(axis), sine = radius / length(to_center);
        switch (random.integer(0, 2)) {
            case 0:
                return center;
            case 1:
                if (size > 0) return center + axis * ((random.one_in(2) ? radius : -radius) / size);
                [[fallthrough]];
            default:
                if (!(sine < 1)) return center;
                return center - to_center * (sine * sine) +
                       random.perpendicular(to_center) * (radius * std::sqrt(1 - sine * sine));
        }
    }
    /// From the swept sphere on which the point would lie if it were on the surface.
    static oracle distance(const round_cone<oracle>& s, const vec3<oracle>& p) {
        const vec3<oracle> axis = s.top - s.base, from_base = p - s.base;
        const oracle narrowing = s.base_radius - s.top_radius, apart = dot(axis, axis) - narrowing * narrowing;
        const oracle along = dot(from_base, axis) - s.base_radius * narrowing;
        oracle which = apart > 0 ? oracle(along / apart) : oracle(narrowing < 0 ? 1 : 0);
        which = max(oracle(0), min(oracle(1), which));
        return length(vec3<oracle>(from_base - axis * which)) - (s.base_radius - narrowing * which);
    }
    static round_cone<oracle> grown(round_cone<oracle> s) {
        s.base_radius *= 1 + oracle(1e-40);
        s.top_radius *= 1 + oracle(1e-40);
        return s;
    }
};

TEST_CASE_TEMPLATE("round_cone: named cases", T, float, double) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    // Equal radii are a capsule; then 3 : 4 : 5, whose cone touches the spheres of 1 and 4 where y = -0.6 and 2.6.
    const round_cone<T> pill{{0, -1, 0}, {0, 1, 0}, 1, 1}, pear{{0, 0, 0}, {0, 5, 0}, 1, 4},
        turned{{0, 5, 0}, {0, 0, 0}, 4, 1}, inside{{0, 0, 0}, {0, 1, 0}, 1, 3}, within{{0, 0, 0}, {0, 2, 0}, 1, 3};
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

TEST_CASE_TEMPLATE("round_cone: properties of every shape", T, float, double) { check_properties<round_cone<T>>(); }

TEST_CASE_TEMPLATE("round_cone: as exact arithmetic", T, float, double) {
    check_oracle<round_cone<T>>();
    check_accuracy<round_cone<T>>(normal_run);
    check_bounds_of_errors<round_cone<T>>(normal_run / 5);
}

TEST_CASE_TEMPLATE("round_cone: uv", T, float, double) {
    const round_cone<T> pear{{0, 0, 0}, {0, 0, 5}, 1, 4};
    const auto v = [&](const ray<T>& ray) {
        hit_record<T> rec;
        REQUIRE(pear.hit(ray, T(0), infinity<T>, rec));
        return rec.uv.y;
    };
    CHECK(v({{0, 0, -9}, {0, 0, 1}}) == T(0));
    CHECK(v({{9, 0, T(1.5)}, {-1, 0, 0}}) == T(0.25));
    CHECK(v({{9, 0, 4}, {-1, 0, 0}}) == T(0.5));
    CHECK(v({{0, 0, 19}, {0, 0, -1}}) == T(1));
}

TEST_CASE_TEMPLATE("round_cone: as exact arithmetic, ten million times" * doctest::test_suite("nightly"), T, float,
                   double) {
    check_accuracy<round_cone<T>>(nightly_run);
}

}  // namespace raio::test
