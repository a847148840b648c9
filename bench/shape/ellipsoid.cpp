#include <raio/shape/ellipsoid.hpp>

#include "support.hpp"

namespace {

template <class T>
void add() {
    const auto random_ellipsoid = [](bench::generator& random) {
        const auto center = random.point<T>(0.5);
        const T x = random.between<T>(0.4, 1.2), y = random.between<T>(0.4, 1.2);
        return raio::ellipsoid<T>{center, {x, y, random.between<T>(0.4, 1.2)}};
    };
    bench::add<raio::ellipsoid<T>>("ellipsoid", random_ellipsoid);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
