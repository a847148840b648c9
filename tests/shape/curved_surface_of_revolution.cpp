#include <raio/shape/curved_surface_of_revolution.hpp>

#include <doctest/doctest.h>

#include "support/accuracy.hpp"
#include "support/cases.hpp"
#include "support/profiles.hpp"

namespace raio::test {

namespace {

/// Its segments go on smoothly, and begin or end on the axis now and then.
template <class T>
curved_surface_of_revolution<T> random_curved_surface(random_numbers& random) {
    const double size = random.log_uniform(1e-3, 1e3);
    curved_surface_of_revolution<T> s;
    s.base = vec3<T>(random.direction() * size * random.log_uniform(0.01, 100));
    s.axis = vec3<T>(random.axis() * random.log_uniform(1e-2, 1e2));
    const double unit = size / static_cast<double>(length(s.axis));
    for (int i = 3 * random.integer(1, 2); i >= 0; --i) {
        const bool end = s.profile.empty() || i == 0;
        s.profile.emplace_back(static_cast<T>(end && random.one_in(4) ? 0 : size * random.uniform()),
                               static_cast<T>(unit * random.uniform(-1, 1)));
    }
    return s;
}

/// Where the profile is at the parameter s of a segment, counted on from the segments before (de Casteljau).
template <class U, class T>
vec2<U> on_profile(const curved_surface_of_revolution<T>& surface, const U& s) {
    const std::size_t segments = (surface.profile.size() - 1) / 3;
    std::size_t i = 0;
    while (i + 1 < segments && U(static_cast<double>(i + 1)) <= s) ++i;
    const U u = s - U(static_cast<double>(i));
    std::array<vec2<U>, 4> mean;
    for (std::size_t k = 0; k < 4; ++k) mean[k] = vec2<U>(surface.profile[3 * i + k]);
    for (std::size_t n = 3; n > 0; --n) {
        for (std::size_t k = 0; k < n; ++k) mean[k] = mean[k] * (U(1) - u) + mean[k + 1] * u;
    }
    return mean[0];
}

/// The same with a straight line instead of each of many parts of a segment.
template <class T>
surface_of_revolution<T> straightened(const curved_surface_of_revolution<T>& surface, int parts) {
    surface_of_revolution<T> s{surface.base, surface.axis, {}};
    const int count = parts * static_cast<int>((surface.profile.size() - 1) / 3);
    for (int i = 0; i <= count; ++i) s.profile.push_back(on_profile(surface, T(i) / T(parts)));
    return s;
}

}  // namespace

TEST_CASE_TEMPLATE("curved surface of revolution: named cases", T, RAIO_NUMBERS) {
    // The square of the radius is the height.
    const curved_surface_of_revolution<T> dish{{0, 0, 0}, {0, 1, 0}, {{0, 0}, {1, 0}, {2, 3}, {3, 9}}},
        tube{{0, 0, 0}, {0, 2, 0}, {{1, 0}, {1, 1}, {1, 2}, {1, 3}}},
        lid{{0, 0, 0}, {0, 2, 0}, {{3, 1}, {2, 1}, {1, 1}, {0, 1}}},
        // Out to a radius of 3 at a height of 0, and back.
        bulge{{0, 0, 0}, {0, 1, 0}, {{0, -4}, {4, -4}, {4, 4}, {0, 4}}},
        can{{0, 0, 0}, {0, 2, 0}, {{1, 0}, {1, 1}, {1, 2}, {1, 3}, {T(2) / 3, 3}, {T(1) / 3, 3}, {0, 3}}},
        short_of_one{{0, 0, 0}, {0, 1, 0}, {{1, 0}, {1, 1}, {1, 2}}},
        turned_in{{0, 0, 0}, {0, 1, 0}, {{-1, 0}, {-1, 1}, {-1, 2}, {-1, 3}}},
        turned_in_once{{0, 0, 0}, {0, 1, 0}, {{1, 0}, {1, 1}, {T(-0.5), 2}, {1, 3}}},
        no_axis{{0, 0, 0}, {0, 0, 0}, {{1, 0}, {1, 1}, {1, 2}, {1, 3}}},
        not_a_number{{0, 0, 0}, {0, 1, 0}, {{1, 0}, {1, nan<T>}, {1, 2}, {1, 3}}},
        endless{{0, 0, 0}, {0, 1, 0}, {{1, 0}, {infinity<T>, 1}, {1, 2}, {1, 3}}},
        of_endless_axis{{0, 0, 0}, {0, infinity<T>, 0}, {{1, 0}, {1, 1}, {1, 2}, {1, 3}}},
        nowhere_near{{0, infinity<T>, 0}, {0, 1, 0}, {{1, 0}, {1, 1}, {1, 2}, {1, 3}}};
    struct row {
        const char* name;
        const curved_surface_of_revolution<T>& shape;
        raio::ray<T> ray;
        expectation expected;
        std::uint32_t segment = 0;
        T t_min = 0;
    };
    for (const row& r : std::initializer_list<row>{
             {"down into the dish", dish, {{2, 9, 0}, {0, -1, 0}}, leaves(5)},
             {"up to the dish", dish, {{2, -9, 0}, {0, 1, 0}}, enters(13)},
             {"across the dish", dish, {{-9, 4, 0}, {1, 0, 0}}, enters(7)},
             {"across the dish, out", dish, {{-9, 4, 0}, {1, 0, 0}}, leaves(11), 0, 8},
             {"from the axis of the dish", dish, {{0, 4, 0}, {0, 0, 1}}, leaves(2)},
             {"onto the vertex", dish, {{0, -9, 0}, {0, 1, 0}}, enters(9)},
             {"the rim of the dish", dish, {{-9, 9, 0}, {1, 0, 0}}, enters(6)},
             {"above the rim", dish, {{-9, T(9.5), 0}, {1, 0, 0}}, misses},
             {"under the vertex", dish, {{-9, T(-0.5), 0}, {1, 0, 0}}, misses},
             {"through the dish, slanting", dish, {{-1, 1, 0}, {1, 1, 0}}, leaves(3), 0, T(0.5)},
             {"a tube", tube, {{5, 2, 0}, {-1, 0, 0}}, enters(4)},
             {"a tube, along its axis", tube, {{0, 9, 0}, {0, -1, 0}}, misses},
             {"a lid from above", lid, {{2, 9, 0}, {0, -1, 0}}, enters(7)},
             {"a lid from below", lid, {{2, 0, 0}, {0, 1, 0}}, leaves(2)},
             {"in the plane of the lid", lid, {{9, 2, 0}, {-1, 0, 0}}, misses},
             {"beside the lid", lid, {{4, 9, 0}, {0, -1, 0}}, misses},
             {"where it bulges", bulge, {{9, 0, 0}, {-1, 0, 0}}, enters(6)},
             {"where it bulges, the far side", bulge, {{9, 0, 0}, {-1, 0, 0}}, leaves(12), 0, 7},
             {"down along the bulge", bulge, {{3, 9, 0}, {0, -1, 0}}, enters(9)},
             {"beside the bulge", bulge, {{T(3.001), 9, 0}, {0, -1, 0}}, misses},
             {"beside the bulge, where it is widest (was hit from anywhere at that height)",
              bulge,
              {{-9, 0, 4}, {1, 0, 0}},
              misses},
             {"the bulge, from its middle up", bulge, {{0, 0, 0}, {0, 1, 0}}, leaves(4)},
             {"the can's side", can, {{5, 2, 0}, {-1, 0, 0}}, enters(4), 0},
             {"the can's lid", can, {{T(0.5), 9, 0}, {0, -1, 0}}, enters(3), 1},
             {"where the side and the lid meet", can, {{5, 6, 0}, {-1, 0, 0}}, enters(4), 0},
             {"one point short", short_of_one, {{5, 1, 0}, {-1, 0, 0}}, misses},
             {"radii below 0", turned_in, {{5, 1, 0}, {-1, 0, 0}}, misses},
             {"one radius below 0", turned_in_once, {{5, T(0.5), 0}, {-1, 0, 0}}, misses},
             {"axis zero", no_axis, {{5, 1, 0}, {-1, 0, 0}}, misses},
             {"a height that is not a number", not_a_number, {{5, 1, 0}, {-1, 0, 0}}, misses},
             {"an infinite radius", endless, {{5, 1, 0}, {-1, 0, 0}}, misses},
             {"an infinite axis", of_endless_axis, {{5, 1, 0}, {-1, 0, 0}}, misses},
             {"at infinity", nowhere_near, {{5, 1, 0}, {-1, 0, 0}}, misses},
             {"direction zero", dish, {{0, 1, 0}, {0, 0, 0}}, misses},
             {"window that is not a number", dish, {{2, 9, 0}, {0, -1, 0}}, misses, 0, nan<T>},
         }) {
        INFO(std::string(r.name));
        hit_record<T> rec{};
        CHECK(r.shape.hit(r.ray, r.t_min, infinity<T>, rec) == r.expected.hit);
        CHECK(r.shape.occluded(r.ray, r.t_min, infinity<T>) == r.expected.hit);
        // Of a double, the last bits are what the formula finds.
        const T off = std::same_as<T, float> ? 0 : T(1e-13);
        CHECK(std::abs(rec.t - static_cast<T>(r.expected.t)) <= off);
        CHECK(rec.index == r.segment);
        CHECK(rec.front_face == r.expected.front_face);
    }
}

TEST_CASE_TEMPLATE("curved surface of revolution: straight lines and a parabola", T, RAIO_NUMBERS) {
    random_numbers random(34);
    int hits = 0;
    for (int i = 0; i < test_rays / 5; ++i) {
        // Thirds of a line between whole numbers, three times as large.
        const auto whole = [&](int low) { return vec2<T>(T(random.integer(low, 3)), T(random.integer(-3, 3))); };
        const vec2<T> from = whole(1) * T(3), to = whole(0) * T(3), third = (to - from) / T(3);
        const vec3<T> base(0), axis{0, T(random.integer(1, 3)), T(random.integer(-2, 2))};
        const surface_of_revolution<T> straight{base, axis, {from, to}};
        const curved_surface_of_revolution<T> curved{base, axis, {from, from + third, to - third, to}};
        const open_paraboloid<T> parabola{base, base + axis * T(9), T(3)};
        const curved_surface_of_revolution<T> dish{base, axis, {{0, 0}, {1, 0}, {2, 3}, {3, 9}}};
        const vec3<T> origin(random.direction() * 99.0);
        const ray<T> r{origin, vec3<T>(random.direction() * random.uniform(0, 30)) - origin};
        hit_record<T> rec{}, expected{};
        const auto compare = [&](const auto& a, const auto& b) {
            const bool hit = a.hit(r, T(0), infinity<T>, rec);
            REQUIRE(hit == b.hit(r, T(0), infinity<T>, expected));
            if (!hit) return;
            ++hits;
            const T vague = norm1(rec.error) + norm1(expected.error);  // the last bits of a double
            if (std::same_as<T, float>) REQUIRE(rec.t == expected.t);
            REQUIRE(std::abs(rec.t - expected.t) * length(r.direction) <= vague);
            REQUIRE(rec.front_face == expected.front_face);
            // What the point may be off by, of a line that all but touches, turns the normal about the axis.
            const vec3<T> beside = cross(vec3<T>(rec.point - a.base), a.axis) / length(a.axis);
            const T turn = norm1(rec.error) / (length(beside) + std::numeric_limits<T>::min());
            REQUIRE(length(vec3<T>(rec.normal - expected.normal)) < turn + 32 * std::numeric_limits<T>::epsilon());
        };
        if (from != to) compare(curved, straight);
        compare(dish, parabola);
    }
    CHECK(hits > test_rays / 20);
}

TEST_CASE_TEMPLATE("curved surface of revolution: across the axis, where roots are double, to the last digit", T,
                   RAIO_NUMBERS) {
    // The square of the radius is the height.
    const curved_surface_of_revolution<T> dish{{0, 0, 0}, {0, 1, 0}, {{0, 0}, {1, 0}, {2, 3}, {3, 9}}};
    for (int i = 1; i < 72; ++i) {
        const oracle height = oracle(i) / 8;
        hit_record<T> rec{};
        REQUIRE(dish.hit({{-9, T(i) / 8, 0}, {1, 0, 0}}, T(0), infinity<T>, rec));
        CHECK(rec.t == rounded<T>(9 - sqrt(height)));
        REQUIRE(dish.hit({{-9, T(i) / 8, 0}, {1, 0, 0}}, T(9), infinity<T>, rec));
        CHECK(rec.t == rounded<T>(9 + sqrt(height)));
    }
}

TEST_CASE("curved surface of revolution: the point in which it meets the axis lies within its bounds") {
    random_numbers random(36);
    for (int i = 0; i < at_least(1'000); ++i) {
        const curved_surface_of_revolution<double> shape{
            {0, 0, 0}, {0, 0, 1}, {{0, -1}, {random.uniform(), -0.5}, {random.uniform(), 0.5}, {0, 1}}};
        const vec3<double> origin = random.direction() * random.log_uniform(0.1, 30),
                           beside = random.direction() * random.log_uniform(1e-16, 1e-9);
        const ray<double> ray{origin, vec3<double>(0, 0, 1) - origin + beside};
        hit_record<double> rec{};
        for (double t = 0; shape.hit(ray, t, infinity<double>, rec); t = std::nextafter(rec.t, infinity<double>)) {
            REQUIRE_MESSAGE(shape.bounds().contains(rec.point), literal(ray));
        }
    }
}

TEST_CASE_TEMPLATE("curved surface of revolution: as exact arithmetic", T, RAIO_NUMBERS) {
    random_numbers random(35);
    const int rays = test_rays / 2;
    int hits = 0, undecided = 0, certain = 0;
    for (int i = 0; i < rays; ++i) {
        const auto s = random_curved_surface<T>(random);
        const ray<T> r = random_ray(s, random);
        if (!(dot(r.direction, r.direction) > T(0))) continue;
        CAPTURE(literal(r));
        const auto points = [&] {
            std::string text = literal(s.base) + literal(s.axis);
            for (const vec2<T>& p : s.profile) text += literal(p);
            return text;
        };
        CAPTURE(points());
        hit_record<T> rec{};
        const bool hit = s.hit(r, T(0), infinity<T>, rec);
        REQUIRE(s.occluded(r, T(0), infinity<T>) == hit);

        // In 75 digits: every crossing lies on the profile, and the first of them in the window is the answer.
        const ray<oracle> exact_ray{vec3<oracle>(r.origin), vec3<oracle>(r.direction)};
        const vec3<oracle> base(s.base), axis(s.axis);
        oracle first = infinity<oracle>;
        for (std::size_t k = 0; k + 3 < s.profile.size(); k += 3) {
            const vec2<T>* p = &s.profile[k];
            const detail::revolved_piece<oracle, 3> piece{
                base, axis, vec2<oracle>(p[0]), vec2<oracle>(p[1]), vec2<oracle>(p[2]), vec2<oracle>(p[3])};
            const auto exact = piece.crossings(line_in<oracle>(exact_ray));
            const detail::revolved_piece<T, 3> own{s.base, s.axis, p[0], p[1], p[2], p[3]};
            const auto quick = own.crossings(line_in<strict_double>(r));
            for (std::size_t n = 0; quick.certain && n < quick.count; ++n) {
                REQUIRE(quick.count == exact.count);
                const crossing<strict_double>& c = quick.crossings[n];
                REQUIRE(abs(exactly(c.t) - exact.crossings[n].t) <= exactly(c.error));
                ++certain;
            }
            for (const crossing<oracle>& c : exact) {
                const vec3<oracle> at = exact_ray.origin + exact_ray.direction * c.t - base;
                const oracle size = length(axis), rho = length(cross(at, axis)) / size;
                const vec2<oracle> on = on_profile(
                    curved_surface_of_revolution<oracle>{base, axis, {piece.p0, piece.p1, piece.p2, piece.p3}}, c.u);
                // The place on the profile is off by c.v, where that goes 6 times its farthest point at most.
                oracle farthest = 0;
                for (const vec2<oracle>& end : {piece.p0, piece.p1, piece.p2, piece.p3}) {
                    farthest = max(farthest, max(abs(end.x), abs(end.y) * size));
                }
                const oracle allowed = c.error * length(exact_ray.direction) + c.v * 6 * farthest +
                                       (length(at) + length(base)) * oracle(1e-20);
                REQUIRE(abs(rho - on.x) < allowed);
                REQUIRE(abs(dot(at, axis) / size - on.y * size) < allowed);
                if (rounded<T>(c.t) >= 0) first = min(first, c.t);
            }
        }
        oracle off = first * 4 * std::numeric_limits<T>::epsilon();
        if (std::same_as<T, double>) off += oracle(norm1(rec.error)) / length(exact_ray.direction);
        const bool right = hit == is_finite(first) && (!hit || abs(oracle(rec.t) - first) <= off);
        if (hit) REQUIRE(s.bounds().contains(rec.point));
        if (std::same_as<T, double> && !right) {
            ++undecided;  // 106 bits need not tell where the profile meets the axis, which one in fifty is aimed at
            continue;
        }
        REQUIRE(right);
        if (!hit) continue;
        ++hits;
        if (std::same_as<T, float>) REQUIRE(rec.t == rounded<T>(first));
        CAPTURE(literal(rec));
        REQUIRE(dot(rec.normal, r.direction) <= T(0));
        REQUIRE((rec.uv.x >= 0 && rec.uv.x <= 1 && rec.uv.y >= 0 && rec.uv.y <= 1));
    }
    CHECK(hits > rays / 4);
    CHECK(certain > rays);
    const double expected = rays / 50.0;  // in a short run chance has its share
    CHECK(undecided < expected + 3 * std::sqrt(expected));
}

TEST_CASE("curved surface of revolution: where no number says the point, it is missed") {
    const float most = std::numeric_limits<float>::max();
    const curved_surface_of_revolution<float> tower{{0, 0, 0}, {0, most / 2, 0}, {{1, 0}, {1, 1}, {1, 2}, {1, 4}}};
    const auto rising = [](float y) { return ray<float>{{-5, 0, 0}, {1, y, 0}}; };  // meets it at t = 4, and at t = 6
    hit_record<float> rec{};
    REQUIRE(tower.hit(rising(most / 16), 0, infinity<float>, rec));
    CHECK((rec.t == 4 && rec.point.y == most / 4));
    CHECK(tower.occluded(rising(most / 16), 0, infinity<float>));
    CHECK(!tower.hit(rising(most / 3), 0, infinity<float>, rec));
    CHECK(!tower.occluded(rising(most / 3), 0, infinity<float>));
}

TEST_CASE("curved surface of revolution: as many straight segments") {
    random_numbers random(36);
    int hits = 0, other = 0;
    for (int i = 0; i < 30; ++i) {
        const auto curved = random_curved_surface<double>(random);
        const auto straight = straightened(curved, 1000);
        for (int k = 0; k < 30; ++k) {
            const vec2<double> at = curved.profile[static_cast<std::size_t>(random.integer(0, 3))];
            const vec3<double> target = curved.base + curved.axis * (at.y * random.uniform()) +
                                        random.perpendicular(curved.axis) * (at.x * random.uniform());
            const vec3<double> from =
                target + random.direction() * (4 * norm1(curved.axis) * std::abs(at.y) + 4 * at.x);
            const ray<double> r{from, target - from};
            hit_record<double> rec{}, expected{};
            const bool hit = curved.hit(r, 0, infinity<double>, rec);
            const bool expected_hit = straight.hit(r, 0, infinity<double>, expected);
            const double size = length(curved.bounds().max - curved.bounds().min);
            const bool same_place = hit && expected_hit && length(rec.point - expected.point) < 1e-3 * size;
            hits += hit;
            other += hit != expected_hit || (hit && !same_place);  // at a silhouette, or at the end of a profile
            if (same_place && std::abs(dot(expected.normal, normalize(r.direction))) > 0.1) {
                REQUIRE(length(rec.point - expected.point) < 1e-4 * size);
                REQUIRE(std::abs(rec.uv.y - expected.uv.y) < 0.01);
            }
        }
    }
    CHECK(hits > 300);
    CHECK(other < 10);
}

TEST_CASE_TEMPLATE("curved surface of revolution: closed where its profile begins and ends on the axis", T,
                   RAIO_NUMBERS) {
    random_numbers random(37);
    const curved_surface_of_revolution<T> vase{{T(0.1), T(-0.7), 3},
                                               {T(0.3), T(1.1), T(-0.2)},
                                               {{0, 0},
                                                {T(0.5), 0},
                                                {1, T(-0.1)},
                                                {1, T(0.3)},
                                                {1, T(0.7)},
                                                {T(0.6), T(0.8)},
                                                {T(0.7), T(1.2)},
                                                {T(0.8), T(1.6)},
                                                {T(0.3), T(1.7)},
                                                {0, T(1.7)}}};
    for (int i = 0; i < test_rays / 5; ++i) {
        const vec3<T> from = vase.base + vase.axis * static_cast<T>(random.uniform(0.2, 1.5));
        const vec2<T> rim = vase.profile[static_cast<std::size_t>(3 * random.integer(0, 3))];
        const vec3<T> target =
            vase.base + vase.axis * rim.y + vec3<T>(random.perpendicular(to_double(vase.axis))) * rim.x;
        hit_record<T> rec{};
        REQUIRE(vase.hit({from, target - from}, T(0), infinity<T>, rec));
    }
}

}  // namespace raio::test
