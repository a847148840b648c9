#include <raio/shape/surface_of_revolution.hpp>

#include <doctest/doctest.h>

#include "support/accuracy.hpp"
#include "support/bounds.hpp"
#include "support/cases.hpp"
#include "support/frusta.hpp"
#include "support/profiles.hpp"
#include "support/sampling.hpp"

namespace raio::test {

/// Those of a segment of a profile in 75 digits, as those of the shape that it is.
inline chord<oracle> crossings_of_piece(const vec3<oracle>& base, const vec3<oracle>& axis, const vec2<oracle>& from,
                                        const vec2<oracle>& to, const ray<oracle>& r) {
    const vec3<oracle> start = base + axis * from.y, end = base + axis * to.y;
    if (from.y != to.y) return open_frustum<oracle>{start, end, from.x, to.x}.crossings(line_in<oracle>(r));
    chord<oracle> c{};
    c.near = ring<oracle>{start, axis, min(from.x, to.x), max(from.x, to.x)}.crossings(line_in<oracle>(r));
    return c;
}

/// A surface whose profile is one segment, of which `crossings` can be asked.
template <real T>
struct lone_segment {
    using number = T;

    vec3<T> base, axis;
    T from_radius, from_height, to_radius, to_height;

    detail::revolved_piece<T, 1> piece() const {
        return {base, axis, {from_radius, from_height}, {to_radius, to_height}};
    }
    surface_of_revolution<T> whole() const {
        return {base, axis, {{from_radius, from_height}, {to_radius, to_height}}};
    }
    template <record Record>
    bool hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return whole().hit(ray, t_min, t_max, rec);
    }
    bool occluded(const ray<T>& ray, T t_min, T t_max) const { return whole().occluded(ray, t_min, t_max); }
    template <class Line>
    auto crossings(const Line& line) const {
        if constexpr (std::same_as<T, oracle>) {
            return crossings_of_piece(base, axis, {from_radius, from_height}, {to_radius, to_height}, line.ray);
        } else {
            return piece().crossings(line);
        }
    }
    template <class Point>
    void surface(Point& at) const {
        piece().surface(at);
    }
};

struct segment_profile {
    static auto ends(const auto& s) {
        const auto base = to_double(s.base), axis = to_double(s.axis);
        return std::pair(base + axis * static_cast<double>(s.from_height),
                         base + axis * static_cast<double>(s.to_height));
    }
    static double radius(const auto& s, double h) {
        return static_cast<double>(s.from_radius) * (1 - h) + static_cast<double>(s.to_radius) * h;
    }
    static double slope(const auto& s, double) { return static_cast<double>(s.to_radius - s.from_radius); }
    static double height(const auto&, random_numbers& random) { return random.uniform(0.01, 0.99); }
};

