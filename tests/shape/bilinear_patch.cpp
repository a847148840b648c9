#include <raio/shape/bilinear_patch.hpp>

#include "support/bounds.hpp"
#include "support/cases.hpp"
#include "support/packs.hpp"

namespace raio::test {

template <class T>
inline constexpr bool is_convex<bilinear_patch<T>> = false;

template <class T>
struct subject<bilinear_patch<T>> {
    static auto fields(auto& s) { return std::tie(s.p00, s.p10, s.p01, s.p11); }

    /// One in eight is nearly flat, one in eight nearly a parallelogram, and one in eight has an edge without length.
    static bilinear_patch<T> random(random_numbers& random, double size, const vec3<double>& place) {
        const vec3<double> a = place + random.direction() * size, b = place + random.direction() * size;
        vec3<double> c = place + random.direction() * size, d = place + random.direction() * size;
        switch (random.integer(0, 7)) {
            case 0:
                d = a + (b - a) * random.uniform(0.25, 2) + (c - a) * random.uniform(0.25, 2);
                break;
            case 1:
                d = b + c - a + random.direction() * (size * random.log_uniform(1e-9, 1e-3));
                break;
            case 2:
                (random.one_in(2) ? c : d) = random.one_in(2) ? a : b;
                break;
            default:
                break;
        }
        return {vec3<T>(a), vec3<T>(b), vec3<T>(c), vec3<T>(d)};
    }
    template <class U>
    static vec3<U> at(const auto& s, const U& u, const U& v) {
        const vec3<U> from = vec3<U>(s.p00) * (1 - u) + vec3<U>(s.p10) * u,
                      to = vec3<U>(s.p01) * (1 - u) + vec3<U>(s.p11) * u;
        return from * (1 - v) + to * v;
    }
    static vec3<double> inner_point(const bilinear_patch<T>& s, random_numbers& random) {
        const double u = random.uniform(0.01, 0.99);
        return at(s, u, random.uniform(0.01, 0.99));
    }
    /// On an edge or a corner, or where the ray is tangent.
    static vec3<double> special_point(const bilinear_patch<T>& s, const vec3<double>& from, random_numbers& random) {
        const double along = random.one_in(2) ? 0 : random.uniform(), side = random.integer(0, 1);
        if (random.one_in(2)) return random.one_in(2) ? at(s, along, side) : at(s, side, along);
        // The plane of the lines through a point contains a ray from there to anywhere on the line of constant u.
        const double u = random.uniform();
        const vec3<double> view = at(s, u, 0.0) - from, line = at(s, u, 1.0) - at(s, u, 0.0);
        const vec3<double> low = at(s, 1.0, 0.0) - at(s, 0.0, 0.0), high = at(s, 1.0, 1.0) - at(s, 0.0, 1.0);
        const double at_low = dot(view, cross(low, line)), at_high = dot(view, cross(high, line));
        return at(s, u, at_low == at_high ? 0.5 : at_low / (at_low - at_high));
    }
    /// Barycentric, in the tetrahedron of the corners: (1 - u) (1 - v), u (1 - v), (1 - u) v and u v times its volume
    /// for a point of the surface.
    static std::array<oracle, 4> weights(const bilinear_patch<oracle>& s, const vec3<oracle>& q) {
        const vec3<oracle> a = s.p00 - q, b = s.p10 - q, c = s.p01 - q, d = s.p11 - q;
        return {dot(b, cross(c, d)), -dot(a, cross(c, d)), dot(a, cross(b, d)), -dot(a, cross(b, c))};
    }
    /// Of a flat patch, the longest of what the corners say.
    static vec3<oracle> plane_normal(const bilinear_patch<oracle>& s) {
        const vec3<oracle> a = s.p10 - s.p00, b = s.p01 - s.p00, c = s.p11 - s.p00;
        vec3<oracle> normal = cross(a, b);
        for (const vec3<oracle>& other : {cross(b, c), cross(c, a)}) {
            if (length(other) > length(normal)) normal = other;
        }
        return normal;
    }
    /// Does the line lie in the surface, or in the plane of one that is flat? Three of its points do then.
    static bool lies_in_side(const bilinear_patch<oracle>& s, const ray<oracle>& r) {
        for (int t = 0; t < 3; ++t) {
            const vec3<oracle> p = r.origin + r.direction * oracle(t);
            const auto [w00, w10, w01, w11] = weights(s, p);
            const bool is_flat = w00 + w10 + w01 + w11 == 0;
            if (is_flat ? dot(plane_normal(s), vec3<oracle>(p - s.p00)) != 0 : w00 * w11 != w10 * w01) return false;
        }
        return true;
    }
    /// The implicit form over its slope, or how far a point of the surface is beyond an edge. (u and v say nothing
    /// about others: of a patch that is nearly flat they may be anything.)
    static oracle distance(const bilinear_patch<oracle>& s, const vec3<oracle>& p) {
        const auto form = [&](const vec3<oracle>& q) {
            const auto [w00, w10, w01, w11] = weights(s, q);
            return oracle(w00 * w11 - w10 * w01);
        };
        const oracle size = length(vec3<oracle>(s.p10 - s.p00)) + length(vec3<oracle>(s.p11 - s.p01)) +
                            length(vec3<oracle>(s.p01 - s.p00));
        const oracle step = size * oracle(1e-20), here = form(p);
        const vec3<oracle> slope((form(p + vec3<oracle>(step, 0, 0)) - here) / step,
                                 (form(p + vec3<oracle>(0, step, 0)) - here) / step,
                                 (form(p + vec3<oracle>(0, 0, step)) - here) / step);
        const auto [w00, w10, w01, w11] = weights(s, p);
        const oracle sum = w00 + w10 + w01 + w11;
        if (abs(sum) < size * size * size * oracle(1e-30)) {
            return abs(dot(normalize(plane_normal(s)), vec3<oracle>(p - s.p00)));
        }
        const oracle u = (w10 + w11) / sum, v = (w01 + w11) / sum;
        const oracle beyond = max(max(oracle(-u), oracle(u - 1)), max(oracle(-v), oracle(v - 1)));
        const oracle off = abs(here) / length(slope);
        return off < size * oracle(1e-30) ? max(off, oracle(beyond * size)) : off;
    }
    static bilinear_patch<oracle> grown(const bilinear_patch<oracle>& s) {
        const oracle low(-1e-40), high(1 + oracle(1e-40));
        if (s.p00 != s.p10 && s.p10 != s.p11 && s.p11 != s.p01 && s.p01 != s.p00) {
            return {at(s, low, low), at(s, high, low), at(s, low, high), at(s, high, high)};
        }
        const vec3<oracle> center = at(s, oracle(0.5), oracle(0.5));  // a triangle stays one
        const auto moved = [&](const vec3<oracle>& p) { return p + (p - center) * oracle(1e-40); };
        return {moved(s.p00), moved(s.p10), moved(s.p01), moved(s.p11)};
    }
};

TEST_CASE_TEMPLATE("bilinear_patch: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    // The saddle z = x y; a flat square; a flat quadrilateral; one with the edge u = 0 in a corner; a folded one.
    const bilinear_patch<T> saddle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}};
    const bilinear_patch<T> square{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    const bilinear_patch<T> kite{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {4, 4, 0}};
    const bilinear_patch<T> fan{{0, 0, 0}, {2, 0, 0}, {0, 0, 0}, {0, 2, 1}},
        bow{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
    const bilinear_patch<T> folded{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}};
    const bilinear_patch<T> half{{0, 0, 1}, {2, 0, 1}, {0, 2, 1}, {0, 2, 1}};
    const auto down = [](T x, T y) { return ray<T>{{x, y, 5}, {0, 0, -1}}; };
    check_cases<bilinear_patch<T>>({
        {"saddle, from the front", saddle, down(0.5, 0.5), enters(4.75)},
        {"saddle, from the back", saddle, {{0.5, 0.5, -5}, {0, 0, 1}}, leaves(5.25)},
        {"saddle, behind the ray", saddle, {{0.5, 0.5, 5}, {0, 0, 1}}, misses},
        {"saddle, beside it", saddle, down(1.5, 0.5), misses},
        {"saddle, beside it, the other way", saddle, down(0.5, -0.5), misses},
        {"saddle, from one of its points", saddle, {{0.5, 0.5, 0.25}, {0, 0, -1}}, enters(0)},
        {"saddle, from one of its points, upwards", saddle, {{0.5, 0.5, 0.25}, {0, 0, 1}}, leaves(0)},
        {"saddle, corner 00", saddle, down(0, 0), enters(5)},
        {"saddle, corner 10", saddle, down(1, 0), enters(5)},
        {"saddle, corner 01", saddle, down(0, 1), enters(5)},
        {"saddle, corner 11", saddle, down(1, 1), enters(4)},
        {"saddle, edge u = 0", saddle, down(0, 0.5), enters(5)},
        {"saddle, edge u = 1", saddle, down(1, 0.5), enters(4.5)},
        {"saddle, edge v = 0", saddle, down(0.75, 0), enters(5)},
        {"saddle, edge v = 1", saddle, down(0.75, 1), enters(4.25)},
        {"saddle, along an edge, which a larger one crosses", saddle, {{0, 0, 0}, {0, 1, 0}}, misses},
        {"saddle, one number beyond u = 1", saddle, down(1 + eps, 0.5), misses},
        {"saddle, one number within u = 1", saddle, down(1 - eps / 2, 0.5), enters(4.5 + eps / 4)},
        {"saddle, by a hair beyond v = 0", saddle, down(0.5, T(-0x1p-80)), misses},
        {"saddle, along the line u = 1/2", saddle, {{0.5, -2, -1}, {0, 2, 1}}, misses},
        {"saddle, along the line v = 1/4", saddle, {{-4, 0.25, -1}, {4, 0, 1}}, misses},
        {"saddle, along the edge u = 0", saddle, {{0, -2, 0}, {0, 1, 0}}, misses},
        {"saddle, along the edge v = 1", saddle, {{-2, 1, -2}, {1, 0, 1}}, misses},
        {"saddle, along a line, from inside", saddle, {{0.5, 0.5, 0.25}, {0, 2, 1}}, misses},
        {"saddle, parallel to the line u = 1/2", saddle, {{0.5, -2, 0}, {0, 2, 1}}, misses},
        {"saddle, twice: the first time", saddle, {{1.25, -0.25, 0.1875}, {-1, 1, 0}}, enters(0.5)},
        {"saddle, twice: the second time", saddle, {{1.25, -0.25, 0.1875}, {-1, 1, 0}}, leaves(1), 0.75},
        {"saddle, twice: after it", saddle, {{1.25, -0.25, 0.1875}, {-1, 1, 0}}, misses, 1.25},
        {"saddle, tangent to the ridge", saddle, {{1.5, -0.5, 0.25}, {-1, 1, 0}}, enters(1)},
        {"saddle, tangent to the ridge, the other way", saddle, {{-0.5, 1.5, 0.25}, {1, -1, 0}}, enters(1)},
        {"saddle, tangent to the valley, from below", saddle, {{1, 1, 0.25}, {-1, -1, -0.5}}, misses},
        {"saddle, one number above the ridge", saddle, {{1.5, -0.5, T(0.25) + eps / 4}, {-1, 1, 0}}, misses},
        {"square", square, down(0.5, 0.75), enters(5)},
        {"square, on a corner", square, down(1, 1), enters(5)},
        {"square, in its plane", square, {{-1, 0.5, 0}, {1, 0, 0}}, misses},
        {"square, in its plane, from inside", square, {{0.5, 0.5, 0}, {1, 1, 0}}, misses},
        {"square, parallel to its plane", square, {{-1, 0.5, 1}, {1, 0, 0}}, misses},
        {"kite", kite, down(2, 2), enters(5)},
        {"kite, outside of the square that it is not", kite, down(3, 3.25), enters(5)},
        {"kite, beside it", kite, down(3, 0.5), misses},
        {"kite, on the far corner", kite, down(4, 4), enters(5)},
        {"fan: an edge in one corner", fan, down(1, 0.5), enters(4.75)},
        {"fan: through that corner", fan, down(0, 0), enters(5)},
        {"fan: beside that corner", fan, down(-0.5, 0), misses},
        {"fan: beside that corner, along the collapsed edge", fan, down(-0.5, 0.25), misses},
        {"bow, where it is steep", bow, {{0.5, 0.5, -5}, {0, 0, 1}}, leaves(5.5)},
        {"folded: two layers, the lesser u first", folded, down(1.125, 1.125), enters(5)},
        {"folded: the tip is not reached", folded, down(2, 2), misses},
        {"folded about its diagonal: on the fold, the lesser u first",
         {{0, 3, -3}, {3, -2, 1}, {3, -2, 1}, {-3, -1, 3}},
         {{0, -1, 4}, {0, 0, -1}},
         enters(23.0 / 9)},
        {"folded about its edge u = 0",
         {{1, 0, -3}, {3, 3, 2}, {3, 1, 2}, {3, 0, 2}},
         {{-3, -2, 3}, {2, 1, -1}},
         enters(8.0 / 3)},
        {"folded about its diagonal: in its plane, along an edge",
         {{2, 1, -2}, {-3, 1, -2}, {-3, 1, -2}, {-3, 2, -1}},
         {{-3, 1, -2}, {1, 0, 0}},
         misses},
        {"a triangle, from one number above it", half, {{0.5, 0.5, 1 + eps}, {0, 0, -1}}, enters(eps)},
        {"as thin as a number, its long edges against each other",
         {{0, 0, 0}, {T(0x1p-700), 0, 0}, {0, -1, -1}, {0, 1, -1}},
         {{1, 1, -0.5}, {-4, -3, 0}},
         leaves(0.25)},
        {"a sliver, by its corner without an edge (the normal was off by a hundred roundings)",
         {{0, 0, 0}, {T(0.3), T(0.7), T(0.9)}, {0, 0, 0}, {T(-0.098), T(-0.23), T(-0.3)}},
         down(T(0.202 * 0x1p-60), T(0.47 * 0x1p-60)),
         leaves(5)},
        {"all in one point", {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{1, 1, 5}, {0, 0, -1}}, misses},
        {"all in one line", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 0, 0}}, down(0.5, 0), misses},
        {"all in one slanted line", {{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {-1, -2, -3}}, {{1, 2, 5}, {0, 0, -1}}, misses},
        {"direction zero", saddle, {{0.5, 0.5, 0.25}, {0, 0, -0.0}}, misses},
        {"direction of length 1e-20", saddle, {{0.5, 0.5, 5.25}, {0, 0, -0x1p-66}}, enters(5 * 0x1p66)},
        {"direction of length 1e20", saddle, {{0.5, 0.5, 5.25}, {0, 0, -0x1p66}}, enters(5 * 0x1p-66)},
        {"far away", saddle, {{0.5, 0.5, T(1e6)}, {0, 0, -1}}, enters(1e6 - 0.25)},
        {"window ends at the crossing", saddle, down(0.5, 0.5), enters(4.75), 0, 4.75},
        {"window that is not a number", saddle, down(0.5, 0.5), misses, nan<T>},
    });
}

