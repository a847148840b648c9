#pragma once

#include <raio/push_macros.hpp>

#include <utility>

#include <raio/math/polynomial_roots.hpp>
#include <raio/proof/settle.hpp>

/// \file
/// More than two crossings of one line, and how they are settled.

namespace raio::inline RAIO_ABI {

/// The crossings of one line with a surface, in order. All that are listed exist in the precision of W.
template <class W, std::size_t N>
struct crossing_list {
    std::array<crossing<W>, N> crossings;  ///< what is beyond `count` has no value
    std::size_t count = 0;
    bool certain = true;  ///< are these all, and are they there, whatever the rounding errors were?

    crossing_list() = default;
    /// None.
    RAIO_FN constexpr explicit crossing_list(bool is_certain) : certain(is_certain) {}
    /// None, as far as it is settled whether there may be some.
    RAIO_FN constexpr explicit crossing_list(const verdict<bool>& exist) : certain(is_settled(exist)) {}

    RAIO_FN constexpr const crossing<W>* begin() const { return crossings.data(); }
    RAIO_FN constexpr const crossing<W>* end() const { return crossings.data() + count; }

    RAIO_FN constexpr void append(const crossing<W>& c) {
        if (count < N) crossings[count++] = c;
    }

    /// Takes over the crossings of a part that is convex.
    RAIO_FN constexpr void append(const chord<W>& part) {
        certain = certain && part.near.certain && part.far.certain;
        if (part.near.exists) append(part.near);
        if (part.far.exists) append(part.far);
    }

    /// Takes over a root of a polynomial along the line that is positive outside. An extremum that cannot be told from
    /// zero is a tangent: the line crosses twice there.
    RAIO_FN constexpr void append(crossing<W> c, const polynomial_root<W>& root) {
        c.entering = root.is_entered();
        append(c);
        c.entering = !c.entering;
        if (root.is_touched()) append(c);
    }

    /// Puts a crossing where its t belongs.
    RAIO_FN constexpr void insert(const crossing<W>& c) {
        std::size_t i = count++;
        for (; i > 0 && c.t < crossings[i - 1].t; --i) crossings[i] = crossings[i - 1];
        crossings[i] = c;
    }

    /// Does what the crossings depend on hold? Where that is in doubt, so is the list.
    RAIO_FN constexpr bool holds(const verdict<bool>& condition) {
        depends_on(condition);
        return condition.yes;
    }

    /// What was decided on the way: where that is in doubt, so is the list.
    RAIO_FN constexpr void depends_on(const verdict<bool>& decided) { certain = certain && is_settled(decided); }
    /// The same of what was found on the way: roots, stretches, a part of the line.
    template <class Found>
    requires requires(const Found found) { bool(found.certain); }
    RAIO_FN constexpr void depends_on(const Found& found) { certain = certain && found.certain; }

