#include <algorithm>

#include <raio/bvh/bvh.hpp>
#include <raio/number/simd.hpp>
#include <raio/raio.hpp>

#include "support/accuracy.hpp"
#include "support/portable_shapes.hpp"
#include "support/proven.hpp"

/// \file
/// The line of a ray that was mapped: whatever ray it stands for, what a formula says of its crossings holds.

namespace raio::test {

namespace {

/// How far a vector is moved, by `error` at most: that is the sum of what its components are moved by.
vec3<double> some_move(random_numbers& random, double error) {
    const double in_x = random.uniform(), in_y = random.uniform() * (1 - in_x);
    const double x = random.one_in(4) ? 1 : in_x, y = x == 1 ? 0 : in_y;
    const vec3<double> share(x, y, 1 - x - y);
    const auto sign = [&] { return random.one_in(2) ? 1.0 : -1.0; };
    return vec3<double>(share.x * sign(), share.y * sign(), share.z * sign()) * (error * (1 - 0x1p-40));
}

template <class W>
bounded_vector<W> with_error(const vec3<double>& v, double error) {
    return {W(v.x), W(v.y), W(v.z), bound_t<W>(error)};
}

template <class X>
vec3<X> moved(const vec3<double>& v, const vec3<double>& move) {
    return {X(v.x) + X(move.x), X(v.y) + X(move.y), X(v.z) + X(move.z)};
}

/// A ray, how far it may be off, and one that it may stand for.
struct vague_ray {
    ray<double> known;
    double origin_error, direction_error;
    ray<double_double> meant;

    vague_ray(const ray<double>& r, random_numbers& random, double least, double most) : known(r) {
        origin_error = random.log_uniform(least, most), direction_error = random.log_uniform(least, most);
        if (random.one_in(8)) origin_error = 0;
        if (random.one_in(8)) direction_error = 0;
        meant = {moved<double_double>(r.origin, some_move(random, origin_error)),
                 moved<double_double>(r.direction, some_move(random, direction_error))};
    }

