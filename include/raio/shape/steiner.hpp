#pragma once

#include <raio/push_macros.hpp>

#include <array>

#include <raio/concepts.hpp>
#include <raio/proof/polynomial_crossings.hpp>

namespace raio::inline RAIO_ABI {

/// Steiner's Roman surface (Steiner 1844; Apery, Models of the Real Projective Plane, 1987): the points
/// size (b c, c a, a b) of all unit vectors (a, b, c), seen from `center`, in a cube with edges of length `size`.
///
///     f = x^2 y^2 + y^2 z^2 + z^2 x^2 - size x y z = 0
///
/// It closes four lobes, where f < 0 and x y z > 0, which meet in the centre and in three segments of the axes: there
/// two sheets cross, and the normal is against the ray. f is zero on all of the axes; beyond the cube, which is beyond
/// the surface, they do not belong to it. Neither is a ray met that runs along one of them.
///
/// uv: x and y of the point, from 0 to 1 across the cube.
template <real T>
struct steiner {
    using number = T;

    vec3<T> center;
    T size;  ///< of the cube around it; missed unless it is positive

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    /// Inside the lobes.
    RAIO_FN constexpr auto spans(const ray<T>& ray) const requires(std::same_as<mask_t<T>, bool>) {
        return inside_of(*this, ray);
    }

    RAIO_FN constexpr aabb<T> bounds() const {
        vec3<T> half(size / T(2));
        return unless_nan(padded(padded(aabb<T>{center - half, center + half})), center, size);
    }

    template <class Line, class Wanted = every_crossing, class W = typename Line::number>
    RAIO_FORMULA constexpr crossings_of_degree<W, 4> crossings(const Line& line, const Wanted& wanted = {}) const {
        // The lobes reach as far as their tips at size / 3 (1, 1, 1), which are 0.58 away, and as the cube's faces.
        const auto part = part_near(line, center, vec3<W>(center), W(size) * W(0.5859375));
        if (!part.exists) return crossings_of_degree<W, 4>(part.is_there());

        // Where f only touches zero from above, that may be an axis beyond the cube.
        const auto half = line.given(W(size) * W(0.5));
        const auto belongs = [&](const polynomial_root<W>& root) {
            if (root.sign_before < 0 || root.sign_after < 0) return true;
            const auto is_within = [&](glm::length_t axis) {
                return abs(part.coordinate_where_touched(root, axis)) <= half;
            };
            return every(is_within(0), is_within(1), is_within(2)).yes;
        };
        return open_crossings(along(part.point()), part, everywhere<W>(), part.roots_for(wanted), belongs);
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        vec3<W> from_center = at.from(center);
        vec3<W> p = from_center * (W(1) / W(size)), squares = p * p;
        vec3<W> gradient(W(2) * p.x * (squares.y + squares.z) - p.y * p.z,
                         W(2) * p.y * (squares.z + squares.x) - p.z * p.x,
                         W(2) * p.z * (squares.x + squares.y) - p.x * p.y);
        at.record_point(size);
        at.keep_in([this] { return bounds(); });
        at.record_gradient(gradient);
        at.record_uv([&] {
            const auto place = [](const W& x) { return raio::max(T(0), raio::min(T(1), T(x + W(0.5)))); };
            return vec2<T>(place(p.x), place(p.y));
        });
    }

private:
    /// f of a cube of size 1, along a line.
    /// \param point  on its way, as seen from the centre
    template <class W, std::size_t N>
    RAIO_FN constexpr polynomial<W, 4 * N> along(const polynomial_vector<W, N>& point) const {
        const auto [x, y, z] = point * inverse(shape_numbers<W>::given(size));
        const auto x2 = square(x);
        const auto y2 = square(y);
        const auto z2 = square(z);
        return x2 * (y2 + z2) + y2 * z2 - x * y * z;
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
