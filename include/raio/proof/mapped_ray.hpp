#pragma once

#include <raio/push_macros.hpp>

#include <raio/hit_record.hpp>
#include <raio/math/transform.hpp>
#include <raio/proof/line.hpp>

/// \file
/// Rays as a shape under affine maps sees them.
///
/// The point o + t d lies on the image of a shape where M^-1 of it lies on the shape, at the same t:
///
///     M^-1 (o + t d) = L^-1 (o - M's origin) + t L^-1 d,    L the linear part of M
///
/// So a ray is mapped back, its direction not normalised, and t needs no mapping at all. What is rounded on the way is
/// an error of the line that the shape's formula is given.

namespace raio::inline RAIO_ABI {

/// An affine map that rays are mapped back by, and its inverse.
template <real T>
class inverse_map {
    using Q = working_t<T>;

    /// The rows of the inverse of L. What a row of numbers v makes of it is off by what v is off, times `size`, and by
    /// what v measures, times `off`.
    template <class W>
    struct rows {
        given_vector<W> x, y, z;
        bound_t<W> size, off;

        template <proven_vector V>
        RAIO_FN constexpr bounded_vector<W> operator()(const V& v) const {
            const auto along = [&](const given_vector<W>& row) {
                return detail::sum_of_products(row.x, v.x, row.y, v.y, row.z, v.z);
            };
            const bound_t<W> error = detail::error_of(v);
            return {along(x), along(y), along(z), off * (size_of(v) + error) + size * error};
        }
    };

public:
    /// Of a singular map the inverse is zero: nothing is hit under it. So it is of a map whose determinant is out of
    /// the range of its numbers, or is lost among its terms.
    RAIO_FN constexpr explicit inverse_map(const transform<T>& map) : map_(map), rows_(rows_in<Q>(map)) {}

    RAIO_FN constexpr const transform<T>& map() const { return map_; }

    /// The same, but that the origin goes elsewhere.
    RAIO_FN constexpr inverse_map with_origin(const vec3<T>& origin) const {
        inverse_map moved = *this;
        moved.map_.origin = origin;
        return moved;
    }

    template <class Line>
    RAIO_FN constexpr auto operator()(const Line& line) const {
        using W = typename Line::number;
        if constexpr (std::same_as<W, Q>) {
            return mapped_line<W>{rows_(line.from(map_.origin)), rows_(line.direction())};
        } else {
            const rows<W> closer = rows_in<W>(map_);
            return mapped_line<W>{closer(line.from(map_.origin)), closer(line.direction())};
        }
    }

    /// How a vector across a surface goes the other way: by the transpose of L^-1, which turns none of them inside out
    /// (Turkowski, Graphics Gems, 1990).
    RAIO_FN constexpr vec3<Q> across(const vec3<Q>& n) const {
        const auto& [x, y, z, size, off] = rows_;
        return {x.x * n.x + y.x * n.y + z.x * n.z, x.y * n.x + y.y * n.y + z.y * n.z,
                x.z * n.x + y.z * n.y + z.z * n.z};
    }

    RAIO_FN constexpr vec3<Q> point(const vec3<Q>& p) const { return map_.linear(p) + vec3<Q>(map_.origin); }

    /// How long a length can become.
    RAIO_FN constexpr T stretched(const T& length) const {
        return length * (norm1(map_.x) + norm1(map_.y) + norm1(map_.z));
    }

private:
    /// The reciprocal basis of the columns a, b, c of L: b x c, c x a and a x b, over the determinant a.(b x c).
    template <class W>
    RAIO_FN static constexpr rows<W> rows_in(const transform<T>& map) {
        using X = exact_t<T>;
        const auto given = [](const vec3<T>& v) { return given_vector<X>{X(v.x), X(v.y), X(v.z)}; };
        auto a = given(map.x), b = given(map.y), c = given(map.z);
        auto b_c = cross(b, c), c_a = cross(c, a), a_b = cross(a, b);
        auto over_det = inverse(dot(a, b_c));
        constexpr given_vector<W> zero{W(0), W(0), W(0)};
        rows<W> inverse{zero, zero, zero, bound_t<W>(0), bound_t<W>(0)};
        if (!(is_finite(over_det.value) && is_finite(over_det.error))) return inverse;
        const auto add = [&](const bounded_vector<X>& row) {
            using E = bound_t<W>;
            const E size(size_of(row));
            inverse.size += size;
            // One rounding to W, three when it is multiplied.
            inverse.off += E(detail::rounded_up<X>(row.error)) + detail::roundings<W>(4, size);
            return given_vector<W>{W(row.x), W(row.y), W(row.z)};
        };
        inverse.x = add(b_c * over_det), inverse.y = add(c_a * over_det), inverse.z = add(a_b * over_det);
        return inverse;
    }

    transform<T> map_;
    rows<Q> rows_;
};

/// A ray of T, and the maps that lead to the shape that is asked.
template <real T>
class mapped_ray {
    using Q = working_t<T>;

public:
    /// Both have to live longer than this.
    RAIO_FN constexpr mapped_ray(const ray<T>& world, const inverse_map<T>& map)
        : world_(world), map_(map), quick_(map(raio::line<Q, T>{stored(world)})) {}
    RAIO_FN constexpr mapped_ray(const mapped_ray& outer, const inverse_map<T>& map)
        : world_(outer.world_), outer_(&outer), map_(map), quick_(map(outer.quick_)) {}

