#include <raio/shape/box.hpp>

#include "support/boxes.hpp"
#include "support/cases.hpp"
#include "support/sampling.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("box: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const box<T> cube{{-1, -1, -1}, {1, 1, 1}}, unit{{0, 0, 0}, {1, 1, 1}};
    const ray<T> ahead{{0, 0, 5}, {0, 0, -1}};
    check_cases<box<T>>({
        {"+z", cube, ahead, enters(4)},
        {"-z", cube, {{0.5, 0.25, -5}, {0, 0, 1}}, enters(4)},
        {"+y", cube, {{0, 3, 0}, {0, -1, 0}}, enters(2)},
        {"-y", cube, {{0, -3, 0}, {0, 1, 0}}, enters(2)},
        {"+x", cube, {{3, 0, 0}, {-1, 0, 0}}, enters(2)},
        {"-x", cube, {{-3, 0, 0}, {1, 0, 0}}, enters(2)},
        {"behind the ray", cube, {{0, 0, 5}, {0, 0, 1}}, misses},
        {"from inside", cube, {{0.5, 0, 0}, {1, 0, 0}}, leaves(0.5)},
        {"from inside, oblique", cube, {{0, 0, 0}, {1, 2, 4}}, leaves(0.25)},
        {"beside the box", cube, {{1.5, 0, 5}, {0, 0, -1}}, misses},
        {"past the corner", cube, {{3, 0, 0}, {-1, 1, 0}}, misses},
        {"through two corners", cube, {{2, 2, 2}, {-1, -1, -1}}, enters(1)},
        {"touches a corner", cube, {{1, 2, 2}, {0, -1, -1}}, enters(1)},
        {"touches a corner on its way past", cube, {{2, 0, 1}, {-1, 1, 0}}, enters(1)},
        {"touches an edge", cube, {{2, 0, 0}, {-1, 1, 0}}, enters(1)},
        {"touches an edge where t is a third", unit, {{-1, 2, 0.5}, {3, -3, 0}}, enters(1.0 / 3)},
        {"touches an edge where t is three sevenths", unit, {{-3, 4, 0.5}, {7, -7, 0}}, enters(3.0 / 7)},
        {"along an edge", cube, {{1, 1, 5}, {0, 0, -1}}, enters(4)},
        {"one number beyond the edge", cube, {{1, 1 + eps, 5}, {0, 0, -1}}, misses},
        {"in a face (0 * inf)", cube, {{1, 0, 5}, {0, 0, -1}}, enters(4)},
        {"in a face, with -0 (0 * -inf)", cube, {{1, 0, 5}, {-0.0, -0.0, -1}}, enters(4)},
        {"in a lower face", cube, {{-1, 0.5, 5}, {0, 0, -1}}, enters(4)},
        {"in a lower face, with -0", cube, {{-1, -1, 5}, {-0.0, 0, -1}}, enters(4)},
        {"one number beyond the face", cube, {{1 + eps, 0, 5}, {0, 0, -1}}, misses},
        {"parallel to faces, outside", cube, {{2, 0, 0}, {-0.0, 1, 0}}, misses},
        {"from a face outwards", cube, {{1, 0, 0}, {1, 0, 0}}, leaves(0)},
        {"from a face inwards", cube, {{1, 0, 0}, {-1, 0, 0}}, enters(0)},
        {"from a face inwards, later", cube, {{1, 0, 0}, {-1, 0, 0}}, leaves(2), 0x1p-60},
        {"from a face along it", cube, {{1, 0, 0}, {0, 1, 0}}, leaves(1)},
        {"flat box", {{-1, -1, 0}, {1, 1, 0}}, ahead, enters(5)},
        {"flat box, on its rim", {{-1, -1, 0}, {1, 1, 0}}, {{1, 1, 5}, {0, 0, -1}}, enters(5)},
        {"flat box, along it", {{-1, -1, 0}, {1, 1, 0}}, {{5, 0, 0}, {-1, 0, 0}}, enters(4)},
        {"box as thin as a line", {{0, 0, -1}, {0, 0, 1}}, {{5, 0, 0}, {-1, 0, 0}}, misses},
        {"box as small as a point", {{0, 0, 0}, {0, 0, 0}}, ahead, misses},
        {"inverted box", {{1, 1, 1}, {-1, -1, -1}}, ahead, misses},
        {"box inverted along one axis", {{-1, -1, 1}, {1, 1, -1}}, ahead, misses},
        {"box that was never filled", {vec3<T>(infinity<T>), vec3<T>(-infinity<T>)}, ahead, misses},
        {"direction zero, from inside", cube, {{0, 0, 0}, {0, 0, 0}}, misses},
        {"first crossing before the window", cube, ahead, leaves(6), 4.5},
        {"both crossings behind the window", cube, ahead, misses, 0, 3.5},
        {"window between the crossings", cube, ahead, misses, 4.5, 5.5},
        {"window ends at the first crossing", cube, ahead, enters(4), 0, 4},
        {"component whose reciprocal is infinite, window ends at the crossing",
         cube,
         {{0.5, 0, 5}, {std::numeric_limits<T>::denorm_min(), 0, -1}},
         enters(4),
         0,
         4},
        {"window that is not a number", cube, ahead, misses, nan<T>},
        {"direction of length 1e-20", cube, {{0, 0, 5}, {0, 0, -0x1p-66}}, enters(0x1p68)},
        {"direction of length 1e20", cube, {{0, 0, 5}, {0, 0, -0x1p66}}, enters(0x1p-64)},
    });
}

