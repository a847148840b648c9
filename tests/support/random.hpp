#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <raio/math/vec.hpp>

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

    /// A unit vector perpendicular to `v`.
    vec3<double> perpendicular(const vec3<double>& v) {
        const vec3<double> across = cross(v, direction());
        return across * (1 / length(across));
    }

private:
    std::uint64_t state_;
};

/// How many rays the comparisons with the oracle send. The answers are the same bits from every compiler, and
/// sanitizers are slow: one compiler sends them all, others a part of them. -DRAIO_TEST_RAYS=N sends N.
#if defined(RAIO_TEST_RAYS)
inline constexpr int normal_run = RAIO_TEST_RAYS;
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int normal_run = 5'000;
#elif defined(__has_feature)
inline constexpr int normal_run = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) ? 5'000 : 20'000;
#else
inline constexpr int normal_run = 100'000;
#endif
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

/// The same part of another number.
constexpr int share_of(int count) { return count / (100'000 / normal_run); }
inline constexpr int nightly_run = 10'000'000;

}  // namespace raio::test
