#pragma once

#include <raio/push_macros.hpp>

#include <array>

#include <raio/concepts.hpp>
#include <raio/proof/lanes.hpp>

namespace raio::inline RAIO_ABI {

/// A plain primitive for each lane of a pack: so whatever has no shape of packs, as a mesh, a tree, a profile or a
/// function, takes rays of packs as well. Several lanes may share one.
///
///     const auto vases = raio::in_every_lane<pack<float>>(vase);  // many rays against one
///
/// Each lane answers what its primitive answers, exactly, and costs as much.
template <real P, primitive Shape>
requires(detail::has_lanes<P>&& std::same_as<number_t<Shape>, scalar_t<P>>) struct in_lanes {
    using number = P;

    std::array<const Shape*, P::lanes> shapes;  ///< each has to live longer than this

    mask_t<P> hit(const ray<P>& ray, const P& t_min, const P& t_max, hit_record<P>& rec) const {
        return detail::first_hit_in_lanes(*this, ray, t_min, t_max, rec);
    }

    mask_t<P> occluded(const ray<P>& ray, const P& t_min, const P& t_max) const {
        return detail::any_hit_in_lanes(*this, ray, t_min, t_max);
    }

    aabb<P> bounds() const requires bounded<Shape> {
        aabb<P> boxes;
        for (std::size_t i = 0; i < P::lanes; ++i) {
            const aabb<scalar_t<P>> box = shapes[i]->bounds();
            detail::set_lane(boxes.min, i, box.min), detail::set_lane(boxes.max, i, box.max);
        }
        return boxes;
    }

    /// The primitive of one lane.
    const Shape& in_lane(std::size_t lane) const { return *shapes[lane]; }
};

/// The same primitive for every lane.
template <real P, primitive Shape>
in_lanes<P, Shape> in_every_lane(const Shape& shape) {
    in_lanes<P, Shape> lanes;
    lanes.shapes.fill(&shape);
    return lanes;
}
template <real P, primitive Shape>
in_lanes<P, Shape> in_every_lane(const Shape&&) = delete;  // which would not live long enough

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
