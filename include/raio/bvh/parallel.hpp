#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <raio/config.hpp>

namespace raio::detail {

/// How many threads are meant by that many: 0 stands for all of the machine's.
inline unsigned thread_count(unsigned wanted) {
    return wanted != 0 ? wanted : std::max(1u, std::thread::hardware_concurrency());
}

/// Calls `work` with 0, 1, ..., count - 1, on several threads and in no certain order. What is thrown comes out once
/// all of them have stopped.
template <class Work>
void parallel_for(std::size_t count, unsigned threads, Work work) {
    std::atomic<std::size_t> next = 0;
    std::exception_ptr failure;
    std::mutex failing;
    const auto run = [&] {
        try {
            for (std::size_t i; (i = next++) < count;) work(i);
        } catch (...) {
            const std::lock_guard lock(failing);
            if (!failure) failure = std::current_exception();
            next = count;
        }
    };
    {
        std::vector<std::jthread> others;
        for (std::size_t i = 1; i < std::min<std::size_t>(threads, count); ++i) others.emplace_back(run);
        run();
    }
    if (failure) std::rethrow_exception(failure);
}

/// A part of a range, from `begin` to before `end`.
struct part {
    std::size_t begin, end;
    std::size_t size() const { return end - begin; }
};

/// Part `i` of the range that is cut into parts of `size`, of which the last may be shorter.
inline part part_of(std::size_t i, std::size_t size, std::size_t total) {
    return {i * size, std::min(total, (i + 1) * size)};
}

/// How many parts these are.
inline std::size_t parts_of(std::size_t size, std::size_t total) { return (total + size - 1) / size; }

}  // namespace raio::detail
