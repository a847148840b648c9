#include "renderer.hpp"

#include <atomic>
#include <system_error>
#include <thread>
#include <vector>

#include <raio/shape/disc.hpp>

#include "camera.hpp"

namespace render {
namespace {

/// A point in the unit disc, uniform by area.
vec2 point_on_lens(const vec2& u) {
    const vec3 point = raio::disc<number>{{0, 0, 0}, {0, 0, 1}, 1}.sample(u).point;
    return {point.x, point.y};
}

}  // namespace

film rendered(const world& world, const integrator& integrator, const render_settings& settings,
              const std::function<void()>& row_done, const std::function<bool()>& stopped) {
    film picture(settings.width, settings.height);
    const camera camera(world.scene().camera, settings.width, settings.height);

    const auto pixel = [&](int column, int row) {
        const auto number_of_pixel = static_cast<std::uint64_t>(row) * static_cast<std::uint64_t>(settings.width) +
                                     static_cast<std::uint64_t>(column);
        color sum(0);
        for (int i = 0; i < settings.samples; ++i) {
            sampler sampler(settings.seed, number_of_pixel, static_cast<std::uint32_t>(i));
            vec2 offset(0), lens(0);
            if (settings.samples > 1) {
                offset = sampler.next_2d();
                lens = point_on_lens(sampler.next_2d());
            }
            sum += integrator.radiance(world, camera.through(column, row, offset, lens), sampler, settings.depth);
        }
        return integrator.shown(sum / number(settings.samples));
    };

    std::atomic<int> next_row = 0;
    const auto work = [&] {
        for (int row; (row = next_row++) < settings.height;) {
            for (int column = 0; column < settings.width; ++column) {
                if (stopped()) return;
                picture.at(column, row) = pixel(column, row);
            }
            row_done();
        }
    };
    std::vector<std::jthread> helpers;
    try {
        for (int i = 1; i < settings.threads; ++i) helpers.emplace_back(work);
    } catch (const std::system_error&) {
        // The system starts no more: the picture is the same with fewer, and what they have begun is not lost.
    }
    work();
    helpers.clear();  // waits for them
    return picture;
}

}  // namespace render
