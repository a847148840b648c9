#include <raio/shape/polyhedra.hpp>

#include <doctest/doctest.h>

#include "support/random.hpp"

namespace raio::test {

template <class T>
vec3<double> in_double(const vec3<T>& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// The largest signed distance from any of the planes: negative inside.
template <class Solid, class T>
double height(const Solid& solid, const vec3<T>& p) {
    double highest = -infinity<double>;
    for (const auto& plane : solid.planes) {
        const vec3<double> n = in_double(plane.normal);
        highest = std::max(highest, (dot(n, in_double(p)) + static_cast<double>(plane.offset)) / length(n));
    }
    return highest;
}

/// Every corner lies on the surface, three planes at least meet there, and the middle of them all is inside.
template <class Solid, class T>
void check_corners(const Solid& solid, const std::vector<vec3<T>>& corners, double size) {
    const double slack = 8 * size * static_cast<double>(std::numeric_limits<T>::epsilon());
    vec3<double> middle(0);
    for (const vec3<T>& corner : corners) {
        middle += in_double(corner) * (1.0 / static_cast<double>(corners.size()));
        CHECK(std::abs(height(solid, corner)) < slack);
        int met = 0;
        for (const auto& plane : solid.planes) {
            const vec3<double> n = in_double(plane.normal);
            met += std::abs(dot(n, in_double(corner)) + static_cast<double>(plane.offset)) < slack * length(n);
        }
        CHECK(met >= 3);
        CHECK(solid.bounds().contains(corner));
    }
    CHECK(height(solid, vec3<T>(middle)) < -1e-3 * size);
}

TEST_CASE_TEMPLATE("oriented_box: the corners, along the axes and turned", T, RAIO_NUMBERS) {
    const auto straight = oriented_box<T>({1, 2, 3}, {1, 0, 0}, {0, 2, 0}, {0, 0, 4});
    check_corners<decltype(straight), T>(straight, {{0, 0, -1}, {2, 4, 7}, {0, 4, -1}, {2, 0, 7}}, 5);
    CHECK(straight.area() == doctest::Approx(112));
    const ray<T> along{{-9, 2, 3}, {1, 0, 0}};
    hit_record<T> rec{};
    REQUIRE(straight.hit(along, T(0), infinity<T>, rec));
    CHECK((rec.t == T(9) && rec.normal == vec3<T>(-1, 0, 0) && rec.front_face));
    CHECK((straight.spans(along) == interval<T>{9, 11}));

    const auto turned = oriented_box<T>({0, 0, 0}, {3, 4, 0}, {-4, 3, 0}, {0, 0, 1});
    check_corners<decltype(turned), T>(turned, {{-1, 7, 1}, {7, 1, -1}, {1, -7, 1}, {-7, -1, -1}}, 7);
    REQUIRE(turned.hit({{30, 40, 0}, {-3, -4, 0}}, T(0), infinity<T>, rec));
    CHECK(rec.t == T(9));
    CHECK(length(vec3<T>(rec.normal - vec3<T>(T(0.6), T(0.8), 0))) < 4 * std::numeric_limits<T>::epsilon());
    CHECK(!turned.occluded({{7, 7, 5}, {0, 0, -1}}, T(0), infinity<T>));

    const auto leaning = oriented_box<T>({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 1});  // a parallelepiped
    check_corners<decltype(leaning), T>(leaning, {{2, 1, 1}, {0, 1, 1}, {-2, -1, 1}, {0, -1, -1}}, 2);
}

TEST_CASE_TEMPLATE("tetrahedron: whatever the order of the corners", T, RAIO_NUMBERS) {
    const vec3<T> a(0, 0, 0), b(2, 0, 0), c(0, 2, 0), d(0, 0, 2);
    for (const auto& solid : {tetrahedron(a, b, c, d), tetrahedron(b, a, c, d), tetrahedron(d, c, b, a)}) {
        check_corners<std::remove_cvref_t<decltype(solid)>, T>(solid, {a, b, c, d}, 2);
        CHECK(solid.area() == doctest::Approx(6 + 2 * std::sqrt(3.0)));
        hit_record<T> rec{};
        REQUIRE(solid.hit({{0.5, 0.5, 9}, {0, 0, -1}}, T(0), infinity<T>, rec));
        const T off = std::same_as<T, float> ? 0 : 32 * std::numeric_limits<T>::epsilon();
        CHECK((std::abs(rec.t - 8) <= off && rec.normal.x > T(0.5)));
    }
}

TEST_CASE_TEMPLATE("pyramid and prism: on any convex base", T, RAIO_NUMBERS) {
    const std::array<vec3<T>, 5> base{vec3<T>{2, 0, 1}, vec3<T>{1, 2, 1}, vec3<T>{-1, 2, 1}, vec3<T>{-2, 0, 1},
                                      vec3<T>{0, -2, 1}};
    const auto roof = pyramid(base, vec3<T>(0, 0, 4));
    check_corners<decltype(roof), T>(roof, {base[0], base[1], base[2], base[3], base[4], {0, 0, 4}}, 4);
    const auto block = prism(base, vec3<T>(0, 1, 4));
    std::vector<vec3<T>> corners(base.begin(), base.end());
    for (const vec3<T>& corner : base) corners.push_back(corner + vec3<T>(0, 1, 4));
    check_corners<decltype(block), T>(block, corners, 5);
    hit_record<T> rec{};
    REQUIRE(roof.hit({{0, 0, -9}, {0, 0, 1}}, T(0), infinity<T>, rec));
    CHECK((rec.t == T(10) && rec.normal == vec3<T>(0, 0, -1)));
    REQUIRE(block.hit({{0, 1, 9}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK((rec.t == T(4) && rec.normal == vec3<T>(0, 0, 1)));
}

/// How often corner to corner is an edge, and how long: what makes a solid regular.
template <std::size_t Faces, class T>
void check_regular(double area, double edge) {
    const vec3<T> center(1, 2, 3);
    const auto solid = regular_solid<Faces>(center, T(2));
    const double eps = static_cast<double>(std::numeric_limits<T>::epsilon());
    CHECK(static_cast<double>(solid.area()) == doctest::Approx(4 * area).epsilon(64 * eps));
    // The corners are where three planes meet.
    std::vector<vec3<double>> corners;
    for (std::size_t i = 0; i < Faces; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            for (std::size_t k = 0; k < j; ++k) {
                const vec3<double> l = in_double(solid.planes[i].normal), m = in_double(solid.planes[j].normal),
                                   n = in_double(solid.planes[k].normal);
                const double det = dot(l, cross(m, n));
                if (std::abs(det) < 1e-3) continue;
                const auto offset = [&](std::size_t f) { return static_cast<double>(solid.planes[f].offset); };
                const vec3<double> p =
                    (cross(m, n) * offset(i) + cross(n, l) * offset(j) + cross(l, m) * offset(k)) * (-1 / det);
                if (height(solid, p) > 64 * eps) continue;
                bool seen = false;
                for (const vec3<double>& q : corners) seen = seen || length(q - p) < 1e-3;
                if (!seen) corners.push_back(p);
            }
        }
    }
    const std::size_t dual[] = {4, 8, 6, 20, 12}, index = Faces == 4    ? 0
                                                          : Faces == 6  ? 1
                                                          : Faces == 8  ? 2
                                                          : Faces == 12 ? 3
                                                                        : 4;
    CHECK(corners.size() == dual[index]);
    for (const vec3<double>& p : corners) {
        CHECK(length(p - in_double(center)) == doctest::Approx(2).epsilon(64 * eps));
        double nearest = 9;
        for (const vec3<double>& q : corners) {
            if (q != p) nearest = std::min(nearest, length(q - p));
        }
        CHECK(nearest == doctest::Approx(2 * edge).epsilon(64 * eps));
    }
}

TEST_CASE_TEMPLATE("regular_solid: corners on the sphere, edges of one length, the area of the books", T,
                   RAIO_NUMBERS) {
    const double root3 = std::sqrt(3.0), root5 = std::sqrt(5.0), golden = (1 + root5) / 2;
    const double dodecahedron_edge = 2 / (root3 * golden), icosahedron_edge = 2 / std::sqrt(golden * root5);
    check_regular<4, T>(8 / root3, std::sqrt(8.0 / 3));
    check_regular<6, T>(8, 2 / root3);
    check_regular<8, T>(4 * root3, std::sqrt(2.0));
    check_regular<12, T>(3 * std::sqrt(25 + 10 * root5) * dodecahedron_edge * dodecahedron_edge, dodecahedron_edge);
    check_regular<20, T>(5 * root3 * icosahedron_edge * icosahedron_edge, icosahedron_edge);
}

TEST_CASE_TEMPLATE("polyhedra: what has no inside is missed", T, RAIO_NUMBERS) {
    const vec3<T> zero(0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    const T nan = std::numeric_limits<T>::quiet_NaN();
    random_numbers random(21);
    const auto check_missed = [&](const auto& solid) {
        for (int i = 0; i < 100; ++i) {
            const vec3<T> from(random.direction() * 5.0), to(random.direction());
            CHECK(!solid.occluded({from, to - from}, -infinity<T>, infinity<T>));
        }
        CHECK(!solid.occluded({{0, 0, 5}, {0, 0, -1}}, T(0), infinity<T>));
        CHECK(!solid.occluded({{5, 0, 0}, {-1, 0, 0}}, T(0), infinity<T>));
    };
    check_missed(oriented_box(zero, x, y, zero));
    check_missed(oriented_box(zero, x, x, z));
    check_missed(tetrahedron(zero, x, y, x + y));
    check_missed(tetrahedron(zero, x, x, z));
    check_missed(pyramid(std::array{zero, x, y}, x + y));
    check_missed(pyramid(std::array{zero, x, x + x}, z));
    check_missed(prism(std::array{zero, x, y}, x));
    check_missed(prism(std::array{zero, x, y}, zero));
    check_missed(tetrahedron(zero, x, y, z * nan));
    check_missed(tetrahedron(x * nan, x, x, z));
    check_missed(oriented_box(zero, x, y, z * infinity<T>));
    check_missed(regular_solid<8>(zero, T(-1)));
    check_missed(regular_solid<12>(zero, T(0)));
    check_missed(regular_solid<20>(zero, nan));
}

}  // namespace raio::test
