#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/formula/edges.hpp>
#include <raio/surface_sample.hpp>

namespace raio::inline RAIO_ABI {

/// The flat triangle a, b, c, whose front is the side from which its corners run counter-clockwise.
///
/// A line crosses its plane at a + u (b - a) + v (c - a): formula/edges.hpp finds u, v and t.
///
/// The point is inside where u, v and 1 - u - v are not negative. Their signs are exact, so neighbours never disagree
/// about a ray near their edge, and no ray slips between them. There is no tolerance on det: a triangle may be as small
/// as it likes.
///
/// uv: the barycentric coordinates of b and c.
template <real T>
struct triangle {
    using number = T;

    vec3<T> a, b, c;

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr aabb<T> bounds() const { return unless_nan(padded(corners()), a, b, c); }

    RAIO_FN constexpr T area() const { return T(0.5) * length(cross(b - a, c - a)); }

    /// A square folded to a triangle by its root (Turk, Graphics Gems, 1990).
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const {
        const T root = sqrt(u.x);
        return {a + (b - a) * (root * (T(1) - u.y)) + (c - a) * (root * u.y), normalize(cross(b - a, c - a))};
    }

    template <class Line, class Wanted = every_crossing>
    RAIO_FORMULA constexpr crossing<typename Line::number> crossings(const Line& line,
                                                                     const Wanted& wanted = {}) const {
        const auto far = [](const auto& u, const auto& v) { return u + v; };
        return cross_edges(line, a, line.between(a, b), line.between(a, c), far, wanted);
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        const auto edge = [this]<class V>(const V&, int i) { return difference_as<V>(i == 0 ? b : c, a); };
        flat_surface(at, corners(), edge);
        at.record_uv([&] {
            const T u = max(T(0), min(T(1), T(at.crossing().u)));
            return vec2<T>(u, max(T(0), min(T(1) - u, T(at.crossing().v))));
        });
    }

private:
    RAIO_FN constexpr aabb<T> corners() const { return hull_of_numbers(hull_of_numbers(aabb<T>{a, a}, b), c); }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
