#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/polynomial.hpp>

/// \file
/// How the roots of a polynomial in an interval are found: all of them, in order, and how far each may be off.
///
/// Between two neighbouring roots of its derivative a polynomial rises or falls all the way: if its sign changes there,
/// it has one root, and none if not. The derivative's roots are found in the same way, down to degree 1. A root that is
/// enclosed like this is approached by Halley's method, and by bisection where that would leave the enclosure. (A
/// closed form loses roots to rounding, and no polish brings back what is lost.)
///
/// Every sign is compared with what rounding can have done to it. A root of the derivative where the polynomial cannot
/// be told from zero is an extremum that may touch zero, or cut it twice: it is reported as a root whose signs before
/// and after are the same.

namespace raio::inline RAIO_ABI {

/// A place where a polynomial is zero, or cannot be told from it.
template <real W>
struct polynomial_root {
    W t;
    bound_t<W> error;             ///< bound of |t - root|, for every root that is meant
    int sign_before, sign_after;  ///< of the polynomial to both sides; 0 beyond an end of the interval
    bound_t<W> height;  ///< of another one's turn: bound of this one's magnitude from t to each root that is meant

    RAIO_FN constexpr bounded_number<W> place() const { return {t, error}; }
    /// Does the polynomial change its sign there?
    RAIO_FN constexpr bool is_simple() const { return sign_before * sign_after < 0; }
    /// Is the polynomial zero there without changing its sign?
    RAIO_FN constexpr bool is_touched() const { return sign_before * sign_after > 0; }
    /// Does what is negative begin there, or is it touched from outside?
    RAIO_FN constexpr bool is_entered() const { return sign_before > 0 || (sign_before == 0 && sign_after < 0); }
    /// The same root of -p.
    RAIO_FN constexpr polynomial_root operator-() const { return {t, error, -sign_before, -sign_after, height}; }
};

/// A place that is as good as a root, whatever the signs are.
template <real W>
RAIO_FN constexpr polynomial_root<W> root_at(const bounded_number<W>& place) {
    return {place.value, place.error, 0, 0, bound_t<W>(0)};
}

namespace detail {

/// Where a root is known to be before it is approached.
template <real W>
struct enclosure {
    W low, high;
    int sign_before, sign_after;  ///< of the polynomial there
    bool is_one;                  ///< is there one simple root for certain?
};

/// How far t is from the farther of the ends that it lies between, rounded up (the distance takes three roundings): a
/// root may lie right beside that end.
template <real W>
RAIO_FN constexpr bound_t<W> farthest_from(const W& t, const W& low, const W& high) {
    using E = bound_t<W>;
    return E(max(high - t, t - low)) * E(1 + 4 * unit_roundoff<E>);
}

/// How much of a step of Halley's method it may have missed the root by, if that is no longer than `tolerance` of t: as
/// much of it as the square of that, or a few roundings of the slope.
template <real E>
RAIO_FN constexpr E left_of_step(const E& tolerance) {
    return max(tolerance * tolerance, E(4 * unit_roundoff<E>));
}

/// The last step after which t is known to some 32 roundings of W.
template <real W>
inline constexpr double last_step = [] {
    double step = 1;
    while (step * left_of_step<double>(step) > 32 * unit_roundoff<W>) step /= 2;
    return step;
}();

/// Finds the roots of one polynomial in [low, high].
template <real W, std::size_t N>
class root_finder {
public:
    using E = bound_t<W>;

    /// \param p  has to live as long
    RAIO_FN constexpr root_finder(const polynomial<W, N>& p, const W& low, const W& high)
        : p_(p),
          noise_(p.noise()),
          most_noise_(noise_(max(E(1), max(E(abs(low)), E(abs(high)))))),
          low_(low),
          high_(high) {}

    /// Can the polynomial be evaluated everywhere in the interval?
    RAIO_FN constexpr bool is_sound() const { return low_ < high_ && is_finite(most_noise_ * E(1 / unit_roundoff<W>)); }