TEST_CASE_TEMPLATE("bilinear_patch: on the fold of a planar one the side with the lesser u comes first", T,
                   RAIO_NUMBERS) {
    random_numbers random(15);
    const auto whole = [&] { return T(random.integer(-9, 9)); };
    const auto lattice_point = [&] { return vec3<T>(whole(), whole(), whole()); };
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        const vec3<T> from = lattice_point(), both = lattice_point(), to = lattice_point(), origin = lattice_point();
        const bool early = random.one_in(2);  // through u = v = 1/3, or 2/3, at t = 1/9
        const vec3<T> on_fold = (early ? from : to) * T(4) + both * T(4) + (early ? to : from);
        const ray<T> ray{origin, on_fold - origin * T(9)};
        const T leaving = dot(ray.direction, cross(to - from, both - from));
        if (leaving == T(0)) continue;
        hit_record<T> rec{};
        REQUIRE(bilinear_patch<T>{from, both, both, to}.hit(ray, T(0), infinity<T>, rec));
        CHECK(rec.t == T(1) / T(9));
        CHECK(rec.front_face == (leaving < T(0)));
        ++hits;
    }
    CHECK(hits > 900);
}

TEST_CASE_TEMPLATE("bilinear_patch: beside it, and all but in the plane of one of its lines (hit, with a u of 1.4)", T,
                   RAIO_NUMBERS) {
    const bilinear_patch<T> some{{0, 2, -1}, {-2, 2, 1}, {0, -3, -2}, {-3, 2, 1}};
    for (int power = -140; power < -20; ++power) {
        CAPTURE(power);
        check_cases<bilinear_patch<T>>({{"", some, {{0, -2, 1}, {0, -1, -std::ldexp(T(1), power)}}, misses}});
    }
}

