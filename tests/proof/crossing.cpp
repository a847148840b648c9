#include <raio/proof/crossing.hpp>
#include <raio/proof/line.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "support/random.hpp"

namespace raio::test {

/// Half of the largest float is 1.7e38.
TEST_CASE("crossing: only what the ray reaches in numbers of its type is kept") {
    struct row {
        float origin, t, error;
        bool exists, certain;
    };
    for (const row& r : {row{0, 5e37f, 0, true, true},
                         {0, -5e37f, 0, true, true},
                         {0, 8.5072e37f, 0, true, false},  // more than a quarter of the largest float
                         {0, 1e38f, 0, true, false},
                         {0, -1e38f, 0, true, false},
                         {0, 5e37f, 5e37f, true, false},
                         {-5e37f, 5e37f, 0, true, false},
                         {0, 2e38f, 0, false, false},
                         {0, -2e38f, 0, false, false},
                         {1e38f, 1e38f, 0, false, false},
                         {-1e38f, 1e38f, 0, false, false}}) {
        INFO(r.origin << ", " << r.t << ", " << r.error);
        const ray<float> ray{{r.origin, 0, 0}, {0, -1, 0}};
        for (const bool certain : {false, true}) {
            crossing<float> c{true, certain, r.t, r.error, true}, none{false, certain, r.t, r.error, true};
            keep_if_in_range<float>(line_in<float>(ray), c), keep_if_in_range<float>(line_in<float>(ray), none);
            CHECK((c.exists == r.exists && c.certain == (certain && r.certain)));
            CHECK((!none.exists && none.certain == certain));
            crossing<double> fine{true, certain, double(r.t), double(r.error), true};
            keep_if_in_range<float>(line_in<double>(ray), fine);
            CHECK((fine.exists == r.exists && fine.certain == certain));
        }
    }
}

TEST_CASE("crossing: what is out of the window, whatever way and size are off by") {
    random_numbers random(1);
    int out = 0, may_be_in = 0;
    for (int i = 0; i < at_least(20'000); ++i) {
        const auto some_error = [&] { return random.one_in(2) ? 0.0 : random.log_uniform(1e-6, 1); };
        const double size = random.log_uniform(1e-2, 1e2), way = random.uniform(-3, 3) * size;
        const double size_error = some_error() * size / 4, way_error = some_error() * size;
        const double from = random.uniform(-2, 2), to = from + random.uniform(0, 2);
        double t_min = infinity<double>, t_max = -infinity<double>;
        for (const double w : {way - way_error, way + way_error}) {
            for (const double s : {size - size_error, size + size_error}) {
                t_min = std::min(t_min, w / s), t_max = std::max(t_max, w / s);
            }
        }
        const bool all_out = t_max < from || t_min > to;
        const bool unwanted = is_unwanted(first_from<double>{from, to, false}, way, way_error, size, size_error);
        if (unwanted) REQUIRE(all_out);
        out += all_out ? 1 : 0, may_be_in += all_out && !unwanted ? 1 : 0;
        CHECK(!is_unwanted(every_crossing{}, way, way_error, size, size_error));
        CHECK(!is_unwanted(first_from<float>{1e30f, 2e30f, false}, way, way_error, size, size_error));
    }
    CHECK(may_be_in < out / 4);
    CHECK(!is_unwanted(first_from<double>{-infinity<double>, infinity<double>, false}, 1.0, 0.5, 1.0, 0.5));
    CHECK(!is_unwanted(first_from<double>{0, infinity<double>, false}, 0.0, 0.0, 0.0, 0.0));
    // A t of 2^-1200 is 0.
    CHECK(!is_unwanted(first_from<double>{0, 0, false}, 0x1p-1000, 0.0, 0x1p200, 0.0));
    CHECK(!is_unwanted(first_from<double>{0, 0, false}, -0x1p-1000, 0.0, 0x1p200, 0.0));
}

}  // namespace raio::test
