#include <doctest/doctest.h>
#include <render/light.hpp>
#include <render/material.hpp>

#include "scenes.hpp"

using namespace render;

namespace {

constexpr number degree = raio::pi<number> / 180;

/// Comes down on the plane y = 0 at this angle from its normal, turned about it.
vec3 falling(number angle, number turn) {
    return {std::sin(angle) * std::cos(turn), -std::cos(angle), std::sin(angle) * std::sin(turn)};
}

const vec3 upward(0, 1, 0);

}  // namespace

TEST_CASE("refraction is Snell's law: the sine is multiplied, the plane of incidence kept, the direction unit") {
    for (const number ratio : {1 / 2.42, 1 / 1.5, 1 / 1.33, 1.0, 1.33, 1.5, 2.42}) {
        for (number angle = 0; angle < 90; angle += 1.5) {
            const vec3 in = falling(angle * degree, 0.7);
            const auto out = refracted(in, upward, ratio);
            const number sine = ratio * std::sin(angle * degree);
            CAPTURE(ratio);
            CAPTURE(angle);
            REQUIRE(out.has_value() == (sine < 1));
            if (!out) continue;
            CHECK(raio::length(*out) == doctest::Approx(1).epsilon(1e-14));
            CHECK(raio::length(raio::cross(*out, upward)) == doctest::Approx(sine).epsilon(1e-14));
            CHECK(out->y < 0);
            CHECK(raio::dot(*out, raio::cross(in, upward)) == doctest::Approx(0));
            CHECK(out->x * in.x + out->z * in.z >= 0);
        }
    }
}

TEST_CASE("internal reflection is total from the critical angle on") {
    for (const number refractive_index : {1.33, 1.5, 2.42}) {
        const number critical = std::asin(1 / refractive_index);
        CHECK(refracted(falling(critical - 1e-6, 2), upward, refractive_index));
        CHECK_FALSE(refracted(falling(critical + 1e-6, 2), upward, refractive_index));
    }
}

TEST_CASE(
    "light goes through a plate of glass and comes out in its old direction, moved sideways by the textbook's distance") {
    const raio::box<number> plate{{-100, -2, -100}, {100, 0, 100}};
    for (const number angle : {0.0, 20.0, 45.0, 70.0}) {
        const ray in{-4.0 * falling(angle * degree, 0.3), falling(angle * degree, 0.3)};
        hit_record rec;
        REQUIRE(plate.hit(in, 0, raio::infinity<number>, rec));
        const ray inside = raio::spawn_ray(rec, refracted(in.direction, rec.normal, 1 / 1.5).value());
        REQUIRE(plate.hit(inside, 0, raio::infinity<number>, rec));
        const vec3 out = refracted(inside.direction, rec.normal, 1.5).value();
        CHECK(raio::length(out - in.direction) < 1e-14);

        const number sine = std::sin(angle * degree), cosine = std::cos(angle * degree);
        const number moved = raio::length(raio::cross(rec.point - in.origin, in.direction));
        CHECK(moved == doctest::Approx(2 * sine * (1 - cosine / std::sqrt(1.5 * 1.5 - sine * sine))).epsilon(1e-12));
    }
}

TEST_CASE("a mirror keeps the angle") {
    for (const number angle : {0.0, 30.0, 89.0}) {
        const vec3 in = falling(angle * degree, 1), out = reflected(in, upward);
        CHECK(raio::length(out - vec3(in.x, -in.y, in.z)) < 1e-15);
    }
}

TEST_CASE("glass reflects as often as Schlick says, the same from both sides at the two angles of one path") {
    const auto share_reflected = [](const vec3& in, bool from_outside) {
        hit_record rec;
        rec.normal = upward;
        rec.front_face = from_outside;
        scattering glass;
        glass.glass = color(1);
        glass.glass_chance = 1;
        glass.refractive_index = 1.5;
        constexpr int tries = 1 << 16;
        int count = 0;
        for (std::uint32_t i = 0; i < tries; ++i) {
            sampler sampler(3, 0, i);
            if (scatter(glass, in, rec, sampler).value().direction.y > 0) ++count;
        }
        return number(count) / tries;
    };
    for (const number angle : {0.0, 45.0, 75.0}) {
        const vec3 in = falling(angle * degree, 0), inside = refracted(in, upward, 1 / 1.5).value();
        const number expected = 0.04 + 0.96 * std::pow(1 - std::cos(angle * degree), 5);
        CHECK(share_reflected(in, true) == doctest::Approx(expected).epsilon(0.01));
        CHECK(share_reflected(inside, false) == doctest::Approx(expected).epsilon(0.01));
    }
    CHECK(share_reflected(falling(60 * degree, 0), false) == 1);
}

TEST_CASE("a matte surface scatters with the density that it says: the mean of 1 / density is the half sphere") {
    hit_record rec;
    rec.normal = raio::normalize(vec3(1, 2, -2));
    scattering matte;
    matte.matte = color(0.5);
    matte.matte_chance = 1;
    number half_sphere = 0, cosine_moment = 0;
    constexpr int n = 1 << 16;
    for (std::uint32_t i = 0; i < n; ++i) {
        sampler sampler(0, 0, i);
        const auto out = scatter(matte, {0, 0, 1}, rec, sampler);
        REQUIRE(out);
        const number cosine = raio::dot(out->direction, rec.normal);
        half_sphere += std::min(1 / out->density, 1e3) / n;
        cosine_moment += cosine / n;
    }
    CHECK(half_sphere == doctest::Approx(2 * raio::pi<number>).epsilon(0.02));
    CHECK(cosine_moment == doctest::Approx(2.0 / 3).epsilon(0.001));
}

TEST_CASE("a finish of the course never scatters more light than it gets") {
    hit_record rec{};
    scene s = scene_of(
        {{raio::sphere<number>{origin, 1}, color(0.9), phong{.diffuse = 0.8, .reflected = 1, .transmitted = 0.7}}});
    const scattering found = scattering_at(world(s), rec);
    CHECK(found.matte.x + found.mirror.x + found.glass.x <= 1 + 1e-15);
    CHECK(found.mirror.x / found.glass.x == doctest::Approx(1 / 0.7));
    CHECK(found.matte_chance + found.mirror_chance + found.glass_chance == doctest::Approx(1));
}
