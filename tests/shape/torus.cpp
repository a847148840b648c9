#include <raio/shape/torus.hpp>

#include "support/cases.hpp"
#include "support/dual.hpp"
#include "support/packs.hpp"
#include "support/sampling.hpp"
#include "support/touching.hpp"

namespace raio::test {

template <class T>
struct subject<torus<T>> {
    static auto fields(auto& s) { return std::tie(s.center, s.axis, s.major_radius, s.minor_radius); }

    /// A tube down to a hundredth of the ring; one in four has no hole.
    static torus<T> random(random_numbers& random, double size, const vec3<double>& place) {
        const double thickness = random.one_in(4) ? random.uniform(1, 3) : random.log_uniform(0.01, 1);
        return {vec3<T>(place), vec3<T>(random.axis() * random.log_uniform(0.1, 10)), static_cast<T>(size * 0.5),
                static_cast<T>(size * 0.5 * thickness)};
    }
    static torus<T> lattice(random_numbers& random) {
        torus<T> s{{}, {}, T(random.integer(0, 3)), T(random.integer(0, 3))};
        for_each_number(s.center, [&](T& x) { x = T(random.integer(-2, 2)); });
        for_each_number(s.axis, [&](T& x) { x = random.one_in(2) ? T(0) : T(random.integer(-3, 3)); });
        return s;
    }
    /// Away from the axis, which is what comes before the circle.
    static vec3<double> outwards(const torus<T>& s, random_numbers& random) {
        return random.perpendicular(to_double(s.axis));
    }
    static vec3<double> inner_point(const torus<T>& s, random_numbers& random) {
        return to_double(s.center) + outwards(s, random) * static_cast<double>(s.major_radius) +
               random.direction() * (random.uniform(0, 0.99) * static_cast<double>(s.minor_radius));
    }
    /// In the hole, on one of the circles where the tube is widest, or on the silhouette.
    static vec3<double> special_point(const torus<T>& s, const vec3<double>& from, random_numbers& random) {
        const vec3<double> center = to_double(s.center), up = normalize(to_double(s.axis)), out = outwards(s, random);
        const double major = static_cast<double>(s.major_radius), minor = static_cast<double>(s.minor_radius);
        const vec3<double> on_circle = center + out * major;
        switch (random.integer(0, 5)) {
            case 0:
                return center + up * (minor * random.uniform(-1, 1));
            case 1:
                return on_circle + up * (random.one_in(2) ? minor : -minor);
            case 2:
                return on_circle + out * (random.one_in(2) ? minor : -minor);
            default:
                break;
        }
        // The normal n of the tube, across the circle, with n.(from - on_circle) = minor.
        const vec3<double> view = from - on_circle;
        const double x = dot(view, out), y = dot(view, up), distance = std::sqrt(x * x + y * y);
        if (distance < minor) return on_circle;
        const double turn = std::acos(minor / distance), psi = std::atan2(y, x) + (random.one_in(2) ? turn : -turn);
        return on_circle + (out * std::cos(psi) + up * std::sin(psi)) * minor;
    }
    static oracle distance(const torus<oracle>& s, const vec3<oracle>& p) {
        const vec3<oracle> from_center = p - s.center;
        const oracle size = length(s.axis), height = dot(from_center, s.axis) / size;
        const oracle beyond_circle = length(cross(from_center, s.axis)) / size - s.major_radius;
        return sqrt(oracle(beyond_circle * beyond_circle + height * height)) - s.minor_radius;
    }
};

TEST_CASE_TEMPLATE("torus: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const torus<T> ring{{0, 0, 0}, {0, 0, 2}, 2, 1}, horn{{0, 0, 0}, {0, 1, 0}, 2, 2},
        spindle{{0, 0, 0}, {0, 0, 1}, 4, 5};
    const ray<T> ahead{{6, 0, 0}, {-1, 0, 0}};
    check_cases<torus<T>>({
        {"four crossings, the first", ring, ahead, enters(3)},
        {"four crossings, the second", ring, ahead, leaves(5), 3.5},
        {"four crossings, the third", ring, ahead, enters(7), 5.5},
        {"four crossings, the last", ring, ahead, leaves(9), 7.5},
        {"behind the last", ring, ahead, misses, 9.5},
        {"between two crossings, in the hole", ring, ahead, misses, 5.5, 6.5},
        {"window ends at the first crossing", ring, ahead, enters(3), 0, 3},
        {"window begins at the last crossing", ring, ahead, leaves(9), 9},
        {"through the hole", ring, {{0, 0, 5}, {0, 0, -1}}, misses},
        {"through the hole, obliquely", ring, {{0.5, 0, 5}, {-0.1, 0, -1}}, misses},
        {"past the outside", ring, {{4, 0, 5}, {0, 0, -1}}, misses},
        {"above it", ring, {{6, 0, 2}, {-1, 0, 0}}, misses},
        {"behind the ray", ring, {{6, 0, 0}, {1, 0, 0}}, misses},
        {"down onto the tube", ring, {{2, 0, 5}, {0, 0, -1}}, enters(4)},
        {"from the centre", ring, {{0, 0, 0}, {1, 0, 0}}, enters(1)},
        {"from inside the tube", ring, {{2, 0, 0}, {1, 0, 0}}, leaves(1)},
        {"from inside the tube, inwards", ring, {{2, 0, 0}, {-1, 0, 0}}, leaves(1)},
        {"from the surface inwards (root near 0)", ring, {{3, 0, 0}, {-1, 0, 0}}, enters(0)},
        {"from the surface inwards, later", ring, {{3, 0, 0}, {-1, 0, 0}}, leaves(2), 0x1p-60},
        {"from the surface outwards", ring, {{3, 0, 0}, {1, 0, 0}}, leaves(0)},
        {"from the surface outwards, later", ring, {{3, 0, 0}, {1, 0, 0}}, misses, 0x1p-60},
        {"from the surface along the outside", ring, {{3, 0, 0}, {0, 0, 1}}, enters(0)},
        {"tangent to the outside", ring, {{3, 0, 5}, {0, 0, -1}}, enters(5)},
        {"tangent to the hole", ring, {{1, 0, 5}, {0, 0, -1}}, enters(5)},
        {"tangent to the top, along the tube", ring, {{2, 5, 1}, {0, -1, 0}}, enters(5)},
        {"tangent to the top, twice", ring, {{5, 0, 1}, {-1, 0, 0}}, enters(3)},
        {"tangent to the top, the second time", ring, {{5, 0, 1}, {-1, 0, 0}}, enters(7), 4},
        {"one number beyond the tangent", ring, {{3 + 2 * eps, 0, 5}, {0, 0, -1}}, misses},
        {"one number beyond the top", ring, {{5, 0, 1 + eps}, {-1, 0, 0}}, misses},
        {"tangent to the hole, from the side", ring, {{1, 5, 0}, {0, -1, 0}}, enters(5 - std::sqrt(8.0))},
        {"zeros with signs", ring, {{6, 0, 0}, {-1, -0.0, 0.0}}, enters(3)},
        {"direction of length 2", ring, {{6, 0, 0}, {-2, 0, 0}}, enters(1.5)},
        {"direction of length 1e-20", ring, {{6, 0, 0}, {-0x1p-66, 0, 0}}, enters(0x3p66)},
        {"direction of length 1e20", ring, {{6, 0, 0}, {-0x1p66, 0, 0}}, enters(0x3p-66)},
        {"slanted axis", {{1, 2, 3}, {2, 3, 6}, 2, 1}, {{7, 11, 21}, {-2, -3, -6}}, misses},
        {"slanted axis, onto the tube", {{1, 2, 3}, {3, 4, 0}, 5, 1}, {{4.75, 2.5, 3}, {-0.8, 0.6, 0}}, misses},
        {"tube of a hundredth", {{0, 0, 0}, {0, 1, 0}, 1, T(0x1p-7)}, {{1, 3, 0}, {0, -1, 0}}, enters(3 - 0x1p-7)},
        {"beside the tube of a hundredth", {{0, 0, 0}, {0, 1, 0}, 1, T(0x1p-7)}, {{T(1.01), 3, 0}, {0, -1, 0}}, misses},
        {"tube of a millionth", {{0, 0, 0}, {0, 1, 0}, 1, T(0x1p-20)}, {{1, 3, 0}, {0, -1, 0}}, enters(3 - 0x1p-20)},
        {"1e4 radii away", ring, {{T(20000), 0, 0}, {-1, 0, 0}}, enters(19997)},
        {"far torus 1e7 away", {{0, 0, -1e7}, {0, 1, 0}, 2, 1}, {{0, 0, 0}, {0, 0, -1}}, enters(9999997)},
        {"horn, along the axis", horn, {{0, 5, 0}, {0, -1, 0}}, enters(5)},
        {"horn, along the axis from below, seen with a normal against the ray",
         horn,
         {{0, -5, 0}, {0, 1, 0}},
         enters(5)},
        {"horn, askew to where it meets itself (seen with a normal along the ray)",
         {vec3<T>(11.5), {11.5, -0.125, 9.125}, 9.125, 9.125},
         {vec3<T>(9.125), vec3<T>(9.125)},
         leaves(2.375 / 9.125)},
        {"horn, through the centre", horn, {{5, 0, 0}, {-1, 0, 0}}, enters(1)},
        {"horn, from the centre", horn, {{0, 0, 0}, {1, 0, 0}}, leaves(0)},
        {"spindle, from outside", spindle, {{10, 0, 0}, {-1, 0, 0}}, enters(1)},
        {"spindle, later", spindle, {{10, 0, 0}, {-1, 0, 0}}, leaves(19), 2.5},
        {"spindle, along the axis", spindle, {{0, 0, 10}, {0, 0, -1}}, enters(7)},
        {"spindle, along the axis, later", spindle, {{0, 0, 10}, {0, 0, -1}}, leaves(13), 7.5},
        {"spindle, beside the axis", spindle, {{1, 0, 10}, {0, 0, -1}}, enters(6)},
        {"spindle, from the centre: no ghost", spindle, {{0, 0, 0}, {1, 0, 0}}, leaves(9)},
        {"spindle, from the centre along the axis", spindle, {{0, 0, 0}, {0, 0, 1}}, leaves(3)},
        {"spindle, from where it meets itself", spindle, {{0, 0, 3}, {0, 0, 1}}, leaves(0)},
        {"spindle, through the point on the axis", spindle, {{-16, 0, 3}, {1, 0, 0}}, enters(8)},
        {"major radius zero", {{0, 0, 0}, {0, 0, 1}, 0, 1}, ahead, misses},
        {"minor radius zero", {{0, 0, 0}, {0, 0, 1}, 2, 0}, ahead, misses},
        {"major radius below zero", {{0, 0, 0}, {0, 0, 1}, -2, 1}, ahead, misses},
        {"minor radius below zero", {{0, 0, 0}, {0, 0, 1}, 2, -1}, ahead, misses},
        {"axis zero", {{0, 0, 0}, {0, 0, 0}, 2, 1}, ahead, misses},
        {"direction zero", ring, {{2, 0, 0}, {0, 0, -0.0}}, misses},
        {"window turned around", ring, ahead, misses, 5, 3},
        {"window that is not a number", ring, ahead, misses, nan<T>},
    });
}

TEST_CASE_TEMPLATE("torus: through the axis from one side of a spindle into the other", T, RAIO_NUMBERS) {
    const torus<T> spindle{{0, 0, 0}, {0, 0, 1}, 4, 5};
    const auto check = [&](const ray<T>& r, T begin, T end) {
        std::size_t count = 0;
        for (const interval<T>& span : spindle.spans(r)) {
            CHECK(span.min == begin);
            CHECK(span.max == end);
            ++count;
        }
        CHECK(count == 1);
        // It touches the surface on the axis, from within.
        hit_record<T> rec{};
        CHECK(spindle.hit(r, T(5), infinity<T>, rec));
        CHECK(rec.t == T(6));
        CHECK(!rec.front_face);
    };
    check({{-18, 0, -3}, {3, 0, 1}}, T(3), T(7.8));
    check({{18, 0, 9}, {-3, 0, -1}}, T(4.2), T(9));
}

TEST_CASE("torus: so small that no t is between its ends (1 was divided by that, which was zero)") {
    const torus<double> speck{{0, 0, 0}, {0, 0, 1}, 2e-312, 1e-312};
    CHECK_FALSE(speck.occluded({{0, 0, 0}, {1e150, 0, 0}}, 0, infinity<double>));
}

TEST_CASE("torus: so large that no square of it is a number (two components of the normal were none)") {
    const torus<double> world{{0, 0, 0}, {0x1p-847, 0x1p-477, 0x1p-477}, 0x1p-670, 0x1p518};
    hit_record<double> rec{};
    REQUIRE(world.hit({{0, 0, 0}, {0, 0x1.2222222222222p-477, 0x1.2p-477}}, 0, infinity<double>, rec));
    CHECK(length(rec.normal) == doctest::Approx(1));
}

TEST_CASE("torus: where it touches its bounds, from far away (beyond them)") {
    check_cases<torus<float>>(
        {{"5,000 sizes",
          {{0, 0, 0}, {-1, 0, 0}, 0x1.5d5bdap+1f, 0x1.09399p-5f},
          {{-0x1.68293cp+5f, 0x1.2aed1p+10f, -0x1.05dcd4p+13f}, {0x1.67e6eep+5f, -0x1.2aed1p+10f, 0x1.05f2aap+13f}},
          enters(1)}});
    check_cases<torus<double>>({{"5,000 sizes",
                                 {{-0x1.9f304a3a6f641p-8, 0x1.3ce37efa674f3p-7, 0x1.3d6e3f658dc58p-8},
                                  {1, 0, 0},
                                  0x1.97fb817b039b7p-6,
                                  0x1.58ee14887cd83p-12},
                                 {{0x1.82bfaeccd4d52p+4, -0x1.ef4e6dca0ef32p+6, -0x1.74eb01bc41449p+4},
                                  {-0x1.82d9a1d1787c1p+4, 0x1.ef3e7ef269f4p+6, 0x1.74fed8a0379d7p+4}},
                                 enters(1)}});
}

TEST_CASE_TEMPLATE("torus: properties of every shape", T, RAIO_NUMBERS) { check_properties<torus<T>>(); }

TEST_CASE_TEMPLATE("torus: lines that all but touch it thrice, four times, or in two places", T, RAIO_NUMBERS) {
    check_along_surface(test_rays / 5, [](random_numbers& random) {
        const torus<T> ring = subject<torus<T>>::random(random, 1, random.direction());
        const vec3<double> center = to_double(ring.center), up = normalize(to_double(ring.axis));
        const vec3<double> out = random.perpendicular(up), along = cross(up, out);
        const double major = static_cast<double>(ring.major_radius), minor = static_cast<double>(ring.minor_radius);
        if (minor < major && random.one_in(4)) {  // in the plane that touches it twice, through the centre
            const double sine = minor / major, cosine = std::sqrt(1 - sine * sine);
            const vec3<double> direction = out * cosine + up * sine;
            return touching_line<torus<T>>{ring, center + direction * (major * cosine), direction};
        }
        // Where the tube bends both ways, the line along which it does not; on the top circle that is its tangent.
        const double psi = random.one_in(4) ? pi<double> / 2 : random.uniform(0.5, 1.5) * pi<double>;
        const double rho = major + minor * std::cos(psi);
        const double turn = std::sqrt(std::max(0.0, -rho * std::cos(psi) / minor));
        return touching_line<torus<T>>{ring, center + out * rho + up * (minor * std::sin(psi)),
                                       along * rho + (up * std::cos(psi) - out * std::sin(psi)) * (minor * turn)};
    });
}

TEST_CASE("torus: a line that all but touches it thrice (in [t, t] it was missed)") {
    const torus<double> ring{{0, 0, 0},
                             {-0x1.9b9c8856e99f3p+1, -0x1.0a95624de44fp+2, -0x1.233e3e983c501p+1},
                             0x1.3488e8cc8d3ebp-8,
                             0x1.72357ae010213p-12};
    const ray<double> inside{{-0x1.64e90b2a4846dp-9, -0x1.de97d91b7114cp-12, 0x1.f1a9ff4e7d4adp-9},
                             {0x1.28f98cb970f92p-1, 0x1.8e393ca7af816p-4, -0x1.9e17885e3807dp-1}};
    CHECK(open_window<torus<double>>({ring, inside}) == "");
}

TEST_CASE_TEMPLATE("torus: from a point of the surface, in any direction (many doubles did not start there)", T,
                   RAIO_NUMBERS) {
    check_starts_on_surface([](random_numbers& random) {
        const T r = static_cast<T>(random.uniform(1, 2)), h = static_cast<T>(random.uniform(1, 2));
        return std::pair(torus<T>{{0, 0, 0}, {0, 0, h}, 3, r}, vec3<T>(0, 3, r));
    });
}

TEST_CASE_TEMPLATE("torus: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<torus<T>>();
    check_accuracy<torus<T>>(test_rays, 1e-3, ulp_of_roots);
    check_bounds_of_errors<torus<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("torus: area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    const double pi2 = std::numbers::pi * std::numbers::pi;
    CHECK(torus<T>{{1, 2, 3}, {0, 0, 1}, 3, 2}.area() == doctest::Approx(24 * pi2));
    CHECK(torus<T>{{1, 2, 3}, {0, 0, 1}, 3, 3}.area() == doctest::Approx(36 * pi2));
    // Without the circle it would be a sphere.
    CHECK(torus<T>{{1, 2, 3}, {0, 0, 1}, T(1e-6), 3}.area() == doctest::Approx(36 * std::numbers::pi));
    const auto check = [](const torus<T>& shape) {
        const double major = double(shape.major_radius), minor = double(shape.minor_radius);
        const double end = std::acos(std::max(-major / minor, -1.0)), all = major * end + minor * std::sin(end);
        check_sampling(shape, [=](const hit_record<T>& rec) {
            const double psi = 2 * std::numbers::pi * (double(rec.uv.y) - (rec.uv.y > T(0.5) ? 1 : 0));
            return vec2<T>(rec.uv.x, T((major * psi + minor * std::sin(psi)) / (2 * all) + 0.5));
        });
    };
    check({{0, 0, 0}, {0, 0, 1}, 2, 1});
    // They turn and rise as uv does.
    const vec3<T> sampled = torus<T>{{0, 0, 0}, {0, 0, 1}, 2, 1}.sample({T(0.25), T(0.75)}).point;
    CHECK((std::abs(sampled.x) < 1e-5 && sampled.y > 2 && sampled.z > T(0.5)));
    // All of the inside is sampled.
    for (const T end : {T(0), T(1)})
        CHECK(std::abs(torus<T>{{0, 0, 0}, {0, 0, 1}, 2, 1}.sample({0, end}).point.z) < 1e-5);
    check({{-10, 20, 30}, {1, 2, 3}, 1, T(0.1)});

    random_numbers random(5);
    const torus<T> spindle{{0, 0, 0}, {3, 0, 1}, 1, 2};
    for (int i = 0; i < at_least(1000); ++i) {
        const T v = i < 100 ? T(1) - T(i + 1) * T(unit_roundoff<T>) : T(random.uniform());  // to the very tip, too
        const surface_sample<T> s = spindle.sample({T(random.uniform()), v});
        const oracle distance = subject<torus<T>>::distance(converted<oracle>(spindle), converted<oracle>(s.point));
        REQUIRE(abs(distance) < 16 * std::numeric_limits<T>::epsilon());
    }
}

TEST_CASE_TEMPLATE("torus: uv", T, RAIO_NUMBERS) {
    const torus<T> ring{{1, 1, 1}, {0, 0, 1}, 2, 1};
    const auto uv = [&](const vec3<T>& from, const vec3<T>& direction) {
        hit_record<T> rec{};
        REQUIRE(ring.hit({ring.center + from, direction}, T(0), infinity<T>, rec));
        return rec.uv;
    };
    CHECK(uv({9, 0, 0}, {-1, 0, 0}) == vec2<T>(0, 0));
    CHECK(uv({0, 9, 0}, {0, -1, 0}) == vec2<T>(0.25, 0));
    CHECK(uv({-2, 0, 9}, {0, 0, -1}) == vec2<T>(0.5, 0.25));
    CHECK(uv({0, 0, 0}, {0, -1, 0}) == vec2<T>(0.75, 0.5));
    CHECK(uv({2, 0, -9}, {0, 0, 1}) == vec2<T>(0, 0.75));
}

TEST_CASE_TEMPLATE("torus: all crossings", T, RAIO_NUMBERS) {
    const torus<T> ring{{0, 0, 0}, {0, 0, 2}, 2, 1};
    const auto inside = ring.spans({{6, 0, 0}, {-1, 0, 0}});
    REQUIRE(inside.count == 2);
    const T off = std::same_as<T, float> ? 0 : T(1e-14);  // of a double, the last bits are what the formula finds
    CHECK((std::abs(inside.intervals[0].min - 3) <= off && std::abs(inside.intervals[0].max - 5) <= off));
    CHECK((std::abs(inside.intervals[1].min - 7) <= off && std::abs(inside.intervals[1].max - 9) <= off));
    CHECK(ring.spans({{0, 0, 6}, {0, 0, -1}}).empty());
    CHECK(torus<T>{{0, 0, 0}, {0, 0, 1}, 3, 5}.spans({{0, 0, 9}, {0, 0, -1}}).intervals[0] == interval<T>{5, 13});
}

TEST_CASE("torus: the derivatives of t, by a number that carries them along") {
    const torus<dual> ring{{0, 0, 0}, {0, 0, 1}, dual::variable(2, 0), dual::variable(1, 1)};
    hit_record<dual> rec{};
    REQUIRE(ring.hit({{dual::variable(6, 2), 0, 0}, {-1, 0, 0}}, 0, infinity<dual>, rec));
    CHECK(rec.t.value == doctest::Approx(3));
    CHECK(rec.t.slope[0] == doctest::Approx(-1));
    CHECK(rec.t.slope[1] == doctest::Approx(-1));
    CHECK(rec.t.slope[2] == doctest::Approx(1));
}

TEST_CASE_TEMPLATE("torus: packs, lane by lane", T, RAIO_NUMBERS) { check_lanes_are_plain<torus<T>>(400); }

}  // namespace raio::test
