#include <raio/raio.hpp>

#include "support.hpp"

// One file with many shapes, as renderers have: what a compiler inlines where a file has one shape it may call here.

namespace {

template <class T>
void add() {
    using bench::generator;
    const auto center = [](generator& random) { return random.point<T>(0.5); };
    const auto axis = [](generator& random) { return random.direction<T>() * random.between<T>(0.8, 2.0); };
    const auto radius = [](generator& random) { return random.between<T>(0.4, 1.0); };
    // From the base to the top and the radius: cylinders, cones and capsules.
    const auto add_axial = [&]<class Shape>(std::type_identity<Shape>, const char* name) {
        bench::add<Shape>(name, [&](generator& random) {
            const auto base = center(random) - axis(random) * T(0.5), along = axis(random);
            return Shape{base, base + along, radius(random)};
        });
    };
    bench::add<raio::sphere<T>>("many_shapes_sphere", [&](generator& random) {
        const auto at = center(random);
        return raio::sphere<T>{at, radius(random)};
    });
    bench::add<raio::plane<T>>("many_shapes_plane", [&](generator& random) {
        const auto at = center(random);
        return raio::plane<T>{at, axis(random)};
    });
    bench::add<raio::triangle<T>>("many_shapes_triangle", [&](generator& random) {
        const auto a = center(random), b = a + axis(random);
        return raio::triangle<T>{a, b, a + axis(random)};
    });
    bench::add<raio::box<T>>("many_shapes_box", [&](generator& random) {
        const auto at = center(random), half = raio::abs(axis(random)) * T(0.5);
        return raio::box<T>{at - half, at + half};
    });
    add_axial(std::type_identity<raio::cylinder<T>>{}, "many_shapes_cylinder");
    add_axial(std::type_identity<raio::cone<T>>{}, "many_shapes_cone");
    add_axial(std::type_identity<raio::capsule<T>>{}, "many_shapes_capsule");
    bench::add<raio::torus<T>>("many_shapes_torus", [&](generator& random) {
        const auto at = center(random), up = axis(random);
        return raio::torus<T>{at, up, T(1), random.between<T>(0.2, 0.5)};
    });
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
