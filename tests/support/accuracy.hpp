#pragma once

#include <algorithm>
#include <cmath>

#include "support/probe.hpp"

/// \file
/// The comparison with the oracle: the same rays in 75 digits.

namespace raio::test {

/// The crossings as `crossings` finds them: both of a convex solid, the one of a flat shape, or a list. A list that
/// is not certain holds nothing that is.
template <class Shape, class Line, class W = typename Line::number>
std::vector<crossing<W>> crossings_along(const Shape& shape, const Line& line) {
    const auto found = shape.crossings(line);
    if constexpr (requires { found.near; }) {
        return {found.near, found.far};
    } else if constexpr (detail::has_lanes<W> && requires { found.second; }) {
        return {found.first.near, found.first.far, found.second.near, found.second.far};
    } else if constexpr (requires { listed(found); }) {
        const auto list = listed(found);
        std::vector<crossing<W>> crossings(list.begin(), list.end());
        for (crossing<W>& c : crossings) c.certain = c.certain && list.certain;
        if (crossings.empty() && !list.certain) crossings.push_back({false, false, W(0), bound_t<W>(0), false});
        return crossings;
    } else {
        return {found};
    }
}
template <class W, class Shape, class R = number_t<Shape>>
std::vector<crossing<W>> all_crossings(const Shape& shape, const ray<R>& ray) {
    return crossings_along(shape, line_in<W>(ray));
}

/// The crossings in 75 digits. Where a ray meets the very edge of a closed shape, 75 digits decide no better than any
/// others, and say that they are not certain: it is crossed, then, if it is as soon as it is larger by 1e-40 or less,
/// and parts that touch are one then, if the shape unites them. That moves a tangent's t by up to the root of it, so
/// rims are farther out by that. `error` says how far t may be off; of all others it is what 75 digits leave open,
/// which matters where t is 0.
template <class Shape, class R>
std::vector<crossing<oracle>> exact_crossings(const Shape& shape, const ray<R>& ray) {
    const auto exact_shape = converted<oracle>(shape);
    const raio::ray<oracle> exact_ray{exactly(ray.origin), exactly(ray.direction)};
    std::vector crossings = all_crossings<oracle>(exact_shape, exact_ray);
    if (crossings.empty()) return crossings;
    using bound = bound_t<oracle>;
    bound shape_size = 0;
    if constexpr (bounded<Shape>) {
        const aabb<number_t<Shape>> box = shape.bounds();
        const bound size = norm1(vec3<bound>(vec3<bound>(box.max) - vec3<bound>(box.min)));
        if (std::isfinite(size)) shape_size = size;
    }
    const vec3<bound> origin(exact_ray.origin), direction(exact_ray.direction);
    const bound speed = length(direction), in_directions = speed > 0 ? 1 / speed : infinity<bound>;
    const auto add_errors = [&](std::vector<crossing<oracle>>& found, bound part) {
        for (crossing<oracle>& c : found) {
            const bound way = norm1(origin) + norm1(direction) * std::abs(bound(c.t));
            // Of a tangent half of the 46 digits are known, but one.
            c.error = (shape_size + way) * std::max(part, c.certain ? 0 : bound(1e-22)) * in_directions;
        }
    };
    add_errors(crossings, 1e-46);
    using about = subject<std::remove_cvref_t<decltype(exact_shape)>>;
    if constexpr (!solid<Shape> && requires { about::lies_in_side(exact_shape, exact_ray); }) {
        if (about::lies_in_side(exact_shape, exact_ray)) return crossings;
    }
    if constexpr (requires { about::grown(exact_shape); }) {
        if (std::ranges::all_of(crossings, &crossing<oracle>::certain)) return crossings;
        std::vector larger = all_crossings<oracle>(about::grown(exact_shape), exact_ray);
        if constexpr (requires { about::grown_inwards(exact_shape); }) {
            const std::vector inwards = all_crossings<oracle>(about::grown_inwards(exact_shape), exact_ray);
            const auto exist = [](const auto& found) {
                return std::ranges::count_if(found, &crossing<oracle>::exists);
            };
            if (exist(inwards) > exist(larger)) larger = inwards;
        }
        add_errors(larger, 1e-17);  // faces are off by 1e-21, and a ray may come to them at an angle of 1e-4
        if constexpr (!solid<Shape> && requires(oracle near) { about::is_apex(exact_shape, exact_ray.origin, near); }) {
            for (crossing<oracle>& c : larger) {  // an apex stays in the plane of its end, which 75 digits cannot say
                const vec3<oracle> step = exact_ray.direction * c.t;
                const oracle near = (norm1(exact_ray.origin) + norm1(step)) * 1e-40;
                if (!c.certain && about::is_apex(exact_shape, exact_ray.origin + step, near)) c.exists = true;
            }
        }
        for (crossing<oracle>& c : larger) c.certain = false;  // of two faces at an edge it may have become the other's
        constexpr bool unites = requires { about::touching_parts_are_one; };
        if (larger.size() > crossings.size() || (unites && larger.size() < crossings.size())) return larger;
        for (std::size_t i = 0; i < larger.size(); ++i) {
            if (!crossings[i].exists && !crossings[i].certain) crossings[i] = larger[i];
        }
    }
    return crossings;
}

template <class Shape>
bool in_window(const probe<Shape>& p, number_t<Shape> t) {
    return p.t_min <= t && t <= p.t_max && std::isfinite(t);
}

/// How far what is recorded along a line is said to be off, but for the rounding to the shape's numbers. It is computed
/// when it is asked for: most rays ask for none of it.
template <class Shape>
class stated_errors {
    using T = number_t<Shape>;

public:
    stated_errors(const Shape& shape, const ray<T>& ray) : shape_(shape), ray_(ray) {}

