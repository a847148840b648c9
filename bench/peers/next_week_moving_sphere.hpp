#pragma once

#include "peers/one_weekend.hpp"

namespace peers {

/// The moving sphere of *The Next Week*: its center at the ray's time, and then the sphere of *One Weekend*.
template <class T>
struct next_week_moving_sphere {
    static constexpr const char* name = "next_week";
    using result = record<T>;

    one_weekend_sphere<T> sphere;
    raio::vec3<T> from, by;
    T time;

    template <class Moving>
    explicit next_week_moving_sphere(const Moving& of)
        : sphere(of.shape.primitive()),
          from(of.shape.map(0).origin),
          by(of.shape.map(1).origin - from),
          time(of.time) {}

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        const raio::ray<T> back{ray.origin - (from + by * time), ray.direction};
        if (!sphere(back, t_min, t_max, rec)) return false;
        rec.point = ray.origin + ray.direction * rec.t;
        return true;
    }
};

}  // namespace peers
