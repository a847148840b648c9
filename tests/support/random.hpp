#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <string>

#include <raio/ray.hpp>

/// \file
/// Random numbers that are the same in every run: the generator and the distributions are our own.

namespace raio::test {

/// SplitMix64 (Steele, Lea and Flood, OOPSLA 2014): 64 bits of state, passes BigCrush.
class random_numbers {
public:
    explicit random_numbers(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    /// In [0, 1).
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    double log_uniform(double low, double high) { return low * std::pow(high / low, uniform()); }

    /// One of low, low + 1, ..., high.
    int integer(int low, int high) { return low + static_cast<int>(uniform() * (high - low + 1)); }
    bool one_in(int n) { return integer(1, n) == 1; }

    /// A unit vector, every direction as likely as any other.
    vec3<double> direction() {
        const double z = uniform(-1, 1), rho = std::sqrt(1 - z * z), phi = uniform(0, 2 * std::numbers::pi);
        return {rho * std::cos(phi), rho * std::sin(phi), z};
    }

    /// A unit vector: one in four along an axis of the coordinates, where bounds are tight, others as `direction`.
    vec3<double> axis() {
        if (!one_in(4)) return direction();
        vec3<double> along(0);
        along[integer(0, 2)] = one_in(2) ? 1 : -1;
        return along;
    }

    /// A unit vector perpendicular to `v`; some are along an axis of the coordinates, if `v` is.
    vec3<double> perpendicular(const vec3<double>& v) {
        vec3<double> across = cross(v, axis());
        if (across == vec3<double>(0)) across = cross(v, direction());
        return across * (1 / length(across));
    }

private:
    std::uint64_t state_;
};

/// The same ray, with digits beyond those of a double in every other number, as one that was mapped has them.
template <class T>
ray<double_double> with_more_digits(const ray<T>& ray, random_numbers& random) {
    const auto number = [&](T x) {
        const double rest = random.one_in(2) ? random.uniform(-0x1p-54, 0x1p-54) : 0;
        return double_double(x) + double_double(x) * double_double(rest);
    };
    const auto numbers = [&](const vec3<T>& v) {
        const double_double x = number(v.x), y = number(v.y);
        return vec3<double_double>(x, y, number(v.z));
    };
    const vec3<double_double> origin = numbers(ray.origin);
    return {origin, numbers(ray.direction)};
}

/// How many rays the comparisons with the oracle send: 100,000, or what RAIO_TEST_RAYS says in the environment. The
/// answers are the same bits from every compiler, and sanitizers are slow: one compiler sends them all, the presets of
/// others a part of them, and the tests labelled nightly a hundred times as many.
inline const int test_rays = [] {
    const char* wanted = std::getenv("RAIO_TEST_RAYS");
    return wanted != nullptr ? std::stoi(wanted) : 100'000;
}();

/// What stands for a number that is `count` in a run of 100,000 rays.
inline int share_of(int count) { return static_cast<int>(std::int64_t{count} * test_rays / 100'000); }
/// So many, more in a longer run.
inline int at_least(int count) { return std::max(count, share_of(count)); }

/// The same, but a tenth of it in a short one.
inline int at_least_a_tenth_of(int count) { return std::max(count / 10, share_of(count)); }

/// A count that is expected, and three standard deviations of it: in a short run chance has its share.
inline double with_chance(double expected) { return expected + 3 * std::sqrt(expected); }

/// The types of numbers that the shapes are tested with. What is made for floats is made for doubles as well, and more:
/// under the address sanitizer, which makes compiling slow, those alone.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define RAIO_NUMBERS double
#endif
#endif
#if !defined(RAIO_NUMBERS)
#define RAIO_NUMBERS float, double
#endif

}  // namespace raio::test
