#include <raio/math/conic.hpp>

#include <doctest/doctest.h>

#include <numbers>

namespace raio::test {

namespace {

/// By Simpson's rule, in x = from + (to - from) s^2 (3 - 2 s), which slows down where a conic may be steep.
double numeric_area(const conic& c, double from, double to) {
    constexpr int steps = 20'000;
    double sum = 0;
    for (int i = 0; i <= steps; ++i) {
        const double s = double(i) / steps, x = from + (to - from) * s * s * (3 - 2 * s);
        sum += c(x) * 6 * s * (1 - s) * (i % 2 == 1 ? 4 : 2);
    }
    return sum * (to - from) / (3 * steps);
}

}  // namespace

TEST_CASE("conic: areas of the books") {
    CHECK(conic{1, -1}.area(0, 1) == doctest::Approx(std::numbers::pi / 4).epsilon(1e-15));  // a quarter of the disc
    CHECK(conic{4, -1}.area(1, 2) == doctest::Approx(2 * std::numbers::pi / 3 - std::sqrt(3.0) / 2).epsilon(1e-15));
    CHECK(conic{9, 0}.area(1, 3) == doctest::Approx(6).epsilon(1e-15));
    CHECK(conic{0, 4}.area(1, 3) == doctest::Approx(8).epsilon(1e-15));
    CHECK(conic{1, 1}.area(0, 1) == doctest::Approx((std::sqrt(2.0) + std::asinh(1.0)) / 2).epsilon(1e-15));
    CHECK(conic{1, 1}.area(1, 1) == 0);
    CHECK(conic{0, 0}.area(0, 1) == 0);
}

TEST_CASE("conic: areas as Simpson's rule finds them, and the places of their parts") {
    for (const conic& c : {conic{1, 3}, conic{1, 1e-14}, conic{1, -1e-14}, conic{1, -0.99}, conic{1, -1}, conic{2, 1e6},
                           conic{-0.25, 1}, conic{-0.24, 1}, conic{-0.2, 1e4}, conic{0, 2}}) {
        const double first = c.constant < 0 ? 0.5 : 0;
        for (const double from : {first, 0.75, 0.9999}) {
            for (const double to : {0.9999, 1.0}) {
                if (!(from < to)) continue;
                CAPTURE(c.constant);
                CAPTURE(c.square);
                CAPTURE(from);
                CHECK(c.area(from, to) == doctest::Approx(numeric_area(c, from, to)).epsilon(1e-9));
                for (const double part : {0.0, 1e-3, 0.3, 0.9, 1.0}) {
                    const double place = c.place(from, to, part);
                    CHECK((from <= place && place <= to));
                    CHECK(c.area(from, place) == doctest::Approx(part * c.area(from, to)).epsilon(1e-12));
                }
            }
        }
    }
}

TEST_CASE("conic: a part so small that its place has no square is sought near the tip, and not for ever") {
    const conic c{0, 1};
    const double place = c.place(0, 1, 1e-163);
    CHECK((0 <= place && c.area(0, place) < 1e-30));
}

}  // namespace raio::test
