// raio inside a renderer that has vectors, rays and records of its own: embed PICTURE.ppm
//
// What raio takes stands between the two lines of dashes. The rest is as it was before.

#include <raio/bvh/bvh.hpp>
#include <raio/compose/csg.hpp>
#include <raio/shape/box.hpp>
#include <raio/shape/sphere.hpp>
#include <raio/shape/torus.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <vector>

struct Vector {
    double x = 0, y = 0, z = 0;

    Vector operator+(const Vector& b) const { return {x + b.x, y + b.y, z + b.z}; }
    Vector operator-(const Vector& b) const { return {x - b.x, y - b.y, z - b.z}; }
    Vector operator*(double s) const { return {x * s, y * s, z * s}; }
    double Dot(const Vector& b) const { return x * b.x + y * b.y + z * b.z; }
    Vector Normalized() const { return *this * (1 / std::sqrt(Dot(*this))); }
};

struct Ray {
    Vector from, along;
    double nearest, farthest;
};

struct Intersection {
    double distance;
    Vector place, across;
    Vector color;
};

class Object {
public:
    virtual ~Object() = default;
    virtual bool Intersect(const Ray& ray, Intersection& found) const = 0;
};

class Floor : public Object {
public:
    bool Intersect(const Ray& ray, Intersection& found) const override {
        const double t = -ray.from.y / ray.along.y;
        if (!(t >= ray.nearest && t <= ray.farthest)) return false;
        const Vector place = ray.from + ray.along * t;
        const bool odd = static_cast<long>(std::floor(place.x) + std::floor(place.z)) % 2 != 0;
        found = {t, place, {0, ray.along.y < 0 ? 1.0 : -1.0, 0}, odd ? Vector{0.9, 0.9, 0.9} : Vector{0.4, 0.4, 0.4}};
        return true;
    }
};

// ---------------------------------------------------------------------------------------------------------------------

struct Met {  // what is wanted of a hit, by raio's names
    double t;
    raio::vec3<double> point, normal;
};

template <class Shape>
class RaioObject : public Object {
public:
    RaioObject(Shape shape, const Vector& color) : shape_(std::move(shape)), color_(color) {}

    bool Intersect(const Ray& ray, Intersection& found) const override {
        Met met;
        const auto& [o, d, nearest, farthest] = ray;
        if (!shape_.hit({{o.x, o.y, o.z}, {d.x, d.y, d.z}}, nearest, farthest, met)) return false;
        found = {met.t, {met.point.x, met.point.y, met.point.z}, {met.normal.x, met.normal.y, met.normal.z}, color_};
        return true;
    }

private:
    Shape shape_;
    Vector color_;
};

// ---------------------------------------------------------------------------------------------------------------------

class Renderer {
public:
    void Add(std::unique_ptr<Object> object) { objects_.push_back(std::move(object)); }
    template <class Shape>
    void Add(const Shape& shape, const Vector& color) {
        Add(std::make_unique<RaioObject<Shape>>(shape, color));
    }

    Vector Color(const Ray& ray) const {
        Intersection found{};
        if (!Intersect(ray, found)) return {0.5, 0.7, 1};
        const Vector sun = Vector{2, 4, 3}.Normalized();
        Intersection shade{};
        const bool in_shade = Intersect({found.place + found.across * 1e-6, sun, 0, 1e30}, shade);
        return found.color * (0.2 + (in_shade ? 0 : 0.8 * std::fmax(0, found.across.Dot(sun))));
    }

private:
    bool Intersect(Ray ray, Intersection& found) const {
        bool any = false;
        for (const auto& object : objects_) {
            if (!object->Intersect(ray, found)) continue;
            any = true, ray.farthest = found.distance;
        }
        return any;
    }

    std::vector<std::unique_ptr<Object>> objects_;
};

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s PICTURE.ppm\n", argv[0]);
        return 2;
    }
    std::vector<raio::sphere<double>> pearls;
    for (double a = 0; a < 40; a += 0.25)
        pearls.push_back({{(2.6 + 0.02 * a) * std::cos(a), 0.1 + 0.06 * a, (2.6 + 0.02 * a) * std::sin(a)}, 0.1});

    Renderer renderer;
    renderer.Add(std::make_unique<Floor>());
    renderer.Add(raio::torus<double>{{0, 0.4, 0}, {0, 1, 0}, 1.4, 0.4}, {0.9, 0.3, 0.2});
    renderer.Add(raio::difference_of(raio::box<double>{{-0.6, 0, -0.6}, {0.6, 1.6, 0.6}},
                                     raio::sphere<double>{{0, 1.2, 0}, 0.7}),
                 {0.9, 0.8, 0.3});
    renderer.Add(raio::bvh(pearls), {0.6, 0.8, 0.9});

    constexpr int width = 640, height = 360;
    std::ofstream picture(argv[1], std::ios::binary);
    picture << "P6\n" << width << ' ' << height << "\n255\n";
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double u = (x + 0.5 - width / 2) / height, v = (height / 2 - y - 0.5) / height;
            const Vector color = renderer.Color({{0, 4, 7}, Vector{u, v - 0.4, -1}.Normalized(), 0, 1e30});
            for (const double c : {color.x, color.y, color.z})
                picture << static_cast<unsigned char>(std::fmin(255, 255 * std::sqrt(c)));
        }
    }
    if (!picture.flush()) {
        std::fprintf(stderr, "%s cannot be written\n", argv[1]);
        return 1;
    }
}
