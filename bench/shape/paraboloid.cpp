#include <raio/shape/paraboloid.hpp>

#include "support.hpp"

namespace {

template <class T>
void add() {
    const auto random_paraboloid = [](bench::generator& random) {
        const auto center = random.point<T>(0.5);
        const auto half = random.direction<T>() * random.between<T>(0.4, 1.0);
        return raio::paraboloid<T>{center - half, center + half, random.between<T>(0.4, 1.2)};
    };
    bench::add<raio::paraboloid<T>>("paraboloid", random_paraboloid);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
