#include <raio/shape/bezier_curve.hpp>

#include "support/cases.hpp"
#include "support/packs.hpp"

namespace raio::test {

template <class T>
inline constexpr bool is_convex<bezier_curve<T>> = false;

template <class T>
struct subject<bezier_curve<T>> {
    static auto fields(auto& s) { return std::tie(s.p0, s.p1, s.p2, s.p3, s.r0, s.r1, s.r2, s.r3); }

    /// One in eight is straight, one in eight ends in a tip, one in eight is of one radius.
    static bezier_curve<T> random(random_numbers& random, double size, const vec3<double>& place) {
        const double thickness = random.log_uniform(1e-2, 1);
        const auto point = [&] { return vec3<T>(place + random.direction() * (size * random.uniform())); };
        const auto radius = [&] { return static_cast<T>(size * thickness * random.uniform(0.1, 1)); };
        bezier_curve<T> s{point(), point(), point(), point(), radius(), radius(), radius(), radius()};
        if (random.one_in(8)) s.p1 = s.p0 + (s.p3 - s.p0) / T(4), s.p2 = s.p0 + (s.p3 - s.p0) / T(2);
        if (random.one_in(8)) s.r3 = 0;
        if (random.one_in(8)) s.r1 = s.r2 = s.r3 = s.r0;
        return s;
    }
    static bezier_curve<T> lattice(random_numbers& random) {
        bezier_curve<T> s;
        for_each_number(s, [&](T& x) { x = T(random.integer(-2, 2)); });
        for (T* r : {&s.r0, &s.r1, &s.r2, &s.r3}) *r = T(random.integer(0, 2));
        return s;
    }
    template <class U>
    struct ball {
        vec3<U> center;
        U radius;
    };
    /// One of the spheres that are swept (de Casteljau, as no polynomial).
    static ball<T> swept(const bezier_curve<T>& s, const T& u) {
        const auto mean = [&](const auto& a, const auto& b) { return a * (T(1) - u) + b * u; };
        const auto cubic = [&](const auto& a, const auto& b, const auto& c, const auto& d) {
            const auto ab = mean(a, b), bc = mean(b, c), cd = mean(c, d), abc = mean(ab, bc), bcd = mean(bc, cd);
            return mean(abc, bcd);
        };
        return {cubic(s.p0, s.p1, s.p2, s.p3), cubic(s.r0, s.r1, s.r2, s.r3)};
    }
    static ball<double> random_ball(const bezier_curve<T>& s, random_numbers& random) {
        const double u = random.one_in(4) ? random.integer(0, 1) : random.uniform();
        const auto [center, radius] = subject<bezier_curve<double>>::swept(converted<double>(s), u);
        return {center, radius};
    }
    static vec3<double> inner_point(const bezier_curve<T>& s, random_numbers& random) {
        const auto [center, radius] = random_ball(s, random);
        return center + random.direction() * (random.uniform(0, 0.99) * radius);
    }
    /// On the curve, or on the silhouette of a sphere.
    static vec3<double> special_point(const bezier_curve<T>& s, const vec3<double>& from, random_numbers& random) {
        const auto [center, radius] = random_ball(s, random);
        const vec3<double> to_center = center - from;
        const double distance = length(to_center);
        if (random.one_in(3) || !(radius < distance)) return center;
        const double sine = radius / distance;
        return center - to_center * (sine * sine) +
               random.perpendicular(to_center) * (radius * std::sqrt(1 - sine * sine));
    }
    /// From the nearest of the spheres: about the best of many, thirds are taken away, as far as doubles can tell, and
    /// then the tips of parabolas through three neighbours double the digits.
    static oracle distance(const bezier_curve<oracle>& s, const vec3<oracle>& p) {
        const auto beyond = [&]<class U>(const bezier_curve<U>& curve, const vec3<U>& q, const U& u) {
            const auto [center, radius] = subject<bezier_curve<U>>::swept(curve, u);
            return U(length(vec3<U>(q - center)) - radius);
        };
        const auto exactly_beyond = [&](const oracle& u) { return beyond(s, p, u); };
        const bezier_curve<double> rough{vec3<double>(s.p0 - p), vec3<double>(s.p1 - p), vec3<double>(s.p2 - p),
                                         vec3<double>(s.p3 - p), rounded<double>(s.r0),  rounded<double>(s.r1),
                                         rounded<double>(s.r2),  rounded<double>(s.r3)};
        const auto roughly_beyond = [&](double u) { return beyond(rough, vec3<double>(0), u); };
        constexpr int count = 256;
        std::vector<double> sampled;
        for (int i = 0; i <= count; ++i) sampled.push_back(roughly_beyond(double(i) / count));
        const auto sample = [&](int i) { return sampled[static_cast<std::size_t>(std::clamp(i, 0, count))]; };
        oracle least = min(exactly_beyond(0), exactly_beyond(1));
        for (int i = 0; i <= count; ++i) {
            if (sample(i) > sample(i - 1) || sample(i) > sample(i + 1)) continue;
            double low = std::max(i - 1, 0) / double(count), high = std::min(i + 1, count) / double(count);
            for (int step = 0; step < 24; ++step) {
                const double a = low + (high - low) / 3, b = high - (high - low) / 3;
                if (roughly_beyond(a) < roughly_beyond(b)) {
                    high = b;
                } else {
                    low = a;
                }
            }
            oracle u = (low + high) / 2, h = (high - low) * 4;
            for (int step = 0; step < 4; ++step, h *= oracle(1e-3)) {
                const oracle here = exactly_beyond(u), before = exactly_beyond(u - h), after = exactly_beyond(u + h);
                const oracle bend = before + after - here - here;
                if (bend > 0) u = max(oracle(0), min(oracle(1), oracle(u - (after - before) / (2 * bend) * h)));
            }
            least = min(least, exactly_beyond(u));
        }
        return least;
    }
    /// Where 106 bits cannot tell the surface from a little beyond (see bezier_curve.hpp).
    static bool is_at_tip(const bezier_curve<oracle>& s, const vec3<oracle>& p) {
        const oracle near = (norm1(vec3<oracle>(s.p3 - s.p0)) + s.r0 + s.r1 + s.r2 + s.r3) * 0x1p-40;
        return (s.r0 == 0 && norm1(vec3<oracle>(p - s.p0)) < near) ||
               (s.r3 == 0 && norm1(vec3<oracle>(p - s.p3)) < near);
    }
    static constexpr bool touching_parts_are_one = true;
    static bezier_curve<oracle> grown(bezier_curve<oracle> s) {
        for (oracle* r : {&s.r0, &s.r1, &s.r2, &s.r3}) *r *= 1 + oracle(1e-40);
        return s;
    }
};

TEST_CASE_TEMPLATE("bezier_curve: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const auto of_radius = [](const vec3<T>& a, const vec3<T>& b, const vec3<T>& c, const vec3<T>& d, T r) {
        return bezier_curve<T>{a, b, c, d, r, r, r, r};
    };
    const bezier_curve<T> straight = of_radius({0, -3, 0}, {0, -1, 0}, {0, 1, 0}, {0, 3, 0}, 1),
                          arch = of_radius({-2, 0, 0}, {-2, 4, 0}, {2, 4, 0}, {2, 0, 0}, 1),
                          ball = of_radius({0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 1),
                          loop = of_radius({0, 0, 0}, {8, 8, 0}, {-8, 8, 0}, {0, 0, 0}, T(0.5)),
                          to_and_fro = of_radius({0, -1, 0}, {0, 5, 0}, {0, -5, 0}, {0, 1, 0}, 1),
                          thorn{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 3, 0}, 1, T(2) / 3, T(1) / 3, 0},
                          bead{{-4, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {4, 0, 0}, 0, 2, 2, 0};
    const ray<T> ahead{{0, 0, 5}, {0, 0, -1}}, through_legs{{-9, 0, 0}, {1, 0, 0}};
    const auto of_radii = [](T r0, T r1, T r2, T r3) {
        return bezier_curve<T>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, r0, r1, r2, r3};
    };
    check_cases<bezier_curve<T>>({
        {"straight, the side", straight, ahead, enters(4)},
        {"straight, from inside", straight, {{0, 0, 0}, {0, 0, -1}}, leaves(1)},
        {"straight, the pole", straight, {{0, 9, 0}, {0, -1, 0}}, enters(5)},
        {"straight, the other pole", straight, {{0, 9, 0}, {0, -1, 0}}, leaves(13), 6},
        {"straight, along it, from inside", straight, {{0, 0, 0}, {0, 1, 0}}, leaves(4)},
        {"straight, parallel to it, in the surface", straight, {{1, 9, 0}, {0, -1, 0}}, enters(6)},
        {"straight, one number beyond the surface", straight, {{1 + eps, 9, 0}, {0, -1, 0}}, misses},
        {"straight, tangent", straight, {{1, 0, 5}, {0, 0, -1}}, enters(5)},
        {"straight, one number beyond the tangent", straight, {{1 + eps, 0, 5}, {0, 0, -1}}, misses},
        {"straight, from the surface inwards", straight, {{0, 0, 1}, {0, 0, -1}}, enters(0)},
        {"straight, from the surface outwards", straight, {{0, 0, 1}, {0, 0, 1}}, leaves(0)},
        {"straight, behind the ray", straight, {{0, 0, 5}, {0, 0, 1}}, misses},
        {"a radius at its start alone", of_radii(1, 0, 0, 0), {{-5, 0, 0}, {1, 0, 0}}, enters(4)},
        {"a radius at its second point alone", of_radii(0, 1, 0, 0), {{1, 5, 0}, {0, -1, 0}}, enters(5 - 4.0 / 9)},
        {"a radius at its third point alone", of_radii(0, 0, 1, 0), {{2, 5, 0}, {0, -1, 0}}, enters(5 - 4.0 / 9)},
        {"a radius at its end alone", of_radii(0, 0, 0, 1), {{8, 0, 0}, {-1, 0, 0}}, enters(4)},
        {"arch, from above", arch, {{0, 9, 0}, {0, -1, 0}}, enters(5)},
        {"arch, from above, out", arch, {{0, 9, 0}, {0, -1, 0}}, leaves(7), 6},
        {"arch, from the side", arch, {{0, 3, 5}, {0, 0, -1}}, enters(4)},
        {"arch, the first leg", arch, through_legs, enters(6)},
        {"arch, out of the first leg", arch, through_legs, leaves(8), 7},
        {"arch, the second leg", arch, through_legs, enters(10), 9},
        {"arch, out of the second leg", arch, through_legs, leaves(12), 11},
        {"arch, from between the legs", arch, {{0, 0, 0}, {1, 0, 0}}, enters(1)},
        {"arch, between the legs", arch, {{0, 0, 5}, {0, 0, -1}}, misses},
        {"arch, tangent to its top", arch, {{0, 4, 5}, {0, 0, -1}}, enters(5)},
        {"arch, one number above its top", arch, {{0, 4 + 4 * eps, 5}, {0, 0, -1}}, misses},
        {"all points one: a sphere", ball, ahead, enters(4)},
        {"all points one, tangent", ball, {{0, 1, 5}, {0, 0, -1}}, enters(5)},
        {"a loop, where it ends on itself", loop, {{0, 0, 5}, {0, 0, -1}}, enters(4.5)},
        {"a loop, its top", loop, {{0, 9, 0}, {0, -1, 0}}, enters(2.5)},
        {"to and fro on a line: its middle", to_and_fro, ahead, enters(4)},
        {"thorn, its tip", thorn, {{0, 9, 0}, {0, -1, 0}}, enters(6)},
        {"thorn, its base", thorn, {{0, -9, 0}, {0, 1, 0}}, enters(8)},
        {"thorn, beside its tip", thorn, {{0, 3 + T(0x1p-20), 5}, {0, 0, -1}}, misses},
        {"bead, where it is thickest", bead, ahead, enters(3.5)},
        {"bead, along it", bead, {{-9, 0, 0}, {1, 0, 0}}, enters(5)},
        {"bead, along it, out", bead, {{-9, 0, 0}, {1, 0, 0}}, leaves(13), 6},
        {"nothing but a tangent of the sphere that it ends with",
         {{0, -1, -1}, {2, -2, 1}, {-1, 1, -1}, {-1, -1, 0}, 0, 2, 0, 1},
         {{-1, 0, -1}, {0, -1, 0}},
         enters(1)},
        {"nothing but its tip",
         {{0, 1, -2}, {0, -1, 0}, {0, 0, 0}, {2, -1, 0}, 1, 0, 1, 0},
         {{-1, -1, 0}, {1, 0, 0}},
         enters(3)},
        {"nothing but its tip, along z",
         {{0, 0, 1}, {0, 1, 2}, {2, -1, -1}, {2, 1, -2}, 1, 0, 2, 0},
         {{2, 1, 2}, {0, 0, -2}},
         enters(2)},
        {"where two of its parts touch, they are one",
         {{0, -1, -1}, {1, -1, -1}, {-2, -2, -1}, {-2, -1, -2}, 2, 1, 0, 1},
         {{-1, -2, 0}, {-2, 2, -2}},
         leaves(5 / 6.)},
        {"where s turns at a quarter of the curve",
         {{-1, -1, -2}, {2, 2, 2}, {-2, 1, -1}, {1, 0, -2}, 2, 0, 2, 1},
         {{1, -2, 0}, {0, 1, 0}},
         enters(1.5832643278157796)},
        {"where s turns at its end",
         {{-1, -1, 2}, {-1, 0, -2}, {1, 1, -2}, {-1, 2, -1}, 2, 2, 1, 1},
         {{-1, 2, -3}, {0, 0, -2}},
         misses},
        {"a line that touches every sphere, from beyond them (was hit where the ray starts)",
         {{2, 0, 0}, {1, -1, 0}, {-2, -1, 0}, {0, -1, 0}, 2, 1, 1, 1},
         {{-3, -2, 0}, {-1, 0, 0}},
         misses},
        {"direction of length 1e20", straight, {{0, 0, 5}, {0, 0, -0x1p66}}, enters(0x1p-64)},
        {"1e4 sizes away", straight, {{0, 0, T(20001)}, {0, 0, -1}}, enters(20000)},
        {"no radius", of_radius({0, -3, 0}, {0, -1, 0}, {0, 1, 0}, {0, 3, 0}, 0), ahead, misses},
        {"one radius below zero", {{0, -3, 0}, {0, -1, 0}, {0, 1, 0}, {0, 3, 0}, 1, 1, -1, 1}, ahead, misses},
        {"direction zero", straight, {{0, 0, 0}, {0, 0, 0}}, misses},
        {"window between the crossings", arch, through_legs, misses, T(8.5), T(9.5)},
        {"window that is not a number", straight, ahead, misses, nan<T>},
    });
}

