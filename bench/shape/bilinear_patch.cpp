#include <raio/shape/bilinear_patch.hpp>

#include "peers/cool_patch.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    const auto random_patch = [](bench::generator& random) {
        const auto a = random.point<T>(1.0), b = random.point<T>(1.0), c = random.point<T>(1.0);
        return raio::bilinear_patch<T>{a, b, c, random.point<T>(1.0)};
    };
    bench::add<raio::bilinear_patch<T>, peers::cool_patch<T>>("bilinear_patch", random_patch);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
