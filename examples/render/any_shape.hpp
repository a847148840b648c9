#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <typeinfo>
#include <utility>

#include <raio/compose/any_primitive.hpp>
#include <raio/math/transform.hpp>
#include <raio/surface_sample.hpp>

/// \file
/// Shapes as what they can do: be hit, be combined if they are solids, and be sampled, which area lights need.

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

/// What chooses points on a shape; nothing where none can be chosen, or where it has no area.
template <class Shape>
std::shared_ptr<const surface_sampler> sampler_of(const Shape& s) {
    if constexpr (raio::sampleable<Shape>) {
        const double area = s.area();
        if (area > 0 && area < raio::infinity<double>) return std::make_shared<const even_sampler<Shape>>(s, area);
    }
    return nullptr;
}

/// A shape that is known once the scene is read, as what it can do. Each type of shape is compiled here and nowhere
/// else.
class any_shape : public raio::any_primitive<double> {
public:
    template <raio::primitive Shape>
    requires(!std::derived_from<Shape, raio::any_primitive<double>>) any_shape(Shape s)
        : any_shape(std::make_shared<const Shape>(std::move(s))) {}
    any_shape(raio::any_solid<double> solid) : raio::any_primitive<double>(solid), solid_(std::move(solid)) {}

    /// The solid that it is; nothing where it has no inside.
    const std::optional<raio::any_solid<double>>& solid() const { return solid_; }

    /// The shape itself, if it is of that type and not transformed.
    template <class Shape>
    const Shape* as() const {
        return type_ && *type_ == typeid(Shape) ? static_cast<const Shape*>(shape_.get()) : nullptr;
    }

    /// What chooses points on it. (Few shapes are asked.)
    std::shared_ptr<const surface_sampler> sampler() const { return make_sampler_ ? make_sampler_() : nullptr; }

    /// The shape under a map; still a solid if it is one, and an area light if it can be one.
    any_shape under(const raio::transform<double>& map) const;

private:
    template <class Shape>
    static auto erased(const Shape& s) {
        if constexpr (raio::solid<Shape>) {
            return raio::any_solid<double>(s);
        } else {
            return raio::any_primitive<double>(s);
        }
    }

    explicit any_shape(raio::any_primitive<double> surface) : raio::any_primitive<double>(std::move(surface)) {}
    template <class Shape>
    explicit any_shape(const std::shared_ptr<const Shape>& s) : any_shape(erased(*s)) {
        shape_ = s;
        type_ = &typeid(Shape);
        if constexpr (raio::sampleable<Shape>) make_sampler_ = [s] { return sampler_of(*s); };
    }

    std::optional<raio::any_solid<double>> solid_;
    std::shared_ptr<const void> shape_;
    const std::type_info* type_ = nullptr;
    std::function<std::shared_ptr<const surface_sampler>()> make_sampler_;
};

}  // namespace render
