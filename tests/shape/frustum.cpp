#include <raio/shape/frustum.hpp>

#include "support/cases.hpp"
#include "support/frusta.hpp"
#include "support/sampling.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("frustum: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    // From radius 3 to radius 1 at 45 degrees: its apex would be at a height of 3.
    const frustum<T> lamp{{0, 0, 0}, {0, 2, 0}, 3, 1}, even{{0, -1, 0}, {0, 1, 0}, 1, 1},
        spike{{0, 0, 0}, {0, 3, 0}, 3, 0};
    const ray<T> ahead{{0, 1, 5}, {0, 0, -1}};
    check_cases<frustum<T>>({
        {"the side", lamp, ahead, enters(3)},
        {"the side, from below", lamp, {{2.5, -1, 0}, {0, 1, 0}}, enters(1)},
        {"out through the side", lamp, {{2.5, -1, 0}, {0, 1, 0}}, leaves(1.5), 1.25},
        {"behind the ray", lamp, {{0, 1, 5}, {0, 0, 1}}, misses},
        {"from inside to the side", lamp, {{0, 1, 0}, {1, 0, 0}}, leaves(2)},
        {"from inside to the top", lamp, {{0.5, 1, 0}, {0, 1, 0}}, leaves(1)},
        {"from inside to the base", lamp, {{2, 0.5, 0}, {0, -1, 0}}, leaves(0.5)},
        {"along the axis", lamp, {{0, 5, 0}, {0, -1, 0}}, enters(3)},
        {"along the axis, from below", lamp, {{0, -5, 0}, {0, 1, 0}}, enters(5)},
        {"parallel to the axis, onto the side", lamp, {{2, 5, 0}, {0, -1, 0}}, enters(4)},
        {"parallel to the axis, outside", lamp, {{4, 5, 0}, {0, -1, 0}}, misses},
        {"parallel to the axis, at the lower rim", lamp, {{3, 5, 0}, {0, -1, 0}}, enters(5)},
        {"parallel to the axis, one number beyond the rim", lamp, {{3 + 2 * eps, 5, 0}, {0, -1, 0}}, misses},
        {"parallel to a generator, inside (a = 0)", lamp, {{2, -1, 0}, {-1, 1, 0}}, enters(1)},
        {"parallel to a generator, inside, later", lamp, {{2, -1, 0}, {-1, 1, 0}}, leaves(3), 2},
        {"parallel to a generator, onto the other side", lamp, {{5, -1, 0}, {-3, 3, 0}}, misses},
        {"parallel to a generator, through the other side", lamp, {{1, -1, 0}, {1, 1, 0}}, enters(1)},
        {"parallel to a generator, through the other side, later", lamp, {{1, -1, 0}, {1, 1, 0}}, leaves(1.5), 1.25},
        {"along a generator", lamp, {{4, -1, 0}, {-1, 1, 0}}, enters(1)},
        {"along a generator, later", lamp, {{4, -1, 0}, {-1, 1, 0}}, leaves(3), 2},
        {"one number from a generator, outside", lamp, {{4 + 4 * eps, -1, 0}, {-1, 1, 0}}, misses},
        {"where the other nappe would be", lamp, {{0, 4, 5}, {0, 0, -1}}, misses},
        {"through the other nappe and in at the top", lamp, {{2, 5, 0}, {-1, -2, 0}}, enters(1.5)},
        {"along the base", lamp, {{-5, 0, 0}, {1, 0, 0}}, enters(2)},
        {"along the top", lamp, {{-5, 2, 0}, {1, 0, 0}}, enters(4)},
        {"one number above the top", lamp, {{-5, 2 + 2 * eps, 0}, {1, 0, 0}}, misses},
        {"touches the lower rim", lamp, {{3, -1, 1}, {0, 1, -1}}, enters(1)},
        {"touches the upper rim", lamp, {{0, 3, 0}, {1, -1, 0}}, enters(1)},
        {"tangent to the side", lamp, {{2, 1, 5}, {0, 0, -1}}, enters(5)},
        {"one number beyond the tangent", lamp, {{2 + 2 * eps, 1, 5}, {0, 0, -1}}, misses},
        {"from the side inwards", lamp, {{2, 1, 0}, {-1, 0, 0}}, enters(0)},
        {"from the side outwards", lamp, {{2, 1, 0}, {1, 0, 0}}, leaves(0)},
        {"from the side outwards, later", lamp, {{2, 1, 0}, {1, 0, 0}}, misses, 0x1p-60},
        {"base and top exchanged", {{0, 2, 0}, {0, 0, 0}, 1, 3}, ahead, enters(3)},
        {"equal radii, the side", even, {{0, 0, 5}, {0, 0, -1}}, enters(4)},
        {"equal radii, parallel to the axis (0 / 0)", even, {{0.5, 5, 0.5}, {0, -1, 0}}, enters(4)},
        {"equal radii, parallel to the axis, outside (0 / 0)", even, {{2, 5, 0}, {0, -1, 0}}, misses},
        {"equal radii, parallel to the axis, on the surface (0 / 0)", even, {{1, 5, 0}, {0, -1, 0}}, enters(4)},
        {"equal radii, parallel to the axis, one number beyond", even, {{1 + eps, 5, 0}, {0, -1, 0}}, misses},
        {"top radius zero, onto the apex", spike, {{0, 5, 0}, {0, -1, 0}}, enters(2)},
        {"top radius zero, across the apex", spike, {{-5, 3, 0}, {1, 0, 0}}, enters(5)},
        {"both radii zero", {{0, 0, 0}, {0, 2, 0}, 0, 0}, ahead, misses},
        {"a radius below zero", {{0, 0, 0}, {0, 2, 0}, 3, -1}, ahead, misses},
        {"base is top", {{0, 0, 0}, {0, 0, 0}, 3, 1}, ahead, misses},
        {"direction zero", lamp, {{0, 1, 0}, {0, 0, 0}}, misses},
        {"first crossing before the window", lamp, ahead, leaves(7), 4},
        {"both crossings behind the window", lamp, ahead, misses, 0, 2.5},
        {"window between the crossings", lamp, ahead, misses, 4, 6},
        {"window that is not a number", lamp, ahead, misses, nan<T>},
    });
}

