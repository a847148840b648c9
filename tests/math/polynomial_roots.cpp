#include <raio/math/polynomial_roots.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "support/dual.hpp"
#include "support/oracle.hpp"
#include "support/random.hpp"

namespace raio::test {

inline oracle exactly(const oracle& x) { return x; }

/// The nearest W.
template <class W>
W nearest(const oracle& x) {
    if constexpr (std::same_as<W, oracle>) {
        return x;
    } else {
        const double high = rounded<double>(x);
        if constexpr (!std::same_as<W, double_double>) return W(high);
        return W(high) + W(rounded<double>(x - oracle(high)));
    }
}

/// The product of `leading` and all t - root, each coefficient rounded to W.
template <class W, std::size_t N>
polynomial<W, N> with_roots(const oracle& leading, const std::vector<oracle>& roots) {
    std::array<oracle, N + 1> product{};
    product[0] = leading;
    for (std::size_t degree = 0; degree < roots.size(); ++degree) {
        for (std::size_t k = degree + 1; k > 0; --k) product[k] = product[k - 1] - roots[degree] * product[k];
        product[0] *= -roots[degree];
    }
    polynomial<W, N> p;
    for (std::size_t k = 0; k <= N; ++k) {
        p.coefficient[k] = nearest<W>(product[k]);
        const oracle off = abs(product[k] - exactly(p.coefficient[k]));
        p.error[k] = bound_t<W>(nearest<bound_t<W>>(off * 2));
    }
    return p;
}

/// The polynomial with each coefficient off by that part of it, or less, as its errors say (rounded up, for adding them
/// takes three roundings).
template <class W, std::size_t N>
polynomial<W, N> blurred(polynomial<W, N> p, double part, random_numbers& random) {
    using E = bound_t<W>;
    for (std::size_t k = 0; k <= N; ++k) {
        const double off = part * (random.one_in(4) ? random.uniform(-1, 1) : random.one_in(2) ? -1 : 1);
        p.error[k] = (p.error[k] + (E(part) + E(2 * unit_roundoff<W>)) * E(abs(p.coefficient[k]))) * E(1 + 0x1p-51);
        p.coefficient[k] += p.coefficient[k] * W(off);
    }
    return p;
}

/// What is wrong with the roots that were found of a polynomial with these.
template <std::size_t N, class W>
std::string wrong_roots(const polynomial_roots<W, N>& found, std::vector<oracle> roots, const oracle& low,
                        const oracle& high) {
    std::sort(roots.begin(), roots.end());
    std::erase_if(roots, [&](const oracle& root) { return root < low || root > high; });
    const auto& places = found.places;
    for (std::size_t i = 0; i + 1 < found.count; ++i) {
        if (!(places[i].t <= places[i + 1].t)) return "not in order";
    }
    if (found.certain && found.count != roots.size()) return "certain of a wrong number of roots";
    std::size_t meant = 0;
    for (std::size_t i = 0; i < found.count; ++i) {
        const oracle t = exactly(places[i].t), error = exactly(places[i].error);
        if (t < low || t > high) return "beyond the interval";
        std::size_t near = 0;
        for (const oracle& root : roots) near += abs(root - t) <= error;
        if (places[i].sign_before * places[i].sign_after < 0 && near == 0) return "off by more than its error";
    }
    for (const oracle& root : roots) {
        for (std::size_t i = 0; i < found.count; ++i) {
            if (abs(root - exactly(places[i].t)) <= exactly(places[i].error)) {
                ++meant;
                break;
            }
        }
    }
    return meant == roots.size() ? "" : "lost " + std::to_string(roots.size() - meant) + " roots";
}

template <class W, std::size_t N>
polynomial_roots<W, N> found_roots(const std::vector<oracle>& roots, double low, double high) {
    const polynomial_roots<W, N> found = roots_between(with_roots<W, N>(oracle(1), roots), W(low), W(high));
    CHECK(wrong_roots<N, W>(found, roots, oracle(low), oracle(high)) == "");
    return found;
}

TEST_CASE_TEMPLATE("polynomial_roots: roots far apart are certain, and each is found", W, strict_double, double_double,
                   oracle) {
    CHECK(found_roots<W, 1>({3}, -10, 10).certain);
    CHECK(found_roots<W, 2>({-3, 3}, -10, 10).certain);
    CHECK(found_roots<W, 3>({-3, 0.5, 3}, -10, 10).certain);
    CHECK(found_roots<W, 4>({-3, -1, 2, 7}, -10, 10).certain);
    CHECK(found_roots<W, 8>({-9, -7, -5, -3, 1, 2, 4, 8}, -10, 10).certain);
    CHECK(found_roots<W, 4>({-3, -1, 2, 7}, 0, 5).count == 1);
    CHECK(found_roots<W, 4>({-3, -1, 2, 7}, 3, 5).count == 0);
    CHECK(found_roots<W, 4>({-3, -1, 2, 7}, 3, 5).certain);
}

TEST_CASE_TEMPLATE("polynomial_roots: the signs to both sides of two roots", W, strict_double, double_double, oracle) {
    for (const int leading : {1, -1}) {
        const auto roots = roots_between(with_roots<W, 2>(leading, {1, 3}), W(0), W(4));
        REQUIRE((roots.certain && roots.count == 2));
        CHECK((roots.places[0].sign_before == leading && roots.places[0].sign_after == -leading));
        CHECK((roots.places[1].sign_before == -leading && roots.places[1].sign_after == leading));
        CHECK(roots_between(with_roots<W, 2>(leading, {1, 3}), W(2), W(4)).begin()->sign_before == -leading);
        CHECK(roots_between(with_roots<W, 2>(leading, {1, 3}), W(4), W(5)).count == 0);
    }
}

TEST_CASE_TEMPLATE("polynomial_roots: of no degree that it could have", W, strict_double, double_double, oracle) {
    CHECK(found_roots<W, 4>({-3, 5}, -10, 10).count == 2);
    CHECK(found_roots<W, 8>({-3, 0, 5}, -10, 10).count == 3);
    CHECK(found_roots<W, 2>({5}, -10, 10).count == 1);
    CHECK(found_roots<W, 4>({}, -10, 10).count == 0);
    CHECK(found_roots<W, 1>({}, -10, 10).certain);
}

TEST_CASE_TEMPLATE("polynomial_roots: no roots", W, strict_double, double_double, oracle) {
    const polynomial<W, 2> above{{W(1), W(0), W(1)}};
    CHECK(roots_between(above, W(-10), W(10)).count == 0);
    CHECK(roots_between(above, W(-10), W(10)).certain);
    const polynomial<W, 4> quartic{{W(1), W(0), W(-1), W(0), W(1)}};
    CHECK(roots_between(quartic, W(-10), W(10)).count == 0);
    CHECK(roots_between(quartic, W(-10), W(10)).certain);
}

TEST_CASE_TEMPLATE("polynomial_roots: roots of higher multiplicity are places that are not certain", W, strict_double,
                   double_double, oracle) {
    const double wide = 1e-6;
    const auto of_two = found_roots<W, 4>({-2, 3, 3, 5}, -10, 10);
    CHECK(of_two.count == 3);
    CHECK(!of_two.certain);
    CHECK((of_two.places[1].sign_before == -1 && of_two.places[1].sign_after == -1));
    CHECK((of_two.places[0].sign_before == 1 && of_two.places[0].sign_after == -1));
    CHECK(of_two.places[1].error < bound_t<W>(wide));
    // An extremum is as sharp as any root.
    CHECK(abs(exactly(of_two.places[1].t) - 3) < oracle(64 * unit_roundoff<W>));

    const auto of_three = found_roots<W, 4>({-2, 3, 3, 3}, -10, 10);
    CHECK(of_three.count == 2);
    CHECK((of_three.places[1].sign_before == -1 && of_three.places[1].sign_after == 1));

    const auto two_of_two = found_roots<W, 4>({-2, -2, 3, 3}, -10, 10);
    CHECK(two_of_two.count == 2);
    CHECK((two_of_two.places[0].sign_after == 1 && two_of_two.places[1].sign_before == 1 &&
           two_of_two.places[1].sign_after == 1));

    CHECK(found_roots<W, 8>({3, 3, 3, 3, 3, 3, 3, 3}, -10, 10).count == 1);
    CHECK(found_roots<W, 4>({0, 0, 0, 0}, -10, 10).count == 1);
    CHECK(found_roots<W, 2>({0, 0}, -10, 10).places[0].t == W(0));
}

TEST_CASE_TEMPLATE("polynomial_roots: of numbers whose squares are 0 (a step of 0 was taken for the last)", W,
                   strict_double, double_double) {
    for (int exponent = -560; exponent < -500; ++exponent) {
        const W unit(std::ldexp(1.0, exponent));  // (t + 1/64) (t - 1/4) (t - 1/2), as small
        const std::array<double, 3> roots{-0x1p-6, 0.25, 0.5};
        const auto tiny =
            roots_between<W, 3>({{unit * W(0x1p-9), unit * W(29 * 0x1p-8), unit * W(-47 * 0x1p-6), unit}}, W(-1), W(1));
        REQUIRE((tiny.count == 3 && tiny.certain));
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(abs(tiny.places[i].t - W(roots[i])) <= W(tiny.places[i].error));
            CHECK(tiny.places[i].error < bound_t<W>(0x1p-40));
        }
    }
}