    /// The error that is stated of the recorded crossing that is nearest to t.
    oracle at(const oracle& t) {
        if (!is_known_) record_all();
        oracle least = infinity<oracle>, error = 0, covering = 0;
        for (const recorded& c : all_) {
            const oracle apart = abs(c.t - t);
            if (apart < least) least = apart, error = c.error;
            if (apart <= c.error) covering = max(covering, oracle(c.error));  // beside a tip it may be either's
        }
        return max(error, covering);
    }

private:
    struct recorded {
        oracle t, error;
    };

    void record_all() {
        using namespace detail;
        is_known_ = true;
        const auto exact = [&] { return shape_.crossings(line_in<double_double>(ray_)); };
        const auto add = [&](const auto& c) {
            if (c.exists) all_.push_back({exactly(c.t), exactly(c.error)});
            return false;
        };
        if constexpr (keeps_all_digits<T>) {
            visit_recorded<T>(shape_.crossings(line_in<working_t<T>>(ray_)), exact, add);
        } else {
            const auto found = exact();
            for (const auto& c : in_order(found)) add(c);
        }
    }

    const Shape& shape_;
    const ray<T>& ray_;
    std::vector<recorded> all_;
    bool is_known_ = false;
};

/// The normal of the crossing, as the shape records it.
template <class Shape>
vec3<oracle> exact_normal(const Shape& exact_shape, const ray<oracle>& ray, const crossing<oracle>& crossing) {
    struct {
        oracle t;
        vec3<oracle> normal;
    } rec{};
    detail::record_crossing(exact_shape, ray, crossing, rec);
    return rec.normal;
}

/// How much a crossing changes with the last places of the numbers given: where that is much, as of a ray that grazes
/// or of a sliver, no formula that rounds can find more.
struct change_of_crossing {
    oracle of_t = 0;
    double of_normal = 0;
};
/// \param is_enough  says of the changes found so far that what they are to explain is explained
template <class Shape, class IsEnough>
change_of_crossing changes_of_input(const probe<Shape>& p, const crossing<oracle>& crossing, IsEnough is_enough) {
    using T = number_t<Shape>;
    const auto normal_of = [](const Shape& shape, const ray<T>& ray, const raio::crossing<oracle>& c) {
        const raio::ray<oracle> exact_ray{exactly(ray.origin), exactly(ray.direction)};
        return exact_normal(converted<oracle>(shape), exact_ray, c);
    };
    const vec3<oracle> normal = normal_of(p.shape, p.ray, crossing);
    random_numbers random(1);
    change_of_crossing most;
    for (int i = 0; i < 16 && !is_enough(most); ++i) {
        probe<Shape> moved = p;
        // A sum of several numbers is rounded to a place of the largest.
        const auto move_all = [&](auto& numbers) {
            T largest = 0;
            for_each_number(numbers, [&](const T& x) { largest = std::max(largest, std::abs(x)); });
            const T step = largest * std::numeric_limits<T>::epsilon();
            for_each_number(numbers, [&](T& x) { x += step * T(random.integer(-2, 2)); });
        };
        move_all(moved.ray.origin), move_all(moved.ray.direction);
        for_each_number(moved.shape,
                        [&](T& x) { x += x * std::numeric_limits<T>::epsilon() * T(random.integer(-2, 2)); });
        oracle least = infinity<oracle>, turned = 0;
        for (const raio::crossing<oracle>& c : exact_crossings(moved.shape, moved.ray)) {
            const oracle apart = abs(c.t - crossing.t);
            if (!(apart < least)) continue;  // beside an edge it may have gone, and still says where it would be
            least = apart;
            if (c.exists) turned = length(normal_of(moved.shape, moved.ray, c) - normal);
        }
        if (isfinite(least)) most.of_t = std::max(most.of_t, oracle(8 * least));
        most.of_normal = std::max(most.of_normal, 2 * rounded<double>(turned));
    }
    return most;
}

/// How far the recorded normal is from that of the crossing, beyond four roundings and what the normal changes within
/// the error of the point: so far the ray may be moved, and the crossing along it; of one that moves farther it is a
/// part. (A ray that all but lies in a patch passes beside it then: it is moved by less as well.) Beside an edge it is
/// that of another face. (Of a crossing that two faces share it may be either's, and of one of which 75 digits are not
/// certain, as one of the edge of a box without thickness, any.)
template <class Shape>
double normal_off(const probe<Shape>& p, const hit_record<number_t<Shape>>& rec, const crossing<oracle>& crossing) {
    using T = number_t<Shape>;
    const auto shape = converted<oracle>(p.shape);
    const ray<oracle> exact_ray{exactly(p.ray.origin), exactly(p.ray.direction)};
    const vec3<oracle> normal = exact_normal(shape, exact_ray, crossing), error(rec.error);
    const double off = rounded<double>(length(normal - vec3<oracle>(rec.normal))) - 4 * unit_roundoff<T>;
    if (!(off > 0) || !crossing.certain || crossing.shared) return 0;
    double explained = 0, of_input = 0;
    const auto is_explained = [&] { return explained + of_input >= off; };
    const auto ask_for_input = [&] {
        if (!detail::keeps_all_digits<T> || is_explained()) return;
        const auto is_enough = [&](const change_of_crossing& c) { return explained + c.of_normal >= off; };
        of_input = changes_of_input(p, crossing, is_enough).of_normal;
    };
    for (int i = 0; i < 4 * 27 && !is_explained(); ++i) {
        const oracle part(std::ldexp(1.0, -10 * (i / 27)));
        ray<oracle> moved = exact_ray;
        moved.origin += error * part * vec3<oracle>(i % 3 - 1, i / 3 % 3 - 1, i / 9 % 3 - 1);
        const auto explain_by = [&](const raio::crossing<oracle>& c) {
            if (!c.exists) return;
            const oracle apart = abs(c.t - crossing.t) * norm1(moved.direction), near = 8 * norm1(error);
            const oracle part_of_it = apart > near ? near / apart : oracle(1);
            const oracle change = length(exact_normal(shape, moved, c) - normal) * part_of_it;
            explained = std::max(explained, 2 * rounded<double>(change));  // others of its directions may turn more
        };
        explain_by(crossing);
        if (!is_explained()) std::ranges::for_each(all_crossings<oracle>(shape, moved), explain_by);
        if (i == 0 && explained == 0) ask_for_input();  // in a plane, whose normal is off by what its numbers are
    }
    if (of_input == 0) ask_for_input();
    return std::max(off - explained - of_input, 0.0);
}

/// May floats ask for more digits than two doubles have? Products do if some of the ray's numbers are less than a
/// millionth of others, but not zero; and so does t if the ray starts 2^-80 of its numbers beside the surface.
template <class Shape>
bool asks_for_more_digits(const probe<Shape>& p) {
    using T = number_t<Shape>;
    const auto is_uneven = [](const vec3<T>& v) {
        const T least = norm1(v) * T(0x1p-20);
        const auto is_tiny = [&](T x) { return x != T(0) && std::abs(x) < least; };
        return is_tiny(v.x) || is_tiny(v.y) || is_tiny(v.z);
    };
    if (is_uneven(p.ray.origin) || is_uneven(p.ray.direction)) return true;
    const oracle close = norm1(exactly(p.ray.origin)) * 0x1p-80 / norm1(exactly(p.ray.direction));
    return std::ranges::any_of(all_crossings<double_double>(p.shape, p.ray),
                               [&](const auto& c) { return abs(exactly(c.t)) < close; });
}

/// How many rays hit, how many of their points were vague, and how far t has been off, in units of its last place.
struct worst_errors {
    int hits = 0, vague = 0;
    double beyond_stated = 0;  ///< that much more than is stated
    double beyond_input = 0;   ///< that much more than roundings of the numbers given make of it, where 2^12 are stated
};

/// Is a point said to be off by more than its own digits, and those of the ray's origin, explain? A double has no more
/// digits than its t was found with, and the bound of that has some room.
template <class Shape>
bool is_vague(const probe<Shape>& p, const hit_record<number_t<Shape>>& rec) {
    using T = number_t<Shape>;
    constexpr double roundings = detail::keeps_all_digits<T> ? 0x1p20 : 16;
    return norm1(rec.error) > T(roundings * unit_roundoff<T>) * (norm1(rec.point) + norm1(p.ray.origin));
}

/// What is wrong with the record of a hit, if it is of this crossing. The error of a double's t may be larger than half
/// an ulp by as much as is stated, and that of a float's by what double_double says if it asks for more digits.
template <class Shape>
std::string difference(const probe<Shape>& p, const hit_record<number_t<Shape>>& rec, const crossing<oracle>& crossing,
                       stated_errors<Shape>& errors, worst_errors& worst) {
    using T = number_t<Shape>;
    const oracle exact_t = crossing.t, error_of_t = abs(oracle(rec.t) - exact_t);
    const T best = rounded<T>(exact_t), ulp = std::nextafter(std::abs(best), infinity<T>) - std::abs(best);
    const bool has_all_digits = rec.t == best || (std::same_as<T, float> && !asks_for_more_digits(p));
    const oracle stated = has_all_digits ? oracle(0) : errors.at(oracle(rec.t));
    const oracle allowed = stated + crossing.error;
    if (error_of_t > allowed + abs(oracle(best) - exact_t)) return "t = " + literal(rec.t) + " for " + literal(best);
    worst.beyond_stated = std::max(worst.beyond_stated, rounded<double>((error_of_t - allowed) / ulp));
    const auto unexplained = [&](const oracle& of_input) { return rounded<double>((error_of_t - of_input) / ulp); };
    const auto is_well_known = [&] { return errors.at(oracle(rec.t)) < oracle(0x1p12) * ulp; };
    if (crossing.certain && unexplained(oracle(0)) > worst.beyond_input && is_well_known()) {
        const auto is_enough = [&](const change_of_crossing& c) { return unexplained(c.of_t) <= worst.beyond_input; };
        const bool is_much = error_of_t > 4 * oracle(ulp);
        const oracle of_input = is_much ? changes_of_input(p, crossing, is_enough).of_t : oracle(0);
        worst.beyond_input = std::max(worst.beyond_input, unexplained(of_input));
    }
    if (rec.front_face != crossing.entering) return "wrong face, " + literal(rec);
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const oracle origin(p.ray.origin[axis]), step = oracle(p.ray.direction[axis]) * exact_t;
        const oracle own_error =
            (abs(origin) + abs(step)) * 1e-38 + abs(oracle(p.ray.direction[axis])) * crossing.error;
        const oracle off = abs(origin + step - oracle(rec.point[axis]));
        if (off > oracle(rec.error[axis]) + own_error) {
            return "point off by " + literal(rounded<T>(off)) + ", " + literal(rec);
        }
    }
    const double turned = normal_off(p, rec, crossing);
    return turned > 0 ? "normal off by " + literal(turned) + ", " + literal(rec) : "";
}

