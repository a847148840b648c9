#include <raio/shape/capsule.hpp>

#include "peers/three_part_capsule.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    const auto random_capsule = [](bench::generator& random) {
        const auto center = random.point<T>(0.5);
        const auto half = random.direction<T>() * random.between<T>(0.4, 1.0);
        return raio::capsule<T>{center - half, center + half, random.between<T>(0.3, 0.6)};
    };
    bench::add<raio::capsule<T>, peers::three_part_capsule<T>>("capsule", random_capsule);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
