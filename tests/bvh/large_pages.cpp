#include <raio/bvh/large_pages.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <string>

namespace raio::test {

namespace {

template <class Value>
std::size_t address_modulo(const Value* place, std::size_t size) {
    return reinterpret_cast<std::uintptr_t>(place) % size;
}

struct alignas(256) wide {
    std::array<std::byte, 256> bytes;
};

}  // namespace

TEST_CASE("large_pages: in lines; large blocks in pages") {
    using pages = detail::large_pages<int>;
    constexpr std::size_t large = pages::page / sizeof(int);
    static_assert(!pages::is_large(large - 1) && pages::is_large(large));
    static_assert(pages::bytes(large - 1) == pages::page - sizeof(int) && pages::bytes(large + 1) == 2 * pages::page);
    pages allocator;
    for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::size_t{17}, large - 1, large, 3 * large + 1}) {
        int* const place = allocator.allocate(n);
        CHECK(address_modulo(place, n < large ? pages::line : pages::page) == 0);
        std::fill_n(place, n, 7);  // all of it is there
        allocator.deallocate(place, n);
    }
}

TEST_CASE("large_pages: what asks for more than a line gets it") {
    detail::large_pages<wide> allocator;
    std::array<wide*, 5> places{};
    for (wide*& place : places) place = allocator.allocate(1);
    for (wide* const place : places) {
        CHECK(address_modulo(place, alignof(wide)) == 0);
        allocator.deallocate(place, 1);
    }
}

TEST_CASE("large_vector: what has no value is left unset, and what has one is not") {
    detail::large_vector<int> numbers{1, 2, 3};
    numbers.clear();
    numbers.resize(3);  // in the same place
    CHECK(numbers == detail::large_vector<int>{1, 2, 3});
    numbers.assign(3, 7);
    CHECK(numbers == detail::large_vector<int>{7, 7, 7});
    detail::large_vector<std::string> words(2);  // which cannot be left unset
    CHECK((words[0].empty() && words[1].empty()));
}

TEST_CASE("large_vector: grows from small blocks to large ones, and is copied and moved") {
    constexpr std::size_t large = detail::large_pages<int>::page / sizeof(int);
    detail::large_vector<int> numbers;
    for (std::size_t i = 0; i < large + 5; ++i) numbers.push_back(static_cast<int>(i));
    const detail::large_vector<int> copy = numbers, moved = std::move(numbers);
    CHECK(copy == moved);
    CHECK(copy.data() != moved.data());
    CHECK(address_modulo(moved.data(), detail::large_pages<int>::page) == 0);
    for (std::size_t i = 0; i < moved.size(); ++i) REQUIRE(moved[i] == static_cast<int>(i));
    CHECK(detail::large_pages<int>(detail::large_pages<wide>()) == detail::large_pages<int>());
}

}  // namespace raio::test
