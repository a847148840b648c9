#pragma once

#include <raio/push_macros.hpp>

#include <raio/math/any_number_of_spans.hpp>
#include <raio/proof/normal.hpp>
#include <raio/shape/box.hpp>

namespace raio::inline RAIO_ABI {

/// The solid where a function f of a point is not above 0, inside a box: blends, offsets, fractals, whatever can be
/// written down.
///
/// Sphere tracing (Hart, The Visual Computer 12, 1996): where f is at most `lipschitz` times as steep as a distance, no
/// point of the surface is nearer than |f| / lipschitz, and so far the ray may go in one step. The walk begins where
/// the line enters the box, whatever the window is, so that all questions about a line hear of the same crossings.
///
/// This is not exact. A crossing is an end of the box, or a t where |f| <= tolerance, f as it is computed for the
/// rounded point: a ray that passes within the tolerance hits, what is thinner than that has two crossings in one
/// place, a gap in which f stays below twice the tolerance is none, and `error` is what the tolerance amounts to across
/// the surface, by the slope of f there. It takes the more steps the less the tolerance is; that should be well above
/// the rounding errors of f, which see whole numbers of 2^-24 of the box in float. After 2^20 steps the walk ends as if
/// it had left the box.
///
/// The normal is the slope of f, by differences over the third root of a roundoff of the box, where their error is
/// least; where there is none, it points against the ray. uv is 0.
template <real T, class Distance>
struct signed_distance {
    using number = T;

    aabb<T> box;        ///< the solid lies inside of it
    T tolerance;        ///< the largest |f| of a crossing, above 0
    T lipschitz;        ///< above 0; 1 for a distance
    Distance distance;  ///< f: takes a vec3<T>, answers with a T, below 0 inside

    template <record Record>
    mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return walk(ray, [&](T t, bool entering) {
            if (!(t_min <= t && t <= t_max)) return false;
            const crossing<T> c{true, true, t, T(0), entering};
            surface_point<T, T, raio::ray<T>, Record> at(ray, c, rec);
            at.record_point();
            at.keep_between(box);
            if constexpr (has_normal<Record> || has_error<Record>) record_slope(at);
            at.record_uv([] { return vec2<T>(T(0)); });
            at.fill(rec);
            return true;
        });
    }

    mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return walk(ray, [&](T t, bool) { return t_min <= t && t <= t_max; });
    }

    raio::spans<T, any_number> spans(const ray<T>& ray) const {
        raio::spans<T, any_number> inside;
        T entered(0);
        walk(ray, [&](T t, bool entering) {
            if (entering) {
                entered = t;
            } else {
                inside.append({entered, t});
            }
            return false;
        });
        return inside;
    }

    aabb<T> bounds() const { return unless_nan(padded(box), box, tolerance, lipschitz); }

private:
    /// Calls `visit` with every crossing, in order, and whether it enters, until that answers yes. Did it?
    template <class Visit>
    bool walk(const ray<T>& ray, Visit visit) const {
        const interval<T> inside_box = raio::box<T>{box.min, box.max}.spans(ray);
        const T speed = length(ray.direction) * lipschitz;
        if (inside_box.empty() || !(tolerance > T(0) && speed > T(0) && is_finite(speed))) return false;

        const auto f_at = [&](T t) { return distance(ray.origin + ray.direction * t); };
        bool inside = false;
        T last = inside_box.min;  // where f was last within the tolerance
        T t = inside_box.min;
        for (int step = 0; t <= inside_box.max && step < 1 << 20; ++step) {
            const T f = f_at(t);
            if (!is_finite(f)) return false;
            if (f <= tolerance) {
                last = t;
                if (!inside && visit(t, true)) return true;
                inside = true;
            } else if (inside && f > T(2) * tolerance) {  // not where a rounding of f grazes the tolerance
                if (visit(last, false)) return true;
                inside = false;
            }
            // Within the tolerance the next step is that long, which is too short to pass it by.
            t = max(t + max(abs(f), tolerance) / speed, outward(t, T(1)));
        }
        return inside && visit(f_at(inside_box.max) <= tolerance ? inside_box.max : last, false);
    }

    template <class Point>
    void record_slope(Point& at) const {
        const T step = T(std::cbrt(static_cast<double>(unit_roundoff<T>))) * norm1(vec3<T>(box.max - box.min));
        const auto rise = [&](const vec3<T>& along) {
            return quotient(distance(at.point() + along * step) - distance(at.point() - along * step), T(2) * step,
                            T(0));
        };
        vec3<T> slope(rise({T(1), T(0), T(0)}), rise({T(0), T(1), T(0)}), rise({T(0), T(0), T(1)}));
        const T steepness = length(slope), side = at.entering() ? T(1) : T(-1);
        const bool flat = !(steepness > T(0) && is_finite(steepness));
        vec3<T> towards = normalize(at.direction()), facing = flat ? -towards : slope * (side / steepness);
        at.normal() = normalize(mirrored_against(facing, towards, T(1)));
        // From the one end of the tolerance to beyond the other.
        at.add_error(T(3) * tolerance / (flat ? lipschitz : steepness));
    }
};

template <real T, class Distance>
signed_distance(aabb<T>, T, T, Distance) -> signed_distance<T, Distance>;

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
