// Compiled, never run: what a kernel can ask of every shape.
#include <raio/raio.hpp>

#include <span>

namespace {

template <class Shape, class T = typename Shape::number>
__device__ void trace(const Shape& shape, raio::ray<T>& ray, raio::hit_record<T>& rec) {
    const T t_max = raio::infinity<T>;
    if (shape.hit(ray, T(0), t_max, rec)) ray = raio::spawn_ray(rec, rec.normal);
    if (shape.occluded(ray, T(0), t_max)) rec.t = t_max;
    rec.error = shape.bounds().max;
    if constexpr (raio::solid<Shape>) rec.t = raio::spans(shape.spans(ray)).begin()->min;
    if constexpr (raio::sampleable<Shape>) rec.t = shape.area() + shape.sample(rec.uv).normal.x;
}

}  // namespace

template <class T>
__global__ void every_shape(raio::ray<T>* rays, raio::hit_record<T>* records, const raio::vec3<T>* p,
                            std::span<const raio::half_space<T>> planes) {
    raio::ray<T>& ray = rays[threadIdx.x];
    raio::hit_record<T>& rec = records[threadIdx.x];
    const T radius = p[0].x;
    trace(raio::sphere<T>{p[1], radius}, ray, rec);
    trace(raio::plane<T>{p[1], p[2]}, ray, rec);
    trace(raio::disc<T>{p[1], p[2], radius}, ray, rec);
    trace(raio::triangle<T>{p[1], p[2], p[3]}, ray, rec);
    trace(raio::watertight_triangle<T>{p[1], p[2], p[3]}, ray, rec);
    trace(raio::box<T>{p[1], p[2]}, ray, rec);
    trace(raio::cylinder<T>{p[1], p[2], radius}, ray, rec);
    trace(raio::open_cylinder<T>{p[1], p[2], radius}, ray, rec);
    trace(raio::torus<T>{p[1], p[2], radius, radius}, ray, rec);
    trace(raio::convex_polyhedron<T, std::span<const raio::half_space<T>>>{planes}, ray, rec);
    trace(raio::ring<T>{p[1], p[2], radius, p[0].y}, ray, rec);
    trace(raio::capsule<T>{p[1], p[2], radius}, ray, rec);
    trace(raio::round_cone<T>{p[1], p[2], radius, p[0].y}, ray, rec);
    trace(raio::paraboloid<T>{p[1], p[2], radius}, ray, rec);
    trace(raio::regular_solid<20>(p[1], radius), ray, rec);
    trace(raio::group{raio::sphere<T>{p[1], radius}, raio::box<T>{p[1], p[2]}}, ray, rec);
    trace(raio::difference_of(raio::sphere<T>{p[1], radius}, raio::box<T>{p[1], p[2]}), ray, rec);
    trace(raio::transformed{raio::sphere<T>{p[1], radius}, raio::scaling(p[2])}, ray, rec);
}

template __global__ void every_shape(raio::ray<float>*, raio::hit_record<float>*, const raio::vec3<float>*,
                                     std::span<const raio::half_space<float>>);
template __global__ void every_shape(raio::ray<double>*, raio::hit_record<double>*, const raio::vec3<double>*,
                                     std::span<const raio::half_space<double>>);