/// What is wrong with the answer to one probe: `hit` has to find the first crossing whose t, as it is recorded, lies in
/// the window. That is the exact one, correctly rounded, or of a double within the error that is stated. One of which
/// 75 digits cannot say whether it does may be that, or not.
template <class Shape>
std::string inexactness(const probe<Shape>& p, worst_errors& worst) {
    using T = number_t<Shape>;
    stated_errors<Shape> errors(p.shape, p.ray);
    hit_record<T> rec{};
    const bool hit = p.hit(rec);
    worst.hits += hit, worst.vague += hit && is_vague(p, rec);
    std::string wrong;
    bool compared = false;
    for (const crossing<oracle>& c : exact_crossings(p.shape, p.ray)) {
        if (!c.exists) continue;
        const oracle off = c.error + (detail::keeps_all_digits<T> ? errors.at(c.t) : oracle(0));
        const T low = rounded<T>(c.t - off), high = rounded<T>(c.t + off);
        if (!(low <= p.t_max && p.t_min <= high && std::isfinite(rounded<T>(c.t)))) continue;
        const bool counts = p.t_min <= low && high <= p.t_max;
        if (hit) {
            compared = true;
            wrong = difference(p, rec, c, errors, worst);
            if (wrong.empty() || counts) return wrong;
        } else if (counts) {
            return "false miss, t = " + literal(rounded<T>(c.t));
        }
    }
    return hit && !compared ? "false hit, " + literal(rec) : wrong;
}

