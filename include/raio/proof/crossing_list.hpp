#pragma once

#include <raio/math/polynomial_roots.hpp>
#include <raio/proof/settle.hpp>

/// \file
/// More than two crossings of one line, and how they are settled.

namespace raio {

/// The crossings of one line with a surface, in order. All that are listed exist in the precision of W.
template <class W, std::size_t N>
struct crossing_list {
    std::array<crossing<W>, N> crossings;  ///< what is beyond `count` has no value
    std::size_t count = 0;
    bool certain = true;  ///< are these all, and are they there, whatever the rounding errors were?

    crossing_list() = default;
    /// None.
    RAIO_FN constexpr explicit crossing_list(bool is_certain) : certain(is_certain) {}

    RAIO_FN constexpr const crossing<W>* begin() const { return crossings.data(); }
    RAIO_FN constexpr const crossing<W>* end() const { return crossings.data() + count; }

    RAIO_FN constexpr void append(const W& t, const bound_t<W>& error, bool entering) {
        append(crossing<W>{true, true, t, error, entering});
    }
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
    RAIO_FN constexpr void append(const W& t, const bound_t<W>& error, const polynomial_root<W>& root) {
        const bool entering = root.before > 0 || (root.before == 0 && root.after < 0);
        append(t, error, entering);
        if (root.before * root.after > 0) append(t, error, !entering);
    }

    /// May the line start on the surface?
    RAIO_FN constexpr bool touches_origin() const {
        for (const crossing<W>& c : *this) {
            if (raio::touches_origin(c)) return true;
        }
        return false;
    }
    /// It does.
    RAIO_FN constexpr void start_at_origin() {
        for (std::size_t i = 0; i < count; ++i) raio::start_at_origin(crossings[i], true);
    }
};

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

/// Keeps only crossings whose point T can say.
template <real T, real R, class W, std::size_t N>
RAIO_FN constexpr void keep_if_reachable(const ray<R>& ray, crossing_list<W, N>& list) {
    std::size_t kept = 0;
    for (crossing<W> c : list) {
        keep_if_reachable<T>(ray, c);
        if (c.exists) list.crossings[kept++] = c;
    }
    list.count = kept;
}

/// Which roots x are wanted, where the crossings wanted are at t = middle + x half.
/// \param error  of t, besides the error of x times half
template <class W>
RAIO_FN constexpr wanted_roots<W> roots_for(const every_crossing&, const W&, const W&, const bound_t<W>&) {
    return {};
}
template <class W, real T>
RAIO_FN constexpr wanted_roots<W> roots_for(const first_from<T>& wanted, const W& middle, const W& half,
                                            const bound_t<W>& error) {
    using E = bound_t<W>;
    const E over_half = E(1) / E(half), in_e(16 * unit_roundoff<E>), in_t(2 * unit_roundoff<T>);
    const E begin(W(wanted.t_min)), end(W(wanted.t_max)), at = E(middle), off = error + in_e * abs(at);
    const E of_begin = off + in_t * abs(begin), of_end = off + in_t * abs(end);
    wanted_roots<W> roots{(begin - of_begin - at) * over_half - in_e, (begin + of_begin - at) * over_half + in_e};
    // What 2^-42 of the way leaves open, another precision decides, and it is less than a correction notices.
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
RAIO_FN constexpr detail::verdict<W> settled_in_window(const crossing_list<W, N>& list, T t_min, T t_max) {
    if (list.certain) {
        for (const crossing<W>& c : list) {
            detail::verdict<W> found = detail::settled_in_window<Asked>(c, t_min, t_max);
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
RAIO_FN constexpr bool are_all(const crossing_list<W, N>& list) {
    return list.certain;
}

namespace detail {

/// Can the shape's crossings be said as a list?
template <class Shape, class R>
concept lists_crossings = requires(const Shape shape, const ray<R> ray) {
    listed(shape.template crossings<exact_t<typename Shape::number>>(ray));
};

}  // namespace detail

/// Where the line is inside a solid: from where it enters to where it leaves next.
template <class Shape, real R>
requires detail::lists_crossings<Shape, R> RAIO_FN constexpr auto inside_of(const Shape& shape, const ray<R>& ray) {
    using T = typename Shape::number;
    using X = exact_t<T>;
    const auto exact = [&] { return shape.template crossings<X>(ray); };
    const auto room_for_half = []<class W, std::size_t N>(const crossing_list<W, N>&) { return spans<T, N / 2>(); };
    decltype(room_for_half(listed(exact()))) inside;
    T entered = -infinity<T>;
    const auto pass = [&](const auto& c) {
        if (!c.exists) return false;
        if (c.entering) {
            entered = T(c.t);
        } else {
            inside.append({entered, T(c.t)});
        }
        return false;
    };
    if constexpr (detail::works_first<T>) {
        detail::keep_as_stored<T>(shape, ray);
        detail::visit_recorded<T>(shape.template crossings<detail::quick_t<T, R>>(ray), exact, pass);
    } else {
        for (const crossing<X>& c : listed(exact())) pass(c);
    }
    return inside;
}

}  // namespace raio
