#pragma once

namespace render {

/// While one lives, Ctrl-C (SIGINT) and SIGTERM do not end the program but are noted, so that what has been done can be
/// kept. The second one of a kind ends it. One lives at a time.
class interruption {
public:
    interruption();
    ~interruption();
    interruption(const interruption&) = delete;
    interruption& operator=(const interruption&) = delete;

    /// The signal that came; 0 if there was none. Any thread may ask.
    int signal() const;

private:
    void (*former_[2])(int);
};

}  // namespace render
