#include <raio/compose/csg.hpp>
#include <raio/shape/sphere.hpp>

#include "peers/roth_difference.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    using sphere = raio::sphere<T>;
    using bitten = raio::csg<raio::set_operation::subtract, sphere, sphere>;
    const auto random_bitten_sphere = [](bench::generator& random) {
        const auto center = random.point<T>(0.5);
        return bitten{{center, T(1)}, {center + random.direction<T>() * T(0.7), random.between<T>(0.4, 0.8)}};
    };
    bench::add<bitten, peers::roth_difference<T>>("csg", random_bitten_sphere);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
