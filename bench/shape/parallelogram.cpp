#include <raio/shape/parallelogram.hpp>

#include "peers/next_week_quad.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    const auto random_parallelogram = [](bench::generator& random) {
        const auto corner = random.point<T>(1.0), u = random.direction<T>();
        return raio::parallelogram<T>{corner, u, random.direction<T>()};
    };
    bench::add<raio::parallelogram<T>, peers::next_week_quad<T>>("parallelogram", random_parallelogram);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