TEST_CASE("bezier_curve: where a thorn is met from far away (the point lay beyond the bounds)") {
    const bezier_curve<double> thorn{{0x1.091224b35f0a4p+0, 0x1.4d178792dc569p+0, -0x1.25948b9390ce8p+1},
                                     {0x1.212866c8d130ap+0, 0x1.7b9a30237e91ep+0, -0x1.2db3bcd1b0361p-1},
                                     {0x1.152dec8522b85p+0, 0x1.4bce95c989371p+1, -0x1.aac571056791cp-1},
                                     {0x1.86e272bb098ccp+0, 0x1.2784374ed68fap-1, -0x1.8155830efbaeap-2},
                                     0x1.80b96ef774621p-3,
                                     0x1.cd13329dc7c9ep-4,
                                     0x1.56c7c8965dbabp-3,
                                     0};
    const ray<double> ray{{0x1.f31e25af2a94fp+17, 0x1.fee377571db89p+17, 0x1.b1f81fca75d64p+17},
                          {-0x1.f31d623df1377p+17, -0x1.fee32d760fe4ep+17, -0x1.b1f84ff526382p+17}};
    CHECK(inconsistent_record(probe<bezier_curve<double>>{thorn, ray, 0, infinity<double>}) == "");
    CHECK(thorn.occluded(ray, 0, 2));
}

