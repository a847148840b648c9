#include "any_shape.hpp"

#include <cmath>

#include <raio/compose/transformed.hpp>

namespace render {
namespace {

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

}  // namespace

any_shape any_shape::under(const raio::transform<double>& map) const {
    const raio::any_primitive<double>& surface = *this;
    any_shape image = solid_ ? any_shape(raio::any_solid<double>(raio::transformed(*solid_, map)))
                             : any_shape(raio::any_primitive<double>(raio::transformed(surface, map)));
    if (make_sampler_) {
        image.make_sampler_ = [make = make_sampler_, map]() -> std::shared_ptr<const surface_sampler> {
            const auto of_this = make();
            return of_this ? std::make_shared<const mapped_sampler>(of_this, map) : nullptr;
        };
    }
    return image;
}

}  // namespace render
