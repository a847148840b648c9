#pragma once

#include <raio/push_macros.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

#include <raio/config.hpp>

// Where a program has one thread only, as in WebAssembly without its threads, compilers do not define this; and nothing
// of <thread> may be asked for then. RAIO_NO_THREADS says that there are none.
#if defined(__STDCPP_THREADS__) && !defined(RAIO_NO_THREADS)
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#endif

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// Anything that is called with the index of a piece of work. It is not owned, and has to outlive this. (One type for
/// all of them: what starts threads is compiled once.)
class work_on {
public:
    template <class Work>
    work_on(const Work& work)
        : work_(&work), call_([](const void* all, std::size_t i) { (*static_cast<const Work*>(all))(i); }) {}
    void operator()(std::size_t i) const { call_(work_, i); }

private:
    const void* work_;
    void (*call_)(const void*, std::size_t);
};

#if defined(__STDCPP_THREADS__) && !defined(RAIO_NO_THREADS)

/// How many threads are meant by that many: 0 stands for all of the machine's.
inline unsigned thread_count(unsigned wanted) {
    return wanted != 0 ? wanted : std::max(1u, std::thread::hardware_concurrency());
}

/// Threads that are waited for, whatever happens. (libc++ has no jthread.)
class joined_threads {
public:
    joined_threads() = default;
    joined_threads(const joined_threads&) = delete;
    joined_threads& operator=(const joined_threads&) = delete;
    ~joined_threads() {
        for (std::thread& thread : threads_) thread.join();
    }

    template <class Run>
    void start(Run run) {
        threads_.emplace_back(run);
    }

private:
    std::vector<std::thread> threads_;
};

/// Calls `work` with 0, 1, ..., count - 1, on several threads and in no certain order. What is thrown comes out once
/// all of them have stopped.
inline void parallel_for(std::size_t count, unsigned threads, work_on work) {
    std::atomic<std::size_t> next = 0;
    const auto run_all = [&] {
        for (std::size_t i; (i = next++) < count;) work(i);
    };
#if defined(__cpp_exceptions)
    std::exception_ptr failure;
    std::mutex failing;
    const auto run = [&] {
        try {
            run_all();
        } catch (...) {
            const std::lock_guard lock(failing);
            if (!failure) failure = std::current_exception();
            next = count;
        }
    };
#else
    const auto run = run_all;
#endif
    {
        joined_threads others;
        for (std::size_t i = 1; i < std::min<std::size_t>(threads, count); ++i) others.start(run);
        run();
    }
#if defined(__cpp_exceptions)
    if (failure) std::rethrow_exception(failure);
#endif
}

#else

/// However many are wanted, there is one.
inline unsigned thread_count(unsigned) { return 1; }

/// Calls `work` with 0, 1, ..., count - 1.
inline void parallel_for(std::size_t count, unsigned, work_on work) {
    for (std::size_t i = 0; i < count; ++i) work(i);
}

#endif

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

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