TEST_CASE("bezier_curve: the turn just before an end, seen from far away (the normal was that of the end)") {
    const auto wrong = [](const bezier_curve<float>& curve, const ray<float>& ray) {
        worst_errors worst;
        return inexactness(probe<bezier_curve<float>>{curve, ray, 0, infinity<float>}, worst);
    };
    CHECK(wrong({{0x1.315632p+5f, -0x1.083b4ep+5f, 0x1.979fc6p+5f},
                 {-0x1.3f2162p+5f, 0x1.02175ap+5f, -0x1.4800dap+4f},
                 {-0x1.9966fep+2f, 0x1.3184eap+5f, -0x1.3ec3cp+5f},
                 {-0x1.9e4dcep+2f, -0x1.0d4d32p+2f, 0x1.4d4e04p+0f},
                 0x1.2ab35ep-2f,
                 0x1.2ab35ep-2f,
                 0x1.2ab35ep-2f,
                 0x1.2ab35ep-2f},
                {{0x1.0a6336p+21f, -0x1.0d4d32p+2f, 0x1.4d4e04p+0f}, {-0x1.778188p-3f, 0, 0}}) == "");
    CHECK(wrong({{0x1.8188b4p+18f, -0x1.4c427cp+15f, 0x1.6c02b2p+18f},
                 {-0x1.f7367ap+17f, 0x1.176918p+18f, 0x1.6d65bp+18f},
                 {-0x1.2c386ep+17f, 0x1.18316ep+18f, 0x1.86af86p+18f},
                 {0x1.fe4f7ep+16f, 0x1.d67686p+15f, -0x1.0dc63cp+14f},
                 0x1.38b2aep+11f,
                 0x1.567512p+12f,
                 0x1.b6a224p+12f,
                 0x1.70ae78p+12f},
                {{-0x1.e0d602p+31f, 0x1.5aaaaap+30f, -0x1.a00a5cp+31f},
                 {0x1.758fb8p-1f, -0x1.0d4e3p-2f, 0x1.4335bp-1f}}) == "");
}

