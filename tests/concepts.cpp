#include <raio/concepts.hpp>

#include <span>
#include <vector>

#include <raio/raio.hpp>

// What the documentation says of each shape.
namespace raio::test {

template <class T>
struct who_is_what {
    static_assert(primitive<sphere<T>> && bounded<sphere<T>> && solid<sphere<T>> && sampleable<sphere<T>>);
    static_assert(primitive<plane<T>> && bounded<plane<T>> && !solid<plane<T>> && !sampleable<plane<T>>);
    static_assert(primitive<disc<T>> && bounded<disc<T>> && !solid<disc<T>> && sampleable<disc<T>>);
    static_assert(primitive<triangle<T>> && bounded<triangle<T>> && !solid<triangle<T>> && sampleable<triangle<T>>);
    static_assert(primitive<watertight_triangle<T>> && bounded<watertight_triangle<T>>);
    static_assert(!solid<watertight_triangle<T>> && sampleable<watertight_triangle<T>>);
    static_assert(bounded<bilinear_patch<T>> && !solid<bilinear_patch<T>> && !sampleable<bilinear_patch<T>>);
    static_assert(bounded<heightfield<T>> && !solid<heightfield<T>> && std::is_aggregate_v<heightfield<T>>);
    static_assert(bounded<bezier_curve<T>> && solid<bezier_curve<T>> && std::is_aggregate_v<bezier_curve<T>>);
    static_assert(bounded<round_cone<T>> && solid<round_cone<T>> && sampleable<round_cone<T>>);
    static_assert(bounded<parallelogram<T>> && !solid<parallelogram<T>> && sampleable<parallelogram<T>>);
    static_assert(primitive<box<T>> && bounded<box<T>> && solid<box<T>> && sampleable<box<T>>);
    static_assert(primitive<cylinder<T>> && bounded<cylinder<T>> && solid<cylinder<T>>);
    static_assert(primitive<open_cylinder<T>> && bounded<open_cylinder<T>>);
    static_assert(!solid<open_cylinder<T>> && sampleable<open_cylinder<T>>);
    static_assert(primitive<torus<T>> && bounded<torus<T>> && solid<torus<T>> && sampleable<torus<T>>);
    static_assert(primitive<convex_polyhedron<T>> && bounded<convex_polyhedron<T>> && solid<convex_polyhedron<T>>);
    static_assert(primitive<ring<T>> && bounded<ring<T>> && !solid<ring<T>> && sampleable<ring<T>>);
    static_assert(primitive<capsule<T>> && bounded<capsule<T>> && solid<capsule<T>> && sampleable<capsule<T>>);
    static_assert(primitive<cone<T>> && bounded<cone<T>> && solid<cone<T>> && sampleable<cone<T>>);
    static_assert(bounded<open_cone<T>> && !solid<open_cone<T>> && sampleable<open_cone<T>>);
    static_assert(primitive<frustum<T>> && bounded<frustum<T>> && solid<frustum<T>> && sampleable<frustum<T>>);
    static_assert(bounded<open_frustum<T>> && !solid<open_frustum<T>> && sampleable<open_frustum<T>>);
    static_assert(primitive<paraboloid<T>> && sampleable<paraboloid<T>> && solid<paraboloid<T>>);
    static_assert(bounded<open_paraboloid<T>> && !solid<open_paraboloid<T>> && sampleable<open_paraboloid<T>>);
    static_assert(bounded<hyperboloid<T>> && solid<hyperboloid<T>> && !solid<open_hyperboloid<T>>);
    static_assert(bounded<two_sheet_hyperboloid<T>> && solid<two_sheet_hyperboloid<T>>);
    static_assert(sampleable<hyperboloid<T>> && sampleable<open_hyperboloid<T>> && sampleable<convex_polyhedron<T>>);
    static_assert(sampleable<two_sheet_hyperboloid<T>> && sampleable<open_two_sheet_hyperboloid<T>>);
    static_assert(bounded<open_two_sheet_hyperboloid<T>> && !solid<open_two_sheet_hyperboloid<T>>);
    static_assert(primitive<ellipsoid<T>> && bounded<ellipsoid<T>> && solid<ellipsoid<T>>);
    static_assert(solid<polyhedron<T, 20>> && std::is_trivially_copyable_v<polyhedron<T, 20>>);
    static_assert(primitive<convex_polyhedron<T, std::span<const half_space<T>>>>);
    static_assert(primitive<group<sphere<T>, std::vector<box<T>>>> && bounded<group<sphere<T>, std::vector<box<T>>>>);
    static_assert(solid<group<sphere<T>>> && !solid<group<sphere<T>, disc<T>>> && !sampleable<group<sphere<T>>>);
    static_assert(solid<csg<set_operation::unite, sphere<T>, const box<T>*>>);
    static_assert(bounded<transformed<sphere<T>>> && solid<transformed<sphere<T>>> && !solid<transformed<disc<T>>>);
    static_assert(primitive<transformed<const group<sphere<T>>*>>);

    // Plain data: no constructor hides work, nothing is virtual.
    static_assert(std::is_aggregate_v<sphere<T>> && std::is_aggregate_v<plane<T>> && std::is_aggregate_v<disc<T>>);
    static_assert(std::is_aggregate_v<triangle<T>> && std::is_aggregate_v<watertight_triangle<T>>);
    static_assert(std::is_aggregate_v<box<T>> && std::is_aggregate_v<cylinder<T>> && std::is_aggregate_v<torus<T>> &&
                  std::is_aggregate_v<ray<T>>);
    static_assert(std::is_trivially_copyable_v<sphere<T>> && std::is_trivially_copyable_v<hit_record<T>>);
    static_assert(sizeof(sphere<T>) == 4 * sizeof(T) && sizeof(triangle<T>) == 9 * sizeof(T));

    /// What answers the two questions is a primitive, whoever wrote it.
    struct nothing {
        using number = T;
        bool hit(const ray<T>&, T, T, hit_record<T>&) const { return false; }
        bool occluded(const ray<T>&, T, T) const { return false; }
    };
    static_assert(primitive<nothing> && !bounded<nothing> && !solid<nothing> && !sampleable<nothing>);
    static_assert(primitive<group<nothing, sphere<T>>> && !bounded<group<nothing, sphere<T>>>);
};
template struct who_is_what<float>;
template struct who_is_what<double>;

static_assert(!primitive<int> && !primitive<vec3<float>> && !primitive<aabb<float>> && !primitive<ray<double>>);

}  // namespace raio::test
