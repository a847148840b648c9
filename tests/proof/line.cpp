#include <raio/proof/line.hpp>

#include "support/proven.hpp"

namespace raio::test {

/// The numbers of rays and shapes that W is made of.
template <class W>
struct numbers_of {
    using number = double;
};
template <std::size_t N>
struct numbers_of<pack<float, N>> {
    using number = pack<float, N>;
};
template <std::size_t N>
struct numbers_of<pack<double, N>> {
    using number = pack<double, N>;
};
template <std::size_t N>
struct numbers_of<pack<strict_double, N>> {
    using number = pack<double, N>;
};

template <class T>
vec3<T> any_vector(random_numbers& random, const vec3<T>* near = nullptr) {
    vec3<T> v;
    for (int axis = 0; axis < 3; ++axis) {
        v[axis] = maker<given_number<T>>::any(random, 40, near != nullptr ? &(*near)[axis] : nullptr).number.value;
    }
    return v;
}

/// What a vector is off by, component by component.
/// \param largest  the largest part of K roundings so far
template <class W, int K, class T>
void check_vector(const rounded_vector<W, K>& found, const vec3<T>& to, const vec3<T>* from, double& largest) {
    const std::array<W, 3> parts{found.x, found.y, found.z};
    for (std::size_t i = 0; i < lanes_of<W>; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto part = [&](const vec3<T>& v) { return exactly(lane(v[axis], i)); };
            const oracle exact = from != nullptr ? part(to) - part(*from) : part(to);
            const oracle off = abs(exactly(lane(parts[static_cast<std::size_t>(axis)], i)) - exact);
            if constexpr (K == 0) {
                REQUIRE(off == oracle(0));
            } else {
                const oracle bound = abs(exact) * largest_rounding<W>(K);
                REQUIRE(off <= bound);
                if (bound > oracle(0)) largest = std::max(largest, rounded<double>(off / bound));
            }
        }
    }
}

/// \tparam T  the numbers of the shape
/// \tparam R  those of the ray, with as many digits
template <class W, class T, class R = T>
double worst_of_line() {
    random_numbers random(1);
    double largest = 0;
    for (int i = 0; i < share_of_lanes<W>(2000); ++i) {
        const vec3<T> p = any_vector<T>(random), q = any_vector<T>(random, &p);
        const ray<R> r{vec3<R>(any_vector<T>(random, &p)), vec3<R>(any_vector<T>(random))};
        const line<W, R> line{r};
        check_vector(line.to(p), p, &r.origin, largest);
        check_vector(line.from(p), r.origin, &p, largest);
        check_vector(line.between(p, q), q, &p, largest);
        check_vector(line.direction(), r.direction, static_cast<const vec3<R>*>(nullptr), largest);
        check_vector(line.given(p), p, static_cast<const vec3<T>*>(nullptr), largest);
        const given_number<W> x = line.given(p.x);
        for (std::size_t j = 0; j < lanes_of<W>; ++j) REQUIRE(exactly(lane(x.value, j)) == exactly(lane(p.x, j)));
    }
    return largest;
}

TEST_CASE_TEMPLATE("line: what goes between points is rounded once, and what is given not at all", W, RAIO_PRECISIONS) {
    using T = typename numbers_of<W>::number;
    const double largest = worst_of_line<W, T>();
    // A double_double holds the difference of two doubles without an error.
    CHECK((last_precision<W> ? largest == 0 : largest > 0.9));
}

TEST_CASE("line: floats, in numbers with more digits") {
    CHECK(worst_of_line<strict_double, float>() > 0.9);
    CHECK(worst_of_line<double_double, float>() == 0);
    CHECK(worst_of_line<pack<double, 8>, pack<float, 8>>() > 0.9);
    CHECK(worst_of_line<pack<strict_double, 8>, pack<float, 8>>() > 0.9);
}

TEST_CASE("line: of a ray with more digits than a double") {
    using W = double_double;
    random_numbers random(2);
    double largest = 0;
    for (int i = 0; i < at_least(2000); ++i) {
        const vec3<double> p = any_vector<double>(random);
        const ray<double> start{any_vector<double>(random, &p), any_vector<double>(random)};
        const ray<double_double> r = with_more_digits(start, random);
        const line<W, double_double> line{r};
        const auto to = line.to(p), from = line.from(p);
        const auto d = line.direction();
        const auto check = [&](const W& found, const oracle& exact) {
            const oracle bound = abs(exact) * largest_rounding<W>(1), off = abs(exactly(found) - exact);
            REQUIRE(off <= bound);
            if (bound > oracle(0)) largest = std::max(largest, rounded<double>(off / bound));
        };
        check(to.x, exactly(p.x) - exactly(r.origin.x));
        check(to.y, exactly(p.y) - exactly(r.origin.y));
        check(to.z, exactly(p.z) - exactly(r.origin.z));
        check(from.x, exactly(r.origin.x) - exactly(p.x));
        check(from.z, exactly(r.origin.z) - exactly(p.z));
        REQUIRE((exactly(d.x) == exactly(r.direction.x) && exactly(d.y) == exactly(r.direction.y)));
    }
    // That of two parts is close to its last bits, which it does not promise.
    CHECK(largest > 0x1p-10);
}

}  // namespace raio::test
