#pragma once

#include <raio/aabb.hpp>
#include <raio/ray.hpp>

namespace raio {

/// Everything about the place where a ray met a shape. N is the number type of the normal: a map that has yet to turn
/// it asks for more digits than T has.
template <real T, real N = T>
struct hit_record {
    T t{};                   ///< ray parameter, in lengths of the ray's direction
    vec3<T> point{T(0)};     ///< where
    vec3<N> normal{N(0)};    ///< unit, against the ray's direction, up to its rounding
    vec2<T> uv{T(0)};        ///< surface coordinates in [0, 1]^2, as the shape documents them
    vec3<T> error{T(0)};     ///< how far `point` may be from the exact crossing, axis by axis
    index_t<T> index{};      ///< which member of an aggregate was hit; 0 where there are no members
    mask_t<T> front_face{};  ///< did the ray come from outside? The outward normal is `front_face ? normal : -normal`
};

/// The nearest that T can say to a point beyond its largest number.
template <real T>
RAIO_FN constexpr vec3<T> within_range(const vec3<T>& p) {
    const T most(std::numeric_limits<scalar_t<T>>::max());
    const auto clamped = [&](const T& x) { return max(-most, min(most, x)); };
    return {clamped(p.x), clamped(p.y), clamped(p.z)};
}

/// Takes `from` over into `to`, in the lanes of the mask. (Not asked whether that is all of them: a pack that is
/// written where the mask is set need not be read.)
template <real T, real N>
RAIO_FN constexpr void assign(mask_t<T> mask, hit_record<T, N>& to, const hit_record<T, N>& from) {
    to.t = select(mask, from.t, to.t);
    to.point = select(mask, from.point, to.point);
    to.normal = select(mask, from.normal, to.normal);
    to.uv = select(mask, from.uv, to.uv);
    to.error = select(mask, from.error, to.error);
    to.index = select(mask, from.index, to.index);
    to.front_face = some(every(mask, from.front_face), every(!mask, to.front_face));
}

/// A ray that leaves the surface at the recorded point and never meets that point again: its origin is moved to the
/// side that `direction` goes to, along the normal, by just the error of the point (Pharr, Jakob and Humphreys, PBR 4th
/// ed., 6.8.6).
template <real T>
RAIO_FN constexpr ray<T> spawn_ray(const hit_record<T>& rec, const vec3<T>& direction) {
    const T side = copysign(T(1), dot(rec.normal, direction));
    vec3<T> n = rec.normal * side;
    const T distance = dot(abs(n), rec.error);
    // A coordinate along which the normal has all but no part stays: moved to the next number, it would take the origin
    // further along a curved surface than the error off it.
    const auto moved = [&](T p, T n_i) {
        return select(n_i * n_i < T(unit_roundoff<T> / 4), p, outward(p + n_i * distance, n_i));
    };
    return {{moved(rec.point.x, n.x), moved(rec.point.y, n.y), moved(rec.point.z, n.z)}, direction};
}

}  // namespace raio
