#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/polynomial.hpp>
#include <raio/proof/chord.hpp>

namespace raio::inline RAIO_ABI {

/// A polynomial and its derivative.
template <real W, std::size_t N>
struct differentiated {
    polynomial<W, N> value;
    polynomial<W, N - 1> slope = value.derivative();
};

/// b - sqrt(s) and b + sqrt(s), where one of them has an extremum at u, or u is known exactly: at an extremum a
/// function changes no faster than with the square of what the place is off by. \param minus_s  -s; where s is below
/// zero, or may be, its root counts as zero
template <class W, std::size_t N, std::size_t M>
RAIO_FN constexpr root_pair<W> extremes_near(const differentiated<W, N>& b, const differentiated<W, M>& minus_s,
                                             const bounded_number<W>& u) {
    using E = bound_t<W>;
    const auto& [b_value, b_slope] = b;
    const auto& [s_value, s_slope] = minus_s;
    const E off = u.error, place = size_of(u) + off, noise = s_value.noise()(place), b_noise = b_value.noise()(place);
    const W height = -s_value(u.value), middle = b_value(u.value), root = E(height) > noise ? sqrt(height) : W(0);
    // How fast b and s change within `off`, and how fast that changes.
    const E b_bend = b_slope.derivative().magnitude(place), s_bend = s_slope.derivative().magnitude(place);
    const E b_rise = abs(E(b_slope(u.value))) + b_slope.noise()(place) + off * b_bend;
    const E s_rise = abs(E(s_slope(u.value))) + s_slope.noise()(place) + off * s_bend;
    const E least = E(height) - noise - off * s_rise, most = abs(E(height)) + noise + off * s_rise;
    E error = off * b_rise + E(2) * sqrt(most);
    if (least > E(0)) {
        const E low = sqrt(least), bend = b_bend + (s_bend + s_rise * s_rise / (E(2) * least)) / (E(2) * low);
        error = min(error, off * off * bend + noise / low);
    }
    error += b_noise + E(16 * unit_roundoff<W>) * (abs(E(middle)) + E(root));
    return {{middle - root, error}, {middle + root, error}};
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
