#pragma once

#include <raio/push_macros.hpp>

#include <raio/proof/polynomial_crossings.hpp>

/// \file
/// Where a line goes into what a sphere sweeps whose centre and radius are cubics, and out of it.

namespace raio::inline RAIO_ABI::detail {

/// A polynomial and its derivative.
template <real W, std::size_t N>
struct differentiated {
    polynomial<W, N> value;
    polynomial<W, N - 1> slope = value.derivative();
};

/// b - sqrt(s) and b + sqrt(s), where one of them has an extremum at u, or u is known exactly: at an extremum a
/// function changes no faster than with the square of what the place is off by.
/// \param minus_s  -s; where s is below zero, or may be, its root counts as zero
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

/// b and s along the curve, for a part of the line (see shape/bezier_curve.hpp, where b, s and d are defined).
template <class W>
struct sweep {
    bounded_number<W> d2;  ///< d.d
    differentiated<W, 3> b;
    differentiated<W, 6> minus_s;

    /// From the least t of a stretch of the curve to the greatest.
    RAIO_FN constexpr chord<W> extent(const line_part<W>& part, const stretch<W>& where) const {
        if (where.may_be_point()) return at(part, where.point());
        chord<W> c = unite(at(part, where.from), at(part, where.to));
        const auto turns = minus_s.value * square(b.slope + b.slope) + square(minus_s.slope);  // s'^2 - 4 s b'^2
        for (const polynomial_root<W>& root : roots_between(turns, where.from.value, where.to.value)) {
            c = unite(c, at(part, root.place()));
        }
        return c;
    }

    /// Where the line goes into the sphere of u, and out of it: at the least t of all about it, and the greatest.
    RAIO_FN constexpr chord<W> at(const line_part<W>& part, const bounded_number<W>& u) const {
        const auto [near, far] = extremes_near(b, minus_s, u);
        return {located(part.at(root_at(near / d2), true), u), located(part.at(root_at(far / d2), false), u)};
    }
};

/// The chords of one line through parts of a solid, in the order in which it enters them.
template <class W, std::size_t N>
struct chord_list {
    std::array<chord<W>, N> chords{};  ///< what is beyond `count` has no value
    std::size_t count = 0;

    RAIO_FN constexpr void insert(const chord<W>& c) {
        std::size_t i = count++;
        for (; i > 0 && c.near.t < chords[i - 1].near.t; --i) chords[i] = chords[i - 1];
        chords[i] = c;
    }

    /// Puts their crossings into a list. Parts may overlap: what cannot be told from touching does.
    /// \param beyond  of parts that may be shorter than they are found: what is farther away than that from t = 0 does
    ///                not start on them
    template <std::size_t M>
    RAIO_FN constexpr void unite_into(crossing_list<W, M>& list, const W& beyond) const {
        for (std::size_t i = 0; i < count;) {
            chord<W> both = chords[i];
            for (++i; i < count; ++i) {
                const chord<W>& next = chords[i];
                const auto apart =
                    bounded_number<W>(next.near.t, next.near.error) > bounded_number<W>(both.far.t, both.far.error);
                list.depends_on(apart);
                if (answer_of<W>(apart)) break;
                both = unite(both, next);
            }
            if (max(both.near.t, -both.far.t) < beyond) {
                start_at_origin(both.near, true);
                start_at_origin(both.far, true);
            }
            list.append(both);
        }
    }
};

}  // namespace raio::inline RAIO_ABI::detail

#include <raio/pop_macros.hpp>
