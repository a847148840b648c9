#include <raio/shape/surface_of_revolution.hpp>

#include "support.hpp"

namespace {

/// Vases of eight straight segments, or of two curved ones.
template <class Vase>
void add(const char* name, int segments) {
    using T = raio::number_t<Vase>;
    const auto random_vase = [=](bench::generator& random) {
        Vase vase{random.point<T>(0.5), random.direction<T>(), {}};
        for (int i = 0; i <= segments; ++i) {
            vase.profile.push_back({random.between<T>(0.2, 0.8), T(2 * i) / T(segments) - T(1)});
        }
        return vase;
    };
    bench::add<Vase>(name, random_vase);
}

}  // namespace

int main(int argc, char** argv) {
    add<raio::surface_of_revolution<float>>("surface_of_revolution", 8);
    add<raio::surface_of_revolution<double>>("surface_of_revolution", 8);
    add<raio::curved_surface_of_revolution<float>>("curved_surface_of_revolution", 6);
    add<raio::curved_surface_of_revolution<double>>("curved_surface_of_revolution", 6);
    return bench::run(argc, argv);
}
