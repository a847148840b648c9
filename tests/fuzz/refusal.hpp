#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <render/tokens.hpp>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#include <sanitizer/allocator_interface.h>
#define RAIO_ALLOCATIONS_ARE_TOLD
#endif
#endif

/// While one of these lives, this thread holds no more than so many bytes beyond what it held before, or stops where it
/// asks for more. That is watched under the address sanitizer alone, which tells what is allocated.
class memory_limit {
public:
    explicit memory_limit(std::size_t bytes) {
#if defined(RAIO_ALLOCATIONS_ARE_TOLD)
        static const int hooks = __sanitizer_install_malloc_and_free_hooks(
            [](const volatile void*, std::size_t size) {
                if ((left -= static_cast<std::ptrdiff_t>(size)) < 0) std::abort();
            },
            [](const volatile void* p) { left += static_cast<std::ptrdiff_t>(__sanitizer_get_allocated_size(p)); });
        if (hooks == 0) std::abort();
#endif
        left = static_cast<std::ptrdiff_t>(bytes);
    }
    ~memory_limit() { left = endless; }
    memory_limit(const memory_limit&) = delete;
    memory_limit& operator=(const memory_limit&) = delete;

private:
    static constexpr std::ptrdiff_t endless = PTRDIFF_MAX / 2;
    static inline thread_local std::ptrdiff_t left = endless;
};

/// A reader may refuse its input, in one line of a sensible length that names the file and says what was expected. It
/// holds memory in proportion to the bytes that it is given.
/// \param bytes  how many these are
template <class Read>
void check_read_or_refused(std::string_view file, std::size_t bytes, Read read) {
    const auto check = [](bool holds) {
        if (!holds) std::abort();
    };
    try {
        // A corner of two bytes, "1 ", makes a triangle of nine doubles, and a vector that grows holds the old ones and
        // room for twice as many: 108 bytes for each. Where the face is cut, what knows its corners takes up to 82
        // more. An error's words and one object are what is fixed.
        const memory_limit limit(16'384 + 200 * bytes);
        read();
    } catch (const render::scene_error& error) {
        const std::string_view message = error.what();
        check(message.starts_with(file) && message.substr(file.size()).starts_with(':'));
        check(message.find(", expected ") != message.npos);
        check(message.find('\n') == message.npos && message.size() < 1000);
    }
}
