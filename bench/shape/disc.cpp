#include <raio/shape/disc.hpp>

#include "peers/glm.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    using glm_disc = peers::glm_disc<T>;
    const auto random_disc = [](bench::generator& random) {
        const auto center = random.point<T>(0.5), normal = random.direction<T>();
        return raio::disc<T>{center, normal, random.between<T>(0.5, 1.0)};
    };
    bench::add<raio::disc<T>, glm_disc, peers::with_record<glm_disc>>("disc", random_disc);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