TEST_CASE_TEMPLATE("bilinear_patch: all but along an edge, from before it (was hit where the ray starts)", T,
                   RAIO_NUMBERS) {
    const bilinear_patch<T> some{{-2, -2, -2}, {-3, 0, 2}, {3, -2, -2}, {-1, 2, -1}};
    for (int power = -140; power < -20; ++power) {
        hit_record<T> rec{};
        const ray<T> ray{{-3, -2, -2}, {T(0x1p-22), 0, std::ldexp(T(1), power)}};
        CHECK((!some.hit(ray, T(0), infinity<T>, rec) || rec.t >= T(0x1p22)));
    }
}

TEST_CASE_TEMPLATE("bilinear_patch: properties of every shape", T, RAIO_NUMBERS) {
    check_properties<bilinear_patch<T>>();
}

TEST_CASE_TEMPLATE("bilinear_patch: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<bilinear_patch<T>>();
    check_accuracy<bilinear_patch<T>>(test_rays);
    check_bounds_of_errors<bilinear_patch<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("bilinear_patch: uv", T, RAIO_NUMBERS) {
    const auto uv = [](const bilinear_patch<T>& patch, T x, T y) {
        hit_record<T> rec{};
        REQUIRE(patch.hit({{x, y, 5}, {0, 0, -1}}, T(0), infinity<T>, rec));
        return rec.uv;
    };
    const bilinear_patch<T> saddle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}};
    CHECK(uv(saddle, 0.25, 0.75) == vec2<T>(0.25, 0.75));
    CHECK(uv(saddle, 1, 0) == vec2<T>(1, 0));
    // The unit square's corners, and one of them twice: any edge may be the one without length.
    const vec3<T> a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0);
    CHECK(uv({a, a, d, c}, 0.25, 0.5) == vec2<T>(0.5, 0.5));
    CHECK(uv({a, b, d, b}, 0.5, 0.25) == vec2<T>(0.5, 0.5));
    CHECK(uv({a, b, c, c}, 0.75, 0.5) == vec2<T>(0.5, 0.5));
    CHECK(uv({a, b, a, c}, 0.5, 0.25) == vec2<T>(0.5, 0.5));
}

