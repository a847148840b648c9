#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/math/angle.hpp>
#include <raio/math/frame.hpp>
#include <raio/proof/polynomial_crossings.hpp>

namespace raio::inline RAIO_ABI {

/// A drop that hangs from its tip: the pear-shaped quartic (piriform; Lawrence, A Catalog of Special Plane Curves,
/// 1972), turned about its axis. At the height h, which is 0 at the bottom and 1 at the tip, the distance rho from the
/// axis is
///
///     rho^2 = radius^2 (256 / 27) h (1 - h)^3
///
/// so that it is widest at h = 1/4, and `radius` there. A radius of sqrt(27) / 16 = 0.32 of the height makes it the
/// curve of the textbooks, 4 rho^2 = (1 + z) (1 - z)^3 for z from -1 to 1. With A = tip - bottom and p seen from the
/// bottom, h = p.A / A.A and rho = |p x A| / |A|, both free of cancellation; along a line they are polynomials of
/// degree 1 and of degree 2 (squared), and the surface is a quartic. At the tip it has no normal: there it is against
/// the ray.
///
/// uv: u is the angle about the axis in turns, from the x axis of `frame_about(axis)`; v is h.
template <real T>
struct teardrop {
    using number = T;

    vec3<T> bottom, tip;
    T radius;  ///< where it is widest; missed unless it is positive and bottom and tip differ

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr auto spans(const ray<T>& ray) const requires(std::same_as<mask_t<T>, bool>) {
        return inside_of(*this, ray);
    }

    RAIO_FN constexpr aabb<T> bounds() const {
        vec3<T> axis = tip - bottom;
        vec3<T> reach = disc_reach(axis, radius) + vec3<T>((norm1(axis) + radius) * T(unit_roundoff<T>));
        const auto around = [&](const vec3<T>& p) { return aabb<T>{p - reach, p + reach}; };
        return padded(padded(hull(around(bottom), around(tip))));
    }

    template <class Line, class Wanted = every_crossing, class W = typename Line::number>
    RAIO_FORMULA constexpr crossings_of_degree<W, 4> crossings(const Line& line, const Wanted& wanted = {}) const {
        const auto axis = line.between(bottom, tip);
        const auto r = line.given(radius);
        const auto has_size = every(is_positive(r), is_positive(square(r)), is_positive(square(axis)));
        if (!has_size.yes) return crossings_of_degree<W, 4>(has_size);

        const vec3<W> low(bottom), middle = low + (vec3<W>(tip) - low) * W(0.5);
        const auto reach = sqrt(square(axis) * line.given(W(0.25)) + square(r));
        const auto part = part_near(line, bottom, middle, reach.value);
        if (!part.exists) return crossings_of_degree<W, 4>(part.is_there());
        return open_crossings(along(part.point()), part, everywhere<W>(), part.roots_for(wanted));
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        using W = typename Point::number;
        using Q = typename Point::precise;
        vec3<W> axis = difference_as<W>(tip, bottom);
        vec3<W> p = at.from(bottom);
        W over_axis2 = W(1) / dot(axis, axis), h = dot(p, axis) * over_axis2, below = W(1) - h, r(radius);
        vec3<W> from_axis = p - axis * h;
        // Half the gradient, times the square of the radius.
        W slope = W(128) * below * below * (W(1) - W(4) * h) * over_axis2 * r * r;
        // A slender drop is bent as much as it is slender, and its terms are as large.
        Q size = length(vec3<Q>(axis)), slender = size / Q(radius),
          bend = size * (slender * slender + Q(1)) + Q(radius);
        const T most = std::numeric_limits<scalar_t<T>>::max();
        at.record_point(bend < Q(most) ? T(bend) : most);
        at.keep_in([this] { return bounds(); });
        at.record_gradient(from_axis * W(27) - axis * slope);
        at.record_uv([&] { return uv_about(frame_about(normalize_from<T>(vec3<Q>(axis))), vec3<Q>(from_axis), T(h)); });
    }

private:
    /// f = rho^2 / radius^2 - (256 / 27) h (1 - h)^3, times 27, along a line.
    /// \param p  the point on its way, as seen from the bottom
    template <class W, std::size_t N>
    RAIO_FN constexpr polynomial<W, 4 * N> along(const polynomial_vector<W, N>& p) const {
        const auto exactly = [](double x) { return shape_numbers<W>::given(W(x)); };
        const auto axis = shape_numbers<W>::between(bottom, tip);
        const auto over_axis2 = inverse(square(axis));
        const auto over_r2 = inverse(square(shape_numbers<W>::given(radius)));
        const auto h = dot(p, axis) * over_axis2;
        const auto below = exactly(1) - h;
        const auto rho2 = square(cross(p, axis)) * over_axis2;
        return rho2 * (exactly(27) * over_r2) - h * below * square(below) * exactly(256);
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
