#pragma once

#include "support/triangles.hpp"

/// \file
/// Closed meshes, and the promise that they are closed.

namespace raio::test {

/// A regular icosahedron whose triangles are divided in four, twice, and blown up to a sphere of radius 1.
template <class Triangle>
std::vector<Triangle> icosphere() {
    using T = number_t<Triangle>;
    const double golden = (1 + std::sqrt(5.0)) / 2;
    const auto vertex = [](const vec3<double>& v) { return vec3<T>(normalize(v)); };
    std::vector<Triangle> mesh;
    // The vertices are (0, +-1, +-golden) and its two rotations; the faces are the triples at distance 2.
    std::vector<vec3<double>> corners;
    for (const double one : {-1.0, 1.0}) {
        for (const double g : {-golden, golden}) {
            corners.insert(corners.end(), {{0, one, g}, {one, g, 0}, {g, 0, one}});
        }
    }
    const auto neighbours = [](const vec3<double>& a, const vec3<double>& b) {
        return std::abs(length(a - b) - 2) < 1e-9;
    };
    for (std::size_t i = 0; i < 12; ++i) {
        for (std::size_t j = i + 1; j < 12; ++j) {
            for (std::size_t k = j + 1; k < 12; ++k) {
                const vec3<double> a = corners[i], b = corners[j], c = corners[k];
                if (!neighbours(a, b) || !neighbours(b, c) || !neighbours(c, a)) continue;
                const bool outward = dot(cross(b - a, c - a), a) > 0;
                mesh.push_back({vertex(a), vertex(outward ? b : c), vertex(outward ? c : b)});
            }
        }
    }
    for (int level = 0; level < 2; ++level) {
        std::vector<Triangle> finer;
        for (const Triangle& t : mesh) {
            const auto middle = [&](const vec3<T>& p, const vec3<T>& q) { return vertex(to_double(p) + to_double(q)); };
            const vec3<T> ab = middle(t.a, t.b), bc = middle(t.b, t.c), ca = middle(t.c, t.a);
            finer.insert(finer.end(), {{t.a, ab, ca}, {ab, t.b, bc}, {ca, bc, t.c}, {ab, bc, ca}});
        }
        mesh = finer;
    }
    return mesh;
}

/// The cube from -1 to 1, each face a fan of 16 triangles around its centre.
template <class Triangle>
std::vector<Triangle> cube_of_fans() {
    using T = number_t<Triangle>;
    std::vector<vec2<T>> rim;  // around the square, from corner to corner
    for (const vec2<T> corner : {vec2<T>(-1, -1), vec2<T>(1, -1), vec2<T>(1, 1), vec2<T>(-1, 1)}) {
        const vec2<T> next(-corner.y, corner.x);
        for (int i = 0; i < 4; ++i) rim.push_back(corner + (next - corner) * T(i) / T(4));
    }
    std::vector<Triangle> mesh;
    for (const T side : {T(-1), T(1)}) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto on_face = [&](const vec2<T>& p) {
                const vec3<T> v(side, p.x * side, p.y);
                return axis == 0 ? v : axis == 1 ? vec3<T>(v.z, v.x, v.y) : vec3<T>(v.y, v.z, v.x);
            };
            for (std::size_t i = 0; i < rim.size(); ++i) {
                mesh.push_back({on_face(vec2<T>(0)), on_face(rim[i]), on_face(rim[(i + 1) % rim.size()])});
            }
        }
    }
    return mesh;
}

/// So much larger, and elsewhere.
template <class Triangle>
std::vector<Triangle> moved(std::vector<Triangle> mesh, double size, const vec3<double>& place) {
    for (Triangle& t : mesh) {
        for (auto* corner : {&t.a, &t.b, &t.c}) *corner = vec3<number_t<Triangle>>(to_double(*corner) * size + place);
    }
    return mesh;
}

/// Tells which triangles of a mesh a ray passes at a distance: by half of its size, which no rounding
/// makes up for.
template <class Triangle>
class distant_triangles {
public:
    explicit distant_triangles(const std::vector<Triangle>& mesh) {
        for (const Triangle& t : mesh) {
            const vec3<double> a = to_double(t.a);
            corners_.push_back(a);
            reach_.push_back(1.5 * std::max(length(to_double(t.b) - a), length(to_double(t.c) - a)));
        }
    }
    bool has(std::size_t nth, const vec3<double>& origin, const vec3<double>& unit_direction) const {
        const double x = corners_[nth].x - origin.x, y = corners_[nth].y - origin.y, z = corners_[nth].z - origin.z;
        const double along = x * unit_direction.x + y * unit_direction.y + z * unit_direction.z;
        return x * x + y * y + z * z - along * along > reach_[nth] * reach_[nth];
    }

private:
    std::vector<vec3<double>> corners_;
    std::vector<double> reach_;
};

/// Rays aimed at vertices and at points of edges of a convex mesh of size 1: from inside each meets backs alone, at one
/// t, however many triangles share the point. From outside it meets fronts at one t and then backs at another, both at
/// one where it touches the mesh, or nothing: no crossing is lost, and none counts twice. (What is far beside the ray
/// is asked by every eighth.)
template <class Triangle>
void check_closed_mesh(const std::vector<Triangle>& unit, double size = 1, const vec3<double>& place = {0, 0, 0}) {
    using T = number_t<Triangle>;
    const std::vector<Triangle> mesh = moved(unit, size, place);
    const distant_triangles<Triangle> distant(mesh);
    random_numbers random(12);
    int complaints = 0, shared = 0, through = 0;
    const int rays = test_rays / 4;
    for (int i = 0; i < rays; ++i) {
        const Triangle& t = mesh[static_cast<std::size_t>(random.integer(0, static_cast<int>(mesh.size()) - 1))];
        const bool at_vertex = i % 2 == 0, from_inside = i % 4 < 2;
        const vec3<T> target = at_vertex ? t.a : t.a + (t.b - t.a) * static_cast<T>(random.uniform());
        const double away = from_inside ? random.one_in(4) ? 0 : random.uniform(0, 0.5) : random.uniform(2, 9);
        const vec3<T> origin(place + random.direction() * (away * size));
        const ray<T> ray{origin, target - origin};
        std::vector<T> fronts, backs;
        const vec3<double> from = to_double(ray.origin), towards = normalize(to_double(ray.direction));
        for (std::size_t nth = 0; nth < mesh.size(); ++nth) {
            if (i / 4 % 8 != 0 && distant.has(nth, from, towards)) continue;
            hit_record<T> rec{};
            if (mesh[nth].hit(ray, T(0), infinity<T>, rec)) (rec.front_face ? fronts : backs).push_back(rec.t);
        }
        const auto at_one_t = [](const std::vector<T>& ts) {
            return !ts.empty() && std::ranges::count(ts, ts.front()) == std::ssize(ts);
        };
        const bool is_sound = from_inside ? fronts.empty() && at_one_t(backs)
                                          : (fronts.empty() && backs.empty()) || (at_one_t(fronts) && at_one_t(backs) &&
                                                                                  fronts.front() <= backs.front());
        shared += fronts.size() + backs.size() > (from_inside ? 1 : 2);
        through += !from_inside && !fronts.empty();
        if (!is_sound && ++complaints <= 3) {
            FAIL_CHECK("a leak, or one crossing that counts twice, towards " << literal(t) << ", {" << literal(ray)
                                                                             << "}");
        }
    }
    CHECK(complaints == 0);
    CHECK(shared > rays / 20);
    CHECK(through > rays / 4);
}

}  // namespace raio::test