TEST_CASE_TEMPLATE("bilinear_patch: in a corner without an edge a flat patch has the plane's normal, on both sides", T,
                   RAIO_NUMBERS) {
    const vec3<T> a(0, 0, 0), c(1, 1, 0), d(0, 1, 0);
    for (const bilinear_patch<T>& patch : {bilinear_patch<T>{a, a, d, c}, bilinear_patch<T>{a, a, c, d}}) {
        for (const T side : {T(1), T(-1)}) {
            hit_record<T> rec{};
            REQUIRE(patch.hit({{-3, -2, 4 * side}, {3, 2, -4 * side}}, T(0), infinity<T>, rec));
            CHECK(rec.normal == vec3<T>(0, 0, side));
        }
    }
}

TEST_CASE("bilinear_patch: so slender that doubles take it for a line, it is hit with a normal against the ray") {
    const float thin = 0x1p-133f, least = 0x1p-127f;
    const bilinear_patch<float> patch{{thin, 5, 0}, {0, 0, 0}, {0, least, 0}, {0, 0, 0}};
    hit_record<float> rec{};
    REQUIRE(patch.hit({{thin, least, 1}, {-thin, -least, -1}}, 0.0f, infinity<float>, rec));
    CHECK(unsound_fields(rec) == "");
}

