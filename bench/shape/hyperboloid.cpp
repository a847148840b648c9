#include <raio/shape/hyperboloid.hpp>

#include "support.hpp"

namespace {

template <class T>
void add() {
    const auto random_hyperboloid = [](bench::generator& random) {
        const auto center = random.point<T>(0.5);
        const auto half = random.direction<T>() * random.between<T>(0.4, 1.0);
        return raio::hyperboloid<T>{center - half, center + half, random.between<T>(0.2, 0.5),
                                    random.between<T>(0.5, 1.0)};
    };
    bench::add<raio::hyperboloid<T>>("hyperboloid", random_hyperboloid);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
