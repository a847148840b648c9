#pragma once

#include <chrono>
#include <mutex>

namespace render {

/// A bar on standard error that says how much is done and how long the rest will take. Silent unless that is a
/// terminal.
class progress {
public:
    progress(int steps, bool quiet);
    ~progress();
    progress(const progress&) = delete;
    progress& operator=(const progress&) = delete;

    /// One more step is done. Any thread may say so.
    void step();

private:
    using clock = std::chrono::steady_clock;

    std::mutex mutex_;
    const int steps_;
    const bool shown_;
    int done_ = 0;
    const clock::time_point begin_ = clock::now();
    clock::time_point next_ = begin_;  // when to draw again
};

}  // namespace render