    /// The ray as it was before all maps.
    RAIO_FN constexpr const ray<T>& world() const { return world_; }

    /// The ray that a shape sees which knows no other rays.
    RAIO_FN constexpr ray<T> rounded() const {
        const auto in_t = [](const bounded_vector<Q>& v) { return vec3<T>(T(v.x), T(v.y), T(v.z)); };
        return {in_t(quick_.origin()), in_t(quick_.direction())};
    }

    /// The line that the shape sees, in numbers of W.
    template <class W>
    RAIO_FN constexpr decltype(auto) line() const {
        if constexpr (std::same_as<W, Q>) {
            return (quick_);  // where it stands: GCC would keep a copy in memory
        } else if constexpr (is_believed<W> || !std::same_as<W, scalar_t<W>>) {  // one number, or every lane of a pack
            const auto in_lanes = [](const Q& x) { return W(static_cast<double>(x)); };
            const auto spread = [&](const bounded_vector<Q>& v) {
                return bounded_vector<W>{in_lanes(v.x), in_lanes(v.y), in_lanes(v.z), bound_t<W>(in_lanes(v.error))};
            };
            return mapped_line<W>{spread(quick_.origin()), spread(quick_.direction())};
        } else {
            if (outer_ == nullptr) return map_(raio::line<W, T>{world_});
            return map_(outer_->template line<W>());
        }
    }

    /// A point of the shape, as it is seen.
    RAIO_FN constexpr vec3<Q> point(const vec3<Q>& p) const {
        const vec3<Q> mapped = map_.point(p);
        return outer_ == nullptr ? mapped : outer_->point(mapped);
    }

    /// A vector across the shape's surface, as it is across that which is seen.
    RAIO_FN constexpr vec3<Q> across(const vec3<Q>& n) const {
        const vec3<Q> mapped = map_.across(n);
        return outer_ == nullptr ? mapped : outer_->across(mapped);
    }

    /// How long a length of the shape's can be, as it is seen.
    RAIO_FN constexpr T stretched(const T& length) const {
        const T mapped = map_.stretched(length);
        return outer_ == nullptr ? mapped : outer_->stretched(mapped);
    }

    /// What a shape has recorded that knows plain rays only, as it is seen.
    RAIO_FN constexpr hit_record<T> seen(hit_record<T> rec) const {
        const auto [from, along] = rounded();
        // The mapped ray was rounded, and so is the mapped point.
        const T rounding = norm1(from) + norm1(along) * abs(rec.t);
        rec.error = vec3<T>(stretched(norm1(rec.error) + rounding * T(4 * unit_roundoff<T>)));
        rec.point = within_range(vec3<T>(point(vec3<Q>(rec.point))));
        rec.error += abs(rec.point) * T(unit_roundoff<T>);
        rec.normal = vec3<T>(normalize_from<T>(across(vec3<Q>(rec.normal))));
        return rec;
    }

    /// What it is made of.
    struct origin {
        using ray = mapped_ray;

        const raio::ray<T>& world;
        const mapped_ray* outer;
        const inverse_map<T>& map;
    };
    RAIO_FN constexpr origin made_of() const { return {world_, outer_, map_}; }
    RAIO_FN constexpr explicit mapped_ray(const origin& of)
        : mapped_ray(of.outer == nullptr ? mapped_ray(of.world, of.map) : mapped_ray(*of.outer, of.map)) {}

private:
    RAIO_FN static constexpr const ray<T>& stored(const ray<T>& ray) {
        detail::keep_as_stored<T>(ray);
        return ray;
    }

    const ray<T>& world_;
    const mapped_ray* outer_ = nullptr;
    const inverse_map<T>& map_;
    mapped_line<Q> quick_;
};

/// A mapped ray of those that have more than a ray has.
template <real T, class World>
class mapped_ray_of : public mapped_ray<T> {
public:
    RAIO_FN constexpr mapped_ray_of(const World& world, const inverse_map<T>& map) : mapped_ray<T>(world, map) {}
    RAIO_FN constexpr mapped_ray_of(const mapped_ray_of& outer, const inverse_map<T>& map)
        : mapped_ray<T>(outer, map) {}

    /// The ray as it was before all maps, with what else it has.
    RAIO_FN constexpr const World& world() const { return static_cast<const World&>(mapped_ray<T>::world()); }
};

/// Its line in numbers of W.
template <class W, real T>
RAIO_FN constexpr decltype(auto) line_in(const mapped_ray<T>& ray) {
    return ray.template line<W>();
}

template <real T>
RAIO_FN constexpr const ray<T>& unmapped(const mapped_ray<T>& ray) {
    return ray.world();
}

namespace detail {

/// The ray as one sees it that is under the map. It is given what it has to outlive.
template <class Ray, real T>
RAIO_FN constexpr auto mapped(const Ray& ray, const inverse_map<T>& map) {
    if constexpr (is_mapped<Ray>) {
        return Ray(ray, map);
    } else if constexpr (std::same_as<Ray, raio::ray<T>>) {
        return mapped_ray<T>(ray, map);
    } else {
        return mapped_ray_of<T, Ray>(ray, map);
    }
}

}  // namespace detail

/// A ray of T, as it is or mapped, or what is derived from one.
template <class Ray, class T>
concept ray_of = std::derived_from<Ray, ray<T>> || std::derived_from<Ray, mapped_ray<T>>;

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