/// A cube with its corners moved about: six patches that share edges and corners.
template <class T>
std::vector<bilinear_patch<T>> crooked_cube(random_numbers& random) {
    std::array<vec3<T>, 8> corners;
    for (unsigned i = 0; i < 8; ++i) {
        const vec3<double> corner(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        corners[i] = vec3<T>(corner + random.direction() * 0.4);
    }
    std::vector<bilinear_patch<T>> faces;
    for (const auto& [p00, p10, p01, p11] : std::initializer_list<std::array<std::size_t, 4>>{
             {0, 2, 1, 3}, {4, 5, 6, 7}, {0, 1, 4, 5}, {2, 6, 3, 7}, {0, 4, 2, 6}, {1, 3, 5, 7}}) {
        faces.push_back({corners[p00], corners[p10], corners[p01], corners[p11]});
    }
    return faces;
}

TEST_CASE("bilinear_patch: a normal that had to be mirrored is unit") {
    const probe<bilinear_patch<double>> p{
        {{-0x1.b757d312ef8aep-18, -0x1.803eb71b1f6d3p-17, 0x1.e09343ccbd448p-17},
         {0x1.dfec746cf6e87p-17, 0x1.a7ccd6153dd3dp-17, 0x1.0425954bb93ep-18},
         {0x1.1c61bbfe6252ap-16, -std::numeric_limits<double>::max(), 0x1.f003310c78499p-20},
         {0x1.380aa3be8812bp-16, 0x1.508fd12c17441p-18, 0x1.7c9d078380a14p-19}},
        {{0x1.7843a73f15f06p-13, -0x1.d03caf733c0bp-14, -0x1.53d5bff1f045ap-11},
         {-0x1.19bc4d1f22cddp-34, 0x1.0578d715a0818p-35, 0x1.e7e16277ddf25p-33}}};
    hit_record<double> rec{};
    REQUIRE(p.hit(rec));
    const vec3<oracle> normal = converted<oracle>(rec.normal);
    CHECK(abs(dot(normal, normal) - 1) <= 4 * oracle(std::numeric_limits<double>::epsilon()));
}

TEST_CASE_TEMPLATE("bilinear_patch: no ray leaves a closed surface unseen", T, RAIO_NUMBERS) {
    random_numbers random(13);
    int leaks = 0;
    for (int i = 0; i < test_rays / 5; ++i) {
        const std::vector faces = crooked_cube<T>(random);
        const auto& aim = faces[static_cast<std::size_t>(random.integer(0, 5))];
        const T along = random.one_in(2) ? T(0) : static_cast<T>(random.uniform());
        const bool edge_u = random.one_in(2);
        const vec3<T> target = aim.p00 + ((edge_u ? aim.p10 : aim.p01) - aim.p00) * along;
        const vec3<T> origin(random.one_in(4) ? vec3<double>(0) : random.direction() * random.uniform(0, 0.2));
        const ray<T> ray{origin, target - origin};
        leaks += std::none_of(faces.begin(), faces.end(),
                              [&](const auto& face) { return face.occluded(ray, T(0), infinity<T>); });
    }
    CHECK(leaks == 0);
}

TEST_CASE_TEMPLATE("bilinear_patch: packs, lane by lane", T, RAIO_NUMBERS) {
    check_lanes_are_plain<bilinear_patch<T>>(400);
}

}  // namespace raio::test
