#include <raio/shape/cone.hpp>

#include "support/cases.hpp"
#include "support/cones.hpp"
#include "support/dual.hpp"
#include "support/sampling.hpp"
#include "support/touching.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("cone: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const cone<T> hat{{0, 0, 0}, {0, 2, 0}, 2}, steep{{0, 0, 0}, {0, 4, 0}, 1};  // hat: 45 degrees
    const ray<T> ahead{{0, 1, 5}, {0, 0, -1}};
    check_cases<cone<T>>({
        {"the side", hat, ahead, enters(4)},
        {"the side, from below, through the base", hat, {{1.5, -1, 0}, {0, 1, 0}}, enters(1)},
        {"out through the side", hat, {{1.5, -1, 0}, {0, 1, 0}}, leaves(1.5), 1.25},
        {"behind the ray", hat, {{0, 1, 5}, {0, 0, 1}}, misses},
        {"from inside to the side (cone fails from inside)", hat, {{0, 1, 0}, {1, 0, 0}}, leaves(1)},
        {"from inside to the base", hat, {{0.5, 0.5, 0}, {0, -1, 0}}, leaves(0.5)},
        {"from inside to the apex", hat, {{0, 1, 0}, {0, 1, 0}}, leaves(1)},
        {"the apex, along the axis", hat, {{0, 5, 0}, {0, -1, 0}}, enters(3)},
        {"the apex, along the axis, later", hat, {{0, 5, 0}, {0, -1, 0}}, leaves(5), 4},
        {"the apex, steeper than a generator", hat, {{-1, 4, 0}, {1, -2, 0}}, enters(1)},
        {"the apex, steeper than a generator, from below", hat, {{-1, 0, 0}, {1, 2, 0}}, leaves(1), 0.5},
        {"the apex, from the side", hat, {{-5, 2, 0}, {1, 0, 0}}, enters(5)},
        {"the apex, flatter than a generator", hat, {{-4, 4, 0}, {2, -1, 0}}, enters(2)},
        {"the apex, flatter than a generator, from below", hat, {{-4, 0, 0}, {2, 1, 0}}, enters(2)},
        {"one number above the apex", hat, {{-5, 2 + 2 * eps, 0}, {1, 0, 0}}, misses},
        {"one number beside the apex, along the axis", hat, {{eps, 5, 0}, {0, -1, 0}}, enters(3 + eps)},
        {"the base, along the axis", hat, {{0, -5, 0}, {0, 1, 0}}, enters(5)},
        {"the wrong nappe", hat, {{0, 3, 5}, {0, 0, -1}}, misses},
        {"the wrong nappe, then the right one", hat, {{1, 5, 0}, {0, -1, 0}}, enters(4)},
        {"the wrong nappe, and beside the right one", hat, {{-3, 4, 0}, {1, 1, 0}}, misses},
        {"from inside the wrong nappe", hat, {{0, 4, 0}, {1, 0, 0}}, misses},
        {"parallel to a generator, inside (a = 0)", hat, {{1, -1, 0}, {-1, 1, 0}}, enters(1)},
        {"parallel to a generator, inside, later", hat, {{1, -1, 0}, {-1, 1, 0}}, leaves(2), 1.5},
        {"parallel to a generator, outside (a = 0)", hat, {{-1, 4, 0}, {1, -1, 0}}, misses},
        {"parallel to a generator, beside the cone", hat, {{0, 2, 1}, {1, -1, 0}}, misses},
        {"along a generator", hat, {{3, -1, 0}, {-1, 1, 0}}, enters(1)},
        {"along a generator, from the apex", hat, {{-1, 3, 0}, {1, -1, 0}}, enters(1)},
        {"along a generator, later", hat, {{-1, 3, 0}, {1, -1, 0}}, leaves(3), 2},
        {"one number from a generator, outside", hat, {{3 + 2 * eps, -1, 0}, {-1, 1, 0}}, misses},
        {"along the base", hat, {{-5, 0, 0}, {1, 0, 0}}, enters(3)},
        {"one number below the base", hat, {{-5, -eps, 0}, {1, 0, 0}}, misses},
        {"touches the rim", hat, {{2, -1, 1}, {0, 1, -1}}, enters(1)},
        {"parallel to the axis, at the rim", hat, {{2, 5, 0}, {0, -1, 0}}, enters(5)},
        {"tangent to the side", hat, {{1, 1, 5}, {0, 0, -1}}, enters(5)},
        {"one number beyond the tangent", hat, {{1 + eps, 1, 5}, {0, 0, -1}}, misses},
        {"from the side inwards", hat, {{1, 1, 0}, {-1, 0, 0}}, enters(0)},
        {"from the side outwards", hat, {{1, 1, 0}, {1, 0, 0}}, leaves(0)},
        {"from the apex inwards", hat, {{0, 2, 0}, {0, -1, 0}}, enters(0)},
        {"from the apex outwards", hat, {{0, 2, 0}, {0, 1, 0}}, leaves(0)},
        {"a steep one", steep, {{5, 2, 0}, {-1, 0, 0}}, enters(4.5)},
        {"apex below the base", {{0, 0, 0}, {0, -2, 0}, 2}, {{0, -1, 5}, {0, 0, -1}}, enters(4)},
        {"radius zero", {{0, 0, 0}, {0, 2, 0}, 0}, ahead, misses},
        {"radius below zero", {{0, 0, 0}, {0, 2, 0}, -2}, ahead, misses},
        {"base is apex", {{0, 0, 0}, {0, 0, 0}, 2}, ahead, misses},
        {"direction zero", hat, {{0, 1, 0}, {0, 0, 0}}, misses},
        {"first crossing before the window", hat, ahead, leaves(6), 4.5},
        {"both crossings behind the window", hat, ahead, misses, 0, 3.5},
        {"window between the crossings", hat, ahead, misses, 4.5, 5.5},
        {"window that is not a number", hat, ahead, misses, nan<T>},
    });
}

