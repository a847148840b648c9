#include <algorithm>
#include <string>
#include <tuple>

#include <raio/shape/bezier_curve.hpp>
#include <raio/shape/capsule.hpp>
#include <raio/shape/cone.hpp>
#include <raio/shape/curved_surface_of_revolution.hpp>
#include <raio/shape/cylinder.hpp>
#include <raio/shape/ellipsoid.hpp>
#include <raio/shape/frustum.hpp>
#include <raio/shape/hyperboloid.hpp>
#include <raio/shape/paraboloid.hpp>
#include <raio/shape/round_cone.hpp>
#include <raio/shape/sphere.hpp>
#include <raio/shape/surface_of_revolution.hpp>
#include <raio/shape/two_sheet_hyperboloid.hpp>

#include "shape_readings.hpp"

namespace render {
namespace {

template <class Cylinder>
shape read_cylinder(tokens& in, int) {
    const vec3 base = vector(in, "the base of a cylinder"), axis = direction(in, "the axis of a cylinder");
    const number radius = in.expect_number("the radius of a cylinder", positive);
    const number height = in.expect_number("the height of a cylinder", positive);
    const vec3 top = base + raio::normalize(axis) * height;
    if (top == base) in.fail("a height that is lost in the rounding of the base", "a higher cylinder");
    return Cylinder{base, top, radius};
}

constexpr requirement inner_fraction{"a number between 0 and 1", [](double x) { return x > 0 && x < 1; }};

shape read_bezier_curve(tokens& in, int) {
    raio::bezier_curve<number> curve{};
    for (vec3* p : {&curve.p0, &curve.p1, &curve.p2, &curve.p3})
        *p = vector(in, "the control points of a Bezier curve");
    const auto radii = numbers<4>(in, "the radii of a Bezier curve", not_negative);
    if (radii == std::array<number, 4>{}) in.fail("radii that are all 0", "one above 0 at least");
    std::tie(curve.r0, curve.r1, curve.r2, curve.r3) = std::tuple_cat(radii);
    return curve;
}

template <std::size_t Degree>
shape read_surface_of_revolution(tokens& in, int) {
    raio::surface_of_revolution<number, Degree> surface{
        vector(in, "the base of a surface of revolution"), direction(in, "the axis of a surface of revolution"), {}};
    surface.profile = section(in, "points of a profile", [&] {
        const number radius = in.expect_number("the radius of a profile's point", not_negative);
        return vec2{radius, in.expect_number("the height of a profile's point")};
    });
    if constexpr (Degree == 1) {
        if (!(surface.area() > 0)) in.fail("a profile that sweeps no area", "two points or more, not all on the axis");
    } else {
        const std::size_t points = surface.profile.size();
        if (points < 4 || points % 3 != 1) in.fail(std::to_string(points) + " points", "4, and 3 for each curve more");
        if (std::ranges::all_of(surface.profile, [](const vec2& p) { return p.x == 0; })) {
            in.fail("a profile that sweeps no area", "points that are not all on the axis");
        }
    }
    return surface;
}

}  // namespace

shape_readings shapes_about_an_axis() {
    return {
        {"sphere", plain<raio::sphere<number>>("a sphere", point{"centre"}, measure{"radius"})},
        {"ellipsoid", plain<raio::ellipsoid<number>>("an ellipsoid", point{"centre"}, lengths{"radii"})},
        {"cylinder", read_cylinder<raio::cylinder<number>>},
        {"open_cylinder", read_cylinder<raio::open_cylinder<number>>},
        {"capsule", plain<raio::capsule<number>>("a capsule", point{"base"}, point{"top"}, measure{"radius"})},
        {"round_cone", plain<raio::round_cone<number>>("a round cone", point{"base"}, point{"top"},
                                                       measure{"base radius"}, measure{"top radius"})},
        {"bezier_curve", read_bezier_curve},
        {"cone", upright<raio::cone<number>>("a cone", point{"base"}, point{"apex"}, measure{"radius"})},
        {"open_cone", upright<raio::open_cone<number>>("a cone", point{"base"}, point{"apex"}, measure{"radius"})},
        {"frustum", upright<raio::frustum<number>>("a frustum", point{"base"}, point{"top"}, measure{"base radius"},
                                                   measure{"top radius", not_negative})},
        {"open_frustum",
         upright<raio::open_frustum<number>>("a frustum", point{"base"}, point{"top"}, measure{"base radius"},
                                             measure{"top radius", not_negative})},
        {"paraboloid",
         upright<raio::paraboloid<number>>("a paraboloid", point{"vertex"}, point{"top"}, measure{"radius"})},
        {"open_paraboloid",
         upright<raio::open_paraboloid<number>>("a paraboloid", point{"vertex"}, point{"top"}, measure{"radius"})},
        {"hyperboloid", upright<raio::hyperboloid<number>>("a hyperboloid", point{"base"}, point{"top"},
                                                           measure{"waist radius"}, measure{"end radius"})},
        {"open_hyperboloid", upright<raio::open_hyperboloid<number>>("a hyperboloid", point{"base"}, point{"top"},
                                                                     measure{"waist radius"}, measure{"end radius"})},
        {"two_sheet_hyperboloid",
         upright<raio::two_sheet_hyperboloid<number>>("a hyperboloid", point{"base"}, point{"top"},
                                                      measure{"gap", inner_fraction}, measure{"end radius"})},
        {"open_two_sheet_hyperboloid",
         upright<raio::open_two_sheet_hyperboloid<number>>("a hyperboloid", point{"base"}, point{"top"},
                                                           measure{"gap", inner_fraction}, measure{"end radius"})},
        {"surface_of_revolution", read_surface_of_revolution<1>},
        {"curved_surface_of_revolution", read_surface_of_revolution<3>},
    };
}

}  // namespace render
