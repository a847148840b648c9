#pragma once

#include <array>
#include <utility>

#include <raio/number/bounded_vector.hpp>
#include <raio/number/simd.hpp>

#include <doctest/doctest.h>

#include "support/oracle.hpp"
#include "support/random.hpp"

/// \file
/// Numbers that know how far off they may be, in every precision, each with the exact number that it stands for: as far
/// off as it says, to either side, or less. What is made of them is compared with what is made of the exact ones.

#define RAIO_PRECISIONS strict_double, double_double, pack<float, 8>, pack<double, 4>, pack<strict_double, 4>

namespace raio::test {

template <class W>
inline constexpr std::size_t lanes_of = 1;
template <class S, std::size_t N>
inline constexpr std::size_t lanes_of<pack<S, N>> = N;

template <class W>
using exact_lanes = std::array<oracle, lanes_of<W>>;

template <class W>
auto lane(const W& x, [[maybe_unused]] std::size_t i) {
    if constexpr (requires { x[i]; }) {
        return x[i];
    } else {
        return x;
    }
}

/// A number whose lanes are what `f` says of each.
template <class W, class F>
W in_lanes(F f) {
    if constexpr (!requires { W::lanes; }) {
        return W(f(std::size_t{0}));
    } else {
        W x(0);
        for (std::size_t i = 0; i < W::lanes; ++i) x.set(i, static_cast<scalar_t<W>>(f(i)));
        return x;
    }
}

template <class W>
oracle largest_rounding(int count) {
    return oracle(count) * oracle(unit_roundoff<W>);
}
template <class W>
double size_of_lane(const W& x, std::size_t i) {
    return std::abs(static_cast<double>(lane(x, i)));
}

inline oracle square(const oracle& x) { return x * x; }
inline oracle square(const vec3<oracle>& v) { return dot(v, v); }
inline oracle inverse(const oracle& x) { return oracle(1) / x; }

/// One of S, of any sign and a size between 2^-most and 2^most, all its bits in use.
template <class S>
S any_number(random_numbers& random, double most) {
    const double high = (random.one_in(2) ? -1 : 1) * std::exp2(random.uniform(-most, most));
    if constexpr (std::same_as<S, double_double>) {
        return double_double(high) + double_double(high * random.uniform(-0x1p-54, 0x1p-54));
    } else {
        return static_cast<S>(high);
    }
}
/// All but x, or all but -x: in a sum nothing is left but some of their last bits.
template <class S>
S all_but(const S& x, random_numbers& random) {
    const double apart = std::exp2(random.uniform(std::log2(unit_roundoff<S>) - 1, 0));
    const S y = x + x * S(apart);
    return random.one_in(2) ? y : -y;
}

/// How far to one side: more often than not all the way.
inline oracle some_way(random_numbers& random) {
    return oracle(random.one_in(3) ? random.uniform(-1, 1) : random.one_in(2) ? 1.0 : -1.0);
}

/// A number and what it stands for.
template <class N>
struct known {
    N number;
    exact_lanes<typename N::number> exact;
};

/// \param most  sizes are between 2^-most and 2^most
/// \param near  all but this number, if there is one
template <class N>
struct maker;
template <class W, int K>
struct maker<rounded_number<W, K>> {
    static known<rounded_number<W, K>> any(random_numbers& random, double most, const W* near = nullptr) {
        known<rounded_number<W, K>> made;
        made.number.value = in_lanes<W>([&](std::size_t i) {
            return near != nullptr && random.one_in(2) ? all_but(lane(*near, i), random)
                                                       : any_number<scalar_t<W>>(random, most);
        });
        for (std::size_t i = 0; i < lanes_of<W>; ++i) {
            // Its relative error is that of the exact one.
            const oracle x = exactly(lane(made.number.value, i)), off = some_way(random) * largest_rounding<W>(K);
            made.exact[i] = x / (oracle(1) + off);
        }
        return made;
    }
};
template <class W>
struct maker<bounded_number<W>> {
    static known<bounded_number<W>> any(random_numbers& random, double most, const W* near = nullptr) {
        const auto given = maker<given_number<W>>::any(random, most, near);
        known<bounded_number<W>> made{given.number, given.exact};
        made.number.error = in_lanes<bound_t<W>>([&](std::size_t i) {
            const double size = size_of_lane(given.number.value, i);
            return random.one_in(4) ? 0 : size * std::exp2(random.uniform(std::log2(unit_roundoff<W>), 2));
        });
        for (std::size_t i = 0; i < lanes_of<W>; ++i) {
            made.exact[i] += some_way(random) * exactly(lane(made.number.error, i));
        }
        return made;
    }
};

/// A given number, one of some roundings, and one with a bound.
template <class W, class Visit>
void for_each_kind(Visit visit) {
    visit.template operator()<given_number<W>>();
    visit.template operator()<rounded_number<W, 3>>();
    visit.template operator()<bounded_number<W>>();
}

/// What W is off by, all told: the bound, and what small numbers lose.
template <class W>
oracle limit(const oracle& error) {
    return error * oracle(1 + 0x1p-16) + oracle(detail::lost<W>);
}

/// The largest part of its bound that an error has been.
struct worst {
    double part = 0;
    int open = 0, known = 0;  ///< of how many nothing is known, and of how many something

