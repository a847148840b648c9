#include <raio/shape/cylinder.hpp>

#include "support/bounds.hpp"
#include "support/cases.hpp"
#include "support/cylinders.hpp"
#include "support/sampling.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("cylinder: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const cylinder<T> unit{{0, -1, 0}, {0, 1, 0}, 1}, wide{{0, 0, 0}, {0, 0, 4}, 5};
    const ray<T> ahead{{0, 0, 5}, {0, 0, -1}};
    check_cases<cylinder<T>>({
        {"the side", unit, ahead, enters(4)},
        {"the side, off the axis", wide, {{-10, 3, 1}, {1, 0, 0}}, enters(6)},
        {"the side, obliquely", unit, {{-3, -1, 0}, {4, 1, 0}}, enters(0.5)},
        {"behind the ray", unit, {{0, 0, 5}, {0, 0, 1}}, misses},
        {"from inside to the side", unit, {{0, 0.5, 0}, {1, 0, 0}}, leaves(1)},
        {"from inside to a cap", unit, {{0.5, 0.5, 0}, {0, 1, 0}}, leaves(0.5)},
        {"the top, along the axis", unit, {{0, 5, 0}, {0, -1, 0}}, enters(4)},
        {"the base, along the axis", unit, {{0, -5, 0}, {0, 1, 0}}, enters(4)},
        {"the top, parallel to the axis", unit, {{0.5, 5, 0.5}, {-0.0, -1, 0}}, enters(4)},
        {"the top, obliquely", unit, {{0, 2, 0}, {0.5, -1, 0}}, enters(1)},
        {"in through the top, out through the side", unit, {{0, 2, 0}, {1, -1.5, 0}}, leaves(1), 0.75},
        {"parallel to the axis, outside (0 / 0)", unit, {{2, 5, 0}, {0, -1, 0}}, misses},
        {"parallel to the axis, on the surface (0 / 0)", unit, {{1, 5, 0}, {0, -1, 0}}, enters(4)},
        {"parallel to the axis, on the surface, off the axes", wide, {{3, 4, 9}, {0, 0, -1}}, enters(5)},
        {"parallel to the axis, one number beyond the surface", unit, {{1 + eps, 5, 0}, {0, -1, 0}}, misses},
        {"one number from parallel, inside", unit, {{0, 5, 0}, {0x1p-60, -1, 0}}, enters(4)},
        {"one number from parallel, on the surface", unit, {{1, 5, 0}, {0x1p-60, -1, 0}}, misses},
        {"one number from parallel, into the surface", unit, {{1, 5, 0}, {-0x1p-60, -1, 0}}, enters(4)},
        {"along a cap", unit, {{-5, 1, 0}, {1, 0, 0}}, enters(4)},
        {"one number beyond the cap", unit, {{-5, 1 + eps, 0}, {1, 0, 0}}, misses},
        {"touches a rim", unit, {{0, 2, 0}, {1, -1, 0}}, enters(1)},
        {"touches a rim from the side", unit, {{2, 0, 0}, {-1, 1, 0}}, enters(1)},
        {"touches a rim where t is a third", {{0, 0, 0}, {0, 3, 0}, 3}, {{4, 2, 0}, {-3, 3, 0}}, enters(1.0 / 3)},
        {"over the rim", unit, {{0, 3, 0}, {1, -1, 0}}, misses},
        {"tangent to the side", unit, {{1, 0, 5}, {0, 0, -1}}, enters(5)},
        {"one number beyond the tangent", unit, {{1 + eps, 0, 5}, {0, 0, -1}}, misses},
        {"above the top (|| for && in the height test)", unit, {{0, 2, 5}, {0, 0, -1}}, misses},
        {"below the base (|| for && in the height test)", unit, {{0, -2, 5}, {0, 0, -1}}, misses},
        {"from the side inwards", unit, {{1, 0, 0}, {-1, 0, 0}}, enters(0)},
        {"from the side outwards", unit, {{1, 0, 0}, {1, 0, 0}}, leaves(0)},
        {"from the top inwards", unit, {{0, 1, 0}, {0, -1, 0}}, enters(0)},
        {"from the top outwards", unit, {{0, 1, 0}, {0, 1, 0}}, leaves(0)},
        {"base and top exchanged", {{0, 1, 0}, {0, -1, 0}, 1}, {{0, 5, 0}, {0, -1, 0}}, enters(4)},
        {"radius zero", {{0, -1, 0}, {0, 1, 0}, 0}, ahead, misses},
        {"radius below zero", {{0, -1, 0}, {0, 1, 0}, -1}, ahead, misses},
        {"base is top", {{0, 0, 0}, {0, 0, 0}, 1}, ahead, misses},
        {"direction zero", unit, {{0, 0, 0}, {0, 0, 0}}, misses},
        {"first crossing before the window", unit, ahead, leaves(6), 4.5},
        {"both crossings behind the window", unit, ahead, misses, 0, 3.5},
        {"window between the crossings", unit, ahead, misses, 4.5, 5.5},
        {"window that is not a number", unit, ahead, misses, nan<T>},
    });
}

