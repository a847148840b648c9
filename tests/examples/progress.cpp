#include <algorithm>
#include <cstddef>

#include <doctest/doctest.h>
#include <render/progress.hpp>

using render::progress_line;

TEST_CASE("the bar is as long as the terminal allows, 40 at most, and stays off its last column") {
    CHECK(progress_line(0.5, 83, 80) == "[####################....................]  50 %, 1:23 left");
    CHECK(progress_line(0.5, 83, 30) == "[#####.....]  50 %, 1:23 left");
    CHECK(progress_line(0.5, 83, 25) == "[##...]  50 %, 1:23 left");
    CHECK(progress_line(0.5, 83, 24) == " 50 %, 1:23 left");
    CHECK(progress_line(0.5, 83, 17) == " 50 %, 1:23 left");
    CHECK(progress_line(0.5, 83, 16) == " 50 %");
    CHECK(progress_line(0.5, 83, 5) == "");
    CHECK(progress_line(0.5, 83, 0) == "");
    for (int columns = 0; columns < 200; ++columns) {
        for (const double done : {0.001, 0.3, 1.0}) {
            CHECK(progress_line(done, 1e12, columns).size() <= static_cast<std::size_t>(std::max(columns - 1, 0)));
        }
    }
}
