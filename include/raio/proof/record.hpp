#pragma once

#include <raio/push_macros.hpp>

#include <raio/hit_record.hpp>
#include <raio/proof/crossing.hpp>
#include <raio/proof/line.hpp>

/// \file
/// What is recorded of a crossing.
///
/// A shape has `surface(at)`, where `at` is the point in which a ray meets it, a `surface_point`. That says where it
/// is, and takes what the shape says of it: how much the surface curves there, its normal, its uv. Of all that, only
/// what the record has room for is computed.

namespace raio::inline RAIO_ABI {

namespace detail {

/// Has W no more digits than are recorded, and is there a precision that has?
template <class T, class W>
inline constexpr bool lacks_digits =
    !is_believed<W> && unit_roundoff<T> <= unit_roundoff<W> && unit_roundoff<exact_t<T>> < unit_roundoff<W>;

/// What the error of t counts for at least: a 64th of its rounding. So it is recorded alike by those who know more of
/// it and those who know less.
template <real T>
RAIO_FN constexpr T least_recorded_error(const T& t) {
    return abs(t) * T(unit_roundoff<T> / 64);
}

/// A bound of a point's error, of which what is beyond the largest number, or no number, counts as that.
template <real T>
RAIO_FN constexpr vec3<T> finite_error(const vec3<T>& error) {
    return min(vec3<T>(T(std::numeric_limits<scalar_t<T>>::max())), error);
}

/// Half of what spawned rays need to be certain, in double_double, that they leave a surface of that size.
template <real T>
RAIO_FN constexpr T least_apart(const T& size) {
    return size * T(0x1p-72);
}

}  // namespace detail

/// The point in which a ray meets a surface. It says where that is, and records what it is told of it.
/// \tparam W  the precision that the crossing was found in
/// \tparam T  the shape's
template <class W, real T, class Ray, record Record>
class surface_point {
    using E = bound_t<W>;

public:
    static constexpr bool is_mapped = detail::is_mapped<Ray>;

    using number = W;
    using precise = std::conditional_t<is_believed<W>, W, working_t<T>>;  ///< what normals and uv are found in

    RAIO_FN constexpr surface_point(const Ray& ray, const raio::crossing<W>& c, Record& rec)
        : ray_(ray), crossing_(c), rec_(rec) {}

    RAIO_FN constexpr const Ray& ray() const { return ray_; }
    /// What the shape's formula has found.
    RAIO_FN constexpr const raio::crossing<W>& crossing() const { return crossing_; }
    RAIO_FN constexpr const mask_t<W>& entering() const { return crossing_.entering; }
    RAIO_FN constexpr const index_t<W>& face() const { return crossing_.face; }

    /// From p to the point.
    template <real V>
    RAIO_FN constexpr vec3<W> from(const vec3<V>& p) const {
        const auto& line = line_in<W>(ray_);
        return vector_in(line.from(p)) + vector_in(line.direction()) * crossing_.t;
    }
    RAIO_FN constexpr vec3<W> position() const {
        return vector_in(line_in<W>(ray_).origin()) + direction() * crossing_.t;
    }
    RAIO_FN constexpr vec3<W> direction() const { return vector_in(line_in<W>(ray_).direction()); }
    /// The ray's line, as the formula has seen it.
    RAIO_FN constexpr auto line() const { return line_in<W>(ray_); }
    /// How far along the ray the exact point may be, as a length.
    RAIO_FN constexpr E blur() const { return norm1(vec3<E>(direction())) * crossing_.error; }

    /// The point, once it has been recorded, as the shape sees it, which may know better where it is; and how far it
    /// may be off.
    RAIO_FN constexpr vec3<T>& point() {
        if constexpr (is_mapped) {
            return own_point_;
        } else {
            return rec_.point;
        }
    }
    RAIO_FN constexpr vec3<T>& error() { return rec_.error; }
    /// For one that is unit and faces the ray already.
    RAIO_FN constexpr vec3<T>& normal() { return rec_.normal; }

