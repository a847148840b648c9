#include "progress.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

namespace render {
namespace {

bool on_terminal() {
#if __has_include(<unistd.h>)
    return isatty(STDERR_FILENO) == 1;
#else
    return false;
#endif
}

}  // namespace

progress::progress(int steps, bool quiet) : steps_(steps), shown_(!quiet && on_terminal()) {}

progress::~progress() {
    if (shown_) std::fputs("\r\x1b[K", stderr);  // clears the line
}

void progress::step() {
    if (!shown_) return;
    const std::lock_guard lock(mutex_);
    ++done_;
    const clock::time_point now = clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);

    constexpr int width = 40;
    const double share = double(done_) / steps_;
    const double left = std::chrono::duration<double>(now - begin_).count() * (1 - share) / share;  // in seconds
    const auto filled = static_cast<std::size_t>(share * width);
    const int seconds = static_cast<int>(std::min(left + 0.5, 1e9));
    std::fprintf(stderr, "\r[%s%s] %3d %%, %d:%02d left\x1b[K", std::string(filled, '#').c_str(),
                 std::string(width - filled, '.').c_str(), static_cast<int>(100 * share), seconds / 60, seconds % 60);
    std::fflush(stderr);
}

}  // namespace render