TEST_CASE("box: from so far that a step of t leaves the range (error not a number)") {
    const double half = 0x1.32dfab08214e5p+9;
    check_cases<box<double>>({{"straight ahead",
                               {{-half, -half, -half}, {half, half, half}},
                               {{0, 0, -std::numeric_limits<double>::max()}, {0, 0, 0x1.5fed7667b74c5p+90}},
                               enters(0x1.7470b47066a87p+933)}});
}

TEST_CASE_TEMPLATE("box: properties of every shape", T, RAIO_NUMBERS) { check_properties<box<T>>(); }

TEST_CASE_TEMPLATE("box: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<box<T>>();
    check_accuracy<box<T>>(test_rays);
    check_bounds_of_errors<box<T>>(test_rays / 20);
}

/// Towards a corner, an edge, or a point of a face or inside, which is met at t = 3; or from there, along every axis
/// whose component is a zero of either sign or too small for a normal number. All components are powers of two.
template <class T>
probe<box<T>> probe_along_sides(random_numbers& random) {
    constexpr T least = std::numeric_limits<T>::denorm_min(), normal = std::numeric_limits<T>::min();
    const T tiny[] = {T(0), least, least * 8, normal / 2, normal};
    probe<box<T>> p{};
    const int exponent = random.integer(-9, 9), ahead = random.integer(0, 2);
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        T &low = p.shape.min[axis], &high = p.shape.max[axis], &d = p.ray.direction[axis];
        low = std::ldexp(T(random.integer(-4, 4)), exponent);
        high = low + std::ldexp(T(random.integer(random.one_in(8) ? 0 : 1, 4)), exponent);
        const T to = random.one_in(3) ? low : random.one_in(2) ? high : low + (high - low) / 4;
        const bool along = axis != ahead && random.one_in(2);
        d = along ? tiny[random.integer(0, 4)] : std::ldexp(T(1), exponent + random.integer(0, 2));
        if (random.one_in(2)) d = -d;
        p.ray.origin[axis] = along ? to : to - 3 * d;
    }
    return p;
}

