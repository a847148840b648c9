#include <raio/compose/in_lanes.hpp>
#include <raio/number/simd.hpp>
#include <raio/shape/torus.hpp>

#include "support.hpp"

namespace {

/// A torus that is asked as the primitive of a lane. There is one lane, so that one call is one ray. (The second
/// parameter keeps it from being taken for a shape that can be one of packs.)
template <class T, class = void>
struct torus_in_a_lane {
    using number = T;
    using P = raio::pack<T, 1>;

    raio::torus<T> torus;

    bool hit(const raio::ray<T>& ray, T t_min, T t_max, raio::hit_record<T>& rec) const {
        raio::hit_record<P> in_lanes;
        if (!any(raio::in_every_lane<P>(torus).hit(packed(ray), P(t_min), P(t_max), in_lanes))) return false;
        rec.t = in_lanes.t[0];
        benchmark::DoNotOptimize(in_lanes);
        return true;
    }
    bool occluded(const raio::ray<T>& ray, T t_min, T t_max) const {
        return any(raio::in_every_lane<P>(torus).occluded(packed(ray), P(t_min), P(t_max)));
    }

private:
    static raio::ray<P> packed(const raio::ray<T>& ray) {
        return {raio::vec3<P>(ray.origin), raio::vec3<P>(ray.direction)};
    }
};

/// The peer: the torus itself.
template <class T>
struct plain : bench::hit<torus_in_a_lane<T>> {
    static constexpr const char* name = "plain";

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, raio::hit_record<T>& rec) const {
        return this->shape.torus.hit(ray, t_min, t_max, rec);
    }
};

template <class T>
void add() {
    bench::add<torus_in_a_lane<T>, plain<T>>("in_lanes", [](bench::generator& random) {
        const auto center = random.point<T>(0.2);
        return torus_in_a_lane<T>{{center, random.direction<T>(), T(1), random.between<T>(0.1, 0.6)}};
    });
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
