#include "interruption.hpp"

#include <atomic>
#include <csignal>

namespace render {
namespace {

constexpr int signals[] = {SIGINT, SIGTERM};

std::atomic<int> noted = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler can write nothing else");

extern "C" void note(int signal) {
    noted = signal;
    std::signal(signal, SIG_DFL);
}

}  // namespace

interruption::interruption() {
    noted = 0;
    for (int i = 0; i < 2; ++i) {
        former_[i] = std::signal(signals[i], note);
        if (former_[i] == SIG_IGN) std::signal(signals[i], SIG_IGN);  // as for what runs in the background
    }
}

interruption::~interruption() {
    for (int i = 0; i < 2; ++i) std::signal(signals[i], former_[i]);
}

int interruption::signal() const { return noted; }

}  // namespace render
