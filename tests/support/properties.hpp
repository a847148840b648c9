#pragma once

#include <cstring>

#include "support/probe.hpp"

/// \file
/// What every shape promises, written once. Each function here answers with what is wrong about one probe, or with
/// nothing.

namespace raio::test {

/// A record that no shape would write.
template <class T>
hit_record<T> untouched_record() {
    return {T(7), vec3<T>(7), vec3<T>(7), vec2<T>(7), vec3<T>(7), 7, true};
}

template <class T>
bool same_record(const hit_record<T>& a, const hit_record<T>& b) {
    return a.t == b.t && a.point == b.point && a.normal == b.normal && a.uv == b.uv && a.error == b.error &&
           a.index == b.index && a.front_face == b.front_face;
}

/// Is a lane's record that of the plain shape? Two of its numbers are computed as compilers like. Where they fuse
/// products and sums, uv may differ in all of its digits (the fraction of a plane's coordinate far away, an angle
/// beside an axis), and the bound of the error a little.
template <class S>
bool same_as_plain(hit_record<S> found, const hit_record<S>& plain) {
#if defined(__FMA__)
    const auto is_fraction = [](S x) { return S(0) <= x && x <= S(1); };
    const auto is_part = [](S a, S b) { return std::abs(a - b) <= S(0.001) * b; };
    if (is_fraction(found.uv.x) && is_fraction(found.uv.y)) found.uv = plain.uv;
    for (glm::length_t i = 0; i < 3; ++i) {
        if (is_part(found.error[i], plain.error[i])) found.error[i] = plain.error[i];
    }
#endif
    return same_record(found, plain);
}

template <class T>
bool all_finite(const vec3<T>& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Every field within its range, whatever the input was.
template <class T>
std::string unsound_fields(const hit_record<T>& rec) {
    const bool no_nan = rec.error.x >= 0 && rec.error.y >= 0 && rec.error.z >= 0;
    if (!std::isfinite(rec.t) || !all_finite(rec.point) || !all_finite(rec.normal) || !no_nan) return "not finite";
    if (!(0 <= rec.uv.x && rec.uv.x <= 1 && 0 <= rec.uv.y && rec.uv.y <= 1)) return "uv beyond [0, 1]";
    const vec3<double> n = to_double(rec.normal);
    if (std::abs(dot(n, n) - 1) > 8 * static_cast<double>(std::numeric_limits<T>::epsilon())) return "normal not unit";
    return "";
}

/// hit and occluded agree (hit and shadow paths that disagree were a bug that others shipped), a miss leaves the record
/// alone, and a hit fills it with sound values and a t in the window.
template <class Shape>
std::string unsound_answer(const probe<Shape>& p) {
    using T = number_t<Shape>;
    hit_record<T> rec = untouched_record<T>();
    const bool hit = p.hit(rec);
    if (hit != p.shape.occluded(p.ray, p.t_min, p.t_max)) return hit ? "hit but not occluded" : "occluded but not hit";
    if (!hit) return same_record(rec, untouched_record<T>()) ? "" : "a miss touched the record";
    if (!(p.t_min <= rec.t && rec.t <= p.t_max)) return "beyond the window, " + literal(rec);
    const std::string unsound = unsound_fields(rec);
    return unsound.empty() ? "" : unsound + ", " + literal(rec);
}

/// The record agrees with the ray and the bounds.
/// \param bend  the smallest radius of the surface: a point that is off turns the normal by that part of it
template <class Shape>
std::string inconsistent_record(const probe<Shape>& p, double bend = infinity<double>) {
    using T = number_t<Shape>;
    hit_record<T> rec{};
    if (!p.hit(rec)) return "";
    // The normal is rounded: of a ray that grazes a plane by less than that it cannot tell the side.
    const vec3<double> direction = to_double(p.ray.direction);
    const double slack = (4 * unit_roundoff<T> + length(to_double(rec.error)) / bend) * length(direction);
    if (dot(to_double(rec.normal), direction) > slack) return "normal along the ray, " + literal(rec);
    if (!p.shape.bounds().contains(rec.point)) return "beyond the bounds, " + literal(rec);
    return "";
}

/// The window is closed: it may begin and end at the crossing, and excludes it one number later.
template <class Shape>
std::string open_window(probe<Shape> p) {
    using T = number_t<Shape>;
    hit_record<T> rec{}, again{};
    if (!p.hit(rec)) return "";
    const probe<Shape> exactly{p.shape, p.ray, rec.t, rec.t};
    if (!exactly.hit(again)) return "missed in [t, t], " + literal(rec);
    if (again.t != rec.t || again.front_face != rec.front_face) return "another in [t, t], " + literal(again);
    p.t_max = std::nextafter(rec.t, -infinity<T>);
    if (p.hit(again)) return "a nearer hit in a shorter window, " + literal(again);
    return "";
}

/// A direction that is longer by a power of two, even by 1e20, makes t smaller by as much, and nothing else, as long as
/// none of these numbers leaves the range of T.
template <class Shape>
std::string direction_not_scaled(const probe<Shape>& p) {
    using T = number_t<Shape>;
    hit_record<T> rec{}, scaled_rec{};
    const bool hit = p.shape.hit(p.ray, T(0), infinity<T>, rec);
    for (const int exponent : {-66, -1, 66}) {
        bool in_range = true;
        const auto scaled = [&](T x, int e) {
            const T y = std::ldexp(x, e);
            // What is rounded up to the smallest normal number was out of range as well.
            in_range = in_range && (x == 0 || (std::isnormal(x) && std::isnormal(y) && std::ldexp(y, -e) == x));
            return y;
        };
        ray<T> ray = p.ray;
        for_each_number(ray.direction, [&](T& x) { x = scaled(x, exponent); });
        const bool scaled_hit = p.shape.hit(ray, T(0), infinity<T>, scaled_rec);
        if (hit && rec.t == T(0) && !scaled_hit) {  // it may have been below zero, and out of range
            const T least = std::ldexp(T(least_normal<T>), std::max(-exponent, 0));
            if (p.shape.hit(ray, -least, T(0), scaled_rec)) continue;
        }
        const T t = hit ? scaled(rec.t, -exponent) : T(0), t_back = scaled_hit ? scaled(scaled_rec.t, exponent) : T(0);
        in_range =
            in_range && (!scaled_hit || scaled_rec.t != 0 || (hit && t == 0));  // no t too small to be told from 0
        if (!in_range) continue;
        if (scaled_hit != hit) return "hit depends on the length of direction";
        if (hit && (scaled_rec.t != t || rec.t != t_back)) return "t = " + literal(scaled_rec.t) + " for " + literal(t);
        // A t of 0 may be one below the range, and then the exact one has another point.
        const T apart = hit ? norm1(scaled_rec.normal - rec.normal) : T(0);
        if (apart > (t == 0 ? T(4 * unit_roundoff<T>) : T(0))) return "normal depends on the length of direction";
    }
    return "";
}

/// A solid's spans begin and end at its hits, and between them there is none.
template <solid Shape>
std::string spans_unlike_hits(const probe<Shape>& p) {
    using T = number_t<Shape>;
    const spans inside = p.shape.spans(p.ray);
    hit_record<T> rec{};
    const auto is_hit = [&](T t) { return p.shape.occluded(p.ray, t, t); };
    T from = -infinity<T>;
    for (const interval<T>& span : inside) {
        if (!(from <= span.min && span.min <= span.max)) return "spans not sorted";
        if (std::isfinite(span.min)) {
            if (!p.shape.hit(p.ray, from, infinity<T>, rec) || rec.t != span.min || !rec.front_face)
                return "no hit where the span begins";
        }
        if (std::isfinite(span.max) && !is_hit(span.max)) return "no hit where the span ends";
        const T between = span.min + (span.max - span.min) / T(2);
        if (is_convex<Shape> && span.min < between && between < span.max && is_hit(between))
            return "a hit inside the span";
        from = std::nextafter(span.max, infinity<T>);
    }
    if (p.shape.hit(p.ray, from, infinity<T>, rec)) return "a hit behind the spans, " + literal(rec);
    return "";
}

/// Calls `visit` with every probe that differs from `p` in one number of the shape or the ray, which is `value`. Of a
/// shape of many numbers it takes 16 or fewer, evenly, from one that chance chooses.
template <class Shape, class Visit>
void for_each_replaced(const probe<Shape>& p, number_t<Shape> value, random_numbers& random, Visit visit) {
    using T = number_t<Shape>;
    const auto for_each_place = [](probe<Shape>& of, auto change) {
        int place = 0;
        const auto at = [&](T& x) { change(x, place++); };
        for_each_number(of.shape, at);
        for_each_number(of.ray, at);
    };
    int count = 0;
    probe<Shape> changed = p;
    for_each_place(changed, [&](T&, int place) { count = place + 1; });
    const int step = (count + 15) / 16;
    for (int i = random.integer(0, step - 1); i < count; i += step) {
        changed = p;
        for_each_place(changed, [&](T& x, int place) { x = place == i ? value : x; });
        visit(changed);
    }
}

/// A NaN or an infinity in any number of the shape, the ray or the window, or a direction of length zero, and the
/// answer is no.
template <class Shape>
std::string impossible_hit(const probe<Shape>& p, random_numbers& random) {
    using T = number_t<Shape>;
    const T nan = std::numeric_limits<T>::quiet_NaN();
    std::string wrong;
    const auto expect_miss = [&](const probe<Shape>& changed) {
        if (changed.shape.occluded(changed.ray, changed.t_min, changed.t_max)) wrong = "hit in " + literal(changed);
        if (const std::string unsound = unsound_answer(changed); !unsound.empty()) wrong = unsound + literal(changed);
    };
    for (const T value : {nan, infinity<T>, -infinity<T>}) for_each_replaced(p, value, random, expect_miss);
    expect_miss({p.shape, p.ray, nan, p.t_max});
    expect_miss({p.shape, p.ray, p.t_min, nan});
    expect_miss({p.shape, p.ray, infinity<T>, infinity<T>});
    expect_miss({p.shape, p.ray, -infinity<T>, -infinity<T>});
    expect_miss({p.shape, {p.ray.origin, vec3<T>(0)}, p.t_min, p.t_max});
    return wrong;
}

/// A NaN in any number of the shape is in every side of its bounds. (Minimum and maximum dropped it, or not, by its
/// place: a tree took what it promises to refuse.)
template <class Shape>
std::string bounds_without_nan(const probe<Shape>& p) {
    using T = number_t<Shape>;
    std::string wrong;
    for (int place = 0, count = 1; place < count; ++place) {
        Shape changed = p.shape;
        count = 0;
        const auto replace = [&](T& x) { x = count++ == place ? std::numeric_limits<T>::quiet_NaN() : x; };
        for_each_number(changed, replace);
        aabb<T> bounds = changed.bounds();
        for (const vec3<T>* corner : {&bounds.min, &bounds.max}) {
            if (!(is_nan(corner->x) && is_nan(corner->y) && is_nan(corner->z))) {
                wrong = "bounds without the NaN of number " + std::to_string(place);
            }
        }
    }
    return wrong;
}

/// The largest and the smallest numbers and zero, anywhere, are answered soundly.
template <class Shape>
std::string extreme_answer(const probe<Shape>& p, random_numbers& random) {
    using limits = std::numeric_limits<number_t<Shape>>;
    std::string wrong;
    for (const auto value :
         {number_t<Shape>(0), limits::denorm_min(), limits::min(), limits::max(), limits::lowest()}) {
        for_each_replaced(p, value, random, [&](const probe<Shape>& changed) {
            if (const std::string unsound = unsound_answer(changed); !unsound.empty()) {
                wrong = unsound + " from {" + literal(changed) + "}";
            }
        });
    }
    return wrong;
}

/// Is the recorded point so far from every edge that the face it lies on is the nearest one, from within and without?
template <class Shape>
bool away_from_edges(const Shape& shape, const hit_record<number_t<Shape>>& rec) {
    const auto exact_shape = converted<oracle>(shape);
    const vec3<oracle> inwards = converted<oracle>(rec.normal) * oracle(rec.front_face ? -1 : 1);
    // A face that is hit has no error across it, but a spawned ray leaves it by two numbers. At an edge, however
    // obtuse, another face is nearer than that; the 100th is for distances that are so to first order only.
    const oracle depth = 4 * oracle(norm1(rec.error)) + 8 * unit_roundoff<number_t<Shape>> * oracle(norm1(rec.point));
    using about = subject<std::remove_cvref_t<decltype(exact_shape)>>;
    const auto distance = [&](const vec3<oracle>& p) { return oracle(about::distance(exact_shape, p)); };
    if constexpr (requires { about::is_at_tip(exact_shape, vec3<oracle>(0)); }) {
        if (about::is_at_tip(exact_shape, converted<oracle>(rec.point))) return false;
    }
    // Of a thin rim, what is as deep may be outside half as far to a side, or what is a 16th as deep along the face.
    const auto point = converted<oracle>(rec.point);
    const auto is_clear = [&](const vec3<oracle>& way, int side) {
        bool clear = side * distance(point + way) > depth * 0.99;
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            vec3<oracle> beside(0);
            beside[axis] = depth / 2;
            const vec3<oracle> along = beside - inwards * dot(beside, inwards), shallow = way / oracle(16);
            clear = clear && side * distance(point + way + beside) > depth * 0.49 &&
                    side * distance(point + way - beside) > depth * 0.49 &&
                    side * distance(point + shallow + along) > 0 && side * distance(point + shallow - along) > 0;
        }
        return clear;
    };
    return is_clear(inwards * depth, solid<Shape> ? -1 : 1) && is_clear(inwards * -depth, 1);
}

/// A ray that was spawned on the surface never hits it again where it left: outwards it misses a convex solid, inwards
/// it meets the far side once, and from a flat shape it misses in any direction. A solid that is not convex may be met
/// again, outwards from the outside and inwards from within. (At an edge "inwards" of one face is outwards of the
/// other, and anything may come of it.)
template <class Shape>
std::string spawned_hit(const probe<Shape>& p, random_numbers& random) {
    using T = number_t<Shape>;
    hit_record<T> rec{}, again{};
    if (!p.hit(rec)) return "";
    for (int i = 0; i < 8; ++i) {
        const vec3<T> direction(random.direction());
        const T rising = dot(rec.normal, direction);
        if (rising == T(0)) continue;
        const bool outwards = (rising > T(0)) == rec.front_face;
        const ray<T> spawned = spawn_ray(rec, direction);
        const bool hit = p.shape.hit(spawned, T(0), infinity<T>, again);
        std::string wrong;
        if (hit && (is_convex<Shape> ? outwards || is_flat<Shape> : outwards != again.front_face)) {
            wrong = "hits what it left";
        }
        if (!outwards && !is_flat<Shape>) {
            if (hit && again.front_face) wrong = "hits the outside from within";
            if (is_convex<Shape> && hit &&
                p.shape.occluded(spawned, std::nextafter(again.t, infinity<T>), infinity<T>)) {
                wrong = "crosses twice";
            }
            if constexpr (solid<Shape>) {
                const spans inside = p.shape.spans(spawned);
                if (!hit && !inside.contains(infinity<T>)) wrong = "misses from within";
            }
        }
        if (!wrong.empty() && !(is_convex<Shape> && outwards) && !away_from_edges(p.shape, rec)) wrong.clear();
        if (!wrong.empty()) return wrong + ", " + literal(spawned) + ", " + literal(rec);
    }
    return "";
}

/// Rays in any direction from a point that lies on the surface are hit there, however its numbers round.
/// \param make  answers with a shape and the point
template <class Make>
void check_starts_on_surface(Make make) {
    random_numbers random(17);
    for (int i = 0; i < at_least(1'000); ++i) {
        const auto [shape, point] = make(random);
        using T = number_t<std::remove_cvref_t<decltype(shape)>>;
        const ray<T> ray{point, vec3<T>(random.direction())};
        hit_record<T> rec{};
        REQUIRE_MESSAGE(shape.hit(ray, T(0), infinity<T>, rec), literal(ray));
        REQUIRE_MESSAGE(rec.t == T(0), literal(ray) << ", " << literal(rec));
    }
}

/// Rays along the x axis meet a face at x = 0, from anywhere and however they are divided, just there.
template <class Shape>
void check_face_across_x(const Shape& shape) {
    using T = number_t<Shape>;
    for (int i = 1; i <= 40; ++i) {
        for (int j = 1; j <= 40; ++j) {
            const ray<T> ray{{T(i) / 8, T(0.25), T(0.125)}, {T(-j) / 8, 0, 0}};
            hit_record<T> rec{};
            REQUIRE(shape.hit(ray, T(0), infinity<T>, rec));
            REQUIRE_MESSAGE((rec.point.x == 0 && shape.bounds().contains(rec.point)), literal(ray));
        }
    }
}

/// All of them.
template <class Shape>
void check_properties() {
    const auto check = [](const char* property, int count, complaint_about<Shape> complaint) {
        for_random_probes<Shape>(property, share_of(count), complaint);
    };
    using probe = test::probe<Shape>;
    check("hit, occluded and record", 20'000, [](const probe& p, auto&) { return unsound_answer(p); });
    check("bounds and side", 20'000, [](const probe& p, auto&) { return inconsistent_record(p); });
    check("closed window", 10'000, [](const probe& p, auto&) { return open_window(p); });
    check("length of direction", 10'000, [](const probe& p, auto&) { return direction_not_scaled(p); });
    check("NaN and infinity", 2'000, [](const probe& p, auto& random) { return impossible_hit(p, random); });
    check("NaN in bounds", 200, [](const probe& p, auto&) { return bounds_without_nan(p); });
    check("extreme numbers", 2'000, [](const probe& p, auto& random) { return extreme_answer(p, random); });
    check("spawned rays", 10'000, [](const probe& p, random_numbers& random) { return spawned_hit(p, random); });
    if constexpr (solid<Shape>) {
        check("spans", 10'000, [](const probe& p, auto&) { return spans_unlike_hits(p); });
    }
}

}  // namespace raio::test
