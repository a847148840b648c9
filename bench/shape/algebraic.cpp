#include <raio/shape/algebraic.hpp>

#include "support.hpp"

namespace {

/// Goursat's rounded cube x^4 + y^4 + z^4 + a (x^2 + y^2 + z^2) = b, about the origin.
template <class T>
raio::algebraic<T, 4> random_goursat(bench::generator& random) {
    const T a = random.between<T>(-1.2, 0.5), b = random.between<T>(-0.2, 0.5);
    return {raio::vec3<T>(-1.2f),
            raio::vec3<T>(1.2f),
            {{1, 4, 0, 0}, {1, 0, 4, 0}, {1, 0, 0, 4}, {a, 2, 0, 0}, {a, 0, 2, 0}, {a, 0, 0, 2}, {-b, 0, 0, 0}}};
}

/// The same of twice the degree.
template <class T>
raio::algebraic<T, 8> random_cube(bench::generator& random) {
    const T a = random.between<T>(-1.2, 0.5), b = random.between<T>(-0.2, 0.5);
    return {raio::vec3<T>(-1.2f),
            raio::vec3<T>(1.2f),
            {{1, 8, 0, 0}, {1, 0, 8, 0}, {1, 0, 0, 8}, {a, 2, 0, 0}, {a, 0, 2, 0}, {a, 0, 0, 2}, {-b, 0, 0, 0}}};
}

template <class T>
void add() {
    bench::add<raio::algebraic<T, 4>>("algebraic", random_goursat<T>);
    bench::add<raio::algebraic<T, 8>>("algebraic_8", random_cube<T>);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
