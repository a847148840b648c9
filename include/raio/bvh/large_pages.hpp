#pragma once

#include <raio/push_macros.hpp>

#include <algorithm>
#include <cstddef>
#include <new>
#include <type_traits>
#include <vector>

#include <raio/config.hpp>

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// Allocates in cache lines, and what is large in the largest pages that the system grants: there are not so many of
/// these that the processor forgets where they are before a ray comes by again.
template <class Value>
struct large_pages {
    using value_type = Value;

    static constexpr std::size_t line = 64, page = std::size_t{1} << 21;

    large_pages() = default;
    template <class Other>
    constexpr large_pages(const large_pages<Other>&) {}

    static constexpr bool is_large(std::size_t n) { return n * sizeof(Value) >= page; }
    /// Whole pages of what is large: what does not fill one is mapped in hundreds of small ones.
    static constexpr std::size_t bytes(std::size_t n) {
        const std::size_t size = n * sizeof(Value);
        return is_large(n) ? (size + page - 1) / page * page : size;
    }
    static constexpr std::align_val_t alignment(std::size_t n) {
        return std::align_val_t(is_large(n) ? page : std::max(alignof(Value), line));
    }

    Value* allocate(std::size_t n) {
        void* place = ::operator new(bytes(n), alignment(n));
#if defined(MADV_HUGEPAGE)
        if (is_large(n)) madvise(place, bytes(n), MADV_HUGEPAGE);
#endif
        return static_cast<Value*>(place);
    }
    /// What is new without a value is left unset: it is about to be written, and perhaps by several threads.
    template <class Unset>
    requires std::is_trivially_copyable_v<Unset>
    void construct(Unset*) {}
    void deallocate(Value* place, std::size_t n) { ::operator delete(place, alignment(n)); }

    friend bool operator==(const large_pages&, const large_pages&) { return true; }
};

template <class Value>
using large_vector = std::vector<Value, large_pages<Value>>;

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
