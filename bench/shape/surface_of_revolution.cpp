#include <raio/shape/surface_of_revolution.hpp>

#include "support.hpp"

namespace {

/// Vases of eight segments.
template <class T>
void add() {
    const auto random_vase = [](bench::generator& random) {
        raio::surface_of_revolution<T> vase{random.point<T>(0.5), random.direction<T>(), {}};
        for (int i = 0; i <= 8; ++i) {
            vase.profile.push_back({random.between<T>(0.2, 0.8), T(2 * i) / T(8) - T(1)});
        }
        return vase;
    };
    bench::add<raio::surface_of_revolution<T>>("surface_of_revolution", random_vase);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