/// Can double_double not decide about a crossing, or whether it is in the window?
template <class Shape>
bool undecided(const probe<Shape>& p) {
    using T = number_t<Shape>;
    for (const crossing<double_double>& c : all_crossings<double_double>(p.shape, p.ray)) {
        const oracle t = exactly(c.t), error = exactly(c.error);
        const T low = rounded<T>(t - error), high = rounded<T>(t + error);
        const auto between = [&](T end) { return low <= end && end <= high; };
        const bool on_an_end = low != high && (between(p.t_min) || between(p.t_max));
        if (!c.certain || on_an_end) return true;
    }
    return false;
}

/// May the answer be another one? Only if double_double cannot decide, and of floats only if these ask for more digits.
template <class Shape>
bool is_excused(const probe<Shape>& p) {
    return undecided(p) && (!std::same_as<number_t<Shape>, float> || asks_for_more_digits(p));
}

/// The line has the same crossings the other way: the first one back is the last one before the ray begins, unless
/// double_double cannot decide about that. Of a double, t need be the same to the errors that are stated only.
template <class Shape>
std::string unlike_the_other_way(const probe<Shape>& p) {
    using T = number_t<Shape>;
    hit_record<T> rec{};
    const bool hit = p.shape.hit({p.ray.origin, -p.ray.direction}, T(0), infinity<T>, rec);
    const T last = hit ? -rec.t : -infinity<T>;
    T low = last, high = last;
    if constexpr (detail::keeps_all_digits<T>) {
        const ray<T> back{p.ray.origin, -p.ray.direction};
        stated_errors<Shape> errors(p.shape, p.ray), errors_back(p.shape, back);
        const oracle off = hit ? oracle(errors.at(oracle(last)) + errors_back.at(oracle(rec.t))) : oracle(0);
        if (hit && isfinite(off)) low = rounded<T>(last - off), high = std::min(rounded<T>(last + off), T(0));
    }
    const probe<Shape> there{p.shape, p.ray, low, high},
        later{p.shape, p.ray, hit ? std::nextafter(high, infinity<T>) : last, T(0)};
    const bool lost = hit && !there.hit(rec), another = later.hit(rec);
    if ((!lost && !another) || (!std::same_as<T, float> && undecided(there))) return "";
    return lost ? "not hit the other way, t = " + literal(last) : "hit this way only, " + literal(rec);
}

