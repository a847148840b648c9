#include "support/algebraics.hpp"
#include "support/cases.hpp"
#include "support/dual.hpp"

namespace raio::test {

template <class T, std::size_t Degree, bool Closed>
struct subject<algebraic<T, Degree, Closed>> : boxed_subject<algebraic<T, Degree, Closed>> {
    using shape = algebraic<T, Degree, Closed>;

    static auto fields(auto& s) { return std::tie(s.min, s.max, s.terms); }

    /// The powers of one term.
    static std::array<unsigned, 3> powers(random_numbers& random) {
        std::array<unsigned, 3> n{};
        for (int left = random.integer(1, int(Degree)); left > 0; --left)
            ++n[static_cast<std::size_t>(random.integer(0, 2))];
        return n;
    }
    /// Half of them end where the highest powers rule, the others go on beyond the box. Always about the origin.
    static shape random(random_numbers& random, double size, const vec3<double>&) {
        shape s{vec3<T>(0), vec3<T>(0), {}};
        for_each_number(s.min, [&](T& x) { x = static_cast<T>(-size * random.uniform(0.3, 1)); });
        for_each_number(s.max, [&](T& x) { x = static_cast<T>(size * random.uniform(0.3, 1)); });
        const auto add = [&](double coefficient, unsigned x, unsigned y, unsigned z) {
            const double unit = std::pow(size, double(Degree) / 2 - (x + y + z));
            s.terms.push_back({static_cast<T>(coefficient * unit), x, y, z});
        };
        add(-random.log_uniform(0.001, 0.3), 0, 0, 0);
        for (int i = random.integer(2, 6); i > 0; --i) {
            const auto [x, y, z] = powers(random);
            add(random.uniform(-1, 1), x, y, z);
        }
        if (random.one_in(2)) add(4, Degree, 0, 0), add(4, 0, Degree, 0), add(4, 0, 0, Degree);
        const bool reaches_corner = s.template value<double>(to_double(s.max)) < 0;
        return !Closed && reaches_corner ? subject::random(random, size, vec3<double>(0)) : s;
    }
    static shape lattice(random_numbers& random) {
        shape s{vec3<T>(0), vec3<T>(0), {}};
        for_each_number(s.min, [&](T& x) { x = T(random.integer(-3, 0)); });
        for_each_number(s.max, [&](T& x) { x = T(random.integer(0, 3)); });
        for (int i = random.integer(1, 5); i > 0; --i) {
            const auto [x, y, z] = powers(random);
            s.terms.push_back({T(random.integer(-2, 2)), x, y, z});
        }
        if (random.one_in(2)) {
            s.terms.push_back({T(random.one_in(4) ? 1 : -1), 0, 0, 0});
        } else {  // a cone's tip
            for (const unsigned axis : {0u, 1u, 2u}) {
                s.terms.push_back(
                    {T(random.one_in(2) ? -1 : 1), axis == 0 ? 2u : 0, axis == 1 ? 2u : 0, axis == 2 ? 2u : 0});
            }
        }
        return s;
    }
};

TEST_CASE_TEMPLATE("algebraic: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    using shape = algebraic<T, 8>;
    const auto in_box = [](std::vector<algebraic_term<T>> terms) { return shape{{-3, -3, -3}, {3, 3, 3}, terms}; };
    const shape ball = in_box({{1, 2, 0, 0}, {1, 0, 2, 0}, {1, 0, 0, 2}, {-4, 0, 0, 0}});
    const shape slabs = in_box({{1, 4, 0, 0}, {-5, 2, 0, 0}, {4, 0, 0, 0}});  // (x^2 - 1) (x^2 - 4)
    const shape outside_slabs = in_box({{-1, 4, 0, 0}, {5, 2, 0, 0}, {-4, 0, 0, 0}});
    const shape die = in_box({{1, 8, 0, 0}, {1, 0, 8, 0}, {1, 0, 0, 8}, {-1, 0, 0, 0}});
    const shape cone = in_box({{1, 2, 0, 0}, {1, 0, 2, 0}, {-1, 0, 0, 2}});
    const shape valley = in_box({{1, 4, 0, 0}, {-1, 0, 0, 1}});  // z >= x^4
    const shape planes = in_box({{1, 1, 1, 0}});                 // x y <= 0
    const shape node = in_box({{1, 0, 2, 0}, {-1, 2, 0, 0}, {-1, 3, 0, 0}});
    const shape all = in_box({{-1, 0, 0, 0}}), none = in_box({{1, 0, 0, 0}});
    const ray<T> ahead{{0, 0, 5}, {0, 0, -1}}, along{{-5, 0, 0}, {1, 0, 0}};
    const auto boxed = [](const shape& s, const vec3<T>& min, const vec3<T>& max) { return shape{min, max, s.terms}; };
    check_cases<shape>({
        {"a ball", ball, ahead, enters(3)},
        {"behind the ray", ball, {{0, 0, 5}, {0, 0, 1}}, misses},
        {"from inside", ball, {{0, 0, 0}, {0, 0, 1}}, leaves(2)},
        {"from the surface inwards", ball, {{0, 0, 2}, {0, 0, -1}}, enters(0)},
        {"from the surface outwards", ball, {{0, 0, 2}, {0, 0, 1}}, leaves(0)},
        {"from the surface outwards, later", ball, {{0, 0, 2}, {0, 0, 1}}, misses, 0x1p-60},
        {"tangent", ball, {{2, 0, 5}, {0, 0, -1}}, enters(5)},
        {"one number beyond the tangent", ball, {{2 + 2 * eps, 0, 5}, {0, 0, -1}}, misses},
        {"the ball's half", boxed(ball, {-3, -3, -3}, {3, 3, 0}), ahead, enters(5)},
        {"the ball's half, from below", boxed(ball, {-3, -3, -3}, {3, 3, 0}), {{1, 0, -5}, {0, 0, 1}}, leaves(5), 4},
        {"the ball's eighth", boxed(ball, {0, 0, 0}, {3, 3, 3}), {{-1, 1, 1}, {1, 0, 0}}, enters(1)},
        {"along the edge of the ball's eighth", boxed(ball, {0, 0, 0}, {3, 3, 3}), {{-1, 0, 0}, {1, 0, 0}}, enters(1)},
        {"only just in the box", boxed(ball, {-2, -2, -2}, {2, 2, 2}), ahead, enters(3)},
        {"a box that the ball reaches beyond", boxed(ball, {-1, -1, -1}, {1, 1, 1}), ahead, enters(4)},
        {"through a corner of the box only", boxed(all, {-1, -1, -1}, {1, 1, 1}), {{3, 0, 0}, {-2, 1, 1}}, enters(1)},
        {"outside of the box", boxed(ball, {-3, -3, -3}, {3, 3, -3 + eps}), ahead, misses},
        {"two slabs, the first crossing", slabs, along, enters(3)},
        {"two slabs, the second", slabs, along, leaves(4), 3.5},
        {"two slabs, the third", slabs, along, enters(6), 4.5},
        {"two slabs, the last", slabs, along, leaves(7), 6.5},
        {"two slabs, behind them", slabs, along, misses, 7.5},
        {"between the slabs", slabs, {{0, 0, 5}, {0, 0, -1}}, misses},
        {"along the face of a slab", slabs, {{1, 0, 5}, {0, 0, -1}}, enters(2)},
        {"what is outside of the slabs, closed by the box", outside_slabs, along, enters(2)},
        {"what is outside of the slabs, the second crossing", outside_slabs, along, leaves(3), 2.5},
        {"what is outside of the slabs, the last", outside_slabs, along, leaves(8), 7.5},
        {"degree 8", die, ahead, enters(4)},
        {"degree 8, obliquely", die, {{5, 5, 0}, {-1, -1, 0}}, enters(5 - std::pow(0.5, 0.125))},
        {"degree 8, past it", die, {{1 + eps, 0, 5}, {0, 0, -1}}, misses},
        {"degree 8, touched eightfold", die, {{1, 0, 5}, {0, 0, -1}}, enters(5)},
        {"a cone's tip", cone, along, enters(5)},
        {"through a cone's tip, inside", cone, {{0, 0, 5}, {0, 0, -1}}, enters(2)},
        {"along a line of the cone", cone, {{-4, 0, 4}, {1, 0, -1}}, enters(1)},
        {"fourfold tangent", valley, along, enters(5)},
        {"two planes, along both", planes, {{0, 0, 5}, {0, 0, -1}}, enters(2)},
        {"two planes, inside", planes, {{1, -1, 5}, {0, 0, -1}}, enters(2)},
        {"two planes, outside", planes, {{1, 1, 5}, {0, 0, -1}}, misses},
        {"two planes, through where they cross", planes, {{-4, -4, 0}, {1, 1, 0}}, enters(4)},
        {"where a curve crosses itself", node, {{0, -5, 0}, {0, 1, 0}}, enters(5)},
        {"always below zero: the box", all, ahead, enters(2)},
        {"always below zero: the box, from inside", all, {{0, 0, 0}, {0, 0, 1}}, leaves(3)},
        {"always above zero", none, ahead, misses},
        {"no terms", in_box({}), ahead, misses},
        {"zero times something", in_box({{0, 2, 0, 0}}), ahead, misses},
        {"degree 9", in_box({{-1, 3, 3, 3}}), ahead, misses},
        {"degree 9, and 2", in_box({{-1, 3, 3, 3}, {1, 2, 0, 0}}), ahead, misses},
        {"zero times degree 9", in_box({{0, 3, 3, 3}, {-1, 0, 0, 0}}), ahead, enters(2)},
        {"a box without thickness", boxed(all, {-1, -1, 0}, {1, 1, 0}), ahead, misses},
        {"a box turned around", boxed(all, {1, 1, 1}, {-1, -1, -1}), ahead, misses},
        {"direction zero", all, {{0, 0, 0}, {0, 0, 0}}, misses},
        {"direction of length 1e-20", ball, {{0, 0, 5}, {0, 0, -0x1p-66}}, enters(0x3p66)},
        {"direction of length 1e20", ball, {{0, 0, 5}, {0, 0, -0x1p66}}, enters(0x3p-66)},
        {"1e4 radii away", ball, {{0, 0, T(20000)}, {0, 0, -1}}, enters(19998)},
        {"window turned around", ball, ahead, misses, 5, 3},
        {"window that is not a number", ball, ahead, misses, nan<T>},
    });
}

TEST_CASE_TEMPLATE("open_algebraic: named cases", T, RAIO_NUMBERS) {
    using shape = open_algebraic<T, 4>;
    const shape saddle{{-1, -1, -1}, {1, 1, 1}, {{1, 2, 0, 0}, {-1, 0, 2, 0}, {-1, 0, 0, 1}}};  // below z = x^2 - y^2
    const shape tube{{-3, -3, -3}, {3, 3, 3}, {{1, 2, 0, 0}, {1, 0, 2, 0}, {-4, 0, 0, 0}}};
    check_cases<shape>({
        {"from above", saddle, {{0.5, 0.25, 5}, {0, 0, -1}}, leaves(5 - 0.1875)},
        {"from below", saddle, {{0.5, 0.25, -5}, {0, 0, 1}}, enters(5.1875)},
        {"in the saddle point", saddle, {{0, 0, 5}, {0, 0, -1}}, leaves(5)},
        {"at an edge of the box", saddle, {{1, 0, 5}, {0, 0, -1}}, leaves(4)},
        {"beside the box", saddle, {{1.5, 1.5, 5}, {0, 0, -1}}, misses},
        {"along a line of the surface", saddle, {{-5, -5, 0}, {1, 1, 0}}, misses},
        {"tangent, at the edge of the box", saddle, {{-1, 0, 5}, {0, 0, -1}}, leaves(4)},
        {"into a tube", tube, {{0, 0, 0}, {1, 0, 0}}, leaves(2)},
        {"through the ends of a tube", tube, {{1, 0, 5}, {0, 0, -1}}, misses},
        {"in the wall of a tube", tube, {{2, 0, 5}, {0, 0, -1}}, misses},
        {"in through an end, onto the wall", tube, {{0, 0, 4}, {1, 0, -1}}, leaves(2)},
        {"onto the rim", tube, {{0, 0, 5}, {1, 0, -1}}, leaves(2)},
        {"onto the wall beyond the rim", tube, {{0, 0, 5.5}, {1, 0, -1}}, misses},
    });
}

TEST_CASE("algebraic: from a wall of the box that is the surface as well (what left it by 2^-1022 met it again)") {
    // 2 x where y = z = 1, and no more than that below.
    const algebraic<double, 4> shape{
        {-3, -1, 0}, {0, 2, 3}, {{1, 1, 3, 0}, {-1, 1, 1, 0}, {2, 1, 2, 0}, {1, 0, 0, 1}, {-1, 0, 0, 0}}};
    hit_record<double> rec{};
    REQUIRE(shape.hit({{4, 1, 1}, {-1, 0, 0}}, 0, infinity<double>, rec));
    CHECK(rec.point == vec3<double>(0, 1, 1));
    REQUIRE(shape.hit(spawn_ray(rec, {-0x1p-11, -1, -0.125}), 0, infinity<double>, rec));
    CHECK((!rec.front_face && rec.t > 1));
}

TEST_CASE_TEMPLATE("algebraic: coefficients that are all but zero hide no root of a higher degree", T, RAIO_NUMBERS) {
    const algebraic<T, 8> along_an_edge{{-2, -3, -2},
                                        {3, 3, 2},
                                        {{2, 1, 1, 0},
                                         {-1, 0, 3, 1},
                                         {-2, 2, 1, 3},
                                         {2, 1, 2, 3},
                                         {2, 1, 0, 6},
                                         {1, 2, 0, 0},
                                         {-1, 0, 2, 0},
                                         {1, 0, 0, 2}}};
    const algebraic<T, 8> from_a_face{
        {-2, -2, -1},
        {2, 1, 1},
        {{-2, 1, 4, 1}, {-1, 0, 0, 1}, {-2, 4, 1, 1}, {1, 2, 0, 0}, {-1, 0, 2, 0}, {1, 0, 0, 2}}};
    for (int power = -140; power < -60; ++power) {
        const T tiny = std::ldexp(T(1), power);
        hit_record<T> rec{};
        REQUIRE(along_an_edge.hit({{3, 3, 0}, {-tiny, 0, 1}}, T(0), infinity<T>, rec));
        CHECK(std::abs(rec.t - T(0.71541842388729637)) < T(1e-6));  // was 0
        REQUIRE(from_a_face.hit({{3, -1, 3}, {-1, -tiny, -1}}, T(0), infinity<T>, rec));
        CHECK(std::abs(rec.t - T(2)) < T(1e-6));  // was 3
    }
}

TEST_CASE_TEMPLATE("algebraic: properties of every shape", T, RAIO_NUMBERS) {
    check_properties<algebraic<T, 4>>();
    check_properties<open_algebraic<T, 4>>();
}

// What a ray in 75 digits costs grows with the square of the degree: the higher it is, the fewer there are.
TEST_CASE_TEMPLATE("algebraic: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<algebraic<T, 4>>();
    check_accuracy<algebraic<T, 4>>(test_rays, 1e-3, ulp_of_roots);
    check_accuracy<algebraic<T, 3>>(test_rays / 10, 1.0 / 200, ulp_of_roots);
    check_accuracy<algebraic<T, 8>>(test_rays / 20, 1.0 / 200, ulp_of_roots);
    check_bounds_of_errors<algebraic<T, 4>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("open_algebraic: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<open_algebraic<T, 3>>();
    check_accuracy<open_algebraic<T, 3>>(test_rays / 5, 1.0 / 200, ulp_of_roots);
    check_bounds_of_errors<open_algebraic<T, 3>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("algebraic: normal along the gradient, against the ray where there is none", T, RAIO_NUMBERS) {
    const T slack = 8 * std::numeric_limits<T>::epsilon();
    const algebraic<T, 2> ball{{-3, -3, -3}, {3, 3, 3}, {{1, 2, 0, 0}, {1, 0, 2, 0}, {1, 0, 0, 2}, {-4, 0, 0, 0}}};
    const algebraic<T, 2> cone{{-3, -3, -3}, {3, 3, 3}, {{1, 2, 0, 0}, {1, 0, 2, 0}, {-1, 0, 0, 2}}};
    random_numbers random(3);
    for (int i = 0; i < at_least(1000); ++i) {
        const vec3<T> from(random.direction() * 6.0), direction(normalize(vec3<T>(random.direction()) - from));
        hit_record<T> rec{};
        if (ball.hit({from, direction}, T(0), infinity<T>, rec)) {
            REQUIRE(length(vec3<T>(rec.normal - rec.point / T(2))) < slack);
        }
        if (cone.hit({vec3<T>(0), direction}, T(0), infinity<T>, rec) && rec.t == T(0)) {
            REQUIRE(length(vec3<T>(rec.normal + direction)) < slack);
        }
    }
}

TEST_CASE_TEMPLATE("algebraic: uv is the place in the box", T, RAIO_NUMBERS) {
    const algebraic<T, 2> ball{{-2, -4, -2}, {2, 4, 1}, {{1, 2, 0, 0}, {1, 0, 2, 0}, {1, 0, 0, 2}, {-3, 0, 0, 0}}};
    const auto uv = [&](const ray<T>& ray) {
        hit_record<T> rec{};
        REQUIRE(ball.hit(ray, T(0), infinity<T>, rec));
        return rec.uv;
    };
    CHECK(uv({{0, 0, -5}, {0, 0, 1}}) == vec2<T>(0.5, 0.5));
    CHECK(uv({{-5, 1, 1}, {1, 0, 0}}) == vec2<T>(0.25, 0.625));
    CHECK(uv({{1, 5, -1}, {0, -1, 0}}) == vec2<T>(0.75, 0.625));
    CHECK(uv({{1, -1, 5}, {0, 0, -1}}) == vec2<T>(0.75, 0.375));
}

TEST_CASE_TEMPLATE("algebraic: all crossings", T, RAIO_NUMBERS) {
    const algebraic<T, 4> slabs{{-3, -3, -3}, {3, 3, 3}, {{-1, 4, 0, 0}, {5, 2, 0, 0}, {-4, 0, 0, 0}}};
    for (const T x : {T(-5), T(5), T(-50)}) {  // ahead, behind and far ahead
        const auto inside = slabs.spans({{x, 0, 0}, {1, 0, 0}});
        REQUIRE(inside.count == 3);
        const T off = std::same_as<T, float> ? 0 : T(1e-13);  // of a double, the last bits are what the formula finds
        const auto is_between = [&](const interval<T>& i, T from, T to) {
            return std::abs(i.min - from) <= off && std::abs(i.max - to) <= off;
        };
        CHECK(is_between(inside.intervals[0], -3 - x, -2 - x));
        CHECK(is_between(inside.intervals[1], -1 - x, 1 - x));
        CHECK(is_between(inside.intervals[2], 2 - x, 3 - x));
    }
}

TEST_CASE("algebraic: the derivatives of t, by a number that carries them along") {
    const dual radius = dual::variable(2, 0);
    const algebraic<dual, 2> ball{
        {-3, -3, -3}, {3, 3, 3}, {{1, 2, 0, 0}, {1, 0, 2, 0}, {1, 0, 0, 2}, {-radius * radius, 0, 0, 0}}};
    hit_record<dual> rec{};
    REQUIRE(ball.hit({{0, 0, dual::variable(5, 1)}, {0, 0, -1}}, 0, infinity<dual>, rec));
    CHECK(rec.t.value == doctest::Approx(3));
    CHECK(rec.t.slope[0] == doctest::Approx(-1));
    CHECK(rec.t.slope[1] == doctest::Approx(1));
}

}  // namespace raio::test
