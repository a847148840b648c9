#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <variant>
#include <vector>

#include <raio/shape/triangle.hpp>

#include "any_shape.hpp"
#include "texture.hpp"

/// \file
/// A scene as its file says it: plain data in the file's order, which the reader fills and `world` makes ready for
/// rays. Lengths are in the scene's own unit, angles in degrees, indices count from 0.

namespace render {

using number = double;
using vec2 = raio::vec2<number>;
using vec3 = raio::vec3<number>;
using ray = raio::ray<number>;
using hit_record = raio::hit_record<number>;

/// What the camera section says, and `aperture`.
struct camera_description {
    vec3 eye{0, 0, 1};
    vec3 look_at{0, 0, 0};
    vec3 up{0, 1, 0};
    number vertical_field_of_view = 60;  ///< of the whole picture, in degrees, in (0, 180)
    number aperture = 0;                 ///< diameter of the lens, at least 0; 0 is a pinhole
    number focus_distance = 1;           ///< from the eye to the plane that is sharp, above 0
};

/// A lamp without size, whose colour is divided by `attenuation[0] + attenuation[1] d + attenuation[2] d^2` at distance
/// d.
struct point_light {
    vec3 position;
    color intensity;
    std::array<number, 3> attenuation;
};

// Pigments say what colour a point has.

struct solid {
    color value;
};

/// Cubes of two colours: the first where floor(x / size) + floor(y / size) + floor(z / size) is even.
struct checker {
    color even, odd;
    number size;  ///< edge of a cube, above 0
};

/// A picture that is laid over space: the texel at (s, t) with s = p . (x, y, z, 1), t = q . (x, y, z, 1), repeated.
struct textured {
    std::shared_ptr<const texture> image;  ///< never null
    std::array<number, 4> p, q;
};

using pigment = std::variant<solid, checker, textured>;

// Materials say what the surface does with light.

/// A finish of the course: Phong's model with a mirror and a refracted part.
struct phong {
    number ambient = 0, diffuse = 0, specular = 0, exponent = 0, reflected = 0, transmitted = 0, refractive_index = 1;
};

/// Matte: light leaves in every direction alike, in the pigment's colour.
struct lambertian {};

/// A mirror in the pigment's colour. `fuzz` in [0, 1] is the radius of the ball the reflection is scattered in.
struct metal {
    number fuzz;
};

/// Glass: reflects and refracts, in the pigment's colour.
struct dielectric {
    number refractive_index;  ///< of the inside, relative to the outside, above 0
};

/// A light with a size: shines from both sides, whatever the pigment.
struct emissive {
    color radiance;
};

using material = std::variant<phong, lambertian, metal, dielectric, emissive>;

/// What a scene has most of, the triangles of meshes, and all other shapes.
using shape = std::variant<raio::triangle<number>, any_shape>;

/// A shape, and which of the scene's pigments and materials it has.
struct object {
    std::size_t pigment, material;
    render::shape shape;
};

/// What rays see that meet nothing: from `bottom` straight down to `top` straight up, linear in the direction's height.
struct background {
    color bottom{0}, top{0};
};

/// What a ray meets at distance d is seen weakened by exp(-density d), and the fog's colour takes its place. The
/// background is not weakened, nor is the light of lamps without size on its way to a surface.
struct fog {
    color value{0};
    number density = 0;  ///< per unit of length, at least 0; 0 is clear air
};

struct scene {
    camera_description camera;
    std::vector<point_light> lights;
    std::vector<render::pigment> pigments;
    std::vector<render::material> materials;
    std::vector<render::object> objects;
    render::background background;
    render::fog fog;
};

}  // namespace render