TEST_CASE("polynomial_roots: a clear sign between two roots is no end of the place where they are taken for one") {
    const std::vector<oracle> roots{oracle("-7.6796936445700136886"), oracle("-7.6790678929735308383"),
                                    oracle("-5.4515112847240505545"), oracle("-5.4511287388667622628"),
                                    oracle("-5.450421413275354297"),  oracle("4.4826356109457954346")};
    random_numbers random(77);
    for (int i = 0; i < at_least(1000); ++i) {  // the place is looked for from other sides
        const double high = random.log_uniform(10, 1e12);
        const auto p = with_roots<strict_double, 8>(oracle(0x1.115bd0459cb54p+3), roots);
        const auto found = roots_between(p, strict_double(-high), strict_double(high));
        REQUIRE(wrong_roots<8, strict_double>(found, roots, oracle(-high), oracle(high)) == "");
    }
}

/// The slope there, of which the noise is a part, would have it anywhere.
TEST_CASE_TEMPLATE("polynomial_roots: a root that is all but triple is as near as the third root of the noise", W,
                   strict_double, double_double) {
    const double noise = 64 * unit_roundoff<W>;
    for (const double slope : {1e-60, 1e-40, 1e-33}) {
        const polynomial<W, 3> p{{W(0), W(-slope), W(0), W(-50)}, {noise}};
        const auto found = roots_between(p, W(-0.5), W(0.75));
        REQUIRE((found.certain && found.count == 1));
        const polynomial_root<W>& root = found.places[0];
        CHECK((root.sign_before == 1 && root.sign_after == -1));
        CHECK(std::abs(static_cast<double>(root.t)) <= root.error);
        CHECK(root.error < 4 * std::cbrt(noise));
    }
}