template <class T>
struct subject<lone_segment<T>> : revolved_subject<lone_segment<T>, segment_profile> {
    static auto fields(auto& s) {
        return std::tie(s.base, s.axis, s.from_radius, s.from_height, s.to_radius, s.to_height);
    }
    /// One in four is a ring, one in four comes to a point, one in eight is a cylinder.
    static lone_segment<T> random(random_numbers& random, double size, const vec3<double>& place) {
        const double unit = random.log_uniform(1e-2, 1e2);
        const auto radius = [&] { return static_cast<T>(size * random.log_uniform(0.1, 1)); };
        const auto height = [&] { return static_cast<T>(size / unit * random.uniform(-2, 2)); };
        lone_segment<T> s{vec3<T>(place), vec3<T>(random.axis() * unit), radius(), height(), radius(), height()};
        if (random.one_in(4)) s.to_height = s.from_height;
        if (random.one_in(8)) s.to_radius = s.from_radius;
        if (random.one_in(4)) (random.one_in(2) ? s.from_radius : s.to_radius) = T(0);
        return s;
    }
    static lone_segment<T> lattice(random_numbers& random) {
        lone_segment<T> s{{},
                          {},
                          T(random.integer(0, 3)),
                          T(random.integer(-3, 3)),
                          T(random.integer(0, 3)),
                          T(random.integer(-3, 3))};
        for_each_number(s.base, [&](T& x) { x = T(random.integer(-3, 3)); });
        for_each_number(s.axis, [&](T& x) { x = T(random.integer(-3, 3)); });
        return s;
    }
    /// On an end of it, a silhouette of a ring as well.
    static vec3<double> special_point(const lone_segment<T>& s, const vec3<double>& from, random_numbers& random) {
        if (s.from_height != s.to_height)
            return revolved_subject<lone_segment<T>, segment_profile>::special_point(s, from, random);
        const double rho = static_cast<double>(random.one_in(2) ? s.from_radius : s.to_radius);
        return segment_profile::ends(s).first + random.perpendicular(to_double(s.axis)) * rho;
    }
    static vec3<double> inner_point(const lone_segment<T>& s, random_numbers& random) {
        const double h = random.uniform(0.01, 0.99);
        const auto [from, to] = segment_profile::ends(s);
        return from + (to - from) * h + random.perpendicular(to_double(s.axis)) * segment_profile::radius(s, h);
    }
    static open_frustum<oracle> as_frustum(const lone_segment<oracle>& s) {
        return {s.base + s.axis * s.from_height, s.base + s.axis * s.to_height, s.from_radius, s.to_radius};
    }
    static bool is_apex(const lone_segment<oracle>& s, const vec3<oracle>& p, const oracle& near) {
        return s.from_height != s.to_height && frustum_subject<open_frustum<T>>::is_apex(as_frustum(s), p, near);
    }
    static bool lies_in_side(const lone_segment<oracle>& s, const ray<oracle>& r) {
        return s.from_height != s.to_height && frustum_subject<open_frustum<T>>::lies_in_side(as_frustum(s), r);
    }
    static lone_segment<oracle> grown(lone_segment<oracle> s) {
        const oracle more(1e-50), height = s.to_height - s.from_height, widening = s.to_radius - s.from_radius;
        if (height == 0) {
            if (widening == 0) return s;  // nothing at all
            const bool widens = widening > 0;
            s.from_radius *= widens ? 1 - more : 1 + more;
            s.to_radius *= widens ? 1 + more : 1 - more;
        } else {
            const oracle before(s.from_radius > 0 ? 1e-21 : 1e-50), behind(s.to_radius > 0 ? 1e-21 : 1e-50);
            s.from_height -= height * before, s.to_height += height * behind;
            if (s.from_radius > 0) s.from_radius = (s.from_radius - widening * before) * (1 + more);
            if (s.to_radius > 0) s.to_radius = (s.to_radius + widening * behind) * (1 + more);
        }
        return s;
    }
};

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
    s.axis = vec3<T>(random.axis() * random.log_uniform(1e-2, 1e2));
    const double unit = size / static_cast<double>(length(s.axis));
    for (int i = random.integer(2, 6); i > 0; --i) {
        vec2<T> next(static_cast<T>(random.one_in(4) ? 0 : size * random.uniform()),
                     static_cast<T>(unit * random.uniform(-1, 1)));
        if (!s.profile.empty() && random.one_in(4)) next.y = s.profile.back().y;
        s.profile.push_back(next);
    }
    return s;
}

/// All crossings in 75 digits, in order, and the segments that they lie on.
template <class T>
std::vector<oracle> exact_crossings(const surface_of_revolution<T>& s, const ray<T>& r) {
    std::vector<oracle> all;
    const ray<oracle> exact_ray{vec3<oracle>(r.origin), vec3<oracle>(r.direction)};
    const vec3<oracle> base(s.base), axis(s.axis);
    for (std::size_t i = 0; i + 1 < s.profile.size(); ++i) {
        const auto c =
            crossings_of_piece(base, axis, vec2<oracle>(s.profile[i]), vec2<oracle>(s.profile[i + 1]), exact_ray);
        if (c.near.exists) all.push_back(c.near.t);
        if (c.far.exists) all.push_back(c.far.t);
    }
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

TEST_CASE_TEMPLATE("surface of revolution: named cases", T, RAIO_NUMBERS) {
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
        hit_record<T> rec{};
        CHECK(r.shape.hit(r.ray, r.t_min, infinity<T>, rec) == r.expected.hit);
        CHECK(r.shape.occluded(r.ray, r.t_min, infinity<T>) == r.expected.hit);
        CHECK(rec.t == static_cast<T>(r.expected.t));
        CHECK(rec.index == r.segment);
        CHECK(rec.front_face == r.expected.front_face);
    }
}

