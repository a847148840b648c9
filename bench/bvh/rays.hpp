#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bvh/scenes.hpp"
#include "support.hpp"

/// \file
/// The rays that are traced: a picture of 1024 x 1024, and what leaves the points that it shows.

namespace bench {

inline constexpr int picture_side = 1024;

/// Rays of one kind. All begin at t = 0.
struct ray_set {
    std::string name;
    std::vector<raio::ray<float>> rays;
    float t_max;
    bool any;  ///< is it asked whether something is hit, rather than what?
};

/// One ray for each pixel, row by row.
inline std::vector<raio::ray<float>> primary_rays(const camera& view) {
    using vec3 = raio::vec3<float>;
    const vec3 back = raio::normalize(view.eye - view.look_at);
    const vec3 right = raio::normalize(raio::cross(vec3(0, 1, 0), back)), up = raio::cross(back, right);
    std::vector<raio::ray<float>> rays;
    rays.reserve(std::size_t(picture_side) * picture_side);
    const auto offset = [&](int pixel) {
        return view.half_width * (2 * (float(pixel) + 0.5f) / float(picture_side) - 1);
    };
    for (int row = 0; row < picture_side; ++row) {
        for (int column = 0; column < picture_side; ++column) {
            rays.push_back({view.eye, raio::normalize(right * offset(column) - up * offset(row) - back)});
        }
    }
    return rays;
}

/// The rays of a picture, square by square of 8 x 8 pixels, and each of these by its quarters: as many as raio takes
/// together are one after the other, and so are the sixteen that Embree does.
inline constexpr int square_side = 8, quarter_side = 4;
inline std::vector<raio::ray<float>> in_squares(const std::vector<raio::ray<float>>& picture) {
    std::vector<raio::ray<float>> squares;
    squares.reserve(picture.size());
    const auto place = [](int i, int side) { return std::pair(i / side, i % side); };
    constexpr int in_quarter = quarter_side * quarter_side, in_square = square_side * square_side;
    for (int i = 0; i < picture_side * picture_side; ++i) {
        const auto [row, column] = place(i / in_square, picture_side / square_side);
        const auto [quarter_row, quarter_column] = place(i % in_square / in_quarter, square_side / quarter_side);
        const auto [pixel_row, pixel_column] = place(i % in_quarter, quarter_side);
        const int y = row * square_side + quarter_row * quarter_side + pixel_row;
        const int x = column * square_side + quarter_column * quarter_side + pixel_column;
        squares.push_back(picture[static_cast<std::size_t>(y * picture_side + x)]);
    }
    return squares;
}

/// One ray from each point that a ray meets first, in the same order, its direction distributed as the cosine.
template <class Tree>
std::vector<raio::ray<float>> bounced(const std::vector<raio::ray<float>>& rays, const Tree& tree) {
    generator random;
    std::vector<raio::ray<float>> bounces;
    for (const auto& ray : rays) {
        raio::hit_record<float> rec;
        if (!tree.hit(ray, 0, raio::infinity<float>, rec)) continue;
        const raio::vec3<float> direction = raio::normalize(rec.normal * 1.001f + random.direction<float>());
        bounces.push_back(raio::spawn_ray(rec, direction));
    }
    return bounces;
}

/// The four kinds that every tree is measured with, and the first of them in packets.
template <class Tree>
std::vector<ray_set> ray_sets(const camera& view, const Tree& tree) {
    const auto box = tree.bounds();
    const auto primary = primary_rays(view), bounce = bounced(primary, tree);
    auto shuffled = bounce;
    generator random;
    for (std::size_t i = shuffled.size(); i > 1; --i) std::swap(shuffled[i - 1], shuffled[random.below(i)]);
    const float everywhere = raio::infinity<float>, near = 0.2f * raio::length(box.max - box.min);
    return {{"primary", primary, everywhere, false},
            {"bounce", bounce, everywhere, false},
            {"shuffled", std::move(shuffled), everywhere, false},
            {"occlusion", bounce, near, true},
            {"packets", in_squares(primary), everywhere, false}};
}

}  // namespace bench