/// Rays of whole numbers that run all but along an axis or across one, from points that all but lie on it: numbers of
/// theirs that were zero are 2^-20 to 2^-140. At an edge, or of a tangent, two doubles may take that for zero, but not
/// elsewhere: what they hit lies on the surface, or all but so. (Where a shape is thinner than a point's digits, the
/// subject may not be able to say how far from it that is, so its own numbers stay.)
template <class Shape>
void check_nothing_is_hit_beside(int rays) {
    using T = number_t<Shape>;
    using exact_shape = decltype(converted<oracle>(std::declval<Shape>()));
    random_numbers random(3);
    const auto tilt = [&](T& x) {
        if (x != T(0) || !random.one_in(2)) return;
        x = std::copysign(std::ldexp(T(1), -random.integer(20, 140)), random.one_in(2) ? T(1) : T(-1));
    };
    for (int i = 0; i < rays; ++i) {
        probe<Shape> p = lattice_probe<Shape>(random);
        for_each_number(p.ray.direction, tilt);
        if (random.one_in(3)) for_each_number(p.ray.origin, tilt);
        hit_record<T> rec{};
        if (!p.hit(rec)) continue;
        const vec3<oracle> at(rec.point);
        const oracle off = abs(oracle(subject<exact_shape>::distance(converted<oracle>(p.shape), at)));
        if (off < (1 + norm1(at)) * 0x1p-10) continue;
        FAIL(literal(p) << " is hit beside its surface, " << literal(rec));
    }
}