TEST_CASE("cylinder: outwards from all but its rim (hit what it had left)") {
    check_cases<cylinder<double>>(
        {{"1e-26 off",
          {{-2, 3, 2}, {-2, 2, 1}, 2},
          {{0x1.c000800000002p-86, 3, 2}, {0x1.878e293c52a9ap-2, -0x1.93b2ee55792b9p-1, 0x1.ed5312c9c6084p-2}},
          misses}});
}

TEST_CASE_TEMPLATE("cylinder: beside it, and all but parallel to its axis (hit, where that came closest)", T,
                   RAIO_NUMBERS) {
    const cylinder<T> straight{{0, 0, 0}, {0, -14, 0}, 6}, askew{{0, 0, 0}, {-14, -14, 0}, 6};
    for (const int power : {-149, -120, -90, -88, -86, -84, -80, -60, -40}) {
        CAPTURE(power);
        const T tilt = std::ldexp(T(1), power);
        check_cases<cylinder<T>>(
            {{"straight, an eighth", straight, {{6.75, 0, 0}, {0, 6, tilt}}, misses},
             {"straight, a little", straight, {{T(6 + 0x1p-18), 0, 0}, {0, 6, tilt}}, misses},
             {"straight, on its way", straight, {{T(6 + 0x1p-18), -20, 0}, {0, 6, -tilt}}, misses},
             {"straight, a little within", straight, {{T(6 - 0x1p-18), 0, 0}, {0, 6, tilt}}, leaves(0)},
             {"askew, a little", askew, {{0, 0, T(6 + 0x1p-18)}, {6 - tilt, 6 + tilt, 0}}, misses},
             {"askew, a little, towards it", askew, {{5, -5, 0}, {6, 6, tilt}}, misses}});
    }
}

TEST_CASE("cylinder: of 1e-96, whose fourth powers are no numbers (hit from anywhere)") {
    check_cases<cylinder<double>>(
        {{"askew, past it",
          {{0, 0, 0}, {0, 0x1p-317, 0x1p-317}, 0x1p-319},
          {{0x1p-317, 0x1p-317, 0}, {0x1p-315, 0x1p-317, 0x1p-317}},
          misses},
         {"along it, beside it", {{0, 0, 0}, {0x1p-336, 0, 0}, 0x1p-348}, {{0, 0x1p-303, 0}, {1, 0, 0}}, misses},
         {"all but along it", {{0, 0, 0}, {0, 0, 2}, 1}, {{0, 0, -1}, {0x1p-600, 0, 1}}, enters(1)}});
}

TEST_CASE("cylinder: above its top, and along it until beyond the largest number (hit there)") {
    const cylinder<double> low{{0, 0, 0}, {0, 0.625, 0}, 4.75};
    check_cases<cylinder<double>>({{"rises", low, {{2, 5.125, 0.125}, {1, 0x1p-1022, 0}}, misses},
                                   {"falls", low, {{2, 5.125, 0.125}, {1, -0x1p-1022, 0}}, misses},
                                   {"rises from below it", low, {{2, -4.5, 0}, {1, 0x1p-1022, 0}}, misses},
                                   {"rises from within", low, {{0, 0.5, 0}, {1, 0x1p-1022, 0}}, leaves(4.75)}});
}