TEST_CASE("cone: a ray that passes the apex by 1e-15 of the axis (it was hit there, beyond the bounds)") {
    const cone<double> cone{{-0x1.ac5e7303bdf73p-1, 0x1.2bc7bec2335b5p-2, 0x1.5d5b4251b3de3p-2},
                            {0x1.372af8161078dp-5, 0x1.0dbf8259c6b93p+0, 0x1.474de7e8cdabfp-4},
                            0x1.3cb814680f79fp-5};
    const ray<double> ray{{-0x1.d5ba2b83fd0c8p-3, 0x1.a45ccb561485ap-1, 0x1.6038fbdd9d5b4p-3},
                          {0x1.11c274c4c0956p-2, 0x1.dc88e575e3b3p-3, -0x1.79240fd26d0a8p-4}};
    CHECK(inconsistent_record(probe<raio::cone<double>>{cone, ray, 0, infinity<double>}) == "");
    CHECK(!cone.occluded(ray, 0, 2));
}

TEST_CASE_TEMPLATE("cone: properties of every shape", T, RAIO_NUMBERS) { check_properties<cone<T>>(); }

TEST_CASE_TEMPLATE("cone: as exact arithmetic", T, RAIO_NUMBERS) {
    check_oracle<cone<T>>();
    check_accuracy<cone<T>>(test_rays);
    check_bounds_of_errors<cone<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("open_cone: named cases", T, RAIO_NUMBERS) {
    constexpr T eps = std::numeric_limits<T>::epsilon();
    const open_cone<T> hat{{0, 0, 0}, {0, 2, 0}, 2};
    const ray<T> ahead{{0, 1, 5}, {0, 0, -1}};
    check_cases<open_cone<T>>({
        {"the side", hat, ahead, enters(4)},
        {"the side, from within", hat, {{1.5, -1, 0}, {0, 1, 0}}, leaves(1.5)},
        {"in through the side, out through the base", hat, {{1.5, 5, 0}, {0, -1, 0}}, enters(4.5)},
        {"in through the side, out through the base, later", hat, {{1.5, 5, 0}, {0, -1, 0}}, misses, 4.75},
        {"the apex, along the axis", hat, {{0, 5, 0}, {0, -1, 0}}, enters(3)},
        {"the apex, along the axis, later", hat, {{0, 5, 0}, {0, -1, 0}}, misses, 4},
        {"the apex, from within", hat, {{0, -1, 0}, {0, 1, 0}}, leaves(3)},
        {"the apex, from the side", hat, {{-5, 2, 0}, {1, 0, 0}}, enters(5)},
        {"one number above the apex", hat, {{-5, 2 + 2 * eps, 0}, {1, 0, 0}}, misses},
        {"the wrong nappe", hat, {{0, 3, 5}, {0, 0, -1}}, misses},
        {"parallel to a generator, inside (a = 0)", hat, {{1, -1, 0}, {-1, 1, 0}}, leaves(2)},
        {"along a generator, through the apex, in the surface", hat, {{-1, 3, 0}, {1, -1, 0}}, misses},
        {"along a generator, from the apex, in the surface", hat, {{0, 2, 0}, {1, -1, 0}}, misses},
        {"along the rim", hat, {{-5, 0, 0}, {1, 0, 0}}, enters(3)},
        {"below the rim", hat, {{-5, -eps, 0}, {1, 0, 0}}, misses},
        {"tangent to the side", hat, {{1, 1, 5}, {0, 0, -1}}, enters(5)},
        {"radius zero", {{0, 0, 0}, {0, 2, 0}, 0}, ahead, misses},
        {"base is apex", {{0, 0, 0}, {0, 0, 0}, 2}, ahead, misses},
        {"direction zero", hat, {{0, 1, 0}, {0, 0, 0}}, misses},
        {"first crossing before the window", hat, ahead, leaves(6), 4.5},
        {"window between the crossings", hat, ahead, misses, 4.5, 5.5},
        {"window that is not a number", hat, ahead, misses, nan<T>},
    });
}

TEST_CASE_TEMPLATE("open_cone: properties of every shape", T, RAIO_NUMBERS) { check_properties<open_cone<T>>(); }

TEST_CASE_TEMPLATE("open_cone: all but along a generator (of few doubles the normal was along the ray)", T,
                   RAIO_NUMBERS) {
    check_along_surface(test_rays / 5, [](random_numbers& random) {
        const open_cone<T> hat =
            subject<open_cone<T>>::random(random, 1, random.direction() * random.log_uniform(1, 1e3));
        const vec3<double> apex = to_double(hat.apex), axis = apex - to_double(hat.base);
        const vec3<double> generator = axis - random.perpendicular(axis) * static_cast<double>(hat.radius);
        return touching_line<open_cone<T>>{hat, random.one_in(2) ? apex : apex - generator * random.uniform(),
                                           generator};
    });
}

TEST_CASE("open_cone: the apex, along the axis (seen with a normal along the ray)") {
    const open_cone<double> funnel{{0, 0, 0}, {0, 0, -0x1.fdeb091195de3p+13}, 0x1.495594e960bc3p+12};
    const ray<double> up{{0, 0, -0x1.9d3008aa37b67p+25}, {0, 0, 0x1.9d2974f9a9265p+9}};
    hit_record<double> rec{};
    REQUIRE(funnel.hit(up, 0, infinity<double>, rec));
    CHECK(rec.normal.z == doctest::Approx(-1));
}

TEST_CASE("open_cone: all but along a generator past the apex (it was hit, with a normal along the ray)") {
    const open_cone<double> funnel{{0x1.00ea4dfdad41bp+6, 0x1.86b3b562b7704p+5, 0x1.2046d1b23b12fp+4},
                                   {0x1.012df6c35554dp+6, 0x1.86afae84f0581p+5, 0x1.1fd33ed3b97dep+4},
                                   0x1.48b9b8ec757fap-3};
    const ray<double> down{{0x1.00ed36c65a743p+6, 0x1.858e03d7bb60dp+5, 0x1.203a6560f437bp+4},
                           {0x1.9c843ed445496p-2, 0x1.cd5c52a75dfd5p-1, -0x1.4894f98d07fc8p-3}};
    CHECK(!funnel.occluded(down, 0, infinity<double>));
}

TEST_CASE_TEMPLATE("open_cone: from a point of the surface, in any direction (many doubles did not start there)", T,
                   RAIO_NUMBERS) {
    check_starts_on_surface([](random_numbers& random) {
        const T r = static_cast<T>(random.uniform(1, 2)), h = static_cast<T>(random.uniform(1, 2));
        return std::pair(open_cone<T>{{0, 0, 0}, {0, 0, h}, r}, vec3<T>(r / 2, 0, h / 2));
    });
}

TEST_CASE_TEMPLATE("open_cone: as exact arithmetic", T, RAIO_NUMBERS) {
    check_accuracy<open_cone<T>>(test_rays, 1.0 / 200);
    check_bounds_of_errors<open_cone<T>>(test_rays / 20);
}

TEST_CASE_TEMPLATE("cone: area, and samples spread evenly over it", T, RAIO_NUMBERS) {
    // The axis is 3 long, the generators 5: the side measures 20, the base 16, times pi.
    const cone<T> hat{{1, 2, 3}, {3, 3, 5}, 4};
    CHECK(hat.area() == doctest::Approx(36 * std::numbers::pi));
    check_sampling(hat, [&](const hit_record<T>& rec) {
        const T up = dot(rec.normal, normalize(hat.apex - hat.base)), v = rec.uv.y;
        return vec2<T>(rec.uv.x, (up < T(-0.9) ? 16 * v * v : 36 - 20 * (1 - v) * (1 - v)) / 36);
    });
    const open_cone<T> open{{1, 2, 3}, {3, 3, 5}, 4};
    CHECK(open.area() == doctest::Approx(20 * std::numbers::pi));
    check_sampling(open,
                   [](const hit_record<T>& rec) { return vec2<T>(rec.uv.x, 1 - (1 - rec.uv.y) * (1 - rec.uv.y)); });
}

TEST_CASE_TEMPLATE("cone: uv, and the normal of the apex", T, RAIO_NUMBERS) {
    const cone<T> hat{{0, 0, 0}, {0, 0, 2}, 2};
    const auto hit = [&](const ray<T>& ray) {
        hit_record<T> rec{};
        REQUIRE(hat.hit(ray, T(0), infinity<T>, rec));
        return rec;
    };
    CHECK(hit({{9, 0, 0.5}, {-1, 0, 0}}).uv == vec2<T>(0, 0.25));
    CHECK(hit({{0, -9, 1}, {0, 1, 0}}).uv == vec2<T>(0.75, 0.5));
    CHECK(hit({{1.5, 0, -9}, {0, 0, 1}}).uv == vec2<T>(0, 0.75));
    CHECK(hit({{0, 0, 9}, {0, 0, -1}}).uv.y == T(1));
    CHECK(hit({{0, 0, 9}, {0, 0, -1}}).normal == vec3<T>(0, 0, 1));
    CHECK(hit({{0, 0, 1}, {0, 0, 1}}).normal == vec3<T>(0, 0, -1));
    CHECK(hit({{9, 0, 2}, {-1, 0, 0}}).normal == vec3<T>(0, 0, 1));
}

TEST_CASE("cone: the derivatives of t, by a number that carries them along") {
    const cone<dual> hat{{0, 0, 0}, {0, 0, 2}, dual::variable(2, 0)};
    hit_record<dual> rec{};
    REQUIRE(hat.hit({{dual::variable(6, 1), 0, dual::variable(1, 2)}, {-1, 0, 0}}, 0, infinity<dual>, rec));
    CHECK(rec.t.value == doctest::Approx(5));
    CHECK(rec.t.slope[0] == doctest::Approx(-0.5));
    CHECK(rec.t.slope[1] == doctest::Approx(1));
    CHECK(rec.t.slope[2] == doctest::Approx(1));
}

}  // namespace raio::test
