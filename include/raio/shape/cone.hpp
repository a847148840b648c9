#pragma once

#include <raio/shape/frustum.hpp>

/// \file
/// Both cones: with its base one is a solid, without it a funnel. They are frusta whose upper radius is 0, and the apex
/// belongs to them; its normal is the axis.
///
/// Faces are counted side, base. uv of the side: u is the angle about the axis, from the x axis of
/// `frame_about(axis)`; v the height, 0 at the base and 1 at the apex. uv of the base: the same u, and v the distance
/// from the axis over the radius.

namespace raio {

/// The points between a disc and an apex over its centre: closed, a solid.
template <real T>
struct cone {
    using number = T;

    vec3<T> base;  ///< the centre of the cap
    vec3<T> apex;
    T radius;  ///< a length; the cone is missed unless it is positive and base and apex differ

    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr interval<T> spans(const ray<T>& ray) const { return inside_of(*this, ray); }

    RAIO_FN constexpr aabb<T> bounds() const { return as_frustum().bounds(); }

    RAIO_FN constexpr T area() const { return as_frustum().area(); }

    /// u.x chooses between the side and the base, and what is left of it is the angle.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const requires(std::same_as<mask_t<T>, bool>) {
        return as_frustum().sample(u);
    }

    template <class W, real R>
    RAIO_FORMULA constexpr chord<W> crossings(const ray<R>& ray) const {
        return as_frustum().template crossings<W>(ray);
    }

    template <class W, real R, real N>
    RAIO_FN constexpr void surface(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec) const {
        as_frustum().surface(ray, c, rec);
    }

private:
    RAIO_FN constexpr frustum<T> as_frustum() const { return {base, apex, radius, T(0)}; }
};

/// The side of a cone, seen from both sides.
template <real T>
struct open_cone {
    using number = T;

    vec3<T> base;  ///< the centre of the rim, which belongs to the cone
    vec3<T> apex;
    T radius;  ///< a length; the cone is missed unless it is positive and base and apex differ

    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr aabb<T> bounds() const { return as_frustum().bounds(); }

    RAIO_FN constexpr T area() const { return as_frustum().area(); }

    /// u.x turns about the axis, u.y is the area between the base and the point.
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const { return as_frustum().sample(u); }

    template <class W, real R>
    RAIO_FORMULA constexpr chord<W> crossings(const ray<R>& ray) const {
        return as_frustum().template crossings<W>(ray);
    }

    template <class W, real R, real N>
    RAIO_FN constexpr void surface(const ray<R>& ray, const crossing<W>& c, hit_record<T, N>& rec) const {
        as_frustum().surface(ray, c, rec);
    }

private:
    RAIO_FN constexpr open_frustum<T> as_frustum() const { return {base, apex, radius, T(0)}; }
};

}  // namespace raio
