#include "progress.hpp"

#include <algorithm>
#include <cstdio>

#if __has_include(<unistd.h>) && __has_include(<sys/ioctl.h>)
#include <sys/ioctl.h>
#include <unistd.h>
#define RAIO_KNOWS_TERMINALS
#endif

namespace render {
namespace {

bool on_terminal() {
#if defined(RAIO_KNOWS_TERMINALS)
    return isatty(STDERR_FILENO) == 1;
#else
    return false;
#endif
}

int columns() {
#if defined(RAIO_KNOWS_TERMINALS)
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
#endif
    return 80;
}

}  // namespace

std::string progress_line(double done, double seconds_left, int columns) {
    const int percent = static_cast<int>(100 * done), seconds = static_cast<int>(std::min(seconds_left + 0.5, 1e9));
    char share[16], rest[32];
    std::snprintf(share, sizeof share, "%3d %%", percent);
    std::snprintf(rest, sizeof rest, ", %d:%02d left", seconds / 60, seconds % 60);

    // The last column stays free: some terminals go on to the next line as soon as it is filled.
    const auto room = static_cast<std::size_t>(std::max(columns - 1, 0));
    std::string line = share;
    if (line.size() > room) return "";
    if (line.size() + std::string(rest).size() > room) return line;
    line += rest;
    constexpr std::size_t widest = 40, narrowest = 5, frame = 3;
    if (line.size() + frame + narrowest > room) return line;
    const std::size_t width = std::min(widest, room - frame - line.size());
    const auto filled = static_cast<std::size_t>(done * static_cast<double>(width));
    return "[" + std::string(filled, '#') + std::string(width - filled, '.') + "] " + line;
}

progress::progress(int steps, bool quiet) : steps_(steps), shown_(!quiet && on_terminal()) {}

progress::~progress() { clear(); }

void progress::clear() {
    if (shown_) std::fputs("\r\x1b[K", stderr);
}

void progress::step() {
    const std::lock_guard lock(mutex_);
    ++done_;
    const clock::time_point now = clock::now();
    if (!shown_ || now < next_) return;
    next_ = now + std::chrono::milliseconds(100);

    const double share = double(done_) / steps_;
    const double left = std::chrono::duration<double>(now - begin_).count() * (1 - share) / share;  // in seconds
    std::fprintf(stderr, "\r%s\x1b[K", progress_line(share, left, columns()).c_str());
    std::fflush(stderr);
}

}  // namespace render
