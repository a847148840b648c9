#pragma once

#include <raio/push_macros.hpp>

#include <vector>

#include <raio/math/interval.hpp>

namespace raio::inline RAIO_ABI::detail {

/// Spans whose number is not known before the program runs have a memory of their own.
template <class T>
struct span_storage<T, any_number> {
    using type = std::vector<interval<T>>;
};

}  // namespace raio::inline RAIO_ABI::detail

#include <raio/pop_macros.hpp>
