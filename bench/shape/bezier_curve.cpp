#include <raio/shape/bezier_curve.hpp>

#include "support.hpp"

namespace {

/// As thick as a tenth of its length, to a third.
template <class T>
void add() {
    const auto random_curve = [](bench::generator& random) {
        const auto p0 = random.point<T>(0.8), p1 = random.point<T>(0.8), p2 = random.point<T>(0.8),
                   p3 = random.point<T>(0.8);
        const T r0 = random.between<T>(0.1, 0.3), r1 = random.between<T>(0.1, 0.3), r2 = random.between<T>(0.1, 0.3);
        return raio::bezier_curve<T>{p0, p1, p2, p3, r0, r1, r2, random.between<T>(0.1, 0.3)};
    };
    bench::add<raio::bezier_curve<T>>("bezier_curve", random_curve);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
