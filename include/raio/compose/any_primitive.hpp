#pragma once

#include <raio/push_macros.hpp>

#include <memory>

#include <raio/compose/group.hpp>
#include <raio/math/any_number_of_spans.hpp>
#include <raio/proof/mapped_ray.hpp>

namespace raio::inline RAIO_ABI {

namespace detail {

/// What can be asked of a primitive that is not known before the program runs, with a ray as it is or mapped.
template <real T>
struct erased {
    using list = raio::spans<T, any_number>;

    virtual ~erased() = default;
    virtual mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const = 0;
    virtual mask_t<T> hit(const mapped_ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const = 0;
    virtual mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const = 0;
    virtual mask_t<T> occluded(const mapped_ray<T>& ray, T t_min, T t_max) const = 0;
    virtual aabb<T> bounds() const = 0;
};

template <real T>
struct erased_solid : erased<T> {
    using typename erased<T>::list;

    virtual list spans(const ray<T>& ray) const = 0;
    virtual list spans(const mapped_ray<T>& ray) const = 0;
};

template <primitive P, class Interface>
struct erased_shape : Interface {
    using T = number_t<P>;

    P shape;

    explicit erased_shape(P from) : shape(std::move(from)) {}

    mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const final {
        return detail::hit(shape, ray, t_min, t_max, rec);
    }
    mask_t<T> hit(const mapped_ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const final {
        return detail::hit(shape, ray, t_min, t_max, rec);
    }
    mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const final { return shape.occluded(ray, t_min, t_max); }
    mask_t<T> occluded(const mapped_ray<T>& ray, T t_min, T t_max) const final {
        return detail::occluded(shape, ray, t_min, t_max);
    }
    aabb<T> bounds() const final {
        if constexpr (bounded<P>) {
            return shape.bounds();
        } else {
            return unbounded<T>();
        }
    }
};

template <solid P>
struct erased_solid_shape final : erased_shape<P, erased_solid<number_t<P>>> {
    using T = number_t<P>;
    using typename erased_solid<T>::list;
    using erased_shape<P, erased_solid<T>>::erased_shape;

    list spans(const ray<T>& ray) const override { return listed(ray); }
    list spans(const mapped_ray<T>& ray) const override { return listed(ray); }

private:
    template <class Ray>
    list listed(const Ray& ray) const {
        list all;
        for (const interval<T>& i : raio::spans(spans_of(this->shape, ray))) all.append(i);
        return all;
    }
};

}  // namespace detail

/// Any primitive of the number type T, for scenes that are known only when the program runs. It is immutable: copies
/// share it. Of a ray and a record it is given what is raio's. What it costs beside a group of ranges, one for each
/// type, is one call that cannot be inlined, and a memory of its own for each primitive.
template <real T>
class any_primitive {
public:
    using number = T;

    template <primitive P>
    requires(std::same_as<number_t<P>, T> && !std::derived_from<P, any_primitive>) any_primitive(P shape)
        : shape_(std::make_shared<const detail::erased_shape<P, detail::erased<T>>>(std::move(shape))) {}

    template <ray_of<T> Ray = raio::ray<T>, record Record>
    mask_t<T> hit(const Ray& ray, T t_min, T t_max, Record& rec) const {
        if constexpr (std::same_as<Record, hit_record<T>>) {
            return shape_->hit(ray, t_min, t_max, rec);
        } else {
            return detail::hit_in_between(*this, ray, t_min, t_max, rec);
        }
    }
    template <ray_of<T> Ray = raio::ray<T>>
    mask_t<T> occluded(const Ray& ray, T t_min, T t_max) const {
        return shape_->occluded(ray, t_min, t_max);
    }
    /// Everything, if the primitive knows no bounds.
    aabb<T> bounds() const { return shape_->bounds(); }

protected:
    explicit any_primitive(std::shared_ptr<const detail::erased<T>> shape) : shape_(std::move(shape)) {}

    std::shared_ptr<const detail::erased<T>> shape_;
};

/// Any solid of the number type T; an any_primitive as well. With it, trees of `csg` can be built while the program
/// runs. Its spans stand in memory that is allocated for each ray.
template <real T>
class any_solid : public any_primitive<T> {
public:
    template <solid P>
    requires(std::same_as<number_t<P>, T> && !std::derived_from<P, any_solid>) any_solid(P shape)
        : any_primitive<T>(std::make_shared<const detail::erased_solid_shape<P>>(std::move(shape))) {}

    template <ray_of<T> Ray = raio::ray<T>>
    raio::spans<T, any_number> spans(const Ray& ray) const {
        return solid().spans(ray);
    }

private:
    const detail::erased_solid<T>& solid() const { return static_cast<const detail::erased_solid<T>&>(*this->shape_); }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
