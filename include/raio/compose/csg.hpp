#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/proof/mapped_ray.hpp>

/// \file
/// Constructive solid geometry: what is inside two solids, in one or the other, or in one but not the other.
///
/// A ray is inside a solid between the ends of its spans; the spans of both, united, intersected or subtracted, are
/// those of the composition (Roth, Computer Graphics and Image Processing 18, 1982). A solid's ends are what its hits
/// record for t: so A - A is empty, and every end is a crossing of one of the leaves, which is asked for its point,
/// normal and uv at just this t. Of floats these are correctly rounded: where the surfaces of two solids meet, their
/// ends are equal. Of doubles they are if the same formula finds them; of others a sliver of a few last places may be
/// left.
///
/// Spans are closed: solids that touch have the points in common that they touch in. What is subtracted takes its
/// surface along: the inside of the hole is front, as seen from the hole. A line that is inside before a point and
/// behind it crosses nothing there: one that only touches a hole, or goes from one solid into another where their
/// surfaces meet.
///
/// `hit_record::index` counts the leaves of the tree from left to right. Of two leaves that cross at the same t the
/// left one is recorded.

namespace raio::inline RAIO_ABI {

enum class set_operation { unite, intersect, subtract };

namespace detail {

/// An end of an interval, which knows whose surface it lies on. Compared by t.
template <real T>
struct leaf_end {
    T t;
    index_t<T> leaf;

    RAIO_FN constexpr leaf_end operator-() const { return {-t, leaf}; }
    RAIO_FN friend constexpr bool operator<(const leaf_end& a, const leaf_end& b) { return a.t < b.t; }
    RAIO_FN friend constexpr bool operator<=(const leaf_end& a, const leaf_end& b) { return a.t <= b.t; }
    RAIO_FN friend constexpr bool operator>(const leaf_end& a, const leaf_end& b) { return a.t > b.t; }
    RAIO_FN friend constexpr leaf_end min(const leaf_end& a, const leaf_end& b) { return b < a ? b : a; }
    RAIO_FN friend constexpr leaf_end max(const leaf_end& a, const leaf_end& b) { return a < b ? b : a; }
};

}  // namespace detail

template <real T>
inline constexpr detail::leaf_end<T> infinity<detail::leaf_end<T>>{infinity<T>, {}};

namespace detail {

template <class P>
concept csg_tree = requires(const P tree) {
    tree.leaves();
};

template <solid P>
RAIO_FN constexpr index_t<number_t<P>> leaf_count(const P& shape) {
    if constexpr (csg_tree<P>) {
        return shape.leaves();
    } else {
        return 1;
    }
}

/// The spans of a tree or of a leaf, whose leaves are counted from `first` on.
template <solid P, class Ray>
RAIO_FN constexpr auto ends_of(const P& shape, const Ray& ray, index_t<number_t<P>> first) {
    if constexpr (csg_tree<P>) {
        return shape.ends(ray, first);
    } else {
        using T = number_t<P>;
        return spans(spans_of(shape, ray)).each([&](const interval<T>& i) {
            return interval<leaf_end<T>>{{i.min, first}, {i.max, first}};
        });
    }
}

/// The crossing at t, which is known to be one.
template <primitive P, class Ray, record Record>
RAIO_FN constexpr mask_t<number_t<P>> hit_at(const P& shape, const Ray& ray, number_t<P> t, Record& rec) {
    if constexpr (requires { shape.record_at(ray, t, rec); }) {
        shape.record_at(ray, t, rec);
        return is_finite(t);
    } else {
        return detail::hit(shape, ray, t, t, rec);
    }
}

/// Can a solid be made of what they hold?
template <class A, class B>
concept solids_to_compose = solid<held_t<A>> && solid<held_t<B>> && of_one_number_type<held_t<A>, held_t<B>>;

}  // namespace detail

/// Two solids and what is made of them; again a solid. Each of them is a primitive, or a pointer to one that is shared.
template <set_operation Operation, holder A, holder B>
requires detail::solids_to_compose<A, B>
struct csg {
    using number = number_t<detail::held_t<A>>;
    using T = number;

    A a;
    B b;

