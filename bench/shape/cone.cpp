#include <raio/shape/cone.hpp>

#include "support.hpp"

namespace {

template <class T>
void add() {
    const auto random_cone = [](bench::generator& random) {
        const auto center = random.point<T>(0.5);
        const auto half = random.direction<T>() * random.between<T>(0.4, 1.0);
        return raio::cone<T>{center - half, center + half, random.between<T>(0.4, 1.2)};
    };
    bench::add<raio::cone<T>>("cone", random_cone);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
