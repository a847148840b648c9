#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace render {

/// How much is done, from 0 to 1, and how long the rest will take, in less than so many columns of a terminal: with a
/// bar where there is room for one.
std::string progress_line(double done, double seconds_left, int columns);

/// A bar on standard error that says how much is done and how long the rest will take. Silent unless that is a
/// terminal.
class progress {
public:
    progress(int steps, bool quiet);
    ~progress();
    progress(const progress&) = delete;
    progress& operator=(const progress&) = delete;

    bool is_shown() const { return shown_; }

    /// Takes the bar away.
    void clear();

    /// One more step is done. Any thread may say so.
    void step();

    int done() const { return done_; }  ///< steps, once no thread says so any more

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
