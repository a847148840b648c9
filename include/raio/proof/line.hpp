#pragma once

#include <raio/number/bounded_vector.hpp>
#include <raio/ray.hpp>

namespace raio {

/// A ray's line as a formula sees it: in numbers of W that carry their errors.
template <class W, real R = W>
struct line {
    using number = W;

    const raio::ray<R>& ray;

    RAIO_FN constexpr given_vector<W> direction() const {
        return {W(ray.direction.x), W(ray.direction.y), W(ray.direction.z)};
    }

    RAIO_FN constexpr given_vector<W> origin() const { return {W(ray.origin.x), W(ray.origin.y), W(ray.origin.z)}; }

    /// From the point where t = 0 to p, and the other way.
    template <real T>
    RAIO_FN constexpr rounded_vector<W, 1> to(const vec3<T>& p) const {
        return difference(p, ray.origin);
    }
    template <real T>
    RAIO_FN constexpr rounded_vector<W, 1> from(const vec3<T>& p) const {
        return difference(ray.origin, p);
    }

    /// From the point where t = 0 to the one half way from p to q.
    template <real T>
    RAIO_FN constexpr bounded_vector<W> to_middle(const vec3<T>& p, const vec3<T>& q) const {
        const rounded_vector<W, 1> a = to(p), b = to(q);
        const W half(0.5);
        return {(a.x + b.x) * half, (a.y + b.y) * half, (a.z + b.z) * half,
                detail::roundings<W>(1, size_of(a) + size_of(b))};
    }

    /// What the shape is made of, in the numbers of the line.
    template <real T>
    RAIO_FN static constexpr given_number<W> given(const T& x) {
        return {W(x)};
    }
    template <real T>
    RAIO_FN static constexpr given_vector<W> given(const vec3<T>& v) {
        return {W(v.x), W(v.y), W(v.z)};
    }
    /// From p to q.
    template <real T>
    RAIO_FN static constexpr rounded_vector<W, 1> between(const vec3<T>& p, const vec3<T>& q) {
        return difference(q, p);
    }
    /// y - x.
    template <real T>
    RAIO_FN static constexpr rounded_number<W, 1> between(const T& x, const T& y) {
        return {difference_as<W>(y, x)};
    }

private:
    template <real A, real B>
    RAIO_FN static constexpr rounded_vector<W, 1> difference(const vec3<A>& a, const vec3<B>& b) {
        return {difference_as<W>(a.x, b.x), difference_as<W>(a.y, b.y), difference_as<W>(a.z, b.z)};
    }
};

}  // namespace raio
