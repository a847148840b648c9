#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/polynomial.hpp>

/// \file
/// A quick look for the first root of a quartic without a cubic term.
///
/// Its inflections are at -w and w, with w^2 = -c2 / 6 c4; it is convex outside of them and concave between (and convex
/// everywhere if that is no square). Where it is concave, or convex and above zero at both ends, little has to be known
/// to tell whether there is a root: a concave function is above the line between two of its points, and a convex one
/// above its tangents. So the roots of its derivative need not be found.

namespace raio::inline RAIO_ABI {

/// Where the first root is, the only one between `low`, where the polynomial is positive, and `high`, where it is
/// negative.
template <real W>
struct first_root {
    bool known = false;           ///< if not, nothing is
    bool exists = false;          ///< there is no root at all if not
    W low{0}, high{0}, guess{0};  ///< `guess` is where to look first
};

/// c4 x^4 + c2 x^2 + c1 x + c0, with c4 > 0, for x between -1 and 1.
template <real W>
class depressed_quartic {
public:
    using E = bound_t<W>;

    /// \param noise  of the polynomial, from -1 to 1 at least
    RAIO_FN constexpr depressed_quartic(const polynomial<W, 4>& p, const E& noise)
        : c0_(p.coefficient[0]), c1_(p.coefficient[1]), c2_(p.coefficient[2]), c4_(p.coefficient[4]) {
        // The polynomial that is meant has its inflection elsewhere: w^2 is off by some d, no more than noise / c4.
        // What the polynomial does between the two places is at most c4 d^2, a 16th of the noise if c4 is 16 times as
        // large: the other half of the doubled noise is that. The slope's noise is no more than four times the value's,
        // since no power is above 4.
        noise_ = E(2) * noise;
        is_sound_ = p.coefficient[3] == W(0) && p.error[3] == E(0) && E(c4_) > E(16) * noise_;
    }
    RAIO_FN constexpr explicit depressed_quartic(const polynomial<W, 4>& p) : depressed_quartic(p, p.noise()(E(1))) {}

    /// The first root in [low, high]. Not known unless it is positive at both ends.
    RAIO_FN constexpr first_root<W> between(const W& low, const W& high) const {
        if (!is_sound_ || !(W(-1) <= low && high <= W(1))) return {};
        W square = c2_ / (c4_ * W(-6)), bend = sqrt(max(W(0), square));
        const place from = place_at(low), left = place_at(max(low, -bend)), right = place_at(min(high, bend)),
                    to = place_at(high);
        if (!(left.x <= right.x) || !is_positive(from) || !is_positive(to)) return {};
        if (is_negative(left)) return enclosed(from, left);
        if (!is_positive(left)) return {};
        const first_root<W> before = in_dip(from, left);
        if (!before.known || before.exists) return before;
        if (is_negative(right)) return enclosed(left, right);
        if (!is_positive(right)) return {};
        return in_dip(right, to);
    }

private:
    struct place {
        W x, value, slope;
    };

    [[gnu::always_inline]] RAIO_FN constexpr place place_at(const W& x) const {
        W square = x * x, leading = c4_ * square;
        return {x, ((leading + c2_) * square + c0_) + c1_ * x, W(2) * ((leading + leading) + c2_) * x + c1_};
    }
    RAIO_FN constexpr bool is_positive(const place& p) const { return E(p.value) > noise_; }
    RAIO_FN constexpr bool is_negative(const place& p) const { return E(p.value) < -noise_; }

    /// The first root between two places where the polynomial is positive and between which it is convex: none if the
    /// tangents there meet above zero. If they do not, it is where they meet that is asked next (Kelley, The
    /// Cutting-Plane Method, 1960).
    RAIO_FN constexpr first_root<W> in_dip(place from, place to) const {
        const W slack(E(4) * noise_);
        for (int i = 0; i < 16; ++i) {
            W down = max(-from.slope, W(0)) + slack, up = max(to.slope, W(0)) + slack;
            W x = from.x + ((from.value - to.value) + up * (to.x - from.x)) / (down + up);
            x = max(from.x, min(to.x, x));
            if (E(from.value - down * (x - from.x)) > noise_) return {true, false};
            const place lowest = place_at(x);
            if (is_negative(lowest)) return enclosed(from, lowest);
            if (!is_positive(lowest)) break;
            (lowest.slope < W(0) ? from : to) = lowest;
        }
        return {};
    }

    /// The root between a place above zero and one below. It is looked for first where the tangent above is zero: where
    /// the polynomial is convex, that is before the root, and what Halley's method makes of it is as well.
    RAIO_FN constexpr first_root<W> enclosed(const place& from, const place& to) const {
        const W on_tangent = from.x - quotient(from.value, from.slope, W(0));
        const bool within = from.x <= on_tangent && on_tangent <= to.x;
        return {true, true, from.x, to.x, within ? on_tangent : from.x + (to.x - from.x) * W(0.5)};
    }

    W c0_, c1_, c2_, c4_;
    E noise_;
    bool is_sound_;
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
