#include <raio/proof/settle.hpp>

#include "support/bounds.hpp"

namespace raio::test {

using W = strict_double;
using X = double_double;

namespace {

const ray<float> any_float{{0, 0, 0}, {0, 0, 1}};
const ray<double> any_double{{0, 0, 0}, {0, 0, 1}};

template <class T>
const ray<T>& any() {
    if constexpr (std::same_as<T, float>) {
        return any_float;
    } else {
        return any_double;
    }
}

/// A crossing that each precision puts elsewhere: who was asked can be seen from the answer.
template <class Number>
crossing<Number> at(double t, double error = 0) {
    return {true, true, Number(t), bound_t<Number>(error), true};
}

template <class Number>
crossing<Number> unsure(crossing<Number> c) {
    c.certain = false;
    return c;
}

template <class Number>
crossing<Number> none(bool certain = true) {
    return {false, certain, Number(1), bound_t<Number>(0), true};
}

/// A shape that says just these are its crossings: at 2 and 6 if nothing else is said, at 3 and 7 if asked in more
/// digits.
template <class T>
struct told {
    using number = T;

    chord<W> quick{at<W>(2), at<W>(6)};
    chord<X> exact{at<X>(3), at<X>(7)};

    template <class Line, class N = typename Line::number>
    chord<N> crossings(const Line&) const {
        if constexpr (std::same_as<N, W>) {
            return quick;
        } else {
            return exact;
        }
    }
    void surface(auto& at) const {
        at.record_point();
        at.record_normal(vec3<T>(0, 0, 1));
        at.record_uv([] { return vec2<T>(0); });
    }

