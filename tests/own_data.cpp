#include <doctest/doctest.h>

#include <algorithm>
#include <memory>

#include <raio/bvh/bvh.hpp>
#include <raio/raio.hpp>

#include "support/random.hpp"

/// What a program keeps beside shapes and rays: it reaches a shape's own `hit` and comes back with the record, and
/// which shape was hit is known however deep it stands.
namespace raio::test {
namespace {

template <class T>
struct own_record {
    T t;
    vec3<T> normal;
    int material;  ///< of the shape
    T time;        ///< of the ray
    int untouched;
    std::array<std::uint32_t, 3> indices;
};

/// A sphere with a material, that flickers: it is there at odd times.
template <class T>
struct ball : sphere<T> {
    int material;

    template <class Ray, record Record>
    bool hit(const Ray& ray, T t_min, T t_max, Record& rec) const {
        if constexpr (requires { rec.time; }) {
            if (std::fmod(rec.time, 2) < 1) return false;
        }
        if (!first_hit(*this, ray, t_min, t_max, rec)) return false;
        if constexpr (requires { rec.material; }) rec.material = material;
        return true;
    }
};

template <class T>
std::vector<ball<T>> balls(random_numbers& random, int count) {
    std::vector<ball<T>> all;
    for (int i = 0; i < count; ++i) {
        const auto number = [&] { return static_cast<T>(random.uniform(-5, 5)); };
        all.push_back({{{number(), number(), number()}, static_cast<T>(random.uniform(0.1, 2))}, 100 + i});
    }
    return all;
}

template <class T>
ray<T> aimed(random_numbers& random) {
    const vec3<double> from = random.direction() * 20.0;
    return {vec3<T>(from), vec3<T>(random.direction() * 4.0 - from)};
}

template <class T>
own_record<T> blank(T time) {
    return {T(-7), {}, -1, time, 42, {9, 9, 9}};
}

/// Is what `scene` answers that which the plain loop over the balls answers?
template <class T, class Scene>
void check_like_loop(const Scene& scene, const std::vector<ball<T>>& all, const vec3<T>& moved = vec3<T>(0)) {
    random_numbers random(7);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const ray<T> ray = aimed<T>(random);
        const T time = static_cast<T>(random.integer(0, 3));
        own_record<T> expected = blank(time), rec = blank(time);
        bool met = false;
        T t_max = infinity<T>;
        for (const ball<T>& one : all) {
            if (!one.hit(raio::ray<T>{ray.origin - moved, ray.direction}, T(0), t_max, expected)) continue;
            met = true, t_max = before(expected.t);
        }
        REQUIRE(scene.hit(ray, T(0), infinity<T>, rec) == met);
        CHECK((rec.untouched == 42 && rec.time == time));
        CHECK(rec.material == expected.material);
        if (!met) CHECK((rec.t == T(-7) && rec.indices[0] == 9));
        hits += met;
    }
    CHECK(hits > 100);
}

TEST_CASE_TEMPLATE("data of one's own: beside a shape and in the record, through all that holds shapes", T,
                   RAIO_NUMBERS) {
    random_numbers random(1);
    const std::vector<ball<T>> all = balls<T>(random, 60);
    const bvh tree(all);
    const group loop{all};
    check_like_loop<T>(loop, all);
    check_like_loop<T>(tree, all);
    check_like_loop<T>(group{group{all}}, all);
    check_like_loop<T>(bvh(std::vector{tree}), all);
    check_like_loop<T>(bvh{loop}, all);
    check_like_loop<T>(bvh{group{all, std::vector<sphere<T>>{{{0, 900, 0}, 1}}}}, all);
    const vec3<T> by(1, 2, 4);
    check_like_loop<T>(transformed{&tree, translation(by)}, all, by);
    check_like_loop<T>(transformed{transformed{&loop, translation(by)}, translation(-by)}, all);
    check_like_loop<T>(bvh(std::vector{transformed{&tree, translation(by)}}), all, by);
}

TEST_CASE_TEMPLATE("data of one's own: some shapes that packs know, some that they do not", T, RAIO_NUMBERS) {
    random_numbers random(2);
    const std::vector<ball<T>> own = balls<T>(random, 40);
    std::vector<sphere<T>> plain;
    for (const ball<T>& one : balls<T>(random, 40)) plain.push_back(one);
    const group loop{plain, own};
    const bvh tree{loop};
    int own_hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const ray<T> ray = aimed<T>(random);
        own_record<T> a = blank(T(1)), b = blank(T(1));
        REQUIRE(loop.hit(ray, T(0), infinity<T>, a) == tree.hit(ray, T(0), infinity<T>, b));
        CHECK((a.t == b.t && a.indices == b.indices && b.untouched == 42 && a.normal == b.normal));
        if (b.t < T(0) || b.indices[0] < plain.size()) continue;
        CHECK(static_cast<std::size_t>(b.material) == 100 + b.indices[0] - plain.size());
        ++own_hits;
    }
    CHECK(own_hits > 200);
}

