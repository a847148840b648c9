#include <raio/shape/box.hpp>

#include "peers/slabs.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    using slabs = peers::slabs<T>;
    const auto random_box = [](bench::generator& random) {
        const auto center = random.point<T>(0.5);
        const auto half = raio::vec3<T>(T(0.6)) + random.point<T>(0.3);
        return raio::box<T>{center - half, center + half};
    };
    bench::add<raio::box<T>, slabs, peers::with_record<slabs>>("box", random_box);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
