#pragma once

#include <raio/push_macros.hpp>

#include <ranges>
#include <tuple>
#include <utility>

#include <raio/concepts.hpp>
#include <raio/math/any_number_of_spans.hpp>
#include <raio/proof/mapped_ray.hpp>

namespace raio::inline RAIO_ABI {

/// What a group can hold: a primitive, or a range of primitives of one type.
template <class Member>
concept group_member = primitive<Member> || primitive<std::ranges::range_value_t<Member>>;

namespace detail {

/// The primitive that a member of a group is, or that it is a range of.
template <class Member>
struct primitive_of {
    using type = Member;
};
template <class Member>
requires(!primitive<Member>) struct primitive_of<Member> {
    using type = std::ranges::range_value_t<Member>;
};

}  // namespace detail

namespace detail {

/// How many intervals a ray can be inside a member.
template <class Member>
consteval std::size_t room_of_member() {
    using P = typename primitive_of<Member>::type;
    using T = number_t<P>;
    constexpr std::size_t one = room_in<decltype(spans_of(std::declval<const P&>(), std::declval<const ray<T>&>()))>;
    if constexpr (primitive<Member>) {
        return one;
    } else if constexpr (requires { std::tuple_size<Member>::value; }) {
        return one == any_number ? any_number : one * std::tuple_size<Member>::value;
    } else {
        return any_number;
    }
}

}  // namespace detail

/// Several primitives of several types, tested one after the other. The nearest is hit, of equally near ones the first
/// that shows its front and, if none does, the first.
///
///     raio::group scene{floor, spheres, triangles};   // a plane, a vector of spheres, a span of triangles
///
/// Each type stands in a range of its own, so that every loop is a plain loop over one type. `hit_record::index` counts
/// through all members in the order in which they were given; a group that is itself a member counts as one.
template <group_member First, group_member... Rest>
requires of_one_number_type < typename detail::primitive_of<First>::type,
typename detail::primitive_of<Rest>::type... > struct group {
    using number = number_t<typename detail::primitive_of<First>::type>;
    using T = number;

    static constexpr bool all_solid =
        solid<typename detail::primitive_of<First>::type> && (solid<typename detail::primitive_of<Rest>::type> && ...);

    std::tuple<First, Rest...> members;

    RAIO_FN constexpr group() = default;
    RAIO_FN constexpr explicit group(First first, Rest... rest) : members(std::move(first), std::move(rest)...) {}

    template <ray_of<T> Ray = raio::ray<T>, record Record>
    RAIO_FN constexpr mask_t<T> hit(const Ray& ray, T t_min, T t_max, Record& rec) const {
        if constexpr (!detail::keeps_t<Record, T>) {
            return detail::hit_in_between(*this, ray, t_min, t_max, rec);
        } else {
            return detail::hit_nearest(ray, t_min, t_max, rec, [&](auto visit) { for_each(visit); });
        }
    }

    template <ray_of<T> Ray = raio::ray<T>>
    RAIO_FN constexpr mask_t<T> occluded(const Ray& ray, T t_min, T t_max) const {
        mask_t<T> found = !(T(0) == T(0));
        for_each([&](const auto& primitive) {
            found = some(found, detail::occluded(primitive, ray, t_min, t_max));
            return !all(found);
        });
        return found;
    }

    /// Where the ray is inside any of the members, if all of them are solids.
    template <ray_of<T> Ray = raio::ray<T>>
    RAIO_FN constexpr auto spans(const Ray& ray) const requires all_solid {
        constexpr std::size_t rooms[] = {detail::room_of_member<First>(), detail::room_of_member<Rest>()...};
        constexpr std::size_t all = [&] {
            std::size_t sum = 0;
            for (const std::size_t each : rooms)
                sum = each == any_number || sum == any_number ? any_number : sum + each;
            return sum;
        }();
        raio::spans<T, all> inside;
        for_each([&](const auto& primitive) {
            for (const interval<T>& i : raio::spans(detail::spans_of(primitive, ray))) inside.insert(i);
            return true;
        });
        return inside;
    }

    RAIO_FN constexpr aabb<T> bounds() const requires(bounded<typename detail::primitive_of<First>::type> &&
                                                      (bounded<typename detail::primitive_of<Rest>::type> && ...)) {
        aabb<T> box;
        for_each([&](const auto& primitive) {
            box = hull(box, primitive.bounds());
            return true;
        });
        return box;
    }

private:
    /// Calls `visit` with one primitive after the other, as long as it answers true.
    template <class Visit>
    RAIO_FN constexpr void for_each(Visit visit) const {
        const auto visit_member = [&](const auto& member) {
            if constexpr (primitive<std::remove_cvref_t<decltype(member)>>) {
                return visit(member);
            } else {
                for (const auto& primitive : member) {
                    if (!visit(primitive)) return false;
                }
                return true;
            }
        };
        std::apply([&](const auto&... member) { (visit_member(member) && ...); }, members);
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
