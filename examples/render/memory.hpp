#pragma once

#include <new>
#include <stdexcept>
#include <string_view>

#include "tokens.hpp"

namespace render {

/// What `make` returns. Where there is no memory left for that, the `std::runtime_error` says what it was for.
template <class Make>
auto with_memory_for(std::string_view what, Make make) {
    const auto fail = [&] { return std::runtime_error(joined({"raio-render: out of memory for ", what})); };
    try {
        return make();
    } catch (const std::bad_alloc&) {
        throw fail();
    } catch (const std::length_error&) {  // of a container: more than any memory has
        throw fail();
    }
}

}  // namespace render