    /// The line starts on the surface.
    RAIO_FN constexpr void start_at_origin() {
        for (std::size_t i = 0; i < count; ++i) raio::start_at_origin(crossings[i], true);
    }
};

/// Puts two crossings in order. What cannot be told apart keeps its order.
template <class W>
RAIO_FN constexpr void sort_by_t(crossing_list<W, 2>& list) {
    if (list.count < 2) return;
    auto& [first, second] = list.crossings;
    bound_t<W> apart(second.t - first.t), error = is_believed<W> ? bound_t<W>(0) : first.error + second.error;
    list.certain = list.certain && abs(apart) > error;
    if (apart < -error) {
        std::swap(first, second);
    } else if (apart < error) {
        second.t = first.t;
    }
}

/// A crossing that cannot be told from t = 0 is there, if the line starts on the surface.
/// \param starts  does it? Asked only then
template <class W, std::size_t N>
RAIO_FN constexpr void start_on_surface(crossing_list<W, N>& list, auto starts) {
    bool touches = false;
    for (const crossing<W>& c : list) touches = touches || touches_origin(c);
    if (touches && starts()) list.start_at_origin();
}

/// The same crossings as a list.
template <class W, std::size_t N>
RAIO_FN constexpr crossing_list<W, N> listed(const crossing_list<W, N>& list) {
    return list;
}
template <class W>
RAIO_FN constexpr crossing_list<W, 4> listed(const chord_pair<W>& c) {
    crossing_list<W, 4> list;
    list.append(c.first), list.append(c.second);
    return list;
}

/// Keeps only crossings whose point has coordinates in the range of T.
template <real T, class Line, class W, std::size_t N>
RAIO_FN constexpr void keep_if_in_range(const Line& line, crossing_list<W, N>& list) {
    std::size_t kept = 0;
    for (crossing<W> c : list) {
        keep_if_in_range<T>(line, c);
        if (c.exists) list.crossings[kept++] = c;
    }
    list.count = kept;
}

/// Which roots x are wanted, where the crossings wanted are at t = middle + x half.
template <class W>
RAIO_FN constexpr wanted_roots<W> roots_for(const every_crossing&, const bounded_number<W>&, const given_number<W>&) {
    return {};
}
template <class W, real T>
RAIO_FN constexpr wanted_roots<W> roots_for(const first_from<T>& wanted, const bounded_number<W>& middle,
                                            const given_number<W>& half) {
    using E = bound_t<W>;
    const E over_half = E(1) / E(half.value), in_e(16 * unit_roundoff<E>), in_t(2 * unit_roundoff<T>);
    const E begin(W(wanted.t_min)), end(W(wanted.t_max)), at(middle.value), off = middle.error + in_e * abs(at);
    const E of_begin = off + in_t * abs(begin), of_end = off + in_t * abs(end);
    wanted_roots<W> roots{(begin - of_begin - at) * over_half - in_e, (begin + of_begin - at) * over_half + in_e};
    // After such a step a root is known to 2^-42 of the way: what that leaves open, another precision decides.
    if constexpr (std::same_as<W, strict_double>) roots.last_step = E(0x1p-14);
    if (wanted.roughly) roots.to = is_finite(end) ? (end - of_end - at) * over_half - in_e : end;
    return roots;
}

// What `first_hit` and `any_hit` ask of a list; they find it by its argument.
template <real T, class W, std::size_t N>
RAIO_FN constexpr crossing<W> first_in_window(const crossing_list<W, N>& list, T t_min, T t_max) {
    for (const crossing<W>& c : list) {
        if (detail::in_window(c, t_min, t_max)) return c;
    }
    return {false, list.certain, W(0), bound_t<W>(0), false};
}
template <detail::question Asked, real T, class W, std::size_t N>
RAIO_FN constexpr detail::finding<W> settled_in_window(const crossing_list<W, N>& list, T t_min, T t_max) {
    if (list.certain) {
        for (const crossing<W>& c : list) {
            detail::finding<W> found = detail::settled_in_window<Asked>(c, t_min, t_max);
            if (found.first.exists || !found.known) return found;
        }
    }
    return {{false, list.certain, W(0), bound_t<W>(0), false}, list.certain};
}
template <class W, std::size_t N>
RAIO_FN constexpr const crossing_list<W, N>& in_order(const crossing_list<W, N>& list) {
    return list;
}
template <class W, std::size_t N>
RAIO_FN constexpr bool missed(const crossing_list<W, N>& list) {
    return list.certain && list.count == 0;
}
template <class W, std::size_t N>
RAIO_FN constexpr bool are_all(const crossing_list<W, N>& list) {
    return list.certain;
}

namespace detail {

/// Can the shape's crossings be said as a list? (Packs have none.)
template <class Shape, class Ray>
concept lists_crossings = !has_lanes<typename Shape::number> && requires(const Shape shape, const Ray& ray) {
    listed(shape.crossings(line_in<exact_t<typename Shape::number>>(ray)));
};

}  // namespace detail

/// Where the line is inside a solid whose crossings these are: from where it enters to where it leaves next.
template <real T, std::size_t N>
struct spans_of_crossings {
    spans<T, N / 2> inside;
    T entered = -infinity<T>;

    template <class W>
    RAIO_FN constexpr void take(const crossing<W>& c) {
        if (!c.exists) return;
        if (c.entering) {
            entered = T(c.t);
        } else {
            inside.append({entered, T(c.t)});
        }
    }
};

template <real T, class W, std::size_t N>
RAIO_FN constexpr spans<T, N / 2> spans_between(const crossing_list<W, N>& list) {
    spans_of_crossings<T, N> found;
    for (const crossing<W>& c : list) found.take(c);
    return found.inside;
}
template <real T, class W>
RAIO_FN constexpr spans<T, 2> spans_between(const chord_pair<W>& c) {
    return spans_between<T>(listed(c));
}

template <class Shape, class Ray>
requires detail::lists_crossings<Shape, Ray> RAIO_FN constexpr auto inside_of(const Shape& shape, const Ray& ray) {
    using T = typename Shape::number;
    using X = exact_t<T>;
    const auto exact = [&] { return shape.crossings(line_in<X>(ray)); };
    if constexpr (detail::works_first<T>) {
        const auto room = []<class W, std::size_t N>(const crossing_list<W, N>&) { return spans_of_crossings<T, N>(); };
        decltype(room(listed(exact()))) found;
        detail::keep_as_stored<T>(shape, unmapped(ray));
        detail::visit_recorded<T>(shape.crossings(line_in<working_t<T>>(ray)), exact, [&](const auto& c) {
            found.take(c);
            return false;
        });
        return found.inside;
    } else {
        return spans_between<T>(exact());
    }
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
