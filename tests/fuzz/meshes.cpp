#include <cstddef>
#include <cstdint>
#include <string_view>

#include <render/mesh.hpp>

#include "refusal.hpp"

/// One input of the fuzzer, and of replay.cpp: the bytes are a mesh, OBJ or PLY, or they are refused, and nothing else
/// happens. No more triangles come of it than there are bytes.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    check_read_or_refused("mesh.obj", size, [&] {
        const std::size_t triangles = render::parse_mesh(text, "mesh.obj").size();
        if (triangles == 0 || triangles > size) std::abort();
    });
    return 0;
}
