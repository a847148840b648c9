#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <render/polygon.hpp>

namespace {

using vec3 = raio::vec3<double>;
using triangle = raio::triangle<double>;

std::vector<triangle> triangles_of(const std::vector<vec3>& corners) {
    std::vector<triangle> triangles;
    render::append_triangles(corners, triangles);
    return triangles;
}

double doubled_area(const triangle& t) { return raio::cross(t.b - t.a, t.c - t.a).z; }

/// Is (x, y) inside, by how often a ray to the right crosses the edges?
bool inside(const std::vector<vec3>& corners, double x, double y) {
    bool in = false;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const vec3 &a = corners[i], &b = corners[j];
        if ((a.y > y) != (b.y > y) && x < a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y)) in = !in;
    }
    return in;
}

/// Every point of a grid is in one triangle if it is in the polygon, and in none if it is not.
void check_covered(const std::vector<vec3>& corners) {
    const std::vector<triangle> triangles = triangles_of(corners);
    REQUIRE(triangles.size() == corners.size() - 2);
    for (const triangle& t : triangles) CHECK(doubled_area(t) >= 0);
    for (double x = -2.013; x < 2; x += 0.083) {
        for (double y = -2.017; y < 2; y += 0.079) {
            const auto count = std::ranges::count_if(triangles, [&](const triangle& t) {
                return inside({t.a, t.b, t.c}, x, y);
            });
            CAPTURE(x);
            CAPTURE(y);
            CHECK(count == (inside(corners, x, y) ? 1 : 0));
        }
    }
}

std::vector<vec3> comb(int teeth) {
    std::vector<vec3> corners{{-1.5, -1, 0}, {1.5, -1, 0}};
    for (int i = 0; i < teeth; ++i) {
        const double right = 1.5 - 3.0 * i / teeth, step = 3.0 / teeth;
        corners.push_back({right, 1, 0});
        corners.push_back({right - step / 2, -0.9, 0});
    }
    corners.push_back({-1.5, 1, 0});
    return corners;
}

std::vector<vec3> spiral(int corners_of_a_side) {
    std::vector<vec3> corners;
    for (int i = 0; i < corners_of_a_side; ++i) {
        const double angle = 0.5 * i, radius = 0.3 + 0.04 * i;
        corners.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    for (int i = corners_of_a_side - 1; i >= 0; --i) {
        const double angle = 0.5 * i, radius = 0.2 + 0.04 * i;
        corners.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    return corners;
}

const struct {
    std::string name;
    std::vector<vec3> corners;
} polygons[] = {
    {"an L, whose notch a fan bridged", {{-1, -1, 0}, {1, -1, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}}},
    {"a dart", {{-1, -1, 0}, {0, -0.5, 0}, {1, -1, 0}, {0, 1, 0}}},
    {"a star, with corners on diagonals",
     {{0, 1.5, 0},
      {-0.3, 0.4, 0},
      {-1.5, 0.4, 0},
      {-0.5, -0.2, 0},
      {-0.9, -1.4, 0},
      {0, -0.6, 0},
      {0.9, -1.4, 0},
      {0.5, -0.2, 0},
      {1.5, 0.4, 0},
      {0.3, 0.4, 0}}},
    {"corners on straight edges",
     {{-1, -1, 0}, {0, -1, 0}, {1, -1, 0}, {1, -0.5, 0}, {1, 0, 0}, {0.5, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}}},
    {"a square hole, reached through an edge and back",
     {{-1.5, -1.5, 0},
      {1.5, -1.5, 0},
      {1.5, 1.5, 0},
      {-1.5, 1.5, 0},
      {-1.5, -1.5, 0},
      {-0.5, -0.5, 0},
      {-0.5, 0.5, 0},
      {0.5, 0.5, 0},
      {0.5, -0.5, 0},
      {-0.5, -0.5, 0}}},
    {"two holes that are reached from one corner",
     {{-1.5, -1.5, 0},
      {1.5, -1.5, 0},
      {1.5, 1.5, 0},
      {-1.5, 1.5, 0},
      {-1.5, -1.5, 0},
      {-1, 0, 0},
      {-0.5, 0.5, 0},
      {-0.5, 0, 0},
      {-1, 0, 0},
      {-1.5, -1.5, 0},
      {0, -1, 0},
      {0.5, -0.5, 0},
      {0.5, -1, 0},
      {0, -1, 0}}},
    {"a comb", comb(12)},
    {"a spiral", spiral(35)},
    {"a regular polygon", {{1, 0, 0}, {0.5, 0.9, 0}, {-0.5, 0.9, 0}, {-1, 0, 0}, {-0.5, -0.9, 0}, {0.5, -0.9, 0}}},
};

}  // namespace

TEST_CASE("the triangles of a face cover it once, whichever its first corner is") {
    for (const auto& polygon : polygons) {
        CAPTURE(polygon.name);
        std::vector<vec3> corners = polygon.corners;
        for (std::size_t first = 0; first < std::min<std::size_t>(corners.size(), 10); ++first) {
            check_covered(corners);
            std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        }
    }
}

TEST_CASE("a face keeps its front, in whatever plane it lies") {
    for (const auto& polygon : polygons) {
        CAPTURE(polygon.name);
        vec3 whole(0);
        for (const triangle& t : triangles_of(polygon.corners)) whole += raio::cross(t.b - t.a, t.c - t.a);
        const auto moved = [&](auto map) {
            std::vector<vec3> corners;
            for (const vec3& p : polygon.corners) corners.push_back(map(p));
            vec3 sum(0), sizes(0);
            for (const triangle& t : triangles_of(corners)) {
                const vec3 area = raio::cross(t.b - t.a, t.c - t.a);
                sum += area, sizes += vec3(std::abs(area.x), std::abs(area.y), std::abs(area.z));
            }
            CHECK(raio::length(sizes) == doctest::Approx(raio::length(sum)).epsilon(1e-12));  // none is turned over
            return sum;
        };
        CHECK(raio::length(moved([](const vec3& p) { return vec3(p.y, p.z, p.x); }) - vec3(0, whole.z, 0)) < 1e-12);
        CHECK(raio::length(moved([](const vec3& p) { return vec3(p.z, p.x, p.y); }) - vec3(whole.z, 0, 0)) < 1e-12);
        CHECK(raio::length(moved([](const vec3& p) { return vec3(p.y, p.x, p.z); }) + whole) < 1e-12);
        // Tilted: x + y is added to z.
        const vec3 tilted = moved([](const vec3& p) { return vec3(p.x, p.y, p.x + p.y); });
        CHECK(raio::length(tilted - vec3(-whole.z, -whole.z, whole.z)) < 1e-12);
    }
}

TEST_CASE("a convex face is a fan about its first corner") {
    const std::vector<vec3> corners{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}};
    const auto triangles = triangles_of(corners);
    REQUIRE(triangles.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(triangles[i].a == corners[0]);
        CHECK(triangles[i].b == corners[i + 1]);
        CHECK(triangles[i].c == corners[i + 2]);
    }
}

TEST_CASE(
    "of faces that cross themselves, or are nothing, as many triangles are made, in a time that can be waited for") {
    const vec3 p(1, 2, 3);
    CHECK(triangles_of({p, p, p, p, p}).size() == 3);
    CHECK(triangles_of({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size() == 2);
    std::vector<vec3> scribble;
    for (int i = 0; i < 2000; ++i) scribble.push_back({std::sin(1.7 * i), std::sin(2.3 * i), std::sin(0.1 * i)});
    CHECK(triangles_of(scribble).size() == 1998);
}
