#include <raio/compose/closed_surface.hpp>
#include <raio/compose/mesh.hpp>

#include <cstdint>
#include <vector>

#include "support.hpp"

// All hits of a closed mesh, and its passages, which need no more of most rays.

namespace {

template <class Surface>
struct listing {
    using T = raio::number_t<Surface>;
    using result = std::vector<raio::hit_record<T>>;
    Surface surface;
};

template <class Surface>
struct all_hits : listing<Surface> {
    static constexpr const char* name = "all_hits";
    using typename listing<Surface>::T;

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, typename listing<Surface>::result& found) const {
        return !(found = this->surface.all_hits(ray, t_min, t_max)).empty();
    }
};

template <class Surface>
struct passages : listing<Surface> {
    static constexpr const char* name = "passages";
    using typename listing<Surface>::T;

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, typename listing<Surface>::result& found) const {
        return !(found = raio::passages(this->surface, ray, t_min, t_max)).empty();
    }
};

template <class T>
void add() {
    const auto random_octahedron = [](bench::generator& random) {
        raio::mesh<T> octahedron;
        for (int axis = 0; axis < 3; ++axis) {
            for (const double side : {-1.0, 1.0}) {
                raio::vec3<T> tip(0);
                tip[axis] = static_cast<T>(side) * random.between<T>(0.5, 1.5);
                octahedron.vertices.push_back(tip);
            }
        }
        for (std::uint32_t i = 0; i < 8; ++i) {
            const std::uint32_t x = i & 1, y = 2 + (i >> 1 & 1), z = 4 + (i >> 2);
            const bool odd = (x + y + z) % 2 != 0;
            octahedron.triangles.push_back({x, odd ? y : z, odd ? z : y});
        }
        return octahedron;
    };
    using mesh = raio::mesh<T>;
    bench::add<mesh, all_hits<mesh>, passages<mesh>>("closed_surface", random_octahedron);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
