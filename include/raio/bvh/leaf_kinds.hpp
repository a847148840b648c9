#pragma once

#include <raio/push_macros.hpp>

#include <tuple>

#include <raio/bvh/leaf.hpp>

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// Where a shape stands: in which lane of which block of which kind of leaves. Given by value, so that it can stay in
/// registers: what is put together in memory is not copied before it has got there.
struct place_in_leaves {
    std::size_t kind;
    std::uint32_t block;
    unsigned lane;
    std::uint32_t id;
};

/// The leaves of all kinds, and the leaf that a child is.
template <class... Leaves>
class leaf_kinds {
public:
    static_assert(sizeof...(Leaves) <= 16);

    std::tuple<Leaves...> all;

    /// Is what the packs find believed, whatever is hit?
    static constexpr bool are_quick = (is_quick<typename Leaves::shape_type> && ...);

    /// Do packs know anything of the shapes of that kind?
    template <std::size_t Kind, class Ray>
    static constexpr bool filters = requires(const std::tuple_element_t<Kind, std::tuple<Leaves...>> leaves,
                                             const Ray& ray) {
        leaves.find(0, ray, 0, 0);
    };

    /// What packs say of the shapes of a leaf; if they do not know, all of them are open.
    template <std::size_t Kind, class T, class Ray>
    auto find(std::uint32_t i, const Ray& ray, T t_min, T t_max) const {
        const auto& leaves = std::get<Kind>(all);
        if constexpr (filters<Kind, Ray>) {
            return leaves.find(i, ray, t_min, t_max);
        } else {
            return findings<T, std::remove_cvref_t<decltype(leaves)>::lanes>{
                .sure = 0, .open = leaves.used(i), .low = {}, .high = {}};
        }
    }

    template <std::size_t Kind>
    place_in_leaves place(std::uint32_t block, unsigned lane) const {
        return {Kind, block, lane, std::get<Kind>(all).id(block, lane)};
    }

    /// What `hit` records of the shape at that place, which is known to be hit.
    /// \param t  where packs have found that
    template <class Ray, class T, record Record>
    void record_at(const place_in_leaves& at, const Ray& ray, T t_min, T t_max, [[maybe_unused]] T t,
                   Record& rec) const {
        with_kind(static_cast<std::uint32_t>(at.kind), [&](auto kind) {
            const auto& shape = std::get<kind()>(all).shape(at.block, at.lane);
            using Shape = std::remove_cvref_t<decltype(shape)>;
            if constexpr (is_quick<Shape>) {
                shape.record_at(ray, t, rec);
            } else if constexpr (gatherable<Shape>) {
                first_hit<question::only_where>(shape, ray, t_min, t_max, rec);  // packs are certain of it
            } else {
                detail::hit(shape, ray, t_min, t_max, rec);
            }
        });
        put_index(rec, at.id);
    }

    /// Is the shape at that place, which is hit at t, seen from its front?
    /// \param seen  room for what is recorded of it
    template <class Ray, class T, record Record>
    bool shows_front(const place_in_leaves& at, const Ray& ray, [[maybe_unused]] T t_min, T t, Record seen) const {
        return with_kind(static_cast<std::uint32_t>(at.kind), [&](auto kind) {
            const auto& shape = std::get<kind()>(all).shape(at.block, at.lane);
            if constexpr (is_quick<std::remove_cvref_t<decltype(shape)>>) {
                shape.record_at(ray, t, seen);
                return bool(seen.front_face);
            } else {
                return detail::hit(shape, ray, t_min, t, seen) && bool(seen.front_face);
            }
        });
    }

    /// `hit` of the shape at that place.
    template <std::size_t Kind, class Ray, class T, record Record>
    bool hit(const place_in_leaves& at, const Ray& ray, T t_min, T t_max, Record& rec) const {
        const bool met = detail::hit(std::get<Kind>(all).shape(at.block, at.lane), ray, t_min, t_max, rec);
        if (met) put_index(rec, at.id);
        return met;
    }

    /// Calls `visit` with the number of the kind, as a constant.
    template <class Visit>
    static auto with_kind(std::uint32_t kind, Visit visit) {
        return choose<0>(kind, visit);
    }

private:
    template <std::size_t I, class Visit>
    static auto choose(std::uint32_t kind, Visit& visit) {
        if constexpr (I + 1 < sizeof...(Leaves)) {
            if (kind != I) return choose<I + 1>(kind, visit);
        }
        return visit(std::integral_constant<std::size_t, I>{});
    }
};

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
