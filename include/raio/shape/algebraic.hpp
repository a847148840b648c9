#pragma once

#include <raio/push_macros.hpp>

#include <array>
#include <vector>

#include <raio/proof/polynomial_crossings.hpp>
#include <raio/shape/box.hpp>

namespace raio::inline RAIO_ABI {

/// coefficient * x^x y^y z^z: `{3, 2, 0, 1}` is 3 x^2 z.
template <real T>
struct algebraic_term {
    T coefficient;
    unsigned x, y, z;  ///< the powers
};

/// The points of a box at which f, the sum of the terms, is zero or below: a solid that the faces of the box close, or,
/// if it is not `Closed`, only the surface f = 0 as far as it lies in the box.
///
/// Along a line f is a polynomial, whose roots are found one between each two roots of its derivative (as in Hanrahan,
/// SIGGRAPH 1983, who isolates them by Descartes' rule). Where the gradient of f vanishes, at a tip or where sheets
/// cross, the normal is against the ray.
///
/// x, y and z are those of the point itself: write the surface about the origin and move it by `transformed`, or the
/// terms cancel. uv: x and y of the point, from 0 at `min` to 1 at `max`; on the faces of the box as those of `box`.
/// \tparam Degree  the highest degree of a term, counted in all three; a surface with one of a higher degree is missed
/// \tparam Terms   any contiguous range
template <real T, std::size_t Degree, bool Closed = true, class Terms = std::vector<algebraic_term<T>>>
struct algebraic {
    using number = T;

    vec3<T> min, max;  ///< opposite corners of the box; missed unless each size is positive
    Terms terms;       ///< missed if there is none but with zeros

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr auto spans(const ray<T>& ray) const requires(Closed) { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const {
        aabb<T> box = unless_nan(padded(aabb<T>{min, max}), min, max);
        for (const algebraic_term<T>& term : terms) box = unless_nan(box, term.coefficient);
        return box;
    }

    /// f at a point.
    template <class W>
    RAIO_FN constexpr W value(const vec3<W>& p) const {
        W sum(0);
        for (const algebraic_term<T>& term : terms) {
            sum += W(term.coefficient) * power(p.x, term.x) * power(p.y, term.y) * power(p.z, term.z);
        }
        return sum;
    }

    template <class W>
    RAIO_FN constexpr vec3<W> gradient(const vec3<W>& p) const {
        vec3<W> sum(W(0));
        for (const algebraic_term<T>& term : terms) {
            W c(term.coefficient), x = power(p.x, term.x), y = power(p.y, term.y), z = power(p.z, term.z);
            if (term.x > 0) sum.x += c * W(term.x) * power(p.x, term.x - 1) * y * z;
            if (term.y > 0) sum.y += c * W(term.y) * power(p.y, term.y - 1) * z * x;
            if (term.z > 0) sum.z += c * W(term.z) * power(p.z, term.z - 1) * x * y;
        }
        return sum;
    }

    template <class Line, class Wanted = every_crossing, class W = typename Line::number>
    RAIO_FORMULA constexpr crossings_of_degree<W, Degree> crossings(const Line& line, const Wanted& wanted = {}) const {
        auto clip = box<T>{min, max}.crossings(line);
        if (!is_sound() || missed(clip)) return crossings_of_degree<W, Degree>(true);

        const vec3<W> low(min), size = vec3<W>(max) - low;
        const auto part = part_near(line, vec3<T>(T(0)), low + size * W(0.5), W(length(size) * W(0.5)));
        if (!part.exists) return crossings_of_degree<W, Degree>(part.is_there());
        clip.near.face = clip.far.face = index_t<W>(1);
        const auto f = along(part.point());
        if constexpr (Closed) {
            return closed_crossings(f, part, clip, part.roots_for(wanted));
        } else {
            return open_crossings(f, part, clip, part.roots_for(wanted));
        }
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        T bend = norm1(max - min);
        index_t<W> axis(3);
        if (at.face() != index_t<W>(0)) {
            const chord<W> clip = box<T>{min, max}.crossings(at.line());
            axis = at.entering() ? clip.near.face : clip.far.face;
            bend = T(0);
        }
        at.record_point(bend);
        detail::clipped_surface(at, aabb<T>{min, max}, axis, [&](const auto& p) { return gradient(p); });
    }

private:
    template <class W>
    RAIO_FN static constexpr W power(const W& x, unsigned n) {
        W product(1);
        for (unsigned i = 0; i < n; ++i) product *= x;
        return product;
    }

    RAIO_FN constexpr bool is_sound() const {
        bool is_zero = true, is_in_degree = true;
        for (const algebraic_term<T>& term : terms) {
            if (term.coefficient == T(0)) continue;
            is_zero = false;
            is_in_degree = is_in_degree && term.x + term.y + term.z <= Degree;
        }
        vec3<T> size = max - min;
        return !is_zero && is_in_degree && size.x > T(0) && size.y > T(0) && size.z > T(0) && is_finite(size);
    }

    /// f along a line.
    template <class W, std::size_t N>
    RAIO_FN constexpr polynomial<W, Degree * N> along(const polynomial_vector<W, N>& point) const {
        constexpr std::size_t degree = Degree * N;
        polynomial<W, degree> sum;
        for (const algebraic_term<T>& term : terms) {
            if (term.coefficient == T(0)) continue;
            polynomial<W, degree> p{{W(term.coefficient)}};
            const auto multiply = [&](const polynomial<W, N>& x, unsigned power) {
                for (unsigned i = 0; i < power; ++i) p = product<degree>(p, x);
            };
            multiply(point[0], term.x), multiply(point[1], term.y), multiply(point[2], term.z);
            sum = sum + p;
        }
        return sum;
    }
};

/// The surface alone.
template <real T, std::size_t Degree, class Terms = std::vector<algebraic_term<T>>>
using open_algebraic = algebraic<T, Degree, false, Terms>;

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
