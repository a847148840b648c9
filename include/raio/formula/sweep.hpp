#pragma once

#include <raio/formula/polynomial_along.hpp>

/// \file
/// Where a line goes into what a sphere sweeps whose centre and radius are cubics, and out of it.

namespace raio::detail {

/// A place of the curve where s begins or ends to be above zero, and how far that may be off.
template <class W>
struct end_of_stretch {
    W u;
    bound_t<W> error;
};

/// b and s along the curve, for a part of the line (see shape/bezier_curve.hpp, where b, s and d are defined).
template <class W>
struct sweep {
    using E = bound_t<W>;

    W a;
    polynomial<W, 3> b;
    polynomial<W, 6> beyond;  ///< -s
    polynomial<W, 2> b_slope = b.derivative();
    polynomial<W, 5> beyond_slope = beyond.derivative();

    /// From the least t of a stretch of the curve to the greatest.
    RAIO_FN constexpr chord<W> extent(const line_part<W>& part, const end_of_stretch<W>& from,
                                      const end_of_stretch<W>& to) const {
        // What cannot be told from a point is where that is known best: an end of the curve is known exactly. (From the
        // one end of what a root may be to the other is twice its error.)
        const W length = to.u - from.u;
        if (E(length) <= E(2) * max(from.error, to.error)) {
            const W middle = from.u + length * W(0.5);
            return at(part, from.error < to.error ? from.u : to.error < from.error ? to.u : middle, E(length));
        }
        chord<W> c = unite(at(part, from.u, from.error), at(part, to.u, to.error));
        const polynomial<W, 2> twice = b_slope + b_slope;
        const auto turns = product<10>(beyond, product<4>(twice, twice)) + product<10>(beyond_slope, beyond_slope);
        for (const polynomial_root<W>& root : roots_between(turns, from.u, to.u)) {
            c = unite(c, at(part, root.t, root.error));
        }
        return c;
    }

    /// Where the line goes into the sphere of u and out of it; of the greatest and the least t, that are no farther
    /// away than `off`, they are off by no more than the error.
    RAIO_FN constexpr chord<W> at(const line_part<W>& part, const W& u, const E& off) const {
        W height = -beyond(u), middle = b(u);
        E place = abs(E(u)) + off, noise = beyond.noise()(place), b_noise = b.noise()(place);
        W root = E(height) > noise ? sqrt(height) : W(0);
        // How fast b and s change within `off`, and how fast that changes.
        E b_bend = b_slope.derivative().magnitude(place), s_bend = beyond_slope.derivative().magnitude(place);
        E b_rise = abs(E(b_slope(u))) + b_slope.noise()(place) + off * b_bend;
        E s_rise = abs(E(beyond_slope(u))) + beyond_slope.noise()(place) + off * s_bend;
        E least = E(height) - noise - off * s_rise, most = abs(E(height)) + noise + off * s_rise;
        E error = off * b_rise + E(2) * sqrt(most);
        if (least > E(0)) {
            E low = sqrt(least), bend = b_bend + (s_bend + s_rise * s_rise / (E(2) * least)) / (E(2) * low);
            error = min(error, off * off * bend + noise / low);
        }
        error += b_noise + E(32 * unit_roundoff<W>) * (abs(E(middle)) + E(root));
        const auto end = [&](const W& sum, bool entering) {
            crossing<W> c = part.at({sum / a, error / E(a), 0, 0, E(0)}, entering);
            c.u = u, c.v = W(off + off);
            return c;
        };
        return {end(middle - root, true), end(middle + root, false)};
    }
};

}  // namespace raio::detail
