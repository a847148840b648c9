#include <raio/shape/steiner.hpp>

#include "support.hpp"

namespace {

template <class T>
raio::steiner<T> random_steiner(bench::generator& random) {
    return {random.point<T>(0.5), random.between<T>(1.5, 2.5)};
}

}  // namespace

int main(int argc, char** argv) {
    bench::add<raio::steiner<float>>("steiner", random_steiner<float>);
    bench::add<raio::steiner<double>>("steiner", random_steiner<double>);
    return bench::run(argc, argv);
}
