#pragma once

#include <raio/shape/quadric.hpp>

#include "support/algebraics.hpp"

namespace raio::test {

template <class T, bool Closed>
inline constexpr bool is_flat<quadric<T, Closed>> = false;
template <class T, bool Closed>
inline constexpr bool is_convex<quadric<T, Closed>> = false;

template <class T, bool Closed>
struct subject<quadric<T, Closed>> : boxed_subject<quadric<T, Closed>> {
    using shape = quadric<T, Closed>;

    static auto fields(auto& s) { return std::tie(s.min, s.max, s.squares, s.products, s.linear, s.constant); }

    /// About the origin, which is inside: of full rank or of less, with and without an axis along one of the box's.
    static shape random(random_numbers& random, double size, const vec3<double>&) {
        shape s{vec3<T>(0), vec3<T>(0)};
        for_each_number(s.min, [&](T& x) { x = static_cast<T>(-size * random.uniform(0.3, 1)); });
        for_each_number(s.max, [&](T& x) { x = static_cast<T>(size * random.uniform(0.3, 1)); });
        const auto some = [&](double unit) {
            return static_cast<T>(random.one_in(3) ? 0 : unit * random.uniform(-1, 1));
        };
        for_each_number(s.squares, [&](T& x) { x = some(1 / size); });
        if (random.one_in(2)) for_each_number(s.products, [&](T& x) { x = some(1 / size); });
        if (random.one_in(2)) for_each_number(s.linear, [&](T& x) { x = some(1); });
        s.constant = static_cast<T>(-size * random.log_uniform(0.001, 0.3));
        const bool reaches_corner = s.template value<double>(to_double(s.max)) < 0;
        return !Closed && reaches_corner ? subject::random(random, size, vec3<double>(0)) : s;
    }
    /// In a larger box, and by less than that wider: what meets a rim meets the surface then. A tangent is moved by the
    /// root of how much wider.
    static auto grown(const auto& s) { return grown_by(s, oracle(1e-55)); }
    /// What touches the surface alone from within meets it, then.
    static auto grown_inwards(const auto& s) requires(!Closed) { return grown_by(s, oracle(-1e-55)); }
    static auto grown_by(auto s, const oracle& part) {
        const vec3<oracle> size = s.max - s.min;
        if (!(size.x > 0 && size.y > 0 && size.z > 0)) return s;  // it is missed, and remains so
        const oracle more = norm1(size) * oracle(1e-21), far = norm1(s.min) + norm1(s.max);
        s.min -= vec3<oracle>(more), s.max += vec3<oracle>(more);
        const oracle terms = (norm1(s.squares) + norm1(s.products)) * far * far + norm1(s.linear) * far;
        s.constant -= (terms + abs(s.constant)) * part;
        return s;
    }
};

}  // namespace raio::test
