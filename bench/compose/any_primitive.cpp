#include <raio/compose/any_primitive.hpp>
#include <raio/compose/group.hpp>
#include <raio/shape/sphere.hpp>
#include <raio/shape/triangle.hpp>

#include <array>
#include <vector>

#include "support.hpp"

namespace {

/// The same scene with and without its types: eight spheres and eight triangles.
template <class T>
struct both_ways {
    using number = T;
    using fixed_scene = raio::group<std::array<raio::sphere<T>, 8>, std::array<raio::triangle<T>, 8>>;
    using erased_scene = raio::group<std::vector<raio::any_primitive<T>>>;

    fixed_scene fixed;
    erased_scene erased;

    explicit both_ways(const fixed_scene& scene) : fixed(scene) {
        auto& members = std::get<0>(erased.members);
        for (const auto& sphere : std::get<0>(scene.members)) members.emplace_back(sphere);
        for (const auto& triangle : std::get<1>(scene.members)) members.emplace_back(triangle);
    }

    bool hit(const raio::ray<T>& ray, T t_min, T t_max, raio::hit_record<T>& rec) const {
        return erased.hit(ray, t_min, t_max, rec);
    }
    bool occluded(const raio::ray<T>& ray, T t_min, T t_max) const { return erased.occluded(ray, t_min, t_max); }
};

/// The peer: the group that knows the types.
template <class T>
struct static_group : bench::hit<both_ways<T>> {
    static constexpr const char* name = "static_group";

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, raio::hit_record<T>& rec) const {
        return this->shape.fixed.hit(ray, t_min, t_max, rec);
    }
};

template <class T>
void add() {
    const auto random_scene = [](bench::generator& random) {
        typename both_ways<T>::fixed_scene scene;
        for (auto& sphere : std::get<0>(scene.members)) {
            const auto center = random.point<T>(1.0);
            sphere = {center, random.between<T>(0.1, 0.4)};
        }
        for (auto& triangle : std::get<1>(scene.members)) {
            const auto a = random.point<T>(1.0), b = a + random.point<T>(0.6);
            triangle = {a, b, a + random.point<T>(0.6)};
        }
        return both_ways<T>(scene);
    };
    bench::add<both_ways<T>, static_group<T>>("any_primitive", random_scene);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
