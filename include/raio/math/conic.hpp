#pragma once

#include <raio/push_macros.hpp>

#include <algorithm>
#include <cmath>

#include <raio/math/newton.hpp>

namespace raio::inline RAIO_ABI {

/// The upper half of a conic about the origin: y = sqrt(constant + square x^2), where that is a number. What areas of
/// surfaces of revolution are made of; to the precision of double, which is enough for them.
struct conic {
    double constant, square;

    RAIO_FN double operator()(double x) const { return std::sqrt(std::max(constant + square * x * x, 0.0)); }

    /// The area below it, 0 <= from <= to: half of x y + constant times the integral of 1 / y, without the difference
    /// of what is nearly the same at both ends.
    RAIO_FN double area(double from, double to) const {
        if (!(from < to)) return 0;
        const double at_from = (*this)(from), at_to = (*this)(to), ends = to * at_to + from * at_from;
        const double squares = (to - from) * (to + from);
        double twice = ends > 0 ? squares * (constant + square * (to * to + from * from)) / ends : 0;
        if (constant == 0) return twice / 2;
        const double root = std::sqrt(std::abs(square));
        if (square > 0) {
            const double rise = root * (to - from) + square * squares / (at_to + at_from);
            twice += constant / root * std::log1p(rise / (root * from + at_from));
        } else if (square < 0) {
            twice += constant / root * (std::atan2(root * to, at_to) - std::atan2(root * from, at_from));
        } else {
            twice += constant * (to - from) / at_to;
        }
        return twice / 2;
    }

    /// Up to where the area from `from` on is such a part of that up to `to`.
    RAIO_FN double place(double from, double to, double part) const {
        const double wanted = part * area(from, to);
        return newton_between(
            from, to, from + (to - from) * part, [&](double x) { return area(from, x) - wanted; }, *this);
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
