#pragma once

#include <raio/push_macros.hpp>

#include <raio/bvh/nearest.hpp>
#include <raio/bvh/ray_bundle.hpp>

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// For each ray of a bundle the nearest of all shapes that have been seen so far.
///
/// A leaf has its shapes in the lanes of packs, and is asked ray by ray; or the rays are in the lanes, and it is asked
/// shape by shape, where fewer shapes are near than rays. What is left at the end is recorded for many rays at once.
template <class T, class Leaves>
class nearest_together {
    using P = typename rays_in_lanes<T>::numbers;
    using query = nearest<T, Leaves, ray<T>, hit_record<T>>;

public:
    /// \param recs  are left as they are where there is nothing to be found
    nearest_together(const Leaves& leaves, std::span<const ray<T>> rays, const rays_in_lanes<T>& lanes, T t_min,
                     T t_max, std::span<hit_record<T>> recs)
        : leaves_(leaves), rays_(rays), groups_(lanes.groups()), t_min_(t_min), t_max_(t_max) {
        farthest_.fill(t_max);
        for (std::size_t i = 0; i < rays.size(); ++i)
            std::construct_at(&queries_[i], leaves, rays[i], t_min, t_max, recs[i]);
    }

    /// Nothing beyond that can be nearest for a ray.
    T farthest(std::size_t i) const { return farthest_[i]; }

    /// \param of    the rays that may meet the leaf
    /// \param near  says which boxes any of the rays may meet
    template <std::size_t Kind, class Near>
    void visit(std::uint32_t block, std::uint64_t of, Near near) {
        const auto& leaves = std::get<Kind>(leaves_.all);
        if constexpr (requires { leaves.shapes(block); }) {
            std::uint32_t shapes = leaves.used(block);
            if (std::popcount(shapes) < std::popcount(of)) shapes &= near(leaves.shapes(block).bounds());
            for (std::size_t g = 0; g < groups_.size(); ++g) {
                const std::uint64_t own = of & std::uint64_t{every_lane<P>} << (g * P::lanes);
                if (std::popcount(shapes) >= std::popcount(own)) continue;
                visit_by_shapes<Kind>(block, shapes, g, static_cast<std::uint32_t>(own >> (g * P::lanes)));
                of &= ~own;
            }
        }
        for (; of != 0; of &= of - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(of));
            queries_[i].template visit<Kind>(block);
            farthest_[i] = queries_[i].farthest();
        }
    }

    /// Answers for which rays there is one, once everything has been seen.
    std::uint64_t finish() {
        record_many();
        std::uint64_t found = 0;
        for (std::size_t i = 0; i < rays_.size(); ++i) found |= std::uint64_t{queries_[i].finish()} << i;
        return found;
    }

private:
    /// \param of  the lanes of the group that may meet the leaf
    template <std::size_t Kind>
    void visit_by_shapes(std::uint32_t block, std::uint32_t shapes, std::size_t g, std::uint32_t of) {
        const auto& leaves = std::get<Kind>(leaves_.all);
        using own = pack<T, std::remove_cvref_t<decltype(leaves)>::lanes>;
        using Shape = std::remove_cvref_t<decltype(leaves.shape(0, 0))>;
        const auto& packed = leaves.shapes(block);
        const P from(within_numbers(t_min_));
        const std::size_t first = g * P::lanes;
        for (; shapes != 0; shapes &= shapes - 1) {
            const auto lane = static_cast<unsigned>(std::countr_zero(shapes));
            const P to = within_numbers(P::load(&farthest_[first]));
            using W = std::conditional_t<is_quick<Shape>, plain<P>, first_t<P>>;
            const auto found = sift(
                crossings_for<W, question::where>(spread<P, own>(packed, lane), groups_[g], W(from), W(to)), from, to);
            const std::uint32_t sure = bits(found.sure) & of, open = bits(found.open) & of;
            for (std::uint32_t left = sure | open; left != 0; left &= left - 1) {
                const auto i = static_cast<std::size_t>(std::countr_zero(left));
                query& own_query = queries_[first + i];
                const place_in_leaves at = leaves_.template place<Kind>(block, lane);
                if ((sure >> i & 1) != 0) {
                    own_query.consider(at, found.low[i], found.high[i]);
                    farthest_[first + i] = own_query.farthest();
                } else {
                    own_query.wait(at);
                }
            }
        }
    }

    /// Records what is nearest for each ray, side by side those that have met shapes of one kind.
    void record_many() {
        std::uint64_t left = 0;
        for (std::size_t i = 0; i < rays_.size(); ++i) left |= std::uint64_t{queries_[i].unrecorded() != nullptr} << i;
        while (left != 0) {
            const std::size_t kind = queries_[static_cast<std::size_t>(std::countr_zero(left))].unrecorded()->kind;
            std::array<std::size_t, P::lanes> which;
            std::size_t count = 0;
            for (std::uint64_t rest = left; rest != 0 && count < which.size(); rest &= rest - 1) {
                const auto i = static_cast<std::size_t>(std::countr_zero(rest));
                if (queries_[i].unrecorded()->kind == kind) which[count++] = i, left &= ~(std::uint64_t{1} << i);
            }
            constexpr std::size_t worth_it = 4;  // packs take as long as so many rays, which are left to `finish`
            if (count < worth_it) continue;
            Leaves::with_kind(static_cast<std::uint32_t>(kind),
                              [&](auto k) { record_some<k()>(std::span(which).first(count)); });
        }
    }

    template <std::size_t Kind>
    void record_some(std::span<const std::size_t> rays) {
        const auto& leaves = std::get<Kind>(leaves_.all);
        using Shape = std::remove_cvref_t<decltype(leaves.shape(0, 0))>;
        if constexpr (gatherable<Shape>) {
            gathered<Shape, P::lanes> shapes;
            ray<P> own;
            P t;
            for (std::size_t lane = 0; lane < P::lanes; ++lane) {
                const std::size_t i = rays[std::min(lane, rays.size() - 1)];
                const place_in_leaves& at = *queries_[i].unrecorded();
                shapes.set(lane, leaves.shape(at.block, at.lane)), t.set(lane, queries_[i].low());
                set_lane(own.origin, lane, rays_[i].origin), set_lane(own.direction, lane, rays_[i].direction);
            }
            hit_record<P> found;
            if constexpr (is_quick<Shape>) {
                shapes.shapes().record_at(own, t, found);
            } else {
                first_hit<question::only_where>(shapes.shapes(), own, P(t_min_), P(t_max_), found);
            }
            for (std::size_t lane = 0; lane < rays.size(); ++lane)
                queries_[rays[lane]].take_in(in_lane<P>(found, lane));
        }
    }

    const Leaves& leaves_;
    std::span<const ray<T>> rays_;
    std::span<const ray<P>> groups_;
    T t_min_, t_max_;
    std::array<T, ray_bundle::most> farthest_;
    union {                                // not set to zero, as optional ones would be
        query queries_[ray_bundle::most];  ///< of as many as there are rays
    };
    static_assert(std::is_trivially_destructible_v<query>);
};

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