TEST_CASE("bezier_curve: beside a tip, in double (the normal was off by twenty thousand roundings)") {
    worst_errors worst;
    CHECK(inexactness<bezier_curve<double>>({{{0x1.dc8c52f737a55p+6, 0x1.7255a1581934fp+3, -0x1.604e77ac7fe1ap+8},
                                              {0x1.3d793824ddbeap+10, 0x1.6690d72911208p+10, 0x1.91185b91ce08bp+9},
                                              {0x1.6833644e92963p-1, -0x1.0d23e65eddc5cp+2, -0x1.2ec9fb0b4f324p+0},
                                              {-0x1.17ad3f78cfb0ep+6, 0x1.9844b429be9a6p+5, 0x1.e3d8fc9a8fd31p+2},
                                              0x1.de6d88d8197ebp+6,
                                              0x1.214b30b9c9147p+6,
                                              0x1.64823ecfc6a57p+6,
                                              0},
                                             {{-0x1.17ab1c864a519p+6, 0x1.984188dea4a4ep+5, 0x1.e3c95be37fef6p+2},
                                              {-0x1.cb6508d645f76p-2, 0x1.6c03a8fcad8b1p-3, 0x1.c07182c86a004p-1}},
                                             0,
                                             0x1.13005fecdf6c8p-8},
                                            worst) == "");
}

