#include <raio/proof/line_part.hpp>

#include <doctest/doctest.h>

#include "support/bounds.hpp"
#include "support/polynomials.hpp"

namespace raio::test {

namespace {

const verdict<bool> yes{true, true, true};

/// A ray, and a part of it that is seen from a base.
template <class W>
struct random_part {
    ray<double> along;
    vec3<double> base;
    W middle, half;

    explicit random_part(random_numbers& random)
        : along{some_vector(random), some_vector(random)},
          base(some_vector(random)),
          middle(random.uniform(-10, 10)),
          half(random.log_uniform(1e-3, 1e3)) {}

    /// Of size where the part is as long as that.
    template <class Line>
    line_part<W> on(const Line& line, double size) const {
        return part_of(line, yes, base, given_number<W>{W(size)}, given_number<W>{middle}, given_number<W>{half}, W(1));
    }
    double length() const { return double(half) * raio::length(along.direction); }
};

/// The point of origin + t direction at t = middle + x half, as seen from the base.
template <class W>
vec3<oracle> exact_point(const random_part<W>& of, const vec3<oracle>& origin, const vec3<oracle>& direction,
                         const oracle& x) {
    const oracle t = exactly(of.middle) + x * exactly(of.half);
    return origin + direction * t - vec3<oracle>(of.base);
}

template <class W>
void check_coordinates(const line_part<W>& part, const vec3<oracle>& exact, double x, part_of_bound& seen) {
    for (const int axis : {0, 1, 2}) {
        const bounded_number<W> found = part.coordinate(axis)(bounded_number<W>(W(x), bound_t<W>(0)));
        seen.add(exactly(found.value) - exact[axis], found.error);
    }
}

}  // namespace

TEST_CASE_TEMPLATE("line_part: a point is where its coordinates say, and as far off", W, strict_double, double_double) {
    random_numbers random(1);
    part_of_bound seen;
    for (int i = 0; i < at_least(5'000); ++i) {
        const random_part<W> made(random);
        const line_part<W> part = made.on(line_in<W>(made.along), made.length());
        const double x = random.uniform(-1, 1);
        const vec3<oracle> origin(made.along.origin), direction(made.along.direction);
        check_coordinates(part, exact_point(made, origin, direction, oracle(x)), x, seen);
    }
    CHECK(seen.largest > 0.01);
}

TEST_CASE_TEMPLATE("line_part: on a line that was mapped it is as far off as that as well", W, strict_double,
                   double_double) {
    random_numbers random(2);
    part_of_bound seen;
    for (int i = 0; i < at_least(5'000); ++i) {
        const random_part<W> made(random);
        const auto blurred = [&](const vec3<double>& v) {
            const double error = length(v) * random.log_uniform(1e-12, 1e-6);
            return bounded_vector<W>{W(v.x), W(v.y), W(v.z), bound_t<W>(error)};
        };
        const mapped_line<W> line(blurred(made.along.origin), blurred(made.along.direction));
        const auto exactly_of = [&](const bounded_vector<W>& v) {
            vec3<oracle> exact(exactly(v.x), exactly(v.y), exactly(v.z));
            exact[random.integer(0, 2)] += exactly(v.error) * oracle(random.uniform(-1, 1));
            return exact;
        };
        const line_part<W> part = made.on(line, made.length());
        const double x = random.uniform(-1, 1);
        check_coordinates(part, exact_point(made, exactly_of(line.origin()), exactly_of(line.direction()), oracle(x)),
                          x, seen);
    }
    CHECK(seen.largest > 0.01);
}

TEST_CASE("line_part: so far away that a place cannot be told from others by the size, nobody knows") {
    using W = strict_double;
    const auto part_at = [](double away, bool passes) {
        const ray<double> far{{away, 0, 0}, {1, 0, 0}};
        const verdict<bool> passed{passes, passes, passes};
        return part_of(line_in<W>(far), passed, vec3<double>(0), given_number<W>{W(1)}, given_number<W>{W(-away)},
                       given_number<W>{W(1)}, W(1));
    };
    CHECK((part_at(0x1p30, true).exists && part_at(0x1p30, true).certain));
    CHECK(!part_at(0x1p45, true).certain);
    CHECK((!part_at(0x1p45, false).exists && part_at(0x1p45, false).certain));
    CHECK((part_at(0x1p30, true).is_there().certainly && !part_at(0x1p30, false).is_there().possibly));
    CHECK((!part_at(0x1p45, true).is_there().certainly && part_at(0x1p45, true).is_there().possibly));
}

TEST_CASE_TEMPLATE(
    "line_part: a root is crossed at its t, and where it is touched that is known to a thousand roundings", W,
    strict_double, double_double) {
    random_numbers random(3);
    part_of_bound of_t, of_place;
    for (int i = 0; i < at_least(2'000); ++i) {
        const random_part<W> made(random);
        const line_part<W> part = made.on(line_in<W>(made.along), made.length());
        const oracle exact_x = oracle(random.uniform(-1, 1));
        const double error = random.log_uniform(1e-14, 1e-3);
        const W x = nearest<W>(exact_x + oracle(error * random.uniform(-1, 1)));
        const crossing<W> c = part.at(polynomial_root<W>{x, error, 1, -1, 0}, true);
        REQUIRE((c.exists && c.certain && c.entering));
        of_t.add(exactly(c.t) - (exactly(made.middle) + exact_x * exactly(made.half)), c.error);

        const oracle touched = exactly(x) * (1 + oracle(random.uniform(-1, 1) * 0x1p9 * unit_roundoff<W>));
        const vec3<oracle> exact =
            exact_point(made, vec3<oracle>(made.along.origin), vec3<oracle>(made.along.direction), touched);
        for (const int axis : {0, 1, 2}) {
            const auto at = part.coordinate_where_touched(polynomial_root<W>{x, error, 1, 1, 0}, axis);
            of_place.add(exactly(at.value) - exact[axis], at.error);
        }
    }
    CHECK(of_t.largest > 0.5);
    CHECK(of_place.largest > 0.1);
}

TEST_CASE_TEMPLATE("line_part: the part of a line that passes a ball has all of it between its ends", W, strict_double,
                   double_double) {
    random_numbers random(1);
    int passed = 0, missed = 0, within = 0;
    for (int i = 0; i < at_least(5'000); ++i) {
        const vec3<double> center = random.direction() * random.uniform(0, 4);
        const double radius = random.log_uniform(0.01, 10);
        const vec3<double> to = center + random.direction() * (radius * random.uniform(0, 2));
        const vec3<double> origin = random.direction() * random.log_uniform(0.01, 100);
        const ray<double> ray{origin, (to - origin) * random.log_uniform(1e-3, 1e3)};
        const line_part<W> part = part_near(line_in<W>(ray), center, vec3<W>(center), W(radius));

        const vec3<oracle> d(ray.direction), l = vec3<oracle>(center) - vec3<oracle>(origin);
        const oracle d2 = dot(d, d), nearest = dot(l, d) / d2;
        const vec3<oracle> beside = l - d * nearest;
        const oracle half2 = oracle(radius) * oracle(radius) - dot(beside, beside);
        REQUIRE(part.certain);
        if (!part.exists) {
            REQUIRE(half2 < 0);
            ++missed;
            continue;
        }
        ++passed;
        const bool starts_within = dot(l, l) <= oracle(radius) * oracle(radius);
        if (starts_within) REQUIRE(part.middle == W(0));
        within += starts_within;
        if (half2 <= 0) continue;
        const oracle half = sqrt(half2 / d2);
        for (const oracle& t : {nearest - half, nearest + half}) {
            REQUIRE(abs(t - exactly(part.middle)) < exactly(part.half) * exactly(part.reach));
        }
    }
    CHECK((passed > 1'000 && missed > 1'000 && within > 100));
}

}  // namespace raio::test
