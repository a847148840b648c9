#include <raio/number/bounded_vector.hpp>

#include <raio/math/vec.hpp>

#include "support/proven.hpp"

namespace raio::test {

template <class V>
struct known_vector {
    V number;
    std::array<vec3<oracle>, lanes_of<typename V::number>> exact;
};

/// Some components all but a given vector's, or all but across it, with what it stands for.
template <class V>
struct vector_maker;
template <class W, int K>
struct vector_maker<rounded_vector<W, K>> {
    using vector = rounded_vector<W, K>;
    using part = maker<rounded_number<W, K>>;

    template <class N = vector>
    static known_vector<vector> any(random_numbers& random, double scale, const N* near = nullptr) {
        // One in four along an axis, where products are as large as the sizes.
        const double most = random.one_in(4) ? 20 : 2;
        const auto x = part::any(random, most, near ? &near->x : nullptr);
        const auto y = part::any(random, most, near ? &near->y : nullptr);
        const auto z = part::any(random, most, near ? &near->z : nullptr);
        const W unit(std::exp2(std::floor(scale)));
        known_vector<vector> made{{x.number.value * unit, y.number.value * unit, z.number.value * unit}, {}};
        const oracle exact_unit(std::exp2(std::floor(scale)));
        for (std::size_t i = 0; i < lanes_of<W>; ++i) {
            made.exact[i] = vec3<oracle>(x.exact[i], y.exact[i], z.exact[i]) * exact_unit;
        }
        return made;
    }
};
template <class W>
struct vector_maker<bounded_vector<W>> {
    template <class N = bounded_vector<W>>
    static known_vector<bounded_vector<W>> any(random_numbers& random, double scale, const N* near = nullptr) {
        const auto given = vector_maker<given_vector<W>>::any(random, scale, near);
        const auto& v = given.number;
        const W part = in_lanes<W>([&](std::size_t) {
            return random.one_in(4) ? 0 : std::exp2(random.uniform(std::log2(unit_roundoff<W>), 0));
        });
        known_vector<bounded_vector<W>> made{{v.x, v.y, v.z, size_of(v) * bound_t<W>(part)}, given.exact};
        for (std::size_t i = 0; i < lanes_of<W>; ++i) {
            // In one component, or in all of them.
            const oracle error = exactly(lane(made.number.error, i));
            const int axis = random.integer(0, 3);
            for (int k = 0; k < 3; ++k) {
                if (axis == 3) made.exact[i][k] += some_way(random) * error / oracle(3);
                if (axis == k) made.exact[i][k] += some_way(random) * error;
            }
        }
        return made;
    }
};

template <class W, class Visit>
void for_each_vector(Visit visit) {
    visit.template operator()<given_vector<W>>();
    visit.template operator()<rounded_vector<W, 3>>();
    visit.template operator()<bounded_vector<W>>();
}

/// The errors of three components, added up.
template <class W>
void see(worst& seen, const bounded_vector<W>& v, const std::array<vec3<oracle>, lanes_of<W>>& exact) {
    for (std::size_t i = 0; i < lanes_of<W>; ++i) {
        const oracle off = abs(exactly(lane(v.x, i)) - exact[i].x) + abs(exactly(lane(v.y, i)) - exact[i].y) +
                           abs(exactly(lane(v.z, i)) - exact[i].z);
        seen.see_lane<W>(off, oracle(0), exactly(lane(v.error, i)));
    }
}
template <class W, int K>
void see(worst& seen, const rounded_vector<W, K>& v, const std::array<vec3<oracle>, lanes_of<W>>& exact) {
    const std::array<W, 3> parts{v.x, v.y, v.z};
    for (std::size_t k = 0; k < 3; ++k) {
        exact_lanes<W> part;
        for (std::size_t i = 0; i < lanes_of<W>; ++i) part[i] = exact[i][static_cast<int>(k)];
        seen.see(rounded_number<W, K>{parts[k]}, part);
    }
}
template <proven_number N, std::size_t Lanes>
void see(worst& seen, const N& x, const std::array<oracle, Lanes>& exact) {
    seen.see(x, exact);
}

template <class F, class A, class B>
auto exact_of(F f, const A& a, const B& b) {
    std::array<decltype(f(a[0], b[0])), std::tuple_size_v<A>> made;
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = f(a[i], b[i]);
    return made;
}

template <class V>
inline constexpr bool is_given_vector = false;
template <class W>
inline constexpr bool is_given_vector<given_vector<W>> = true;

template <class W>
void check_worst(const worst& seen, const closeness& least, bool given) {
    if (given) {
        if (!last_precision<W>) CHECK(seen.part >= least.of_given);
    } else {
        CHECK(seen.part >= least.of_any);
    }
    CHECK(seen.open == 0);
}

/// As check_binary, of two vectors, or of the first of them.
template <class W, bool OfOne = false, class F>
void check_vectors(const char* name, const closeness& least, F f) {
    CAPTURE(name);
    random_numbers random(8);
    for_each_vector<W>([&]<class A>() {
        for_each_vector<W>([&]<class B>() {
            worst seen;
            for (int i = 0; i < share_of_lanes<W>(600); ++i) {
                const double scale = random.uniform(-15, 15);
                const auto a = vector_maker<A>::any(random, scale);
                const auto b = vector_maker<B>::any(random, random.one_in(2) ? -scale : 0, &a.number);
                see(seen, f(a.number, b.number), exact_of(f, a.exact, b.exact));
            }
            check_worst<W>(seen, least, is_given_vector<A> && (OfOne || is_given_vector<B>));
        });
    });
}

TEST_CASE_TEMPLATE("bounded_vector: what a product or a sum is off by is within its bound, and close", W,
                   RAIO_PRECISIONS) {
    check_vectors<W>("dot", {0.4, 0.3}, [](const auto& a, const auto& b) { return dot(a, b); });
    check_vectors<W>("cross", {0.5, 0.4}, [](const auto& a, const auto& b) { return cross(a, b); });
    check_vectors<W>("sum", {0.9, 0.8}, [](const auto& a, const auto& b) { return a + b; });
    check_vectors<W>("difference", {0.9, 0.8}, [](const auto& a, const auto& b) { return a - b; });
    check_vectors<W>("component by component", {0.3, 0.3}, [](const auto& a, const auto& b) { return a * b; });
    check_vectors<W>("shear", {0.3, 0.3}, []<class V>(const V& v, const auto& slope) {
        if constexpr (proven_vector<V>) {
            return shear(v, slope);
        } else {
            return V(v.x - slope.x * v.z, v.y - slope.y * v.z, v.z);
        }
    });
    check_vectors<W, true>("square", {0.5, 0.5}, [](const auto& a, const auto&) { return square(a); });
    check_vectors<W, true>("opposite", {0.9, 0}, [](const auto& a, const auto&) { return -a; });
}

TEST_CASE_TEMPLATE("bounded_vector: so is what is made of a vector and a number", W, RAIO_PRECISIONS) {
    random_numbers random(9);
    const auto times = [](const auto& v, const auto& s) { return v * s; };
    for_each_vector<W>([&]<class V>() {
        for_each_kind<W>([&]<class S>() {
            worst seen;
            for (int i = 0; i < share_of_lanes<W>(600); ++i) {
                const auto v = vector_maker<V>::any(random, random.uniform(-15, 15));
                const auto s = maker<S>::any(random, 15);
                see(seen, v.number * s.number, exact_of(times, v.exact, s.exact));
            }
            check_worst<W>(seen, {0.7, 0.9}, is_given_vector<V> && is_given<S>);
        });
    });
}

TEST_CASE_TEMPLATE("bounded_vector: the roundings of a square are counted whatever its components are", W,
                   RAIO_PRECISIONS) {
    // All roundings to the same side, of three components of one size and of one component alone.
    const oracle off = largest_rounding<W>(5);
    for (const double other : {0.0, 0.3660254037844386, 1.0}) {
        const W x(1), y(other);
        const vec3<oracle> exact(oracle(1) + off, exactly(lane(y, 0)) * (oracle(1) + off),
                                 exactly(lane(y, 0)) * (oracle(1) + off));
        worst seen;
        const rounded_vector<W, 5> v{x, y, y};
        exact_lanes<W> squares;
        for (auto& s : squares) s = square(exact);
        see(seen, square(v), squares);
        CHECK(seen.part > 0.5);
    }
}

TEST_CASE_TEMPLATE("bounded_vector: small products that lose digits are known to", W, RAIO_PRECISIONS) {
    // A factor may be as small as it gets: the bound of its product is no product of a bound.
    random_numbers random(10);
    const double most = std::same_as<scalar_t<W>, float> ? 70 : 500;
    for_each_vector<W>([&]<class A>() {
        for_each_vector<W>([&]<class B>() {
            worst seen;
            const auto dots = [](const auto& a, const auto& b) { return dot(a, b); };
            const auto crosses = [](const auto& a, const auto& b) { return cross(a, b); };
            for (int i = 0; i < share_of_lanes<W>(200); ++i) {
                const auto a = vector_maker<A>::any(random, random.uniform(-most, -most / 2));
                const auto b = vector_maker<B>::any(random, random.uniform(-most, -most / 2));
                see(seen, dots(a.number, b.number), exact_of(dots, a.exact, b.exact));
                see(seen, crosses(a.number, b.number), exact_of(crosses, a.exact, b.exact));
            }
            CHECK(seen.open == 0);
        });
    });
}

/// What formulas are made of: a line that is seen from a shape, two vectors of the shape, and a length.
template <class Vector, class Given, class Number>
struct setting {
    Vector l, u, v;
    Given d;
    Number r;
};

/// As check_binary, of a formula.
/// \param least  which part of its bound is reached at least; a quarter of that in the last precision, which is better
///               than it says
template <class W, class F>
void check_formula(const char* name, double least, F f) {
    CAPTURE(name);
    random_numbers random(11);
    using vector = rounded_vector<W, 1>;
    worst seen;
    for (int i = 0; i < share_of_lanes<W>(3000); ++i) {
        const double scale = std::same_as<scalar_t<W>, float> ? random.uniform(-6, 6) : random.uniform(-40, 40);
        const auto l = vector_maker<vector>::any(random, scale);
        const auto d = vector_maker<given_vector<W>>::any(random, 0, random.one_in(2) ? &l.number : nullptr);
        const auto u = vector_maker<vector>::any(random, scale, random.one_in(4) ? &d.number : nullptr);
        const auto v = vector_maker<vector>::any(random, scale, random.one_in(4) ? &u.number : nullptr);
        const auto r = maker<given_number<W>>::any(random, 2);
        const W unit(std::exp2(std::floor(scale)));
        exact_lanes<W> exact;
        for (std::size_t j = 0; j < lanes_of<W>; ++j) {
            const oracle radius = r.exact[j] * exactly(std::exp2(std::floor(scale)));
            exact[j] =
                f(setting<vec3<oracle>, vec3<oracle>, oracle>{l.exact[j], u.exact[j], v.exact[j], d.exact[j], radius});
        }
        const given_number<W> radius{r.number.value * unit};
        seen.see(f(setting<vector, given_vector<W>, given_number<W>>{l.number, u.number, v.number, d.number, radius}),
                 exact);
    }
    CHECK(seen.part > (last_precision<W> ? least / 4 : least));
    CHECK(seen.known > seen.open / 4);  // many lines miss
}

TEST_CASE_TEMPLATE("bounded_vector: the formulas of shapes are within their bounds, and close", W, RAIO_PRECISIONS) {
    const auto sphere = [](const auto& s) { return square(s.d) * (s.r * s.r) - square(cross(s.l, s.d)); };
    check_formula<W>("sphere", 0.4, sphere);
    check_formula<W>("sphere, t", 0.2,
                     [&](const auto& s) { return (dot(s.l, s.d) - root_of(sphere(s))) * inverse(square(s.d)); });
    const auto cylinder = [](const auto& s) {
        const auto n = cross(s.d, s.u);
        return square(s.u) * (square(n) * (s.r * s.r) - square(dot(s.l, n)));
    };
    check_formula<W>("cylinder", 0.25, cylinder);
    check_formula<W>("cylinder, t", 0.07, [&](const auto& s) {
        const auto n = cross(s.d, s.u);
        return (dot(cross(s.l, s.u), n) + root_of(cylinder(s))) * inverse(square(n));
    });
    check_formula<W>("plane, t", 0.15, [](const auto& s) { return dot(s.l, s.u) * inverse(dot(s.d, s.u)); });
    check_formula<W>("triangle", 0.25, [](const auto& s) { return dot(s.u, cross(s.d, s.v)); });
    check_formula<W>("triangle, t", 0.08,
                     [](const auto& s) { return dot(s.v, cross(s.l, s.u)) * inverse(dot(s.u, cross(s.d, s.v))); });
    check_formula<W>("triangle, the normal's t", 0.07, [](const auto& s) {
        const auto n = cross(s.u, s.v);
        return dot(s.l, n) * inverse(dot(s.d, n));
    });
    check_formula<W>("the point at t from the axis", 0.4, [](const auto& s) {
        const auto t = dot(s.l, s.d) * inverse(square(s.d));
        return square(cross(s.d * t - s.l, s.u)) - square(s.u) * square(s.r);
    });
}

}  // namespace raio::test
