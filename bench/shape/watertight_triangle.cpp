#include <raio/shape/watertight_triangle.hpp>

#include "peers/glm.hpp"
#include "peers/woop.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    using glm_triangle = peers::glm_triangle<T>;
    const auto random_triangle = [](bench::generator& random) {
        const auto a = random.point<T>(1.0), b = random.point<T>(1.0);
        return raio::watertight_triangle<T>{a, b, random.point<T>(1.0)};
    };
    bench::add<raio::watertight_triangle<T>, peers::woop<T>, glm_triangle, peers::with_record<glm_triangle>>(
        "watertight_triangle", random_triangle);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
