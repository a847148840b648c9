#include <raio/shape/quadric.hpp>

#include "support.hpp"

namespace {

/// Of all signs, so of all kinds.
template <class T>
raio::quadric<T> random_quadric(bench::generator& random) {
    return {raio::vec3<T>(-1),    raio::vec3<T>(1),     random.point<T>(2.0),
            random.point<T>(1.0), random.point<T>(1.0), random.between<T>(-1.0, 0.5)};
}

}  // namespace

int main(int argc, char** argv) {
    bench::add<raio::quadric<float>>("quadric", random_quadric<float>);
    bench::add<raio::quadric<double>>("quadric", random_quadric<double>);
    return bench::run(argc, argv);
}
