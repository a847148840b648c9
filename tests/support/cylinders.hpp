#pragma once

#include "support/subject.hpp"

namespace raio::test {

/// What the tests know of both cylinders.
template <class Cylinder>
struct cylinder_subject {
    using T = number_t<Cylinder>;

    static auto fields(auto& s) { return std::tie(s.base, s.top, s.radius); }

    static Cylinder random(random_numbers& random, double size, const vec3<double>& place) {
        const vec3<double> axis = random.axis() * (size * random.log_uniform(0.01, 10));
        return {vec3<T>(place), vec3<T>(place + axis), static_cast<T>(size * random.log_uniform(0.1, 1))};
    }
    /// A point at a height of 0 to 1 of the axis, so many radii from it.
    static vec3<double> at(const Cylinder& s, double height, double rho, random_numbers& random) {
        const vec3<double> axis = to_double(s.top) - to_double(s.base);
        return to_double(s.base) + axis * height + random.perpendicular(axis) * (rho * static_cast<double>(s.radius));
    }
    /// On a rim, on the axis, on the side, or where the side is a silhouette.
    static vec3<double> special_point(const Cylinder& s, const vec3<double>& from, random_numbers& random) {
        const double height = random.uniform();
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
        const vec3<double> axis = to_double(s.top) - to_double(s.base);
        const vec3<double> center = to_double(s.base) + axis * height;
        const vec3<double> across = normalize(cross(axis, cross(axis, from - center)));  // away from the eye
        const double r = static_cast<double>(s.radius), sine = -r / dot(across, from - center);
        if (sine > 1) return center;
        return center - across * (r * sine) + normalize(cross(axis, across)) * (r * std::sqrt(1 - sine * sine));
    }
    struct cylindrical {
        oracle beyond_side, beyond_caps;  ///< negative inside
    };
    static cylindrical coordinates(const auto& s, const vec3<oracle>& p) {
        const vec3<oracle> axis = s.top - s.base, from_base = p - s.base;
        const oracle size = length(axis), height = dot(from_base, axis) / size;
        return {length(cross(from_base, axis)) / size - s.radius, max(oracle(-height), oracle(height - size))};
    }
    static auto grown(auto s) {
        const vec3<oracle> more = (s.top - s.base) * oracle(1e-21);
        s.base -= more;
        s.top += more;
        s.radius *= 1 + oracle(1e-50);
        return s;
    }
};

template <class T>
struct subject<cylinder<T>> : cylinder_subject<cylinder<T>> {
    using cylinder_subject<cylinder<T>>::at;

    static vec3<double> inner_point(const cylinder<T>& s, random_numbers& random) {
        return at(s, random.uniform(0.01, 0.99), random.uniform(0, 0.99), random);
    }
    static oracle distance(const cylinder<oracle>& s, const vec3<oracle>& p) {
        const auto [side, caps] = cylinder_subject<cylinder<T>>::coordinates(s, p);
        return max(side, caps);
    }
};

template <class T>
struct subject<open_cylinder<T>> : cylinder_subject<open_cylinder<T>> {
    using cylinder_subject<open_cylinder<T>>::at;

    static vec3<double> inner_point(const open_cylinder<T>& s, random_numbers& random) {
        return at(s, random.uniform(0.01, 0.99), 1, random);
    }
    static oracle distance(const open_cylinder<oracle>& s, const vec3<oracle>& p) {
        const auto [side, caps] = cylinder_subject<open_cylinder<T>>::coordinates(s, p);
        return max(oracle(abs(side)), caps);
    }
};

}  // namespace raio::test