    /// The polynomial's noise anywhere in the interval, and from -1 to 1.
    RAIO_FN constexpr const E& most_noise() const { return most_noise_; }

    /// Calls `take` with one enclosure after the other, in order, and with a function that finds the root in there, as
    /// long as it answers true; answers whether it did to the end.
    ///
    /// \param tolerance  of the last step, relative to t
    /// \param between    the same for the roots of the derivatives, which need only be told from those of the
    /// polynomial
    /// \tparam Turns  are the roots another polynomial's turns, of which also `height` is needed?
    template <bool Turns = false, class Take>
    RAIO_FN constexpr bool find(const E& tolerance, const E& between, Take take) const {
        if constexpr (N == 2) {
            pair_of_roots two;
            if (solve(two)) {
                for (std::size_t i = 0; i < two.count; ++i) {
                    const polynomial_root<W>& root = two.places[i];
                    if (!take({root.t, root.t, root.sign_before, root.sign_after, true}, [&] { return root; }))
                        return false;
                }
                return true;
            }
        }
        sample before{low_, E(0), 0, E(0)}, first{}, last{};  // with a sign; first and last without one
        bool is_open = false;
        E highest(0);  // of those without
        const auto take_extremum = [&](const sample& after) {
            return take({first.t, last.t, before.sign, after.sign, false},
                        [&] { return extremum(before, first, last, after, highest); });
        };
        const auto reach = [&](const sample& next) {
            if (next.sign == 0) {
                if (!is_open) first = next, highest = E(0);
                last = next, is_open = true, highest = max(highest, next.height);
                return true;
            }
            bool goes_on = true;
            if (is_open) {
                goes_on = take_extremum(next);
            } else if (before.sign * next.sign < 0) {
                goes_on = take({before.t, next.t, before.sign, next.sign, true},
                               [&] { return enclosed(before, next, guess(before.t, next.t), tolerance); });
            }
            before = next, is_open = false;
            return goes_on;
        };
        if (!reach(sample_at(low_, E(0), E(0)))) return false;
        if constexpr (N > 1) {
            const auto turn = [&](const enclosure<W>& about, auto approached) {
                if (!Turns && about.is_one && about.low < about.high && !is_open) {
                    // If the sign has changed here, the turn itself need not be found: there is one root so far, and
                    // from here on to the next turn there is one or none, as the signs say.
                    const sample nearly = sample_at(about.low + (about.high - about.low) * W(0.5), E(0), E(0));
                    if (before.sign * nearly.sign < 0) return reach(nearly);
                }
                const polynomial_root<W> at = approached();
                return reach(sample_at(at.t, at.error, at.height));
            };
            const polynomial<W, N - 1> slope = p_.derivative();
            if (!root_finder<W, N - 1>(slope, low_, high_).template find<true>(between, between, turn)) return false;
        }
        return reach(sample_at(high_, E(0), E(0))) && (!is_open || take_extremum({high_, E(0), 0, E(0)}));
    }

    /// The one root that is enclosed there.
    /// \param guess  where to look first
    RAIO_FN constexpr polynomial_root<W> approach(const enclosure<W>& about, const W& guess, const E& tolerance) const {
        return enclosed({about.low, E(0), about.sign_before, E(0)}, {about.high, E(0), about.sign_after, E(0)}, guess,
                        tolerance);
    }

private:
    struct pair_of_roots {
        std::array<polynomial_root<W>, 2> places;
        std::size_t count = 0;
    };

    /// The polynomial at one place.
    struct sample {
        W t;
        E reach;   ///< how far the extremum that is meant may be from t
        int sign;  ///< 0 if rounding errors leave it open
        E height;  ///< bound of the extremum's magnitude
    };

    RAIO_FN static constexpr int sign_beyond(const W& value, const E& error) {
        return (E(value) > error ? 1 : 0) - (E(value) < -error ? 1 : 0);
    }
    RAIO_FN constexpr E noise_at(const W& t) const { return noise_(E(abs(t))); }
    RAIO_FN constexpr int sign_at(const W& t) const { return sign_beyond(p_(t), noise_at(t)); }