TEST_CASE("bezier_curve: what leaves a line that touches every sphere") {
    const bezier_curve<double> curve{{-1, 0, -1}, {1, 1, -2}, {1, 0, 0}, {1, 0, 0}, 1, 0, 1, 1};  // all are below y = 1
    hit_record<double> rec{};
    REQUIRE(curve.hit({{1, 1, 0}, {-1, 0, -1}}, 0, infinity<double>, rec));
    const vec3<double> up(0x1.4c2da458f8b7cp-8, 0x1.9f8f3b68ee027p-1, -0x1.2b13eeb38bbecp-1);
    CHECK_FALSE(curve.occluded(spawn_ray(rec, up), 0, infinity<double>));
}

TEST_CASE_TEMPLATE("bezier_curve: properties of every shape", T, RAIO_NUMBERS) { check_properties<bezier_curve<T>>(); }

TEST_CASE_TEMPLATE("bezier_curve: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<bezier_curve<T>>();
    check_accuracy<bezier_curve<T>>(test_rays / 4,
                                    4e-3);  // one in 24 rays is aimed at an end, and some of these are tips
    check_bounds_of_errors<bezier_curve<T>>(test_rays / 50);
}

TEST_CASE_TEMPLATE("bezier_curve: one that is straight is a round cone", T, RAIO_NUMBERS) {
    const auto hits_as_round_cone = [](const vec3<T>& base, const vec3<T>& step, T radius, T widening,
                                       const ray<T>& r) {
        const bezier_curve<T> curve{base,   base + step,       base + step * T(2),    base + step * T(3),
                                    radius, radius + widening, radius + 2 * widening, radius + 3 * widening};
        const round_cone<T> straight{curve.p0, curve.p3, curve.r0, curve.r3};
        hit_record<T> rec{}, expected{};
        REQUIRE(curve.hit(r, T(0), infinity<T>, rec) == straight.hit(r, T(0), infinity<T>, expected));
        // Of a double, the last bits are what either formula finds.
        const T vague = norm1(rec.error) + norm1(expected.error);
        if (std::same_as<T, float>) REQUIRE(rec.t == expected.t);
        REQUIRE(std::abs(rec.t - expected.t) * length(r.direction) <= vague);
        const T turned = std::same_as<T, float> ? 0 : vague / min(radius, radius + 3 * widening);
        REQUIRE(length(vec3<T>(rec.normal - expected.normal)) < turned + 2 * std::numeric_limits<T>::epsilon());
        return rec.t > 0;
    };
    // Whose normals were 180 and 50 epsilons off in float: of u that many digits are missing where t is certain.
    CHECK(hits_as_round_cone(
        {5, 4, 3}, {-3, -4, 3}, 5, -1,
        {{0x1.74d3dcp+5f, 0x1.553b6cp+3f, 0x1.5ac40cp+6f}, {-0x1.dceb04p+5f, -0x1.4038p+4f, -0x1.592766p+6f}}));
    CHECK(hits_as_round_cone(
        {5, -9, 3}, {-7, 5, 3}, 7, 1,
        {{-0x1.0433f4p+4f, -0x1.88509ep+5f, 0x1.51cbf8p+6f}, {0x1.154052p+3f, 0x1.ed79a8p+5f, -0x1.4a5cecp+6f}}));

    random_numbers random(41);
    int hits = 0;
    for (int i = 0; i < test_rays / 10; ++i) {
        // Whole numbers and halves: what lies at a third and at two thirds is exact.
        const auto point = [&] { return vec3<T>(T(random.integer(-9, 9)), T(random.integer(-9, 9)), T(3)); };
        const vec3<T> base = point(), step = point();
        const T radius = T(random.integer(4, 9)), widening = T(random.integer(-1, 1));
        const vec3<double> from = random.direction() * 99.0, to = random.direction() * random.uniform(0, 20);
        hits += hits_as_round_cone(base, step, radius, widening, {vec3<T>(from), vec3<T>(to - from)});
    }
    CHECK(hits > test_rays / 40);
}

TEST_CASE_TEMPLATE("bezier_curve: uv", T, RAIO_NUMBERS) {
    const bezier_curve<T> curve{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}, 1, 1, 1, 1};
    const auto uv = [&](const vec3<T>& origin, const vec3<T>& direction) {
        hit_record<T> rec{};
        REQUIRE(curve.hit({origin, direction}, T(0), infinity<T>, rec));
        return rec.uv;
    };
    CHECK(uv({9, 0, T(0.75)}, {-1, 0, 0}) == vec2<T>(0, 0.25));
    CHECK(uv({0, 9, T(1.5)}, {0, -1, 0}) == vec2<T>(0.25, 0.5));
    CHECK(uv({-9, 0, T(2.25)}, {1, 0, 0}) == vec2<T>(0.5, 0.75));
    CHECK(uv({0, 0, -9}, {0, 0, 1}).y == T(0));
    CHECK(uv({0, 0, 9}, {0, 0, -1}).y == T(1));
}

TEST_CASE_TEMPLATE("bezier_curve: packs, lane by lane", T, RAIO_NUMBERS) {
    check_lanes_are_plain<bezier_curve<T>>(400);
}

}  // namespace raio::test