TEST_CASE("polynomial_roots: a turn that is hardly known is as high as it may be") {
    // Of a Bezier curve and a ray, see bezier_curve.hpp. Between the two roots it is no lower than -1.3e-4.
    const polynomial<strict_double, 10> p{{0x1.be7f41f36ed5fp+5, -0x1.ec39e74815d58p+8, 0x1.40b8d37a2209p+11,
                                           -0x1.293501bbab4fap+13, 0x1.966f850515f46p+14, -0x1.a6d4ad4e2a08fp+15,
                                           0x1.4c3d414cf8ec7p+16, -0x1.75ace16e20c64p+16, 0x1.14b1456790f84p+16,
                                           -0x1.db981532d38c8p+14, 0x1.6481ef97898e1p+12}};
    for (const double low : {0x1.c38ef68cd0512p-1, 0x1.c38ef68cd05dp-1, 0.88, 0.9}) {
        const auto found = roots_between(p, strict_double(low), strict_double(1));
        REQUIRE((found.certain && found.count == 2));
        CHECK(static_cast<double>(found.places[0].t) == doctest::Approx(0.9631995).epsilon(1e-6));
        CHECK(static_cast<double>(found.places[1].t) == doctest::Approx(0.9699381).epsilon(1e-6));
    }
}

TEST_CASE_TEMPLATE("polynomial_roots: a turn where a root is looked for is no root", W, strict_double, double_double,
                   oracle) {
    // The first of them turns at 1/4, where Halley's step is 0, and the other one at 1.
    const std::array<polynomial<W, 6>, 2> turning{polynomial<W, 6>{{4, -60, 309, -802, 1122, -798, 228}, {}},
                                                  polynomial<W, 6>{{20, -72, 84, -32, 108, -240, 128}, {}}};
    for (const polynomial<W, 6>& p : turning) {
        const auto roots = roots_between(p, W(0), W(1));
        CHECK(roots.certain);
        CHECK(roots.count > 0);
        for (const polynomial_root<W>& root : roots) {
            CHECK(root.error < bound_t<W>(1e-11));
            CHECK(p(root.t - W(root.error)) * p(root.t + W(root.error)) < W(0));
        }
    }
}

