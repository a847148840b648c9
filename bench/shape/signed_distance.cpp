#include <raio/shape/signed_distance.hpp>

#include "support.hpp"

namespace {

/// A torus about z.
template <class T>
struct doughnut {
    T major_radius, minor_radius;
    T operator()(const raio::vec3<T>& p) const {
        const T beyond = std::sqrt(p.x * p.x + p.y * p.y) - major_radius;
        return std::sqrt(beyond * beyond + p.z * p.z) - minor_radius;
    }
};

template <class T>
void add() {
    const auto random_doughnut = [](bench::generator& random) {
        const doughnut<T> f{random.between<T>(0.6, 1.0), random.between<T>(0.1, 0.5)};
        const T reach = f.major_radius + f.minor_radius, tolerance = T(1e-4);
        const raio::aabb<T> box{{-reach, -reach, -f.minor_radius}, {reach, reach, f.minor_radius}};
        return raio::signed_distance{box, tolerance, T(1), f};
    };
    bench::add<raio::signed_distance<T, doughnut<T>>>("signed_distance", random_doughnut);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
