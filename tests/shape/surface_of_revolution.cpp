#include <raio/shape/surface_of_revolution.hpp>

#include <doctest/doctest.h>

#include "support/accuracy.hpp"
#include "support/cases.hpp"
#include "support/frusta.hpp"

namespace raio::test {

namespace {

/// A goblet, and its hollow: from the middle of its foot to the middle of its cup.
template <class T>
surface_of_revolution<T> goblet() {
    return {{0, 0, 0},
            {0, 2, 0},
            {{0, 0},
             {2, 0},
             {2, T(0.125)},
             {T(0.5), T(0.25)},
             {T(0.5), 1},
             {2, 2},
             {2, 3},
             {T(1.5), 3},
             {T(1.5), 2},
             {0, T(1.25)}}};
}

template <class T>
surface_of_revolution<T> random_surface(random_numbers& random) {
    const double size = random.log_uniform(1e-3, 1e3);
    surface_of_revolution<T> s;
    s.base = vec3<T>(random.direction() * size * random.log_uniform(0.01, 100));
    s.axis = vec3<T>(random.direction() * random.log_uniform(1e-2, 1e2));
    const double unit = size / static_cast<double>(length(s.axis));
    for (int i = random.integer(2, 6); i > 0; --i) {
        vec2<T> next(static_cast<T>(random.one_in(4) ? 0 : size * random.uniform()),
                     static_cast<T>(unit * random.uniform(-1, 1)));
        if (!s.profile.empty() && random.one_in(4)) next.y = s.profile.back().y;
        s.profile.push_back(next);
    }
    return s;
}

/// A ray to a rim or to anywhere near.
template <class T>
ray<T> random_ray(const surface_of_revolution<T>& s, random_numbers& random) {
    const vec3<double> axis = to_double(s.axis), base = to_double(s.base);
    const vec2<T> at = s.profile[static_cast<std::size_t>(random.integer(0, static_cast<int>(s.profile.size()) - 1))];
    double rho = static_cast<double>(at.x), height = static_cast<double>(at.y);
    if (!random.one_in(4)) rho *= random.uniform(), height *= random.uniform(0, 1.2);
    const vec3<double> target = base + axis * height + random.perpendicular(axis) * rho;
    const double size = length(axis) * std::abs(height) + rho;
    const vec3<double> from = target + random.direction() * size * random.log_uniform(0.1, 1e3);
    ray<T> r{vec3<T>(from), vec3<T>(target - from)};
    if (random.one_in(8)) r.direction = r.direction - s.axis * (dot(r.direction, s.axis) / dot(s.axis, s.axis));
    if (random.one_in(8)) r.direction = s.axis;
    return r;
}

/// All crossings in 50 digits, in order, and the segments that they lie on.
template <class T>
std::vector<oracle> exact_crossings(const surface_of_revolution<T>& s, const ray<T>& r) {
    std::vector<oracle> all;
    const ray<oracle> exact_ray{vec3<oracle>(r.origin), vec3<oracle>(r.direction)};
    const vec3<oracle> base(s.base), axis(s.axis);
    for (std::size_t i = 0; i + 1 < s.profile.size(); ++i) {
        const vec2<oracle> from(s.profile[i]), to(s.profile[i + 1]);
        if (from.y == to.y) {
            const ring<oracle> piece{vec3<oracle>(base + axis * from.y), axis, min(from.x, to.x), max(from.x, to.x)};
            if (const auto c = piece.crossings<oracle>(exact_ray); c.exists) all.push_back(c.t);
        } else {
            const open_frustum<oracle> piece{vec3<oracle>(base + axis * from.y), vec3<oracle>(base + axis * to.y),
                                             from.x, to.x};
            const auto c = piece.crossings<oracle>(exact_ray);
            if (c.near.exists) all.push_back(c.near.t);
            if (c.far.exists) all.push_back(c.far.t);
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

TEST_CASE_TEMPLATE("surface of revolution: named cases", T, float, double) {
    const surface_of_revolution<T> cup = goblet<T>(), tube{{0, 0, 0}, {0, 0, 1}, {{1, 0}, {1, 4}}},
                                   point{{0, 0, 0}, {0, 0, 1}, {{1, 0}}}, nothing{{0, 0, 0}, {0, 0, 1}, {}},
                                   turned_in{{0, 0, 0}, {0, 0, 1}, {{-1, 0}, {-1, 4}}},
                                   no_axis{{0, 0, 0}, {0, 0, 0}, {{1, 0}, {1, 4}}},
                                   not_a_number{{0, 0, 0}, {0, 0, 1}, {{1, 0}, {1, nan<T>}}};
    struct row {
        const char* name;
        const surface_of_revolution<T>& shape;
        raio::ray<T> ray;
        expectation expected;
        std::uint32_t segment = 0;
        T t_min = 0;
    };
    for (const row& r : std::initializer_list<row>{
             {"the foot from the side", cup, {{5, T(0.125), 0}, {-1, 0, 0}}, enters(3), 1},
             {"the stem", cup, {{5, 1, 0}, {-1, 0, 0}}, enters(4.5), 3},
             {"the stem, from within", cup, {{0, 1, 0}, {-1, 0, 0}}, leaves(0.5), 3},
             {"the cup", cup, {{5, 5, 0}, {-1, 0, 0}}, enters(3), 5},
             {"the cup, its inside", cup, {{5, 5, 0}, {-1, 0, 0}}, enters(3.5), 7, T(3.25)},
             {"the cup, the far side", cup, {{5, 5, 0}, {-1, 0, 0}}, leaves(6.5), 7, T(4)},
             {"the cup, the far side's outside", cup, {{5, 5, 0}, {-1, 0, 0}}, leaves(7), 5, T(6.75)},
             {"the rim from above", cup, {{1.75, 9, 0}, {0, -1, 0}}, enters(3), 6},
             {"down into the cup", cup, {{0, 9, 0}, {0, -1, 0}}, leaves(6.5), 8},
             {"the foot from below", cup, {{1, -3, 0}, {0, 1, 0}}, leaves(3), 0},
             {"where two segments meet", cup, {{5, 4, 0}, {-1, 0, 0}}, enters(3), 4},
             {"above all", cup, {{5, T(6.5), 0}, {-1, 0, 0}}, misses},
             {"a tube through its open end", tube, {{0, 0, 9}, {0, 0, -1}}, misses},
             {"a tube, at its rim", tube, {{5, 0, 4}, {-1, 0, 0}}, enters(4), 0},
             {"a single point", point, {{5, 0, 0}, {-1, 0, 0}}, misses},
             {"no profile", nothing, {{5, 0, 0}, {-1, 0, 0}}, misses},
             {"radii below 0", turned_in, {{5, 0, 1}, {-1, 0, 0}}, misses},
             {"axis zero", no_axis, {{5, 0, 1}, {-1, 0, 0}}, misses},
             {"a height that is not a number", not_a_number, {{5, 0, 1}, {-1, 0, 0}}, misses},
             {"direction zero", cup, {{0, 1, 0}, {0, 0, 0}}, misses},
             {"window that is not a number", cup, {{5, 1, 0}, {-1, 0, 0}}, misses, 0, nan<T>},
         }) {
        INFO(std::string(r.name));
        hit_record<T> rec;
        CHECK(r.shape.hit(r.ray, r.t_min, infinity<T>, rec) == r.expected.hit);
        CHECK(r.shape.occluded(r.ray, r.t_min, infinity<T>) == r.expected.hit);
        CHECK(rec.t == static_cast<T>(r.expected.t));
        CHECK(rec.index == r.segment);
        CHECK(rec.front_face == r.expected.front_face);
    }
}

TEST_CASE_TEMPLATE("surface of revolution: as exact arithmetic", T, float, double) {
    random_numbers random(31);
    const int rays = normal_run / 4;
    int hits = 0;
    for (int i = 0; i < rays; ++i) {
        const surface_of_revolution<T> s = random_surface<T>(random);
        const ray<T> r = random_ray(s, random);
        if (!(dot(r.direction, r.direction) > T(0))) continue;
        const T t_min = random.one_in(4) ? T(-1) : T(0);
        CAPTURE(literal(r));
        std::string points = literal(s.base) + literal(s.axis);
        for (const vec2<T>& p : s.profile) points += literal(p);
        CAPTURE(points);
        hit_record<T> rec;
        const bool hit = s.hit(r, t_min, infinity<T>, rec);
        REQUIRE(s.occluded(r, t_min, infinity<T>) == hit);
        const std::vector<oracle> exact = exact_crossings(s, r);
        const auto first = std::ranges::find_if(exact, [&](const oracle& t) { return rounded<T>(t) >= t_min; });
        if (std::same_as<T, double> && hit != (first != exact.end())) continue;  // 106 bits need not tell at a rim
        REQUIRE(hit == (first != exact.end()));
        if (!hit) continue;
        ++hits;
        if (std::same_as<T, float>) REQUIRE(rec.t == rounded<T>(*first));
        REQUIRE(abs(oracle(rec.t) - *first) <= abs(*first) * 4 * std::numeric_limits<T>::epsilon());
        REQUIRE(s.bounds().contains(rec.point));
        CAPTURE(literal(rec));
        REQUIRE(dot(rec.normal, r.direction) <= T(0));
        REQUIRE((rec.uv.x >= 0 && rec.uv.x <= 1 && rec.uv.y >= 0 && rec.uv.y <= 1));
    }
    CHECK(hits > rays / 4);
}

TEST_CASE_TEMPLATE("surface of revolution: closed where its profile begins and ends on the axis", T, float, double) {
    random_numbers random(32);
    const surface_of_revolution<T> vase{{T(0.1), T(-0.7), 3},
                                        {T(0.3), T(1.1), T(-0.2)},
                                        {{0, 0}, {1, T(0.1)}, {T(0.7), T(0.9)}, {T(0.7), T(1.3)}, {0, T(1.7)}}};
    for (int i = 0; i < normal_run / 2; ++i) {
        const vec3<T> from = vase.base + vase.axis * static_cast<T>(random.uniform(0.4, 1.2));
        const vec2<T> rim = vase.profile[static_cast<std::size_t>(random.integer(0, 4))];
        const vec3<T> target =
            vase.base + vase.axis * rim.y + vec3<T>(random.perpendicular(to_double(vase.axis))) * rim.x;
        hit_record<T> rec;
        REQUIRE(vase.hit({from, target - from}, T(0), infinity<T>, rec));
        REQUIRE(!rec.front_face);
    }
}

TEST_CASE_TEMPLATE("surface of revolution: uv and area, and points that lie on it", T, float, double) {
    const surface_of_revolution<T> cup = goblet<T>();
    const frame<T> f = frame_about(vec3<T>(0, 1, 0));
    hit_record<T> rec;
    const auto uv_towards = [&](const vec3<T>& out, T height) {
        REQUIRE(cup.hit({out * T(9) + vec3<T>(0, height, 0), -out}, T(0), infinity<T>, rec));
        return rec.uv;
    };
    CHECK(uv_towards(f.x, T(5)).x == 0);
    CHECK(uv_towards(f.y, T(5)).x == T(0.25));
    CHECK(uv_towards(-f.y, T(5)).y == doctest::Approx((5 + 0.5) / 9));
    // The rim's v goes inwards, as the profile does.
    REQUIRE(cup.hit({f.x * T(1.625) + vec3<T>(0, 9, 0), {0, -1, 0}}, T(0), infinity<T>, rec));
    CHECK(rec.uv.y == doctest::Approx((6 + 0.75) / 9));

    const surface_of_revolution<T> can{{1, 2, 3}, {0, 0, 2}, {{0, 0}, {3, 0}, {3, 2}, {0, 2}}};
    CHECK(can.area() == doctest::Approx(cylinder<T>{{1, 2, 3}, {1, 2, 7}, 3}.area()));
    random_numbers random(33);
    int on_side = 0;
    for (int i = 0; i < 4000; ++i) {
        const surface_sample<T> s = can.sample({T(random.uniform()), T(random.uniform())});
        REQUIRE(can.bounds().contains(s.point));
        const T rho = std::hypot(s.point.x - 1, s.point.y - 2), height = s.point.z - 3;
        const bool side = std::abs(rho - 3) < T(1e-5) && height >= 0 && height <= 4;
        REQUIRE((side || (rho <= 3 && (std::abs(height) < T(1e-5) || std::abs(height - 4) < T(1e-5)))));
        on_side += std::abs(s.normal.z) < T(0.5);
    }
    CHECK(on_side == doctest::Approx(4000.0 * 24 / 42).epsilon(0.05));
}

}  // namespace raio::test
