// Balls on the ground, coloured by their normals: normals PICTURE.ppm

#include <raio/raio.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>

using vec3 = raio::vec3<float>;

vec3 color(const auto& scene, const raio::ray<float>& ray) {
    raio::hit_record<float> rec;
    if (scene.hit(ray, 0, raio::infinity<float>, rec)) return 0.5f * rec.normal + 0.5f;  // from [-1, 1] to [0, 1]
    const float height = 0.5f * raio::normalize(ray.direction).y + 0.5f;
    return (1 - height) * vec3{1, 1, 1} + height * vec3{0.5f, 0.7f, 1};  // the sky
}

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s PICTURE.ppm\n", argv[0]);
        return 2;
    }
    constexpr int width = 640, height = 360;

    const raio::plane<float> ground{{0, -1, 0}, {0, 1, 0}};
    std::vector<raio::sphere<float>> balls{{{0, 0, 0}, 1}};
    for (float angle = 0; angle < 6.28f; angle += 0.5236f)  // twelve in a ring
        balls.push_back({{2 * std::cos(angle), -0.6f, 2 * std::sin(angle)}, 0.4f});
    const raio::group scene{ground, balls};

    std::ofstream picture(argv[1], std::ios::binary);
    picture << "P6\n" << width << ' ' << height << "\n255\n";
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const vec3 to_pixel(2 * x + 1 - width, height - 2 * y - 1, -5 * height / 2);
            const raio::vec3<unsigned char> pixel(255.0f * color(scene, {{0, 0.3f, 6}, to_pixel}) + 0.5f);
            picture << pixel.r << pixel.g << pixel.b;
        }
    if (!picture.flush()) {
        std::fprintf(stderr, "%s cannot be written\n", argv[1]);
        return 1;
    }
}
