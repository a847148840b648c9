#include <raio/shape/plane.hpp>

#include "peers/glm.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    using glm_plane = peers::glm_plane<T>;
    const auto random_plane = [](bench::generator& random) {
        const auto point = random.point<T>(0.5);
        return raio::plane<T>{point, random.direction<T>()};
    };
    bench::add<raio::plane<T>, glm_plane, peers::with_record<glm_plane>>("plane", random_plane);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
