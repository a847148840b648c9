#include <raio/shape/triangle.hpp>

#include "peers/glm.hpp"
#include "peers/moeller_trumbore.hpp"
#include "support.hpp"

namespace {

template <class T>
void add() {
    using glm_triangle = peers::glm_triangle<T>;
    using textbook = peers::moeller_trumbore<T>;
    const auto random_triangle = [](bench::generator& random) {
        const auto a = random.point<T>(1.0), b = random.point<T>(1.0);
        return raio::triangle<T>{a, b, random.point<T>(1.0)};
    };
    bench::add<raio::triangle<T>, glm_triangle, peers::with_record<glm_triangle>, textbook,
               peers::with_record<textbook>>("triangle", random_triangle);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
