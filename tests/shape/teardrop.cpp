#include <raio/shape/teardrop.hpp>

#include "support/algebraics.hpp"
#include "support/cases.hpp"
#include "support/packs.hpp"

namespace raio::test {

template <class T>
inline constexpr bool is_convex<teardrop<T>> = false;

template <class T>
struct subject<teardrop<T>> {
    static auto fields(auto& s) { return std::tie(s.bottom, s.tip, s.radius); }

    static teardrop<T> random(random_numbers& random, double size, const vec3<double>& place) {
        return {vec3<T>(place), vec3<T>(place + random.axis() * size),
                static_cast<T>(size * random.log_uniform(0.01, 2))};
    }
    static double width(const teardrop<T>& s, double h) {
        return static_cast<double>(s.radius) * std::sqrt(256.0 / 27 * h) * std::pow(1 - h, 1.5);
    }
    static vec3<double> inner_point(const teardrop<T>& s, random_numbers& random) {
        const vec3<double> bottom = to_double(s.bottom), axis = to_double(s.tip) - bottom;
        const double h = random.uniform(0.01, 0.95);
        return bottom + axis * h + random.perpendicular(axis) * (random.uniform(0, 0.99) * width(s, h));
    }
    /// The tip, the bottom, the widest circle, the axis beyond the tip, or a silhouette.
    static vec3<double> special_point(const teardrop<T>& s, const vec3<double>& from, random_numbers& random) {
        const vec3<double> bottom = to_double(s.bottom), tip = to_double(s.tip), axis = tip - bottom;
        switch (random.integer(0, 6)) {
            case 0:
                return tip;
            case 1:
                return bottom;
            case 2:
                return bottom + axis * 0.25 + random.perpendicular(axis) * static_cast<double>(s.radius);
            case 3:
                return bottom + axis * random.uniform(0.9, 1.1);
            default:
                return grazed_point(s, from, inner_point(s, random), length(axis), random);
        }
    }
    static oracle distance(const teardrop<oracle>& s, const vec3<oracle>& at) {
        const vec3<oracle> p = at - s.bottom, axis = s.tip - s.bottom;
        const oracle axis2 = dot(axis, axis), h = dot(p, axis) / axis2, below = 1 - h, r2 = s.radius * s.radius;
        const vec3<oracle> beside = p - axis * h;
        const oracle f = 27 * dot(beside, beside) - 256 * r2 * h * below * below * below;
        const vec3<oracle> gradient =
            beside * oracle(54) - axis * oracle(256 * r2 * below * below * (1 - 4 * h) / axis2);
        return distance_by_gradient(f, gradient);
    }
};

TEST_CASE_TEMPLATE("teardrop: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const teardrop<T> drop{{0, 0, 0}, {0, 0, 4}, 1}, flat{{0, 0, 0}, {0, 0, 1}, 8};
    const ray<T> ahead{{5, 0, 1}, {-1, 0, 0}}, down{{0, 0, 9}, {0, 0, -1}};
    check_cases<teardrop<T>>({
        {"where it is widest", drop, ahead, enters(4)},
        {"where it is widest, the far side", drop, ahead, leaves(6), 4.5},
        {"behind the ray", drop, {{5, 0, 1}, {1, 0, 0}}, misses},
        {"from inside", drop, {{0, 0, 1}, {1, 0, 0}}, leaves(1)},
        {"the tip, along the axis", drop, down, enters(5)},
        {"the bottom, along the axis", drop, {{0, 0, -3}, {0, 0, 1}}, enters(3)},
        {"in at the bottom, out at the tip", drop, {{0, 0, -3}, {0, 0, 1}}, leaves(7), 3.5},
        {"from inside to the tip", drop, {{0, 0, 1}, {0, 0, 1}}, leaves(3)},
        {"from the tip inwards", drop, {{0, 0, 4}, {0, 0, -1}}, enters(0)},
        {"from the tip outwards", drop, {{0, 0, 4}, {0, 0, 1}}, leaves(0)},
        {"across the tip", drop, {{5, 0, 4}, {-1, 0, 0}}, enters(5)},
        {"across the tip, obliquely", drop, {{5, 5, 9}, {-1, -1, -1}}, enters(5)},
        {"one number beyond the tip", drop, {{5, 0, 4 + 4 * eps}, {-1, 0, 0}}, misses},
        {"across the bottom", drop, {{5, 0, 0}, {-1, 0, 0}}, enters(5)},
        {"below the bottom", drop, {{5, 0, -eps}, {-1, 0, 0}}, misses},
        {"tangent where it is widest", drop, {{1, 0, 9}, {0, 0, -1}}, enters(8)},
        {"tangent where it is widest, across", drop, {{1, 5, 1}, {0, -1, 0}}, enters(5)},
        {"one number beyond the tangent", drop, {{1 + eps, 0, 9}, {0, 0, -1}}, misses},
        {"beside it, in the hollow under the tip", drop, {{5, 0, 3}, {-1, 0, T(0.25)}}, misses},
        {"flat and wide", flat, {{9, 0, T(0.25)}, {-1, 0, 0}}, enters(1)},
        {"upside down", {{0, 0, 4}, {0, 0, 0}, 1}, {{5, 0, 3}, {-1, 0, 0}}, enters(4)},
        {"elsewhere", {{1, 2, 3}, {1, 2, 7}, 1}, {{6, 2, 4}, {-1, 0, 0}}, enters(4)},
        {"1e4 sizes away", drop, {{T(65536), 0, 1}, {-1, 0, 0}}, enters(65535)},
        {"radius zero", {{0, 0, 0}, {0, 0, 4}, 0}, ahead, misses},
        {"radius below zero", {{0, 0, 0}, {0, 0, 4}, -1}, ahead, misses},
        {"an infinite radius", {{0, 0, 0}, {0, 0, 4}, infinity<T>}, ahead, misses},
        {"a tip at infinity", {{0, 0, 0}, {0, 0, infinity<T>}, 1}, ahead, misses},
        {"a bottom at infinity", {{0, 0, -infinity<T>}, {0, 0, 4}, 1}, ahead, misses},
        {"a tip that is no number", {{0, 0, 0}, {0, nan<T>, 4}, 1}, ahead, misses},
        {"bottom is tip", {{0, 0, 1}, {0, 0, 1}, 1}, ahead, misses},
        {"direction zero", drop, {{0, 0, 1}, {0, 0, 0}}, misses},
        {"window that is not a number", drop, ahead, misses, nan<T>},
    });
}

TEST_CASE("teardrop: its tip, from far away, where its bounds end as well (beyond them)") {
    check_cases<teardrop<float>>(
        {{"across",
          {{0, 0, 0}, {-0x1.698198p-3f, 0, 0}, 0x1.5117a2p+0f},
          {{-0x1.412004p+11f, 0x1.1819p+3f, 0x1.0ee888p+8f}, {0x1.411a5ep+11f, -0x1.1819p+3f, -0x1.0ee888p+8f}},
          enters(1)}});
    check_cases<teardrop<double>>({{"along its axis",
                                    {{0, 0, 0}, {0x1.2671eb15fd06fp-8, 0, 0}, 0x1.8047d80d5d934p-8},
                                    {{0x1.7d34a7f4fdbe4p+5, -0x1.5d4043de4d8fcp-24, 0x1.513ffaa1f753p-25},
                                     {-0x1.7d2b746623746p+5, 0x1.5d4043de4d8fcp-24, -0x1.513ffaa1f753p-25}},
                                    enters(0x1.ffffffff56336p-1)}});
}

TEST_CASE_TEMPLATE("teardrop: properties of every shape", T, RAIO_NUMBERS) { check_properties<teardrop<T>>(); }

TEST_CASE_TEMPLATE("teardrop: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<teardrop<T>>();
    // Of a double that is aimed at the tip, 106 bits cannot tell on which side it passes.
    check_accuracy<teardrop<T>>(test_rays, 1.0 / 40, ulp_of_roots);
    check_bounds_of_errors<teardrop<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("teardrop: uv and normal", T, RAIO_NUMBERS) {
    const teardrop<T> drop{{1, 1, 1}, {1, 1, 5}, 1};
    const auto hit = [&](const ray<T>& ray) {
        hit_record<T> rec{};
        REQUIRE(drop.hit(ray, T(0), infinity<T>, rec));
        return rec;
    };
    CHECK(hit({{9, 1, 2}, {-1, 0, 0}}).uv == vec2<T>(0, 0.25));
    CHECK(hit({{1, 9, 2}, {0, -1, 0}}).uv == vec2<T>(0.25, 0.25));
    CHECK(hit({{9, 1, 2}, {-1, 0, 0}}).normal == vec3<T>(1, 0, 0));
    CHECK(hit({{1, 1, -9}, {0, 0, 1}}).normal == vec3<T>(0, 0, -1));
    CHECK(hit({{1, 1, -9}, {0, 0, 1}}).uv.y == T(0));
    // The tip has no normal of its own.
    CHECK(hit({{1, 1, 9}, {0, 0, -1}}).normal == vec3<T>(0, 0, 1));
    CHECK(hit({{9, 1, 5}, {-1, 0, 0}}).normal == vec3<T>(1, 0, 0));
    CHECK(hit({{9, 1, 5}, {-1, 0, 0}}).uv.y == T(1));
}

TEST_CASE_TEMPLATE("teardrop: packs, lane by lane", T, RAIO_NUMBERS) { check_lanes_are_plain<teardrop<T>>(400); }

}  // namespace raio::test
