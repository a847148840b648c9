#include <raio/number/simd.hpp>

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <raio/raio.hpp>

#include "support/lanes.hpp"

namespace raio::test {

static_assert(real<pack<float>> && real<pack<double>> && real<pack<float, 3>> && real<pack<float, 32>>);
static_assert(std::is_trivially_copyable_v<pack<float>> && std::is_trivially_default_constructible_v<pack<double>>);
static_assert(sizeof(pack<float, 12>) == 12 * sizeof(float) && sizeof(pack<double, 5>) == 5 * sizeof(double));
static_assert(std::is_aggregate_v<sphere<pack<float>>> && primitive<sphere<pack<float>>>);
static_assert(std::same_as<scalar_t<pack<float, 8>>, float> && unit_roundoff<pack<float>> == 0x1p-24);
static_assert(std::same_as<mask_t<pack<float, 8>>, mask_t<index_t<pack<float, 8>>>>);
#if defined(RAIO_WITHOUT_XSIMD)
static_assert(pack<float>::lanes == 1 && pack<double>::lanes == 1);
#elif defined(__AVX512F__)
static_assert(pack<float>::lanes == 16 && pack<double>::lanes == 8 && alignof(pack<float, 8>) == 32);
#elif defined(__AVX2__)
static_assert(pack<float>::lanes == 8 && pack<double>::lanes == 4 && alignof(pack<float, 16>) == 32);
#elif defined(__SSE2__)
static_assert(pack<float>::lanes == 4 && pack<double>::lanes == 2);
#endif

TEST_CASE_TEMPLATE("pack: every lane as a plain number", P, RAIO_PACKS_UNDER_TEST) {
    check_lanes<P>("a + b", [](auto a, auto b) { return a + b; });
    check_lanes<P>("a - b", [](auto a, auto b) { return a - b; });
    check_lanes<P>("a * b", [](auto a, auto b) { return a * b; });
    check_lanes<P>("a / b", [](auto a, auto b) { return a / select(b == decltype(b)(0), decltype(b)(1), b); });
    check_lanes<P>("-a", [](auto a, auto) { return -a; });
    check_lanes<P>("+=, -=, *=, /=", [](auto a, auto b) {
        auto c = a;
        c += b, c -= a, c *= a, c /= decltype(c)(3);
        return c;
    });
    check_lanes<P>("a < b", [](auto a, auto b) { return a < b; });
    check_lanes<P>("a <= b", [](auto a, auto b) { return a <= b; });
    check_lanes<P>("a > b", [](auto a, auto b) { return a > b; });
    check_lanes<P>("a >= b", [](auto a, auto b) { return a >= b; });
    check_lanes<P>("a == b", [](auto a, auto b) { return a == b; });
    check_lanes<P>("a != b", [](auto a, auto b) { return a != b; });
    check_lanes<P>("min", [](auto a, auto b) { return min(a, b); });
    check_lanes<P>("max", [](auto a, auto b) { return max(a, b); });
    check_lanes<P>("select", [](auto a, auto b) { return select(a < b, a + b, b); });
    check_lanes<P>("quotient", [](auto a, auto b) { return quotient(a, b, a); });
    check_lanes<P>("sqrt", [](auto a, auto) { return sqrt(abs(a)); });
    check_lanes<P>("abs", [](auto a, auto) { return abs(a); });
    check_lanes<P>("copysign", [](auto a, auto b) { return copysign(a, b); });
    check_lanes<P>("flip", [](auto a, auto b) { return flip(a, b); });
    check_lanes<P>("is_finite", [](auto a, auto) { return is_finite(a); });
    check_lanes<P>("floor", [](auto a, auto) { return floor(a) + decltype(a)(0); });
    check_lanes<P>("infinity", [](auto a, auto) { return a < infinity<decltype(a)>; });
}

/// A function of numbers of two parts, of which both are the same in each lane.
template <class P, class F>
void check_both_parts(const char* name, F f) {
    const auto in_two_parts = [=](auto a, auto b) {
        using X = exact_t<decltype(a)>;
        const X small(0x1p-54);
        return f(X(a) + X(b) * small, X(b) - X(a) * small);
    };
    check_lanes<P>(name, [=](auto a, auto b) { return decltype(a)(in_two_parts(a, b)); });
    check_lanes<P>(name, [=](auto a, auto b) {
        using X = exact_t<decltype(a)>;
        const X whole = in_two_parts(a, b);
        return decltype(a)(whole - X(decltype(a)(whole)));
    });
}

TEST_CASE_TEMPLATE("pack: two of doubles, as every lane's double_double", P, pack<double>, pack<double, 6>,
                   pack<double, 16>) {
    static_assert(real<exact_t<P>> && std::same_as<scalar_t<exact_t<P>>, double_double>);
    check_both_parts<P>("a + b", [](auto a, auto b) { return a + b; });
    check_both_parts<P>("a - b", [](auto a, auto b) { return a - b; });
    check_both_parts<P>("a * b", [](auto a, auto b) { return a * b; });
    check_both_parts<P>("a / b", [](auto a, auto b) { return a / select(b == decltype(b)(0), decltype(b)(1), b); });
    check_both_parts<P>("-a", [](auto a, auto) { return -a; });
    check_both_parts<P>("sqrt", [](auto a, auto) { return sqrt(abs(a)); });
    check_both_parts<P>("floor", [](auto a, auto) { return floor(a); });
    // A NaN has any sign.
    check_both_parts<P>("copysign", [](auto a, auto b) { return copysign(a, select(b == b, b, decltype(b)(1))); });
    check_both_parts<P>("min, max", [](auto a, auto b) { return min(a, b) + max(a, b); });
    check_both_parts<P>("quotient", [](auto a, auto b) { return quotient(a, b, a); });
    check_lanes<P>("a < b", [](auto a, auto b) { return exact_t<decltype(a)>(a) < exact_t<decltype(a)>(b); });
    check_lanes<P>("a <= b", [](auto a, auto b) { return exact_t<decltype(a)>(a) <= exact_t<decltype(a)>(b); });
    check_lanes<P>("a == b", [](auto a, auto b) { return exact_t<decltype(a)>(a) == exact_t<decltype(a)>(b); });
    check_lanes<P>("a != b", [](auto a, auto b) { return exact_t<decltype(a)>(a) != exact_t<decltype(a)>(b); });
    check_lanes<P>("is_finite", [](auto a, auto) { return is_finite(exact_t<decltype(a)>(a)); });
    const auto of_one_part = [](auto a, auto b) {
        using X = exact_t<decltype(a)>;
        const X two_parts = X(b) / X(3);
        return sum_as<X>(product_as<X>(a, b), X(0)) + sum_as<X>(a, two_parts) * product_as<X>(b, two_parts) -
               difference_as<X>(a, b);
    };
    check_lanes<P>("of one part", [=](auto a, auto b) { return decltype(a)(of_one_part(a, b)); });
}

TEST_CASE_TEMPLATE("pack: angles", P, RAIO_PACKS_UNDER_TEST) {
    using S = scalar_t<P>;
    const auto near = [](S a, S b) {
        return std::abs(a - b) <= S(1e-6) || (sizeof(S) == 8 && std::abs(a - b) < 1e-14);
    };
    for_all_pairs<P>([&](const P& a, const P& b) {
        const P angle = atan2(a, b), sine = sin(a), cosine = cos(a), turn = turns(a, b);
        for (std::size_t lane = 0; lane < P::lanes; ++lane) {
            if (!(std::abs(a[lane]) < 100) || !(std::abs(b[lane]) < 100)) continue;
            CHECK(near(sine[lane], std::sin(a[lane])));
            CHECK(near(cosine[lane], std::cos(a[lane])));
            if (a[lane] == 0 && b[lane] == 0) continue;
            CHECK(near(angle[lane], std::atan2(a[lane], b[lane])));
            CHECK(near(turn[lane], turns(a[lane], b[lane])));
        }
    });
}

TEST_CASE_TEMPLATE("pack: what is set in one lane is there and nowhere else", P, RAIO_PACKS_UNDER_TEST) {
    using S = scalar_t<P>;
    using index = index_t<P>;
    P x(7);
    index i(7);
    for (std::size_t lane = 0; lane < P::lanes; ++lane) {
        x.set(lane, S(lane));
        i.set(lane, static_cast<scalar_t<index>>(lane));
        for (std::size_t other = 0; other < P::lanes; ++other) {
            CHECK(x[other] == (other <= lane ? S(other) : S(7)));
            CHECK(i[other] == (other <= lane ? other : 7));
        }
    }
    const index next = select(x < P(2), i + index(1), index(0));
    CHECK(next[0] == 1);
    CHECK(bits(next == index(1)) == 1);
    std::array<S, P::lanes + 1> memory{};
    x.store(memory.data() + 1);
    CHECK(bits(P::load(memory.data() + 1) == x) == bits(mask_t<P>(true)));
    CHECK(memory[0] == 0);
}

TEST_CASE_TEMPLATE("pack: the same numbers of another size", P, RAIO_PACKS_UNDER_TEST) {
    using S = scalar_t<P>;
    using Other = std::conditional_t<std::same_as<S, float>, double, float>;
    P numbers;
    for (std::size_t i = 0; i < P::lanes; ++i) numbers.set(i, S(0.1) * S(int(i) - 3));
    const pack<Other, P::lanes> others(numbers);
    for (std::size_t i = 0; i < P::lanes; ++i) CHECK(others[i] == Other(numbers[i]));
}

TEST_CASE_TEMPLATE("pack: in the vectors of GLM", P, RAIO_PACKS_UNDER_TEST) {
    // The products are exact, so that it does not matter where they are fused with the sums.
    check_lanes<P>("dot", [](auto a, auto b) { return dot(vec3<decltype(a)>(a, 1, 2), vec3<decltype(a)>(1, b, 1)); });
    check_lanes<P>("cross", [](auto a, auto b) {
        using V = vec3<decltype(a)>;
        const V c = cross((V(a, b, 1) + V(b) - V(1, 2, 3)) / decltype(a)(2), V(1, -1, 1));
        return c.x + c.y - c.z;
    });
    P x(1);
    vec3<P> v(x), w(2);
    v += w, v *= x, v -= vec3<P>(0.5);
    CHECK(all(v.y == P(2.5)));
    CHECK(all(glm::dot(v, w) == P(15)));
}

}  // namespace raio::test
