#include <raio/shape/frustum.hpp>

#include "support.hpp"

namespace {

template <class T>
void add() {
    const auto random_frustum = [](bench::generator& random) {
        const auto center = random.point<T>(0.5);
        const auto half = random.direction<T>() * random.between<T>(0.4, 1.0);
        return raio::frustum<T>{center - half, center + half, random.between<T>(0.4, 1.0), random.between<T>(0.2, 0.8)};
    };
    bench::add<raio::frustum<T>>("frustum", random_frustum);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
