#pragma once

#include <raio/push_macros.hpp>

#include <array>
#include <bit>

#include <raio/aabb.hpp>
#include <raio/ray.hpp>

namespace raio::inline RAIO_ABI {

/// Everything about the place where a ray met a shape. It has no values until something is hit.
///
/// What a program has no use for it need not pay for: `hit` fills any struct that has a `t`, and of the other members
/// those that the struct has, in the types that they have there. What else a struct has goes along: a shape with a
/// `hit` of its own finds there what the caller has put, and what it puts there comes back, through groups and trees as
/// well. (A member that only some shapes write is that of the last one met on the way, as in a plain loop.)
///
/// A struct that has `indices`, an array of numbers, is given the way to the shape: first which member of the outermost
/// aggregate was hit, then which member of that, and so on; zeros behind the last.
template <real T>
struct hit_record {
    T t;                   ///< ray parameter, in lengths of the ray's direction
    vec3<T> point;         ///< where
    vec3<T> normal;        ///< unit, against the ray's direction, up to its rounding
    vec2<T> uv;            ///< surface coordinates in [0, 1]^2, as the shape documents them
    vec3<T> error;         ///< how far `point` may be from the exact crossing, axis by axis
    index_t<T> index;      ///< which member of an aggregate was hit; 0 where there are no members
    mask_t<T> front_face;  ///< did the ray come from outside? The outward normal is `front_face ? normal : -normal`
};

/// What of a hit is recorded: what the record has.
template <class Record>
concept has_point = requires(Record& rec) {
    rec.point;
};
template <class Record>
concept has_normal = requires(Record& rec) {
    rec.normal;
};
template <class Record>
concept has_uv = requires(Record& rec) {
    rec.uv;
};
template <class Record>
concept has_error = requires(Record& rec) {
    rec.error;
};
template <class Record>
concept has_index = requires(Record& rec) {
    rec.index;
};
template <class Record>
concept has_indices = requires(Record& rec) {
    rec.indices[0];
    std::size(rec.indices);
};
template <class Record>
concept has_front_face = requires(Record& rec) {
    rec.front_face;
};

/// A struct that `hit` can fill. It has to have a `t`.
template <class Record>
concept record = requires(Record& rec) {
    rec.t;
};

namespace detail {

/// Assigns a member of a record, which may be of another type.
template <class To, class From>
RAIO_FN constexpr void put(To& to, const From& from) {
    if constexpr (requires { static_cast<To>(from); }) {
        to = static_cast<To>(from);
    } else {
        to = from;
    }
}

/// Calls `visit` with each member that the record has, and with that of the other one; but for `indices`.
template <class Record, class Other, class Visit>
RAIO_FN constexpr void for_each_member(Record& rec, const Other& other, Visit visit) {
    visit(rec.t, other.t);
    if constexpr (has_point<Record>) visit(rec.point, other.point);
    if constexpr (has_normal<Record>) visit(rec.normal, other.normal);
    if constexpr (has_uv<Record>) visit(rec.uv, other.uv);
    if constexpr (has_error<Record>) visit(rec.error, other.error);
    if constexpr (has_index<Record>) visit(rec.index, other.index);
    if constexpr (has_front_face<Record>) visit(rec.front_face, other.front_face);
}

/// Says which member of an aggregate was hit, in the record that the member has filled.
template <record Record, class Index>
RAIO_FN constexpr void put_index(Record& rec, const Index& index) {
    if constexpr (has_index<Record>) put(rec.index, index);
    if constexpr (has_indices<Record>) {
        for (std::size_t k = std::size(rec.indices); --k > 0;) rec.indices[k] = rec.indices[k - 1];
        put(rec.indices[0], index);
    }
}

/// The order of crossings along a ray: by t, at equal t the front faces first, and of equal ones the lowest index.
template <real T>
RAIO_FN constexpr bool comes_before(const hit_record<T>& a, const hit_record<T>& b) {
    if (a.t != b.t) return a.t < b.t;
    return a.front_face != b.front_face ? a.front_face : a.index < b.index;
}

}  // namespace detail

/// The next number above t. The window of `hit` is closed, so that `shape.hit(ray, after(rec.t), t_max, rec)` finds the
/// next crossing of the same ray; `rec.t + epsilon` is rec.t again where that is large.
template <std::floating_point T>
RAIO_FN constexpr T after(T t) {
    using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    static_assert(sizeof(T) == sizeof(bits));
    if (!(t < std::numeric_limits<T>::infinity())) return t;
    if (t == T(0)) return std::numeric_limits<T>::denorm_min();
    const bits b = std::bit_cast<bits>(t);
    return std::bit_cast<T>(t > T(0) ? b + 1 : b - 1);
}
/// The next number below t.
template <std::floating_point T>
RAIO_FN constexpr T before(T t) {
    return -after(-t);
}

/// The nearest that T can say to a point beyond its largest number. Hardly any point is.
template <real T>
RAIO_RARELY RAIO_FN constexpr vec3<T> within_range(vec3<T> p) {
    const vec3<T> most{T(std::numeric_limits<scalar_t<T>>::max())};
    return max(-most, min(most, p));
}

/// Takes `from` over into `to`, in the lanes of the mask. What else the record has stays as it is. (Not asked whether
/// the mask is set in all lanes: a pack that is written where it is need not be read.)
template <class Mask, record Record>
RAIO_FN constexpr void assign(const Mask& mask, Record& to, const Record& from) {
    const auto take = [&mask](auto& member, const auto& new_member) {
        if constexpr (requires { member.take(mask, new_member); }) {  // which lanes are front
            member.take(mask, new_member);
        } else if constexpr (!std::same_as<Mask, bool>) {
            member = select(mask, new_member, member);
        } else if (mask) {
            member = new_member;
        }
    };
    detail::for_each_member(to, from, take);
    if constexpr (has_indices<Record>) {
        for (std::size_t k = 0; k < std::size(to.indices); ++k) take(to.indices[k], from.indices[k]);
    }
}

/// Takes over what the record has room for.
template <record Record, real T>
RAIO_FN constexpr void assign(Record& to, const hit_record<T>& from) {
    detail::for_each_member(to, from, [](auto& member, const auto& new_member) { detail::put(member, new_member); });
    if constexpr (has_indices<Record>) {
        for (auto& index : to.indices) detail::put(index, index_t<T>{});
        detail::put(to.indices[0], from.index);
    }
}

/// A ray that leaves the surface at the recorded point and never meets that point again: its origin is moved to the
/// side that `direction` goes to, along the normal, by just the error of the point (Pharr, Jakob and Humphreys, PBR 4th
/// ed., 6.8.6).
/// \param rec  any with a point, a normal and an error, of the shape's numbers
template <record Record, real T = std::remove_cvref_t<decltype(Record::t)>>
RAIO_FN constexpr ray<T> spawn_ray(const Record& rec, const vec3<T>& direction) requires(
    has_point<Record>&& has_normal<Record>&& has_error<Record>) {
    const vec3<T> point(rec.point), normal(rec.normal), error(rec.error);
    const T side = copysign(T(1), dot(normal, direction));
    vec3<T> n = normal * side;
    const T distance = dot(abs(n), error);
    // A coordinate along which the normal has all but no part stays: moved to the next number, it would take the origin
    // further along a curved surface than the error off it.
    const auto moved = [&](T p, T n_i) {
        return select(n_i * n_i < T(unit_roundoff<T> / 4), p, outward(p + n_i * distance, n_i));
    };
    return {{moved(point.x, n.x), moved(point.y, n.y), moved(point.z, n.z)}, direction};
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
