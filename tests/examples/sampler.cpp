#include <set>
#include <utility>

#include <doctest/doctest.h>
#include <render/sampler.hpp>

using namespace render;

TEST_CASE("a pixel's 64 samples fill every grid of 64 equal cells, one each") {
    for (const std::uint64_t pixel : {0u, 1u, 77u}) {
        for (int dimension = 0; dimension < 4; ++dimension) {
            for (int columns = 1; columns <= 64; columns *= 2) {
                std::set<std::pair<int, int>> cells;
                for (std::uint32_t i = 0; i < 64; ++i) {
                    sampler sampler(5, pixel, i);
                    for (int skipped = 0; skipped < dimension; ++skipped) sampler.next_2d();
                    const vec2 u = sampler.next_2d();
                    REQUIRE(u.x >= 0);
                    REQUIRE(u.x < 1);
                    REQUIRE(u.y >= 0);
                    REQUIRE(u.y < 1);
                    cells.emplace(static_cast<int>(u.x * columns), static_cast<int>(u.y * 64 / columns));
                }
                CHECK(cells.size() == 64);
            }
        }
    }
}

TEST_CASE("the numbers follow from seed, pixel, sample and how many were drawn, and from each of them") {
    const auto second = [](std::uint64_t seed, std::uint64_t pixel, std::uint32_t sample) {
        sampler s(seed, pixel, sample);
        s.next_2d();
        return s.next_1d();
    };
    CHECK(second(1, 2, 3) == second(1, 2, 3));
    CHECK(second(1, 2, 3) != second(2, 2, 3));
    CHECK(second(1, 2, 3) != second(1, 3, 3));
    CHECK(second(1, 2, 3) != second(1, 2, 4));
    sampler s(1, 2, 3);
    CHECK(s.next_1d() != second(1, 2, 3));
}

TEST_CASE("neighbouring pixels, and the dimensions of one sample, are not correlated") {
    // The mean of the product of two centred uniform numbers has standard deviation 1 / (12 sqrt(n)).
    constexpr int n = 20000;
    number neighbours = 0, dimensions = 0, x_and_y = 0;
    for (std::uint64_t pixel = 0; pixel < n; ++pixel) {
        sampler here(0, pixel, 0), there(0, pixel + 1, 0);
        const vec2 a = here.next_2d() - 0.5, b = there.next_2d() - 0.5, c = here.next_2d() - 0.5;
        neighbours += a.x * b.x / n;
        dimensions += a.x * c.x / n;
        x_and_y += a.x * a.y / n;
    }
    const number four_deviations = 4 / (12 * std::sqrt(number(n)));
    CHECK(std::abs(neighbours) < four_deviations);
    CHECK(std::abs(dimensions) < four_deviations);
    CHECK(std::abs(x_and_y) < four_deviations);
}
