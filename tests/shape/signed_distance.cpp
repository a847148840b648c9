#include <raio/shape/signed_distance.hpp>

#include <raio/shape/sphere.hpp>
#include <raio/shape/torus.hpp>

#include "support/cases.hpp"

namespace raio::test {

namespace {

template <class T>
struct ball {
    vec3<T> center;
    T radius;
    T operator()(const vec3<T>& p) const { return length(vec3<T>(p - center)) - radius; }
};

template <class T>
struct doughnut {
    T major_radius, minor_radius;
    T operator()(const vec3<T>& p) const {
        const T beyond = std::sqrt(p.x * p.x + p.y * p.y) - major_radius;
        return std::sqrt(beyond * beyond + p.z * p.z) - minor_radius;
    }
};

template <class T>
constexpr T fine = std::same_as<T, float> ? T(1e-5) : T(1e-11);

/// A ray towards anywhere in [-2, 2]^3; one in four along an axis, one in eight from near the middle.
template <class T>
ray<T> random_ray(random_numbers& random) {
    const vec3<double> from = random.direction() * (random.one_in(8) ? random.uniform() : random.uniform(3, 6));
    vec3<double> direction = random.direction() * random.uniform(0, 2) - from;
    if (random.one_in(4)) {
        const int axis = random.integer(0, 2);
        for (glm::length_t i = 0; i < 3; ++i) direction[i] = i == axis ? direction[i] : 0;
    }
    return {vec3<T>(from), vec3<T>(direction * random.log_uniform(1e-3, 1e3))};
}

/// The crossings are those of the exact shape, but for rays that a shape larger or smaller by a few tolerances would
/// cross another number of times; and all promises but exactness are kept.
template <class T, class Function, class Exact>
void check_beside(const signed_distance<T, Function>& shape, const Exact& exact, const Exact& larger,
                  const Exact& smaller) {
    random_numbers random(9);
    int hits = 0, compared = 0;
    for (int i = 0; i < test_rays / 5; ++i) {
        const ray<T> ray = random_ray<T>(random);
        INFO(literal(ray));
        hit_record<T> rec = untouched_record<T>(), again;
        const bool hit = shape.hit(ray, T(0), infinity<T>, rec);
        REQUIRE(shape.occluded(ray, T(0), infinity<T>) == hit);
        hits += hit;

        const raio::spans found = shape.spans(ray);
        const raio::spans is(exact.spans(ray)), outer(larger.spans(ray)), inner(smaller.spans(ray));
        if (outer.count == is.count && inner.count == is.count) {
            REQUIRE(found.count == is.count);
            for (std::size_t k = 0; k < found.count; ++k) {
                const auto& [entered, left] = found.begin()[k];
                REQUIRE((outer.begin()[k].min <= entered && entered <= inner.begin()[k].min));
                REQUIRE((inner.begin()[k].max <= left && left <= outer.begin()[k].max));
            }
            ++compared;
        }
        if (!hit) {
            REQUIRE(same_record(rec, untouched_record<T>()));
            continue;
        }
        REQUIRE(unsound_fields(rec) == "");
        REQUIRE(std::abs(shape.distance(rec.point)) <= shape.tolerance * T(1.5));
        REQUIRE(shape.bounds().contains(rec.point));
        REQUIRE(dot(rec.normal, ray.direction) <= T(1e-6) * length(ray.direction));
        REQUIRE((shape.hit(ray, rec.t, rec.t, again) && again.t == rec.t));
        REQUIRE_FALSE(shape.hit(ray, T(0), std::nextafter(rec.t, T(-1)), again));
        REQUIRE(shape.occluded(ray, rec.t, rec.t));
        // The crossing of the exact surface is within the error, along the normal.
        const vec3<T> outward = rec.front_face ? rec.normal : -rec.normal;
        REQUIRE(shape.distance(rec.point + outward * rec.error) > T(0));
        REQUIRE(shape.distance(rec.point - outward * rec.error) < T(0));
        const vec3<T> direction(random.direction());
        if (shape.hit(spawn_ray(rec, direction), T(0), infinity<T>, again)) {
            REQUIRE(again.front_face == ((dot(rec.normal, direction) > T(0)) == rec.front_face));
        }
    }
    CHECK(hits > test_rays / 20);
    CHECK(compared > test_rays / 6);
}

}  // namespace

TEST_CASE_TEMPLATE("signed_distance: as the exact shapes, within the tolerance", T, RAIO_NUMBERS) {
    const T tolerance = fine<T>, more = 4 * tolerance;
    const aabb<T> box{vec3<T>(-2), vec3<T>(2)};
    const vec3<T> center(T(0.25), T(0.5), T(-0.25));
    check_beside(signed_distance<T, ball<T>>{box, tolerance, 1, {center, 1}}, sphere<T>{center, 1},
                 sphere<T>{center, 1 + more}, sphere<T>{center, 1 - more});
    const vec3<T> up(0, 0, 1);
    check_beside(signed_distance<T, doughnut<T>>{box, tolerance, 1, {1, T(0.5)}}, torus<T>{{0, 0, 0}, up, 1, T(0.5)},
                 torus<T>{{0, 0, 0}, up, 1, T(0.5) + more}, torus<T>{{0, 0, 0}, up, 1, T(0.5) - more});
}

TEST_CASE_TEMPLATE("signed_distance: named cases", T, RAIO_NUMBERS) {
    const T tolerance = fine<T>;
    const aabb<T> box{vec3<T>(-2), vec3<T>(2)};
    const signed_distance shape{box, tolerance, T(1), ball<T>{{0, 0, 0}, 1}};
    const auto t_of = [&](const auto& s, const ray<T>& ray, T t_min = 0) {
        hit_record<T> rec{};
        return s.hit(ray, t_min, infinity<T>, rec) ? rec.t : T(-1);
    };
    const auto about = [&](T t) { return doctest::Approx(double(t)).epsilon(4 * double(tolerance)); };
    const ray<T> ahead{{0, 0, 5}, {0, 0, -1}};
    CHECK(t_of(shape, ahead) == about(4));
    CHECK(t_of(shape, ahead, 4.5) == about(6));
    CHECK(t_of(shape, {{0, 0, 0}, {0, 0, -1}}) == about(1));
    CHECK(t_of(shape, {{0, 0, 5}, {0, 0, 1}}) == T(-1));
    CHECK(t_of(shape, {{0, 0, 1}, {0, 0, -1}}, tolerance * 4) == about(2));           // on the surface, inwards
    CHECK(t_of(shape, {{0, 0, 1}, {0, 0, 1}}, tolerance * 4) == T(-1));               // and outwards
    CHECK(t_of(shape, {{1, 0, 5}, {0, 0, -1}}) == doctest::Approx(5).epsilon(0.01));  // tangent
    CHECK(t_of(shape, {{1 + 2 * tolerance, 0, 5}, {0, 0, -1}}) == T(-1));  // beside it by more than the tolerance
    CHECK(t_of(shape, {{0, 0, 5}, {0, 0, 0}}) == T(-1));
    CHECK(t_of(shape, {{0, 0, nan<T>}, {0, 0, -1}}) == T(-1));
    CHECK(t_of(shape, {{0, 0, 5}, {0, nan<T>, -1}}) == T(-1));
    CHECK(t_of(shape, {{0, 0, 5}, {0, 0, -infinity<T>}}) == T(-1));
    CHECK(t_of(shape, ahead, nan<T>) == T(-1));
    // What is not in the box is not there; what is twice as steep needs the bound that says so.
    CHECK(t_of(signed_distance{aabb<T>{vec3<T>(2), vec3<T>(3)}, tolerance, T(1), ball<T>{{0, 0, 0}, 1}}, ahead) ==
          T(-1));
    CHECK(t_of(signed_distance{aabb<T>{{-2, -2, 0}, {2, 2, 2}}, tolerance, T(1), ball<T>{{0, 0, 0}, 1}}, ahead, 4.5) ==
          about(5));  // and ends there
    CHECK_FALSE(shape.occluded(ahead, T(0), T(3.5)));
    CHECK_FALSE(shape.occluded(ahead, T(6.5), T(8)));
    CHECK(t_of(signed_distance{aabb<T>{{-2, -2, 0}, {2, 2, 2}}, tolerance, T(1), ball<T>{{0, 0, 0}, 1}}, ahead, 5.5) ==
          T(-1));
    // Where the slope is no number, the normal is against the ray.
    const auto torn = [](const vec3<T>& p) { return p.x > 0 ? infinity<T> : std::abs(p.z) - 1; };
    hit_record<T> rec{};
    REQUIRE(signed_distance{box, tolerance, T(1), torn}.hit(ahead, T(0), infinity<T>, rec));
    CHECK(rec.normal == vec3<T>(0, 0, 1));
    const auto steep = [](const vec3<T>& p) { return 2 * (std::abs(p.z) - T(0.5)); };
    CHECK(t_of(signed_distance{box, tolerance, T(2), steep}, ahead) == about(4.5));
    CHECK(t_of(signed_distance{box, T(0), T(1), ball<T>{{0, 0, 0}, 1}}, ahead) == T(-1));
    CHECK(t_of(signed_distance{box, tolerance, T(0), ball<T>{{0, 0, 0}, 1}}, ahead) == T(-1));
    CHECK(t_of(signed_distance{box, tolerance, infinity<T>, ball<T>{{0, 0, 0}, 1}}, ahead) == T(-1));
    CHECK(t_of(signed_distance{box, tolerance, T(1), ball<T>{{0, 0, 0}, nan<T>}}, ahead) == T(-1));
    CHECK(t_of(signed_distance{aabb<T>{}, tolerance, T(1), ball<T>{{0, 0, 0}, 1}}, ahead) == T(-1));
}

static_assert(solid<signed_distance<float, ball<float>>> && bounded<signed_distance<double, ball<double>>>);

TEST_CASE_TEMPLATE("signed distance: a walk ends, however short its steps", T, RAIO_NUMBERS) {
    const auto flat = [](const vec3<T>&) { return T(0); };
    const signed_distance<T, decltype(flat)> shape{{vec3<T>(-1), vec3<T>(1)}, least_normal<T>, T(1), flat};
    const auto inside = shape.spans({{0, 0, 0}, {0, 0, 1}});
    REQUIRE(inside.count == 1);
    CHECK(inside.intervals[0].min == T(-1));
    CHECK(inside.intervals[0].max > T(-1));
}

TEST_CASE_TEMPLATE("signed distance: what grazes the tolerance is not left and entered again", T, RAIO_NUMBERS) {
    // f of a ball where a ray is about to enter: now a little more than the tolerance, now a little less.
    const ray<T> grazing{{-0x1.ad722cp+0f, -0x1.ceddd4p+1f, -0x1.dd18d4p+1f},
                         {0x1.90814p-2f, 0x1.7edd88p-1f, 0x1.d46232p-1f}};
    const aabb<T> box{vec3<T>(-2), vec3<T>(2)};
    const ball<T> ball{{T(0.25), T(0.5), T(-0.25)}, 1};
    CHECK(signed_distance{box, fine<T>, T(1), ball}.spans(grazing).count == 1);

    // Less than twice the tolerance is no gap, more is one.
    const T tolerance = fine<T>;
    const aabb<T> thin{vec3<T>(0), vec3<T>(1, 1, 300 * tolerance)};
    const auto crossed = [&](T highest) {
        const auto waves = [=](const vec3<T>& p) {
            return tolerance * (p.z > 100 * tolerance && p.z < 200 * tolerance ? highest : T(0.5));
        };
        return signed_distance{thin, tolerance, T(1), waves}.spans({vec3<T>(0.5, 0.5, -1), {0, 0, 1}}).count;
    };
    CHECK(crossed(T(1.9)) == 1);
    CHECK(crossed(T(2)) == 1);
    CHECK(crossed(T(2.1)) == 2);
}

TEST_CASE_TEMPLATE("signed distance: what lies at the tolerance, or at the end of the box, belongs to it", T,
                   RAIO_NUMBERS) {
    const T tolerance = fine<T>;
    const ray<T> up{{T(0.5), T(0.5), -1}, {0, 0, 1}};
    const aabb<T> cube{vec3<T>(0), vec3<T>(1)};

    // At the tolerance up to a height, and far outside beyond it.
    const T height = 100 * tolerance;
    const auto step = [=](const vec3<T>& p) { return p.z <= height ? tolerance : T(1); };
    const auto inside = signed_distance{cube, tolerance, T(1), step}.spans(up);
    REQUIRE(inside.count == 1);
    CHECK(inside.begin()->min == 1);
    CHECK(inside.begin()->max == doctest::Approx(double(1 + height)).epsilon(2 * double(tolerance)));

    // All but at the tolerance where the box ends, as it was not on the way.
    const auto rising = [=](const vec3<T>& p) { return p.z - 1 + tolerance / 2; };
    const auto to_the_end = signed_distance{cube, tolerance, T(1), rising}.spans(up);
    REQUIRE(to_the_end.count == 1);
    CHECK(to_the_end.begin()->max == 2);
    const auto ending = [=](const vec3<T>& p) { return p.z < 1 ? T(-0.6) : tolerance; };
    CHECK(signed_distance{cube, tolerance, T(1), ending}.spans(up).begin()->max == 2);

    // A box without a height.
    const ball<T> ball{{0, 0, 0}, 1};
    const signed_distance flat{aabb<T>{{-1, -1, 0}, {1, 1, 0}}, tolerance, T(1), ball};
    hit_record<T> rec{};
    REQUIRE(flat.hit(up, T(0), infinity<T>, rec));
    CHECK(rec.t == 1);

    // Where the box is entered deep inside, f rises along the ray: the normal is mirrored. Where f is flat, there is
    // none.
    REQUIRE(signed_distance{cube, tolerance, T(1), rising}.hit(up, T(0), infinity<T>, rec));
    CHECK(rec.t == 1);
    CHECK(length(vec3<T>(rec.normal - vec3<T>(0, 0, -1))) < T(1e-5));
    const auto level = [](const vec3<T>&) { return T(-1); };
    REQUIRE(signed_distance{cube, tolerance, T(1), level}.hit(up, T(0), infinity<T>, rec));
    CHECK(rec.normal == vec3<T>(0, 0, -1));
    CHECK_FALSE(signed_distance{cube, tolerance, T(0), level}.hit(up, T(0), infinity<T>, rec));
}

}  // namespace raio::test