TEST_CASE_TEMPLATE(
    "surface of revolution: from a point of the surface, in any direction (many doubles did not start there)", T,
    RAIO_NUMBERS) {
    check_starts_on_surface([](random_numbers& random) {
        const T r = static_cast<T>(random.uniform(1, 2)), h = static_cast<T>(random.uniform(1, 2));
        return std::pair(surface_of_revolution<T>{{0, 0, 0}, {0, 0, h}, {{r, 0}, {r, 2}}},
                         vec3<T>(r, 0, h * static_cast<T>(random.uniform(0.1, 0.9))));
    });
}

TEST_CASE_TEMPLATE("surface of revolution: as exact arithmetic", T, RAIO_NUMBERS) {
    random_numbers random(31);
    const int rays = test_rays / 4;
    int hits = 0;
    for (int i = 0; i < rays; ++i) {
        const surface_of_revolution<T> s = random_surface<T>(random);
        const ray<T> r = random_ray(s, random);
        if (!(dot(r.direction, r.direction) > T(0))) continue;
        const T t_min = random.one_in(4) ? T(-1) : T(0);
        CAPTURE(literal(r));
        const auto points = [&] {
            std::string text = literal(s.base) + literal(s.axis);
            for (const vec2<T>& p : s.profile) text += literal(p);
            return text;
        };
        CAPTURE(points());
        hit_record<T> rec{};
        const bool hit = s.hit(r, t_min, infinity<T>, rec);
        REQUIRE(s.occluded(r, t_min, infinity<T>) == hit);
        const std::vector<oracle> exact = exact_crossings(s, r);
        const auto first = std::ranges::find_if(exact, [&](const oracle& t) { return rounded<T>(t) >= t_min; });
        if (std::same_as<T, double> && hit != (first != exact.end())) continue;  // 106 bits need not tell at a rim
        REQUIRE(hit == (first != exact.end()));
        if (!hit) continue;
        ++hits;
        if (std::same_as<T, float>) REQUIRE(rec.t == rounded<T>(*first));
        oracle off = abs(*first) * 4 * std::numeric_limits<T>::epsilon();
        if (std::same_as<T, double>) off += oracle(norm1(rec.error)) / length(vec3<oracle>(r.direction));
        REQUIRE(abs(oracle(rec.t) - *first) <= off);
        REQUIRE(s.bounds().contains(rec.point));
        CAPTURE(literal(rec));
        REQUIRE(dot(rec.normal, r.direction) <= T(0));
        REQUIRE((rec.uv.x >= 0 && rec.uv.x <= 1 && rec.uv.y >= 0 && rec.uv.y <= 1));
    }
    CHECK(hits > rays / 4);
}