    template <class W>
    void see_lane(const oracle& value, const oracle& exact, const oracle& error) {
        // What is not finite says nothing.
        if (!isfinite(error) || !isfinite(value)) {
            ++open;
            return;
        }
        ++known;
        const oracle off = abs(value - exact);
        REQUIRE_MESSAGE(off <= limit<W>(error), "off by ", off.str(9), ", bound ", error.str(9), ", exact ",
                        exact.str(9));
        if (error > oracle(detail::lost<W> * 16)) part = std::max(part, rounded<double>(off / error));
    }
    template <class W>
    void see(const bounded_number<W>& x, const exact_lanes<W>& exact) {
        for (std::size_t i = 0; i < lanes_of<W>; ++i) {
            see_lane<W>(exactly(lane(x.value, i)), exact[i], exactly(lane(x.error, i)));
        }
    }
    template <class W, int K>
    void see(const rounded_number<W, K>& x, const exact_lanes<W>& exact) {
        for (std::size_t i = 0; i < lanes_of<W>; ++i) {
            see_lane<W>(exactly(lane(x.value, i)), exact[i], abs(exact[i]) * largest_rounding<W>(K));
        }
    }
};

template <class N>
inline constexpr bool is_given = false;
template <class W>
inline constexpr bool is_given<given_number<W>> = true;

/// How close to its bound an operation comes at worst: with numbers that are off themselves, and with given ones.
struct closeness {
    double of_any, of_given;
};

/// Between given numbers there are no errors but those of the operation: a double_double has a few bits more than it
/// says, and its bounds are not close.
template <class A, class B = A>
void check_closeness(const worst& seen, const closeness& least) {
    using W = typename A::number;
    if constexpr (is_given<A> && is_given<B>) {
        if (!last_precision<W>) CHECK(seen.part >= least.of_given);
    } else {
        CHECK(seen.part >= least.of_any);
    }
    CHECK(seen.known > seen.open);
}

/// As many as in so many packs.
template <class W>
int share_of_lanes(int count) {
    return at_least(count / static_cast<int>(lanes_of<W>)) + 1;
}

/// What a function makes of the exact numbers, lane by lane.
template <class W, class F, class... Exact>
exact_lanes<W> exactly_in_lanes(F f, const Exact&... exact) {
    exact_lanes<W> made;
    for (std::size_t i = 0; i < lanes_of<W>; ++i) made[i] = f(exact[i]...);
    return made;
}

/// A function of proven numbers is as far off as it says, and no less than a part of that at worst.
/// \param most  sizes are between 2^-most and 2^most
template <class W, class F>
void check_unary(const char* name, const closeness& least, F f, double most = 40) {
    CAPTURE(name);
    random_numbers random(7);
    for_each_kind<W>([&]<class A>() {
        worst seen;
        for (int i = 0; i < share_of_lanes<W>(1000); ++i) {
            const auto a = maker<A>::any(random, most);
            seen.see(f(a.number), exactly_in_lanes<W>(f, a.exact));
        }
        check_closeness<A>(seen, least);
    });
}
template <class W, class F>
void check_binary(const char* name, const closeness& least, F f, double most = 40) {
    CAPTURE(name);
    random_numbers random(7);
    for_each_kind<W>([&]<class A>() {
        for_each_kind<W>([&]<class B>() {
            worst seen;
            for (int i = 0; i < share_of_lanes<W>(1000); ++i) {
                const auto a = maker<A>::any(random, most);
                const auto b = maker<B>::any(random, most, &a.number.value);
                seen.see(f(a.number, b.number), exactly_in_lanes<W>(f, a.exact, b.exact));
            }
            check_closeness<A, B>(seen, least);
        });
    });
}

/// The root as `sqrt` says it, of an exact number as well.
template <class N>
auto root_of(const N& a) {
    if constexpr (std::same_as<N, oracle>) {
        return sqrt(max(a, oracle(0)));
    } else {
        return sqrt(a);
    }
}

}  // namespace raio::test