TEST_CASE("frustum: past the tip, from all but there (the other cap's error made a hit of it)") {
    check_cases<frustum<float>>(
        {{"1e-29 sizes off",
          {{0, 0, 0}, {0x1.7ef016p-12f, -0x1.7da6a2p-11f, -0x1.63d8e6p-11f}, 0, 0x1.04c4b6p-10f},
          {{-0x1.04ff48p-109f, 0x1.d9265cp-110f, 0x1.dcef32p-110f}, {-0x1.cb0ca2p-3f, -0x1.bc57cep-1f, 0x1.c6046cp-2f}},
          misses}});
}

/// To points close to the tip, on the side or on the axis; along the axis or a generator, all but along these, or from
/// anywhere.
template <class Shape>
probe<Shape> ray_to_the_tip_of_a_needle(random_numbers& random) {
    using T = number_t<Shape>;
    const double size = random.log_uniform(1e-6, 1e6);
    const vec3<double> apex = random.direction() * (random.one_in(2) ? 0 : size * random.log_uniform(1e-3, 1e3));
    const vec3<T> tip(apex), wide(apex + random.direction() * size);
    const T radius = static_cast<T>(size * random.log_uniform(1e-5, 3));
    const Shape needle = random.one_in(2) ? Shape{tip, wide, T(0), radius} : Shape{wide, tip, radius, T(0)};

    const vec3<double> axis = to_double(wide) - to_double(tip), out = random.perpendicular(axis) * double(radius),
                       aside = random.direction() * (double(radius) * random.log_uniform(1e-8, 10));
    const auto maybe = [&](const vec3<double>& v) { return v * double(random.integer(0, 1)); };
    const vec3<double> target = to_double(tip) + (axis + maybe(out)) * random.log_uniform(1e-16, 1);
    vec3<double> direction = random.one_in(4) ? random.direction() : normalize(axis + maybe(out) + maybe(aside));
    if (random.one_in(2)) direction = -direction;
    const vec3<T> origin(target - direction * (size * random.log_uniform(1e-6, 1e2)));
    return {needle, {origin, vec3<T>(direction * random.log_uniform(1e-3, 1e3))}, T(0), infinity<T>};
}

