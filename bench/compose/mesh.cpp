#include <raio/compose/mesh.hpp>

#include <cstdint>

#include "support.hpp"

namespace {

/// Fans of eight triangles.
template <class T>
void add() {
    const auto random_fan = [](bench::generator& random) {
        raio::mesh<T> fan;
        fan.vertices.push_back(random.point<T>(0.5));
        for (std::uint32_t i = 0; i < 9; ++i) fan.vertices.push_back(random.point<T>(1.0));
        for (std::uint32_t i = 1; i < 9; ++i) fan.triangles.push_back({0, i, i + 1});
        return fan;
    };
    bench::add<raio::mesh<T>>("mesh", random_fan);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
