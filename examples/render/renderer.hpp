#pragma once

#include <cstdint>
#include <functional>

#include "film.hpp"
#include "integrator.hpp"

namespace render {

struct render_settings {
    int width = 800, height = 600;  ///< in pixels
    int samples = 1;                ///< for each pixel
    int depth = 6;                  ///< how many times light may bounce
    int threads = 1;
    std::uint64_t seed = 0;
};

/// The picture of a world. The same settings give the same picture, whatever the number of threads.
///
/// A pixel with one sample shows what lies at its corner that `camera` names; with more, their mean, spread over the
/// pixel and the lens. `row_done` is called after each row, by any thread. `stopped` is asked before each pixel, by any
/// thread; once it says so, what is not rendered yet stays black.
film rendered(
    const world& world, const integrator& integrator, const render_settings& settings,
    const std::function<void()>& row_done = [] {}, const std::function<bool()>& stopped = [] { return false; });

}  // namespace render
