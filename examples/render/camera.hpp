#pragma once

#include <cmath>

#include "scene.hpp"

namespace render {

/// Turns places on the picture into rays.
///
/// The convention is David Mount's, and two things in it are unusual: column 0, at the left of the picture, lies to the
/// right of the camera, so that pictures are mirrored; and a pixel is named by its lower outer corner, not by its
/// centre.
class camera {
public:
    camera(const camera_description& from, int width, int height)
        : eye_(from.eye),
          z_(raio::normalize(from.eye - from.look_at)),
          x_(raio::normalize(raio::cross(from.up, z_))),
          y_(raio::cross(z_, x_)),
          columns_(width),
          rows_(height),
          height_(2 * std::tan(from.vertical_field_of_view * raio::pi<number> / 360)),
          width_(height_ * columns_ / rows_),
          lens_radius_(from.aperture / 2),
          focus_distance_(from.focus_distance) {}

    /// The ray of a place on the picture: `column` from the left, `row` from the top, each counted to a pixel's corner
    /// that is named above; `offset` in [0, 1)^2 is the way from there across the pixel, `lens` a point in the unit
    /// disc.
    ray through(int column, int row, const vec2& offset, const vec2& lens) const {
        const number j = columns_ - 1 - column + offset.x, i = rows_ - 1 - row + offset.y;
        const vec3 direction =
            x_ * (width_ * j / columns_ - width_ / 2) + y_ * (height_ * i / rows_ - height_ / 2) - z_;
        const vec3 across = (x_ * lens.x + y_ * lens.y) * lens_radius_;
        return {eye_ + across, direction - across / focus_distance_};
    }

private:
    vec3 eye_, z_, x_, y_;
    number columns_, rows_, height_, width_;  // of the picture: counts of pixels, then lengths at distance 1
    number lens_radius_, focus_distance_;
};

}  // namespace render
