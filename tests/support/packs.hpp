#pragma once

#include <array>

#include <raio/math/simd.hpp>

#include "support/accuracy.hpp"
#include "support/properties.hpp"

/// \file
/// Shapes and rays of packs, lane by lane against plain numbers and against the oracle.

namespace raio::test {

/// Probes side by side, one in each lane.
template <class Shape, class P>
struct packed_probe {
    using shape_type = decltype(converted<P>(std::declval<Shape>()));

    shape_type shape;
    raio::ray<P> ray;
    P t_min, t_max;

    explicit packed_probe(const std::array<probe<Shape>, P::lanes>& probes)
        : shape(converted<P>(probes[0].shape)), ray(converted<P>(probes[0].ray)), t_min(0), t_max(0) {
        for (std::size_t lane = 0; lane < P::lanes; ++lane) set(lane, probes[lane]);
    }

    void set(std::size_t lane, probe<Shape> p) {
        std::vector<scalar_t<P>> numbers;
        const auto take = [&](auto& x) { numbers.push_back(x); };
        for_each_number(p.shape, take);
        for_each_number(p.ray, take);
        std::size_t next = 0;
        const auto put = [&](P& x) { x.set(lane, numbers[next++]); };
        for_each_number(shape, put);
        for_each_number(ray, put);
        t_min.set(lane, p.t_min);
        t_max.set(lane, p.t_max);
    }
};

/// A polyhedron has as many planes in every lane: the last one is repeated.
template <class Shape>
void make_as_large(Shape&) {}
template <class T>
void make_as_large(convex_polyhedron<T>& shape) {
    shape.planes.resize(9, shape.planes.back());
}

template <class Shape, std::size_t N, class MakeProbe>
std::array<probe<Shape>, N> probes_side_by_side(random_numbers& random, MakeProbe make_probe) {
    std::array<probe<Shape>, N> probes;
    for (probe<Shape>& p : probes) {
        p = make_probe(random);
        make_as_large(p.shape);
    }
    return probes;
}

/// What is wrong with one lane of the crossings: those that it is certain of have an exact one within the error that is
/// stated, and every exact one is among them, unless the lane leaves one open. Which of the two is called the near one
/// is another matter where a shape is open, and the other end is far outside of it.
template <class Shape, class S, std::size_t N>
std::string wrong_lane(const probe<Shape>& p, const std::vector<crossing<pack<S, N>>>& found, std::size_t lane) {
    const std::vector exact = exact_crossings(p.shape, p.ray);
    const auto is = [&](const crossing<pack<S, N>>& c, const crossing<oracle>& e) {
        const S error = c.error[lane];
        const bool in_range = abs(e.t) < std::numeric_limits<S>::max() && error < infinity<S>;
        return e.exists && (!in_range || abs(e.t - oracle(c.t[lane])) <= oracle(error));
    };
    for (const auto& c : found) {
        if (!c.certain[lane] || !c.exists[lane]) continue;
        if (std::ranges::none_of(exact, [&](const auto& e) { return is(c, e); })) {
            return "certain of a false hit at t = " + literal(c.t[lane]) + ", said " + literal(c.error[lane]);
        }
    }
    for (const auto& e : exact) {
        const auto may_be = [&](const auto& c) { return !c.certain[lane] || (c.exists[lane] && is(c, e)); };
        if (e.exists && std::ranges::none_of(found, may_be)) return "certain of a false miss";
    }
    return "";
}

/// Is it beyond doubt, by what one lane of the crossings says of itself, which of them are in the window?
template <class Shape, class S, std::size_t N>
bool settled_lane(const probe<Shape>& p, const std::vector<crossing<pack<S, N>>>& found, std::size_t lane) {
    for (const crossing<pack<S, N>>& c : found) {
        const S low = c.t[lane] - c.error[lane], high = c.t[lane] + c.error[lane];
        const bool apart = high < p.t_min || p.t_max < low || (p.t_min <= low && high <= p.t_max && high < infinity<S>);
        if (!c.certain[lane] || (c.exists[lane] && !apart)) return false;
    }
    return true;
}

template <class S, std::size_t N>
hit_record<S> lane_of(const hit_record<pack<S, N>>& rec, std::size_t lane) {
    const auto of = [&](const vec3<pack<S, N>>& v) { return vec3<S>(v.x[lane], v.y[lane], v.z[lane]); };
    return {rec.t[lane], of(rec.point),       of(rec.normal), {rec.uv.x[lane], rec.uv.y[lane]}, of(rec.error),
            0,           rec.front_face[lane]};
}

/// What is wrong with the hit in one lane, seen from the exact hit of plain numbers.
template <class Shape>
std::string unlike_plain(const probe<Shape>& p, bool hit, bool settled, const hit_record<number_t<Shape>>& rec,
                         number_t<Shape> error) {
    hit_record<number_t<Shape>> exact;
    const bool exact_hit = p.hit(exact);
    if (settled && hit != exact_hit) return hit ? "false hit" : "false miss";
    if (!hit) return rec.t == 7 && rec.error.z == 7 && rec.front_face ? "" : "a miss touched the record";
    if (!settled) return "";
    if (const std::string unsound = unsound_fields(rec); !unsound.empty()) return unsound + ", " + literal(rec);
    if (rec.front_face != exact.front_face) return "wrong face, " + literal(rec);
    if (!(std::abs(rec.t - exact.t) <= error + std::abs(exact.t) * std::numeric_limits<number_t<Shape>>::epsilon()))
        return "t = " + literal(rec.t) + " for " + literal(exact.t);
    if (dot(rec.normal, exact.normal) < number_t<Shape>(0.5)) return "";  // at an edge, of the other face
    const vec3<number_t<Shape>> off = abs(rec.point - exact.point), both = rec.error + exact.error;
    if (off.x > both.x || off.y > both.y || off.z > both.z) return "point off, " + literal(rec);
    return "";
}

/// The crossings, the hits and the records of packs, lane by lane; and that a lane which is not a number is missed and
/// leaves the others alone.
template <class Shape, class P>
void check_lanes_of_hits(int rays) {
    using S = scalar_t<P>;
    random_numbers random(20260101);
    int complaints = 0, settled_hits = 0;
    const auto complain = [&](const std::string& wrong, const probe<Shape>& p) {
        if (!wrong.empty() && ++complaints <= 3) FAIL_CHECK(wrong << "\n    {" << literal(p) << "}");
    };
    for (int i = 0; i < rays; i += int(P::lanes)) {
        const auto probes = probes_side_by_side<Shape, P::lanes>(random, random_probe<Shape>);
        packed_probe<Shape, P> packed(probes);
        const auto found = all_crossings<P>(packed.shape, packed.ray);
        hit_record<P> rec{P(7), vec3<P>(7), vec3<P>(7), vec2<P>(7), vec3<P>(7), 7, true};
        const auto hits = packed.shape.hit(packed.ray, packed.t_min, packed.t_max, rec);
        const auto occluded = packed.shape.occluded(packed.ray, packed.t_min, packed.t_max);
        for (std::size_t lane = 0; lane < P::lanes; ++lane) {
            complain(wrong_lane(probes[lane], found, lane), probes[lane]);
            const bool settled = settled_lane(probes[lane], found, lane);
            // What is not settled, two calls may round to different answers: compilers contract them as they like.
            if (settled && hits[lane] != occluded[lane]) complain("hit and occluded differ", probes[lane]);
            const hit_record<S> own = lane_of(rec, lane);
            const auto& met = own.t == found.front().t[lane] ? found.front() : found.back();
            complain(unlike_plain(probes[lane], hits[lane], settled, own, met.error[lane]), probes[lane]);
            settled_hits += settled && hits[lane];
        }

        const std::size_t broken = std::size_t(random.integer(0, int(P::lanes) - 1));
        packed.ray.origin.y.set(broken, std::numeric_limits<S>::quiet_NaN());
        hit_record<P> again = rec;
        const auto others = packed.shape.hit(packed.ray, packed.t_min, packed.t_max, again);
        if ((bits(others) | 1u << broken) != (bits(hits) | 1u << broken) || others[broken])
            complain("a lane that is no number is hit, or changes another", probes[broken]);
        for (std::size_t lane = 0; lane < P::lanes; ++lane) {
            if (lane != broken && !same_record(lane_of(rec, lane), lane_of(again, lane)))
                complain("a lane that is no number changes another's record", probes[lane]);
        }
    }
    CHECK(complaints == 0);
    CHECK(settled_hits > rays / 20);
}

/// Where packs go lane by lane, each lane answers what the plain shape answers, and a miss leaves its record alone.
template <class Shape>
void check_lanes_are_plain(int rays) {
    using S = number_t<Shape>;
    using P = pack<S, 4>;
    random_numbers random(20261122);
    int hits = 0;
    for (int i = 0; i < rays; i += int(P::lanes)) {
        const auto probes = probes_side_by_side<Shape, P::lanes>(random, random_probe<Shape>);
        const packed_probe<Shape, P> packed(probes);
        hit_record<P> rec{P(7), vec3<P>(7), vec3<P>(7), vec2<P>(7), vec3<P>(7), 7, true};
        const auto hit = packed.shape.hit(packed.ray, packed.t_min, packed.t_max, rec);
        const auto occluded = packed.shape.occluded(packed.ray, packed.t_min, packed.t_max);
        for (std::size_t lane = 0; lane < P::lanes; ++lane) {
            hit_record<S> expected{S(7), vec3<S>(7), vec3<S>(7), vec2<S>(7), vec3<S>(7), 7, true};
            const bool expected_hit = probes[lane].hit(expected);
            if (expected_hit) expected.index = 0;
            INFO(literal(probes[lane]));
            REQUIRE(hit[lane] == expected_hit);
            REQUIRE(occluded[lane] == expected_hit);
            hit_record<S> found = lane_of(rec, lane);
            found.index = expected.index;  // which `lane_of` leaves out
            REQUIRE(same_record(found, expected));
            hits += expected_hit;
        }
    }
    CHECK(hits > rays / 20);
}

/// The shape about one unit large and up to so far away, a ray from up to thirty units farther on that meets it about
/// half the time: what most rays of a scene are like.
template <class Shape>
probe<Shape> ordinary_probe_within(double far, random_numbers& random) {
    using T = number_t<Shape>;
    using about = subject<Shape>;
    probe<Shape> p{about::random(random, 1.0, random.direction() * random.uniform(0, far)), {}};
    const vec3<double> to = about::inner_point(p.shape, random) + random.direction() * random.uniform(0, 2);
    const vec3<double> from = about::inner_point(p.shape, random) + random.direction() * random.uniform(3, 30);
    p.ray = {vec3<T>(from), vec3<T>(to - from)};
    return p;
}

template <class Shape>
probe<Shape> ordinary_probe(random_numbers& random) {
    return ordinary_probe_within<Shape>(10, random);
}

/// How many of the lanes leave something open, of ordinary rays: in the crossings there are, or in whether there are
/// any.
template <class P, class Shape>
double fraction_left_open(int rays) {
    random_numbers random(11);
    int open = 0, count = 0;
    for (; count < rays; count += int(P::lanes)) {
        const auto probes = probes_side_by_side<Shape, P::lanes>(random, ordinary_probe<Shape>);
        const packed_probe<Shape, P> packed(probes);
        const auto found = all_crossings<P>(packed.shape, packed.ray);
        for (std::size_t lane = 0; lane < P::lanes; ++lane) open += !found[0].certain[lane];
    }
    return double(open) / count;
}

/// How many of the lanes leave open what a ray meets that leaves the shape where another hit it, if it did.
/// \param arriving  makes the other ray and the shape
template <class P, class Shape, class Arriving>
double fraction_of_spawned_left_open(int rays, Arriving arriving) {
    using T = number_t<Shape>;
    const auto spawned = [&](random_numbers& random) {
        for (;;) {
            probe<Shape> p = arriving(random);
            hit_record<T> rec;
            if (!p.shape.hit(p.ray, 0, infinity<T>, rec)) continue;
            p.ray = spawn_ray(rec, vec3<T>(vec3<double>(rec.normal) + random.direction()));
            p.t_min = 0, p.t_max = infinity<T>;
            return p;
        }
    };
    random_numbers random(12);
    int open = 0, count = 0;
    for (; count < rays; count += int(P::lanes)) {
        const auto probes = probes_side_by_side<Shape, P::lanes>(random, spawned);
        const packed_probe<Shape, P> packed(probes);
        const auto found = all_crossings<P>(packed.shape, packed.ray);
        for (std::size_t lane = 0; lane < P::lanes; ++lane) open += !settled_lane(probes[lane], found, lane);
    }
    return double(open) / count;
}

}  // namespace raio::test
