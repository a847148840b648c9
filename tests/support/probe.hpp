#pragma once

#include <doctest/doctest.h>

#include "support/print.hpp"

namespace raio::test {

/// A shape and a ray that asks it something.
template <class Shape>
struct probe {
    using T = number_t<Shape>;

    Shape shape;
    raio::ray<T> ray;
    T t_min = T(0);
    T t_max = infinity<T>;

    bool hit(hit_record<T>& rec) const { return shape.hit(ray, t_min, t_max, rec); }
};

template <class Shape>
std::string literal(const probe<Shape>& p) {
    return literal(p.shape) + ", " + literal(p.ray) + ", " + literal(p.t_min) + ", " + literal(p.t_max);
}

/// A function that answers with what is wrong about a probe, or with nothing. It refers to it, as a std::function would
/// hold it: so what asks is compiled once for each shape.
template <class Shape>
class complaint_about {
public:
    template <class Complaint>
    complaint_about(const Complaint& complaint)
        : complaint_(&complaint), call_([](const void* c, const probe<Shape>& p, random_numbers& random) {
              return std::string((*static_cast<const Complaint*>(c))(p, random));
          }) {}

    std::string operator()(const probe<Shape>& p, random_numbers& random) const { return call_(complaint_, p, random); }

private:
    const void* complaint_;
    std::string (*call_)(const void*, const probe<Shape>&, random_numbers&);
};

/// Shape and ray made of small whole numbers: rays through edges and vertices, tangents, rays in the plane of a flat
/// shape or from a point of the surface are the rule, and exactly so.
template <class Shape>
probe<Shape> lattice_probe(random_numbers& random) {
    using T = number_t<Shape>;
    probe<Shape> p{subject<Shape>::random(random, 1.0, vec3<double>(0)), {}};
    if constexpr (requires { subject<Shape>::lattice(random); }) {
        p.shape = subject<Shape>::lattice(random);
    } else {
        for_each_number(p.shape, [&](T& x) { x = T(random.integer(-3, 3)); });
    }
    for_each_number(p.ray.origin, [&](T& x) { x = T(random.integer(-4, 4)); });
    for_each_number(p.ray.direction, [&](T& x) {
        x = random.one_in(2) ? std::copysign(T(0), T(random.integer(0, 1)) - T(0.5)) : T(random.integer(-2, 2));
    });
    return p;
}

/// Shapes of sizes 1e-6 to 1e6 at up to 1000 sizes from the origin; rays from up to a million sizes away, from inside
/// or from the surface; to anywhere on the shape, or to where it is hard: edges, silhouettes, axes.
template <class Shape>
probe<Shape> scattered_probe(random_numbers& random) {
    using T = number_t<Shape>;
    using about = subject<Shape>;
    const double size = random.log_uniform(1e-6, 1e6);
    const vec3<double> place =
        random.one_in(2) ? vec3<double>(0) : random.direction() * size * random.log_uniform(1, 1e3);
    probe<Shape> p{about::random(random, size, place), {}};

    const vec3<double> far_off =
        about::inner_point(p.shape, random) + random.direction() * size * random.log_uniform(1, 1e6);
    const vec3<double> from = random.one_in(8) ? about::inner_point(p.shape, random) : far_off;
    const vec3<double> to = random.one_in(3)   ? about::special_point(p.shape, from, random)
                            : random.one_in(2) ? about::inner_point(p.shape, random)
                                               : about::inner_point(p.shape, random) + random.direction() * size;
    p.ray = {vec3<T>(from), vec3<T>(to) - vec3<T>(from)};
    if (random.one_in(2)) p.ray.direction = vec3<T>(normalize(to - from));

    if (random.one_in(8)) {  // along an axis, or across one, with zeros of both signs
        const bool along = random.one_in(2);
        const glm::length_t axis = random.integer(0, 2);
        for (glm::length_t i = 0; i < 3; ++i) {
            if ((i == axis) == along) continue;
            p.ray.origin[i] = static_cast<T>(to[i]);
            p.ray.direction[i] = std::copysign(T(0), p.ray.direction[i]);
        }
    }
    if (random.one_in(4)) p.ray.direction *= static_cast<T>(std::ldexp(1.0, random.integer(-66, 66)));
    if (random.one_in(16)) {  // away from it, which it may be met behind
        p.ray.direction = -p.ray.direction;
        if (random.one_in(2)) p.t_min = -infinity<T>;
    }
    if (hit_record<T> rec; random.one_in(6) && p.hit(rec)) {  // from the surface, or from next to it
        const double off = random.one_in(2) ? size * random.log_uniform(1e-9, 1e-4) : 0.0;
        const vec3<double> near_by = to_double(rec.point) + random.direction() * off;
        p.ray = {vec3<T>(near_by), vec3<T>(random.direction())};
    }
    if (hit_record<T> rec; random.one_in(8) && p.hit(rec)) {  // through a window that ends near the crossing, or at it
        (random.one_in(2) ? p.t_min : p.t_max) = rec.t * static_cast<T>(random.one_in(2) ? 1 : random.uniform(0, 2));
    }
    return p;
}

template <class Shape>
probe<Shape> random_probe(random_numbers& random) {
    return random.one_in(4) ? lattice_probe<Shape>(random) : scattered_probe<Shape>(random);
}

/// Counts complaints, prints the first three, and fails if there was any.
class complaints {
public:
    explicit complaints(const char* property) : property_(property) {}

    /// \param print  answers with what the complaint is about
    template <class Print>
    void add(const std::string& wrong, Print print) {
        if (!wrong.empty() && ++count_ <= 3) fail(wrong, print());
    }
    void check(int of) const {
        if (count_ != 0) FAIL_CHECK(property_ << ": complaints about " << count_ << " of " << of);
        CHECK(count_ == 0);
    }

private:
    void fail(const std::string& wrong, const std::string& what) const {
        FAIL_CHECK(property_ << ": " << wrong << "\n    {" << what << "}");
    }

    const char* property_;
    int count_ = 0;
};

/// Sends `count` random probes to `complaint`, which answers with what is wrong, or with nothing.
template <class Shape>
void for_random_probes(const char* property, int count, complaint_about<Shape> complaint) {
    random_numbers random(20260101);
    complaints all(property);
    for (int i = 0; i < count; ++i) {
        const probe<Shape> p = random_probe<Shape>(random);
        all.add(complaint(p, random), [&] { return literal(p); });
    }
    all.check(count);
}

}  // namespace raio::test
