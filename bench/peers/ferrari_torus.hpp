#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <raio/shape/torus.hpp>

#include "peers/record.hpp"

namespace peers {

/// The torus of the textbooks: the quartic along the ray by Ferrari's closed form, the resolvent cubic by Cardano's.
template <class T>
struct ferrari_torus {
    static constexpr const char* name = "ferrari";
    using result = record<T>;

    raio::vec3<T> center, axis;  ///< the axis as a unit vector
    T major, minor;

    explicit ferrari_torus(const raio::torus<T>& shape)
        : center(shape.center),
          axis(raio::normalize(shape.axis)),
          major(shape.major_radius),
          minor(shape.minor_radius) {}

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        const raio::vec3<T> o = ray.origin - center, d = ray.direction;
        const T d2 = raio::dot(d, d), od = raio::dot(o, d), da = raio::dot(d, axis), oa = raio::dot(o, axis);
        const T k = raio::dot(o, o) + major * major - minor * minor, r4 = 4 * major * major, a = d2 * d2;
        std::array<T, 4> roots;
        const int count =
            quartic(4 * d2 * od / a, (2 * d2 * k + 4 * od * od - r4 * (d2 - da * da)) / a,
                    (4 * od * k - 2 * r4 * (od - oa * da)) / a, (k * k - r4 * (raio::dot(o, o) - oa * oa)) / a, roots);
        T nearest = t_max;
        bool found = false;
        for (int i = 0; i < count; ++i) {
            const T t = roots[static_cast<std::size_t>(i)];
            if (t < t_min || t > nearest) continue;
            nearest = t;
            found = true;
        }
        if (!found) return false;
        rec.t = nearest;
        rec.point = ray.origin + d * nearest;
        const raio::vec3<T> p = rec.point - center, across = p - axis * raio::dot(p, axis);
        rec.face(ray, (p - across * (major / raio::length(across))) / minor);
        return true;
    }

private:
    /// The real roots of t^4 + b t^3 + c t^2 + d t + e.
    static int quartic(T b, T c, T d, T e, std::array<T, 4>& roots) {
        const T b2 = b * b, p = c - T(3) / 8 * b2, q = d - b * c / 2 + b2 * b / 8;
        const T r = e - b * d / 4 + b2 * c / 16 - T(3) / 256 * b2 * b2, shift = -b / 4;
        int count = 0;
        const auto pair = [&](T middle, T square) {
            if (square < T(0)) return;
            const T root = std::sqrt(square);
            roots[static_cast<std::size_t>(count++)] = shift + middle - root;
            roots[static_cast<std::size_t>(count++)] = shift + middle + root;
        };
        // (t^2 + y)^2 = (2 y - p) t^2 - q t + y^2 - r, a square if y is a root of the resolvent.
        const T y = largest_of_cubic(-p / 2, -r, p * r / 2 - q * q / 8), w2 = 2 * y - p;
        if (w2 > T(1e-6)) {
            const T w = std::sqrt(w2), z = q / (2 * w);
            pair(w / 2, w2 / 4 - y - z);
            pair(-w / 2, w2 / 4 - y + z);
        } else {  // biquadratic
            const T inner = p * p / 4 - r;
            if (inner < T(0)) return 0;
            for (const T square : {-p / 2 - std::sqrt(inner), -p / 2 + std::sqrt(inner)}) pair(T(0), square);
        }
        return count;
    }

    /// The largest real root of y^3 + b y^2 + c y + d.
    static T largest_of_cubic(T b, T c, T d) {
        const T q = (b * b - 3 * c) / 9, r = (2 * b * b * b - 9 * b * c + 27 * d) / 54;
        if (r * r < q * q * q) {
            const T angle = std::acos(r / std::sqrt(q * q * q)), m = -2 * std::sqrt(q);
            return std::max({m * std::cos(angle / 3), m * std::cos((angle + T(6.2831853)) / 3),
                             m * std::cos((angle - T(6.2831853)) / 3)}) -
                   b / 3;
        }
        const T s = -std::copysign(std::cbrt(std::abs(r) + std::sqrt(r * r - q * q * q)), r);
        return s + (s == T(0) ? T(0) : q / s) - b / 3;
    }
};

}  // namespace peers
