#pragma once

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <raio/number/simd.hpp>

#include "support/random.hpp"

/// \file
/// Functions of packs, compared with the same functions of plain numbers, lane by lane.

namespace raio::test {

/// Ordinary numbers, and those that go wrong first.
template <class S>
std::vector<S> numbers() {
    using limits = std::numeric_limits<S>;
    std::vector<S> all{0,
                       S(-0.0),
                       1,
                       -1,
                       S(0.5),
                       S(-2.5),
                       3,
                       limits::min(),
                       limits::denorm_min(),
                       limits::max(),
                       limits::lowest(),
                       limits::infinity(),
                       -limits::infinity(),
                       limits::quiet_NaN()};
    random_numbers random(3);
    // Close to the end of the range, where not every product of two is beyond it.
    all.push_back(limits::max() / 8), all.push_back(limits::max() / -64);
    for (int i = 0; i < 50; ++i) all.push_back(static_cast<S>(random.uniform(-10, 10)));
    return all;
}

/// The same number, zeros told apart, any NaN as good as another.
template <class S>
bool same(S a, S b) {
    return (a != a && b != b) || (a == b && std::signbit(a) == std::signbit(b));
}

/// Calls `visit` with packs that hold all pairs of numbers.
template <class P, class Visit>
void for_all_pairs(Visit visit) {
    using S = scalar_t<P>;
    const std::vector<S> all = numbers<S>();
    std::array<S, P::lanes> a, b;
    for (std::size_t first = 0; first < all.size() * all.size(); first += P::lanes) {
        for (std::size_t lane = 0; lane < P::lanes; ++lane) {
            a[lane] = all[(first + lane) / all.size() % all.size()];
            b[lane] = all[(first + lane) % all.size()];
        }
        visit(P::load(a.data()), P::load(b.data()));
    }
}

/// A function of packs gives in each lane what the same function of plain numbers gives.
template <class P, class F>
void check_lanes(const char* name, F f) {
    int wrong = 0;
    for_all_pairs<P>([&](const P& a, const P& b) {
        const auto result = f(a, b);
        for (std::size_t lane = 0; lane < P::lanes; ++lane) {
            const auto expected = f(a[lane], b[lane]);
            if constexpr (std::same_as<decltype(expected), const bool>) {
                wrong += result[lane] != expected || (bits(result) >> lane & 1) != expected;
            } else {
                wrong += !same(result[lane], expected);
            }
        }
    });
    CHECK_MESSAGE(wrong == 0, std::string(name));
}

// One register, plain numbers, half a register of AVX-512, and several registers.
#define RAIO_PACKS_UNDER_TEST \
    pack<float>, pack<float, 3>, pack<float, 8>, pack<float, 32>, pack<double>, pack<double, 6>, pack<double, 16>

}  // namespace raio::test
