#pragma once

#include <raio/push_macros.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <iterator>
#include <optional>
#include <span>
#include <vector>

#include <raio/concepts.hpp>

/// \file
/// What is inside of a closed surface, and where a ray passes through it.
///
/// At an edge or a vertex all faces that share it are met at one t, and are one passage, or none where the surface is
/// touched. It is a passage if all show the same side. Whatever else happens there is not known from that, nor where
/// passages do not go in and out by turns: where a ray runs in the plane of a face, or where the t of two faces that
/// share an edge have been rounded apart.

namespace raio::inline RAIO_ABI {

/// A surface that tells all crossings with a ray, and has no inside of its own: a mesh, or the tree of one.
template <class P>
concept surface_of_many =
    primitive<P> && !solid<P> && requires(const P surface, const ray<number_t<P>> ray, number_t<P> t) {
    { surface.all_hits(ray, t, t) } -> std::same_as<std::vector<hit_record<number_t<P>>>>;
};

namespace detail {

/// One direction, and others where that leaves something open.
template <class T>
inline constexpr std::array<vec3<T>, 8> any_directions{any_direction<T>(),
                                                       vec3<T>(T(-0.6121), T(0.3517), T(0.7083)),
                                                       vec3<T>(T(0.2399), T(-0.8363), T(0.4931)),
                                                       vec3<T>(T(0.7687), T(0.1451), T(-0.6229)),
                                                       vec3<T>(T(-0.3307), T(-0.5813), T(-0.744)),
                                                       vec3<T>(T(-0.8839), T(0.4217), T(-0.2027)),
                                                       vec3<T>(T(0.1153), T(0.9433), T(-0.3121)),
                                                       vec3<T>(T(0.4729), T(-0.3911), T(0.7897))};

/// What a ray meets at one t.
template <class T>
struct met_at_once {
    std::span<const hit_record<T>> hits;  ///< the fronts first
    std::size_t fronts;

    T t() const { return hits[0].t; }
    std::size_t backs() const { return hits.size() - fronts; }
    bool passes() const { return fronts == 0 || backs() == 0; }
};

/// \param hits  sorted
template <class T>
std::vector<met_at_once<T>> by_t(std::span<const hit_record<T>> hits) {
    std::vector<met_at_once<T>> all;
    for (auto next = hits.begin(); next != hits.end();) {
        const auto end = std::find_if(next, hits.end(), [&](const auto& rec) { return rec.t != next->t; });
        const auto fronts = std::count_if(next, end, [](const auto& rec) { return rec.front_face; });
        all.push_back({{next, end}, static_cast<std::size_t>(fronts)});
        next = end;
    }
    return all;
}

/// The passages among them, the first hit of each. Nothing, if it is not known which are.
template <class T>
std::optional<std::vector<hit_record<T>>> known_passages(std::span<const met_at_once<T>> met) {
    std::vector<hit_record<T>> all;
    for (const met_at_once<T>& at : met) {
        const hit_record<T>& first = at.hits[0];
        if (!at.passes() || (!all.empty() && all.back().front_face == first.front_face)) return std::nullopt;
        all.push_back(first);
    }
    return all;
}

}  // namespace detail

/// Is the point inside of a closed surface, or on it? The fronts may be inside or outside, if neighbours agree. As
/// exact as a ray from there: by whether it passes through the surface an odd number of times. Where one ray leaves
/// that open another is asked.
template <surface_of_many P>
bool contains(const P& closed, const vec3<number_t<P>>& point) {
    using T = number_t<P>;
    bool inside = false;
    for (const vec3<T>& direction : detail::any_directions<T>) {
        const std::vector<hit_record<T>> hits = closed.all_hits({point, direction}, T(0), infinity<T>);
        if (!hits.empty() && hits[0].t == T(0)) return true;
        const auto met = detail::by_t<T>(hits);
        if (const auto passages = detail::known_passages<T>(met)) return passages->size() % 2 == 1;
        inside = std::ranges::count_if(met, [](const auto& at) { return at.fronts != at.backs(); }) % 2 == 1;
    }
    return inside;
}

/// Where a ray passes through a closed surface, in order, in and out by turns: one record for each passage, however
/// many faces share the edge or the vertex in which the surface is met there. Where it is touched only there is none,
/// nor are there any of a wall that is thinner than t tells. As exact as `contains`, which is asked where faces do not
/// tell by themselves.
template <surface_of_many P>
std::vector<hit_record<number_t<P>>> passages(const P& closed, const ray<number_t<P>>& ray, number_t<P> t_min,
                                              number_t<P> t_max) {
    using T = number_t<P>;
    const std::vector<hit_record<T>> hits = closed.all_hits(ray, t_min, t_max);
    if (auto known = detail::known_passages<T>(detail::by_t<T>(hits))) return std::move(*known);

    // What is between two places in which the surface is met lies inside or outside, all of it. Places that round to
    // one point are one.
    const std::vector<hit_record<T>> all = closed.all_hits(ray, -infinity<T>, infinity<T>);
    std::vector<hit_record<T>> found;
    bool inside = false;
    for (auto first = all.begin(); first != all.end();) {
        const auto at = ray.at(first->t);
        const auto end = std::find_if(first, all.end(), [&](const auto& rec) { return ray.at(rec.t) != at; });
        bool next = false;
        if (end != all.end()) {
            const T before = std::prev(end)->t;
            next = contains(closed, ray.at(before + (end->t - before) / T(2)));
        }
        if (next != inside) {  // who enters meets a front, if there is one
            const auto face = std::find_if(first, end, [&](const auto& rec) { return rec.front_face == next; });
            const hit_record<T>& rec = face != end ? *face : *first;
            if (t_min <= rec.t && rec.t <= t_max) found.push_back(rec);
        }
        inside = next, first = end;
    }
    return found;
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
