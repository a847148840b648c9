#include <raio/bvh/options.hpp>

#include "support/trees.hpp"

namespace raio::test {

static_assert(bvh_options{}.quality == bvh_quality::standard && bvh_options{}.threads == 0);

namespace {

double cost_of(const std::vector<triangle<float>>& shapes, const bvh_options& options) {
    return bvh(std::span<const triangle<float>>(shapes), options).cost();
}

}  // namespace

TEST_CASE("bvh_options: the more time, the less a ray costs") {
    random_numbers random(1);
    std::vector<triangle<float>> small, across;
    for (int i = 0; i < 2000; ++i) {
        const vec3<float> place = within<float>(random, 8);
        small.push_back({place, place + within<float>(random, 0.5), place + within<float>(random, 0.5)});
        across.push_back({within<float>(random, 8), within<float>(random, 8), within<float>(random, 8)});
    }
    for (const auto& shapes : {small, across}) {
        CHECK(cost_of(shapes, {}) == cost_of(shapes, {.quality = bvh_quality::standard, .threads = 1}));
        CHECK(cost_of(shapes, {}) < cost_of(shapes, {.quality = bvh_quality::low}));
        CHECK(cost_of(shapes, {.quality = bvh_quality::high}) <= cost_of(shapes, {}));
    }
    CHECK(cost_of(across, {.quality = bvh_quality::high}) < cost_of(across, {}));
}

}  // namespace raio::test
