#pragma once

#include <raio/push_macros.hpp>

#include <algorithm>
#include <cmath>

#include <raio/config.hpp>

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

    /// Up to where the area from `from` on is such a part of that up to `to`. By Newton's method, halved where it would
    /// leave what encloses the place.
    RAIO_FN double place(double from, double to, double part) const {
        const double wanted = part * area(from, to);
        double low = from, high = to, x = from + (to - from) * part;
        for (int i = 0; i < 64; ++i) {
            const double over = area(from, x) - wanted, height = (*this)(x), last = x;
            if (over == 0) break;
            (over > 0 ? high : low) = x;
            const double next = height > 0 ? x - over / height : low;
            x = low < next && next < high ? next : low + (high - low) / 2;
            if (std::abs(x - last) <= 0x1p-52 * std::abs(x)) break;
        }
        return x;
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