TEST_CASE_TEMPLATE("data of one's own: on a solid, through csg", T, RAIO_NUMBERS) {
    const ball<T> a{{{0, 0, 0}, 2}, 5}, b{{{0, 0, 2}, 1}, 6};
    own_record<T> rec = blank(T(1));
    REQUIRE(difference_of(a, b).hit({{0, 0, 9}, {0, 0, -1}}, T(0), infinity<T>, rec));
    CHECK((rec.t == 8 && rec.material == 6 && rec.untouched == 42));
    CHECK((rec.indices == std::array<std::uint32_t, 3>{1, 0, 0}));
}

TEST_CASE_TEMPLATE("indices: the way to the shape, from the outermost (an instance's index was all that was left)", T,
                   RAIO_NUMBERS) {
    const auto square = std::make_shared<const bvh<triangle<T>>>(
        mesh<T>{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{{0, 1, 2}, {0, 2, 3}}}});
    std::vector<transformed<std::shared_ptr<const bvh<triangle<T>>>>> instances;
    for (int i = 0; i < 30; ++i) instances.emplace_back(square, translation<T>({T(2 * i), 0, 0}));
    const auto check = [](const auto& scene, const std::array<std::uint32_t, 3>& expected) {
        own_record<T> rec = blank(T(1));
        const ray<T> upper_left{{T(26.25), T(0.5), 5}, {0, 0, -1}};
        REQUIRE(scene.hit(upper_left, T(0), infinity<T>, rec));
        CHECK(rec.indices == expected);
        CHECK(rec.untouched == 42);
        struct {
            T t;
            std::uint16_t index;
            std::uint8_t indices[2];  // of any type, and as many as are wanted
        } small;
        REQUIRE(scene.hit(upper_left, T(0), infinity<T>, small));
        CHECK((small.index == expected[0] && small.indices[0] == expected[0] && small.indices[1] == expected[1]));
    };
    const sphere<T> far{{0, 0, 900}, 1};
    check(instances[13], {1, 0, 0});
    check(group{instances}, {13, 1, 0});
    check(bvh(instances), {13, 1, 0});
    check(group{far, bvh(instances)}, {1, 13, 1});
    check(bvh{group{far, bvh(instances)}}, {1, 13, 1});
    check(any_primitive<T>(bvh(instances)), {13, 0, 0});  // which knows of a hit_record alone
    mesh<T> own{{{26, 0, 0}, {27, 0, 0}, {27, 1, 0}, {26, 1, 0}}, {{{0, 1, 2}, {0, 2, 3}}}};
    check(own, {1, 0, 0});
    check(group{far, own}, {1, 1, 0});
    check(bvh<mesh_triangle<T>>(own), {1, 0, 0});
}

/// What raio knows nothing of but what it answers.
struct object {
    virtual ~object() = default;
    virtual bool intersect(const ray<double>& ray, double t_min, double t_max, double& t) const = 0;
};
struct wall : object {
    double z;

    explicit wall(double at) : z(at) {}
    bool intersect(const ray<double>& ray, double t_min, double t_max, double& t) const override {
        const double found = (z - ray.origin.z) / ray.direction.z;
        const vec3<double> p = ray.at(found);
        if (!(found >= t_min && found <= t_max && std::abs(p.x) <= 1 && std::abs(p.y) <= 1)) return false;
        return t = found, true;
    }
};
struct any_object {
    using number = double;
    const object* of;
    double z;

    template <record Record>
    bool hit(const ray<double>& ray, double t_min, double t_max, Record& rec) const {
        return of->intersect(ray, t_min, t_max, rec.t);
    }
    bool occluded(const ray<double>& ray, double t_min, double t_max) const {
        double t;
        return of->intersect(ray, t_min, t_max, t);
    }
    aabb<double> bounds() const { return {{-1, -1, z}, {1, 1, z}}; }
};

