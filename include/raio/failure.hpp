#pragma once

#include <raio/push_macros.hpp>

#include <cstdio>
#include <cstdlib>

#include <raio/config.hpp>

namespace raio::inline RAIO_ABI {

/// Called with the message where something is refused and the program is compiled without exceptions. It ends the
/// program; whoever wants to do that otherwise assigns a function of his own, which must not come back.
inline void (*on_failure)(const char* message) = [](const char* message) {
    std::fprintf(stderr, "%s\n", message);
    std::abort();
};

namespace detail {

/// Throws the exception or, with -fno-exceptions, calls `on_failure`.
template <class Exception>
[[noreturn]] void fail(const Exception& failure) {
#if defined(__cpp_exceptions)
    throw failure;
#else
    on_failure(failure.what());
    std::abort();
#endif
}

}  // namespace detail

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
