#include <raio/shape/teardrop.hpp>

#include "support.hpp"

namespace {

template <class T>
raio::teardrop<T> random_teardrop(bench::generator& random) {
    const auto middle = random.point<T>(0.5), half = random.direction<T>();
    return {middle - half, middle + half, random.between<T>(0.3, 1.0)};
}

}  // namespace

int main(int argc, char** argv) {
    bench::add<raio::teardrop<float>>("teardrop", random_teardrop<float>);
    bench::add<raio::teardrop<double>>("teardrop", random_teardrop<double>);
    return bench::run(argc, argv);
}
