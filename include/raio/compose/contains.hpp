#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include <raio/concepts.hpp>

namespace raio {

namespace detail {

/// Rays along none of the axes, diagonals or other directions that shapes are made of.
template <class T>
inline constexpr std::array<vec3<T>, 8> any_directions{
    vec3<T>(T(0.5547), T(0.7193), T(0.4181)),   vec3<T>(T(-0.6121), T(0.3517), T(0.7083)),
    vec3<T>(T(0.2399), T(-0.8363), T(0.4931)),  vec3<T>(T(0.7687), T(0.1451), T(-0.6229)),
    vec3<T>(T(-0.3307), T(-0.5813), T(-0.744)), vec3<T>(T(-0.8839), T(0.4217), T(-0.2027)),
    vec3<T>(T(0.1153), T(0.9433), T(-0.3121)),  vec3<T>(T(0.4729), T(-0.3911), T(0.7897))};

/// Is the point inside from which a ray has met a closed surface there? Each passage is counted once: at an edge or a
/// vertex all faces that share it are met at one t. Nothing, if it is not known what happens at a vertex.
/// \param hits  all of them, sorted by t; on the surface is inside as well
/// \param last  says something in any case
template <class T>
std::optional<bool> is_inside(std::span<const hit_record<T>> hits, bool last) {
    bool inside = false;
    for (auto next = hits.begin(); next != hits.end();) {
        const auto end = std::find_if(next, hits.end(), [&](const auto& rec) { return rec.t != next->t; });
        const auto fronts = std::count_if(next, end, [](const auto& rec) { return rec.front_face; });
        const auto backs = end - next - fronts;
        if (next->t == T(0)) return true;
        if (fronts == 0 || backs == 0 || (last && fronts != backs)) {
            inside = !inside;
        } else if (!last && (fronts > 1 || backs > 1)) {
            return std::nullopt;
        }  // an edge that is touched, or a wall that is thinner than t tells
        next = end;
    }
    return inside;
}

/// The same of a surface. Where one ray meets vertices and leaves it open, another is asked.
/// \param all_hits  answers with those of a ray, sorted by t
template <class T, class AllHits>
bool is_inside_surface(const vec3<T>& point, AllHits all_hits) {
    for (const vec3<T>& direction : any_directions<T>) {
        const std::vector<hit_record<T>> hits = all_hits(ray<T>{point, direction});
        if (const auto inside = is_inside<T>(hits, &direction == &any_directions<T>.back())) return *inside;
    }
    return false;
}

}  // namespace detail

/// Is the point in the solid, or on its surface? As exact as a ray from there. (There is `contains` of closed meshes
/// and their trees as well.)
template <solid P>
RAIO_FN constexpr mask_t<number_t<P>> contains(const P& shape, const vec3<number_t<P>>& point) {
    using T = number_t<P>;
    return detail::spans_of(shape, ray<T>{point, vec3<T>(detail::any_directions<scalar_t<T>>[0])}).contains(T(0));
}

}  // namespace raio
