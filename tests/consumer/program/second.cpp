// The same header again: a function that lacks `inline` is now defined twice, and the linker says so.
#include <raio/raio.hpp>

bool seen_from_the_other_file(const raio::ray<double>& ray);

bool seen_from_the_other_file(const raio::ray<double>& ray) {
    const raio::sphere<double> sphere{{0, 0, -2}, 1};
    raio::hit_record<double> rec{};
    return sphere.hit(ray, 0, raio::infinity<double>, rec) && rec.t == 1;
}
