#include <raio/shape/convex_polyhedron.hpp>

#include <array>

#include "peers/cyrus_beck.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    using planes = std::array<raio::half_space<T>, 8>;
    using cyrus_beck = peers::cyrus_beck<T, planes>;
    // An octahedron whose faces are tilted and moved.
    const auto random_polyhedron = [](bench::generator& random) {
        raio::convex_polyhedron<T, planes> polyhedron;
        for (std::size_t i = 0; i < 8; ++i) {
            const raio::vec3<T> corner(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
            const auto normal = raio::normalize(corner + random.point<T>(0.5));
            polyhedron.planes[i] = {normal, random.between<T>(-0.9, -0.5)};
        }
        return polyhedron;
    };
    bench::add<raio::convex_polyhedron<T, planes>, cyrus_beck, peers::with_record<cyrus_beck>>("convex_polyhedron",
                                                                                               random_polyhedron);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
