#pragma once

#include "support/accuracy.hpp"
#include "support/properties.hpp"

/// \file
/// Lines that touch a surface along more than a point: generators, rulings, and what has three crossings in one place.

namespace raio::test {

/// Such a line, by a point of it that is on the surface, and whose shape that is.
template <class Shape>
struct touching_line {
    Shape shape;
    vec3<double> point, direction;
};

/// A ray along such a line, as near to it as T can say, or a little off.
template <class Shape>
probe<Shape> ray_along(touching_line<Shape> line, random_numbers& random) {
    using T = number_t<Shape>;
    const double size = length(line.direction);
    if (random.one_in(4)) line.direction += random.direction() * (size * random.log_uniform(1e-17, 1e-6));
    if (random.one_in(2)) line.direction = -line.direction;
    const double before = random.one_in(4) ? 0 : random.log_uniform(1e-3, 1e3);
    probe<Shape> p{line.shape, {vec3<T>(line.point - line.direction * before), vec3<T>(line.direction)}};
    if (before > 0 && random.one_in(3)) p.ray.direction = vec3<T>(line.point) - p.ray.origin;
    return p;
}

/// What is promised of every ray holds of such ones, and what two doubles can tell is right.
/// \param make  of random numbers a `touching_line`
template <class Make>
void check_along_surface(int rays, Make make) {
    random_numbers random(23);
    int hits = 0, excused = 0, complaints = 0;
    for (int i = 0; i < rays; ++i) {
        const auto p = ray_along(make(random), random);
        worst_errors worst;
        std::string wrong = inexactness(p, worst);
        hits += worst.hits;
        if (!wrong.empty() && is_excused(p)) wrong.clear(), ++excused;
        wrong += unsound_answer(p) + inconsistent_record(p) + open_window(p);
        if (!wrong.empty() && ++complaints <= 3) FAIL_CHECK(wrong << "\n    {" << literal(p) << "}");
    }
    MESSAGE(rays << " rays, " << hits << " hits, undecided: " << excused);
    CHECK(complaints == 0);
    CHECK(hits > rays / 4);
}

}  // namespace raio::test
