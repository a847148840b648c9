#include <raio/shape/cylinder.hpp>

#include "peers/quadratic_cylinder.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    const auto random_cylinder = [](bench::generator& random) {
        const auto center = random.point<T>(0.5);
        const auto half = random.direction<T>() * random.between<T>(0.4, 1.0);
        return raio::cylinder<T>{center - half, center + half, random.between<T>(0.4, 0.8)};
    };
    bench::add<raio::cylinder<T>, peers::quadratic_cylinder<T>>("cylinder", random_cylinder);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
