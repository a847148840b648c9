#include <raio/raio.hpp>

#include <cstdio>

int main() {
    const raio::sphere<float> sphere{{0, 0, -3}, 1};       // center, radius
    const raio::ray<float> ray{{0, 0, 0}, {0, 0.2f, -1}};  // origin, direction

    raio::hit_record<float> rec;
    if (sphere.hit(ray, 0, raio::infinity<float>, rec))
        std::printf("met at t = %g, normal (%g, %g, %g)\n", rec.t, rec.normal.x, rec.normal.y, rec.normal.z);
}
