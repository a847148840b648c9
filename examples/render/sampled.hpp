#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include <raio/raio.hpp>

/// \file
/// Shapes that have an area and are kept as what they can do: `raio::any_primitive` and `raio::any_solid` forget how
/// points are chosen on them, which area lights need.

namespace render {

/// How points are chosen on a surface.
struct surface_sampler {
    virtual ~surface_sampler() = default;
    virtual raio::surface_sample<double> sample(const raio::vec2<double>& u) const = 0;
    /// How densely `sample` chooses points per area, where the surface has this unit normal, of either side.
    virtual double density(const raio::vec3<double>& normal) const = 0;
};

/// Points of a shape are chosen evenly over its area.
template <raio::sampleable Shape>
class even_sampler final : public surface_sampler {
public:
    even_sampler(Shape s, double area) : shape_(std::move(s)), density_(1 / area) {}

    raio::surface_sample<double> sample(const raio::vec2<double>& u) const override { return shape_.sample(u); }
    double density(const raio::vec3<double>&) const override { return density_; }

private:
    Shape shape_;
    double density_;
};

/// Points are chosen on a surface, and mapped.
///
/// A map L of vectors makes of a piece of area with the unit normal m one |det L| |L^-T m| times as large, whose normal
/// n is L^-T m, normalized. So m is L^T n, normalized, and |L^-T m| = 1 / |L^T n|.
class mapped_sampler final : public surface_sampler {
public:
    mapped_sampler(std::shared_ptr<const surface_sampler> from, const raio::transform<double>& map)
        : from_(std::move(from)), map_(map), volume_(raio::dot(map.x, raio::cross(map.y, map.z))) {}

    raio::surface_sample<double> sample(const raio::vec2<double>& u) const override {
        const auto [point, normal] = from_->sample(u);
        // The columns of L^-T times the determinant; its sign keeps outside what was outside.
        const raio::vec3<double> across = raio::cross(map_.y, map_.z) * normal.x +
                                          raio::cross(map_.z, map_.x) * normal.y +
                                          raio::cross(map_.x, map_.y) * normal.z;
        return {map_.point(point), raio::normalize(volume_ < 0 ? -across : across)};
    }
    double density(const raio::vec3<double>& normal) const override {
        const raio::vec3<double> back(raio::dot(map_.x, normal), raio::dot(map_.y, normal), raio::dot(map_.z, normal));
        const double length = raio::length(back);
        return from_->density(back / length) * length / std::abs(volume_);
    }

private:
    std::shared_ptr<const surface_sampler> from_;
    raio::transform<double> map_;
    double volume_;  ///< of what the unit cube becomes, negative if it is mirrored
};

/// `Any` is `raio::any_primitive` or `raio::any_solid`, and `make` makes what chooses points on it, for which few
/// shapes are asked.
template <class Any>
class sampled : public Any {
public:
    using maker = std::function<std::shared_ptr<const surface_sampler>()>;

    sampled(Any shape, maker make) : Any(std::move(shape)), make_(std::move(make)) {}

    std::shared_ptr<const surface_sampler> sampler() const { return make_(); }

private:
    maker make_;
};

/// Can points be chosen on shapes of this type?
template <class Shape>
concept with_sampler = raio::sampleable<Shape> || requires(const Shape s) {
    s.sampler();
};

/// What chooses points on a shape; nothing where none can be chosen, or where it has no area.
template <class Shape>
std::shared_ptr<const surface_sampler> sampler_of(const Shape& s) {
    if constexpr (raio::sampleable<Shape>) {
        const double area = s.area();
        if (area > 0 && area < raio::infinity<double>) return std::make_shared<const even_sampler<Shape>>(s, area);
    } else if constexpr (with_sampler<Shape>) {
        return s.sampler();
    }
    return nullptr;
}

}  // namespace render
