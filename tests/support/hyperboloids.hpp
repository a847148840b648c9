#pragma once

#include <raio/shape/two_sheet_hyperboloid.hpp>

#include "support/revolved.hpp"
#include "support/sampling.hpp"

namespace raio::test {

/// rho^2 = constant + square (2 h - 1)^2.
template <class Number>
struct hyperboloid_equation {
    Number constant, square;
};
template <class Number>
auto equation(const auto& s) {
    const Number end2 = Number(s.end_radius) * Number(s.end_radius);
    if constexpr (requires { s.gap; }) {
        const Number gap2 = Number(s.gap) * Number(s.gap), scale = end2 / (1 - gap2);
        return hyperboloid_equation<Number>{-gap2 * scale, scale};
    } else {
        const Number waist2 = Number(s.waist_radius) * Number(s.waist_radius);
        return hyperboloid_equation<Number>{waist2, end2 - waist2};
    }
}

struct hyperboloid_profile {
    static auto ends(const auto& s) { return std::pair(s.base, s.top); }
    static double radius(const auto& s, double h) {
        const auto [constant, square] = equation<double>(s);
        return std::sqrt(std::max(constant + square * (2 * h - 1) * (2 * h - 1), 0.0));
    }
    static double slope(const auto& s, double h) { return 2 * equation<double>(s).square * (2 * h - 1) / radius(s, h); }
    /// Not in the gap.
    static double height(const auto& s, random_numbers& random) {
        double distance = random.uniform(0, 0.98);
        if constexpr (requires { s.gap; })
            distance = static_cast<double>(s.gap) * (1.001 - distance) + distance * 0.999;
        return random.one_in(2) ? 0.5 - 0.5 * distance : 0.5 + 0.5 * distance;
    }
};

/// What the tests know of all hyperboloids.
template <class Hyperboloid>
struct hyperboloid_subject : revolved_subject<Hyperboloid, hyperboloid_profile> {
    using T = number_t<Hyperboloid>;

    static auto fields(auto& s) {
        if constexpr (requires { s.gap; }) {
            return std::tie(s.base, s.top, s.gap, s.end_radius);
        } else {
            return std::tie(s.base, s.top, s.waist_radius, s.end_radius);
        }
    }

