#include <raio/compose/transformed.hpp>
#include <raio/shape/sphere.hpp>

#include "peers/instance.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    const auto random_ellipsoid = [](bench::generator& random) {
        const auto size = [&] { return random.between<T>(0.4, 1.2); };
        const auto turn = raio::rotation(random.direction<T>(), random.between<T>(0, 3));
        const auto map = raio::translation(random.point<T>(0.5)) * turn * raio::scaling<T>({size(), size(), size()});
        return raio::transformed{raio::sphere<T>{{0, 0, 0}, 1}, map};
    };
    bench::add<raio::transformed<raio::sphere<T>>, peers::instance<T>>("transformed", random_ellipsoid);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
