#pragma once

#include <raio/push_macros.hpp>

#include <raio/proof/settle.hpp>

/// \file
/// What can be asked of a shape. Whatever answers is a primitive, whether it is one triangle or a tree of them.

namespace raio::inline RAIO_ABI {

/// The number type of a shape: that of the corner of its bounds, for all that have bounds.
template <class P>
using number_t = typename P::number;

/// A surface that rays meet.
template <class P>
concept primitive = real<number_t<P>> &&
    requires(const P shape, const ray<number_t<P>> ray, number_t<P> t, hit_record<number_t<P>> rec) {
    { shape.hit(ray, t, t, rec) } -> std::same_as<mask_t<number_t<P>>>;
    { shape.occluded(ray, t, t) } -> std::same_as<mask_t<number_t<P>>>;
};

/// A primitive that knows a box around every point it can return.
template <class P>
concept bounded = primitive<P> && requires(const P shape) {
    { shape.bounds() } -> std::same_as<aabb<number_t<P>>>;
};

/// A primitive with an inside: it says which part of a ray lies there.
template <class P>
concept solid = primitive<P> && requires(const P shape, const ray<number_t<P>> ray) {
    shape.spans(ray);
};

/// Holds a primitive: is one, or points to one, as `const P*` and `std::shared_ptr<const P>` do. What holds a pointer
/// shares the primitive with others.
template <class H>
concept holder = primitive<H> || requires(const H h) {
    requires primitive<std::remove_cvref_t<decltype(*h)>>;
};

/// Are they all made of the same numbers? Nothing is converted in secret: `sphere<float>` and `sphere<double>` do not
/// mix.
template <class First, class... Rest>
concept of_one_number_type = (std::same_as<number_t<First>, number_t<Rest>> && ...);

/// A primitive that a light can be made of: it has an area, and points spread evenly over it.
template <class P>
concept sampleable = primitive<P> && requires(const P shape, vec2<number_t<P>> u) {
    { shape.area() } -> std::same_as<number_t<P>>;
    shape.sample(u);
};

namespace detail {

template <holder H>
RAIO_FN constexpr const auto& held(const H& h) {
    if constexpr (primitive<H>) {
        return h;
    } else {
        return *h;
    }
}

/// The primitive that is held.
template <holder H>
using held_t = std::remove_cvref_t<decltype(held(std::declval<const H&>()))>;

/// Does the shape have a formula, which takes any line? (Packs are asked lane by lane.)
template <class P>
concept has_formula = !has_lanes<number_t<P>> && requires(const P shape, const mapped_line<exact_t<number_t<P>>> line) {
    shape.crossings(line);
};

// The three questions, put with a ray as it is or mapped. What knows plain rays only is asked with the mapped one,
// rounded.

template <primitive P, class Ray, record Record>
RAIO_FN constexpr mask_t<number_t<P>> hit(const P& shape, const Ray& ray, number_t<P> t_min, number_t<P> t_max,
                                          Record& rec) {
    using T = number_t<P>;
    if constexpr (requires { shape.hit(ray, t_min, t_max, rec); }) {
        return shape.hit(ray, t_min, t_max, rec);
    } else if constexpr (has_formula<P>) {
        return first_hit(shape, ray, t_min, t_max, rec);
    } else {
        hit_record<T> own;
        if constexpr (is_mapped<Ray>) {
            if (!shape.hit(ray.rounded(), t_min, t_max, own)) return false;
            own = ray.seen(own);
        } else {
            if (!shape.hit(ray, t_min, t_max, own)) return false;
        }
        assign(rec, own);
        return true;
    }
}

/// The crossing at t, which is known to be one.
template <primitive P, class Ray, record Record>
RAIO_FN constexpr mask_t<number_t<P>> hit_at(const P& shape, const Ray& ray, number_t<P> t, Record& rec) {
    if constexpr (requires { shape.record_at(ray, t, rec); }) {
        shape.record_at(ray, t, rec);
        return is_finite(t);
    } else {
        return detail::hit(shape, ray, t, t, rec);
    }
}

/// Is t kept as it was found, to be read again?
template <class Record, class T>
concept keeps_t = requires(Record& rec) {
    requires std::same_as<std::remove_cvref_t<decltype(rec.t)>, T>;
};

/// `hit` of an aggregate that has to compare t, for a record that does not keep it.
template <class P, class Ray, real T, record Record>
RAIO_FN constexpr mask_t<T> hit_in_between(const P& shape, const Ray& ray, T t_min, T t_max, Record& rec) {
    hit_record<T> own;
    if (!shape.hit(ray, t_min, t_max, own)) return false;
    assign(rec, own);
    return true;
}

/// Of several primitives that are equally near, records the first that shows its front or, if none does, the first.
/// Out of line, as what is rare.
/// \param tied  the lanes in which more than one is met at rec.t
template <class Ray, real T, record Record, class ForEach>
RAIO_RARELY RAIO_FN constexpr void record_front_first(mask_t<T> tied, const Ray& ray, T t_min, Record& rec,
                                                      ForEach for_each) {
    const T t = select(tied, rec.t, t_min);
    for (int sweep = 0; sweep < 2 && any(tied); ++sweep) {
        const mask_t<T> any_side(sweep == 1);
        index_t<T> index{};
        for_each([&](const auto& primitive) {
            auto seen = with_side<T>(rec);
            const mask_t<T> met = tied && hit(primitive, ray, t_min, t, seen);
            const mask_t<T> first = met && (any_side || mask_t<T>(seen.front_face));
            if (any(first)) {
                if constexpr (has_lanes<T>) {
                    Record candidate = rec;
                    hit(primitive, ray, t_min, t, candidate);
                    put_index(candidate, index);
                    assign(first, rec, candidate);
                } else {
                    hit(primitive, ray, t_min, t, rec);
                    put_index(rec, index);
                }
                tied = tied && !first;
            }
            index = index + index_t<T>(1);
            return any(tied);
        });
    }
}

/// `hit` of several primitives, one after the other: the nearest is hit, of equally near ones the first that shows its
/// front or, if none does, the first.
/// \param for_each  calls what it is given with one primitive after the other
template <class Ray, real T, record Record, class ForEach>
RAIO_FN constexpr mask_t<T> hit_nearest(const Ray& ray, T t_min, T t_max, Record& rec, ForEach for_each) {
    mask_t<T> found = !(T(0) == T(0)), tied = found;
    index_t<T> index{};
    for_each([&](const auto& primitive) {
        if constexpr (std::floating_point<T>) {
            // What is as near as all before, or nearer, goes straight into the record: a miss writes nothing.
            if (hit(primitive, ray, t_min, t_max, rec)) {
                put_index(rec, index);
                tied = found && rec.t == t_max;
                t_max = rec.t;
                found = true;
            }
        } else {
            Record candidate;
            const mask_t<T> met = hit(primitive, ray, t_min, select(found, rec.t, t_max), candidate);
            const mask_t<T> nearer = met && (!found || candidate.t < rec.t);
            tied = !nearer && (tied || (met && candidate.t == rec.t));
            put_index(candidate, index);
            if (any(nearer)) assign(nearer, rec, candidate);
            found = found || nearer;
        }
        index = index + index_t<T>(1);
        return true;
    });
    if (any(tied)) [[unlikely]]
        record_front_first(tied, ray, t_min, rec, for_each);
    return found;
}

template <primitive P, class Ray>
RAIO_FN constexpr mask_t<number_t<P>> occluded(const P& shape, const Ray& ray, number_t<P> t_min, number_t<P> t_max) {
    if constexpr (requires { shape.occluded(ray, t_min, t_max); }) {
        return shape.occluded(ray, t_min, t_max);
    } else if constexpr (has_formula<P>) {
        return any_hit(shape, ray, t_min, t_max);
    } else {
        return shape.occluded(ray.rounded(), t_min, t_max);
    }
}

template <solid P, class Ray>
RAIO_FN constexpr auto spans_of(const P& shape, const Ray& ray) {
    if constexpr (requires { shape.spans(ray); }) {
        return shape.spans(ray);
    } else if constexpr (has_formula<P>) {
        return inside_of(shape, ray);
    } else {
        return shape.spans(ray.rounded());
    }
}

/// Along none of the axes, diagonals or other directions that shapes are made of.
template <real T>
RAIO_FN constexpr vec3<T> any_direction() {
    const auto number = [](double x) { return T(static_cast<scalar_t<T>>(x)); };
    return {number(0.5547), number(0.7193), number(0.4181)};
}

}  // namespace detail

/// Is the point in the solid, or on its surface? As exact as a ray from there. (There is `contains` of closed meshes
/// and their trees as well.)
template <solid P>
RAIO_FN constexpr mask_t<number_t<P>> contains(const P& shape, const vec3<number_t<P>>& point) {
    using T = number_t<P>;
    return detail::spans_of(shape, ray<T>{point, detail::any_direction<T>()}).contains(T(0));
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
