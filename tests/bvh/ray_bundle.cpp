#include <raio/bvh/ray_bundle.hpp>

#include "support/slabs.hpp"

namespace raio::test {

using detail::ray_bundle;

namespace {

std::uint64_t first_bits(std::size_t count) { return ~std::uint64_t{0} >> (64 - count); }

const std::array<float, ray_bundle::most> everywhere = [] {
    std::array<float, ray_bundle::most> far;
    far.fill(infinity<float>);
    return far;
}();

/// From one place, or near it, in about one direction or just that, some faster than others.
template <class T>
std::vector<ray<T>> random_bundle(random_numbers& random) {
    const ray<T> first = random_ray<T>(random);
    std::vector<ray<T>> rays(static_cast<std::size_t>(random.integer(1, static_cast<int>(ray_bundle::most))), first);
    const double angle = random.one_in(2) ? 0 : random.log_uniform(1e-4, 1);
    const double apart = random.one_in(2) ? 0 : random.log_uniform(1e-3, 3);
    const bool is_uneven = random.one_in(2);
    for (ray<T>& r : rays) {
        r.origin += vec3<T>(random.direction() * apart);
        r.direction += vec3<T>(random.direction() * (angle * double(norm1(first.direction))));
        if (is_uneven) r.direction *= static_cast<T>(random.log_uniform(0.1, 10));
    }
    return rays;
}

}  // namespace

/// Asked about all children together, and then about each: no ray loses one that it meets, and none that it passes at a
/// distance is left.
TEST_CASE_TEMPLATE("ray_bundle: meets what each of its rays meets", T, RAIO_NUMBERS) {
    random_numbers random(1);
    int bundles = 0, met_by_rays = 0, out_together = 0;
    for (int i = 0; i < at_least_a_tenth_of(50'000); ++i) {
        const std::vector<ray<T>> rays = random_bundle<T>(random);
        const ray_bundle bundle(std::span<const ray<T>>(rays), T(1), random_box_reach);
        if (!bundle.is_coherent()) continue;
        ++bundles;
        const auto count = static_cast<std::size_t>(random.integer(0, static_cast<int>(node_width)));
        const wide_node node = random_node(random, count);
        const double size = 1 / double(norm1(rays[0].direction));
        const bool is_one_ray = std::ranges::all_of(
            rays, [&](const ray<T>& r) { return r.origin == rays[0].origin && r.direction == rays[0].direction; });
        const auto t_min = static_cast<float>(random.one_in(2) ? 0 : random.uniform(-20, 20) * size);
        // Each ray looks as far as it likes; lanes without a ray not at all.
        std::array<float, ray_bundle::most> t_max;
        t_max.fill(-infinity<float>);
        float farthest = -infinity<float>;
        const bool is_one_point = random.one_in(4);
        for (std::size_t k = 0; k < rays.size(); ++k) {
            t_max[k] = random.one_in(2) ? infinity<float> : static_cast<float>(random.uniform(-10, 40) * size);
            if (is_one_point) t_max[k] = t_min;
            farthest = std::max(farthest, t_max[k]);
        }
        ray_bundle::numbers entry;
        const ray_bundle::numbers from(t_min);
        const std::uint32_t children = bundle.children_met(node, from, ray_bundle::numbers(farthest), entry);
        REQUIRE((children >> count) == 0);
        for (std::size_t j = 0; j < count; ++j) {
            const std::uint64_t met = bundle.rays_met(node, j, from, t_max);
            REQUIRE((met & ~first_bits(rays.size())) == 0);
            if ((children >> j & 1) != 0) {
                REQUIRE(entry[j] >= t_min);
                const interval<double> window{double(t_min) - 1e-3 * size, double(farthest) + 1e-3 * size};
                if (is_one_ray) REQUIRE(!within_box(rays[0], node.box(j), window, 1e-3).empty());
            }
            out_together += (children >> j & 1) == 0 ? 1 : 0;
            for (std::size_t k = 0; k < rays.size(); ++k) {
                const interval<double> window{double(t_min), double(t_max[k])};
                const interval<double> inside = within_box(rays[k], node.box(j), window);
                const bool is_met = (met >> k & 1) != 0;
                if (!inside.empty()) {
                    ++met_by_rays;
                    REQUIRE(is_met);
                    REQUIRE((children >> j & 1) != 0);
                    REQUIRE(double(entry[j]) <= inside.min);
                }
                const double more = 1e-3 / double(norm1(rays[k].direction));
                const interval<double> a_little_more{window.min - more, window.max + more};
                if (is_met) REQUIRE(!within_box(rays[k], node.box(j), a_little_more, 1e-3).empty());
            }
        }
    }
    CHECK(bundles > at_least_a_tenth_of(10'000));
    CHECK(met_by_rays > at_least_a_tenth_of(2000));
    CHECK(out_together > bundles / 2);
}

TEST_CASE_TEMPLATE("ray_bundle: boxes may be scaled", T, RAIO_NUMBERS) {
    const std::vector<ray<T>> rays{{vec3<T>(0x1p50), vec3<T>(0x1p50)}, {vec3<T>(0x1p51), vec3<T>(0x1p50)}};
    const ray_bundle bundle(std::span<const ray<T>>(rays), T(0x1p-50), random_box_reach);
    wide_node node;
    node.set(0, detail::to_build_box(aabb<float>{{5, 5, 5}, {6, 6, 6}}));
    node.set(1, detail::to_build_box(aabb<float>{{5, 5, 8}, {6, 6, 9}}));
    const ray_bundle::numbers from(0), to(infinity<float>);
    ray_bundle::numbers entry;
    CHECK(bundle.children_met(node, from, to, entry) == 1);
    CHECK(entry[0] == doctest::Approx(3));
    CHECK(bundle.rays_met(node, 0, from, everywhere) == first_bits(ray_bundle::numbers::lanes));
}

TEST_CASE("ray_bundle: the slowest ray has its slack, to which the origin's rounding matters most") {
    // Below y = 8 by less than a float tells, one ray leaves there at t = 0.02, the other at once.
    const vec3<double> origin(0, 8 - 2e-7, 0);
    const std::vector<ray<double>> rays{{origin, {1, 1e-5, 1}}, {origin, {1, 1, 1}}};
    const ray_bundle bundle(std::span<const ray<double>>(rays), 1.0, random_box_reach);
    REQUIRE(bundle.is_coherent());
    wide_node node;
    node.set(0, detail::to_build_box(aabb<float>{{0.01f, 0, -8}, {8, 8, 8}}));
    const ray_bundle::numbers from(0), to(infinity<float>);
    ray_bundle::numbers entry;
    CHECK(bundle.children_met(node, from, to, entry) == 1);
    CHECK((bundle.rays_met(node, 0, from, everywhere) & 3) == 1);
}

TEST_CASE_TEMPLATE("ray_bundle: a ray of its own is met by the children that each of them meets", T, RAIO_NUMBERS) {
    random_numbers random(2);
    for (int i = 0; i < at_least(1000); ++i) {
        const ray<T> r{random_ray<T>(random).origin, vec3<T>(random.direction())};
        const ray_bundle bundle(std::span(&r, 1), T(1), random_box_reach);
        REQUIRE(bundle.is_coherent());
        const wide_node node = random_node(random, node_width);
        const ray_bundle::numbers from(0), to(infinity<float>);
        ray_bundle::numbers entry;
        const std::uint32_t alone = detail::node_ray(r, T(1), random_box_reach).meets(node, from, to, entry);
        for (std::size_t j = 0; j < node_width; ++j) {
            const std::uint64_t every_lane = first_bits(ray_bundle::numbers::lanes);
            CHECK(bundle.rays_met(node, j, from, everywhere) == ((alone >> j & 1) != 0 ? every_lane : 0));
        }
    }
}

TEST_CASE("ray_bundle: rays of several octants, or out of range, are no bundle") {
    const vec3<float> o(0);
    const auto coherent = [](std::vector<ray<float>> rays) {
        return ray_bundle(std::span<const ray<float>>(rays), 1.0f, 1.0f).is_coherent();
    };
    CHECK(coherent({{o, {1, 1, 1}}}));
    CHECK(coherent({{o, {1, 1, 1}}, {{5, 6, 7}, {0.1f, 1, 30}}}));
    CHECK(!coherent({{o, {1, 1, 1}}, {o, {-1, 1, 1}}}));
    CHECK(!coherent({{o, {1, 1, 1}}, {o, {1, -1, 1}}}));
    CHECK(!coherent({{o, {1, 1, 1}}, {o, {1, 1, -1}}}));
    CHECK(coherent({{o, {-1, -1, -1}}, {o, {-1, -1, -2}}}));
    CHECK(coherent({{o, {1, 0, 0}}, {o, {1, 0, 0}}}));  // zeros go with their signs
    CHECK(!coherent({{o, {1, 0, 0}}, {o, {1, -0.0f, 0}}}));
    CHECK(!coherent({{o, {1, 1, 1}}, {o, {0x1p-91f, 0, 0}}}));
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        vec3<float> fast(1), far_off(0), slow(0);
        fast[axis] = 0x1p101f, far_off[axis] = 0x1p92f, slow[axis] = 0x1p-89f;
        CHECK(!coherent({{o, {1, 1, 1}}, {o, fast}}));
        CHECK(!coherent({{o, {1, 1, 1}}, {far_off, {1, 1, 1}}}));
        CHECK(coherent({{o, slow}, {o, slow}}));
    }
}

}  // namespace raio::test
