#include <raio/number/pack_mask.hpp>

#include "support/lanes.hpp"

namespace raio::test {

static_assert(std::is_trivially_copyable_v<pack_mask<float, 8>>);

TEST_CASE_TEMPLATE("pack: masks, and masks that are chosen by masks", P, RAIO_PACKS_UNDER_TEST) {
    check_lanes<P>("a && b", [](auto a, auto b) { return a < b && a <= -b; });
    check_lanes<P>("a || b", [](auto a, auto b) { return a < b || a <= -b; });
    check_lanes<P>("!a", [](auto a, auto b) { return !(a < b); });
    check_lanes<P>("a == b", [](auto a, auto b) { return (a < b) == (a <= -b); });
    check_lanes<P>("a != b", [](auto a, auto b) { return (a < b) != (a <= -b); });
    check_lanes<P>("every", [](auto a, auto b) { return every(a < b, a <= -b, is_finite(b)); });
    check_lanes<P>("some", [](auto a, auto b) { return some(a < b, a <= -b, !is_finite(b)); });
    check_lanes<P>("select", [](auto a, auto b) { return select(a < b, a <= -b, b <= a); });
    for_all_pairs<P>([](const P& a, const P& b) {
        const auto less = a < b;
        const std::uint32_t every_bit = bits(mask_t<P>(true));
        CHECK(std::popcount(every_bit) == P::lanes);
        CHECK(bits(mask_t<P>(false)) == 0);
        CHECK(any(less) == (bits(less) != 0));
        CHECK(none(less) == (bits(less) == 0));
        CHECK(all(less) == (bits(less) == every_bit));
        CHECK(bits(!less) == (bits(less) ^ every_bit));
    });
}

}  // namespace raio::test