    /// Records t, the point, how far that may be off, and the side.
    /// \param bend  a bound of the radius at which the surface bends, where it does: the greater, the farther from it
    ///              spawned rays start; 0 if it is flat
    RAIO_FN constexpr void record_point(T bend = T(0)) {
        const auto& [origin, direction] = unmapped(ray_);
        rec_.point = vec3<T>(sum_as<W>(origin, product_as<W>(direction, crossing_.t)));
        if constexpr (last_precision<W>) {  // bounds without a thickness, as a single point's, expect no rounding of 0
            const vec3<T> rounding = abs(vec3<T>(origin)) * T(8 * unit_roundoff<W>);
            const auto not_0 = [](const T& p, const T& off) { return select(abs(p) <= off, T(0), p); };
            rec_.point = {not_0(rec_.point.x, rounding.x), not_0(rec_.point.y, rounding.y),
                          not_0(rec_.point.z, rounding.z)};
        }
        const T reach = norm1(rec_.point);
        if constexpr (!is_believed<W>) {
            if (!all(is_finite(reach))) rec_.point = within_range(rec_.point);
        }
        if constexpr (is_mapped) {
            own_point_ = vec3<T>(position());
            bend = ray_.stretched(bend + norm1(own_point_));
        }

        // Three errors add up: that of t, that of the sum above in W, where |direction t| <= |origin| + |point|, and
        // the rounding of the point to T. The smallest normal number stands for all that underflows, `up` for the
        // roundings of this bound: less than eight.
        constexpr double in_w = 8 * unit_roundoff<W>, in_t = unit_roundoff<T>, up = 1 + 8 * in_t;
        const T least(least_normal<T>), most(std::numeric_limits<scalar_t<T>>::max());
        const T of_t = min(max(T(crossing_.error), detail::least_recorded_error(t())) + least, most);
        // A ray that leaves at the angle of the normal's own rounding must not meet a curved surface again, and every
        // crossing of a point that is off by this much has to be certain in double_double. Of a point of doubles it
        // should be certain sooner, also on a surface that is far larger than the point's coordinates, as a ground is:
        // on a sphere that takes 8 roundings of its radius.
        constexpr double of_bend = detail::lacks_digits<T, working_t<T>> ? 16 * in_t : 4 * in_t * in_t;
        const T floor = bend * T(of_bend) + detail::least_apart(bend + reach) + least;
        using R = std::remove_cvref_t<decltype(origin.x)>;
        vec3<T> error = vec3<T>(abs(direction) * R(of_t)) + vec3<T>(abs(origin) * R(in_w));
        error += abs(rec_.point) * T(in_t + in_w);
        rec_.error = detail::finite_error(error * T(up) + vec3<T>(floor));
    }

    /// Says that the point may be off by that much more.
    RAIO_FN constexpr void add_error(T more) {
        if constexpr (is_mapped) more = ray_.stretched(more);
        rec_.error = detail::finite_error(rec_.error + vec3<T>(more));
    }

    /// Keeps the point within the bounds of the shape: where little more is known of t than its own digits, as of a ray
    /// that grazes a tip or comes from far away, it may have come to lie beyond them. A record that would say nothing
    /// of that is left as it is. \param bounds  answers with them, to be asked only then
    template <class Bounds>
    RAIO_FN constexpr void keep_in([[maybe_unused]] Bounds bounds) {
        if constexpr (is_believed<W> || !(has_point<Record> || has_error<Record> || has_uv<Record>)) return;
        const auto& [origin, direction] = unmapped(ray_);
        // No more than `padded` leaves: three coordinates add up to at most three times the largest.
        const T room = norm1(rec_.point) * T(padding<T> / 4 * unit_roundoff<T>);
        const T off = norm1(vec3<T>(direction)) * T(crossing_.error) + norm1(vec3<T>(origin)) * T(8 * unit_roundoff<W>);
        const mask_t<T> unknown = !(off <= room);
        if (none(unknown)) return;
        if constexpr (is_mapped) {
            const vec3<T> kept = nearest_in(bounds(), own_point_);
            if (kept == own_point_) return;
            rec_.point = within_range(vec3<T>(ray_.point(vec3<working_t<T>>(kept))));
            add_error(norm1(vec3<T>(kept - own_point_)) + norm1(kept) * T(8 * unit_roundoff<Q>));
            own_point_ = kept;
        } else {
            rec_.point = select(unknown, nearest_in(bounds(), rec_.point), rec_.point);
        }
    }
    /// The same of a point that lies between corners, which may be seen edge-on.
    RAIO_FN constexpr void keep_between([[maybe_unused]] const aabb<T>& corners) {
        if constexpr (!is_believed<W>) point() = nearest_in(corners, point());
    }

