#pragma once

#ifndef GLM_ENABLE_EXPERIMENTAL
#define GLM_ENABLE_EXPERIMENTAL
#endif
#include <glm/geometric.hpp>
#include <glm/gtx/intersect.hpp>

#include <raio/shape/disc.hpp>
#include <raio/shape/plane.hpp>
#include <raio/shape/sphere.hpp>
#include <raio/shape/triangle.hpp>

#include "peers/record.hpp"

/// \file
/// glm/gtx/intersect.hpp. It finds t (and for triangles the barycentrics), knows no window, and is right for unit
/// directions, in front of the origin, at a moderate scale.

namespace peers {

template <class T>
struct glm_call {
    static constexpr const char* name = "glm";
    static constexpr const char* name_with_record = "glm_record";
    using number = T;
    struct result {
        T t;
    };
};

template <class T>
struct glm_sphere : glm_call<T> {
    raio::vec3<T> center;
    T radius_squared;

    explicit glm_sphere(const raio::sphere<T>& shape)
        : center(shape.center), radius_squared(shape.radius * shape.radius) {}

    bool operator()(const raio::ray<T>& ray, T, T, typename glm_call<T>::result& found) const {
        return glm::intersectRaySphere(ray.origin, ray.direction, center, radius_squared, found.t);
    }
    raio::vec3<T> outward_normal(const raio::vec3<T>& point) const { return glm::normalize(point - center); }
};

template <class T>
struct glm_plane : glm_call<T> {
    raio::vec3<T> point, normal;

    explicit glm_plane(const raio::plane<T>& shape) : point(shape.point), normal(shape.normal) {}

    bool operator()(const raio::ray<T>& ray, T, T, typename glm_call<T>::result& found) const {
        return glm::intersectRayPlane(ray.origin, ray.direction, point, normal, found.t);
    }
    raio::vec3<T> outward_normal(const raio::vec3<T>&) const { return glm::normalize(normal); }
};

/// The plane, then the distance from the centre.
template <class T>
struct glm_disc : glm_call<T> {
    raio::vec3<T> center, normal;
    T radius_squared;

    explicit glm_disc(const raio::disc<T>& shape)
        : center(shape.center), normal(shape.normal), radius_squared(shape.radius * shape.radius) {}

    bool operator()(const raio::ray<T>& ray, T, T, typename glm_call<T>::result& found) const {
        if (!glm::intersectRayPlane(ray.origin, ray.direction, center, normal, found.t)) return false;
        const raio::vec3<T> from_center = ray.origin + ray.direction * found.t - center;
        return glm::dot(from_center, from_center) <= radius_squared;
    }
    raio::vec3<T> outward_normal(const raio::vec3<T>&) const { return glm::normalize(normal); }
};

template <class T>
struct glm_triangle : glm_call<T> {
    raio::vec3<T> a, b, c;
    struct result {
        T t;
        raio::vec2<T> uv;
    };

    /// `Triangle`: any triangle with the corners a, b and c.
    template <class Triangle>
    explicit glm_triangle(const Triangle& shape) : a(shape.a), b(shape.b), c(shape.c) {}

    bool operator()(const raio::ray<T>& ray, T, T, result& found) const {
        return glm::intersectRayTriangle(ray.origin, ray.direction, a, b, c, found.uv, found.t);
    }
    raio::vec3<T> outward_normal(const raio::vec3<T>&) const { return glm::normalize(glm::cross(b - a, c - a)); }
};

}  // namespace peers
