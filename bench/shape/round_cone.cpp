#include <raio/shape/round_cone.hpp>

#include "support.hpp"

namespace {

template <class T>
void add() {
    const auto random_round_cone = [](bench::generator& random) {
        const auto base = random.point<T>(0.8), top = random.point<T>(0.8);
        const T base_radius = random.between<T>(0.1, 0.6);
        return raio::round_cone<T>{base, top, base_radius, random.between<T>(0.1, 0.6)};
    };
    bench::add<raio::round_cone<T>>("round_cone", random_round_cone);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
