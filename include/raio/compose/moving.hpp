#pragma once

#include <raio/push_macros.hpp>

#include <raio/compose/transformed.hpp>

namespace raio::inline RAIO_ABI {

/// A primitive that moves from one affine map to another while time goes from 0 to 1, each of its points straight and
/// evenly: what is shot, falls, slides or grows. (Where it turns, by small angles: halfway through half a turn it would
/// be flat.) It is asked with rays that have a time, and before 0 and after 1 it is missed.
///
///     const raio::sphere<float> ball{{0, 0, 0}, 1};
///     const raio::moving rising{ball, raio::transform<float>{}, raio::translation<float>({0, 2, 0})};
///     rising.hit(raio::timed_ray<float>{{origin, direction}, time}, 0, t_max, rec);
///
/// A ray meets what it meets of `transformed{primitive, map(time)}`, bit for bit. In trees, groups, maps and CSG it is
/// asked with such rays as well.
template <holder Primitive>
class moving {
    using P = detail::held_t<Primitive>;

public:
    using number = number_t<P>;
    using T = number;

    RAIO_FN constexpr moving(Primitive primitive, const transform<T>& from, const transform<T>& to)
        : primitive_(std::move(primitive)),
          from_(from),
          to_(to),
          keeps_shape_(from.x == to.x && from.y == to.y && from.z == to.z) {}

    RAIO_FN constexpr const P& primitive() const { return detail::held(primitive_); }

    /// Where it is at that time.
    RAIO_FN constexpr transform<T> map(T time) const {
        using W = wider_t<T>;
        const W past(time), left = W(1) - past;
        const auto between = [&](const vec3<T>& a, const vec3<T>& b) {
            return vec3<T>(product_as<W>(a, left) + product_as<W>(b, past));
        };
        transform<T> now = from_.map();
        now.origin = between(now.origin, to_.origin);
        if (!keeps_shape_) now.x = between(now.x, to_.x), now.y = between(now.y, to_.y), now.z = between(now.z, to_.z);
        return now;
    }

    template <ray_of<T> Ray, record Record>
    RAIO_FLATTEN RAIO_FN constexpr bool hit(const Ray& ray, T t_min, T t_max, Record& rec) const {
        const T time = time_of(ray);
        if (!is_there(time)) return false;
        const inverse_map<T> inverse = inverse_at(time);
        return detail::hit(primitive(), detail::mapped(ray, inverse), t_min, t_max, rec);
    }

    template <ray_of<T> Ray>
    RAIO_FLATTEN RAIO_FN constexpr bool occluded(const Ray& ray, T t_min, T t_max) const {
        const T time = time_of(ray);
        if (!is_there(time)) return false;
        const inverse_map<T> inverse = inverse_at(time);
        return detail::occluded(primitive(), detail::mapped(ray, inverse), t_min, t_max);
    }

    /// A ray without a time is inside nowhere.
    template <ray_of<T> Ray>
    RAIO_FN constexpr auto spans(const Ray& ray) const requires(solid<P>) {
        decltype(detail::spans_of(primitive(), detail::mapped(ray, from_))) inside{};
        if constexpr (has_time<Ray>) {
            if (is_there(time_of(ray))) {
                const inverse_map<T> inverse = inverse_at(time_of(ray));
                inside = detail::spans_of(primitive(), detail::mapped(ray, inverse));
            }
        }
        return inside;
    }

    /// Of all times: as its points go straight, none leaves the hull of the first and the last.
    RAIO_FN constexpr aabb<T> bounds() const requires(bounded<P>) {
        const aabb<T> first = transformed{&primitive(), from_.map()}.bounds();
        const aabb<T> last = transformed{&primitive(), to_}.bounds();
        const aabb<T> own = primitive().bounds();
        if (!(own.min.x <= own.max.x)) return own;
        // What is between two maps is rounded to T.
        const vec3<T> reach(max(abs(own.min.x), abs(own.max.x)), max(abs(own.min.y), abs(own.max.y)),
                            max(abs(own.min.z), abs(own.max.z)));
        const auto off_by = [&](const transform<T>& map) {
            return (abs(map.x) * reach.x + abs(map.y) * reach.y + abs(map.z) * reach.z + abs(map.origin)) *
                   T(4 * unit_roundoff<T>);
        };
        const vec3<T> off = off_by(from_.map()) + off_by(to_);
        const aabb<T> all = hull(first, last);
        return padded(aabb<T>{all.min - off, all.max + off});
    }

private:
    template <class Ray>
    static constexpr bool has_time = requires(const Ray& ray) {
        ray.time;
    }
    || requires(const Ray& ray) { ray.world().time; };

    template <class Ray>
    RAIO_FN static constexpr T time_of(const Ray& ray) {
        static_assert(has_time<Ray>, "raio: what moves is asked with rays that have a time, as a timed_ray");
        if constexpr (requires { ray.time; }) {
            return ray.time;
        } else {
            return ray.world().time;
        }
    }
    RAIO_FN static constexpr bool is_there(T time) { return T(0) <= time && time <= T(1); }

    RAIO_FN constexpr inverse_map<T> inverse_at(T time) const {
        const transform<T> now = map(time);
        return keeps_shape_ ? from_.with_origin(now.origin) : inverse_map<T>(now);
    }

    Primitive primitive_;
    inverse_map<T> from_;
    transform<T> to_;
    bool keeps_shape_;  ///< so that the inverse is known but for the origin
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
