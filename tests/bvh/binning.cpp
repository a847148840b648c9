#include <raio/bvh/binning.hpp>

#include "support/binary_trees.hpp"

namespace raio::test {

TEST_CASE("bins: the split of least cost, as all of them tried") {
    random_numbers random(1);
    for (int run = 0; run < 500; ++run) {
        const std::uint32_t leaf = 1u << random.integer(0, 4);
        // An empty place of a leaf counts a quarter.
        const auto weight = [&](float boxes) {
            const auto room = static_cast<float>(leaf);
            return boxes + (std::ceil(boxes / room) * room - boxes) / 4;
        };
        const auto references = random_references(random, static_cast<std::size_t>(random.integer(1, 60)));
        build_box centers;
        for (const build_box& box : references) centers.include(detail::center_box(box));
        const detail::bin_scale bin_of(centers);
        detail::bins all, one, other;
        all.add(references, bin_of);
        const std::size_t half = references.size() / 2;
        one.add(std::span(references).first(half), bin_of);
        other.add(std::span(references).subspan(half), bin_of);
        one.add(other);

        float least = infinity<float>;
        for (unsigned axis = 0; axis < 3; ++axis) {
            for (unsigned last = 0; last + 1 < detail::bin_count; ++last) {
                build_box left, right;
                float left_count = 0, right_count = 0;
                for (const build_box& box : references) {
                    const bool is_left = bin_of(box, axis) <= last;
                    (is_left ? left : right).include(box);
                    (is_left ? left_count : right_count) += 1;
                }
                if (left_count == 0 || right_count == 0) continue;
                least =
                    std::min(least, left.half_area() * weight(left_count) + right.half_area() * weight(right_count));
            }
        }
        for (const detail::bins& filled : {all, one}) {
            const detail::bin_split best = filled.best_split(leaf);
            REQUIRE((best.axis == 3) == (least == infinity<float>));
            if (best.axis == 3) continue;
            REQUIRE(best.cost == doctest::Approx(least).epsilon(1e-6));
            const auto is_left = [&](const build_box& box) { return bin_of(box, best.axis) <= best.last; };
            REQUIRE(best.left_count == std::ranges::count_if(references, is_left));
        }
    }
}

TEST_CASE("bin_scale: from the first bin to the last, and one where there is no extent") {
    const auto at = [](float x) { return detail::to_build_box(aabb<float>{{x, 0, 0}, {x + 1, 2, 3}}); };
    const detail::bin_scale bin_of(hull(detail::center_box(at(5)), detail::center_box(at(21))));
    CHECK(bin_of(at(5), 0) == 0);
    CHECK(bin_of(at(13.5f), 0) == 8);
    CHECK(bin_of(at(21), 0) == detail::bin_count - 1);
    CHECK((bin_of(at(13), 1) == 0 && bin_of(at(13), 2) == 0));
    for (unsigned axis = 0; axis < 3; ++axis) {
        const build_box center = detail::center_box(at(5));
        CHECK((center.low(axis) == detail::center2(at(5), axis) && center.high(axis) == center.low(axis)));
    }
}

}  // namespace raio::test