    /// t of the hit; -1 if there is none.
    T hit(T t_min = 0, T t_max = infinity<T>) const {
        struct {
            T t;
        } rec;
        return first_hit(*this, any<T>(), t_min, t_max, rec) ? rec.t : T(-1);
    }
    bool occluded(T t_min = 0, T t_max = infinity<T>) const { return any_hit(*this, any<T>(), t_min, t_max); }
};

/// The same, whose first crossing is its only one.
template <class T>
struct told_of_one : told<T> {
    template <class Line, class N = typename Line::number>
    crossing<N> crossings(const Line& line) const {
        return told<T>::crossings(line).near;
    }
};

/// A shape that has to search, and says with its t how closely it was told to.
template <class T>
struct told_how_closely : told<T> {
    template <class Line, class N = typename Line::number>
    crossing<N> crossings(const Line&) const {
        return at<N>(8);
    }
    template <class Line, class N = typename Line::number>
    crossing<N> crossings(const Line&, const first_from<T>& wanted) const {
        return at<N>(wanted.roughly ? 2 : 4);
    }
};

}  // namespace

// A quicker precision than the last is tried where there is one.
static_assert(detail::works_first<float> && detail::works_first<double> && !detail::works_first<double_double>);

TEST_CASE("settle: what is certain to the last bit of a float is the answer, and all else is asked again") {
    using T = float;
    constexpr T eps = std::numeric_limits<T>::epsilon();
    CHECK(told<T>{}.hit() == 2);
    CHECK(told<T>{}.hit(2, 2) == 2);
    CHECK(told<T>{}.hit(2 + 2 * eps) == 6);
    CHECK(told<T>{}.hit(2 + 2 * eps, 6) == 6);
    CHECK(told<T>{.exact = {none<X>(), none<X>()}}.hit(3, 5) == -1);
    CHECK(told<T>{.quick = {at<W>(2, 0.25), at<W>(6)}}.hit() == 3);
    CHECK(told<T>{.quick = {at<W>(2, 0.25), at<W>(6)}}.hit(2.25) == 3);
    CHECK(told<T>{.quick = {at<W>(2, 0.25), at<W>(6)}}.hit(2.5) == 6);
    CHECK(told<T>{.quick = {at<W>(2), at<W>(6, 0.25)}}.hit(2.5) == 3);
    CHECK(told<T>{.quick = {unsure(at<W>(2)), at<W>(6)}}.hit() == 3);
    CHECK(told<T>{.quick = {none<W>(), at<W>(6)}}.hit() == 6);
    CHECK(told<T>{.quick = {none<W>(false), at<W>(6)}}.hit() == 3);
    CHECK(told<T>{.quick = {none<W>(), none<W>()}}.hit() == -1);
    CHECK(told<T>{.quick = {none<W>(), none<W>(false)}}.hit() == 3);
    CHECK(told<T>{.quick = {at<W>(2, 0.25), at<W>(6)}, .exact = {none<X>(), none<X>()}}.hit() == -1);
    CHECK(told<T>{.quick = {unsure(at<W>(2)), at<W>(6)}, .exact = {none<X>(), none<X>()}}.hit() == -1);
    CHECK(told<T>{.quick = {at<W>(2, 2), at<W>(6)}}.hit(3.5) == 7);
    CHECK(told<T>{.quick = {at<W>(2, 2), at<W>(6)}}.hit(2, 2.5) == -1);
    CHECK(told<T>{.quick = {at<W>(INFINITY), at<W>(INFINITY)}}.hit() == 3);
}

namespace {

/// Whatever is asked, the same t is found, of these two: by `hit` from anywhere on, by `occluded` in no window without
/// it, and by `inside_of`.
template <class Shape>
void check_recorded(const Shape& shape, double first, double second) {
    constexpr double ever = infinity<double>;
    const auto after = [](double t) { return std::nextafter(t, ever); };
    const auto before = [](double t) { return std::nextafter(t, -ever); };
    CHECK(shape.hit(-ever) == first);
    CHECK(shape.hit(first, first) == first);
    CHECK(shape.hit(after(first)) == second);
    CHECK(shape.hit(second, second) == second);
    CHECK(shape.hit(after(second)) == -1);
    CHECK(shape.hit(after(first), before(second)) == -1);
    CHECK(shape.hit(-ever, before(first)) == -1);
    CHECK((shape.occluded(first, first) && shape.occluded(second, second)));
    CHECK((!shape.occluded(-ever, before(first)) && !shape.occluded(after(first), before(second)) &&
           !shape.occluded(after(second))));
    CHECK(inside_of(shape, any_double) == interval<double>{first, second});
}

}  // namespace

TEST_CASE("settle: of a double the quick crossings count that are known, and the exact ones in the place of others") {
    using T = double;
    const auto shared = [](crossing<W> c) {
        c.shared = true;
        return c;
    };
    check_recorded(told<T>{}, 2, 6);
    check_recorded(told<T>{{at<W>(2, 0.25), at<W>(6, 1)}}, 2, 6);  // however far they may be off
    check_recorded(told<T>{{at<W>(-6, 1), at<W>(-2, 1)}}, -6, -2);
    check_recorded(told<T>{{at<W>(0), at<W>(6)}}, 0, 6);
    // It is there, but on which face or side of the origin is not known, or nothing of its t.
    for (const auto& [open, exact] : {std::pair(shared(at<W>(2, 0.5)), 2.25),
                                      {at<W>(0.25, 0.5), 0.5},
                                      {at<W>(-0.25, 0.5), 0.125},
                                      {at<W>(0, 0x1p-1000), 0x1p-1001},
                                      {at<W>(2, NAN), 3.0},
                                      {at<W>(2, INFINITY), 3.0},
                                      {at<W>(INFINITY), 3.0},
                                      {at<W>(NAN), 3.0}}) {
        check_recorded(told<T>{{open, at<W>(6)}, {at<X>(exact), at<X>(7)}}, exact, 6);
        check_recorded(told<T>{{at<W>(-2), open}, {at<X>(-3), at<X>(exact)}}, -2, exact);
    }
    // Where one may not be there, what the next ones are is not known either.
    for (const auto& open : {unsure(at<W>(2)), none<W>(false)}) {
        check_recorded(told<T>{{open, at<W>(6)}}, 3, 7);
        check_recorded(told<T>{{at<W>(2), open}}, 2, 7);
    }
    // One that is beyond the window in any case need not be known: the exact one would be found in it.
    CHECK(told<T>{{at<W>(0.25, 0.5), at<W>(6)}, {at<X>(3), at<X>(7)}}.hit(1) == 6);
    CHECK(told<T>{{at<W>(0.25, 0.5), at<W>(6)}, {at<X>(3), at<X>(7)}}.hit(0.5) == 3);
    CHECK(told<T>{{at<W>(2), shared(at<W>(6, 0.5))}, {at<X>(3), at<X>(4)}}.hit(3, 5) == -1);
    CHECK(told<T>{{none<W>(), at<W>(6)}}.hit() == 6);
    CHECK(told<T>{{none<W>(), none<W>()}}.hit() == -1);
    CHECK(told<T>{{none<W>(), unsure(at<W>(6))}}.hit() == 7);
    CHECK(inside_of(told<T>{{none<W>(), none<W>()}}, any_double).empty());
    CHECK(inside_of(told<T>{{none<W>(false), none<W>()}, {none<X>(), none<X>()}}, any_double).empty());
    // What is certain all the same is there, if the exact one has overflowed.
    const chord<X> overflowed{none<X>(), none<X>()};
    check_recorded(told<T>{{shared(at<W>(2)), at<W>(6)}, overflowed}, 2, 6);
    check_recorded(told<T>{{at<W>(2), shared(at<W>(6))}, overflowed}, 2, 6);
    CHECK(told<T>{{unsure(at<W>(2)), at<W>(6)}, overflowed}.hit() == -1);
}

TEST_CASE_TEMPLATE("settle: where there is one beyond doubt, only its t is asked for", T, float, double) {
    const auto where = [](const crossing<W>& near) {
        hit_record<T> rec{};
        const told_of_one<T> shape{{.quick = {near, at<W>(6)}}};
        return first_hit<detail::question::only_where>(shape, any<T>(), T(0), infinity<T>, rec) ? rec.t : T(-1);
    };
    CHECK(where(at<W>(2)) == 2);
    CHECK(where(unsure(at<W>(2))) == 2);
    CHECK(where(none<W>(false)) == 1);
    CHECK(where(at<W>(2, 0.25)) == (std::same_as<T, float> ? 3 : 2));
    CHECK(where(at<W>(0.25, 0.5)) == 3);
    CHECK(where(at<W>(INFINITY)) == 3);
}

TEST_CASE("settle: a shape that has to search is told whether t of a float is asked for, and never of a double") {
    hit_record<float> rec{};
    CHECK((first_hit(told_how_closely<float>{}, any_float, 0.0f, infinity<float>, rec) && rec.t == 4));
    CHECK(any_hit(told_how_closely<float>{}, any_float, 1.0f, 3.0f));
    hit_record<double> rec_of_double{};
    CHECK((first_hit(told_how_closely<double>{}, any_double, 0.0, infinity<double>, rec_of_double) &&
           rec_of_double.t == 8));
    CHECK(any_hit(told_how_closely<double>{}, any_double, 8.0, 8.0));
}

TEST_CASE("settle: whether there is one is known where the last bit of a float is not") {
    using T = float;
    const chord<X> nothing{none<X>(), none<X>()};
    CHECK(told<T>{.quick = {at<W>(2, 0.25), at<W>(6)}, .exact = nothing}.occluded());
    CHECK(told<T>{.quick = {at<W>(2, 0.25), at<W>(6)}, .exact = nothing}.occluded(1.75, 2.25));
    CHECK(!told<T>{.quick = {at<W>(2, 0.25), none<W>()}, .exact = nothing}.occluded(1.875));
    CHECK(!told<T>{.quick = {at<W>(2, 0.25), none<W>()}, .exact = nothing}.occluded(0, 2.125));
    CHECK(!told<T>{.quick = {at<W>(2, INFINITY), none<W>()}, .exact = nothing}.occluded(-infinity<T>));
    CHECK(!told<T>{.quick = {at<W>(2, 0.25), none<W>()}}.occluded(2.5));
    CHECK(!told<T>{.quick = {at<W>(2, 0.25), none<W>()}}.occluded(0, 1.5));
    CHECK(told<T>{.quick = {at<W>(2, 0.25), none<W>()}}.occluded(2.25));
}

TEST_CASE("settle: a line is inside from crossing to crossing, both to the last bit of a float") {
    using T = float;
    const auto inside = [](const chord<W>& quick, const chord<X>& exact = {at<X>(3), at<X>(7)}) {
        return inside_of(told<T>{quick, exact}, any<T>());
    };
    const interval<T> quick{2, 6}, exact{3, 7};
    CHECK(inside({at<W>(2), at<W>(6)}) == quick);
    CHECK(inside({at<W>(2), none<W>()}) == interval<T>{2, 1});
    CHECK(inside({at<W>(2, 0.25), at<W>(6)}) == exact);
    CHECK(inside({at<W>(2), at<W>(6, 0.25)}) == exact);
    CHECK(inside({unsure(at<W>(2)), at<W>(6)}) == exact);
    CHECK(inside({at<W>(2), unsure(at<W>(6))}) == exact);
    CHECK(inside({at<W>(2, 0.25), none<W>()}) == exact);
    CHECK(inside({none<W>(), at<W>(6, 0.25)}) == exact);
    CHECK(inside({none<W>(), none<W>()}).empty());
    CHECK(inside({none<W>(false), none<W>()}) == exact);
    CHECK(inside({none<W>(), none<W>(false)}) == exact);
    CHECK(inside({none<W>(false), none<W>()}, {none<X>(), none<X>()}).empty());
}

/// A surface that is nowhere: what is recorded of a point of it is asked here.
template <class T>
struct bent {
    using number = T;
    T bend;

