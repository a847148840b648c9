#pragma once

#include <raio/math/real.hpp>

namespace raio {

/// The parameters `min <= t <= max` of a ray. Empty where `min > max`, as it is when it is new.
template <real T>
struct interval {
    T min = infinity<T>;
    T max = -infinity<T>;

    RAIO_FN constexpr mask_t<T> empty() const { return !(min <= max); }
    RAIO_FN constexpr mask_t<T> contains(const T& t) const { return min <= t && t <= max; }
    RAIO_FN constexpr T length() const { return select(min <= max, max - min, T(0)); }
    RAIO_FN friend constexpr bool operator==(const interval&, const interval&) = default;
};

}  // namespace raio
