#pragma once

#include "support/subject.hpp"

namespace raio::test {

template <class T>
struct subject<sphere<T>> {
    static auto fields(auto& s) { return std::tie(s.center, s.radius); }

    static sphere<T> random(random_numbers&, double size, const vec3<double>& place) {
        return {vec3<T>(place), static_cast<T>(size)};
    }
    static vec3<double> inner_point(const sphere<T>& s, random_numbers& random) {
        return to_double(s.center) + random.direction() * (random.uniform(0, 0.99) * static_cast<double>(s.radius));
    }
    /// Where it touches its bounds or elsewhere on it, or on the circle that is the silhouette.
    static vec3<double> special_point(const sphere<T>& s, const vec3<double>& from, random_numbers& random) {
        const vec3<double> to_center = to_double(s.center) - from;
        const double r = static_cast<double>(s.radius), sine = r / length(to_center);
        if (random.one_in(4)) return to_double(s.center) + random.axis() * r;
        if (sine > 1) return to_double(s.center);
        return to_double(s.center) - to_center * (sine * sine) +
               random.perpendicular(to_center) * (r * std::sqrt(1 - sine * sine));
    }
    static oracle distance(const sphere<oracle>& s, const vec3<oracle>& p) {
        return length(vec3<oracle>(p - s.center)) - s.radius;
    }
};

}  // namespace raio::test
