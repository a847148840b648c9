#pragma once

#include <raio/bvh/gather.hpp>
#include <raio/raio.hpp>

#include <array>
#include <cstdint>

namespace raio::test {

/// Numbers that are the same everywhere, which the distributions of <random> are not (xorshift64; Marsaglia 2003).
class portable_numbers {
public:
    /// In [0, 1).
    double uniform() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return static_cast<double>(state_ >> 11) * 0x1p-53;
    }

    template <class T>
    T length() {
        return static_cast<T>(uniform());
    }

    /// Around the origin, up to twice the size away along each axis. The size is a power of two: its product is exact,
    /// so that nothing in this test depends on contraction either.
    template <class T>
    vec3<T> point(double size = 1) {
        const double x = centred(), y = centred(), z = centred();
        return {static_cast<T>(x * size), static_cast<T>(y * size), static_cast<T>(z * size)};
    }

    /// From within eight of the origin, along each axis, to within two of it, where the shapes are.
    template <class T>
    ray<T> aimed_ray() {
        const vec3<T> origin = point<T>(4), target = point<T>();
        return {origin, target - origin};
    }

private:
    /// In (-2, 2), mostly near 0.
    double centred() {
        double sum = -2.0;
        for (int i = 0; i < 4; ++i) sum += uniform();
        return sum;
    }

    std::uint64_t state_ = 88172645463325252u;
};