    template <class Point>
    void surface(Point& at) const {
        at.record_point(bend);
    }
};
template <class T>
struct point_alone {
    T t;
    vec3<T> point, error;
};

template <class T, class N>
point_alone<T> recorded_point(const ray<T>& ray, const crossing<N>& c, T bend = T(0)) {
    point_alone<T> rec;
    detail::record_crossing(bent<T>{bend}, ray, c, rec);
    return rec;
}

/// Along each axis the error holds, and is little more than that of t and the rounding of the point.
template <class N, class T>
void check_recorded_error() {
    random_numbers random(1);
    double largest = 0;
    for (int i = 0; i < at_least(20'000); ++i) {
        vec3<T> origin(some_vector(random)), direction(some_vector(random));
        if (i % 3 == 0) origin = vec3<T>(0);
        const double t = random.uniform(-9, 9), error = i % 2 == 0 ? 0 : std::abs(t) * random.log_uniform(1e-20, 1e9);
        const crossing<N> c = at<N>(t, error);
        const auto rec = recorded_point(ray<T>{origin, direction}, c);
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            const oracle o(origin[axis]), d(direction[axis]), p(rec.point[axis]), stated(rec.error[axis]);
            for (const double off : {-error, error}) REQUIRE(abs(o + d * (oracle(t) + off) - p) <= stated);
            const oracle most = abs(d) * error + (abs(p) + abs(o)) * 10 * unit_roundoff<T>;
            REQUIRE(stated <= most * 1.001 + norm1(vec3<oracle>(rec.point)) * 0x1p-71 + least_normal<T>);
            largest = std::max(largest, rounded<double>(abs(o + d * t - p) / stated));
        }
    }
    CHECK(largest > 0.1);
}

TEST_CASE("record_point: the error holds along each axis, and is no larger than it must be") {
    check_recorded_error<W, float>();
    check_recorded_error<W, double>();
    check_recorded_error<X, double>();
}

template <class T>
struct described {
    using number = T;
    vec3<T> outward;
    vec2<T> uv;

