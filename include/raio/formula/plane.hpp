#pragma once

#include <raio/push_macros.hpp>

#include <raio/hit_record.hpp>
#include <raio/proof/chord.hpp>

namespace raio::inline RAIO_ABI {

/// The part of a line behind a plane: from its crossing on, up to it, or all or nothing if it runs parallel.
/// \param height  of the point where the line has t = 0, times the length of the normal
/// \param speed   how fast the height grows
template <class W>
RAIO_FN constexpr chord<W> cross_half_space(const bounded_number<W>& height, const bounded_number<W>& speed,
                                            const index_t<W>& face) {
    const bounded_number<W> t = -height * inverse(speed);
    const auto is_parallel = !is_positive(abs(speed));
    const mask_t<W> leaves = speed.value > W(0);
    chord<W> c = between(!is_parallel, t, t);
    c.near.face = c.far.face = face;
    begin_never_where(leaves, c), end_never_where(!leaves, c);
    return unless_parallel(is_parallel, c, is_not_negative(-height));
}

/// The part of a line between two planes that are parallel.
/// \param to_low, to_high  how far it is to each across them, from the point where the line has t = 0
/// \param speed            how fast the line goes that way
template <class W>
RAIO_FN constexpr chord<W> cross_between(const bounded_number<W>& to_low, const bounded_number<W>& to_high,
                                         const bounded_number<W>& speed) {
    const bounded_number<W> over = inverse(speed), low = to_low * over, high = to_high * over;
    const auto is_parallel = !is_positive(abs(speed));
    const mask_t<W> upward = !(speed.value < W(0));
    chord<W> c = between(!is_parallel, choose_where(upward, low, high), choose_where(upward, high, low));
    if (all(!is_parallel)) return c;

    // A line that is parallel to the planes is between them everywhere or nowhere.
    return unless_parallel(is_parallel, c, every(is_not_negative(-to_low), is_not_negative(to_high)));
}

/// Puts the point onto its plane if that runs across an axis, as bounds without a thickness expect it: one coordinate
/// is known then, that of any other point of the plane.
template <class Point, real T>
RAIO_FN constexpr void put_onto_plane(Point& at, const vec3<T>& normal, const vec3<T>& on_plane) {
    if constexpr (Point::is_mapped || is_believed<typename Point::number>) return;
    const auto put = [](const T& n_j, const T& n_k, const T& known, T& p) {
        p = select(every(n_j == T(0), n_k == T(0)), known, p);
    };
    vec3<T>& point = at.point();
    put(normal.y, normal.z, on_plane.x, point.x);
    put(normal.z, normal.x, on_plane.y, point.y);
    put(normal.x, normal.y, on_plane.z, point.z);
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
