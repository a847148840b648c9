#pragma once

#include "support/probe.hpp"

/// \file
/// What a light needs of a shape: points spread evenly over its area.

namespace raio::test {

/// The squared deviation of the counts from evenness, each over what was to be expected (Pearson 1900): as large as the
/// number of counts, give or take a few times the root of twice that number.
inline double chi_square(const std::vector<int>& counts, const std::vector<double>& expected) {
    double sum = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        sum += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
    }
    return sum;
}

/// What that exceeds in one of a hundred tests of even counts, of which so many are free (Wilson and Hilferty 1931).
inline double chi_square_limit(double free) {
    const double variance = 2 / (9 * free);
    return free * std::pow(1 - variance + 2.326 * std::sqrt(variance), 3);
}

/// Samples lie on the surface, with the normal that a ray finds there, and are spread evenly over the unit square that
/// `to_square` maps the surface to, equal areas to equal areas.
template <sampleable Shape, class ToSquare>
void check_sampling(const Shape& shape, ToSquare to_square) {
    using T = number_t<Shape>;
    constexpr int side = 8;
    const int samples = std::max(4'000, test_rays / 5);
    const auto exact_shape = converted<oracle>(shape);
    using about = subject<std::remove_cvref_t<decltype(exact_shape)>>;
    const T eps = std::numeric_limits<T>::epsilon(), size = std::sqrt(shape.area());
    const T away = is_convex<Shape> ? size : size / 32;  // from where the point is the first that is met
    std::vector<int> counts(side * side, 0);
    int lost = 0;

    random_numbers random(8);
    for (int i = 0; i < samples; ++i) {
        const surface_sample<T> s = shape.sample({static_cast<T>(random.uniform()), static_cast<T>(random.uniform())});
        if (i % 100 == 0) {
            const oracle distance = abs(about::distance(exact_shape, converted<oracle>(s.point)));
            REQUIRE(rounded<T>(distance) < 16 * eps * (size + length(s.point)));
        }
        hit_record<T> rec{};
        if (!shape.hit({s.point + s.normal * away, -s.normal}, T(0), infinity<T>, rec)) {
            ++lost;  // at an edge
            continue;
        }
        REQUIRE(rec.front_face);
        REQUIRE(length(vec3<T>(rec.point - s.point)) < 64 * eps * (size + length(s.point)) + 2 * norm1(rec.error));
        const T roundings = detail::keeps_all_digits<T> ? 256 : 128;
        REQUIRE(length(vec3<T>(rec.normal - s.normal)) <
                roundings * eps * (1 + length(s.point) / size) + 32 * norm1(rec.error) / size);
        const vec2<T> square = to_square(rec);
        const auto bin = [](T x) { return std::min(static_cast<int>(x * side), side - 1); };
        ++counts[static_cast<std::size_t>(bin(square.x) * side + bin(square.y))];
    }
    CHECK(lost < with_chance(samples * 0.001));
    const std::vector<double> even(counts.size(), double(samples) / (side * side));
    CHECK(chi_square(counts, even) < chi_square_limit(63));

    // The ends of the unit square are points of the surface as well.
    for (const T u : {T(0), T(1) - eps / 2}) {
        for (const T v : {T(0), T(1) - eps / 2}) {
            const vec3<T> point = shape.sample({u, v}).point;
            REQUIRE(rounded<T>(abs(about::distance(exact_shape, converted<oracle>(point)))) <
                    16 * eps * (size + length(point)));
        }
    }
}

}  // namespace raio::test
