#include <raio/hit_record.hpp>

#include <doctest/doctest.h>

#include <initializer_list>

#include <raio/shape/disc.hpp>
#include <raio/shape/sphere.hpp>

#include "support/random.hpp"

namespace raio::test {

template <class T>
hit_record<T> record_on_floor() {
    const T error = std::numeric_limits<T>::epsilon();
    return {T(3), {T(1), T(2), T(-5)}, {T(0), T(1), T(0)}, {T(0.5), T(0.25)}, vec3<T>(error), 7, true};
}

TEST_CASE_TEMPLATE("spawn_ray: starts on the side that the direction goes to, more than the error away", T,
                   RAIO_NUMBERS) {
    const hit_record<T> rec = record_on_floor<T>();
    const vec3<T> up(T(3), T(1), T(0)), down(T(3), T(-1), T(0));
    CHECK(spawn_ray(rec, up).direction == up);
    CHECK(spawn_ray(rec, up).origin.y > rec.point.y + rec.error.y);
    CHECK(spawn_ray(rec, down).origin.y < rec.point.y - rec.error.y);
    CHECK(spawn_ray(rec, up).origin.x == rec.point.x);  // a wall beside it comes no nearer
    CHECK(spawn_ray(rec, up).origin.z == rec.point.z);

    // Tangent to a torus from below: aside by an ulp of x is outside of it.
    constexpr T eps = std::numeric_limits<T>::epsilon();
    hit_record<T> below{};
    below.point = {-2, 0, 3}, below.normal = {-eps, -1, eps}, below.error = {eps, eps * eps, eps};
    CHECK(spawn_ray(below, up).origin == vec3<T>(-2, spawn_ray(below, up).origin.y, 3));
}

TEST_CASE_TEMPLATE("spawn_ray: moves by the size of the error, no matter where or how large", T, RAIO_NUMBERS) {
    for (const T scale : {T(1e-6), T(1), T(1e6)}) {
        hit_record<T> rec = record_on_floor<T>();
        rec.point *= scale, rec.error *= scale;
        rec.normal = {T(0.6), T(0), T(-0.8)};
        const vec3<T> moved = spawn_ray(rec, rec.normal).origin - rec.point;
        CHECK(dot(moved, rec.normal) >= dot(abs(rec.normal), rec.error));
        CHECK(length(moved) < T(16) * std::numeric_limits<T>::epsilon() * scale * T(5));
        CHECK(dot(spawn_ray(rec, -rec.normal).origin - rec.point, rec.normal) <= -dot(abs(rec.normal), rec.error));
    }
}

TEST_CASE_TEMPLATE("spawn_ray: moves off a point at the origin that is exact", T, RAIO_NUMBERS) {
    hit_record<T> rec = record_on_floor<T>();
    rec.point = rec.error = vec3<T>(0);
    CHECK(spawn_ray(rec, vec3<T>(0, 1, 0)).origin.y > T(0));
    CHECK(spawn_ray(rec, vec3<T>(0, -1, 0)).origin.y < T(0));
}

TEST_CASE_TEMPLATE("spawn_ray: leaves from any record that knows point, normal and error", T, RAIO_NUMBERS) {
    struct own_vector {
        T x, y, z;
        own_vector() = default;
        own_vector(const vec3<T>& v) : x(v.x), y(v.y), z(v.z) {}
        operator vec3<T>() const { return {x, y, z}; }
    };
    struct own_record {
        T t;
        own_vector point, normal, error;
    };
    const sphere<T> ball{{0, 0, -3}, 1};
    const ray<T> ray{{0, T(0.1), 0}, {0, 0, -1}};
    hit_record<T> all;
    own_record own;
    REQUIRE(ball.hit(ray, T(0), infinity<T>, all));
    REQUIRE(ball.hit(ray, T(0), infinity<T>, own));
    CHECK(spawn_ray(own, {1, 2, 3}).origin == spawn_ray(all, {1, 2, 3}).origin);
    CHECK(spawn_ray(own, {1, 2, -3}).origin == spawn_ray(all, {1, 2, -3}).origin);
    struct without_error {
        T t;
        vec3<T> point, normal;
    };
    constexpr bool is_refused = !requires(const without_error& rec) { spawn_ray(rec, vec3<T>()); };
    CHECK(is_refused);
}

TEST_CASE_TEMPLATE("spawn_ray: a layer 4e-5 behind another is not skipped", T, RAIO_NUMBERS) {
    const disc<T> front{{0, 0, 0}, {0, 0, 1}, 1}, behind{{0, 0, T(-4e-5)}, {0, 0, 1}, 1};
    hit_record<T> rec{}, next{};
    REQUIRE(front.hit({{3, 2, 9}, {-3, -2, -9}}, T(0), infinity<T>, rec));
    const ray<T> spawned = spawn_ray(rec, {0, 0, -1});
    CHECK(!front.occluded(spawned, T(0), infinity<T>));
    REQUIRE(behind.hit(spawned, T(0), infinity<T>, next));
    CHECK(next.t == doctest::Approx(4e-5).epsilon(0.05));
}

TEST_CASE_TEMPLATE("after, before: the next number", T, RAIO_NUMBERS) {
    constexpr T most = std::numeric_limits<T>::max(), least = std::numeric_limits<T>::denorm_min();
    for (const T t : {T(0), T(1), T(-1), T(5000), most, -most, least, -least, std::numeric_limits<T>::min()}) {
        CHECK(after(t) == std::nextafter(t, infinity<T>));
        CHECK(before(t) == std::nextafter(t, -infinity<T>));
    }
    CHECK((after(infinity<T>) == infinity<T> && before(infinity<T>) == most));
    CHECK((after(-infinity<T>) == -most && before(-infinity<T>) == -infinity<T>));
    const T none = std::numeric_limits<T>::quiet_NaN();
    CHECK((after(none) != after(none) && before(none) != before(none)));
    static_assert(before(after(T(3))) == 3);
}

TEST_CASE_TEMPLATE("after: the next crossing, where an epsilon is nothing beside t", T, RAIO_NUMBERS) {
    const sphere<T> far{{0, 0, -5000}, 1};
    const ray<T> ray{{0, 0, 0}, {0, 0, -1}};
    hit_record<T> rec;
    REQUIRE(far.hit(ray, 0, infinity<T>, rec));
    CHECK(rec.t == 4999);
    REQUIRE(far.hit(ray, after(rec.t), infinity<T>, rec));
    CHECK(rec.t == 5001);
    CHECK(!far.hit(ray, after(rec.t), infinity<T>, rec));
}

TEST_CASE_TEMPLATE("assign: takes over all or nothing", T, RAIO_NUMBERS) {
    const hit_record<T> rec = record_on_floor<T>();
    hit_record<T> to{};
    assign(false, to, rec);
    CHECK((to.t == T(0) && to.index == 0 && !to.front_face && to.point == vec3<T>(0)));
    assign(true, to, rec);
    CHECK((to.t == rec.t && to.point == rec.point && to.normal == rec.normal && to.uv == rec.uv));
    CHECK((to.error == rec.error && to.index == rec.index && to.front_face == rec.front_face));
}

}  // namespace raio::test
