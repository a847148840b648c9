#include <raio/bvh/nearest_together.hpp>

#include <doctest/doctest.h>

#include "support/properties.hpp"
#include "support/trees.hpp"

namespace raio::test {

namespace {

using detail::ray_bundle;

/// Leaves of three kinds: two that have packs, and one that has none.
template <class T>
using kinds = detail::leaf_kinds<detail::leaf_blocks<triangle<T>>, detail::leaf_blocks<sphere<T>>,
                                 detail::leaf_list<convex_polyhedron<T>>>;

/// Puts random shapes into one kind of leaves, and keeps them by their ids.
template <class Shape, class Leaves>
std::vector<Shape> fill(random_numbers& random, Leaves& leaves, std::uint32_t first_id) {
    const auto shapes = random_shapes<Shape>(random, 24);
    std::vector<std::uint32_t> ids;
    std::vector<detail::leaf_range> ranges;
    for (std::uint32_t i = 0; i < shapes.size(); ++i) {
        if (i % Leaves::lanes == 0) ranges.push_back({i, 0});
        ids.push_back(first_id + i), ++ranges.back().count;
    }
    leaves.resize(ranges);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        leaves.fill(i, std::span(ids).subspan(ranges[i].first, ranges[i].count),
                    [&](std::uint32_t id) { return shapes[id - first_id]; });
    }
    return shapes;
}

/// The first of the nearest, as a loop finds it.
template <class T, class Shape>
void ask_all(const std::vector<Shape>& shapes, std::uint32_t first_id, const ray<T>& ray, T t_min, bool& exists,
             hit_record<T>& nearest, T t_max) {
    for (std::uint32_t i = 0; i < shapes.size(); ++i) {
        hit_record<T> rec{};
        if (!shapes[i].hit(ray, t_min, t_max, rec)) continue;
        rec.index = first_id + i;
        if (!exists || detail::comes_before(rec, nearest)) nearest = rec;
        exists = true;
    }
}

}  // namespace

/// Few rays and many, of which some may meet a leaf: asked ray by ray, and shape by shape.
TEST_CASE_TEMPLATE("nearest_together: what each ray finds alone, whoever is in the lanes", T, RAIO_NUMBERS) {
    random_numbers random(5);
    int hits = 0, left_out = 0;
    for (int i = 0; i < at_least_a_tenth_of(300); ++i) {
        kinds<T> leaves;
        const auto triangles = fill<triangle<T>>(random, std::get<0>(leaves.all), 0);
        const auto spheres = fill<sphere<T>>(random, std::get<1>(leaves.all), 100);
        const auto solids = fill<convex_polyhedron<T>>(random, std::get<2>(leaves.all), 200);
        const vec3<T> from = within<T>(random, 20), to = triangles.front().a - from;
        std::vector<ray<T>> rays(static_cast<std::size_t>(random.integer(1, static_cast<int>(ray_bundle::most))));
        const double apart = random.log_uniform(1e-3, 1);
        for (ray<T>& r : rays) r = {from, to + within<T>(random, apart) * norm1(to)};
        const T t_min = T(random.one_in(2) ? 0 : random.uniform(0, 1)), t_max = random.one_in(2) ? T(1.5) : infinity<T>;

        const detail::rays_in_lanes<T> lanes{std::span<const ray<T>>(rays)};
        std::vector<hit_record<T>> recs(rays.size());
        for (auto& rec : recs) rec.t = T(77);
        detail::nearest_together<T, kinds<T>> query(leaves, rays, lanes, t_min, t_max, recs);
        // A ray misses the leaves that it is not shown to; here that is so for one ray in two runs.
        std::uint64_t of = ~std::uint64_t{0} >> (64 - rays.size());
        if (random.one_in(2)) of &= ~(std::uint64_t{1} << random.integer(0, static_cast<int>(rays.size()) - 1));
        const auto near = [&](const auto& boxes) { return bits(boxes.min.x == boxes.min.x); };
        const auto show = [&](auto kind) {
            const std::uint32_t count = std::get<kind()>(leaves.all).size();
            for (std::uint32_t block = 0; block < count; ++block) query.template visit<kind()>(block, of, near);
        };
        show(std::integral_constant<std::size_t, 0>{});
        show(std::integral_constant<std::size_t, 1>{});
        show(std::integral_constant<std::size_t, 2>{});
        const std::uint64_t found = query.finish();
        REQUIRE((found & ~of) == 0);
        for (std::size_t k = 0; k < rays.size(); ++k) {
            hit_record<T> expected{};
            expected.t = T(77);
            bool exists = false;
            if ((of >> k & 1) != 0) {
                ask_all<T>(triangles, 0, rays[k], t_min, exists, expected, t_max);
                ask_all<T>(spheres, 100, rays[k], t_min, exists, expected, t_max);
                ask_all<T>(solids, 200, rays[k], t_min, exists, expected, t_max);
            } else {
                ++left_out;
            }
            REQUIRE((found >> k & 1) == (exists ? 1 : 0));
            if (exists) REQUIRE(query.farthest(k) >= expected.t);
            REQUIRE(same_as_plain(recs[k], expected));
            hits += exists ? 1 : 0;
        }
    }
    CHECK(hits > at_least_a_tenth_of(300));
    CHECK(left_out > at_least_a_tenth_of(50));
}

TEST_CASE_TEMPLATE("rays_in_lanes: each in its place, and the last as often as there is room", T, RAIO_NUMBERS) {
    random_numbers random(6);
    for (std::size_t count = 1; count <= ray_bundle::most; ++count) {
        std::vector<ray<T>> rays(count);
        for (ray<T>& r : rays) r = {within<T>(random, 1), within<T>(random, 1)};
        const detail::rays_in_lanes<T> packed{std::span<const ray<T>>(rays)};
        using P = typename detail::rays_in_lanes<T>::numbers;
        REQUIRE(packed.groups().size() == (count + P::lanes - 1) / P::lanes);
        for (std::size_t i = 0; i < packed.groups().size() * P::lanes; ++i) {
            const ray<T> own = detail::in_lane<P>(packed.groups()[i / P::lanes], i % P::lanes);
            const ray<T>& expected = rays[std::min(i, count - 1)];
            REQUIRE((own.origin == expected.origin && own.direction == expected.direction));
        }
    }
}

}  // namespace raio::test
