#pragma once

#include "support/accuracy.hpp"
#include "support/properties.hpp"

/// \file
/// Tables of cases with names, the same for float and double. A probe that failed somewhere is printed as it stands in
/// one.

namespace raio::test {

/// What a case expects: nothing, or a crossing at t, where the ray comes from the outside or from within.
struct expectation {
    bool hit;
    double t;
    bool front_face;
};
inline constexpr expectation misses{false, 0, false};
constexpr expectation enters(double t) { return {true, t, true}; }
constexpr expectation leaves(double t) { return {true, t, false}; }

template <class Shape>
struct named_case {
    using T = number_t<Shape>;

    const char* name;
    Shape shape;
    raio::ray<T> ray;
    expectation expected;
    T t_min = T(0);
    T t_max = infinity<T>;
};

/// Every case gives what it expects, t to the last bit; the oracle thinks so too; and every promise is kept.
template <class Shape>
void check_cases(const std::vector<named_case<Shape>>& cases) {
    using T = number_t<Shape>;
    for (const named_case<Shape>& c : cases) {
        INFO(std::string(c.name));
        const probe<Shape> p{c.shape, c.ray, c.t_min, c.t_max};
        hit_record<T> rec{};
        const bool hit = p.hit(rec);
        CHECK(hit == c.expected.hit);
        if (hit && c.expected.hit) {
            // Of a double, t is right to the error that is stated.
            const T t = static_cast<T>(c.expected.t);
            if constexpr (detail::keeps_all_digits<T>) {
                stated_errors<Shape> errors(p.shape, p.ray);
                CHECK(abs(oracle(rec.t) - oracle(t)) <= errors.at(oracle(t)));
            } else {
                CHECK(rec.t == t);
            }
            CHECK(rec.front_face == c.expected.front_face);
        }
        worst_errors worst;
        random_numbers random(7);
        const bool finite = all_finite(c.ray.origin) && all_finite(c.ray.direction) && c.t_min <= c.t_max;
        if (finite) CHECK(inexactness(p, worst) == "");
        CHECK(unsound_answer(p) == "");
        CHECK(inconsistent_record(p) == "");
        CHECK(open_window(p) == "");
        CHECK(spawned_hit(p, random) == "");
        if constexpr (solid<Shape>) CHECK(spans_unlike_hits(p) == "");
    }
}

/// NaN, infinity and the ends of the range, for the tables.
template <class T>
inline constexpr T nan = std::numeric_limits<T>::quiet_NaN();

}  // namespace raio::test