TEST_CASE_TEMPLATE("polynomial_roots: a root in the middle of where a turn is enclosed is certain as well", W,
                   strict_double, double_double, oracle) {
    const auto found = roots_between(polynomial<W, 5>{{0, -625, 0, 0, 0, 1}}, W(-10), W(10));
    REQUIRE((found.certain && found.count == 3));
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(abs(exactly(found.places[i].t) - (5 * static_cast<int>(i) - 5)) <= exactly(found.places[i].error));
    }
}

TEST_CASE_TEMPLATE("polynomial_roots: only the first root beyond a place", W, strict_double, oracle) {
    using E = bound_t<W>;
    const auto p = with_roots<W, 4>(1, {-3, -1, 2, 7});
    const auto found = [&](double before, double from, double to) {
        return roots_between(p, W(-10), W(10), {E(before), E(from), E(to)});
    };
    const double nowhere = -infinity<double>;
    const auto is_at = [](const polynomial_root<W>& root, double t) {
        return root.sign_before * root.sign_after < 0 && abs(exactly(root.t) - t) <= exactly(root.error);
    };

    const auto second = found(nowhere, -2, nowhere);
    REQUIRE((second.certain && second.count == 2));
    CHECK((is_at(second.places[0], -3) && is_at(second.places[1], -1)));
    CHECK(exactly(second.places[1].error) < oracle(1e-12));
    CHECK(found(nowhere, 9, nowhere).count == 4);
    // A place within the error of a root may be beyond it.
    CHECK(roots_between(p, W(-10), W(10), {E(nowhere), E(second.places[1].t), E(nowhere)}).count == 3);

    // Which roots end before a place the roots' enclosures say, so that one beside it may be found all the same.
    const auto last = found(6, 6.5, nowhere);
    REQUIRE((last.certain && last.count >= 1 && last.count <= 2));
    CHECK(is_at(last.places[last.count - 1], 7));

    const auto rough = found(nowhere, -11, 11);
    REQUIRE((rough.certain && rough.count == 1 && is_at(rough.places[0], -3)));
    CHECK(exactly(rough.places[0].error) > oracle(1e-3));
    const auto sharp = found(nowhere, -11, -3 + 1e-9);
    REQUIRE((sharp.certain && sharp.count == 1 && is_at(sharp.places[0], -3)));
    CHECK(exactly(sharp.places[0].error) < oracle(1e-12));
}