    void surface(auto& at) const {
        at.record_point();
        at.record_normal(outward);
        at.record_uv([this] { return uv; });
    }
};

TEST_CASE_TEMPLATE("record: where numbers leave no normal, it is against the ray, and uv is 0", T, float, double) {
    constexpr T nan = std::numeric_limits<T>::quiet_NaN();
    const ray<T> along{{0, 0, 0}, {0, 3, -4}};
    hit_record<T> rec{};
    for (const vec3<T>& none : {vec3<T>(nan), vec3<T>(0)}) {
        detail::record_crossing(described<T>{none, {T(0.5), nan}}, along, at<W>(1), rec);
        CHECK(length(vec3<T>(rec.normal - vec3<T>(0, T(-0.6), T(0.8)))) < std::numeric_limits<T>::epsilon());
        CHECK(rec.uv == vec2<T>(0.5, 0));
    }
    detail::record_crossing(described<T>{{0, 2, 0}, {0, 1}}, along, at<W>(1), rec);
    CHECK((rec.normal == vec3<T>(0, rec.front_face ? 1 : -1, 0) && rec.uv == vec2<T>(0, 1)));
}

template <class T>
struct between_corners {
    using number = T;

    void surface(auto& at) const {
        at.record_point();
        at.keep_between({vec3<T>(0), vec3<T>(2, 0, 1)});
    }
};

TEST_CASE_TEMPLATE("record_point: beyond the largest number it is the nearest that there is", T, float, double) {
    constexpr T most = std::numeric_limits<T>::max();
    CHECK(recorded_point(ray<T>{{most, -most, 0}, {most, -most, 1}}, at<W>(1)).point == vec3<T>(most, -most, 1));
    point_alone<T> rec;
    detail::record_crossing(between_corners<T>{}, ray<T>{{1, -1, 5}, {3, 0, 0}}, at<W>(1), rec);
    CHECK(rec.point == vec3<T>(2, 0, 1));
}

TEST_CASE_TEMPLATE("record_point: an error without end is the largest number", T, float, double) {
    constexpr T most = std::numeric_limits<T>::max();
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        vec3<T> direction(0);
        direction[axis] = 4;
        const auto rec = recorded_point(ray<T>{{1, 2, 3}, direction}, at<W>(2, INFINITY));
        for (glm::length_t other = 0; other < 3; ++other) CHECK((rec.error[other] == most) == (other == axis));
    }
}

