#pragma once

#include <cstring>

#include <raio/hit_record.hpp>

/// \file
/// The lanes of shapes and rays of packs.
///
/// A shape is an aggregate of numbers, and so is the shape of packs: where the one has its k-th number, the other has
/// its k-th pack. So a shape goes into a lane, and comes out again, number by number, and nothing needs to be known of
/// its fields.

namespace raio::detail {

/// Has a number type more than one lane?
template <class T>
concept has_lanes = requires {
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
RAIO_FN const auto& in_lane(const Packed& packed, std::size_t lane) { return packed.in_lane(lane); }

template <has_lanes P>
RAIO_FN void set_lane(vec3<P>& to, std::size_t lane, const vec3<scalar_t<P>>& from) {
    to.x.set(lane, from.x), to.y.set(lane, from.y), to.z.set(lane, from.z);
}

/// `occluded` of a shape of packs whose formula takes another course for each number: lane by lane.
template <has_lanes P, class Packed>
RAIO_FN mask_t<P> any_hit_in_lanes(const Packed& packed, const ray<P>& ray, const P& t_min, const P& t_max) {
    P found(0);
    for (std::size_t lane = 0; lane < P::lanes; ++lane) {
        const bool hit = in_lane<P>(packed, lane).occluded(in_lane<P>(ray, lane), t_min[lane], t_max[lane]);
        found.set(lane, hit ? 1 : 0);
    }
    return found > P(0);
}

/// `hit`, likewise.
template <has_lanes P, class Packed>
RAIO_FN mask_t<P> first_hit_in_lanes(const Packed& packed, const ray<P>& ray, const P& t_min, const P& t_max,
                                     hit_record<P>& rec) {
    P found(0), front(0);
    hit_record<P> candidate;
    for (std::size_t lane = 0; lane < P::lanes; ++lane) {
        hit_record<scalar_t<P>> own;
        if (!in_lane<P>(packed, lane).hit(in_lane<P>(ray, lane), t_min[lane], t_max[lane], own)) continue;
        found.set(lane, 1), front.set(lane, own.front_face ? 1 : 0);
        candidate.t.set(lane, own.t), candidate.index.set(lane, own.index);
        set_lane(candidate.point, lane, own.point), set_lane(candidate.normal, lane, own.normal);
        set_lane(candidate.error, lane, own.error);
        candidate.uv.x.set(lane, own.uv.x), candidate.uv.y.set(lane, own.uv.y);
    }
    candidate.front_face = front > P(0);
    assign(found > P(0), rec, candidate);
    return found > P(0);
}

}  // namespace raio::detail