    template <class W>
    mapped_line<W> line() const {
        return {with_error<W>(known.origin, origin_error), with_error<W>(known.direction, direction_error)};
    }
};

/// What is certain of the crossings, and how much of it there is.
struct count_of_certain {
    int all = 0, certain = 0, crossings = 0;
};

/// As `wrong_bound`. What those that it is compared with are not certain of, they do not tell.
template <class W, class X>
std::string wrong_bound_of(const std::vector<crossing<W>>& found, const std::vector<crossing<X>>& exact) {
    const auto certain = [](const auto& c) { return c.certain; };
    if (!std::ranges::all_of(exact, certain)) return "";
    if (found.size() != exact.size() && !std::ranges::all_of(found, certain)) return "";
    const auto there = std::ranges::count_if(exact, [](const auto& c) { return c.exists; });
    if (std::ranges::count_if(found, [](const auto& c) { return c.certain && c.exists; }) > there) {
        return "certain of a false hit";
    }
    if (std::ranges::count_if(found, [](const auto& c) { return !c.certain || c.exists; }) < there) {
        return "certain of a false miss";
    }
    for (const crossing<W>& c : found) {
        if (!c.certain || !c.exists) continue;
        oracle least = infinity<oracle>;
        for (const crossing<X>& e : exact) {
            if (!e.exists) continue;
            const oracle off = abs(exactly(c.t) - exactly(e.t)) - exactly(e.error);
            least = exactly(c.t) == exactly(e.t) ? oracle(0) : min(least, off);
        }
        if (!(least <= exactly(c.error))) {
            return "off by " + literal(rounded<double>(least)) + ", said " + literal(rounded<double>(exactly(c.error)));
        }
    }
    return "";
}

/// Of two chords, the second is not certain unless the first is.
template <class W>
std::vector<crossing<scalar_t<W>>> in_lane_of(const std::vector<crossing<W>>& packed, std::size_t i) {
    std::vector<crossing<scalar_t<W>>> own;
    const bool begins = packed[0].certain[i];
    for (const crossing<W>& c : packed) {
        own.push_back({c.exists[i], begins && c.certain[i], c.t[i], c.error[i], c.entering[i]});
    }
    return own;
}

/// Visits the shapes that are asked for crossings, and the pieces of those that are made of some.
template <class Shape, class Visit>
void visit_crossed(const Shape& shape, Visit visit) {
    if constexpr (requires { shape.profile; }) {
        const auto& p = shape.profile;
        if constexpr (std::same_as<Shape, surface_of_revolution<double>>) {
            visit(detail::revolved_piece<double, 1>{shape.base, shape.axis, p[0], p[1]});
        } else {
            visit(detail::revolved_piece<double, 3>{shape.base, shape.axis, p[0], p[1], p[2], p[3]});
        }
    } else if constexpr (detail::has_formula<Shape>) {
        visit(shape);
    }
}

}  // namespace

TEST_CASE("mapped_line: what its vectors stand for is no farther off than they say") {
    const auto check = []<class W>(W) {
        random_numbers random(1);
        double largest = 0;
        for (int i = 0; i < at_least_a_tenth_of(2000); ++i) {
            const auto some = [&] { return random.direction() * random.log_uniform(1e-3, 1e3); };
            const vec3<double> p = some(), q = some();
            const vague_ray r({some(), some()}, random, 1e-34, 1e-9);
            const mapped_line<W> line = r.line<W>();
            const vec3<oracle> origin = exactly(r.meant.origin), direction = exactly(r.meant.direction);
            const auto holds = [&](const bounded_vector<W>& v, const vec3<oracle>& exact) {
                const oracle off =
                    abs(exactly(v.x) - exact.x) + abs(exactly(v.y) - exact.y) + abs(exactly(v.z) - exact.z);
                REQUIRE(off <= exactly(v.error));
                if (v.error > 0) largest = std::max(largest, rounded<double>(off / exactly(v.error)));
            };
            holds(line.origin(), origin);
            holds(line.direction(), direction);
            holds(line.to(p), exactly(p) - origin);
            holds(line.from(p), origin - exactly(p));
            holds(line.to_middle(p, q), (exactly(p) + exactly(q)) * oracle(0.5) - origin);
            REQUIRE(exactly(line.given(p).y) == exactly(p.y));
        }
        CHECK(largest > 0.9);
    };
    check(strict_double());
    check(double_double());
}

TEST_CASE("mapped_line: what a shape is certain of holds for every ray that may be meant") {
    for_every_portable_shape<double>([&](const char* name, auto make) {
        INFO(std::string(name));
        portable_numbers numbers;
        random_numbers random(1);
        count_of_certain count;
        for (int i = 0; i < at_least_a_tenth_of(2000); ++i) {
            const auto all_of_it = make(numbers);
            const vague_ray r(numbers.aimed_ray<double>(), random, 1e-17, 0.1);
            const vague_ray fine(r.known, random, 1e-28, 1e-17);
            INFO(i);
            visit_crossed(all_of_it, [&](const auto& shape) {
                using Shape = std::remove_cvref_t<decltype(shape)>;
                const std::vector exact = crossings_along(shape, line_in<double_double>(r.meant));
                const std::vector found = crossings_along(shape, r.line<strict_double>());
                REQUIRE(wrong_bound_of(found, exact) == "");
                count.all += 1, count.certain += std::ranges::all_of(found, &crossing<strict_double>::certain) ? 1 : 0;
                count.crossings += static_cast<int>(std::ranges::count_if(found, &crossing<strict_double>::exists));

                const std::vector exact_of_fine = crossings_along(shape, line_in<double_double>(fine.meant));
                REQUIRE(wrong_bound_of(crossings_along(shape, fine.line<double_double>()), exact_of_fine) == "");
                if constexpr (requires { requires bounded<Shape> && detail::gatherable<Shape>; }) {
                    using N = pack<strict_double, 4>;
                    detail::gathered<Shape, 4> shapes;
                    for (std::size_t lane = 0; lane < 4; ++lane) shapes.set(lane, shape);
                    const auto of_packs = detail::as_packs_of<N>(shapes.shapes());
                    REQUIRE(wrong_bound_of(in_lane_of(crossings_along(of_packs, r.line<N>()), 3), exact) == "");
                }
            });
        }
        MESSAGE(std::string(name) << ": " << count.certain << " of " << count.all << " certain, " << count.crossings
                                  << " crossings");
        CHECK(count.certain >= count.all / 2);
    });
}

}  // namespace raio::test
