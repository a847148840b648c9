#include <raio/aabb.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

#include "support/random.hpp"

namespace raio::test {

static_assert(aabb<float>{{0, 0, 0}, {1, 2, 3}}.half_area() == 2 + 6 + 3);
static_assert(aabb<float>{}.half_area() == 0);
static_assert(aabb<double>{{0, 0, 0}, {1, 1, 1}}.contains({1, 0, 0.5}));
static_assert(!aabb<double>{{0, 0, 0}, {1, 1, 1}}.contains({1.5, 0, 0.5}));

TEST_CASE_TEMPLATE("aabb: a new one is empty, and the neutral element of hull", T, RAIO_NUMBERS) {
    const aabb<T> empty, box{{-1, 0, 1}, {2, 3, 4}};
    CHECK(!empty.contains({0, 0, 0}));
    CHECK(hull(empty, box).min == box.min);
    CHECK(hull(box, empty).max == box.max);
    CHECK(hull(empty, vec3<T>(1, 2, 3)).min == vec3<T>(1, 2, 3));
    CHECK(hull(empty, vec3<T>(1, 2, 3)).max == vec3<T>(1, 2, 3));
}

TEST_CASE_TEMPLATE("aabb: contains its faces, edges and corners, and no NaN", T, RAIO_NUMBERS) {
    const aabb<T> box{{-1, 0, 1}, {2, 3, 4}};
    const T beyond = std::numeric_limits<T>::epsilon() * 4, nan = std::numeric_limits<T>::quiet_NaN();
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        vec3<T> low = box.min, high = box.max;
        CHECK(box.contains(low));
        CHECK(box.contains(high));
        low[axis] -= beyond, high[axis] += beyond;
        CHECK(!box.contains(low));
        CHECK(!box.contains(high));
        low[axis] = nan;
        CHECK(!box.contains(low));
    }
    CHECK(unbounded<T>().contains({infinity<T>, -infinity<T>, 0}));
    CHECK(!unbounded<T>().contains({nan, 0, 0}));
}

TEST_CASE_TEMPLATE("aabb: hull takes in both", T, RAIO_NUMBERS) {
    const aabb<T> both = hull(aabb<T>{{0, -5, 0}, {1, 1, 9}}, aabb<T>{{-3, 0, 0}, {0, 2, 3}});
    CHECK(both.min == vec3<T>(-3, -5, 0));
    CHECK(both.max == vec3<T>(1, 2, 9));
    CHECK(hull(both, vec3<T>(0, 7, -1)).max == vec3<T>(1, 7, 9));
    CHECK(hull(both, vec3<T>(0, 7, -1)).min == vec3<T>(-3, -5, -1));
}

TEST_CASE_TEMPLATE("aabb: hull and overlap are NaN if one side is, wherever (the second one's was dropped)", T,
                   RAIO_NUMBERS) {
    const T nan = std::numeric_limits<T>::quiet_NaN();
    const aabb<T> box{{-1, 0, 1}, {2, 3, 4}};
    const auto is_all_nan = [](const aabb<T>& b) {
        return is_nan(b.min.x) && is_nan(b.min.y) && is_nan(b.min.z) && is_nan(b.max.x) && is_nan(b.max.y) &&
               is_nan(b.max.z);
    };
    for (glm::length_t i = 0; i < 6; ++i) {
        aabb<T> bad = box;
        (i < 3 ? bad.min : bad.max)[i % 3] = nan;
        CHECK(is_nan(bad));
        for (const aabb<T>& both : {hull(bad, box), hull(box, bad), hull(aabb<T>{}, bad), overlap(bad, box),
                                    overlap(box, bad), hull(bad, vec3<T>(0)), unless_nan(box, T(1), bad)}) {
            CHECK(is_all_nan(both));
        }
    }
    CHECK(is_all_nan(unless_nan(box, vec3<T>(0), nan)));
    CHECK(is_all_nan(unless_nan(box, vec3<T>(0, nan, 0))));
    CHECK(!is_nan(unless_nan(box, vec3<T>(-infinity<T>, infinity<T>, 0), infinity<T>, aabb<T>{}, unbounded<T>())));
}

TEST_CASE_TEMPLATE("aabb: the nearest point in it", T, RAIO_NUMBERS) {
    const aabb<T> box{{-1, 2, 0}, {1, 5, 0}};
    CHECK(nearest_in(box, vec3<T>(0.5, 3, 0)) == vec3<T>(0.5, 3, 0));
    CHECK(nearest_in(box, vec3<T>(-7, 6, 1)) == vec3<T>(-1, 5, 0));
    CHECK(nearest_in(box, vec3<T>(infinity<T>, -infinity<T>, -1)) == vec3<T>(1, 2, 0));
    const T none = std::numeric_limits<T>::quiet_NaN();
    CHECK(nearest_in({vec3<T>(none, 2, none), vec3<T>(1, none, none)}, vec3<T>(3, 1, 4)) == vec3<T>(1, 2, 4));
}

TEST_CASE_TEMPLATE("outward: to the next number or the one after it, and off zero", T, RAIO_NUMBERS) {
    using limits = std::numeric_limits<T>;
    for (const T x : {T(1), T(-1), T(2) - limits::epsilon(), T(0.3), T(-1e20), T(1e-20), limits::max() / 2}) {
        const T next = std::nextafter(x, infinity<T>), after = std::nextafter(next, infinity<T>);
        CHECK((outward(x, T(1)) == next || outward(x, T(1)) == after));
        CHECK(outward(-x, T(-1)) == -outward(x, T(1)));
    }
    // Where the least step and an ulp are alike.
    for (const T x : {limits::min() / limits::epsilon(), 2 * limits::min() / limits::epsilon()}) {
        CHECK((outward(x, T(1)) > x && outward(x, T(-1)) < x));
    }
    for (const T x : {T(0), -T(0), limits::denorm_min(), limits::min(), -limits::min()}) {  // no ulp is too small
        CHECK((outward(x, T(1)) > x && outward(x, T(1)) <= x + 2 * limits::min()));
        CHECK((outward(x, T(-1)) < x && outward(x, T(-1)) >= x - 2 * limits::min()));
    }
    CHECK(outward(infinity<T>, T(1)) == infinity<T>);
    const aabb<T> box = padded(aabb<T>{{-1, 0, 1}, {2, 3, 4}});
    CHECK((box.min.x < T(-1) && box.min.y < T(0) && box.min.z < T(1)));
    CHECK((box.max.x > T(2) && box.max.y > T(3) && box.max.z > T(4)));
    // A side at 0 moves by the padding of the largest coordinate, also where another has no end.
    const aabb<T> large = padded(aabb<T>{{0, 0, -infinity<T>}, {0, 64, 1}});
    const T ulp = 64 * limits::epsilon(), room = 64 * T(padding<T>) * T(unit_roundoff<T>);
    for (const T blur : {-large.min.x, -large.min.y, large.max.x}) CHECK((blur >= room && blur <= 2 * room));
    CHECK(large.max.y <= 64 + 2 * ulp + 2 * room);
}

}  // namespace raio::test