    /// Of those of one sheet, one in eight bulges.
    static Hyperboloid random(random_numbers& random, double size, const vec3<double>& place) {
        const vec3<double> axis = random.axis() * (size * random.log_uniform(0.01, 10));
        const double end = size * random.log_uniform(0.1, 1);
        double middle = random.log_uniform(0.03, 0.97);
        if constexpr (!requires(Hyperboloid s) { s.gap; }) middle = end * (random.one_in(8) ? 1 / middle : middle);
        return {vec3<T>(place), vec3<T>(place + axis), static_cast<T>(middle), static_cast<T>(end)};
    }
    static Hyperboloid lattice(random_numbers& random) {
        Hyperboloid s{{}, {}, T(random.integer(0, 3)), T(random.integer(0, 3))};
        if constexpr (requires { s.gap; }) s.gap = T(0.25) * s.gap;
        for_each_number(s.base, [&](T& x) { x = T(random.integer(-3, 3)); });
        for_each_number(s.top, [&](T& x) { x = T(random.integer(-3, 3)); });
        return s;
    }
    /// To the side, as its gradient tells near it, and to the planes of the caps, below 0 inside.
    static std::pair<oracle, oracle> distances(const auto& s, const vec3<oracle>& p) {
        const auto at = hyperboloid_subject::coordinates(s.base, s.top, p);
        const auto [constant, square] = equation<oracle>(s);
        const oracle y = 2 * at.height - 1, slope = 4 * square * y / at.size;
        const oracle gradient = sqrt(oracle(4 * at.rho * at.rho + slope * slope));
        // Where a bulging one meets its caps, the way inwards from one leads away from the other.
        const oracle obtuse = square < 0 ? oracle(1 + abs(slope) / gradient) : oracle(1);
        return {(at.rho * at.rho - constant - square * y * y) / gradient / obtuse, at.beyond_caps() / obtuse};
    }
    /// Longer along its profile, and by less than that wider: what meets a rim meets the side then.
    static auto grown(auto s) {
        const oracle more(1e-21), longer2 = (1 + 2 * more) * (1 + 2 * more), wider = 1 + oracle(4e-50);
        const auto [constant, square] = equation<oracle>(s);
        const vec3<oracle> axis = s.top - s.base;
        s.base -= axis * more;
        s.top += axis * more;
        const oracle end = sqrt(max(oracle(0), oracle(constant + square * longer2))) * wider;
        s.end_radius = s.end_radius < 0 ? -end : end;  // below zero it is missed, and remains so
        if constexpr (requires { s.gap; }) {
            s.gap /= sqrt(longer2) * wider;
        } else {
            s.waist_radius *= wider;
        }
        return s;
    }
    static oracle distance(const auto& s, const vec3<oracle>& p) {
        const auto [side, caps] = distances(s, p);
        return solid<Hyperboloid> ? oracle(max(side, caps)) : oracle(-max(side, caps));  // away from the rims as well
    }
};

template <class T>
struct subject<hyperboloid<T>> : hyperboloid_subject<hyperboloid<T>> {};
template <class T>
struct subject<open_hyperboloid<T>> : hyperboloid_subject<open_hyperboloid<T>> {};
template <class T>
struct subject<two_sheet_hyperboloid<T>> : hyperboloid_subject<two_sheet_hyperboloid<T>> {};
template <class T>
struct subject<open_two_sheet_hyperboloid<T>> : hyperboloid_subject<open_two_sheet_hyperboloid<T>> {};

/// The area of the side below a height, by the rule of the middle, of small truncated cones.
double area_below(const auto& s, double height) {
    constexpr int steps = 20'000;
    const vec3<double> axis = converted<double>(s.top) - converted<double>(s.base);
    const double size = std::sqrt(dot(axis, axis));
    double area = 0;
    for (int i = 0; i < steps; ++i) {
        const double from = height * i / steps, to = height * (i + 1) / steps;
        const double low = hyperboloid_profile::radius(s, from), high = hyperboloid_profile::radius(s, to);
        area += std::numbers::pi * (low + high) * std::hypot(high - low, low + high > 0 ? (to - from) * size : 0);
    }
    return area;
}

template <class T>
void check_area(const auto& open, const auto& closed) {
    const double side = area_below(open, 1), cap = std::numbers::pi * double(open.end_radius) * double(open.end_radius);
    CHECK(double(open.area()) == doctest::Approx(side).epsilon(1e-3));
    CHECK(double(closed.area()) == doctest::Approx(side + 2 * cap).epsilon(1e-3));
}

/// Of hyperboloids about the z axis, or beside it.
template <class T>
void check_samples(const auto& open, const auto& closed) {
    constexpr int steps = 512;
    std::vector<double> below(steps + 1);
    for (int i = 0; i <= steps; ++i) below[std::size_t(i)] = area_below(open, double(i) / steps);
    const double side = below.back(), cap = std::numbers::pi * double(open.end_radius) * double(open.end_radius);
    const auto part = [&](T height) {
        const double at = std::clamp(double(height), 0.0, 1.0) * steps;
        const auto i = std::min(static_cast<std::size_t>(at), std::size_t{steps - 1});
        return (below[i] + (below[i + 1] - below[i]) * (at - double(i))) / side;
    };
    check_sampling(open, [&](const hit_record<T>& rec) { return vec2<T>(rec.uv.x, T(part(rec.uv.y))); });
    check_sampling(closed, [&](const hit_record<T>& rec) {
        const double ring = double(rec.uv.y) * double(rec.uv.y) * cap;
        const bool on_base = rec.point.z == closed.base.z, on_top = rec.point.z == closed.top.z;
        const double area = on_base ? side + ring : on_top ? side + cap + ring : part(rec.uv.y) * side;
        return vec2<T>(rec.uv.x, T(area / (side + 2 * cap)));
    });
}

}  // namespace raio::test
