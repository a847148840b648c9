#pragma once

#include <utility>
#include <vector>

#include <raio/raio.hpp>
#include <render/renderer.hpp>

#include "support/random.hpp"

/// \file
/// Small scenes that are written in the tests, and the numbers that come out of them.

namespace render {

inline const vec3 origin(0, 0, 0);
inline const ray forward{{0, 0, -4}, {0, 0, 1}};  ///< from the eye of every scene here

/// A scene in which object number i has pigment and material number i.
struct painted {
    render::shape shape;
    color hue;
    render::material material;
};

inline scene scene_of(const std::vector<painted>& objects, const background& sky = {}) {
    scene s;
    s.camera = {.eye = {0, 0, -4}, .look_at = origin};
    s.background = sky;
    for (const painted& o : objects) {
        s.objects.push_back({s.pigments.size(), s.materials.size(), o.shape});
        s.pigments.push_back(solid{o.hue});
        s.materials.push_back(o.material);
    }
    return s;
}

inline const integrator& integrator_named(std::string_view name) {
    return *std::ranges::find(integrators(), name, &integrator::name);
}

/// Many independent paths along one ray (fewer in a short run, but 256): their mean, and the standard error of the
/// mean's red.
struct estimate {
    color mean{0};
    number standard_error = 0;
};

inline estimate path_estimate(const world& world, const ray& view, int paths = 4096, int depth = 50) {
    paths = std::min(paths, std::max(256, raio::test::share_of(paths)));
    color sum(0);
    number squares = 0;
    for (int i = 0; i < paths; ++i) {
        sampler sampler(1, static_cast<std::uint64_t>(i), 0);  // each of another pixel: without any stratification
        const color light = path::radiance(world, view, sampler, depth);
        sum += light;
        squares += light.x * light.x;
    }
    const color mean = sum / number(paths);
    return {mean, std::sqrt(std::max(0.0, squares / paths - mean.x * mean.x) / paths)};
}

inline bool same_pixels(const film& a, const film& b) {
    if (a.width() != b.width() || a.height() != b.height()) return false;
    for (int row = 0; row < a.height(); ++row) {
        for (int column = 0; column < a.width(); ++column) {
            if (a.at(column, row) != b.at(column, row)) return false;
        }
    }
    return true;
}

}  // namespace render
