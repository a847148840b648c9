#include <raio/shape/polyhedra.hpp>

#include "peers/cyrus_beck.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    using solid = raio::polyhedron<T, 20>;
    using cyrus_beck = peers::cyrus_beck<T, decltype(solid::planes)>;
    const auto random_icosahedron = [](bench::generator& random) {
        const auto center = random.point<T>(0.5);
        return raio::regular_solid<20>(center, random.between<T>(0.6, 1.2));
    };
    bench::add<solid, cyrus_beck, peers::with_record<cyrus_beck>>("icosahedron", random_icosahedron);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
