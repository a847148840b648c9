#pragma once

#include <raio/push_macros.hpp>

#include <cstring>

#include <raio/hit_record.hpp>
#include <raio/math/interval.hpp>

/// \file
/// The lanes of shapes and rays of packs.
///
/// A shape is an aggregate of numbers, and so is the shape of packs: where the one has its k-th number, the other has
/// its k-th pack. So a shape goes into a lane, and comes out again, number by number, and nothing needs to be known of
/// its fields.

namespace raio::inline RAIO_ABI::detail {

/// Has a number type more than one lane?
template <class T>
concept has_lanes = real<T> && requires {
    T::lanes;
};

/// The same shape, made of another number type.
template <class Shape, class U>
struct rebind;
template <template <real, auto...> class Shape, real T, auto... Options, class U>
struct rebind<Shape<T, Options...>, U> {
    using type = Shape<U, Options...>;
};
template <class Shape, class U>
using rebind_t = typename rebind<Shape, U>::type;

/// Is it made of packs P where the same shape, made of plain numbers, has those numbers, and of nothing else?
template <class Packed, class P>
concept aggregate_of_packs = std::is_trivially_copyable_v<rebind_t<Packed, scalar_t<P>>> &&
                             std::is_standard_layout_v<rebind_t<Packed, scalar_t<P>>> &&
                             (sizeof(Packed) % sizeof(P) == 0) &&
                             (sizeof(rebind_t<Packed, scalar_t<P>>) == sizeof(Packed) / P::lanes);

/// What is in one lane of a shape, or a ray, of packs P.
template <class P, class Packed>
RAIO_FN auto in_lane(const Packed& packed, std::size_t lane) {
    static_assert(aggregate_of_packs<Packed, P>, "raio: only an aggregate of numbers can be one of packs");
    using S = scalar_t<P>;
    // Put together in place, number by number: as a whole it would have to wait for the numbers to reach memory.
    rebind_t<Packed, S> plain;
    for (std::size_t k = 0; k < sizeof(Packed) / sizeof(P); ++k) {
        std::memcpy(reinterpret_cast<std::byte*>(&plain) + k * sizeof(S),
                    reinterpret_cast<const std::byte*>(&packed) + k * sizeof(P) + lane * sizeof(S), sizeof(S));
    }
    return plain;
}

/// The same, of a shape that knows what stands in its lanes.
template <class P, class Packed>
requires requires(const Packed packed) { packed.in_lane(0); }
RAIO_FN decltype(auto) in_lane(const Packed& packed, std::size_t lane) { return packed.in_lane(lane); }

/// The same, but packed as many times over as P has lanes.
template <class P, class From, class Packed>
RAIO_FN auto spread(const Packed& packed, std::size_t lane) {
    static_assert(aggregate_of_packs<Packed, From>, "raio: only an aggregate of numbers can be one of packs");
    rebind_t<Packed, P> same;
    for (std::size_t k = 0; k < sizeof(Packed) / sizeof(From); ++k) {
        scalar_t<P> number;
        std::memcpy(&number, reinterpret_cast<const std::byte*>(&packed) + k * sizeof(From) + lane * sizeof(number),
                    sizeof(number));
        const P numbers(number);
        std::memcpy(reinterpret_cast<std::byte*>(&same) + k * sizeof(P), &numbers, sizeof(P));
    }
    return same;
}

template <has_lanes P>
RAIO_FN void set_lane(vec3<P>& to, std::size_t lane, const vec3<scalar_t<P>>& from) {
    to.x.set(lane, from.x), to.y.set(lane, from.y), to.z.set(lane, from.z);
}

/// Takes `from` over into a lane of `to`, but for the side: whether it is the front is said by 1 and 0.
template <has_lanes P, record Record>
RAIO_FN void set_lane(Record& to, P& front, std::size_t lane, const hit_record<scalar_t<P>>& from) {
    to.t.set(lane, from.t), front.set(lane, from.front_face ? 1 : 0);
    if constexpr (has_index<Record>) to.index.set(lane, from.index);
    if constexpr (has_point<Record>) set_lane(to.point, lane, from.point);
    if constexpr (has_normal<Record>) set_lane(to.normal, lane, from.normal);
    if constexpr (has_error<Record>) set_lane(to.error, lane, from.error);
    if constexpr (has_uv<Record>) to.uv.x.set(lane, from.uv.x), to.uv.y.set(lane, from.uv.y);
}

/// What is recorded in one lane. (Part of what asks: a record that is put together in memory waits there to be copied.)
template <has_lanes P>
[[gnu::always_inline]] RAIO_FN inline hit_record<scalar_t<P>> in_lane(const hit_record<P>& rec, std::size_t lane) {
    const auto of = [&](const vec3<P>& v) { return vec3<scalar_t<P>>(v.x[lane], v.y[lane], v.z[lane]); };
    return {rec.t[lane],         of(rec.point),
            of(rec.normal),      {rec.uv.x[lane], rec.uv.y[lane]},
            of(rec.error),       static_cast<std::uint32_t>(rec.index[lane]),
            rec.front_face[lane]};
}

/// Calls `ask` with the plain shape and the plain ray of each lane that has its bit set, and with its number. Answers
/// for which it was true.
template <has_lanes P, class Packed, class Ask>
RAIO_FN mask_t<P> ask_lanes(std::uint32_t which, const Packed& packed, const ray<P>& ray, Ask ask) {
    P yes(0);
    for (std::size_t lane = 0; lane < P::lanes; ++lane) {
        if ((which >> lane & 1) != 0 && ask(in_lane<P>(packed, lane), in_lane<P>(ray, lane), lane)) yes.set(lane, 1);
    }
    return yes > P(0);
}

template <has_lanes P>
inline constexpr std::uint32_t every_lane = ~std::uint32_t{0} >> (32 - P::lanes);

/// `occluded` of the plain shapes in these lanes.
template <has_lanes P, class Packed>
[[gnu::noinline]] RAIO_FN mask_t<P> any_hit_in_lanes(const Packed& packed, const ray<P>& ray, const P& t_min,
                                                     const P& t_max, std::uint32_t which = every_lane<P>) {
    return ask_lanes<P>(which, packed, ray, [&](const auto& shape, const auto& own_ray, std::size_t lane) {
        return shape.occluded(own_ray, t_min[lane], t_max[lane]);
    });
}

/// `hit` of the plain shapes in these lanes.
template <has_lanes P, class Packed, record Record>
[[gnu::noinline]] RAIO_FN mask_t<P> first_hit_in_lanes(const Packed& packed, const ray<P>& ray, const P& t_min,
                                                       const P& t_max, Record& rec,
                                                       std::uint32_t which = every_lane<P>) {
    P front(0);
    const mask_t<P> met =
        ask_lanes<P>(which, packed, ray, [&](const auto& shape, const auto& own_ray, std::size_t lane) {
            hit_record<scalar_t<P>> own;
            if (!shape.hit(own_ray, t_min[lane], t_max[lane], own)) return false;
            set_lane(rec, front, lane, own);
            return true;
        });
    if constexpr (has_front_face<Record>) {
        rec.front_face.take(met, front > P(0));
    }
    return met;
}

/// `spans` of the plain shapes, which are one interval each.
template <class Packed, has_lanes P>
RAIO_FN auto spans_in_lanes(const Packed& packed, const ray<P>& ray) {
    interval<P> inside;
    for (std::size_t lane = 0; lane < P::lanes; ++lane) {
        const interval<scalar_t<P>> own = in_lane<P>(packed, lane).spans(in_lane<P>(ray, lane));
        inside.min.set(lane, own.min), inside.max.set(lane, own.max);
    }
    return inside;
}

}  // namespace raio::inline RAIO_ABI::detail

#include <raio/pop_macros.hpp>
