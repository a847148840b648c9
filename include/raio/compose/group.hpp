#pragma once

#include <raio/push_macros.hpp>

#include <ranges>
#include <span>
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

/// A record that `hit` can fill as that one, and that says which side is hit.
template <real T, record Record>
RAIO_FN constexpr auto with_side(const Record& rec) {
    if constexpr (has_front_face<Record>) {
        return rec;
    } else {
        return hit_record<T>{};
    }
}

/// Is t kept as it was found, to be read again?
template <class Record, class T>
concept keeps_t = requires(Record& rec) {
    requires std::same_as<std::remove_cvref_t<decltype(rec.t)>, T>;
};

/// `hit` of an aggregate that has to compare t, for a record that does not keep it.
template <class P, class Ray, real T, record Record>
RAIO_FN constexpr mask_t<T> hit_in_between(const P& shape, const Ray& ray, T t_min, T t_max, Record& rec) {
    hit_record<T> own;
    if (!shape.hit(ray, t_min, t_max, own)) return false;
    assign(rec, own);
    return true;
}

/// Of several primitives that are equally near, records the first that shows its front or, if none does, the first.
/// Out of line, as what is rare.
/// \param tied  the lanes in which more than one is met at rec.t
template <class Ray, real T, record Record, class ForEach>
RAIO_RARELY RAIO_FN constexpr void record_front_first(mask_t<T> tied, const Ray& ray, T t_min, Record& rec,
                                                      ForEach for_each) {
    const T t = select(tied, rec.t, t_min);
    for (int sweep = 0; sweep < 2 && any(tied); ++sweep) {
        const mask_t<T> any_side(sweep == 1);
        index_t<T> index{};
        for_each([&](const auto& primitive) {
            auto seen = with_side<T>(rec);
            const mask_t<T> met = tied && hit(primitive, ray, t_min, t, seen);
            const mask_t<T> first = met && (any_side || mask_t<T>(seen.front_face));
            if (any(first)) {
                if constexpr (has_lanes<T>) {
                    Record candidate = rec;
                    hit(primitive, ray, t_min, t, candidate);
                    put_index(candidate, index);
                    assign(first, rec, candidate);
                } else {
                    hit(primitive, ray, t_min, t, rec);
                    put_index(rec, index);
                }
                tied = tied && !first;
            }
            index = index + index_t<T>(1);
            return any(tied);
        });
    }
}

/// `hit` of several primitives, one after the other: the nearest is hit, of equally near ones the first that shows its
/// front or, if none does, the first.
/// \param for_each  calls what it is given with one primitive after the other
template <class Ray, real T, record Record, class ForEach>
RAIO_FN constexpr mask_t<T> hit_nearest(const Ray& ray, T t_min, T t_max, Record& rec, ForEach for_each) {
    mask_t<T> found = !(T(0) == T(0)), tied = found;
    index_t<T> index{};
    for_each([&](const auto& primitive) {
        if constexpr (std::floating_point<T>) {
            // What is as near as all before, or nearer, goes straight into the record: a miss writes nothing.
            if (hit(primitive, ray, t_min, t_max, rec)) {
                put_index(rec, index);
                tied = found && rec.t == t_max;
                t_max = rec.t;
                found = true;
            }
        } else {
            Record candidate;
            const mask_t<T> met = hit(primitive, ray, t_min, select(found, rec.t, t_max), candidate);
            const mask_t<T> nearer = met && (!found || candidate.t < rec.t);
            tied = !nearer && (tied || (met && candidate.t == rec.t));
            put_index(candidate, index);
            if (any(nearer)) assign(nearer, rec, candidate);
            found = found || nearer;
        }
        index = index + index_t<T>(1);
        return true;
    });
    if (any(tied)) [[unlikely]]
        record_front_first(tied, ray, t_min, rec, for_each);
    return found;
}

/// The primitive that a member of a group is, or that it is a range of.
template <class Member>
struct primitive_of {
    using type = Member;
};
template <class Member>
requires(!primitive<Member>) struct primitive_of<Member> {
    using type = std::ranges::range_value_t<Member>;
};

/// The shapes of a member of a group, be it a range or a single one.
template <class Member>
auto all_of(const Member& member) {
    if constexpr (primitive<Member>) {
        return std::span(&member, 1);
    } else {
        return std::span(member);
    }
}

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