    template <ray_of<T> Ray = raio::ray<T>, record Record>
    RAIO_FN constexpr mask_t<T> hit(const Ray& ray, T t_min, T t_max, Record& rec) const {
        return first_end(ray, t_min, t_max, [&](const detail::leaf_end<T>& end, bool entering) {
            const bool met =
                ask_leaf(end.leaf, [&](const auto& leaf) { return detail::hit_at(leaf, ray, end.t, rec); });
            if (!met) return false;
            detail::put_index(rec, end.leaf);
            if constexpr (has_front_face<Record>) detail::put(rec.front_face, entering);
            return true;
        });
    }

    template <ray_of<T> Ray = raio::ray<T>>
    RAIO_FN constexpr mask_t<T> occluded(const Ray& ray, T t_min, T t_max) const {
        return first_end(ray, t_min, t_max, [](const detail::leaf_end<T>& end, bool) { return is_finite(end.t); });
    }

    template <ray_of<T> Ray = raio::ray<T>>
    RAIO_FN constexpr auto spans(const Ray& ray) const {
        return ends(ray, 0).each([](const auto& i) { return interval<T>{i.min.t, i.max.t}; });
    }

    RAIO_FN constexpr aabb<T> bounds() const requires(bounded<detail::held_t<A>>&& bounded<detail::held_t<B>>) {
        const aabb<T> of_a = detail::held(a).bounds(), of_b = detail::held(b).bounds();
        if constexpr (Operation == set_operation::unite) return hull(of_a, of_b);
        if constexpr (Operation == set_operation::subtract) return unless_nan(of_a, of_b);
        return padded(overlap(of_a, of_b));  // a point that was rounded onto one box may lie beyond the other
    }

    /// How many leaves the tree has.
    RAIO_FN constexpr index_t<T> leaves() const {
        return detail::leaf_count(detail::held(a)) + detail::leaf_count(detail::held(b));
    }

    /// The spans, with the leaf of each end.
    template <class Ray>
    RAIO_FN constexpr auto ends(const Ray& ray, index_t<T> first) const {
        const auto in_a = detail::ends_of(detail::held(a), ray, first);
        const auto combined = [&](const auto& in_b) {
            if constexpr (Operation == set_operation::unite) {
                return unite(in_a, in_b);
            } else if constexpr (Operation == set_operation::intersect) {
                return intersect(in_a, in_b);
            } else {
                return subtract(in_a, in_b);
            }
        };
        using in_b = decltype(detail::ends_of(detail::held(b), ray, first));
        if (in_a.empty() && Operation != set_operation::unite) return combined(in_b());
        return combined(detail::ends_of(detail::held(b), ray, first + detail::leaf_count(detail::held(a))));
    }

    /// What `ask` answers of one leaf.
    template <class Ask>
    RAIO_FN constexpr bool ask_leaf(index_t<T> leaf, Ask ask) const {
        const auto in = [&](const auto& shape, index_t<T> nth) {
            if constexpr (detail::csg_tree<std::remove_cvref_t<decltype(shape)>>) {
                return shape.ask_leaf(nth, ask);
            } else {
                return ask(shape);
            }
        };
        const index_t<T> of_a = detail::leaf_count(detail::held(a));
        return leaf < of_a ? in(detail::held(a), leaf) : in(detail::held(b), leaf - of_a);
    }

private:
    /// Calls `accept` with the ends in the window, one after the other, until it answers true.
    template <class Ray, class Accept>
    RAIO_FN constexpr bool first_end(const Ray& ray, T t_min, T t_max, Accept accept) const {
        for (const auto& i : ends(ray, 0)) {
            if (t_min <= i.min.t && i.min.t <= t_max && accept(i.min, true)) return true;
            if (t_min <= i.max.t && i.max.t <= t_max && accept(i.max, false)) return true;
        }
        return false;
    }
};

/// Inside `a` or `b`.
template <holder A, holder B>
requires detail::solids_to_compose<A, B> RAIO_FN constexpr auto union_of(A a, B b) {
    return csg<set_operation::unite, A, B>{std::move(a), std::move(b)};
}
/// Inside both.
template <holder A, holder B>
requires detail::solids_to_compose<A, B> RAIO_FN constexpr auto intersection_of(A a, B b) {
    return csg<set_operation::intersect, A, B>{std::move(a), std::move(b)};
}
/// Inside `a` and not inside `b`.
template <holder A, holder B>
requires detail::solids_to_compose<A, B> RAIO_FN constexpr auto difference_of(A a, B b) {
    return csg<set_operation::subtract, A, B>{std::move(a), std::move(b)};
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