/// visit(name, make) for every shape whose answers are its own, where make(numbers) is one of its kind, with a position
/// within two of the origin. (Not signed_distance: its function is the caller's, and computed as the compiler likes.)
template <class T, class Visit>
void for_every_portable_shape(Visit&& visit) {
    using numbers = portable_numbers;
    const vec3<T> low(-1), high(1);
    visit("sphere", [](numbers& n) { return sphere<T>{n.point<T>(), n.length<T>()}; });
    visit("plane", [](numbers& n) { return plane<T>{n.point<T>(), n.point<T>()}; });
    visit("disc", [](numbers& n) { return disc<T>{n.point<T>(), n.point<T>(), n.length<T>()}; });
    visit("triangle", [](numbers& n) { return triangle<T>{n.point<T>(), n.point<T>(), n.point<T>()}; });
    visit("watertight_triangle", [](numbers& n) {
        return watertight_triangle<T>{n.point<T>(), n.point<T>(), n.point<T>()};
    });
    visit("box", [](numbers& n) {
        const vec3<T> corner = n.point<T>();
        return box<T>{corner, corner + vec3<T>{n.length<T>(), n.length<T>(), n.length<T>()}};
    });
    visit("cylinder", [](numbers& n) { return cylinder<T>{n.point<T>(), n.point<T>(), n.length<T>()}; });
    visit("open_cylinder", [](numbers& n) { return open_cylinder<T>{n.point<T>(), n.point<T>(), n.length<T>()}; });
    visit("convex_polyhedron", [](numbers& n) {
        convex_polyhedron<T, std::array<half_space<T>, 5>> some;
        for (half_space<T>& s : some.planes) s = {n.point<T>(), -n.length<T>()};
        return some;
    });
    visit("torus", [](numbers& n) { return torus<T>{n.point<T>(), n.point<T>(), n.length<T>(), n.length<T>()}; });
    visit("parallelogram", [](numbers& n) { return parallelogram<T>{n.point<T>(), n.point<T>(), n.point<T>()}; });
    visit("frustum", [](numbers& n) { return frustum<T>{n.point<T>(), n.point<T>(), n.length<T>(), n.length<T>()}; });
    visit("open_cone", [](numbers& n) { return open_cone<T>{n.point<T>(), n.point<T>(), n.length<T>()}; });
    visit("ellipsoid", [](numbers& n) {
        return ellipsoid<T>{n.point<T>(), {n.length<T>(), n.length<T>(), n.length<T>()}};
    });
    visit("ring", [](numbers& n) {
        const vec3<T> center = n.point<T>(), normal = n.point<T>();
        const T inner = n.length<T>();
        return ring<T>{center, normal, inner, inner + n.length<T>()};
    });
    visit("capsule", [](numbers& n) { return capsule<T>{n.point<T>(), n.point<T>(), n.length<T>()}; });
    visit("round_cone", [](numbers& n) {
        return round_cone<T>{n.point<T>(), n.point<T>(), n.length<T>(), n.length<T>()};
    });
    visit("cone", [](numbers& n) { return cone<T>{n.point<T>(), n.point<T>(), n.length<T>()}; });
    visit("open_frustum", [](numbers& n) {
        return open_frustum<T>{n.point<T>(), n.point<T>(), n.length<T>(), n.length<T>()};
    });
    visit("paraboloid", [](numbers& n) { return paraboloid<T>{n.point<T>(), n.point<T>(), n.length<T>()}; });
    visit("open_paraboloid", [](numbers& n) { return open_paraboloid<T>{n.point<T>(), n.point<T>(), n.length<T>()}; });
    visit("hyperboloid", [](numbers& n) {
        return hyperboloid<T>{n.point<T>(), n.point<T>(), n.length<T>(), n.length<T>()};
    });
    visit("open_hyperboloid", [](numbers& n) {
        return open_hyperboloid<T>{n.point<T>(), n.point<T>(), n.length<T>(), n.length<T>()};
    });
    visit("two_sheet_hyperboloid", [](numbers& n) {
        return two_sheet_hyperboloid<T>{n.point<T>(), n.point<T>(), n.length<T>(), n.length<T>()};
    });
    visit("open_two_sheet_hyperboloid", [](numbers& n) {
        return open_two_sheet_hyperboloid<T>{n.point<T>(), n.point<T>(), n.length<T>(), n.length<T>()};
    });
    visit("bilinear_patch", [](numbers& n) {
        return bilinear_patch<T>{n.point<T>(), n.point<T>(), n.point<T>(), n.point<T>()};
    });
    visit("heightfield", [](numbers& n) {
        heightfield<T> field{{-2, -2}, {2, 2}, 4, {}};
        for (int i = 0; i < 16; ++i) field.heights.push_back(n.length<T>());
        return field;
    });
    visit("quadric",
          [&](numbers& n) { return quadric<T>{low, high, n.point<T>(), n.point<T>(), n.point<T>(), -n.length<T>()}; });
    visit("open_quadric", [&](numbers& n) {
        return open_quadric<T>{low, high, n.point<T>(), n.point<T>(), n.point<T>(), -n.length<T>()};
    });
    visit("algebraic", [&](numbers& n) {
        const std::array<vec3<int>, 6> powers{{{4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}, {0, 2, 0}, {0, 0, 0}}};
        algebraic<T, 4, true, std::array<algebraic_term<T>, 6>> surface{low, high, {}};
        for (std::size_t i = 0; i < powers.size(); ++i) {
            surface.terms[i] = {n.point<T>().x, unsigned(powers[i].x), unsigned(powers[i].y), unsigned(powers[i].z)};
        }
        return surface;
    });
    visit("steiner", [](numbers& n) { return steiner<T>{n.point<T>(), n.length<T>()}; });
    visit("teardrop", [](numbers& n) { return teardrop<T>{n.point<T>(), n.point<T>(), n.length<T>()}; });
    visit("blob", [](numbers& n) {
        blob<T, 3> some{{}, T(0.25)};
        for (metaball<T>& m : some.components) m = {n.point<T>(), n.length<T>(), n.point<T>().x};
        some.components[0].axis = n.point<T>();
        return some;
    });
    visit("surface_of_revolution", [](numbers& n) {
        surface_of_revolution<T> vase{n.point<T>(), n.point<T>(), {}};
        for (int i = 0; i < 7; ++i) vase.profile.push_back({n.length<T>(), n.length<T>()});
        return vase;
    });
    visit("curved_surface_of_revolution", [](numbers& n) {
        curved_surface_of_revolution<T> vase{n.point<T>(), n.point<T>(), {}};
        for (int i = 0; i < 7; ++i) vase.profile.push_back({n.length<T>(), n.length<T>()});
        return vase;
    });
    visit("bezier_curve", [](numbers& n) {
        return bezier_curve<T>{n.point<T>(),  n.point<T>(),  n.point<T>(),  n.point<T>(),
                               n.length<T>(), n.length<T>(), n.length<T>(), n.length<T>()};
    });
    visit("group", [](numbers& n) {
        return group{sphere<T>{n.point<T>(), n.length<T>()}, cone<T>{n.point<T>(), n.point<T>(), n.length<T>()}};
    });
    visit("csg", [&](numbers& n) {
        return difference_of(box<T>{low, high}, torus<T>{n.point<T>(), n.point<T>(), n.length<T>(), n.length<T>()});
    });
    visit("transformed", [](numbers& n) {
        const transform<T> map{n.point<T>(), n.point<T>(), n.point<T>(), n.point<T>()};
        return transformed{cylinder<T>{n.point<T>(), n.point<T>(), n.length<T>()}, map};
    });
}

}  // namespace raio::test
