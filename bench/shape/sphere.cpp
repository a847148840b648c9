#include <raio/shape/sphere.hpp>

#include "peers/glm.hpp"
#include "peers/one_weekend.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    using glm_sphere = peers::glm_sphere<T>;
    const auto random_sphere = [](bench::generator& random) {
        const auto center = random.point<T>(0.5);
        return raio::sphere<T>{center, random.between<T>(0.5, 1.0)};
    };
    bench::add<raio::sphere<T>, peers::one_weekend_sphere<T>, peers::next_week_sphere<T>, glm_sphere,
               peers::with_record<glm_sphere>>("sphere", random_sphere);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
