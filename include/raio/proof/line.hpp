#pragma once

#include <raio/push_macros.hpp>

#include <raio/number/bounded_vector.hpp>
#include <raio/ray.hpp>

namespace raio::inline RAIO_ABI {

/// The components, without their errors.
template <proven_vector V>
RAIO_FN constexpr vec3<typename V::number> vector_in(const V& v) {
    return {v.x, v.y, v.z};
}

/// What a shape is made of, in numbers of W that carry their errors.
template <class W>
struct shape_numbers {
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

protected:
    template <real A, real B>
    RAIO_FN static constexpr rounded_vector<W, 1> difference(const vec3<A>& a, const vec3<B>& b) {
        return {difference_as<W>(a.x, b.x), difference_as<W>(a.y, b.y), difference_as<W>(a.z, b.z)};
    }
};

/// A ray's line as a formula sees it: in numbers of W that carry their errors. The ray is given, without an error.
template <class W, real R = W>
struct line : shape_numbers<W> {
    using number = W;
    static constexpr bool is_exact = true;

    const raio::ray<R>& ray;

    RAIO_FN constexpr explicit line(const raio::ray<R>& r) : ray(r) {}

    RAIO_FN constexpr given_vector<W> direction() const { return line::given(ray.direction); }
    RAIO_FN constexpr given_vector<W> origin() const { return line::given(ray.origin); }

    /// From the point where t = 0 to p, and the other way.
    template <real T>
    RAIO_FN constexpr rounded_vector<W, 1> to(const vec3<T>& p) const {
        return line::difference(p, ray.origin);
    }
    template <real T>
    RAIO_FN constexpr rounded_vector<W, 1> from(const vec3<T>& p) const {
        return line::difference(ray.origin, p);
    }

    /// From the point where t = 0 to the one half way from p to q.
    template <real T>
    RAIO_FN constexpr bounded_vector<W> to_middle(const vec3<T>& p, const vec3<T>& q) const {
        const rounded_vector<W, 1> a = to(p), b = to(q);
        const W half(0.5);
        return {(a.x + b.x) * half, (a.y + b.y) * half, (a.z + b.z) * half,
                detail::roundings<W>(1, size_of(a) + size_of(b))};
    }
};

/// The line of a ray, which has to live longer.
template <class W, real R>
RAIO_FN constexpr line<W, R> line_in(const ray<R>& ray) {
    return line<W, R>(ray);
}

/// The ray as it was asked for: before all maps, if it was mapped (proof/mapped_ray.hpp).
template <real T>
RAIO_FN constexpr const ray<T>& unmapped(const ray<T>& ray) {
    return ray;
}

namespace detail {

template <class Ray>
inline constexpr bool is_mapped = requires(const Ray& ray) {
    ray.made_of();
};

/// What a ray can be made of again: who is given that has not seen the ray itself, which can stay in registers.
template <real T>
RAIO_FN constexpr const ray<T>& origin_of(const ray<T>& ray) {
    return ray;
}
template <class Ray>
requires is_mapped<Ray> RAIO_FN constexpr auto origin_of(const Ray& ray) { return ray.made_of(); }
template <real T>
RAIO_FN constexpr const ray<T>& made_of(const ray<T>& ray) {
    return ray;
}
template <class Origin>
RAIO_FN constexpr auto made_of(const Origin& origin) {
    return typename Origin::ray(origin);
}

}  // namespace detail

/// The line of a ray that was mapped: in numbers of W, each with a bound of its error.
template <class W>
struct mapped_line : shape_numbers<W> {
    using number = W;
    static constexpr bool is_exact = false;

    bounded_vector<W> start, step;  ///< the point where t = 0, and how far it goes as t grows by 1

    RAIO_FN constexpr mapped_line(const bounded_vector<W>& origin, const bounded_vector<W>& direction)
        : start(origin), step(direction) {}

    RAIO_FN constexpr const bounded_vector<W>& direction() const { return step; }
    RAIO_FN constexpr const bounded_vector<W>& origin() const { return start; }

    /// From the point where t = 0 to p, and the other way.
    template <real T>
    RAIO_FN constexpr bounded_vector<W> to(const vec3<T>& p) const {
        return this->given(p) - start;
    }
    template <real T>
    RAIO_FN constexpr bounded_vector<W> from(const vec3<T>& p) const {
        return start - this->given(p);
    }

    /// From the point where t = 0 to the one half way from p to q.
    template <real T>
    RAIO_FN constexpr bounded_vector<W> to_middle(const vec3<T>& p, const vec3<T>& q) const {
        return (to(p) + to(q)) * this->given(W(0.5));
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
