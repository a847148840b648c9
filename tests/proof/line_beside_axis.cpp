#include <raio/proof/line_beside_axis.hpp>

#include <doctest/doctest.h>

#include "support/oracle.hpp"
#include "support/random.hpp"

namespace raio::test {

namespace {

using bounds = detail::profile_bounds<double>;

/// Between two heights, how near a line comes to an axis and how far away from it, in a window; `min > max` if it is
/// never there.
interval<oracle> distances(const ray<double>& ray, const vec3<double>& base, const vec3<double>& axis,
                           const bounds& part, double t_min, double t_max) {
    const vec3<oracle> a(axis), from = vec3<oracle>(ray.origin) - vec3<oracle>(base), d(ray.direction);
    const oracle a2 = dot(a, a), rise = dot(d, a), start = dot(from, a);
    interval<oracle> within{t_min, t_max};
    for (const bool is_low : {true, false}) {
        const oracle above = (is_low ? part.low.y : part.high.y) * a2 - start;
        if (rise == 0) {
            if (is_low ? above > 0 : above < 0) return {};
        } else if (is_low == (rise > 0)) {
            within.min = max(within.min, above / rise);
        } else {
            within.max = min(within.max, above / rise);
        }
    }
    if (within.empty()) return {};
    const vec3<oracle> across = cross(from, a), step = cross(d, a);
    const oracle nearest = quotient(-dot(across, step), dot(step, step), oracle(0));
    const auto distance = [&](const oracle& t) { return length(across + step * t) / sqrt(a2); };
    return {distance(min(max(nearest, within.min), within.max)), max(distance(within.min), distance(within.max))};
}

}  // namespace

TEST_CASE("line_beside_axis: what a line passes by, it passes by, and it tells most of that") {
    random_numbers random(1);
    int passed = 0, not_told = 0, open = 0;
    for (int i = 0; i < at_least_a_tenth_of(100'000); ++i) {
        const double size = random.log_uniform(1e-3, 1e3), far = size * random.log_uniform(0.1, 1e5);
        const vec3<double> base = random.direction() * (size * random.log_uniform(1e-2, 1e2));
        const vec3<double> axis = random.axis() * random.log_uniform(1e-2, 1e2);
        const double unit = size / length(axis);
        bounds whole{{0, -unit}, {size, unit}}, part = whole;
        part.low.x = random.one_in(2) ? 0 : size * random.uniform(), part.high.x = random.uniform(part.low.x, size);
        part.low.y = unit * random.uniform(-1, 1), part.high.y = random.uniform(part.low.y, unit);
        if (random.one_in(4)) part.high = part.low;

        // To anywhere near, or to a rim; across the axis, all but, or along it.
        vec3<double> target = base + axis * (unit * random.uniform(-1.5, 1.5)) +
                              random.perpendicular(axis) * (size * random.uniform(0, 1.5));
        if (random.one_in(2)) target = base + axis * part.high.y + random.perpendicular(axis) * part.high.x;
        vec3<double> towards = random.direction() * far;
        if (random.one_in(4)) {
            towards -= axis * (dot(towards, axis) / dot(axis, axis));
            if (random.one_in(2)) towards += axis * (far / length(axis) * random.log_uniform(1e-17, 1e-8));
        }
        if (random.one_in(8)) towards = axis;
        const double rounding = 0x1p-24, t = 1 + random.uniform(-0.99, 0.99) * rounding;
        const ray<double> ray{target - towards * t, towards};
        float t_min = 0, t_max = 2;
        if (random.one_in(2)) t_min = random.one_in(2) ? 1 : static_cast<float>(random.uniform(0, 2));
        if (random.one_in(2)) t_max = random.one_in(2) ? 1 : static_cast<float>(random.log_uniform(1e-4, 1e4));

        const detail::line_beside_axis<strict_double> line(line_in<strict_double>(ray), base, axis, whole, t_min,
                                                           t_max);
        const double from = (1 - rounding) * static_cast<double>(t_min),
                     to = (1 + rounding) * static_cast<double>(t_max);
        const interval<oracle> seen = distances(ray, base, axis, part, from, to);
        if (line.passes(part)) {
            ++passed;
            REQUIRE((seen.empty() || seen.min > part.high.x || seen.max < part.low.x));
            continue;
        }
        // By so much it has to pass by to be told.
        const double more = size * 1e-3;
        const bounds larger{{std::max(part.low.x - more, 0.0), part.low.y - 1e-3 * unit},
                            {part.high.x + more, part.high.y + 1e-3 * unit}};
        const double later = 2e-2 * (size + unit) / length(towards) + 8 * rounding;
        const interval<oracle> near = distances(ray, base, axis, larger, from - later, to + later);
        ++open;
        if (near.empty() || near.min > larger.high.x || near.max < larger.low.x) ++not_told;
    }
    CHECK(passed > at_least_a_tenth_of(50'000));
    CHECK(open > at_least_a_tenth_of(10'000));
    CHECK(not_told < open / 200);
}

}  // namespace raio::test
