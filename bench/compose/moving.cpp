#include <raio/compose/moving.hpp>
#include <raio/shape/sphere.hpp>

#include "peers/next_week_moving_sphere.hpp"
#include "support.hpp"

namespace {

/// Rays are plain here: what moves brings their time.
template <class T>
struct at_a_time {
    using number = T;

    raio::moving<raio::sphere<T>> shape;
    T time;

    template <raio::record Record>
    bool hit(const raio::ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return shape.hit(raio::timed_ray<T>{ray, time}, t_min, t_max, rec);
    }
    bool occluded(const raio::ray<T>& ray, T t_min, T t_max) const {
        return shape.occluded(raio::timed_ray<T>{ray, time}, t_min, t_max);
    }
    raio::aabb<T> bounds() const { return shape.bounds(); }
};

template <class T>
void add() {
    const auto random_mover = [](bench::generator& random) {
        const raio::sphere<T> ball{{0, 0, 0}, random.between<T>(0.4, 1.2)};
        const auto from = raio::translation(random.point<T>(0.5)), to = raio::translation(random.point<T>(0.5));
        return at_a_time<T>{{ball, from, to}, random.between<T>(0, 1)};
    };
    bench::add<at_a_time<T>, peers::next_week_moving_sphere<T>>("moving", random_mover);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
