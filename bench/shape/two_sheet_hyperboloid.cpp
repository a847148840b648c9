#include <raio/shape/two_sheet_hyperboloid.hpp>

#include "support.hpp"

namespace {

template <class T>
void add() {
    const auto random_sheets = [](bench::generator& random) {
        const auto center = random.point<T>(0.5);
        const auto half = random.direction<T>() * random.between<T>(0.4, 1.0);
        return raio::two_sheet_hyperboloid<T>{center - half, center + half, random.between<T>(0.2, 0.5),
                                              random.between<T>(0.5, 1.0)};
    };
    bench::add<raio::two_sheet_hyperboloid<T>>("two_sheet_hyperboloid", random_sheets);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
