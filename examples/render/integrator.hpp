#pragma once

#include <span>
#include <string_view>

#include "sampler.hpp"
#include "world.hpp"

namespace render {

/// A way to say how much light comes back along a ray.
struct integrator {
    std::string_view name;
    /// `depth` is how many times light may bounce.
    color (*radiance)(const world& world, const ray& view, sampler& sampler, int depth);
    /// From the mean of a pixel's samples to the colour that is shown, which is encoded.
    color (*shown)(const color& mean);
    /// Is there any light for it in the scene? If not, all is black.
    bool (*is_lit)(const scene& scene);
    int samples;  ///< for each pixel, if nothing else is wanted
    int depth;    ///< if nothing else is wanted
    std::string_view description;
};

/// All there are.
std::span<const integrator> integrators();

namespace flat {
/// The pigment of the first surface.
color radiance(const world& world, const ray& view, sampler& sampler, int depth);
}  // namespace flat

namespace normals {
/// The unit normal of the first surface, against the ray, from [-1, 1] to [0, 1].
color radiance(const world& world, const ray& view, sampler& sampler, int depth);
}  // namespace normals

namespace whitted {
/// Phong's model with sharp shadows, mirrors and glass, clamped to [0, 1] at every bounce
/// (Appel 1968; Phong, CACM 18(6), 1975; Whitted, CACM 23(6), 1980).
color radiance(const world& world, const ray& view, sampler& sampler, int depth);
}  // namespace whitted

namespace path {
/// One path of light, drawn at random; their mean is all light that there is (Kajiya, "The Rendering Equation", 1986).
color radiance(const world& world, const ray& view, sampler& sampler, int depth);
}  // namespace path

}  // namespace render
