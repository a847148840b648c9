#include <cmath>
#include <cstdint>
#include <memory>

#include <doctest/doctest.h>
#include <render/color.hpp>

#include "scenes.hpp"

using namespace render;

namespace {

/// The only pixel of a thing in white light.
color pixel_of(const pigment& p, const material& m, std::string_view integrator) {
    scene s = scene_of({{raio::sphere<number>{origin, 1}, color(0), m}}, {color(1), color(1)});
    s.pigments[0] = p;
    s.camera.vertical_field_of_view = 1;
    return rendered(world(s), integrator_named(integrator), {.width = 1, .height = 1, .samples = 16, .depth = 50})
        .at(0, 0);
}

}  // namespace

TEST_CASE("sRGB: the levels that IEC 61966-2-1 tells, and back") {
    struct {
        int level;
        double light;
    } const rows[] = {{0, 0}, {1, 0.000303527}, {10, 0.00303527}, {11, 0.00334654}, {128, 0.215861}, {255, 1}};
    for (const auto& row : rows) {
        CAPTURE(row.level);
        CHECK(decoded(static_cast<std::uint8_t>(row.level)) == doctest::Approx(row.light).epsilon(1e-5));
    }
    for (int i = 0; i < 256; ++i) {
        const color shown = encoded(color(decoded(static_cast<std::uint8_t>(i)), 0, 1));
        CHECK(255 * shown.x == doctest::Approx(i).epsilon(1e-12));
        CHECK(shown.y == 0);
        CHECK(shown.z == doctest::Approx(1).epsilon(1e-15));
    }
}

TEST_CASE("a texture in white light is shown as its file has it, by every integrator: path decodes it") {
    for (int texel = 0; texel < 256; texel += 5) {
        CAPTURE(texel);
        const auto image = std::make_shared<texture>(texture{1, 1, {static_cast<std::uint8_t>(texel), 255, 0}});
        for (const auto& row : {std::pair<std::string_view, material>{"flat", lambertian{}},
                                {"whitted", phong{.ambient = 1}},
                                {"path", phong{.ambient = 1}},
                                {"path", lambertian{}},
                                {"path", metal{0}}}) {
            CAPTURE(row.first);
            const color shown = pixel_of(textured{image, {}, {}}, row.second, row.first);
            CHECK(level(shown.x) == texel);
            CHECK(level(shown.y) == 255);
            CHECK(level(shown.z) == 0);
        }
    }
}

TEST_CASE("the colours of a scene are shown as they stand, but for path, to which they are linear") {
    const auto shown = [&](std::string_view name) {
        return level(pixel_of(solid{color(0.5)}, phong{.ambient = 1}, name).x);
    };
    CHECK(shown("flat") == 127);
    CHECK(shown("whitted") == 127);
    CHECK(shown("path") == 188);
}
