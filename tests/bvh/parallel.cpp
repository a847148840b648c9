#include <raio/bvh/parallel.hpp>

#include <doctest/doctest.h>

#include <set>
#include <stdexcept>

namespace raio::test {

TEST_CASE("parallel_for: every index once, on no more threads than are wanted") {
    for (const std::size_t count : {0u, 1u, 2u, 7u, 1000u}) {
        for (const unsigned threads : {0u, 1u, 2u, 3u, 8u}) {
            std::vector<int> calls(count, 0);
            std::mutex both;
            std::set<std::thread::id> workers;
            detail::parallel_for(count, threads, [&](std::size_t i) {
                ++calls[i];
                const std::lock_guard lock(both);
                workers.insert(std::this_thread::get_id());
            });
            CHECK(std::ranges::all_of(calls, [](int c) { return c == 1; }));
            CHECK(workers.size() <= std::min<std::size_t>(std::max(threads, 1u), count));
            if (threads <= 1 && count > 0) CHECK(workers == std::set{std::this_thread::get_id()});
        }
    }
}

TEST_CASE("parallel_for: all threads work at the same time") {
    std::atomic<unsigned> arrived = 0;
    detail::parallel_for(4, 4, [&](std::size_t) {  // each waits for the three others
        ++arrived;
        while (arrived < 4) std::this_thread::yield();
    });
    CHECK(arrived == 4);
}

TEST_CASE("parallel_for: what is thrown comes out when all have stopped, and nothing is begun after it") {
    for (const unsigned threads : {1u, 2u, 8u}) {
        std::atomic<int> begun = 0, ended = 0;
        const auto work = [&](std::size_t i) {
            ++begun;
            if (i == 5) {
                ++ended;
                throw std::runtime_error("the sixth");
            }
            ++ended;
        };
        CHECK_THROWS_WITH_AS(detail::parallel_for(1'000'000, threads, work), "the sixth", std::runtime_error);
        CHECK(begun == ended);
        CHECK(begun < 1'000'000);
        if (threads == 1) CHECK(begun == 6);
    }
    // Of several one comes out, also if two are thrown at the same time.
    std::atomic<unsigned> arrived = 0;
    const auto both = [&](std::size_t i) {
        ++arrived;
        while (arrived < 2) std::this_thread::yield();
        throw i;
    };
    CHECK_THROWS_AS(detail::parallel_for(2, 2, both), std::size_t);
    CHECK(arrived == 2);
    CHECK_THROWS_AS(detail::parallel_for(100, 8, [](std::size_t i) { throw i; }), std::size_t);
}

TEST_CASE("thread_count: 0 are all that the machine has") {
    CHECK(detail::thread_count(0) == std::max(1u, std::thread::hardware_concurrency()));
    CHECK(detail::thread_count(1) == 1);
    CHECK(detail::thread_count(1000) == 1000);
}

TEST_CASE("part_of: parts of one size, the last perhaps smaller, one behind the other") {
    for (std::size_t total = 0; total < 40; ++total) {
        for (std::size_t size = 1; size < 12; ++size) {
            std::size_t end = 0;
            for (std::size_t i = 0; i < detail::parts_of(size, total); ++i) {
                const detail::part p = detail::part_of(i, size, total);
                REQUIRE(p.begin == end);
                REQUIRE(p.size() == std::min(size, total - p.begin));
                REQUIRE(p.size() > 0);
                end = p.end;
            }
            REQUIRE(end == total);
        }
    }
}

}  // namespace raio::test
