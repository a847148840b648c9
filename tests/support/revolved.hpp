#pragma once

#include "support/subject.hpp"

namespace raio::test {

/// What the tests know of a shape that is turned about the axis from its base to its top. Profile says of it:
///
///     ends(shape)           the two centres
///     radius(shape, h)      of the side at a height of 0 to 1
///     slope(shape, h)       how fast it changes there with h
///     heights(random)       a height where there is a side
template <class Shape, class Profile>
struct revolved_subject {
    using T = number_t<Shape>;

    struct axis_of {
        vec3<double> base, axis;
    };
    static axis_of axis(const Shape& s) {
        const auto [base, top] = Profile::ends(s);
        return {to_double(base), to_double(top) - to_double(base)};
    }
    /// A point at a height of 0 to 1 of the axis, so many radii from it.
    static vec3<double> at(const Shape& s, double height, double rho, random_numbers& random) {
        const axis_of a = axis(s);
        return a.base + a.axis * height + random.perpendicular(a.axis) * (rho * Profile::radius(s, height));
    }
    static vec3<double> inner_point(const Shape& s, random_numbers& random) {
        return at(s, Profile::height(s, random), solid<Shape> ? random.uniform(0, 0.99) : 1, random);
    }
    /// On a rim or at an apex, on the axis, on the side, along a generator, or where the side is a silhouette.
    static vec3<double> special_point(const Shape& s, const vec3<double>& from, random_numbers& random) {
        const double height = Profile::height(s, random);
        switch (random.integer(0, 3)) {
            case 0:
                return at(s, random.integer(0, 1), 1, random);
            case 1:
                return at(s, height, 0, random);
            case 2:
                return at(s, height, 1, random);
            default:
                break;
        }
        // The point with the unit vector e across the axis, and the normal e - slope up, where
        // normal.(from - point) = 0.
        const axis_of a = axis(s);
        const double size = length(a.axis), r = Profile::radius(s, height), slope = Profile::slope(s, height) / size;
        const vec3<double> up = a.axis * (1 / size), center = a.base + a.axis * height, view = from - center;
        const vec3<double> across = view - up * dot(view, up);
        const double distance = length(across), cosine = (r + slope * dot(view, up)) / distance;
        if (!(std::abs(cosine) < 1)) return center;
        const vec3<double> x = across * (1 / distance), y = cross(up, x);
        return center + (x * cosine + y * std::sqrt(1 - cosine * cosine)) * r;
    }
    struct cylindrical {
        oracle rho, height, size;
        oracle beyond_caps() const { return size * max(oracle(-height), oracle(height - 1)); }
    };
    static cylindrical coordinates(const vec3<oracle>& base, const vec3<oracle>& top, const vec3<oracle>& p) {
        const vec3<oracle> axis = top - base, from_base = p - base;
        const oracle size = length(axis);
        return {length(cross(from_base, axis)) / size, dot(from_base, axis) / (size * size), size};
    }
};

}  // namespace raio::test
