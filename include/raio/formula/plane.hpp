#pragma once

#include <raio/hit_record.hpp>
#include <raio/proof/chord.hpp>

namespace raio {

/// The part of a line behind a plane: from its crossing on, up to it, or all or nothing if it runs parallel.
/// \param height  of the point where the line has t = 0, times the length of the normal
/// \param speed   how fast the height grows
template <class W>
RAIO_FN constexpr chord<W> cross_half_space(const bounded_number<W>& height, const bounded_number<W>& speed,
                                            const index_t<W>& face) {
    const bounded_number<W> t = -height * inverse(speed);
    const auto crosses = is_positive(abs(speed));
    const mask_t<W> leaves = speed.value > W(0);
    chord<W> c = between(crosses, t, t);
    c.near.face = c.far.face = face;
    begin_never_where(leaves, c), end_never_where(!leaves, c);
    return unless(!crosses, c, is_not_negative(-height));
}

/// Puts the recorded point onto its plane if that runs across an axis, as bounds without a thickness expect it: one
/// coordinate is known then, that of any other point of the plane.
template <real T, real N>
RAIO_FN constexpr void put_onto_plane(const vec3<T>& normal, const vec3<T>& on_plane, hit_record<T, N>& rec) {
    const auto put = [](const T& n_j, const T& n_k, const T& known, T& p) {
        p = select(every(n_j == T(0), n_k == T(0)), known, p);
    };
    put(normal.y, normal.z, on_plane.x, rec.point.x);
    put(normal.z, normal.x, on_plane.y, rec.point.y);
    put(normal.x, normal.y, on_plane.z, rec.point.z);
}

}  // namespace raio
