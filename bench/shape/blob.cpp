#include <raio/shape/blob.hpp>

#include "support.hpp"

namespace {

/// Four components that melt into each other.
template <class T>
raio::blob<T, 4> random_blob(bench::generator& random) {
    raio::blob<T, 4> blob{{}, T(0.25f)};
    for (raio::metaball<T>& m : blob.components) {
        m = {random.point<T>(0.7), random.between<T>(0.7, 1.2), random.between<T>(0.5, 1.0)};
    }
    return blob;
}

}  // namespace

int main(int argc, char** argv) {
    bench::add<raio::blob<float, 4>>("blob", random_blob<float>);
    bench::add<raio::blob<double, 4>>("blob", random_blob<double>);
    return bench::run(argc, argv);
}