TEST_CASE("data of one's own: a tree over a program's objects behind a virtual call") {
    std::vector<std::unique_ptr<object>> owned;
    std::vector<any_object> objects;
    for (int i = 0; i < 50; ++i) {
        owned.push_back(std::make_unique<wall>(i));
        objects.push_back({owned.back().get(), static_cast<double>(i)});
    }
    const bvh tree(objects);
    struct {
        double t;
        std::size_t index;
    } rec;
    REQUIRE(tree.hit({{0.5, 0.5, 7.5}, {0, 0, 0.5}}, 0, infinity<double>, rec));
    CHECK((rec.t == 1 && rec.index == 8));
    CHECK(!tree.occluded({{0.5, 0.5, 7.5}, {0, 0, 0.5}}, 0, 0.5));
    CHECK(!tree.hit({{1.5, 0.5, 7.5}, {0, 0, 0.5}}, 0, infinity<double>, rec));
    const std::vector<sphere<double>> balls{{{0, 0, 60}, 1}};
    REQUIRE(bvh{group{balls, objects}}.hit({{0.5, 0.5, 99}, {0, 0, -1}}, 0, infinity<double>, rec));
    CHECK((rec.index == 0 && rec.t < 40));
}

TEST_CASE_TEMPLATE("data of one's own: tree and loop agree on equally near ones, the first of them", T, RAIO_NUMBERS) {
    const ball<T> a{{{0, 0, 0}, 1}, 3};
    std::vector<ball<T>> same(20, a);
    for (int i = 0; i < 20; ++i) same[static_cast<std::size_t>(i)].material = i;
    own_record<T> rec = blank(T(1)), of_tree = rec;
    REQUIRE(group{same}.hit({{0, 0, 9}, {0, 0, -1}}, T(0), infinity<T>, rec));
    REQUIRE(bvh(same).hit({{0, 0, 9}, {0, 0, -1}}, T(0), infinity<T>, of_tree));
    CHECK((rec.material == 0 && of_tree.material == 0));
}

/// A triangle with a material.
template <class T>
struct sheet : triangle<T> {
    int material;

    template <class Ray, record Record>
    bool hit(const Ray& ray, T t_min, T t_max, Record& rec) const {
        if (!first_hit(*this, ray, t_min, t_max, rec)) return false;
        if constexpr (requires { rec.material; }) rec.material = material;
        return true;
    }
};

TEST_CASE_TEMPLATE("data of one's own: of equally near ones it is that of the one that shows its front", T,
                   RAIO_NUMBERS) {
    const vec3<T> a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    const sheet<T> up{{a, b, c}, 1}, down{{a, c, b}, 2}, also_up{{b, c, a}, 3}, also_down{{c, b, a}, 4};
    const ray<T> from_above{{T(0.25), T(0.25), 2}, {0, 0, -1}}, from_below{{T(0.25), T(0.25), -2}, {0, 0, 1}};
    std::vector<sheet<T>> all{up, down, also_up, also_down};
    const auto earlier = [](const sheet<T>& s, const sheet<T>& t) { return s.material < t.material; };
    do {
        const auto first_of = [&](int one, int other) {
            return std::ranges::find_if(all,
                                        [&](const sheet<T>& s) { return s.material == one || s.material == other; })
                ->material;
        };
        const auto check = [&](const auto& scene) {
            own_record<T> rec = blank(T(1));
            REQUIRE(scene.hit(from_above, T(0), infinity<T>, rec));
            CHECK((rec.material == first_of(1, 3) && rec.normal == vec3<T>(0, 0, 1) && rec.untouched == 42));
            CHECK(all[rec.indices[0]].material == rec.material);
            REQUIRE(scene.hit(from_below, T(0), infinity<T>, rec));
            CHECK((rec.material == first_of(2, 4) && rec.normal == vec3<T>(0, 0, -1)));
            CHECK(all[rec.indices[0]].material == rec.material);
        };
        check(group{all});
        check(bvh(all));
        check(transformed{bvh(all), transform<T>{}});
    } while (std::next_permutation(all.begin(), all.end(), earlier));
}

}  // namespace
}  // namespace raio::test
