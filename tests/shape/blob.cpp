#include "support/algebraics.hpp"
#include "support/bounds.hpp"
#include "support/cases.hpp"
#include "support/packs.hpp"

namespace raio::test {

template <class T>
inline constexpr bool is_convex<blob<T>> = false;

template <class T>
struct subject<blob<T>> {
    static auto fields(auto& s) { return std::tie(s.components, s.threshold); }

    static double field(const blob<T>& s, const vec3<double>& p) { return s.template field<double>(p); }

    /// The first component is there in any case, whatever the others take away.
    static blob<T> random(random_numbers& random, double size, const vec3<double>& place) {
        blob<T> s{};
        for (std::size_t i = 0; i < (random.one_in(3) ? 2 : 3); ++i) {
            const double strength = random.one_in(3) ? random.uniform(-0.5, 0.5) : random.uniform(0.5, 2);
            s.components[i] = {vec3<T>(place + random.direction() * (size * random.uniform(0, 0.5))),
                               static_cast<T>(size * random.log_uniform(0.1, 0.5)), static_cast<T>(strength)};
            if (random.one_in(2)) s.components[i].axis = vec3<T>(random.direction() * (size * random.uniform(0, 0.5)));
        }
        const double most = field(s, to_double(s.components[0].center));
        if (most < 0.1) return subject::random(random, size, place);
        s.threshold = static_cast<T>(most * random.log_uniform(0.05, 0.9));
        return s;
    }
    static blob<T> lattice(random_numbers& random) {
        blob<T> s{{}, T(random.integer(1, 3)) / 4};
        for (std::size_t i = 0; i < 3; ++i) {
            for_each_number(s.components[i].center, [&](T& x) { x = T(random.integer(-2, 2)); });
            for_each_number(s.components[i].axis, [&](T& x) { x = T(random.one_in(2) ? random.integer(-2, 2) : 0); });
            s.components[i].radius = T(random.integer(0, 3));
            s.components[i].strength = T(random.integer(-1, 2));
        }
        return s;
    }
    static vec3<double> inner_point(const blob<T>& s, random_numbers& random) {
        const auto& first = s.components[0];
        const vec3<double> center = to_double(first.center);
        const auto inside = [&](const vec3<double>& p) { return field(s, p) > static_cast<double>(s.threshold); };
        const vec3<double> p = center + random.direction() * (static_cast<double>(first.radius) * random.uniform());
        return inside(p) ? p : last_yes(center, p, 30, inside);
    }
    /// Where a component begins, as seen from there, its centre, or a silhouette.
    static vec3<double> special_point(const blob<T>& s, const vec3<double>& from, random_numbers& random) {
        const auto& component = s.components[static_cast<std::size_t>(random.integer(0, 1))];
        const vec3<double> center = to_double(component.center), inside = inner_point(s, random);
        const double radius = static_cast<double>(component.radius);
        if (random.one_in(4)) return center + random.perpendicular(center - from) * radius;
        if (random.one_in(4)) return center;
        return grazed_point(s, from, inside, 4 * radius, random);
    }
    static oracle distance(const blob<oracle>& s, const vec3<oracle>& p) {
        vec3<oracle> gradient(oracle(0));
        for (const auto& [center, radius, strength, axis] : s.components) {
            if (!(radius > 0)) continue;
            vec3<oracle> from_center = p - center;
            const oracle axis2 = dot(axis, axis);
            if (axis2 > 0) from_center -= axis * max(oracle(0), min(oracle(1), oracle(dot(from_center, axis) / axis2)));
            const oracle within = 1 - dot(from_center, from_center) / (radius * radius);
            if (within > 0) gradient += from_center * oracle(4 * strength * within / (radius * radius));
        }
        return distance_by_gradient(s.threshold - s.field(p), gradient);
    }
};

TEST_CASE_TEMPLATE("blob: named cases", T, RAIO_NUMBERS) {
    // Where 1 - d^2 / 4 is 3/4, d is 1.
    const T threshold = T(0.5625);
    const auto at = [](T x, T strength = 1) { return metaball<T>{{x, 0, 0}, 2, strength}; };
    const auto of = [&](auto... components) { return blob<T>{{components...}, threshold}; };
    const blob<T> one = of(at(0)), apart = of(at(0), at(5)), twice = of(at(0, T(0.5)), at(0, T(0.5)));
    const blob<T> dent = of(at(0), metaball<T>{{0, 0, 0}, 1, -1}), touching = of(at(-1), at(3));
    const auto along_y = [](T x, T strength = 1) { return metaball<T>{{x, -1, 0}, 2, strength, {0, 3, 0}}; };
    const blob<T> rod = of(along_y(0)), bitten = of(along_y(0), along_y(2, -1)), twin = of(along_y(0), at(5));
    const ray<T> ahead{{-8, 0, 0}, {1, 0, 0}}, down{{0, 9, 0}, {0, -1, 0}};
    check_cases<blob<T>>({
        {"one ball", one, ahead, enters(7)},
        {"one ball, the far side", one, ahead, leaves(9), 7.5},
        {"behind the ray", one, {{-8, 0, 0}, {-1, 0, 0}}, misses},
        {"from inside", one, {{0, 0, 0}, {1, 0, 0}}, leaves(1)},
        {"from the surface inwards", one, {{-1, 0, 0}, {1, 0, 0}}, enters(0)},
        {"from the surface outwards", one, {{1, 0, 0}, {1, 0, 0}}, leaves(0)},
        {"tangent", one, {{-8, 1, 0}, {1, 0, 0}}, enters(8)},
        {"through the field, past the surface", one, {{-8, 1.5, 0}, {1, 0, 0}}, misses},
        {"where the field ends", one, {{-8, 2, 0}, {1, 0, 0}}, misses},
        {"beside the field", one, {{-8, 3, 0}, {1, 0, 0}}, misses},
        {"two that do not meet, the first", apart, ahead, enters(7)},
        {"two that do not meet, the second", apart, ahead, enters(12), 9.5},
        {"two that do not meet, the end", apart, ahead, leaves(14), 12.5},
        {"two halves of one", twice, ahead, enters(7)},
        {"fields that touch", touching, ahead, enters(6)},
        {"fields that touch, the second", touching, ahead, enters(10), 8.5},
        {"a dent inside", dent, ahead, enters(7)},
        {"a capsule's side", rod, ahead, enters(7)},
        {"a capsule's side, out", rod, ahead, leaves(9), 7.5},
        {"a capsule, where its round end begins", rod, {{-8, 2, 0}, {1, 0, 0}}, enters(7)},
        {"a capsule's round end", rod, {{-8, 2.5, 0}, {1, 0, 0}}, enters(8 - std::sqrt(0.75))},
        {"along a capsule, one pole", rod, down, enters(6)},
        {"along a capsule, the other pole", rod, down, leaves(11), 7},
        {"parallel to a capsule, in the surface", rod, {{1, 9, 0}, {0, -1, 0}}, enters(7)},
        {"parallel to a capsule, in the surface, from where that begins", rod, {{1, 2, 0}, {0, -1, 0}}, enters(0)},
        {"parallel to a capsule, in the surface, from within", rod, {{1, 1, 0}, {0, -1, 0}}, leaves(2)},
        {"parallel to a capsule, in the surface, from where that ends", rod, {{1, -1, 0}, {0, -1, 0}}, leaves(0)},
        {"parallel to a capsule, in the surface, behind the ray", rod, {{1, -2, 0}, {0, -1, 0}}, misses},
        {"from within a ball into the surface of a capsule",
         of(along_y(0), metaball<T>{{1, -1, 0}, 2, 1}),
         {{1, 0, 0}, {0, 1, 0}},
         leaves(2)},
        {"beside a capsule, in its field", rod, {{1.5, 9, 0}, {0, -1, 0}}, misses},
        {"beside a capsule, where its field ends", rod, {{2, 9, 0}, {0, -1, 0}}, misses},
        {"above a capsule", rod, {{-8, 3.5, 0}, {1, 0, 0}}, misses},
        {"a capsule and a ball, the ball", twin, ahead, enters(12), 9.5},
        {"a capsule that another takes away from: where that does not reach", bitten, ahead, enters(7)},
        {"a capsule that takes itself away", of(along_y(0), along_y(0, -1)), ahead, misses},
        {"one that takes itself away", of(at(0), at(0, -1)), ahead, misses},
        {"below the threshold", of(at(0, T(0.5))), ahead, misses},
        {"all at the threshold: a point", of(at(0, T(0.5625))), ahead, enters(8)},
        {"all at the threshold: a line, from farther along it (was hit where the ray starts)",
         {{metaball<T>{vec3<T>(12.5), 0.5, 5.25, vec3<T>(5.25)}}, 5.25},
         {vec3<T>(5.25), vec3<T>(5.25)},
         enters(7.25 / 5.25)},
        {"no components", of(), ahead, misses},
        {"a component without radius", of(metaball<T>{{0, 0, 0}, 0, 1}), ahead, misses},
        {"a component of radius below zero", of(at(0), metaball<T>{{0, 0, 0}, -1, 1}), ahead, misses},
        {"threshold zero", {{at(0)}, 0}, ahead, misses},
        {"threshold below zero", {{at(0)}, -1}, ahead, misses},
        {"direction zero", one, {{0, 0, 0}, {0, 0, 0}}, misses},
        {"1e4 sizes away", one, {{T(-20000), 0, 0}, {1, 0, 0}}, enters(19999)},
        {"window that is not a number", one, ahead, misses, nan<T>},
    });
}

/// Two doubles cannot tell at once that it is not in there. Some were hit where the ray starts.
TEST_CASE_TEMPLATE("blob: a line all but in the side of a capsule meets it where that begins, not before", T,
                   RAIO_NUMBERS) {
    const blob<T> rod{{metaball<T>{{0, -1, 0}, 2, 1, {0, 3, 0}}}, T(0.5625)};
    for (int digits = 80; digits <= 120; ++digits) {
        const T inwards = std::ldexp(T(-1.25), -digits);
        const ray<T> up{{1, -1.5, 0}, {inwards, 1, 0}}, down{{1, 2.5, 0}, {inwards, -1, 0}};
        for (const ray<T>& ray : {up, down}) {
            hit_record<T> rec{};
            REQUIRE(rod.hit(ray, T(0), infinity<T>, rec));
            CHECK(std::abs(rec.t - T(0.5)) < T(1e-9));
        }
    }
}

TEST_CASE_TEMPLATE("blob: properties of every shape", T, RAIO_NUMBERS) { check_properties<blob<T>>(); }

TEST_CASE_TEMPLATE("blob: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<blob<T>>();
    check_accuracy<blob<T>>(test_rays / 4, 1e-3, ulp_of_roots);
    check_bounds_of_errors<blob<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("blob: uv and normal", T, RAIO_NUMBERS) {
    const blob<T> ball{{{{{1, 1, 1}, 2}}}, T(0.5625)};
    hit_record<T> rec{};
    REQUIRE(ball.hit({{1, 1, 9}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK(rec.uv.x == doctest::Approx(0.5));
    CHECK(rec.uv.y == doctest::Approx(0.5));
    CHECK(rec.normal == vec3<T>(0, 0, 1));
    REQUIRE(ball.hit({{9, 1, 1}, {-1, 0, 0}}, T(0), infinity<T>, rec));
    CHECK(rec.uv.x == doctest::Approx(0.75));
    CHECK(rec.normal == vec3<T>(1, 0, 0));
}

TEST_CASE_TEMPLATE("blob: from a point of the surface, in any direction", T, RAIO_NUMBERS) {
    check_starts_on_surface([](random_numbers& random) {
        const T y = random.one_in(2) ? 1 : -1, z = random.one_in(2) ? 1 : -1, x = T(random.integer(0, 24)) / 8;
        const metaball<T> bar{{0, 0, 0}, 2, 1, {3, 0, 0}}, left{{-1, 0, 0}, 2}, right{{1, 0, 0}, 2};
        if (random.one_in(2)) return std::pair(blob<T>{{bar}, T(0.25)}, vec3<T>(x, y, z));
        return std::pair(blob<T>{{left, right}, T(0.5)}, random.one_in(2) ? vec3<T>(0, y, 0) : vec3<T>(0, 0, z));
    });
}

TEST_CASE_TEMPLATE("blob: packs, lane by lane", T, RAIO_NUMBERS) { check_lanes_are_plain<blob<T>>(400); }

}  // namespace raio::test
