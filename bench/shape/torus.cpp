#include <raio/shape/torus.hpp>

#include "peers/ferrari_torus.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    const auto random_torus = [](bench::generator& random) {
        return raio::torus<T>{random.point<T>(0.5), random.direction<T>(), random.between<T>(0.6, 1.0),
                              random.between<T>(0.1, 0.5)};
    };
    bench::add<raio::torus<T>, peers::ferrari_torus<T>>("torus", random_torus);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
