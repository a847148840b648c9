#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <render/reader.hpp>

#include "refusal.hpp"

/// One input of the fuzzer, and of replay.cpp: the bytes are a scene or they are refused in one line, and nothing else
/// happens.

namespace {

/// No input may name a file that is then read.
render::texture one_texel(const std::filesystem::path& path) {
    if (path.filename() == "there.png") return {1, 1, {255, 0, 255}};
    throw std::runtime_error("no such picture");
}

std::vector<raio::triangle<double>> one_triangle(const std::filesystem::path&) {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    check_read_or_refused("scene.txt", size, [&] {
        const render::scene scene = render::parse_scene(text, "scene.txt", {one_texel, one_triangle});
        for (const render::object& object : scene.objects) {
            if (object.pigment >= scene.pigments.size() || object.material >= scene.materials.size()) std::abort();
        }
    });
    return 0;
}