/// What is wrong with the roots that were found if only the first beyond a place is wanted.
template <std::size_t N, class W>
std::string wrong_first(const polynomial_roots<W, N>& found, std::vector<oracle> roots, const wanted_roots<W>& wanted,
                        const oracle& low, const oracle& high) {
    const auto end = [&](const polynomial_root<W>& r, int side) { return exactly(r.t) + side * exactly(r.error); };
    std::erase_if(roots, [&](const oracle& root) { return root < low || root > high; });
    std::sort(roots.begin(), roots.end());
    bool beyond = false;
    std::size_t next = 0;  // of the roots that were not found
    for (const polynomial_root<W>& place : found) {
        if (beyond) return last_precision<W> ? "" : "one after the first";
        while (next < roots.size() && roots[next] < end(place, -1)) {
            if (roots[next] >= exactly(wanted.before)) return "lost one";
            ++next;
        }
        if (next == roots.size() || roots[next] > end(place, 1)) return "off by more than its error";
        ++next;
        beyond = end(place, -1) > exactly(wanted.from);
        if (exactly(place.error) > oracle(1e-2) && !(beyond && end(place, 1) < exactly(wanted.to)))
            return "rough where that was not wanted";
    }
    if (!beyond && next < roots.size() && roots.back() >= exactly(wanted.before)) return "lost the last";
    return "";
}

TEST_CASE_TEMPLATE("polynomial_roots: the first root beyond a place is the same as among all", W, strict_double,
                   double_double) {
    using E = bound_t<W>;
    random_numbers random(8);
    int complaints = 0, certain = 0;
    for (int i = 0; i < test_rays / 20; ++i) {
        std::vector<oracle> roots;
        for (int n = random.integer(0, 6); n > 0; --n) roots.push_back(oracle(random.uniform(-10, 10)));
        const double from = random.uniform(-11, 11), to = random.one_in(2) ? from : random.uniform(from, 12);
        const double before = random.one_in(2) ? -infinity<double> : from - random.log_uniform(1e-9, 1);
        const wanted_roots<W> wanted{E(before), E(from), E(to)};
        const auto found = roots_between(with_roots<W, 6>(1, roots), W(-10), W(10), wanted);
        if (!found.certain) continue;
        ++certain;
        const std::string wrong = wrong_first<6, W>(found, roots, wanted, oracle(-10), oracle(10));
        if (wrong.empty() || ++complaints > 3) continue;
        std::string text;
        for (const oracle& root : roots) text += ' ' + root.str(20);
        FAIL_CHECK(wrong << ", before " << before << ", from " << from << ", to " << to << ":" << text);
    }
    CHECK(complaints == 0);
    CHECK(certain > test_rays / 25);
}

TEST_CASE("polynomial_roots: the last precision finds the same, whichever is wanted (a torus was missed in [t, t])") {
    using W = double_double;
    random_numbers random(9);
    int wanted = 0;
    for (int i = 0; i < test_rays / 20; ++i) {
        // Two roots close to each other are told from one, or not, in more ways than one.
        const double root = random.uniform(-1, 1), apart = random.log_uniform(1e-18, 1e-3);
        const std::vector<oracle> roots{oracle(root), oracle(root) + apart, oracle(random.uniform(-1, 1)),
                                        oracle(random.uniform(-1, 1))};
        const auto p = with_roots<W, 4>(1, roots);
        const auto all = roots_between(p, W(-2), W(2));
        const strict_double from(random.uniform(-2, 2)), before = random.one_in(2) ? -infinity<strict_double> : from;
        for (const polynomial_root<W>& one : roots_between(p, W(-2), W(2), {before, from})) {
            ++wanted;
            REQUIRE(std::ranges::any_of(all, [&](const auto& r) { return r.t == one.t && r.error == one.error; }));
        }
    }
    CHECK(wanted > test_rays / 20);
}

TEST_CASE_TEMPLATE("polynomial_roots: a root at the end of the interval is not certain", W, strict_double,
                   double_double) {
    CHECK(!found_roots<W, 4>({-3, -1, 2, 7}, -1, 5).certain);
    CHECK(!found_roots<W, 4>({-3, -1, 2, 7}, -2, 7).certain);
}

