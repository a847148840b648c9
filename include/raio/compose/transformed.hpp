#pragma once

#include <raio/concepts.hpp>
#include <raio/math/transform.hpp>
#include <raio/proof/lanes.hpp>

namespace raio {

/// A primitive under an affine map M: turned, moved, scaled unevenly, mirrored.
///
/// The point origin + t direction lies on the image where M^-1 of it lies on the primitive, at the same t:
///
///     M^-1 (origin + t direction) = L^-1 (origin - M's origin) + t L^-1 direction,   L the linear part of M
///
/// So the ray is mapped back, its direction not renormalised, and t needs no mapping at all. Normals go by the inverse
/// transpose of L (Turkowski, Graphics Gems, 1990), which turns none of them inside out: n.direction is the same on
/// both sides of the map. uv, index and side are the primitive's.
///
/// The mapped ray is rounded once, to the first precision beyond T. From there on everything is as exact as the
/// primitive itself: all questions are asked of the same ray, which passes within 2^-50 of what L^-1 and the ray
/// measure of where it should (for double 2^-102, times the lengths of L's columns over its determinant).
///
///     raio::transformed{raio::sphere<float>{{0, 0, 0}, 1}, raio::scaling<float>({1, 2, 3})}    // an ellipsoid
///     raio::transformed{&mesh, map}    // an instance: the mesh is shared, and has to live longer
template <holder Primitive>
class transformed {
    using P = detail::held_t<Primitive>;
    using W = wider_t<number_t<P>>;

public:
    using number = number_t<P>;
    using T = number;

    /// A singular map leaves nothing to be hit, and so does one whose determinant is out of the range of its numbers.
    RAIO_FN constexpr transformed(Primitive primitive, const transform<T>& map)
        : primitive_(std::move(primitive)), map_(map), inverse_(map) {}

    RAIO_FN constexpr const P& primitive() const { return detail::held(primitive_); }
    RAIO_FN constexpr const transform<T>& map() const { return map_; }

    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        return hit<T, T>(ray, t_min, t_max, rec);
    }
    template <real R, real N>
    RAIO_FN constexpr mask_t<T> hit(const ray<R>& ray, T t_min, T t_max, hit_record<T, N>& rec) const {
        if constexpr (detail::has_lanes<T>) {
            return detail::first_hit_in_lanes(*this, ray, t_min, t_max, rec);
        } else {
            hit_record<T, W> local;
            const bool met = detail::hit(primitive(), mapped_back(ray), t_min, t_max, local);
            if (met) rec = mapped<N>(local, vec3<W>(ray.direction));
            return met;
        }
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return occluded<T>(ray, t_min, t_max);
    }
    template <real R>
    RAIO_FN constexpr mask_t<T> occluded(const ray<R>& ray, T t_min, T t_max) const {
        if constexpr (detail::has_lanes<T>) {
            return detail::any_hit_in_lanes(*this, ray, t_min, t_max);
        } else {
            return detail::occluded(primitive(), mapped_back(ray), t_min, t_max);
        }
    }

    RAIO_FN constexpr auto spans(const ray<T>& ray) const requires(solid<P>) { return spans<T>(ray); }
    template <real R>
    RAIO_FN constexpr auto spans(const ray<R>& ray) const requires(solid<P>) {
        if constexpr (detail::has_lanes<T>) {
            return detail::spans_in_lanes(*this, ray);
        } else {
            return detail::spans_of(primitive(), mapped_back(ray));
        }
    }

    /// Each side of the image is the sum of what the sides of the primitive's box contribute (Arvo, Graphics Gems,
    /// 1990).
    RAIO_FN constexpr aabb<T> bounds() const requires(bounded<P>) {
        using B = working_t<T>;
        const aabb<T> box = primitive().bounds();
        if (!(box.min.x <= box.max.x)) return box;
        vec3<B> low(map_.origin), high = low, size = abs(low);
        const auto add = [&](const vec3<T>& axis, const T& from, const T& to) {
            for (glm::length_t i = 0; i < 3; ++i) {
                if (axis[i] == T(0)) continue;  // of infinity, nothing is nothing as well
                B a = B(axis[i]) * B(from), b = B(axis[i]) * B(to);
                low[i] += min(a, b), high[i] += max(a, b), size[i] += max(abs(a), abs(b));
            }
        };
        add(map_.x, box.min.x, box.max.x);
        add(map_.y, box.min.y, box.max.y);
        add(map_.z, box.min.z, box.max.z);
        vec3<B> off = size * B(8 * unit_roundoff<B>);
        return padded(aabb<T>{vec3<T>(low - off), vec3<T>(high + off)});
    }

    /// What is in one lane of packs.
    RAIO_FN auto in_lane(std::size_t lane) const requires detail::has_lanes<T> {
        return raio::transformed(detail::in_lane<T>(primitive(), lane), detail::in_lane<T>(map_, lane));
    }

private:
    template <real R>
    RAIO_FN constexpr raio::ray<W> mapped_back(const raio::ray<R>& ray) const {
        return {inverse_(difference_as<W>(ray.origin, map_.origin)), inverse_(ray.direction)};
    }

    template <real N>
    RAIO_FN constexpr hit_record<T, N> mapped(const hit_record<T, W>& local, const vec3<W>& direction) const {
        using E = bound_t<W>;
        constexpr double u = unit_roundoff<W>, in_t = unit_roundoff<T>;
        const T most(std::numeric_limits<scalar_t<T>>::max());
        vec3<T> p = within_range(map_.point(local.point));

        // The error of the primitive's point seen through L, that of a ray from here that is mapped back, and the
        // roundings of the point.
        vec3<E> from_origin = abs(vec3<E>(p) - vec3<E>(map_.origin)), x = abs(vec3<E>(inverse_.x));
        vec3<E> y = abs(vec3<E>(inverse_.y)), z = abs(vec3<E>(inverse_.z));
        vec3<E> back(dot(x, from_origin), dot(y, from_origin), dot(z, from_origin));
        vec3<E> inside = vec3<E>(local.error) + back * E(8 * u);
        vec3<E> error =
            abs(vec3<E>(map_.x)) * inside.x + abs(vec3<E>(map_.y)) * inside.y + abs(vec3<E>(map_.z)) * inside.z;
        error += abs(vec3<E>(p)) * E(in_t) + abs(vec3<E>(map_.origin)) * E(8 * u);
        const auto rounded_up = [&](const E& e) {
            const T up = T(e * E(1 + 4 * in_t) + E(least_normal<T>));
            return select(up <= most, up, most);
        };
        vec3<W> normal = inverse_.transposed(local.normal);
        // A coordinate may be 1.74 times the largest of the inverse: beyond the range, but not as a quarter.
        if (!is_finite(norm1(normal))) normal = inverse_.transposed(local.normal * W(0.25));
        // Of a map so uneven that W is left without a normal, it is against the ray.
        normal = select(norm1(normal) > W(0), normal, -direction);
        return {local.t,
                p,
                vec3<N>(normalize_from<N>(vec3<working_t<N>>(normal))),
                local.uv,
                {rounded_up(error.x), rounded_up(error.y), rounded_up(error.z)},
                local.index,
                local.front_face};
    }

    Primitive primitive_;
    transform<T> map_;
    linear_inverse<W> inverse_;
};

}  // namespace raio