TEST_CASE_TEMPLATE("surface of revolution: of one segment, as exact arithmetic", T, RAIO_NUMBERS) {
    check_accuracy<lone_segment<T>>(test_rays, 1.0 / 500);
    check_bounds_of_errors<lone_segment<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("surface of revolution: closed where its profile begins and ends on the axis", T, RAIO_NUMBERS) {
    random_numbers random(32);
    const surface_of_revolution<T> vase{{T(0.1), T(-0.7), 3},
                                        {T(0.3), T(1.1), T(-0.2)},
                                        {{0, 0}, {1, T(0.1)}, {T(0.7), T(0.9)}, {T(0.7), T(1.3)}, {0, T(1.7)}}};
    for (int i = 0; i < test_rays / 2; ++i) {
        const vec3<T> from = vase.base + vase.axis * static_cast<T>(random.uniform(0.4, 1.2));
        const vec2<T> rim = vase.profile[static_cast<std::size_t>(random.integer(0, 4))];
        const vec3<T> target =
            vase.base + vase.axis * rim.y + vec3<T>(random.perpendicular(to_double(vase.axis))) * rim.x;
        hit_record<T> rec{};
        REQUIRE(vase.hit({from, target - from}, T(0), infinity<T>, rec));
        REQUIRE(!rec.front_face);
    }
}

TEST_CASE_TEMPLATE("surface of revolution: a ring across an axis has one coordinate, and no rounding moves points off",
                   T, RAIO_NUMBERS) {
    check_face_across_x(surface_of_revolution<T>{{1, 0, 0}, {2, 0, 0}, {{0, -0.5}, {1, -0.5}}});
}

TEST_CASE_TEMPLATE("surface of revolution: uv and area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    const surface_of_revolution<T> cup = goblet<T>();
    const frame<T> f = frame_about(vec3<T>(0, 1, 0));
    hit_record<T> rec{};
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

    // Where the profile goes down, u is the angle about the axis as well (and was that about its reverse).
    const surface_of_revolution<T> sinking{{0, 0, 0}, {0, 1, 0}, {{2, 8}, {1, 0}}};
    REQUIRE(sinking.hit({f.y * T(9) + vec3<T>(0, 4, 0), -f.y}, T(0), infinity<T>, rec));
    CHECK(rec.uv.x == T(0.25));
    CHECK(rec.uv.y == doctest::Approx(0.5));

    // Along the axis into a tip, where u is anything (and was a little less than 0).
    const surface_of_revolution<T> funnel{{1, 0, 0}, {4.5, 0, 0}, {{3.875, 0.5}, {0, 3.875}}};
    REQUIRE(funnel.hit({{0, 0, 0}, {1, 0, 0}}, T(0), infinity<T>, rec));
    CHECK((rec.uv.x >= 0 && rec.uv.x <= 1));

    const surface_of_revolution<T> can{{1, 2, 3}, {0, 0, 2}, {{0, 0}, {3, 0}, {3, 2}, {0, 2}}};
    CHECK(can.area() == doctest::Approx(cylinder<T>{{1, 2, 3}, {1, 2, 7}, 3}.area()));
    CHECK(!(surface_of_revolution<T>{{1, 2, 3}, {0, 0, 2}, {{3, 0}}}.bounds().contains({1, 2, 3})));  // no segment
    for (int place = 0; place < 14; ++place) {  // a NaN is seen in the bounds, wherever it is
        surface_of_revolution<T> bad = can;
        T& number = place < 3   ? bad.base[place]
                    : place < 6 ? bad.axis[place - 3]
                                : bad.profile[static_cast<std::size_t>(place / 2 - 3)][place % 2];
        number = std::numeric_limits<T>::quiet_NaN();
        const aabb<T> box = bad.bounds();
        CHECK((is_nan(box.min.x) && is_nan(box.min.z) && is_nan(box.max.y)));
    }
    // Evenly over the base, the side and the top: 8 x 8 parts of equal areas each.
    const int samples = 100'000;
    std::vector<int> counts(3 * 64, 0);
    random_numbers random(33);
    for (int i = 0; i < samples; ++i) {
        const surface_sample<T> s = can.sample({T(random.uniform()), T(random.uniform())});
        REQUIRE(can.bounds().contains(s.point));
        const T x = s.point.x - 1, y = s.point.y - 2, rho = std::hypot(x, y), height = s.point.z - 3;
        const bool on_side = std::abs(s.normal.z) < T(0.5);
        const bool on_top = height > 2;
        REQUIRE(std::abs(on_side ? rho - 3 : on_top ? height - 4 : height) < T(1e-5));
        const auto part = [](T u) { return static_cast<std::size_t>(std::clamp(static_cast<int>(u * 8), 0, 7)); };
        const std::size_t segment = on_side ? 1 : on_top ? 2 : 0;
        const T turn = std::atan2(y, x) / T(2 * std::numbers::pi) + T(0.5);
        ++counts[64 * segment + 8 * part(turn) + part(on_side ? height / 4 : rho * rho / 9)];
    }
    std::vector<double> by_area(counts.size());
    for (std::size_t i = 0; i < by_area.size(); ++i) by_area[i] = samples * (i / 64 == 1 ? 24 : 9) / (42 * 64.0);
    CHECK(chi_square(counts, by_area) < chi_square_limit(191));
}

}  // namespace raio::test
