#pragma once

#include <raio/push_macros.hpp>

#include <raio/concepts.hpp>
#include <raio/proof/lanes.hpp>
#include <raio/proof/mapped_ray.hpp>

namespace raio::inline RAIO_ABI {

/// A primitive under an affine map: turned, moved, scaled unevenly, mirrored.
///
/// The ray is mapped back (proof/mapped_ray.hpp), and whatever the primitive is, its formula is given a line whose
/// numbers know what the map has rounded. So it is as exact as the primitive alone. t needs no mapping: the point, and
/// how far that may be off, are those of the ray. Normals go by the inverse transpose. uv, index and side are the
/// primitive's.
///
///     raio::transformed{raio::sphere<float>{{0, 0, 0}, 1}, raio::scaling<float>({1, 2, 3})}    // an ellipsoid
///     raio::transformed{&mesh, map}    // an instance: the mesh is shared, and has to live longer
///     raio::transformed{box, glm::rotate(glm::mat4(1), 0.5f, {0, 1, 0})}    // a map as GLM makes it
template <holder Primitive>
class transformed {
    using P = detail::held_t<Primitive>;

public:
    using number = number_t<P>;
    using T = number;

    /// A singular map leaves nothing to be hit, and so does one whose determinant is out of the range of its numbers,
    /// or is lost among its terms.
    RAIO_FN constexpr transformed(Primitive primitive, const transform<T>& map)
        : primitive_(std::move(primitive)), inverse_(map) {}

    RAIO_FN constexpr const P& primitive() const { return detail::held(primitive_); }
    RAIO_FN constexpr const transform<T>& map() const { return inverse_.map(); }

    template <ray_of<T> Ray = raio::ray<T>, record Record>
    RAIO_NO_SLP RAIO_FLATTEN RAIO_FN constexpr mask_t<T> hit(const Ray& ray, T t_min, T t_max, Record& rec) const {
        if constexpr (detail::has_lanes<T>) {
            return detail::first_hit_in_lanes(*this, ray, t_min, t_max, rec);
        } else {
            return detail::hit(primitive(), detail::mapped(ray, inverse_), t_min, t_max, rec);
        }
    }

    template <ray_of<T> Ray = raio::ray<T>>
    RAIO_FLATTEN RAIO_FN constexpr mask_t<T> occluded(const Ray& ray, T t_min, T t_max) const {
        if constexpr (detail::has_lanes<T>) {
            return detail::any_hit_in_lanes(*this, ray, t_min, t_max);
        } else {
            return detail::occluded(primitive(), detail::mapped(ray, inverse_), t_min, t_max);
        }
    }

    template <ray_of<T> Ray = raio::ray<T>>
    RAIO_FN constexpr auto spans(const Ray& ray) const requires(solid<P>) {
        if constexpr (detail::has_lanes<T>) {
            return detail::spans_in_lanes(*this, ray);
        } else {
            return detail::spans_of(primitive(), detail::mapped(ray, inverse_));
        }
    }

    /// Each side of the image is the sum of what the sides of the primitive's box contribute (Arvo, Graphics Gems,
    /// 1990).
    RAIO_FN constexpr aabb<T> bounds() const requires(bounded<P>) {
        using B = working_t<T>;
        const aabb<T> box = primitive().bounds();
        if (!(box.min.x <= box.max.x)) return unless_nan(box, map().x, map().y, map().z, map().origin);
        vec3<B> low(map().origin), high = low, size = abs(low);
        const auto add = [&](const vec3<T>& axis, const T& from, const T& to) {
            for (glm::length_t i = 0; i < 3; ++i) {
                if (axis[i] == T(0)) continue;  // of infinity, nothing is nothing as well
                B a = B(axis[i]) * B(from), b = B(axis[i]) * B(to);
                low[i] += min(a, b), high[i] += max(a, b), size[i] += max(abs(a), abs(b));
            }
        };
        add(map().x, box.min.x, box.max.x);
        add(map().y, box.min.y, box.max.y);
        add(map().z, box.min.z, box.max.z);
        vec3<B> off = size * B(8 * unit_roundoff<B>);
        return unless_nan(padded(aabb<T>{vec3<T>(low - off), vec3<T>(high + off)}), map().x, map().y, map().z,
                          map().origin);
    }

    /// What is in one lane of packs.
    RAIO_FN auto in_lane(std::size_t lane) const requires detail::has_lanes<T> {
        return raio::transformed(detail::in_lane<T>(primitive(), lane), detail::in_lane<T>(map(), lane));
    }

private:
    /// Of packs, each lane inverts its own.
    struct only_map {
        transform<T> of;

        RAIO_FN constexpr explicit only_map(const transform<T>& map) : of(map) {}
        RAIO_FN constexpr const transform<T>& map() const { return of; }
    };

    Primitive primitive_;
    std::conditional_t<detail::has_lanes<T>, only_map, inverse_map<T>> inverse_;
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