TEST_CASE_TEMPLATE(
    "frustum: the normal near an apex (it was the axis from a hundred errors away, or of the other side)", Shape,
    frustum<float>, frustum<double>, open_frustum<float>, open_frustum<double>) {
    random_numbers random(15);
    int hits = 0, complaints = 0;
    const int rays = at_least_a_tenth_of(4'000);
    for (int i = 0; i < rays; ++i) {
        const probe<Shape> p = ray_to_the_tip_of_a_needle<Shape>(random);
        hit_record<number_t<Shape>> rec{};
        if (!p.hit(rec)) continue;
        ++hits;
        worst_errors worst;
        std::string wrong = undecided(p) ? "" : inexactness(p, worst);
        const vec3<double> d = to_double(p.ray.direction);  // of a tangent the normal's roundings decide
        if (dot(to_double(rec.normal), d) > 1e-6 * length(d)) wrong += "seen from behind, " + literal(rec);
        if (!wrong.empty() && ++complaints <= 3) FAIL_CHECK(wrong << "\n    {" << literal(p) << "}");
    }
    CHECK(complaints == 0);
    CHECK(hits > rays / 2);
}

TEST_CASE("frustum: the side of a needle is seen from outside (it leaned by the roundings of the height)") {
    const std::array<probe<frustum<float>>, 2> rays{
        {{{{-0x1.80a07cp+8f, -0x1.7f2516p+5f, -0x1.76467ep+5f}, {0, 0, 0}, 0x1.d5abcap+1f, 0},
          {{-0x1.2ea9fp-11f, -0x1.2d7f62p-14f, -0x1.2684a6p-14f}, {0x1.ef4192p+0f, 0x1.ed590cp-3f, 0x1.e1ed5ep-3f}},
          0,
          infinity<float>},
         {{{0x1.c4c35ep-19f, 0x1.80ef6ep-21f, -0x1.3caaap-19f}, {0, 0, 0}, 0x1.2dbf58p-22f, 0},
          {{-0x1.5925a8p-38f, -0x1.aebfdcp-44f, 0x1.552068p-41f}, {0x1.2697bep+6f, 0x1.6fa822p+0f, -0x1.23294p+3f}},
          0,
          infinity<float>}}};
    for (const probe<frustum<float>>& p : rays) {
        CAPTURE(literal(p));
        hit_record<float> rec{};
        REQUIRE(p.hit(rec));
        CHECK(dot(to_double(rec.normal), to_double(p.ray.direction)) < 0);
    }
}

TEST_CASE_TEMPLATE("frustum: properties of every shape", T, RAIO_NUMBERS) { check_properties<frustum<T>>(); }

TEST_CASE_TEMPLATE("frustum: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<frustum<T>>();
    check_accuracy<frustum<T>>(test_rays);
    check_bounds_of_errors<frustum<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("open_frustum: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const open_frustum<T> lamp{{0, 0, 0}, {0, 2, 0}, 3, 1}, even{{0, -1, 0}, {0, 1, 0}, 1, 1};
    const ray<T> ahead{{0, 1, 5}, {0, 0, -1}};
    check_cases<open_frustum<T>>({
        {"the side", lamp, ahead, enters(3)},
        {"the side, from within", lamp, {{2.5, -1, 0}, {0, 1, 0}}, leaves(1.5)},
        {"through both ends", lamp, {{0.5, 5, 0}, {0, -1, 0}}, misses},
        {"in through the top, onto the side", lamp, {{0, 3, 0}, {1.25, -1, 0}}, misses},
        {"in through the base, onto the side", lamp, {{1, -1, 0}, {1, 1, 0}}, leaves(1.5)},
        {"in through the side, out through the base", lamp, {{2, 3, 0}, {0, -1, 0}}, enters(2)},
        {"in through the side, out through the base, later", lamp, {{2, 3, 0}, {0, -1, 0}}, misses, 2.5},
        {"parallel to a generator, inside (a = 0)", lamp, {{2.5, -1, 0}, {-1, 1, 0}}, misses},
        {"parallel to a generator, onto the upper rim (a = 0)", lamp, {{2, -1, 0}, {-1, 1, 0}}, leaves(3)},
        {"along a generator, in the surface", lamp, {{4, -1, 0}, {-1, 1, 0}}, misses},
        {"where the other nappe would be", lamp, {{0, 4, 5}, {0, 0, -1}}, misses},
        {"along the rim of the base", lamp, {{-5, 0, 0}, {1, 0, 0}}, enters(2)},
        {"one number above the top", lamp, {{-5, 2 + 2 * eps, 0}, {1, 0, 0}}, misses},
        {"touches the upper rim from within", lamp, {{-1, 3, 0}, {2, -1, 0}}, leaves(1)},
        {"touches the wider rim from within", {{-3, 3, 0}, {2, 3, 0}, 1, 3}, {{-4, 3, 0}, {2, 0, 1}}, leaves(3)},
        {"tangent to the side", lamp, {{2, 1, 5}, {0, 0, -1}}, enters(5)},
        {"equal radii, parallel to the axis, in the surface (0 / 0)", even, {{1, 5, 0}, {0, -1, 0}}, misses},
        {"equal radii, parallel to the axis, outside (0 / 0)", even, {{2, 5, 0}, {0, -1, 0}}, misses},
        {"both radii zero", {{0, 0, 0}, {0, 2, 0}, 0, 0}, ahead, misses},
        {"base is top", {{0, 0, 0}, {0, 0, 0}, 3, 1}, ahead, misses},
        {"direction zero", lamp, {{0, 1, 0}, {0, 0, 0}}, misses},
        {"first crossing before the window", lamp, ahead, leaves(7), 4},
        {"window between the crossings", lamp, ahead, misses, 4, 6},
        {"window that is not a number", lamp, ahead, misses, nan<T>},
    });
}

TEST_CASE_TEMPLATE("open_frustum: properties of every shape", T, RAIO_NUMBERS) { check_properties<open_frustum<T>>(); }

TEST_CASE_TEMPLATE("open_frustum: as exact arithmetic", T, RAIO_NUMBERS) {
    check_accuracy<open_frustum<T>>(test_rays, 1.0 / 200);
    check_bounds_of_errors<open_frustum<T>>(test_rays / 20);
}

/// How much of the side's area lies below a height of the lamp that the tests of samples use.
template <class T>
T below(T v) {
    return (36 - (6 - 4 * v) * (6 - 4 * v)) / 32;
}

TEST_CASE_TEMPLATE("frustum: area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    // The axis is 3 long, the generators 5: the side measures 40, the base 36 and the top 4, times pi.
    const frustum<T> lamp{{1, 2, 3}, {3, 3, 5}, 6, 2};
    CHECK(lamp.area() == doctest::Approx(80 * std::numbers::pi));
    check_sampling(lamp, [&](const hit_record<T>& rec) {
        const T up = dot(rec.normal, normalize(lamp.top - lamp.base)), v = rec.uv.y;
        const T all = up < T(-0.9) ? 36 * v * v : up > T(0.9) ? 76 + 4 * v * v : 36 + 40 * below(v);
        return vec2<T>(rec.uv.x, all / 80);
    });
    CHECK(frustum<T>{{1, 2, 3}, {3, 3, 5}, 2, 2}.area() == doctest::Approx(20 * std::numbers::pi));
}

TEST_CASE_TEMPLATE("open_frustum: area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    const open_frustum<T> lamp{{1, 2, 3}, {3, 3, 5}, 6, 2};
    CHECK(lamp.area() == doctest::Approx(40 * std::numbers::pi));
    check_sampling(lamp, [](const hit_record<T>& rec) { return vec2<T>(rec.uv.x, below(rec.uv.y)); });
    const open_frustum<T> even{{1, 2, 3}, {3, 3, 5}, 2, 2};
    check_sampling(even, [](const hit_record<T>& rec) { return rec.uv; });
}

TEST_CASE_TEMPLATE("frustum: uv and normal", T, RAIO_NUMBERS) {
    const frustum<T> lamp{{0, 0, 0}, {0, 0, 2}, 3, 1};
    const auto hit = [&](const ray<T>& ray) {
        hit_record<T> rec{};
        REQUIRE(lamp.hit(ray, T(0), infinity<T>, rec));
        return rec;
    };
    CHECK(hit({{9, 0, 0.5}, {-1, 0, 0}}).uv == vec2<T>(0, 0.25));
    CHECK(hit({{0, 9, 1.5}, {0, -1, 0}}).uv == vec2<T>(0.25, 0.75));
    CHECK(hit({{0.5, 0, 9}, {0, 0, -1}}).uv == vec2<T>(0, 0.5));
    CHECK(hit({{1.5, 0, -9}, {0, 0, 1}}).uv == vec2<T>(0, 0.5));
    CHECK(hit({{0, 0, 9}, {0, 0, -1}}).uv == vec2<T>(0, 0));
    const T half = T(std::sqrt(0.5));
    CHECK(length(hit({{9, 0, 0.5}, {-1, 0, 0}}).normal - vec3<T>(half, 0, half)) <
          2 * std::numeric_limits<T>::epsilon());
    CHECK(length(hit({{0, 0, 1}, {1, 0, 0}}).normal - vec3<T>(-half, 0, -half)) <
          2 * std::numeric_limits<T>::epsilon());
    CHECK(hit({{0, 0, 9}, {0, 0, -1}}).normal == vec3<T>(0, 0, 1));
}

}  // namespace raio::test