/// The same of a root of a polynomial that had to be expanded first.
inline constexpr double ulp_of_roots = 1000;

/// Sends rays in numbers. A few are excused: of doubles mostly rays from a point of the surface, rounded to double,
/// whose t is below 1e-16 of its size.
/// \param excusable_doubles  part of the rays
/// \param ordinary_ulp       how far t may be off where the numbers given do not amplify their own roundings
template <class Shape>
void check_accuracy(int rays, double excusable_doubles = 1e-3, double ordinary_ulp = 4) {
    using T = number_t<Shape>;
    const double excusable = std::same_as<T, float> ? 1e-4 : excusable_doubles;
    int excused = 0;
    worst_errors worst;
    for_random_probes<Shape>("as exact arithmetic", rays, [&](const probe<Shape>& p, random_numbers&) -> std::string {
        const std::string wrong = inexactness(p, worst) + unlike_the_other_way(p);
        if (wrong.empty() || !is_excused(p)) return wrong;
        ++excused;
        return "";
    });
    MESSAGE(rays << " rays, " << worst.hits << " hits, t off by up to " << worst.beyond_stated
                 << " ulp more than stated, than the numbers given explain by " << worst.beyond_input << ", "
                 << worst.vague << " points vague, undecided: " << excused);
    CHECK(worst.beyond_input <= ordinary_ulp);
    CHECK(worst.hits > rays / 20);
    const double may_be_vague = detail::keeps_all_digits<T> ? 0.4 : 0.2;
    CHECK(worst.vague <
          with_chance(worst.hits * may_be_vague));  // most are of doubles and of rays that run all but in a plane
    CHECK(excused < with_chance(rays * excusable));
    using exact_shape = decltype(converted<oracle>(std::declval<Shape>()));
    if constexpr (requires(exact_shape s, vec3<oracle> p) { subject<exact_shape>::distance(s, p); }) {
        check_nothing_is_hit_beside<Shape>(rays);
    }
}

/// How far t is from that of the nearest crossing. Its place in the list does not tell which one it is: of a quadric
/// one precision leaves out an end that is out of reach, another lists it first.
inline oracle away(const std::vector<crossing<oracle>>& exact, const oracle& t) {
    oracle least = infinity<oracle>;
    for (const crossing<oracle>& c : exact) {
        if (c.exists) least = min(least, t == c.t ? oracle(0) : abs(t - c.t));
    }
    return least;
}

/// In the precision of W: there are as many crossings as are certain, and no more than may be; and the t of those that
/// are certain is off by no more than the error that it states.
template <class W>
std::string wrong_bound(const std::vector<crossing<W>>& found, const std::vector<crossing<oracle>>& exact) {
    if (found.size() != exact.size() && !std::ranges::all_of(found, &crossing<W>::certain)) return "";
    const auto there = std::ranges::count_if(exact, &crossing<oracle>::exists);
    if (std::ranges::count_if(found, [](const auto& c) { return c.certain && c.exists; }) > there) {
        return "certain of a false hit";
    }
    if (std::ranges::count_if(found, [](const auto& c) { return !c.certain || c.exists; }) < there) {
        return "certain of a false miss";
    }
    for (const crossing<W>& c : found) {
        if (!c.certain || !c.exists) continue;
        const oracle off = away(exact, exactly(c.t)), error = exactly(c.error);
        if (!(off <= error))
            return "off by " + literal(rounded<double>(off)) + ", said " + literal(rounded<double>(error));
    }
    return "";
}