TEST_CASE("cylinder: 2^278 wide, whose fourth powers are beyond the range, where the window ends") {
    const cylinder<double> wide{{0, 0, 0}, {0, 0x1p278, 0}, 0x1p278};
    const ray<double> tilted{{0x1.8p278, 0x1p277, 0x1p276}, {-0x1p-349, 0x1p-352, 0x1p-354}};
    hit_record<double> rec{}, same{};
    REQUIRE(wide.hit(tilted, 0, infinity<double>, rec));
    CHECK((wide.hit(tilted, 0, rec.t, same) && same.t == rec.t && wide.occluded(tilted, 0, rec.t)));
    CHECK(!wide.hit(tilted, 0, std::nextafter(rec.t, 0.0), same));
    CHECK(rec.t == 0x1.128d8ff6fdf5ep+626);  // by 50 digits
}

TEST_CASE("cylinder: its rim, from far away (beyond the bounds)") {
    check_cases<cylinder<double>>({{"14,000 sizes",
                                    {{0, 0, 0}, {0, 0, -0x1.70d3eb72400fcp-3}, 0x1.789fdd3fdb6fcp-11},
                                    {{0x1.a8f81667ba5cbp+3, 0x1.777fb915ea717p+3, 0x1.49422bc997d6dp+11},
                                     {-0x1.a8f233e8455d4p+3, -0x1.777fb915ea717p+3, -0x1.4947ee0328302p+11}},
                                    enters(1)}});
}

TEST_CASE_TEMPLATE("cylinder: properties of every shape", T, RAIO_NUMBERS) { check_properties<cylinder<T>>(); }

TEST_CASE_TEMPLATE("cylinder: from a point of the surface, in any direction (many doubles did not start there)", T,
                   RAIO_NUMBERS) {
    check_starts_on_surface([](random_numbers& random) {
        const T r = static_cast<T>(random.uniform(1, 2)), h = static_cast<T>(random.uniform(1, 2));
        return std::pair(cylinder<T>{{0, 0, 0}, {0, 0, h}, r},
                         vec3<T>(r, 0, h * static_cast<T>(random.uniform(0.1, 0.9))));
    });
}