/// The oracle divides by powers of two alone, and is exact. What has no reciprocal in double counts as zero.
TEST_CASE_TEMPLATE("box: along faces, at edges and corners, with zeros and denormal numbers for directions", T,
                   RAIO_NUMBERS) {
    random_numbers random(20);
    int complaints = 0, hits = 0;
    for (int i = 0; i < test_rays; ++i) {
        const probe<box<T>> p = probe_along_sides<T>(random);
        auto exact_ray = converted<oracle>(p.ray);
        for_each_number(exact_ray.direction, [](oracle& d) { d = abs(d) > oracle(0x1p-1024) ? d : oracle(0); });
        T t = infinity<T>;
        for (const crossing<oracle>& c : all_crossings<oracle>(converted<oracle>(p.shape), exact_ray)) {
            if (c.exists && in_window(p, rounded<T>(c.t))) t = std::min(t, rounded<T>(c.t));
        }
        hit_record<T> rec{};
        const bool expected = t < infinity<T>, hit = p.hit(rec);
        std::string wrong = unsound_answer(p) + inconsistent_record(p);
        if (hit != expected) wrong += hit ? "false hit" : "false miss";
        if (hit && expected && rec.t != t) wrong += "t = " + literal(rec.t) + " for " + literal(t);
        hits += hit;
        if (!wrong.empty() && ++complaints <= 3) FAIL_CHECK(wrong << "\n    {" << literal(p) << "}");
    }
    CHECK(complaints == 0);
    CHECK(hits > test_rays / 4);
}

TEST_CASE_TEMPLATE("box: area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    const box<T> bar{{0, 0, 0}, {1, 2, 4}};
    CHECK(bar.area() == T(28));
    const auto to_square = [](const hit_record<T>& rec) { return rec.uv; };
    check_sampling(bar, to_square);
    check_sampling(box<T>{{-9, 4, 7}, {T(-8.5), 5, T(7.25)}}, to_square);
    check_sampling(box<T>{{0, 0, 0}, {0, 1, 1}}, to_square);

    // The last number of one pair of faces, and the first of the next.
    for (const T part : {T(16) / 28, T(24) / 28}) {
        for (const T u : {std::nextafter(part, T(0)), part, std::nextafter(part, T(1))}) {
            CHECK(bar.bounds().contains(bar.sample({u, T(0.5)}).point));
        }
    }
    CHECK(bar.sample({T(1), T(0.5)}).point.z == T(4));  // no pair comes after the last one

    std::vector<int> counts(6, 0);
    random_numbers random(11);
    const int samples = 100'000;
    for (int i = 0; i < samples; ++i) {
        const vec3<T> n = bar.sample({static_cast<T>(random.uniform()), static_cast<T>(random.uniform())}).normal;
        const std::size_t axis = n.x != 0 ? 0 : n.y != 0 ? 1 : 2;
        ++counts[2 * axis + (n.x + n.y + n.z > 0)];
    }
    std::vector<double> by_area{8, 8, 4, 4, 2, 2};
    for (double& expected : by_area) expected *= samples / 28.0;
    CHECK(chi_square(counts, by_area) < chi_square_limit(5));
}

TEST_CASE_TEMPLATE("box: uv, and the point exactly on the face", T, RAIO_NUMBERS) {
    const box<T> bar{{0, 0, 0}, {1, 2, 4}};
    hit_record<T> rec{};
    REQUIRE(bar.hit({{T(0.25), T(1.5), 9}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK(rec.uv == vec2<T>(0.25, 0.75));
    REQUIRE(bar.hit({{9, 1, 3}, {-1, 0, 0}}, T(0), infinity<T>, rec));
    CHECK(rec.uv == vec2<T>(0.5, 0.75));
    REQUIRE(bar.hit({{T(0.25), -9, 1}, {0, 1, 0}}, T(0), infinity<T>, rec));
    CHECK(rec.uv == vec2<T>(0.25, 0.25));
    REQUIRE(bar.hit({{T(0.1), -9, T(0.7)}, {T(0.03), 1, T(0.01)}}, T(0), infinity<T>, rec));
    CHECK((rec.point.y == T(0) && rec.error.y == T(0)));
}

static_assert(box<double>{{0, 0, 0}, {1, 1, 1}}.occluded({{0.25, 0.25, 5}, {0, 0, -1}}, 0, 9));
static_assert(!box<float>{{0.5, 0, 0}, {1, 1, 1}}.occluded({{0.25, 0.25, 5}, {0, 0, -1}}, 0, 9));

}  // namespace raio::test
