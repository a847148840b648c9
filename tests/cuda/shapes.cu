// Compiled, never run: what a kernel can ask of every shape.
#include <raio/raio.hpp>

#include <array>
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
                            std::span<const raio::half_space<T>> planes,
                            std::span<const raio::algebraic_term<T>> terms) {
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
    trace(raio::ellipsoid<T>{p[1], p[2]}, ray, rec);
    trace(raio::parallelogram<T>{p[1], p[2], p[3]}, ray, rec);
    trace(raio::bilinear_patch<T>{p[1], p[2], p[3], p[4]}, ray, rec);
    trace(raio::cone<T>{p[1], p[2], radius}, ray, rec);
    trace(raio::open_cone<T>{p[1], p[2], radius}, ray, rec);
    trace(raio::frustum<T>{p[1], p[2], radius, p[0].y}, ray, rec);
    trace(raio::open_frustum<T>{p[1], p[2], radius, p[0].y}, ray, rec);
    trace(raio::paraboloid<T>{p[1], p[2], radius}, ray, rec);
    trace(raio::open_paraboloid<T>{p[1], p[2], radius}, ray, rec);
    trace(raio::hyperboloid<T>{p[1], p[2], radius, p[0].y}, ray, rec);
    trace(raio::open_hyperboloid<T>{p[1], p[2], radius, p[0].y}, ray, rec);
    trace(raio::two_sheet_hyperboloid<T>{p[1], p[2], radius, p[0].y}, ray, rec);
    trace(raio::open_two_sheet_hyperboloid<T>{p[1], p[2], radius, p[0].y}, ray, rec);
    trace(raio::quadric<T>{p[1], p[2], p[3], p[4], p[5], radius}, ray, rec);
    trace(raio::open_quadric<T>{p[1], p[2], p[3], p[4], p[5], radius}, ray, rec);
    trace(raio::algebraic<T, 8, true, std::span<const raio::algebraic_term<T>>>{p[1], p[2], terms}, ray, rec);
    trace(raio::steiner<T>{p[1], radius}, ray, rec);
    trace(raio::teardrop<T>{p[1], p[2], radius}, ray, rec);
    trace(raio::blob<T>{{{{p[1], radius}, {p[2], radius, T(1), p[3]}}}, p[0].y}, ray, rec);
    trace(raio::bezier_curve<T>{p[1], p[2], p[3], p[4], radius, radius, radius, p[0].y}, ray, rec);
    trace(raio::oriented_box(p[1], p[2], p[3], p[4]), ray, rec);
    trace(raio::tetrahedron(p[1], p[2], p[3], p[4]), ray, rec);
    trace(raio::pyramid(std::array{p[1], p[2], p[3]}, p[4]), ray, rec);
    trace(raio::prism(std::array{p[1], p[2], p[3]}, p[4]), ray, rec);
    trace(raio::regular_solid<20>(p[1], radius), ray, rec);
    trace(raio::group{raio::sphere<T>{p[1], radius}, raio::box<T>{p[1], p[2]}}, ray, rec);
    trace(raio::difference_of(raio::sphere<T>{p[1], radius}, raio::box<T>{p[1], p[2]}), ray, rec);
    trace(raio::transformed{raio::sphere<T>{p[1], radius}, raio::scaling(p[2])}, ray, rec);
}

template __global__ void every_shape(raio::ray<float>*, raio::hit_record<float>*, const raio::vec3<float>*,
                                     std::span<const raio::half_space<float>>,
                                     std::span<const raio::algebraic_term<float>>);
template __global__ void every_shape(raio::ray<double>*, raio::hit_record<double>*, const raio::vec3<double>*,
                                     std::span<const raio::half_space<double>>,
                                     std::span<const raio::algebraic_term<double>>);