TEST_CASE("record_point: what is too small for a float, a long direction makes large") {
    const auto rec = recorded_point(ray<float>{{0, 0, 0}, {0x1p120f, 0, 0}}, at<W>(0x1p-150, 0x1p-160));
    CHECK((rec.t == 0 && rec.point.x == 0x1p-30f && rec.error.x >= 0x1p-40f));
    CHECK(!std::signbit(recorded_point(ray<float>{{0, 0, 0}, {1, 0, 0}}, at<W>(-0.0)).t));
}

TEST_CASE_TEMPLATE("record_point: what curves is left by more than its normal is rounded by", T, float, double) {
    constexpr T u = unit_roundoff<T>, eps = std::numeric_limits<T>::epsilon();
    const ray<T> through_origin{{0, 0, 0}, {1, 0, 0}};
    const auto flat = recorded_point(through_origin, at<W>(0)), curved = recorded_point(through_origin, at<W>(0), T(3));
    CHECK(flat.error.y < least_normal<T> * 2);
    CHECK(flat.error.y >= least_normal<T>);
    const T of_bend = std::same_as<T, double> ? 16 * u : 4 * u * u;  // doubles are told apart by doubles
    CHECK(curved.error.y / (3 * (of_bend + T(0x1p-72))) == doctest::Approx(1));
    const auto farther = recorded_point(through_origin, at<W>(2));
    CHECK(farther.error.y / T(0x1p-71) == doctest::Approx(1));
    CHECK(farther.error.x <= 10 * eps);
}

}  // namespace raio::test
