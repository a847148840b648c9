#include <raio/bvh/bvh.hpp>
#include <raio/shape/heightfield.hpp>

#include "support/cases.hpp"

namespace raio::test {

/// The loop over all triangles.
template <class T>
bool hit_loop(const heightfield<T>& field, const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) {
    bool found = false;
    for (std::size_t i = 0; i < field.size(); ++i) {
        hit_record<T> candidate{};
        if (!field[i].hit(ray, t_min, t_max, candidate)) continue;
        candidate.index = static_cast<std::uint32_t>(i);
        if (found && !detail::comes_before(candidate, rec)) continue;
        rec = candidate;
        found = true;
    }
    return found;
}

/// Smooth, rough, flat or with holes; of 2 to 12 lines each way, of any size, anywhere.
template <class T>
heightfield<T> random_field(random_numbers& random) {
    const double size = random.log_uniform(1e-6, 1e6), far = random.one_in(2) ? 0 : random.log_uniform(1, 1e3);
    const auto columns = static_cast<std::uint32_t>(random.integer(2, 12)),
               rows = static_cast<std::uint32_t>(random.integer(2, 12));
    const vec3<double> place = random.direction() * size * far;
    const double height = random.one_in(4) ? 0 : size * random.log_uniform(1e-3, 2),
                 base = random.one_in(2) ? 0 : place.z;
    heightfield<T> field{vec2<T>(vec2<double>(place)),
                         vec2<T>(vec2<double>(place) + vec2<double>(size, size * random.log_uniform(0.1, 10))),
                         columns,
                         {}};
    if (random.one_in(3)) {  // whole numbers
        field.min = {T(random.integer(-3, 3)), T(random.integer(-3, 3))};
        field.max = field.min + vec2<T>(T(columns - 1), T(rows - 1));
    }
    const bool whole = field.max.x - field.min.x == T(columns - 1), holes = random.one_in(4);
    for (std::uint32_t i = 0; i < columns * rows; ++i) {
        field.heights.push_back(whole ? T(random.integer(-2, 2))
                                      : static_cast<T>(base + random.uniform(-1, 1) * height));
        if (holes && random.one_in(8)) field.heights.back() = nan<T>;
    }
    return field;
}

/// A corner of a triangle, a point of an edge, or a point inside.
template <class T>
vec3<double> point_of(const heightfield<T>& field, random_numbers& random) {
    const triangle<T> t = field[static_cast<std::size_t>(random.integer(0, static_cast<int>(field.size()) - 1))];
    const double u = random.one_in(3) ? 0 : random.uniform(), v = random.one_in(3) ? 0 : random.uniform(0, 1 - u);
    vec3<double> p = to_double(t.a) + (to_double(t.b) - to_double(t.a)) * u + (to_double(t.c) - to_double(t.a)) * v;
    if (!std::isfinite(p.z)) p.z = 0;
    return p;
}

template <class T>
ray<T> random_ray(const heightfield<T>& field, random_numbers& random) {
    const vec2<double> extent(field.max - field.min);
    const double size = extent.x + extent.y;
    const vec3<double> to = point_of(field, random);
    const double away = random.one_in(3) ? 1 : random.log_uniform(0.01, 1e4);
    vec3<double> from = random.one_in(2) ? point_of(field, random) + random.direction() * (size * away)
                                         : to + random.direction() * size * away;
    if (random.one_in(4)) from = point_of(field, random);  // from the surface, and across the field
    if (random.one_in(3)) from.z = to.z + (from.z - to.z) * random.log_uniform(1e-6, 1);
    ray<T> r{vec3<T>(from), vec3<T>(to) - vec3<T>(from)};
    for (glm::length_t axis = 0; axis < 3; ++axis) {  // vertical, along a border, in a plane of constant height
        if (!random.one_in(4)) continue;
        r.origin[axis] = static_cast<T>(to[axis]);
        r.direction[axis] = random.one_in(2) ? T(0) : -T(0);
    }
    if (random.one_in(4)) r.direction *= static_cast<T>(std::ldexp(1.0, random.integer(-40, 40)));
    return r;
}

TEST_CASE_TEMPLATE("heightfield: what the loop over its triangles answers, bit for bit", T, RAIO_NUMBERS) {
    random_numbers random(5);
    int complaints = 0, hits = 0;
    for (int i = 0; i < test_rays / 2; ++i) {
        const heightfield<T> field = random_field<T>(random);
        const ray<T> ray = random_ray(field, random);
        T t_min(0), t_max = infinity<T>;
        hit_record<T> expected = untouched_record<T>(), found = expected;
        if (random.one_in(4) &&
            hit_loop(field, ray, t_min, t_max, found)) {  // a window that ends at a crossing, or near
            const T end = found.t * static_cast<T>(random.one_in(2) ? 1 : random.uniform(0.5, 2));
            (random.one_in(2) ? t_min : t_max) = end;
            found = untouched_record<T>();
        }
        if (random.one_in(8)) t_min = -infinity<T>;
        const bool hit = hit_loop(field, ray, t_min, t_max, expected);
        hits += hit;
        bool same = field.hit(ray, t_min, t_max, found) == hit && field.occluded(ray, t_min, t_max) == hit;
        if (hit) {
            same = same && 0 <= found.uv.x && found.uv.x <= 1 && 0 <= found.uv.y && found.uv.y <= 1;
            same = same && field.bounds().contains(found.point);
            expected.uv = found.uv;
        }
        if ((same && same_record(expected, found)) || ++complaints > 3) continue;
        FAIL_CHECK("{" << literal(ray) << "}, " << field.columns << " columns, expected " << literal(expected)
                       << ", found " << literal(found) << ", " << literal(t_min) << ", " << literal(t_max));
    }
    CHECK(complaints == 0);
    CHECK(hits > test_rays / 10);
}

TEST_CASE_TEMPLATE("heightfield: named cases", T, RAIO_NUMBERS) {
    constexpr T inf = infinity<T>;
    // A tent over [0, 4]^2 with its top at (2, 2, 2).
    const heightfield<T> tent{{0, 0}, {4, 4}, 3, {0, 0, 0, 0, 2, 0, 0, 0, 0}};
    const auto t_of = [&](const heightfield<T>& field, const ray<T>& ray) {
        hit_record<T> rec{};
        return field.hit(ray, T(0), inf, rec) ? rec.t : T(-1);
    };
    const auto down = [](T x, T y) { return ray<T>{{x, y, 5}, {0, 0, -1}}; };
    CHECK(t_of(tent, down(2, 2)) == T(3));
    CHECK(t_of(tent, down(0, 0)) == T(5));
    CHECK(t_of(tent, down(4, 4)) == T(5));
    CHECK(t_of(tent, down(4, 0)) == T(5));
    CHECK(t_of(tent, down(2, 0)) == T(5));
    CHECK(t_of(tent, down(1, 2)) == T(4));
    CHECK(t_of(tent, down(2, 3)) == T(4));
    CHECK(t_of(tent, down(-1, 2)) == T(-1));
    CHECK(t_of(tent, down(5, 2)) == T(-1));
    CHECK(t_of(tent, down(2, T(4) + T(4) * std::numeric_limits<T>::epsilon())) == T(-1));
    CHECK(t_of(tent, {{-1, 2, 1}, {1, 0, 0}}) == T(2));         // along a line of the grid
    CHECK(t_of(tent, {{5, 2, 1}, {-1, -0.0, 0}}) == T(2));      // the other way
    CHECK(t_of(tent, {{-1, -1, 1}, {1, 1, 0}}) == T(2));        // through the corners of cells
    CHECK(t_of(tent, {{-1, 2, 2}, {1, 0, 0}}) == T(3));         // over the top, which it touches
    CHECK(t_of(tent, {{-1, 2, T(2.25)}, {1, 0, 0}}) == T(-1));  // over all of it
    CHECK(t_of(tent, {{2, 2, 1}, {0, 0, -1}}) == T(-1));        // from below, downwards
    CHECK(t_of(tent, {{2, 2, 1}, {0, 0, 1}}) == T(1));
    CHECK(t_of(tent, {{2, 2, 5}, {0, 0, 0}}) == T(-1));
    CHECK(t_of(tent, {{2, 2, 5}, {0, 0, nan<T>}}) == T(-1));
    CHECK(t_of(tent, {{2, nan<T>, 5}, {0, 0, -1}}) == T(-1));
    CHECK(t_of(tent, {{2, inf, 5}, {0, 0, -1}}) == T(-1));
    CHECK(t_of(tent, {{2, 2, 5}, {inf, 0, -1}}) == T(-1));
    CHECK(t_of({{0, 0}, {4, 4}, 2, {1, 1, 1, 1}}, down(3, 1)) == T(4));  // flat
    CHECK(t_of({{0, 0}, {4, 4}, 2, {1, 1, 1, 1}}, {{-1, 1, 1}, {1, 0, 0}}) == T(-1));
    CHECK(t_of({{0, 0}, {4, 4}, 2, {1, nan<T>, 1, 1}}, down(3, 1)) == T(-1));  // a hole
    CHECK(t_of({{0, 0}, {4, 4}, 2, {1, nan<T>, 1, 1}}, down(1, 3)) == T(4));   // and beside it
    CHECK(t_of({{0, 0}, {4, 4}, 1, {1}}, down(0, 0)) == T(-1));                // one height is no surface
    CHECK(t_of({{0, 0}, {4, 4}, 1, {1, 1}}, down(0, 0)) == T(-1));
    CHECK(t_of({{0, 0}, {4, 4}, 2, {1, 1}}, down(0, 0)) == T(-1));
    CHECK(t_of({{0, 0}, {4, 4}, 0, {}}, down(0, 0)) == T(-1));
    CHECK(t_of({{0, 0}, {0, 4}, 2, {1, 1, 1, 1}}, down(0, 2)) == T(-1));
    CHECK(t_of({{0, 0}, {4, 0}, 2, {1, 1, 1, 1}}, down(2, 0)) == T(-1));
    CHECK(t_of({{4, 4}, {0, 0}, 2, {1, 1, 1, 1}}, down(2, 2)) == T(-1));

    hit_record<T> rec{};
    REQUIRE(tent.hit({{5, 2, 1}, {1, 0, 0}}, -inf, inf, rec));  // behind the ray, from anywhere on
    CHECK(rec.t == T(-4));
    REQUIRE(tent.hit({{-1, 2, 1}, {-1, 0, 0}}, -inf, T(0), rec));
    CHECK(rec.t == T(-4));
    CHECK_FALSE(tent.hit(down(2, 2), nan<T>, inf, rec));
    CHECK_FALSE(tent.hit(down(2, 2), T(0), nan<T>, rec));
    REQUIRE(tent.hit(down(3, 1), T(0), inf, rec));
    CHECK(rec.uv == vec2<T>(0.75, 0.25));
    CHECK(rec.front_face);
    CHECK(rec.index == 2);
    REQUIRE(tent.hit({{1, T(3.5), -5}, {0, 0, 1}}, T(0), inf, rec));
    CHECK(rec.uv == vec2<T>(0.25, 0.875));
    CHECK_FALSE(rec.front_face);
    CHECK(rec.index == 5);
}

TEST_CASE_TEMPLATE(
    "heightfield: heights that fill no rows are refused by whoever builds from them (they were an empty field)", T,
    RAIO_NUMBERS) {
    const heightfield<T> sound{{0, 0}, {2, 2}, 3, {0, 1, 2, 3, 4, 5}};
    CHECK_NOTHROW(sound.check());
    for (const auto& [columns, count] : {std::pair(3u, 5u), std::pair(3u, 7u), std::pair(3u, 3u), std::pair(0u, 6u),
                                         std::pair(1u, 6u), std::pair(3u, 0u)}) {
        heightfield<T> bad = sound;
        bad.columns = columns, bad.heights.resize(count);
        CHECK_THROWS_AS(bad.check(), std::invalid_argument);
        CHECK_THROWS_AS((bvh{std::vector{sound, bad}}), std::invalid_argument);
    }
    heightfield<T> short_of_one = sound;
    short_of_one.heights.pop_back();
    CHECK_THROWS_WITH_AS(
        short_of_one.check(),
        "raio::heightfield: 5 heights are not two rows or more of 3 columns, of which there must be two",
        std::invalid_argument);
}

TEST_CASE_TEMPLATE("heightfield: a NaN is a hole where it is a height, and in the bounds where it is a corner", T,
                   RAIO_NUMBERS) {
    const T nan = std::numeric_limits<T>::quiet_NaN();
    heightfield<T> field{{0, 0}, {2, 2}, 3, {nan, 0, 9, 0, 1, 2, 0, 3, nan}};
    const aabb<T> box = field.bounds();  // of the triangles that are there
    CHECK((box.contains({1, 1, 1}) && box.contains({2, 0, 9}) && !box.contains({1, 1, T(9.1)})));
    CHECK(!is_nan(box));
    for (T* number : {&field.min.x, &field.min.y, &field.max.x, &field.max.y}) {
        const T kept = std::exchange(*number, nan);
        CHECK((is_nan(field.bounds().min) && is_nan(field.bounds().max)));
        *number = kept;
    }
}

TEST_CASE_TEMPLATE("heightfield: from a point of it, in any direction", T, RAIO_NUMBERS) {
    check_starts_on_surface([](random_numbers& random) {
        heightfield<T> field{{0, 0}, {1, 1}, 2, {}};
        for (int i = 0; i < 4; ++i) field.heights.push_back(T(random.integer(-8, 8)));
        const T x = T(random.integer(0, 8)) / 8, y = T(random.integer(0, 8)) / 8;
        const T corner = field.heights[x > y ? 1 : 2];
        const T z =
            field.heights[0] + (corner - field.heights[0]) * max(x, y) + (field.heights[3] - corner) * min(x, y);
        return std::pair(field, vec3<T>(x, y, z));
    });
}

TEST_CASE_TEMPLATE("heightfield: what is spawned on it does not meet it where it left", T, RAIO_NUMBERS) {
    random_numbers random(6);
    int again = 0;
    for (int i = 0; i < test_rays / 10; ++i) {
        const heightfield<T> field = random_field<T>(random);
        hit_record<T> rec{}, next{};
        if (!field.hit(random_ray(field, random), T(0), infinity<T>, rec)) continue;
        const ray<T> spawned = spawn_ray(rec, vec3<T>(random.direction()));
        again += field.hit(spawned, T(0), infinity<T>, next) && next.index == rec.index;
    }
    CHECK(again == 0);
}

}  // namespace raio::test
