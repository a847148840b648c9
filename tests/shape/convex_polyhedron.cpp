#include <raio/shape/convex_polyhedron.hpp>

#include "support/cases.hpp"
#include "support/polyhedra.hpp"
#include "support/sampling.hpp"

namespace raio::test {

template <class T>
std::vector<half_space<T>> cube_and(std::vector<half_space<T>> more) {
    for (const T sign : {T(1), T(-1)}) {
        more.push_back({{sign, 0, 0}, -1});
        more.push_back({{0, sign, 0}, -1});
        more.push_back({{0, 0, sign}, -1});
    }
    return more;
}

TEST_CASE_TEMPLATE("convex_polyhedron: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    using solid = convex_polyhedron<T>;
    const solid cube{cube_and<T>({})};
    const ray<T> ahead{{0, 0, 5}, {0, 0, -1}};
    check_cases<solid>({
        {"a face", cube, ahead, enters(4)},
        {"behind the ray", cube, {{0, 0, 5}, {0, 0, 1}}, misses},
        {"from inside", cube, {{0.5, 0, 0}, {1, 0, 0}}, leaves(0.5)},
        {"beside", cube, {{1.5, 0, 5}, {0, 0, -1}}, misses},
        {"all but in a plane in which it starts, and beyond another",
         {{{{0, 0, -1}, -1}, {{0, -1, 0}, -1}, {{0, 1, 0}, -3}, {{1, 0, 0}, -2}}},
         {{4, 3, 1}, {-0x1p-28, -0x1p-126, -2}},
         misses},
        {"all but in two planes in which it starts, and beyond a third",
         {{{{0, 0, -1}, -3}, {{0, 0, 1}, 0}, {{0, -1, 0}, -1}, {{-1, 0, 0}, -3}}},
         {{-3, -1, 4}, {0x1p-105, -0x1p-122, 1}},
         misses},
        {"past an edge", cube, {{3, 0, 0}, {-1, 1, 0}}, misses},
        {"through two corners", cube, {{2, 2, 2}, {-1, -1, -1}}, enters(1)},
        {"touches an edge", cube, {{2, 0, 0}, {-1, 1, 0}}, enters(1)},
        {"touches a corner", cube, {{2, 0, 1}, {-1, 1, 0}}, enters(1)},
        {"touches an edge where t is a third", cube, {{-2, 2, 0.5}, {3, 3, 0}}, misses},
        {"in a face", cube, {{1, 0, 5}, {0, 0, -1}}, enters(4)},
        {"one number beyond the face", cube, {{1 + eps, 0, 5}, {0, 0, -1}}, misses},
        {"from a face inwards", cube, {{1, 0, 0}, {-1, 0, 0}}, enters(0)},
        {"from a face outwards", cube, {{1, 0, 0}, {1, 0, 0}}, leaves(0)},
        {"a redundant plane", {cube_and<T>({{{0, 0, 1}, -7}})}, ahead, enters(4)},
        {"a plane twice, with another length", {cube_and<T>({{{0, 0, 2}, -2}})}, ahead, enters(4)},
        {"a plane through a corner only", {cube_and<T>({{{1, 1, 1}, -3}})}, {{2, 2, 2}, {-1, -1, -1}}, enters(1)},
        {"a corner cut off", {cube_and<T>({{{1, 1, 1}, -1.5}})}, {{2, 2, 2}, {-1, -1, -1}}, enters(1.5)},
        {"contradictory planes", {cube_and<T>({{{0, 0, 1}, 2}})}, ahead, misses},
        {"contradictory planes, across them", {cube_and<T>({{{0, 0, 1}, 2}})}, {{5, 0, 0}, {-1, 0, 0}}, misses},
        {"only one plane", {{{{0, 1, 0}, 0}}}, {{0, 2, 0}, {0, -1, 0}}, enters(2)},
        {"only one plane, from within", {{{{0, 1, 0}, 0}}}, {{0, -2, 0}, {0, 1, 0}}, leaves(2)},
        {"only one plane, parallel within", {{{{0, 1, 0}, 0}}}, {{0, -2, 0}, {1, 0, 0}}, misses},
        {"only one plane, parallel in it", {{{{0, 1, 0}, 0}}}, {{0, 0, 0}, {1, 0, 0}}, misses},
        {"a slab, along it", {{{{0, 1, 0}, -1}, {{0, -1, 0}, -1}}}, {{0, 0, 0}, {1, 0, 0}}, misses},
        {"a slab, across it", {{{{0, 1, 0}, -1}, {{0, -1, 0}, -1}}}, {{0, 5, 0}, {0, -1, 0}}, enters(4)},
        {"no plane at all", {{}}, ahead, misses},
        {"normal zero", {cube_and<T>({{{0, 0, 0}, -1}})}, ahead, enters(4)},
        {"normal zero, nothing inside", {cube_and<T>({{{0, 0, 0}, 1}})}, ahead, misses},
        {"direction zero, from inside", cube, {{0, 0, 0}, {0, 0, 0}}, misses},
        {"first crossing before the window", cube, ahead, leaves(6), 4.5},
        {"both crossings behind the window", cube, ahead, misses, 0, 3.5},
        {"window between the crossings", cube, ahead, misses, 4.5, 5.5},
        {"window that is not a number", cube, ahead, misses, nan<T>},
    });
}

TEST_CASE_TEMPLATE("convex_polyhedron: a line that stays inside is all inside (it was nowhere)", T, RAIO_NUMBERS) {
    using planes = std::vector<half_space<T>>;
    const T inf = infinity<T>, most = std::numeric_limits<T>::max();
    const interval<T> all{-inf, inf};
    const planes below{{{0, 0, 3}, 0}}, tube{{{1, 0, 0}, -1}, {{-1, 0, 0}, -1}, {{0, 1, 0}, -1}, {{0, -1, 0}, -1}};
    const auto spans = [](const planes& of, const ray<T>& ray) { return convex_polyhedron<T>{of}.spans(ray); };
    CHECK(spans(below, {{0, 0, -1}, {1, 0, 0}}) == all);
    CHECK(spans(below, {{0, 0, 0}, {1, 2, 0}}) == all);  // in its face
    CHECK(spans(below, {{0, 0, 1}, {1, 0, 0}}).empty());
    CHECK(spans(below, {{0, 0, -2}, {0, 0, 1}}) == interval<T>{-inf, 2});
    CHECK(spans(below, {{0, 0, 2}, {0, 0, -1}}) == interval<T>{2, inf});
    CHECK(spans(tube, {{0, T(0.5), 7}, {0, 0, -2}}) == all);
    CHECK(spans(tube, {{1, 1, 7}, {0, 0, 1}}) == all);  // along an edge
    CHECK(spans(tube, {{0, 2, 7}, {0, 0, -2}}).empty());
    CHECK(spans(tube, {{-3, 0, 0}, {1, 0, 1}}) == interval<T>{2, 4});
    CHECK(spans({}, {{1, 2, 3}, {0, 0, 1}}) == all);
    CHECK(spans({{{0, 0, 0}, -1}}, {{1, 2, 3}, {0, 0, 1}}) == all);
    CHECK(spans({{{0, 0, 0}, 1}}, {{1, 2, 3}, {0, 0, 1}}).empty());
    CHECK(spans({{{0, T(1e-30), 0}, T(-0.5)}}, {{0, 0, 0}, {0, T(1e-30), 0}}).contains(0));  // ends out of range
    // What is no line, or no plane, is nowhere.
    for (const ray<T>& bad :
         {ray<T>{{0, 0, -1}, {0, 0, 0}}, ray<T>{{0, 0, -1}, {inf, 0, 0}}, ray<T>{{0, 0, -1}, {nan<T>, 0, 0}},
          ray<T>{{nan<T>, 0, -1}, {1, 0, 0}}, ray<T>{{inf, 0, -1}, {1, 0, 0}}}) {
        CHECK(spans(below, bad).empty());
        CHECK(spans({}, bad).empty());
    }
    CHECK(spans({{{0, 0, 1}, nan<T>}}, {{0, 0, -1}, {1, 0, 0}}).empty());
    CHECK(spans({{{0, nan<T>, 1}, 0}}, {{0, 0, -1}, {1, 0, 0}}).empty());
    CHECK(spans({{{most, 0, 0}, -1}}, {{-1, 0, 0}, {0, most, 0}}) == all);

    // Nothing is hit: neither end is there.
    hit_record<T> rec{};
    CHECK_FALSE(convex_polyhedron<T>{below}.hit({{0, 0, -1}, {1, 0, 0}}, -inf, inf, rec));
    CHECK_FALSE(convex_polyhedron<T>{}.occluded({{0, 0, -1}, {1, 0, 0}}, -inf, inf));
}

TEST_CASE_TEMPLATE("convex_polyhedron: the area of what is inside, however many planes say so", T, RAIO_NUMBERS) {
    const auto area = [](std::vector<half_space<T>> planes) { return convex_polyhedron<T>{std::move(planes)}.area(); };
    CHECK(area(cube_and<T>({})) == T(24));
    CHECK(area(cube_and<T>({{{0, 0, 2}, -2}})) == T(24));             // a plane twice
    CHECK(area(cube_and<T>({{{1, 1, 0}, -2}})) == T(24));             // through an edge only
    CHECK(area(cube_and<T>({{{0, 0, 1}, -7}})) == T(24));             // beyond a face
    CHECK(area(cube_and<T>({{{0, 0, 0}, -1}})) == T(24));             // no plane at all
    CHECK(area(cube_and<T>({{{0, 0, 1}, 0}})) == T(16));              // through the middle
    CHECK(area({{{0, 0, 1}, 0}}) == infinity<T>);                     // a half-space
    CHECK(area({{{0, 0, 1}, 0}, {{0, 0, 1}, -1}}) == infinity<T>);    // and a plane beyond
    CHECK(area({{{0, 1, 0}, -1}, {{0, -1, 0}, -1}}) == infinity<T>);  // a slab
    CHECK(area({{{0, 1, 0}, -1}, {{0, -3, 0}, 6}}) == T(0));          // two planes, and nothing between
    CHECK(area({{{1, 0, 0}, 0}, {{0, 1, 0}, 0}}) == infinity<T>);     // a wedge
    CHECK(
        area({{{1, 0, 0}, -1}, {{-1, 0, 0}, -1}, {{0, 0, 1}, 0}, {{0, 0, -1}, 0}, {{0, 1, 0}, -1}, {{0, -1, 0}, -1}}) ==
        T(8));                                                                        // a square, both sides
    CHECK(area({{{-1, 0, 0}, 0}, {{0, -1, 0}, 0}, {{0, 0, -1}, 0}}) == infinity<T>);  // a corner without end
    for (const T x : {T(0.1), T(0.3), T(0.7), T(0.9)}) {  // the foot of a plane is rounded, to its outside as well
        CHECK(area({{{x, T(0.2), T(-0.3)}, -x}}) == infinity<T>);
    }
    CHECK(area({}) == T(0));
    // Planes through an edge that no number says: it is one edge, on any side of the origin.
    random_numbers random(14);
    for (int i = 0; i < 200; ++i) {
        const auto whole = [&] { return T(random.integer(1, 9)); };
        const T low = T(random.integer(-9, 9)), high = T(random.integer(-9, 9));
        const T side = T(random.one_in(2) ? 1 : -1), other = T(random.one_in(2) ? 1 : -1);
        const vec3<T> first(side * whole(), other * whole(), 0), second(side * whole(), other * whole(), 0);
        if (norm1(cross(first, second)) == T(0)) continue;
        const vec3<T> both = first + second;
        std::vector<half_space<T>> prism{{{0, 0, 1}, -1}, {{0, 0, -1}, -1}, {-both, -99}, {first, low}, {second, high}};
        const T all = area(prism);
        prism.push_back({both, low + high});
        CHECK(area(prism) == doctest::Approx(all));
    }
}

TEST_CASE_TEMPLATE("convex_polyhedron: a single point is hit within its bounds", T, RAIO_NUMBERS) {
    const convex_polyhedron<T> origin{{{{T(-0x1.4569e8p-1), T(-0x1.362bccp-2), T(-0x1.a2af2cp+0)}, 0},
                                       {{0, 0, -1}, 0},
                                       {{0, -1, 0}, 0},
                                       {{0, 1, 0}, 0},
                                       {{-1, 0, 0}, 0},
                                       {{2, 2, 2}, 0}}};
    hit_record<T> rec{};
    REQUIRE(origin.hit({{-4, -4, -4}, {1, 1, 1}}, T(0), infinity<T>, rec));
    CHECK(origin.bounds().contains(rec.point));
}

/// On its way along an edge the ray crosses the planes there anywhere, for all that two doubles know, but by then it
/// has left another plane, and not yet entered the last.
TEST_CASE("convex_polyhedron: past the tip of a needle, along the edge on the other side of it") {
    const convex_polyhedron<double> needle{
        {{{-0x1.f6970304bb179p-7, 0x1.fe9c251bf48bbp-5, -0x1.fef1b132419b3p-1}, -0x1.e6e24aec953edp-4},
         {{0x1.7c94956d35181p-1, -0x1.43e5f18df6b7ep-4, -0x1.5417d73b76411p-1}, -0x1.4p-56},
         {{0x1.52fcc468d6b54p-4, -0x1.7d5c5cf5f18bfp-1, 0x1.52fcc468d6b54p-1}, -0x1p-57},
         {{0x1.d03ef30d1a06ap-7, -0x1.052368b75ea3cp-3, 0x1.fbc4d9d654774p-1}, 0x1.c1bcfb74b1367p-4},
         {{0, -0x1.4e16d3ea27b25p-5, 0x1.ff92f47e8cc91p-1}, -0x1.6p-57}}};
    hit_record<double> rec{};
    CHECK_FALSE(needle.hit({vec3<double>(-0.125), vec3<double>(-0.125)}, 0, infinity<double>, rec));
}

TEST_CASE_TEMPLATE("convex_polyhedron: samples are spread evenly over the area", T, RAIO_NUMBERS) {
    // The corner of a cube, cut off.
    const convex_polyhedron<T> corner{{{{-1, 0, 0}, 0}, {{0, -1, 0}, 0}, {{0, 0, -1}, 0}, {{1, 1, 1}, -1}}};
    const T slanted = std::sqrt(T(3)) / 2, all = T(1.5) + slanted;
    CHECK(corner.area() == doctest::Approx(all));
    check_sampling(corner, [&](const hit_record<T>& rec) {
        const vec3<T>& p = rec.point;
        const auto in_triangle = [&](T before, T area, T a, T b) {
            return vec2<T>((before + area * (a + b) * (a + b)) / all, b / (a + b));
        };
        if (rec.normal.x == T(-1)) return in_triangle(0, T(0.5), p.y, p.z);
        if (rec.normal.y == T(-1)) return in_triangle(T(0.5), T(0.5), p.x, p.z);
        if (rec.normal.z == T(-1)) return in_triangle(1, T(0.5), p.x, p.y);
        return in_triangle(T(1.5), slanted, p.x, p.y);
    });
}

TEST_CASE_TEMPLATE("convex_polyhedron: a face across an axis has one coordinate, and no rounding moves points off", T,
                   RAIO_NUMBERS) {
    check_face_across_x(convex_polyhedron<T>{
        {{{3, 0, 0}, 0}, {{-1, 0, 0}, -1}, {{0, 1, 0}, -1}, {{0, -1, 0}, -1}, {{0, 0, 1}, -1}, {{0, 0, -1}, -1}}});
}

TEST_CASE_TEMPLATE("convex_polyhedron: properties of every shape", T, RAIO_NUMBERS) {
    check_properties<convex_polyhedron<T>>();
}

TEST_CASE_TEMPLATE("convex_polyhedron: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<convex_polyhedron<T>>();
    check_accuracy<convex_polyhedron<T>>(test_rays);
    check_bounds_of_errors<convex_polyhedron<T>>(test_rays / 20);
}

}  // namespace raio::test