/// The line of a ray in doubles, which know what they were rounded from.
inline mapped_line<strict_double> rounded_line(const ray<double_double>& ray) {
    const auto rounded = [](const vec3<double_double>& v) {
        const strict_double x(v.x), y(v.y), z(v.z);
        return bounded_vector<strict_double>{x, y, z, (abs(x) + abs(y) + abs(z)) * strict_double(0x1p-53)};
    };
    return {rounded(ray.origin), rounded(ray.direction)};
}

template <class Shape>
void check_bounds_of_errors(int rays) {
    for_random_probes<Shape>("bounds of errors", rays, [&](const probe<Shape>& p, random_numbers& random) {
        const ray<double_double> fine_ray = with_more_digits(p.ray, random);
        const std::vector exact = exact_crossings(p.shape, p.ray), exact_of_fine = exact_crossings(p.shape, fine_ray);
        std::string wrong;
        const auto complain = [&](const std::string& in, const std::string& about) {
            if (!about.empty()) wrong += (wrong.empty() ? "" : "; ") + in + ": " + about;
        };
        complain("strict_double", wrong_bound(all_crossings<strict_double>(p.shape, p.ray), exact));
        complain("double_double", wrong_bound(all_crossings<double_double>(p.shape, p.ray), exact));
        complain("a mapped line", wrong_bound(crossings_along(p.shape, rounded_line(fine_ray)), exact_of_fine));
        return wrong;
    });
}

/// Is the recorded normal across the surface? A step along it leads away from there; one across it hardly does, if it
/// is too short to notice how the surface bends. (Where that has no normal, any step leads away.)
template <class Shape>
bool is_across(const Shape& shape, const vec3<oracle>& point, const vec3<oracle>& normal, const oracle& step) {
    const auto away = [&](const vec3<oracle>& direction) {
        return oracle(abs(subject<Shape>::distance(shape, point + direction * step)));
    };
    const frame<oracle> f = frame_about(normal);
    return away(f.x) + away(f.y) < oracle(1e-3) * away(normal);
}

/// The oracle itself, asked in other words than the shape's own: what it crosses lies on the surface, a line through a
/// point inside crosses before it and behind it, and its normals are across the surface. It is the same one for floats,
/// which are doubles.
template <class Shape>
void check_oracle() {
    if constexpr (!std::same_as<number_t<Shape>, double>) return;
    using exact_shape = decltype(converted<oracle>(std::declval<Shape>()));
    random_numbers random(1);
    int normals = 0, beside = 0;
    for (int i = 0; i < at_least(500); ++i) {
        const probe<Shape> p = scattered_probe<Shape>(random);
        const exact_shape shape = converted<oracle>(p.shape);
        const vec3<oracle> inside(subject<Shape>::inner_point(p.shape, random)), direction(random.direction());
        bool before = false, behind = false;
        for (const crossing<oracle>& c : all_crossings<oracle>(shape, {inside, direction})) {
            if (!c.exists) continue;
            before = before || c.t <= 0;
            behind = behind || c.t >= 0;
            const vec3<oracle> point = inside + direction * c.t;
            const oracle off = abs(oracle(subject<exact_shape>::distance(shape, point)));
            if (!(off <= (abs(c.t) + length(inside)) * 1e-38)) FAIL("off the surface: " << literal(p.shape));
            const vec3<oracle> normal = exact_normal(shape, ray<oracle>{inside, direction}, c);
            ++normals, beside += !is_across(shape, point, normal, oracle((abs(c.t) + norm1(inside)) * 1e-24));
        }
        if (!(solid<Shape> ? before && behind : before || behind)) FAIL("left out: " << literal(p.shape));
    }
    MESSAGE(normals << " normals, " << beside << " not across");
    CHECK(beside < with_chance(normals * 0.02));  // tips of thorns, which have none
}

}  // namespace raio::test