    /// Records the normal.
    /// \param outward  across the surface, of any length
    template <real V>
    RAIO_FN constexpr void record_normal(const vec3<V>& outward) {
        if constexpr (has_normal<Record>) {
            vec3<Q> unit = normalize_from<T>(seen(vec3<Q>(outward)));
            rec_.normal = vec3<T>(unit) * choose(mask_t<T>(entering()), T(1), T(-1));
        }
    }

    /// The same where the vector has that length, but for its rounding.
    template <real V>
    RAIO_FN constexpr void record_normal(const vec3<V>& outward, const T& length) {
        if constexpr (is_believed<W> && !is_mapped && has_normal<Record>) {
            rec_.normal = vec3<T>(outward) * choose(mask_t<T>(entering()), T(1) / length, T(-1) / length);
        } else {
            record_normal(outward);  // which is exact to its last place
        }
    }

    /// Records the normal along the gradient of what is positive outside. Where it has none, at a tip or where sheets
    /// cross, or none but its rounding, the surface is seen face on.
    RAIO_FN constexpr void record_gradient(const vec3<W>& gradient) {
        if constexpr (has_normal<Record>) {
            vec3<Q> along(normalize(vec3<Q>(direction()))), outward(scaled_into_range<Q>(vec3<Q>(gradient)));
            Q steep = length(outward);
            vec3<Q> normal = outward * quotient(select(mask_t<Q>(entering()), Q(1), Q(-1)), steep, Q(0));
            const mask_t<Q> against = every(steep > Q(0), dot(normal, along) <= Q(unit_roundoff<T>));
            if constexpr (is_mapped) {
                rec_.normal = vec3<T>(against ? normalize(seen(normal)) : against_ray());
            } else {
                rec_.normal = vec3<T>(select(against, normal, -along));
            }
        }
    }

    /// The same in some of the lanes.
    RAIO_FN constexpr void record_gradient(const vec3<W>& gradient, const mask_t<T>& where) {
        if constexpr (has_normal<Record>) {
            vec3<T> other = rec_.normal;
            record_gradient(gradient);
            rec_.normal = select(where, rec_.normal, other);
        }
    }

    /// Records uv.
    /// \param find  answers with it: angles are not asked for in vain
    template <class Find>
    RAIO_FN constexpr void record_uv(Find find) {
        if constexpr (has_uv<Record>) rec_.uv = find();
    }

    /// Says the rest, and fills the record.
    RAIO_FN constexpr void fill(Record& rec) {
        rec_.t = t(), rec_.index = index_t<T>{}, rec_.front_face = mask_t<T>(entering());
        if constexpr (has_normal<Record> && !is_believed<W>) {
            // Where the shape's numbers are so uneven that no normal is left of them, it is against the ray; and what
            // is left of uv is 0.
            const mask_t<T> known = is_finite(norm1(rec_.normal));
            if (!all(known)) [[unlikely]] {
                rec_.normal = select(known, rec_.normal, vec3<T>(against_ray()));
                const auto number_or_0 = [](const T& x) { return select(x == x, x, T(0)); };
                if constexpr (has_uv<Record>) rec_.uv = {number_or_0(rec_.uv.x), number_or_0(rec_.uv.y)};
            }
        }
        if constexpr (!is_full) assign(rec, rec_);
    }

private:
    using Q = precise;

    static constexpr bool is_full = std::same_as<Record, hit_record<T>>;
    /// For a record that has no room for all of it.
    struct own_record : hit_record<T> {
        RAIO_FN constexpr explicit own_record(Record&) {}
    };
    struct nothing {};

    /// A vector across the surface, as it is seen.
    RAIO_FN constexpr vec3<Q> seen(const vec3<Q>& outward) const {
        if constexpr (is_mapped) {
            return vec3<Q>(ray_.across(scaled_into_range<T>(vec3<working_t<T>>(outward))));
        } else {
            return outward;
        }
    }
    RAIO_RARELY RAIO_FN static constexpr vec3<Q> against(vec3<Q> direction) { return -normalize(direction); }
    RAIO_FN constexpr vec3<Q> against_ray() const { return against(vec3<Q>(vec3<W>(unmapped(ray_).direction))); }

    RAIO_FN constexpr T t() const { return T(crossing_.t) + T(0); }  // never -0

    const Ray& ray_;
    const raio::crossing<W>& crossing_;
    std::conditional_t<is_full, hit_record<T>&, own_record> rec_;
    [[no_unique_address]] std::conditional_t<is_mapped, vec3<T>, nothing> own_point_;  ///< before all maps
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
