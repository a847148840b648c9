#include <raio/shape/sphere.hpp>

/// Whatever is not made part of this is a symbol of the object file.
bool hit(const raio::sphere<float>& sphere, const raio::ray<float>& ray, raio::hit_record<float>& rec) {
    return sphere.hit(ray, 0, raio::infinity<float>, rec);
}
