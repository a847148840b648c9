#pragma once

#include <raio/push_macros.hpp>

#include <raio/bvh/assemble.hpp>
#include <raio/bvh/hit_list.hpp>
#include <raio/bvh/nearest.hpp>
#include <raio/bvh/nearest_together.hpp>
#include <raio/bvh/together.hpp>
#include <raio/compose/group.hpp>
#include <raio/compose/mesh.hpp>

namespace raio::inline RAIO_ABI::inline RAIO_REGISTERS {

/// A bounding volume hierarchy: many shapes, of one type or of several, that a ray asks only where it comes close.
///
///     raio::bvh<raio::triangle<float>> tree(triangles);
///     raio::bvh scene{raio::group{spheres, triangles}};    // two vectors: a bvh<sphere<float>, triangle<float>>
///
/// It answers what the plain loop over all shapes answers, bit for bit: the nearest is hit, of equally near ones the
/// first that shows its front and, if none does, the first. `hit_record::index` counts the shapes in the order in which
/// they were given. The tree has as many children a node as the processor's registers have lanes, and its leaves are
/// shapes in packs, eight together or, of those that take longer to test, one; they filter, and the plain shapes
/// decide. So boxes, tree and packs make it fast and nothing else. Of many equal shapes in one place the first is asked
/// for all of them.
///
/// The shapes are copied, but for those of a `bvh<mesh_triangle<T>>`. Every shape must have finite bounds; shapes
/// without any point are left out.
template <bounded P, bounded... Rest>
requires(std::floating_point<number_t<P>>&& of_one_number_type<P, Rest...>) class bvh {
    using leaves = typename detail::assembled<P, Rest...>::leaves_type;
    static constexpr std::size_t kind_count = 1 + sizeof...(Rest);
    static constexpr bool all_solid = solid<P> && (solid<Rest> && ...);

public:
    using number = number_t<P>;
    using T = number;

    bvh() = default;

    /// \param shapes  any range that stands in one piece: a vector, an array, a span, or a list in braces
    /// \throws std::invalid_argument  for a shape that is infinite or not a number, named by its index
    /// \throws std::length_error      for more than 2^27 shapes
    explicit bvh(std::span<const P> shapes, const bvh_options& options = {}) requires(sizeof...(Rest) == 0) {
        tree_.build(std::tuple(shapes), options);
    }
    template <std::size_t N>
    explicit bvh(const P (&shapes)[N], const bvh_options& options = {}) requires(sizeof...(Rest) == 0)
        : bvh(std::span<const P>(shapes), options) {}

    /// \throws  the same
    template <class... Members>
    requires(sizeof...(Members) == kind_count) explicit bvh(const group<Members...>& shapes,
                                                            const bvh_options& options = {}) {
        std::apply([&](const auto&... member) { tree_.build(std::tuple(detail::all_of(member)...), options); },
                   shapes.members);
    }

    /// The triangles of a mesh; what it has beside them is not taken. A tree of `mesh_triangle` leaves the corners
    /// where they are, and the mesh has to live longer. \throws  the same, and what `mesh::check` throws
    explicit bvh(const mesh<T>& of, const bvh_options& options = {}) requires(sizeof...(Rest) == 0) {
        of.check();
        tree_.build(std::tuple(detail::triangles_as<P>{of}), options);
    }

    /// The same shapes at other places: the tree stays, its boxes follow. The farther they go, the more the tree costs.
    /// \throws std::invalid_argument  if they are not as many as before, and what the constructor throws; then nothing
    /// has changed
    void refit(std::span<const P> shapes) requires(sizeof...(Rest) == 0) { tree_.refit(std::tuple(shapes)); }
    template <class... Members>
    requires(sizeof...(Members) == kind_count) void refit(const group<Members...>& shapes) {
        std::apply([&](const auto&... member) { tree_.refit(std::tuple(detail::all_of(member)...)); }, shapes.members);
    }
    void refit(const mesh<T>& of) requires(sizeof...(Rest) == 0) {
        of.check();
        tree_.refit(std::tuple(detail::triangles_as<P>{of}));
    }

    template <ray_of<T> Ray = raio::ray<T>, record Record>
    RAIO_FLATTEN bool hit(const Ray& ray, T t_min, T t_max, Record& rec) const {
        if constexpr (!detail::keeps_t<Record, T>) {
            return detail::hit_in_between(*this, ray, t_min, t_max, rec);
        } else {
            detail::nearest<T, leaves, Ray, Record> query(tree_.leaves, ray, t_min, t_max, rec);
            T far = t_max;
            visit_leaves<false>(ray, t_min, far, [&](auto kind, std::uint32_t block) {
                query.template visit<kind()>(block);
                far = query.farthest();
                return true;
            });
            return query.finish();
        }
    }

    template <ray_of<T> Ray = raio::ray<T>>
    RAIO_FLATTEN bool occluded(const Ray& ray, T t_min, T t_max) const {
        bool found = false;
        visit_leaves<true>(ray, t_min, t_max, [&](auto kind, std::uint32_t block) {
            found = meets_any<kind()>(block, ray, t_min, t_max);
            return !found;
        });
        return found;
    }

    /// What `hit` answers for each of at most 64 rays, one bit for each that hits, the first the lowest. Rays that run
    /// side by side, as those of neighbouring pixels, go through the tree together.
    ///
    /// \param recs  as many; those of rays that miss are left as they are
    std::uint64_t hit(std::span<const ray<T>> rays, T t_min, T t_max, std::span<hit_record<T>> recs) const {
        return detail::for_each_bundle(rays, [&](std::span<const ray<T>> some, std::size_t first) {
            const detail::rays_in_lanes<T> lanes(some);
            detail::nearest_together<T, leaves> query(tree_.leaves, some, lanes, t_min, t_max,
                                                      recs.subspan(first, some.size()));
            const bool together = detail::visit_leaves_together(
                tree_, lanes, some.size(), t_min, t_max,
                [&](auto kind, std::uint32_t block, std::uint64_t of, auto near) {
                    query.template visit<kind()>(block, of, near);
                },
                [&](std::size_t i) { return query.farthest(i); });
            if (together) return query.finish();
            return detail::answer_apart(
                some,
                [&](std::size_t from, std::size_t count) {
                    return hit(some.subspan(from, count), t_min, t_max, recs.subspan(first + from, count));
                },
                [&](std::size_t i) { return hit(some[i], t_min, t_max, recs[first + i]); });
        });
    }

    /// What `occluded` answers for each of at most 64 rays, likewise.
    std::uint64_t occluded(std::span<const ray<T>> rays, T t_min, T t_max) const {
        return detail::for_each_bundle(rays, [&](std::span<const ray<T>> some, std::size_t) {
            std::array<bool, detail::ray_bundle::most> found{};
            const auto visit = [&](auto kind, std::uint32_t block, std::uint64_t of, auto) {
                for (; of != 0; of &= of - 1) {
                    const auto i = static_cast<std::size_t>(std::countr_zero(of));
                    found[i] = meets_any<kind()>(block, some[i], t_min, t_max);
                }
            };
            const bool together =
                detail::visit_leaves_together(tree_, detail::rays_in_lanes<T>(some), some.size(), t_min, t_max, visit,
                                              [&](std::size_t i) { return found[i] ? -infinity<T> : t_max; });
            if (together) return detail::bits_of(some.size(), [&](std::size_t i) { return found[i]; });
            return detail::answer_apart(
                some,
                [&](std::size_t from, std::size_t count) { return occluded(some.subspan(from, count), t_min, t_max); },
                [&](std::size_t i) { return occluded(some[i], t_min, t_max); });
        });
    }

    /// The nearest crossings that `accept` takes, in order, as many as there is room for in `found`; answers how many.
    /// A shape that is crossed twice counts twice.
    /// \param accept  is asked with a hit_record: a mask, or a texture with holes. It may be asked more than once
    template <class Accept = bool (*)(const hit_record<T>&)>
    std::size_t nearest_hits(
        const ray<T>& ray, T t_min, T t_max, std::span<hit_record<T>> found,
        Accept accept = [](const hit_record<T>&) { return true; }) const {
        if (found.empty()) return 0;
        detail::nearest_few<T> few(found, t_max);
        collect(ray, t_min, t_max, few, accept);
        return few.count();
    }

    /// All crossings, in order. (At an edge that triangles share there is one of each: see `passages`.)
    std::vector<hit_record<T>> all_hits(const ray<T>& ray, T t_min, T t_max) const {
        detail::all_hits<T> all(t_max);
        collect(ray, t_min, t_max, all, [](const hit_record<T>&) { return true; });
        return std::move(all).sorted();
    }

    /// The nearest that `accept` takes.
    template <std::predicate<const hit_record<T>&> Accept>
    bool hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec, Accept accept) const {
        return nearest_hits(ray, t_min, t_max, std::span(&rec, 1), accept) != 0;
    }