/// Roots that are spread evenly, in clusters, equal, or over 24 orders of magnitude.
template <std::size_t N>
std::vector<oracle> random_roots(random_numbers& random) {
    std::vector<oracle> roots;
    const int kind = random.integer(0, 4);
    const double apart = random.log_uniform(1e-12, 1e-1);
    for (std::size_t n = static_cast<std::size_t>(random.integer(0, N)); roots.size() < n;) {
        if (kind >= 2 && !roots.empty() && random.one_in(2)) {
            roots.push_back(kind == 2 ? roots.back() : roots.back() + random.uniform(-apart, apart));
        } else {
            const double sign = random.one_in(2) ? -1 : 1;
            roots.push_back(oracle(kind == 1 ? sign * random.log_uniform(1e-12, 1e12) : random.uniform(-10, 10)));
        }
    }
    return roots;
}

/// Is a root that is as far from others as from 0 known less well than to some hundred times of what the noise makes of
/// it?
template <class W, std::size_t N>
bool rough_root(const polynomial_roots<W, N>& found, const polynomial<W, N>& p, const oracle& leading,
                const std::vector<oracle>& roots, double length) {
    const oracle u = unit_roundoff<W>;
    for (const polynomial_root<W>& place : found) {
        const oracle t = exactly(place.t), noise = exactly(p.noise()(bound_t<W>(abs(place.t))));
        const auto nearer = [&](const oracle& a, const oracle& b) { return abs(a - t) < abs(b - t); };
        const auto nearest = std::ranges::min_element(roots, nearer);
        oracle slope = leading, apart = length;
        for (auto other = roots.begin(); other != roots.end(); ++other) {
            if (other == nearest) continue;
            slope *= *other - *nearest;
            apart = min(apart, abs(*other - *nearest));
        }
        const oracle off = noise / abs(slope);
        if (off < apart / 1000 && abs(t) < 2 * apart && exactly(place.error) > 200 * (off + u * (abs(t) + u * length)))
            return true;
    }
    return false;
}

/// What is wrong if the roots are looked for as those of a derivative are, of which also the height has to be known: up
/// to a root, the polynomial must not be larger than the place says that the root alone belongs to.
template <class W, std::size_t N>
std::string wrong_turns(const polynomial<W, N>& p, const oracle& leading, const std::vector<oracle>& roots, double low,
                        double high, double tolerance) {
    using E = bound_t<W>;
    polynomial_roots<W, N> found;
    found.certain = false;
    const detail::root_finder<W, N> finder(p, W(low), W(high));
    finder.template find<true>(E(tolerance), E(tolerance), [&](const detail::enclosure<W>&, auto approached) {
        found.places[found.count++] = approached();
        return true;
    });
    for (const oracle& root : roots) {
        const auto has_root = [&](const auto& place) { return abs(root - exactly(place.t)) <= exactly(place.error); };
        const auto place = std::ranges::find_if(found, has_root);
        if (root < low || root > high || std::ranges::count_if(found, has_root) != 1) continue;
        for (const double part : {0.0, 0.25, 0.5, 0.75}) {
            const oracle x = exactly(place->t) + (root - exactly(place->t)) * part;
            oracle height = leading;
            for (const oracle& other : roots) height *= x - other;
            if (abs(height) > exactly(place->height)) return "higher than it says";
        }
    }
    return wrong_roots<N, W>(found, roots, oracle(low), oracle(high));
}