TEST_CASE_TEMPLATE("cylinder: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<cylinder<T>>();
    check_accuracy<cylinder<T>>(test_rays);
    check_bounds_of_errors<cylinder<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("open_cylinder: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const open_cylinder<T> unit{{0, -1, 0}, {0, 1, 0}, 1}, wide{{0, 0, 0}, {0, 0, 4}, 5};
    const ray<T> ahead{{0, 0, 5}, {0, 0, -1}};
    check_cases<open_cylinder<T>>({
        {"the side", unit, ahead, enters(4)},
        {"the side, off the axis", wide, {{-10, 3, 1}, {1, 0, 0}}, enters(6)},
        {"behind the ray", unit, {{0, 0, 5}, {0, 0, 1}}, misses},
        {"from inside", unit, {{0, 0.5, 0}, {1, 0, 0}}, leaves(1)},
        {"through both ends", unit, {{0.25, 5, 0}, {0, -1, 0}}, misses},
        {"from inside through an end", unit, {{0, 0, 0}, {0.5, 1, 0}}, misses},
        {"in through an end, onto the side", unit, {{0, 2, 0}, {1, -1.5, 0}}, leaves(1)},
        {"in through the side, out through an end", unit, {{2, 0, 0}, {-1, 0.75, 0}}, enters(1)},
        {"in through the side, out through an end, later", unit, {{2, 0, 0}, {-1, 0.75, 0}}, misses, 1.5},
        {"parallel to the axis, in the surface (0 / 0)", unit, {{1, 5, 0}, {0, -1, 0}}, misses},
        {"parallel to the axis, outside (0 / 0)", unit, {{2, 5, 0}, {0, -1, 0}}, misses},
        {"along an end", unit, {{-5, 1, 0}, {1, 0, 0}}, enters(4)},
        {"one number beyond the end", unit, {{-5, 1 + eps, 0}, {1, 0, 0}}, misses},
        {"touches a rim", unit, {{0, 2, 0}, {1, -1, 0}}, leaves(1)},
        {"tangent at a rim, from far away (left without having been entered)",
         {{0, 0, 0}, {-0x1.be90fp+16, 0, 0}, 0x1.74a868p+13},
         {{0x1.2560f2p+30, 0x1.09b666p+31, 0x1.74a868p+13}, {-0x1.2560f2p+30, -0x1.09b666p+31, -0.0}},
         enters(1)},
        {"tangent to the side", unit, {{1, 0, 5}, {0, 0, -1}}, enters(5)},
        {"above the top (|| for && in the height test)", unit, {{0, 2, 5}, {0, 0, -1}}, misses},
        {"radius zero", {{0, -1, 0}, {0, 1, 0}, 0}, ahead, misses},
        {"base is top", {{0, 0, 0}, {0, 0, 0}, 1}, ahead, misses},
        {"direction zero", unit, {{0, 0, 0}, {0, 0, 0}}, misses},
        {"first crossing before the window", unit, ahead, leaves(6), 4.5},
        {"window between the crossings", unit, ahead, misses, 4.5, 5.5},
        {"window that is not a number", unit, ahead, misses, nan<T>},
    });
}

/// Of the rise of these rays there is no inverse (a cap that had no t for it was crossed anywhere).
TEST_CASE("cylinder: rays that never rise as far as a cap") {
    const cylinder<double> tower{{0, 0, 0}, {0, 0, 12}, 13};
    check_cases<cylinder<double>>({
        {"below the base", tower, {{-5, -5, -2.5}, {-1, 0, 0x1p-1074}}, misses},
        {"above the top", tower, {{-5, -5, 12.5}, {-1, 0, 0x1p-1074}}, misses},
        {"between them", tower, {{-5, -5, 2.5}, {-1, 0, 0x1p-1074}}, leaves(7)},
    });
}

/// What floats make of the products of its axis and the ray is 0 (packs took that for a ray along the caps).
TEST_CASE("cylinder: all but a disc, whose axis is 2^-45 long, in packs") {
    using P = pack<float, 4>;
    const vec3<float> base(0x1p-127f, 0x1.fcp-128f, 0x1.f8p-128f), top(0x1.fcp-128f, 0x1.60ba8p-45f, 0x1.fcp-128f);
    const cylinder<P> packed{vec3<P>(base), vec3<P>(top), P(0x1.8p+59f)};
    const ray<float> r{{0x1.80526p-126f, 0x1.7fp-41f, -0x1.625656p+5f}, {0x1.56p-41f, 0x1.0acacp-131f, 0x1.48p-124f}};
    REQUIRE(cylinder<float>{base, top, 0x1.8p+59f}.occluded(r, 0, infinity<float>));
    CHECK(all(packed.occluded({vec3<P>(r.origin), vec3<P>(r.direction)}, P(0), P(infinity<float>))));
}

TEST_CASE_TEMPLATE("open_cylinder: properties of every shape", T, RAIO_NUMBERS) {
    check_properties<open_cylinder<T>>();
}

TEST_CASE_TEMPLATE("open_cylinder: as exact arithmetic", T, RAIO_NUMBERS) {
    check_accuracy<open_cylinder<T>>(test_rays, 1.0 / 200);
    check_bounds_of_errors<open_cylinder<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("cylinder: the bound of t on its own, from above as well, where rays all but run along it", W,
                   strict_double, double_double) {
    part_of_bound of_t;
    random_numbers random(1);
    int seen = 0;
    for (int i = 0; i < at_least(20'000); ++i) {
        const vec3<double> axis = some_vector(random), base = some_vector(random), top = base + axis;
        const double radius = random.log_uniform(1e-3, 1e3), slant = random.log_uniform(1e-9, 1);
        const vec3<double> along = (top - base) * random.uniform(-1, 1);
        const vec3<double> direction = (top - base) * (1 - slant) + random.perpendicular(axis) * length(axis) * slant;
        const vec3<double> inside = base + along + random.perpendicular(axis) * radius * random.uniform();
        const ray<double> ray{inside - direction * random.uniform(-2, 2), direction};
        const auto [near, far] = detail::cross_endless_cylinder(base, top, radius, line_in<W>(ray));

        const vec3<oracle> a(vec3<oracle>(top) - vec3<oracle>(base)), l(vec3<oracle>(base) - vec3<oracle>(ray.origin));
        const vec3<oracle> n = cross(vec3<oracle>(direction), a), beside = cross(l, a);
        const oracle r(radius), n2 = dot(n, n), b = dot(beside, n), c = dot(beside, beside) - dot(a, a) * r * r;
        const oracle square = b * b - n2 * c, root = sqrt(max(square, oracle(0)));
        if (!near.certain || !near.exists) continue;
        of_t.add(exactly(near.t) - (b - root) / n2, near.error);
        of_t.add(exactly(far.t) - (b + root) / n2, far.error);
        ++seen;
    }
    // What double_double states of an operation is no bound that is ever met.
    CHECK((seen > 2'000 && of_t.largest > (std::same_as<W, strict_double> ? 0.01 : 2e-4)));
}

TEST_CASE_TEMPLATE("cylinder: area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    const cylinder<T> can{{1, 2, 3}, {3, 3, 5}, 2};  // 3 high
    CHECK(can.area() == doctest::Approx(20 * std::numbers::pi));
    CHECK(can.sample({T(0.7), T(0)}).point == can.base);
    CHECK(can.sample({T(0.9), T(0)}).point == can.top);
    // A fifth of the area is each cap, three fifths are the side.
    check_sampling(can, [&](const hit_record<T>& rec) {
        const T up = dot(rec.normal, normalize(can.top - can.base)), v = rec.uv.y;
        const bool on_side = std::abs(up) < T(0.5);
        return vec2<T>(rec.uv.x, (on_side ? 1 + 3 * v : up < 0 ? v * v : 4 + v * v) / 5);
    });
}

TEST_CASE_TEMPLATE("open_cylinder: area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    const open_cylinder<T> tube{{1, 2, 3}, {3, 3, 5}, 2};
    CHECK(tube.area() == doctest::Approx(12 * std::numbers::pi));
    check_sampling(tube, [](const hit_record<T>& rec) { return rec.uv; });
}

TEST_CASE_TEMPLATE("cylinder: uv", T, RAIO_NUMBERS) {
    const cylinder<T> can{{0, 0, 0}, {0, 0, 4}, 2};
    const auto uv = [&](const ray<T>& ray) {
        hit_record<T> rec{};
        REQUIRE(can.hit(ray, T(0), infinity<T>, rec));
        return rec.uv;
    };
    CHECK(uv({{9, 0, 1}, {-1, 0, 0}}).y == T(0.25));
    CHECK(uv({{9, 0, 0}, {-1, 0, 0}}).y == T(0));
    CHECK(uv({{0, 9, 4}, {0, -1, 0}}).y == T(1));
    CHECK(uv({{0, 0, 9}, {0, 0, -1}}) == vec2<T>(0, 0));
    CHECK(uv({{1, 0, 9}, {0, 0, -1}}).y == T(0.5));
    CHECK(uv({{0, -2, -9}, {0, 0, 1}}).y == T(1));
    // The same angle on the side and on both caps.
    CHECK(uv({{9, 9, 1}, {-1, -1, 0}}).x == doctest::Approx(uv({{1, 1, 9}, {0, 0, -1}}).x));
    CHECK(uv({{9, 9, 1}, {-1, -1, 0}}).x == doctest::Approx(uv({{1, 1, -9}, {0, 0, 1}}).x));
    CHECK(std::abs(uv({{9, 9, 1}, {-1, -1, 0}}).x - uv({{-9, -9, 1}, {1, 1, 0}}).x) == doctest::Approx(0.5));
}

}  // namespace raio::test