    /// Is there any that `accept` takes?
    template <std::predicate<const hit_record<T>&> Accept>
    bool occluded(const ray<T>& ray, T t_min, T t_max, Accept accept) const {
        bool found = false;
        visit_leaves<true>(ray, t_min, t_max, [&](auto kind, std::uint32_t block) {
            for_each_shape<kind()>(block, ray, t_min, t_max, [&](const auto& shape, std::uint32_t id) {
                detail::for_each_crossing(shape, ray, t_min, t_max, id, [&](const hit_record<T>& rec) {
                    found = accept(rec);
                    return !found;
                });
                return !found;
            });
            return !found;
        });
        return found;
    }

    /// Where the ray is inside any of the shapes, if all of them are solids: so a tree can be cut from a solid, or met
    /// with one, by `csg`.
    template <ray_of<T> Ray = raio::ray<T>>
    raio::spans<T, any_number> spans(const Ray& ray) const requires all_solid {
        std::vector<interval<T>> found;
        const T from = -infinity<T>, to = infinity<T>;
        visit_leaves<true>(ray, from, to, [&](auto kind, std::uint32_t block) {
            for_each_lane<kind()>(block, ray, from, to, [&](const auto& shape, std::uint32_t) {
                for (const interval<T>& i : raio::spans(detail::spans_of(shape, ray))) found.push_back(i);
                return true;
            });
            return true;
        });
        std::ranges::sort(found, {}, &interval<T>::min);
        raio::spans<T, any_number> inside;
        for (const interval<T>& i : found) inside.append(i);
        return inside;
    }

