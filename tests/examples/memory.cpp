#include <new>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>
#include <render/memory.hpp>
#include <render/reader.hpp>

#include "reader_text.hpp"

using namespace render;

TEST_CASE("running out of memory is told with what it was for") {
    CHECK(with_memory_for("a test", [] { return 1; }) == 1);
    CHECK_THROWS_WITH(with_memory_for("a test", []() -> int { throw std::bad_alloc(); }),
                      "raio-render: out of memory for a test");
    CHECK_THROWS_WITH(with_memory_for("a test", [] { std::vector<int>().reserve(static_cast<std::size_t>(-1)); }),
                      "raio-render: out of memory for a test");
    CHECK_THROWS_AS(with_memory_for("a test", []() -> int { throw scene_error("another"); }), scene_error);
}

TEST_CASE("a texture that memory is too short for is not called a file that is no picture") {
    const loaders load{[](const auto&) -> texture { throw std::bad_alloc(); }, square};
    const scene_text text{.pigments = "1 texture wood.png  0 0 0 0  0 0 0 0"};
    CHECK_THROWS_AS(parse_scene(text.joined(), "scenes/test.txt", load), std::bad_alloc);
}