    /// Has the polynomial beyond doubt the sign at t that it has in the sample, or any, if it has none there?
    RAIO_FN constexpr bool has_sign_of(const sample& s, const W& t) const {
        const int sign = sign_at(t);
        return s.sign == 0 ? sign != 0 : sign == s.sign;
    }

    /// \param slope  bound of the derivative's magnitude within `reach` of t
    [[gnu::always_inline]] RAIO_FN constexpr sample sample_at(const W& t, const E& reach, const E& slope) const {
        W value = p_(t);
        E error = noise_(E(abs(t)) + reach) + reach * slope;
        return {t, reach, sign_beyond(value, error), E(abs(value)) + error};
    }

    /// The closed form of degree 2 loses no root where the sign of its discriminant is not in doubt. False if it is, or
    /// if a root may be on an end.
    RAIO_FN constexpr bool solve(pair_of_roots& found) const requires(N == 2) {
        const auto& c = p_.coefficient;
        const auto& off = noise_.coefficient;
        W half = c[1] * W(-0.5), square = half * half - c[2] * c[0];
        E square_error = off[1] * (abs(E(half)) + off[1]) + off[0] * abs(E(c[2])) + off[2] * (abs(E(c[0])) + off[0]) +
                         E(least_normal<W>);
        if (E(square) < -square_error) return true;
        if (!(E(square) > E(4) * square_error && abs(E(c[2])) > E(2) * off[2])) return false;
        W root = sqrt(square), q = half + copysign(root, half), one = q / c[2], other = c[0] / q;
        // With the roots r and r' of the polynomial that is meant, its value at t is c2 (t - r) (t - r'). The farther
        // one is at least half of their distance away, which is 2 root / |c2|: so |t - r| is at most |value| / root.
        // The square under that root is right to a quarter, and 1.25 > 1 / sqrt(3/4). Nothing in reach of t is farther
        // than the two are apart, twice; with |c2| right to a half, the value there is no more than 10 times that at t.
        E over_root = E(1.25) / E(root), low(low_), high(high_), last = -infinity<E>;
        const int outside = c[2] > W(0) ? 1 : -1;
        for (const bool second : {false, true}) {
            W t = second ? max(one, other) : min(one, other);
            E value = E(abs(p_(t))) + noise_at(t), reach = value * over_root, from = E(t) - reach, to = E(t) + reach;
            const bool within = low < from && to < high, beyond = to < low || high < from;
            if (!(last < from) || !(within || beyond)) {
                found.count = 0;
                return false;
            }
            last = to;
            const int before = second ? -outside : outside;
            if (within) found.places[found.count++] = {t, reach, before, -before, E(12) * value};
        }
        return true;
    }

    /// The distance of the next numbers from t; more than nothing at 0 as well.
    RAIO_FN constexpr E resolution(const W& t) const {
        E u(2 * unit_roundoff<W>);
        return u * (E(abs(t)) + u * E(high_ - low_));
    }

    /// Its coefficients, in the precision of bounds.
    RAIO_FN constexpr polynomial<E, N> roughly() const {
        polynomial<E, N> rough;
        for (std::size_t k = 0; k <= N; ++k) rough.coefficient[k] = E(p_.coefficient[k]);
        return rough;
    }

    /// A place between a and b for the first look at the one root there.
    RAIO_FN constexpr W guess(const W& a, const W& b) const {
        W middle = a + (b - a) * W(0.5);
        if constexpr (N == 1) {
            return quotient(-p_.coefficient[0], p_.coefficient[1], middle);
        } else {
            return middle;
        }
    }