    aabb<T> bounds() const { return tree_.bounds; }

    /// What a ray through `bounds` costs, by the surface area heuristic, in tests of a node.
    double cost() const { return tree_.cost; }

    /// How much memory the tree takes, the shapes included.
    std::size_t bytes() const { return tree_.bytes(); }

private:
    /// Is any shape of a leaf hit?
    template <std::size_t Kind, class Ray>
    bool meets_any(std::uint32_t block, const Ray& ray, T t_min, T t_max) const {
        auto findings = tree_.leaves.template find<Kind>(block, ray, t_min, t_max);
        bool found = findings.sure != 0;
        for (; !found && findings.open != 0; findings.open &= findings.open - 1) {
            const auto lane = static_cast<unsigned>(std::countr_zero(findings.open));
            found = detail::occluded(std::get<Kind>(tree_.leaves.all).shape(block, lane), ray, t_min, t_max);
        }
        return found;
    }

    /// Calls `visit` with the shapes of a leaf that may be crossed, and their ids, as long as it answers true.
    template <std::size_t Kind, class Ray, class Visit>
    void for_each_lane(std::uint32_t block, const Ray& ray, T t_min, T t_max, Visit visit) const {
        const auto found = tree_.leaves.template find<Kind>(block, ray, t_min, t_max);
        const auto& own = std::get<Kind>(tree_.leaves.all);
        for (std::uint32_t left = found.sure | found.open; left != 0; left &= left - 1) {
            const auto lane = static_cast<unsigned>(std::countr_zero(left));
            if (!visit(own.shape(block, lane), own.id(block, lane))) return;
        }
    }

    /// The same, and with those for which they stand.
    template <std::size_t Kind, class Ray, class Visit>
    void for_each_shape(std::uint32_t block, const Ray& ray, T t_min, T t_max, Visit visit) const {
        for_each_lane<Kind>(block, ray, t_min, t_max, [&](const auto& shape, std::uint32_t id) {
            return visit(shape, id) &&
                   tree_.equals[Kind].for_each_equal(id, [&](std::uint32_t equal) { return visit(shape, equal); });
        });
    }

    template <class Hits, class Accept>
    void collect(const ray<T>& ray, T t_min, T t_max, Hits& hits, Accept accept) const {
        T far = t_max;
        visit_leaves<false>(ray, t_min, far, [&](auto kind, std::uint32_t block) {
            for_each_shape<kind()>(block, ray, t_min, far, [&](const auto& shape, std::uint32_t id) {
                detail::for_each_crossing(shape, ray, t_min, far, id, [&](const hit_record<T>& rec) {
                    if (accept(rec)) hits.add(rec);
                    far = hits.farthest();
                    return true;
                });
                return true;
            });
            return true;
        });
    }

    /// Calls `visit` with all leaves that the ray may meet.
    /// \param t_max  may be brought nearer by `visit`
    template <bool Any, class Ray, class Visit>
    void visit_leaves(const Ray& ray, T t_min, const T& t_max, Visit visit) const {
        if (tree_.nodes.empty() || !(t_min <= t_max)) return;
        const detail::node_ray boxes(ray, tree_.scale, tree_.size);
        if (!boxes.fits() && !detail::runs(ray)) return;
        float far = detail::rounded_up(t_max);
        const float near = detail::rounded_down(t_min);
        const auto visit_leaf = [&](std::uint32_t leaf) {
            const bool go_on = leaves::with_kind(detail::child::kind(leaf),
                                                 [&](auto kind) { return visit(kind, detail::child::block(leaf)); });
            far = detail::rounded_up(t_max);
            return go_on;
        };
        if constexpr (Any) {
            detail::traverse_any(tree_.nodes, boxes, near, far, visit_leaf);
        } else {
            detail::traverse(tree_.nodes, boxes, near, far, visit_leaf);
        }
    }

    detail::assembled<P, Rest...> tree_;
};

template <std::ranges::contiguous_range Shapes>
bvh(const Shapes&, const bvh_options& = {}) -> bvh<std::ranges::range_value_t<Shapes>>;
template <class P, std::size_t N>
bvh(const P (&)[N], const bvh_options& = {}) -> bvh<P>;  // which a list in braces is as well
template <real T>
bvh(const mesh<T>&, const bvh_options& = {}) -> bvh<triangle<T>>;
template <class... Members>
bvh(const group<Members...>&, const bvh_options& = {}) -> bvh<typename detail::primitive_of<Members>::type...>;

}  // namespace raio::inline RAIO_ABI::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
