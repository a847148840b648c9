#include <raio/shape/surface_of_revolution.hpp>

#include <doctest/doctest.h>

#include "support/accuracy.hpp"
#include "support/bounds.hpp"
#include "support/cases.hpp"
#include "support/frusta.hpp"
#include "support/sampling.hpp"

namespace raio::test {

/// Those of a segment of a profile in 50 digits, as those of the shape that it is.
inline chord<oracle> crossings_of_piece(const vec3<oracle>& base, const vec3<oracle>& axis, const vec2<oracle>& from,
                                        const vec2<oracle>& to, const ray<oracle>& r) {
    const vec3<oracle> start = base + axis * from.y, end = base + axis * to.y;
    if (from.y != to.y) return open_frustum<oracle>{start, end, from.x, to.x}.crossings<oracle>(r);
    chord<oracle> c{};
    c.near = ring<oracle>{start, axis, min(from.x, to.x), max(from.x, to.x)}.crossings<oracle>(r);
    return c;
}

/// A surface whose profile is one segment, of which `crossings` can be asked.
template <real T>
struct lone_segment {
    using number = T;

    vec3<T> base, axis;
    T from_radius, from_height, to_radius, to_height;

    detail::revolved_segment<T> piece() const {
        return {base, axis, {from_radius, from_height}, {to_radius, to_height}};
    }
    surface_of_revolution<T> surface() const {
        return {base, axis, {{from_radius, from_height}, {to_radius, to_height}}};
    }
    bool hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        return surface().hit(ray, t_min, t_max, rec);
    }
    bool occluded(const ray<T>& ray, T t_min, T t_max) const { return surface().occluded(ray, t_min, t_max); }
    template <class W, real R>
    auto crossings(const ray<R>& ray) const {
        if constexpr (std::same_as<T, oracle>) {
            return crossings_of_piece(base, axis, {from_radius, from_height}, {to_radius, to_height}, ray);
        } else {
            return piece().template crossings<W>(ray);
        }
    }
    template <class X, class W>
    crossing<W> correction(const nearby_ray<X, W>& ray, const crossing<W>& c) const {
        return piece().correction(ray, c);
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
        lone_segment<T> s{vec3<T>(place), vec3<T>(random.direction() * unit), radius(), height(), radius(), height()};
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
    static lone_segment<oracle> grown(lone_segment<oracle> s) {
        const oracle more(1e-40), height = (s.to_height - s.from_height) * more;
        if (height == 0) {
            if (s.from_radius == s.to_radius) return s;  // nothing at all
            const bool widens = s.from_radius < s.to_radius;
            s.from_radius *= widens ? 1 - more : 1 + more;
            s.to_radius *= widens ? 1 + more : 1 - more;
        } else {
            s.from_height -= height, s.to_height += height;
            s.from_radius *= 1 + more, s.to_radius *= 1 + more;
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
        hit_record<T> rec;
        CHECK(r.shape.hit(r.ray, r.t_min, infinity<T>, rec) == r.expected.hit);
        CHECK(r.shape.occluded(r.ray, r.t_min, infinity<T>) == r.expected.hit);
        CHECK(rec.t == static_cast<T>(r.expected.t));
        CHECK(rec.index == r.segment);
        CHECK(rec.front_face == r.expected.front_face);
    }
}

TEST_CASE_TEMPLATE("surface of revolution: as exact arithmetic", T, RAIO_NUMBERS) {
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

TEST_CASE_TEMPLATE("surface of revolution: of one segment, as exact arithmetic", T, RAIO_NUMBERS) {
    check_accuracy<lone_segment<T>>(normal_run, 1.0 / 500);
    check_bounds_of_errors<lone_segment<T>>(share_of(20'000));
}

TEST_CASE("surface of revolution: of one segment, the bounds of what is missing, from above as well") {
    using W = strict_double;
    random_numbers random(34);
    part_of_bound of_side, of_slope, of_ring;
    int seen = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto radius = [&] { return random.one_in(8) ? 0 : random.log_uniform(1e-3, 1e3); };
        const auto height = [&] { return random.uniform(-1, 1) * random.log_uniform(1e-3, 1e3); };
        lone_segment<double> s{some_vector(random), some_vector(random), radius(), height(), radius(), height()};
        const bool flat = random.one_in(3);
        if (flat) s.to_height = s.from_height;
        const auto exact = converted<oracle>(s);

        // How far a point is above the ring, or how much farther from the axis than the side, in squares.
        const auto level = [&](const vec3<oracle>& p) {
            const vec3<oracle> from_base = p - exact.base;
            const oracle axis2 = dot(exact.axis, exact.axis), up = dot(from_base, exact.axis) / axis2;
            if (flat) return oracle(up - exact.from_height);
            const vec3<oracle> beside = from_base - exact.axis * up;
            const oracle part = (up - exact.from_height) / (exact.to_height - exact.from_height);
            const oracle rho = exact.from_radius + (exact.to_radius - exact.from_radius) * part;
            return oracle(dot(beside, beside) - rho * rho);
        };
        const double part = random.one_in(4) ? random.log_uniform(1e-6, 1) : random.uniform();
        const vec3<double> near_by =
            s.base + s.axis * (s.from_height + (s.to_height - s.from_height) * part) +
            random.perpendicular(s.axis) * (s.from_radius + (s.to_radius - s.from_radius) * part);
        const vec3<double> direction = some_vector(random);
        const auto level_along = [&](const ray<oracle>& ray) {
            return [&level, ray](const oracle& t) { return level(ray.origin + ray.direction * t); };
        };
        const oracle scale = oracle(std::max(s.from_radius, s.to_radius)) / length(vec3<oracle>(direction));
        if (!(scale > 0)) continue;
        const oracle root = zero_close_to_0(level_along({vec3<oracle>(near_by), vec3<oracle>(direction)}), scale);

        // All of t is known, or only as much as the bound of its error says.
        const double error = random.one_in(2) ? 0 : random.log_uniform(1e-16, 1e-6) * rounded<double>(scale);
        const vec3<oracle> place =
            vec3<oracle>(near_by) + vec3<oracle>(direction) * (root + error * random.uniform(-1, 1));
        const vec3<double> origin = near_by + random.direction() * random.log_uniform(1e-9, 1e3);
        const auto [nearby, exact_ray] = gone_close_to(place, origin, direction);
        const crossing<W> missing = s.correction(nearby, crossing<W>{true, true, W(0), W(error), true});
        if (!missing.certain) continue;
        const oracle t = zero_close_to_0(level_along(exact_ray), scale);
        (flat ? of_ring : error == 0 ? of_side : of_slope).add(exactly(missing.t) - t, missing.error);
        ++seen;
    }
    CHECK(seen > 10'000);
    CHECK((of_side.largest > 1e-4 && of_slope.largest > 0.1 && of_ring.largest > 0.1));
}

TEST_CASE_TEMPLATE("surface of revolution: of one segment, as exact arithmetic, ten million times" *
                       doctest::test_suite("nightly"),
                   T, RAIO_NUMBERS) {
    check_accuracy<lone_segment<T>>(nightly_run, 1.0 / 500);
}

TEST_CASE_TEMPLATE("surface of revolution: closed where its profile begins and ends on the axis", T, RAIO_NUMBERS) {
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

TEST_CASE_TEMPLATE("surface of revolution: a ring across an axis has one coordinate, and no rounding moves points off",
                   T, RAIO_NUMBERS) {
    check_face_across_x(surface_of_revolution<T>{{1, 0, 0}, {2, 0, 0}, {{0, -0.5}, {1, -0.5}}});
}

TEST_CASE_TEMPLATE("surface of revolution: uv and area, and samples spread evenly over it", T, RAIO_NUMBERS) {
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
    CHECK(!(surface_of_revolution<T>{{1, 2, 3}, {0, 0, 2}, {{3, 0}}}.bounds().contains({1, 2, 3})));  // no segment
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

namespace {

/// Its segments go on smoothly, and begin or end on the axis now and then.
template <class T>
curved_surface_of_revolution<T> random_curved_surface(random_numbers& random) {
    const double size = random.log_uniform(1e-3, 1e3);
    curved_surface_of_revolution<T> s;
    s.base = vec3<T>(random.direction() * size * random.log_uniform(0.01, 100));
    s.axis = vec3<T>(random.direction() * random.log_uniform(1e-2, 1e2));
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
             {"the bulge, from its middle up", bulge, {{0, 0, 0}, {0, 1, 0}}, leaves(4)},
             {"the can's side", can, {{5, 2, 0}, {-1, 0, 0}}, enters(4), 0},
             {"the can's lid", can, {{T(0.5), 9, 0}, {0, -1, 0}}, enters(3), 1},
             {"where the side and the lid meet", can, {{5, 6, 0}, {-1, 0, 0}}, enters(4), 0},
             {"one point short", short_of_one, {{5, 1, 0}, {-1, 0, 0}}, misses},
             {"radii below 0", turned_in, {{5, 1, 0}, {-1, 0, 0}}, misses},
             {"axis zero", no_axis, {{5, 1, 0}, {-1, 0, 0}}, misses},
             {"a height that is not a number", not_a_number, {{5, 1, 0}, {-1, 0, 0}}, misses},
             {"an infinite radius", endless, {{5, 1, 0}, {-1, 0, 0}}, misses},
             {"an infinite axis", of_endless_axis, {{5, 1, 0}, {-1, 0, 0}}, misses},
             {"at infinity", nowhere_near, {{5, 1, 0}, {-1, 0, 0}}, misses},
             {"direction zero", dish, {{0, 1, 0}, {0, 0, 0}}, misses},
             {"window that is not a number", dish, {{2, 9, 0}, {0, -1, 0}}, misses, 0, nan<T>},
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

TEST_CASE_TEMPLATE("curved surface of revolution: straight lines and a parabola", T, RAIO_NUMBERS) {
    random_numbers random(34);
    int hits = 0;
    for (int i = 0; i < normal_run / 5; ++i) {
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
        hit_record<T> rec, expected;
        const auto compare = [&](const auto& a, const auto& b) {
            const bool hit = a.hit(r, T(0), infinity<T>, rec);
            REQUIRE(hit == b.hit(r, T(0), infinity<T>, expected));
            if (!hit) return;
            ++hits;
            REQUIRE(rec.t == expected.t);
            REQUIRE(rec.front_face == expected.front_face);
            REQUIRE(length(vec3<T>(rec.normal - expected.normal)) < 32 * std::numeric_limits<T>::epsilon());
        };
        if (from != to) compare(curved, straight);
        compare(dish, parabola);
    }
    CHECK(hits > normal_run / 20);
}

TEST_CASE_TEMPLATE("curved surface of revolution: across the axis, where roots are double, to the last digit", T,
                   RAIO_NUMBERS) {
    // The square of the radius is the height.
    const curved_surface_of_revolution<T> dish{{0, 0, 0}, {0, 1, 0}, {{0, 0}, {1, 0}, {2, 3}, {3, 9}}};
    for (int i = 1; i < 72; ++i) {
        const oracle height = oracle(i) / 8;
        hit_record<T> rec;
        REQUIRE(dish.hit({{-9, T(i) / 8, 0}, {1, 0, 0}}, T(0), infinity<T>, rec));
        CHECK(rec.t == rounded<T>(9 - sqrt(height)));
        REQUIRE(dish.hit({{-9, T(i) / 8, 0}, {1, 0, 0}}, T(9), infinity<T>, rec));
        CHECK(rec.t == rounded<T>(9 + sqrt(height)));
    }
}

TEST_CASE_TEMPLATE("curved surface of revolution: as exact arithmetic", T, RAIO_NUMBERS) {
    random_numbers random(35);
    const int rays = normal_run / 25;
    int hits = 0, undecided = 0, refinements = 0, open = 0;
    for (int i = 0; i < rays; ++i) {
        const auto s = random_curved_surface<T>(random);
        const ray<T> r = random_ray(surface_of_revolution<T>{s.base, s.axis, s.profile}, random);
        if (!(dot(r.direction, r.direction) > T(0))) continue;
        CAPTURE(literal(r));
        std::string points = literal(s.base) + literal(s.axis);
        for (const vec2<T>& p : s.profile) points += literal(p);
        CAPTURE(points);
        hit_record<T> rec;
        const bool hit = s.hit(r, T(0), infinity<T>, rec);
        REQUIRE(s.occluded(r, T(0), infinity<T>) == hit);

        // In 50 digits: every crossing lies on the profile, and the first of them in the window is the answer.
        const ray<oracle> exact_ray{vec3<oracle>(r.origin), vec3<oracle>(r.direction)};
        const vec3<oracle> base(s.base), axis(s.axis);
        oracle first = infinity<oracle>;
        for (std::size_t k = 0; k + 3 < s.profile.size(); k += 3) {
            const vec2<T>* p = &s.profile[k];
            const detail::revolved_curve<oracle> piece{
                base, axis, vec2<oracle>(p[0]), vec2<oracle>(p[1]), vec2<oracle>(p[2]), vec2<oracle>(p[3])};
            const auto exact = piece.crossings<oracle>(exact_ray);
            const detail::revolved_curve<T> own{s.base, s.axis, p[0], p[1], p[2], p[3]};
            const auto quick = own.template crossings<strict_double>(r);
            for (std::size_t n = 0; quick.certain && n < quick.count; ++n) {
                REQUIRE(quick.count == exact.count);
                const crossing<double_double> fine = refined<double_double>(own, r, quick.crossings[n]);
                ++refinements;
                if (!fine.certain || !detail::rounds_to_one<double>(fine)) ++open;
                if (!fine.certain) continue;
                REQUIRE(abs(exactly(fine.t) - exact.crossings[n].t) <= exactly(fine.error));
            }
            for (const crossing<oracle>& c : exact) {
                const vec3<oracle> at = exact_ray.origin + exact_ray.direction * c.t - base;
                const oracle size = length(axis), rho = length(cross(at, axis)) / size;
                const vec2<oracle> on = on_profile(
                    curved_surface_of_revolution<oracle>{base, axis, {piece.p0, piece.p1, piece.p2, piece.p3}}, c.u);
                const oracle allowed =
                    c.error * length(exact_ray.direction) + (length(at) + length(base)) * oracle(1e-20);
                REQUIRE(abs(rho - on.x) < allowed);
                REQUIRE(abs(dot(at, axis) / size - on.y * size) < allowed);
                if (rounded<T>(c.t) >= 0) first = min(first, c.t);
            }
        }
        const bool right = hit == is_finite(first) &&
                           (!hit || abs(oracle(rec.t) - first) <= first * 4 * std::numeric_limits<T>::epsilon());
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
    MESSAGE(refinements << " crossings refined, left open to the last bit of a double: " << open);
    CHECK((refinements > rays && open < refinements * 0.6));
    const double expected = rays / 50.0;  // in a short run chance has its share
    CHECK(undecided < expected + 3 * std::sqrt(expected));
}

TEST_CASE("curved surface of revolution: where no number says the point, it is missed") {
    const float most = std::numeric_limits<float>::max();
    const curved_surface_of_revolution<float> tower{{0, 0, 0}, {0, most / 2, 0}, {{1, 0}, {1, 1}, {1, 2}, {1, 4}}};
    const auto rising = [](float y) { return ray<float>{{-5, 0, 0}, {1, y, 0}}; };  // meets it at t = 4, and at t = 6
    hit_record<float> rec;
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
            hit_record<double> rec, expected;
            const bool hit = curved.hit(r, 0, infinity<double>, rec);
            const bool expected_hit = straight.hit(r, 0, infinity<double>, expected);
            const double size = length(vec3<double>(curved.bounds().max - curved.bounds().min));
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
    for (int i = 0; i < normal_run / 5; ++i) {
        const vec3<T> from = vase.base + vase.axis * static_cast<T>(random.uniform(0.2, 1.5));
        const vec2<T> rim = vase.profile[static_cast<std::size_t>(3 * random.integer(0, 3))];
        const vec3<T> target =
            vase.base + vase.axis * rim.y + vec3<T>(random.perpendicular(to_double(vase.axis))) * rim.x;
        hit_record<T> rec;
        REQUIRE(vase.hit({from, target - from}, T(0), infinity<T>, rec));
    }
}

}  // namespace raio::test
