#include <cfenv>

#include "support/boxes.hpp"
#include "support/capsules.hpp"
#include "support/cones.hpp"
#include "support/cylinders.hpp"
#include "support/discs.hpp"
#include "support/ellipsoids.hpp"
#include "support/planes.hpp"
#include "support/polyhedra.hpp"
#include "support/probe.hpp"
#include "support/rings.hpp"
#include "support/round_cones.hpp"
#include "support/spheres.hpp"
#include "support/triangles.hpp"

/// What a program meets that has traps on. (Only where the compiler keeps to what the source divides: clang goes ahead
/// with quotients that nobody asks for.)
namespace raio::test {

namespace {

/// No answer raises any of these floating-point exceptions.
template <class Shape>
void check_raises_none(int exceptions) {
    using T = number_t<Shape>;
    for_random_probes<Shape>("floating-point exceptions", test_rays / 20, [&](const probe<Shape>& p, random_numbers&) {
        std::feclearexcept(FE_ALL_EXCEPT);
        hit_record<T> rec{};
        const bool hit = p.hit(rec), occluded = p.shape.occluded(p.ray, p.t_min, p.t_max);
        const bool raised = std::fetestexcept(exceptions) != 0;
        CHECK(hit == occluded);
        return std::string(raised ? "raised" : "");
    });
}

}  // namespace

/// These compare with what comes of infinities: of what nothing is known the error is infinite.
TEST_CASE_TEMPLATE("exceptions: nothing is divided by zero, nor out of range", T, RAIO_NUMBERS) {
    check_raises_none<box<T>>(FE_DIVBYZERO | FE_OVERFLOW);
    // Spheres in float are looked at in floats first, and numbers beyond 2^63 have no squares there.
    constexpr int of_spheres = std::same_as<T, float> ? FE_DIVBYZERO : FE_DIVBYZERO | FE_OVERFLOW;
    check_raises_none<sphere<T>>(of_spheres);
    check_raises_none<ellipsoid<T>>(FE_DIVBYZERO | FE_OVERFLOW);
    check_raises_none<disc<T>>(FE_DIVBYZERO | FE_OVERFLOW);
    check_raises_none<ring<T>>(FE_DIVBYZERO | FE_OVERFLOW);
    check_raises_none<triangle<T>>(FE_DIVBYZERO | FE_OVERFLOW);
    check_raises_none<watertight_triangle<T>>(FE_DIVBYZERO | FE_OVERFLOW);
    check_raises_none<plane<T>>(FE_DIVBYZERO);  // is met farther off than floats go
    check_raises_none<cylinder<T>>(FE_DIVBYZERO | FE_OVERFLOW);
    check_raises_none<open_cylinder<T>>(FE_DIVBYZERO | FE_OVERFLOW);
    check_raises_none<capsule<T>>(of_spheres);
    check_raises_none<cone<T>>(FE_DIVBYZERO | FE_OVERFLOW);
    check_raises_none<round_cone<T>>(of_spheres);
    check_raises_none<convex_polyhedron<T>>(FE_DIVBYZERO | FE_OVERFLOW);
}

}  // namespace raio::test
