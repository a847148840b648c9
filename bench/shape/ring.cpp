#include <raio/shape/ring.hpp>

#include "peers/flat_ring.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    const auto random_ring = [](bench::generator& random) {
        const auto center = random.point<T>(0.5), normal = random.direction<T>();
        const T inner = random.between<T>(0.2, 0.5);
        return raio::ring<T>{center, normal, inner, random.between<T>(0.7, 1.2)};
    };
    bench::add<raio::ring<T>, peers::flat_ring<T>>("ring", random_ring);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