    /// The one root between two samples of different signs, which is looked for at t first.
    RAIO_FN constexpr polynomial_root<W> enclosed(const sample& from, const sample& to, W t, const E& tolerance) const {
        // The end that t takes the place of is as good as random: chosen by an index it is not guessed by the
        // processor.
        std::array<W, 2> ends{from.t, to.t};
        const auto slope_at = roughly().derivative();
        const auto curvature_at = slope_at.derivative();
        E slope(0), step = E(to.t - from.t);
        for (int i = 0; i < 256; ++i) {
            W value = p_(t);
            E x(t), bend = E(0.5) * curvature_at(x);
            slope = slope_at(x);
            ends[(value > W(0)) == (to.sign > 0) ? 1 : 0] = t;
            E height(value), off = quotient(height * slope, slope * slope - height * bend, E(infinity<E>));
            W next = t - W(off);
            E last_step = step;
            step = abs(off);
            // (At a root of any order |f f''| / 2 is at most half of f'^2. Where it is more than twice that, the slope
            // is all but zero and the value is not: a short step says nothing. Nor does one of squares that are lost.)
            const bool good = every(ends[0] <= next, next <= ends[1], step <= E(0.5) * last_step,
                                    abs(height * bend) <= slope * slope, slope * slope >= E(least_normal<W>));
            t = good ? next : ends[0] + (ends[1] - ends[0]) * W(0.5);
            if (!good) step = E(abs(ends[1] - ends[0]));
            if (!(step > (good ? tolerance : E(unit_roundoff<W>)) * E(abs(t)))) break;
        }

        // The root lies where the sign changes beyond doubt. It is looked for from as near as the slope says on, or
        // from next to t, if that is no longer a small part of the interval: of a root of a higher order the slope,
        // which is all but zero there, would have it anywhere.
        E by_slope = quotient(E(4) * noise_at(t), abs(slope), step);
        const E beside = step * left_of_step(tolerance) + resolution(t);
        if constexpr (is_believed<W>) {  // not enclosed: the error is what the slope makes of the noise
            const E error = min(by_slope, E(to.t - from.t)) + beside;
            return {t, error, from.sign, to.sign, abs(slope) * error + noise_at(t)};
        }
        E reach = (by_slope < E(0x1p-10) * E(to.t - from.t) ? by_slope : E(0)) + beside;
        for (;;) {
            W left = max(from.t, t - W(reach)), right = min(to.t, t + W(reach)), at_left = p_(left),
              at_right = p_(right);
            E noise = noise_(E(abs(t)) + reach);
            const bool left_clear = !(from.t < left) || sign_beyond(at_left, noise) == from.sign;
            const bool right_clear = !(right < to.t) || sign_beyond(at_right, noise) == to.sign;
            if (left_clear && right_clear) {
                return {t, farthest_from(t, left, right), from.sign, to.sign,
                        E(2) * (max(E(abs(at_left)), E(abs(at_right))) + noise)};
            }
            reach = reach * E(4);
        }
    }

    /// The root, or the roots, or none, about neighbouring samples that cannot be told from zero.
    /// \param highest  bound of these samples' magnitudes
    RAIO_FN constexpr polynomial_root<W> extremum(const sample& before, const sample& first, const sample& last,
                                                  const sample& after, const E& highest) const {
        W t = first.t + (last.t - first.t) * W(0.5);
        E reach = E(last.t - first.t) + first.reach + last.reach + resolution(t);
        for (;;) {
            W left = max(before.t, t - W(reach)), right = min(after.t, t + W(reach));
            const bool left_clear = !(before.t < left) || has_sign_of(before, left);
            const bool right_clear = !(right < after.t) || has_sign_of(after, right);
            if (left_clear && right_clear) {
                E ends = E(2) * (max(E(abs(p_(left))), E(abs(p_(right)))) + noise_(E(abs(t)) + reach));
                return {t, farthest_from(t, left, right), before.sign, after.sign, max(ends, highest)};
            }
            reach = reach * E(8);
        }
    }

    const polynomial<W, N>& p_;
    polynomial<E, N> noise_;
    E most_noise_;
    W low_, high_;
};

}  // namespace detail

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
