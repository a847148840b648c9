#include <raio/compose/group.hpp>
#include <raio/shape/sphere.hpp>
#include <raio/shape/triangle.hpp>

#include <array>

#include "peers/virtual_list.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    using spheres = std::array<raio::sphere<T>, 8>;
    using triangles = std::array<raio::triangle<T>, 8>;
    const auto random_group = [](bench::generator& random) {
        spheres s;
        triangles t;
        for (auto& sphere : s) {
            const auto center = random.point<T>(1.0);
            sphere = {center, random.between<T>(0.1, 0.4)};
        }
        for (auto& triangle : t) {
            const auto a = random.point<T>(1.0), b = a + random.point<T>(0.6);
            triangle = {a, b, a + random.point<T>(0.6)};
        }
        return raio::group(s, t);
    };
    bench::add<raio::group<spheres, triangles>, peers::virtual_list<T>>("group", random_group);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