template <class W, std::size_t N>
void check_random_roots(int count, int least_certain) {
    random_numbers random(N);
    int complaints = 0, certain = 0;
    for (int i = 0; i < count; ++i) {
        const std::vector<oracle> roots = random_roots<N>(random);
        double high = random.log_uniform(1, 1e13), low = random.one_in(2) ? -high : random.uniform(-5, 0.5);
        if (random.one_in(4) && !roots.empty()) {  // an end beside a root
            const double end = rounded<double>(roots[0]) * (1 + random.uniform(-1, 1) * random.log_uniform(1e-17, 0.1));
            (end < low / 2 + high / 2 ? low : high) = end;
        }
        const oracle leading((random.one_in(2) ? -1 : 1) * random.log_uniform(1e-3, 1e3));
        auto p = with_roots<W, N>(leading, roots);
        if (random.one_in(3)) p = blurred(p, random.log_uniform(1e-20, 1e-1), random);
        const polynomial_roots<W, N> found = roots_between(p, W(low), W(high));
        certain += found.certain;
        std::string wrong = wrong_roots<N, W>(found, roots, oracle(low), oracle(high));
        if (wrong.empty() && found.certain && rough_root<W, N>(found, p, leading, roots, high - low))
            wrong = "rougher than the noise";
        const double tolerance = random.one_in(2) ? 0x1p-7 : detail::last_step<W>;
        if (wrong.empty()) wrong = wrong_turns(p, leading, roots, low, high, tolerance);
        if (wrong.empty() || ++complaints > 3) continue;
        std::string text;
        for (const oracle& root : roots) text += ' ' + root.str(20);
        FAIL_CHECK("degree " << N << ": " << wrong << ", [" << low << ", " << high << "]:" << text);
    }
    CHECK(complaints == 0);
    MESSAGE("degree " << N << ": " << certain << " of " << count << " certain");
    CHECK(certain > count * least_certain / 100);
}

TEST_CASE("polynomial_roots: no root is lost or invented, and each is as near as is said") {
    const int count = test_rays / 10;
    check_random_roots<strict_double, 2>(count, 50);
    check_random_roots<strict_double, 3>(count, 50);
    check_random_roots<strict_double, 4>(count, 50);
    check_random_roots<strict_double, 8>(count, 20);
    check_random_roots<double_double, 2>(count / 4, 50);
    check_random_roots<double_double, 3>(count / 4, 50);
    check_random_roots<double_double, 4>(count / 4, 50);
    check_random_roots<double_double, 8>(count / 4, 20);
}

TEST_CASE("polynomial_roots: the derivatives of a root, by a number that carries them along") {
    // t^2 - a t + b at a = 7, b = 12: the roots 3 and 4.
    const dual a = dual::variable(7, 0), b = dual::variable(12, 1);
    const auto found = roots_between(polynomial<dual, 2>{{b, -a, dual(1)}}, dual(0), dual(10));
    REQUIRE(found.count == 2);
    CHECK(found.places[0].t.value == doctest::Approx(3));
    CHECK(found.places[0].t.slope[0] == doctest::Approx(-3));  // t / (2 t - a)
    CHECK(found.places[0].t.slope[1] == doctest::Approx(1));   // -1 / (2 t - a)
    CHECK(found.places[1].t.slope[0] == doctest::Approx(4));
    CHECK(found.places[1].t.slope[1] == doctest::Approx(-1));
}

TEST_CASE_TEMPLATE("polynomial_roots: what is not finite has no roots, and that is not certain", W, strict_double,
                   double_double) {
    const double huge = 1e308, none = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {infinity<double>, none, huge}) {
        for (std::size_t place = 0; place < 3; ++place) {
            polynomial<W, 2> p{{W(-1), W(0), W(1)}};
            p.coefficient[place] = W(bad);
            const auto found = roots_between(p, W(-10), W(10));
            CHECK((found.count == 0 && !found.certain));
        }
    }
    const polynomial<W, 2> p{{W(-1), W(0), W(1)}};
    CHECK(roots_between(p, W(none), W(10)).count == 0);
    CHECK(roots_between(p, W(1), W(-1)).count == 0);
    CHECK(roots_between(p, W(-10), W(infinity<double>)).count == 0);
}

#if defined(__GNUC__) && !defined(__clang__)  // whose square root is constexpr
constexpr auto cubic = roots_between(polynomial<double_double, 3>{{0, -1, 0, 1}}, double_double(-2), double_double(2));
static_assert(cubic.certain && cubic.count == 3);
#endif

}  // namespace raio::test
