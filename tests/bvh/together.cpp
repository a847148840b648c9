#include <raio/bvh/together.hpp>

#include "support/trees.hpp"

namespace raio::test {

TEST_CASE("together: a bundle after the other, and one bit for each ray in its place") {
    const std::vector<ray<float>> rays(64);
    for (std::size_t count = 0; count <= rays.size(); ++count) {
        std::size_t next = 0;
        const std::uint64_t all = detail::for_each_bundle(
            std::span(rays.data(), count), [&](std::span<const ray<float>> some, std::size_t first) {
                CHECK((first == next && !some.empty()));
                CHECK(some.data() == rays.data() + first);
                CHECK((some.size() == detail::ray_bundle::most || first + some.size() == count));
                next = first + some.size();
                return detail::bits_of(some.size(), [&](std::size_t i) { return (first + i) % 3 == 0; });
            });
        CHECK(next == count);
        for (std::size_t i = 0; i < 64; ++i) CHECK((all >> i & 1) == (i < count && i % 3 == 0 ? 1 : 0));
    }
}

namespace {

/// Small balls, and rays from one point to places near one of them.
struct balls_and_rays {
    std::vector<sphere<float>> balls;
    detail::assembled<sphere<float>> tree;
    std::vector<ray<float>> rays;

    explicit balls_and_rays(random_numbers& random) : balls(random_shapes<sphere<float>>(random, 200)) {
        tree.build(std::tuple(std::span(std::as_const(balls))), {});
        const vec3<float> from = within<float>(random, 20), to = balls.front().center - from;
        rays.assign(static_cast<std::size_t>(random.integer(1, static_cast<int>(detail::ray_bundle::most))),
                    {from, to});
        for (ray<float>& r : rays) r.direction += within<float>(random, 0.02) * norm1(to);
    }

    template <class Visit, class Far>
    bool visit(Visit visit, Far far_of) const {
        const detail::rays_in_lanes<float> lanes{std::span<const ray<float>>(rays)};
        return detail::visit_leaves_together(tree, lanes, rays.size(), 0.0f, infinity<float>, visit, far_of);
    }
};

constexpr auto endlessly = [](std::size_t) { return infinity<float>; };

/// The numbers of the bits that are set.
std::vector<std::size_t> numbers_of(std::uint64_t bits) {
    std::vector<std::size_t> numbers;
    for (; bits != 0; bits &= bits - 1) numbers.push_back(static_cast<std::size_t>(std::countr_zero(bits)));
    return numbers;
}

}  // namespace

TEST_CASE("together: each ray is shown all leaves with shapes that it meets, and none that are far from it") {
    random_numbers random(31);
    int bundles = 0;
    int left_out = 0;
    std::size_t shown = 0, blocks = 0;
    for (int i = 0; i < at_least_a_tenth_of(500); ++i) {
        const balls_and_rays all(random);
        const auto& leaves = std::get<0>(all.tree.leaves.all);
        std::vector<std::vector<bool>> seen(all.rays.size(), std::vector<bool>(leaves.size()));
        const auto visit = [&](auto kind, std::uint32_t block, std::uint64_t of, auto near) {
            static_assert(kind() == 0);
            const std::uint32_t boxes = near(leaves.shapes(block).bounds()) & leaves.used(block);
            for (const std::size_t ray : numbers_of(of)) {
                REQUIRE(!seen.at(ray).at(block));
                seen[ray][block] = true;
                ++shown;
                for (const std::size_t lane : numbers_of(leaves.used(block) & ~boxes)) {
                    const auto& ball = leaves.shape(block, static_cast<unsigned>(lane));
                    REQUIRE(!ball.occluded(all.rays[ray], 0.0f, infinity<float>));
                }
            }
            left_out += std::popcount(leaves.used(block) & ~boxes);
        };
        const bool together = all.visit(visit, endlessly);
        if (!together) continue;
        ++bundles, blocks += all.rays.size() * leaves.size();
        for (std::size_t k = 0; k < all.rays.size(); ++k) {
            for (std::uint32_t block = 0; block < leaves.size(); ++block) {
                for (std::uint32_t left = leaves.used(block); left != 0; left &= left - 1) {
                    const auto lane = static_cast<unsigned>(std::countr_zero(left));
                    const bool met = leaves.shape(block, lane).occluded(all.rays[k], 0.0f, infinity<float>);
                    REQUIRE((seen[k][block] || !met));
                }
            }
        }
    }
    CHECK(bundles > at_least_a_tenth_of(100));
    CHECK(shown < blocks / 4);
    CHECK(left_out > bundles);
}

TEST_CASE("together: a ray that wants no more is shown no more, the others are") {
    random_numbers random(32);
    int bundles = 0, more = 0;
    for (int i = 0; i < at_least_a_tenth_of(500); ++i) {
        const balls_and_rays all(random);
        std::vector<int> count(all.rays.size(), 0);
        bundles += all.visit(
            [&](auto, std::uint32_t, std::uint64_t of, auto) {
                for (const std::size_t ray : numbers_of(of)) ++count.at(ray);
            },
            [](std::size_t ray) { return ray == 0 ? -infinity<float> : infinity<float>; });
        CHECK(count[0] <= 1);
        more += std::ranges::any_of(count, [](int n) { return n > 1; }) ? 1 : 0;
    }
    CHECK(bundles > at_least_a_tenth_of(100));
    CHECK(more > at_least_a_tenth_of(100));
}

TEST_CASE("together: nothing is done for rays of which one runs another way, or nowhere") {
    random_numbers random(33);
    balls_and_rays all(random);
    const vec3<float> from(-20), to = all.balls.front().center - from;  // upwards along each axis
    const auto visits = [&](const vec3<float>& direction) {
        int count = 0;
        const std::vector<ray<float>> rays{{from, to}, {from, direction}};
        const auto visit = [&](auto, std::uint32_t, std::uint64_t, auto) { ++count; };
        const detail::rays_in_lanes<float> lanes{std::span(rays)};
        const bool together =
            detail::visit_leaves_together(all.tree, lanes, rays.size(), 0.0f, infinity<float>, visit, endlessly);
        CHECK(together == (count > 0));
        return count;
    };
    CHECK(visits({to.x, to.y * 1.01f, to.z}) > 0);
    CHECK(visits({to.x, -to.y, to.z}) == 0);
    CHECK(visits({-to.x, to.y, to.z}) == 0);
    CHECK(visits({0, 0, 0}) == 0);
    CHECK(visits({to.x, std::numeric_limits<float>::quiet_NaN(), to.z}) == 0);
    const auto visit = [](auto, std::uint32_t, std::uint64_t, auto) {};
    const detail::rays_in_lanes<float> one{std::span<const ray<float>>(all.rays.data(), 1)};
    CHECK(!detail::visit_leaves_together(all.tree, one, 1, 2.0f, 1.0f, visit, endlessly));
    CHECK(detail::visit_leaves_together(all.tree, one, 1, 1.0f, 1.0f, visit, endlessly));
    CHECK(!detail::visit_leaves_together(detail::assembled<sphere<float>>(), one, 1, 0.0f, 1.0f, visit, endlessly));
}

}  // namespace raio::test
