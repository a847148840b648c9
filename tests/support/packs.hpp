#pragma once

#include <array>

#include <raio/number/simd.hpp>

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

/// And its spans those of the plain shape? Packs have room for one in each lane.
template <class Shape, class P, class Complain>
void check_spans_of_lane(const packed_probe<Shape, P>& packed, const probe<Shape>& p, std::size_t lane,
                         Complain complain) {
    if constexpr (requires { packed.shape.spans(packed.ray).min; }) {
        const auto inside = packed.shape.spans(packed.ray);
        const interval<scalar_t<P>> own{inside.min[lane], inside.max[lane]};
        if (!(own == p.shape.spans(p.ray))) complain("other spans", p);
    }
}

/// Each lane answers what the plain shape answers, and a miss leaves its record alone; and a lane which is not a number
/// is missed and leaves the others alone.
template <class Shape, class P = pack<number_t<Shape>, 4>>
void check_lanes_are_plain(int rays) {
    using S = number_t<Shape>;
    random_numbers random(20261122);
    int complaints = 0, hits = 0;
    const auto complain = [&](const std::string& wrong, const probe<Shape>& p) {
        if (++complaints <= 3) FAIL_CHECK(wrong << "\n    {" << literal(p) << "}");
    };
    const hit_record<S> untouched{S(7), vec3<S>(7), vec3<S>(7), vec2<S>(7), vec3<S>(7), 7, true};
    for (int i = 0; i < rays; i += int(P::lanes)) {
        const auto probes = probes_side_by_side<Shape, P::lanes>(random, random_probe<Shape>);
        packed_probe<Shape, P> packed(probes);
        hit_record<P> rec{P(7), vec3<P>(7), vec3<P>(7), vec2<P>(7), vec3<P>(7), 7, true};
        const auto hit = packed.shape.hit(packed.ray, packed.t_min, packed.t_max, rec);
        const auto occluded = packed.shape.occluded(packed.ray, packed.t_min, packed.t_max);
        for (std::size_t lane = 0; lane < P::lanes; ++lane) {
            hit_record<S> expected = untouched;
            const bool expected_hit = probes[lane].hit(expected);
            hits += expected_hit;
            if (hit[lane] != expected_hit) complain(expected_hit ? "false miss" : "false hit", probes[lane]);
            if (occluded[lane] != expected_hit) complain("hit and occluded differ", probes[lane]);
            const hit_record<S> found = detail::in_lane<P>(rec, lane);
            if constexpr (!detail::lists_crossings<Shape, S>) check_spans_of_lane(packed, probes[lane], lane, complain);
            if (hit[lane] == expected_hit && !same_as_plain(found, expected))
                complain(literal(found) + " for " + literal(expected), probes[lane]);
        }

        const std::size_t broken = std::size_t(random.integer(0, int(P::lanes) - 1));
        packed.ray.origin.y.set(broken, std::numeric_limits<S>::quiet_NaN());
        hit_record<P> again = rec;
        const auto others = packed.shape.hit(packed.ray, packed.t_min, packed.t_max, again);
        if ((bits(others) | 1u << broken) != (bits(hit) | 1u << broken) || others[broken])
            complain("a lane that is no number is hit, or changes another", probes[broken]);
        for (std::size_t lane = 0; lane < P::lanes; ++lane) {
            if (lane != broken && !same_as_plain(detail::in_lane<P>(again, lane), detail::in_lane<P>(rec, lane)))
                complain("a lane that is no number changes another's record", probes[lane]);
        }
    }
    CHECK(complaints == 0);
    CHECK(hits > rays / 20);
}

/// Where a formula finds one crossing: what is found again of it in strict_double, to within what the sieve's error
/// says of that.
template <class Shape, class P>
auto crossings_found_again(const packed_probe<Shape, P>& packed) {
    using D = pack<double, P::lanes>;
    std::vector<crossing<D>> found;
    if constexpr (std::same_as<scalar_t<P>, float> &&
                  requires { packed.shape.crossings(line_in<P>(packed.ray)).exists; }) {
        const P most(std::numeric_limits<float>::max());
        const auto sieve = detail::sift(packed.shape.crossings(line_in<P>(packed.ray)), -most, most);
        const auto again = detail::retrieved<detail::question::where>(
            sieve, packed.shape.crossings(line_in<working_t<P>>(packed.ray)), -most);
        found.push_back({again.exists, again.exists, D(again.t), D(again.error), again.entering});
    }
    return found;
}

/// What the crossings of packs are certain of is so.
template <class Shape, class P>
void check_crossings_of_lanes(int rays) {
    random_numbers random(20260101);
    int complaints = 0;
    for (int i = 0; i < rays; i += int(P::lanes)) {
        const auto probes = probes_side_by_side<Shape, P::lanes>(random, random_probe<Shape>);
        const packed_probe<Shape, P> packed(probes);
        const auto found = all_crossings<P>(packed.shape, packed.ray);
        const auto again = crossings_found_again(packed);
        for (std::size_t lane = 0; lane < P::lanes; ++lane) {
            std::string wrong = wrong_lane(probes[lane], found, lane);
            if (wrong.empty() && !again.empty()) wrong = wrong_lane(probes[lane], again, lane);
            if (!wrong.empty() && ++complaints <= 3) FAIL_CHECK(wrong << "\n    {" << literal(probes[lane]) << "}");
        }
    }
    CHECK(complaints == 0);
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

/// How many of the lanes that the sieve is sure of, of ordinary rays, have to be asked for alone all the same.
template <class P, class Shape>
double fraction_asked_alone(int rays) {
    random_numbers random(13);
    const P t_min(0), t_max(std::numeric_limits<scalar_t<P>>::max());
    int sure = 0, alone = 0;
    for (int count = 0; count < rays; count += int(P::lanes)) {
        const auto probes = probes_side_by_side<Shape, P::lanes>(random, ordinary_probe<Shape>);
        const packed_probe<Shape, P> packed(probes);
        constexpr detail::question where = detail::question::where;
        const auto found =
            detail::sift(detail::first_crossings<where>(packed.shape, packed.ray, t_min, t_max), t_min, t_max);
        if (none(found.sure)) continue;
        hit_record<P> rec{};
        std::uint32_t left = 0;
        detail::record_known<where>(packed.shape, packed.ray, t_min, t_max, rec, left);
        sure += std::popcount(bits(found.sure)), alone += std::popcount(bits(found.sure) & left);
    }
    return double(alone) / sure;
}

/// How many of the lanes leave open what a ray meets that leaves the shape where another hit it, if it did.
/// \param arriving  makes the other ray and the shape
template <class P, class Shape, class Arriving>
double fraction_of_spawned_left_open(int rays, Arriving arriving) {
    using T = number_t<Shape>;
    const auto spawned = [&](random_numbers& random) {
        for (;;) {
            probe<Shape> p = arriving(random);
            hit_record<T> rec{};
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
