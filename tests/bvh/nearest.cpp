#include <raio/bvh/nearest.hpp>

#include <doctest/doctest.h>

#include <tuple>

#include <raio/shape/convex_polyhedron.hpp>
#include <raio/shape/sphere.hpp>

#include "support/random.hpp"

namespace raio::test {

namespace {

/// A shape that every ray meets at one t, or none does, and that counts how often it is asked.
template <class T>
struct mark {
    using number = T;

    bool exists;
    T t;
    int* asked;
    bool front = false;

    bool occluded(const ray<T>&, T t_min, T t_max) const { return exists && t_min <= t && t <= t_max; }
    bool hit(const ray<T>& ray, T t_min, T t_max, hit_record<T>& rec) const {
        ++*asked;
        if (!occluded(ray, t_min, t_max)) return false;
        rec = {}, rec.t = t, rec.point = vec3<T>(t, 0, 0), rec.front_face = front;
        return true;
    }
};

/// A mark with its id, and what packs know of it: that it lies between t - error and t + error, or nothing.
template <class T>
struct known_mark {
    mark<T> shape;
    std::uint32_t id;
    bool certain;
    T error;
};

template <class Number>
struct leaves_of_marks {
    using T = Number;
    using shape_type = known_mark<T>;
    static constexpr std::size_t lanes = 4;

    std::vector<std::vector<known_mark<T>>> leaves;

    std::uint32_t used(std::uint32_t i) const { return (1u << leaves[i].size()) - 1; }
    std::uint32_t id(std::uint32_t i, unsigned lane) const { return leaves[i][lane].id; }
    const mark<T>& shape(std::uint32_t i, unsigned lane) const { return leaves[i][lane].shape; }

    detail::findings<T, lanes> find(std::uint32_t i, const ray<T>&, T t_min, T t_max) const {
        std::array<T, lanes> low{}, high{};
        detail::findings<T, lanes> found{};
        for (std::size_t lane = 0; lane < leaves[i].size(); ++lane) {
            const known_mark<T>& m = leaves[i][lane];
            low[lane] = m.shape.t - m.error, high[lane] = m.shape.t + m.error;
            const bool inside = t_min <= low[lane] && high[lane] <= t_max;
            const bool outside = high[lane] < t_min || t_max < low[lane] || !m.shape.exists;
            if (!m.certain || (!inside && !outside)) found.open |= 1u << lane;
            if (m.certain && inside && !outside) found.sure |= 1u << lane;
        }
        found.low = pack<T, lanes>::load(low.data()), found.high = pack<T, lanes>::load(high.data());
        return found;
    }
};

template <class T>
using marks = detail::leaf_kinds<leaves_of_marks<T>, leaves_of_marks<T>>;
template <class T>
using nearest_mark = detail::nearest<T, marks<T>, ray<T>, hit_record<T>>;

}  // namespace

TEST_CASE_TEMPLATE("nearest: what a loop finds, whatever packs know", T, RAIO_NUMBERS) {
    random_numbers random(1);
    const int scenes = at_least(5000);
    int hits = 0, asked = 0;
    for (int i = 0; i < scenes; ++i) {
        marks<T> leaves;
        std::vector<known_mark<T>> all;
        const int count = random.integer(1, 30);
        for (int k = 0; k < count; ++k) {
            known_mark<T> m{{!random.one_in(5), T(random.integer(0, 8)), &asked, random.one_in(2)},
                            static_cast<std::uint32_t>(count - k),
                            !random.one_in(3),
                            T(random.integer(0, 4)) / 2};
            if (k > 0 && random.one_in(10)) m = all[static_cast<std::size_t>(random.integer(0, k - 1))];
            auto& kind = random.one_in(2) ? std::get<0>(leaves.all) : std::get<1>(leaves.all);
            if (kind.leaves.empty() || kind.leaves.back().size() == 4 || random.one_in(3)) kind.leaves.emplace_back();
            kind.leaves.back().push_back(m);
            all.push_back(m);
        }
        const T t_min = T(random.integer(-1, 4)), t_max = random.one_in(2) ? infinity<T> : T(random.integer(0, 9));
        const ray<T> along{{0, 0, 0}, {1, 0, 0}};
        const known_mark<T>* expected = nullptr;
        for (const known_mark<T>& m : all) {
            if (!m.shape.occluded(along, t_min, t_max)) continue;
            const auto order = [](const known_mark<T>& of) { return std::tuple(of.shape.t, !of.shape.front, of.id); };
            const bool first = expected == nullptr || order(m) < order(*expected);
            if (first) expected = &m;
        }
        hit_record<T> rec{};
        rec.t = T(77), rec.index = 77;
        nearest_mark<T> query(leaves, along, t_min, t_max, rec);
        const std::size_t most = std::max(std::get<0>(leaves.all).leaves.size(), std::get<1>(leaves.all).leaves.size());
        for (std::uint32_t block = 0; block < most; ++block) {
            if (block < std::get<0>(leaves.all).leaves.size()) query.template visit<0>(block);
            if (block < std::get<1>(leaves.all).leaves.size()) query.template visit<1>(block);
            REQUIRE((expected == nullptr || expected->shape.t <= query.farthest()));
        }
        REQUIRE(query.finish() == (expected != nullptr));
        REQUIRE(rec.t == (expected != nullptr ? expected->shape.t : T(77)));
        REQUIRE(rec.index == (expected != nullptr ? expected->id : 77));
        if (expected != nullptr)
            REQUIRE((rec.point == vec3<T>(rec.t, 0, 0) && rec.front_face == expected->shape.front));
        hits += expected != nullptr ? 1 : 0;
    }
    CHECK((hits > scenes / 5 * 2 && hits < scenes / 50 * 49));
}

TEST_CASE_TEMPLATE("nearest: nobody but the nearest is asked where packs can tell, and what is open waits", T,
                   RAIO_NUMBERS) {
    int asked = 0;
    const auto at = [&](T t, std::uint32_t id, bool certain) {
        return known_mark<T>{{true, t, &asked}, id, certain, T(0.25)};
    };
    marks<T> leaves;
    std::get<0>(leaves.all).leaves = {{at(5, 0, true), at(3, 1, true), at(4, 2, true)}, {at(6, 3, true)}};
    std::get<1>(leaves.all).leaves = {{at(2, 4, true)}, {at(1, 5, false), at(7, 6, false)}};
    const ray<T> along{{0, 0, 0}, {1, 0, 0}};
    hit_record<T> rec{};
    nearest_mark<T> query(leaves, along, T(0), infinity<T>, rec);
    CHECK(query.farthest() == infinity<T>);
    query.template visit<0>(0);
    CHECK(query.farthest() == T(3.25));
    query.template visit<0>(1);
    CHECK(query.farthest() == T(3.25));
    query.template visit<1>(0);
    CHECK(query.farthest() == T(2.25));
    CHECK(asked == 0);
    REQUIRE(query.finish());
    CHECK((rec.t == T(2) && rec.index == 4 && asked == 1));

    nearest_mark<T> open(leaves, along, T(0), infinity<T>, rec);
    open.template visit<1>(1), open.template visit<1>(0);
    CHECK((asked == 1 && open.farthest() == T(2.25)));
    REQUIRE(open.finish());
    CHECK((rec.t == T(1) && rec.index == 5));
    CHECK(asked == 3);  // both that were open, and not the one that is beyond the first of them
}

TEST_CASE("nearest: a ray that was mapped, of shapes that have packs or none") {
    using kinds = detail::leaf_kinds<detail::leaf_blocks<sphere<float>>, detail::leaf_list<convex_polyhedron<float>>>;
    kinds leaves;
    auto& [spheres, solids] = leaves.all;
    const std::uint32_t ids[] = {0, 1, 2};
    const detail::leaf_range of_spheres[] = {{0, 2}}, of_solids[] = {{0, 1}};
    const sphere<float> in_front{{0, 0, -4}, 1}, behind{{0, 0, -9}, 1};
    const convex_polyhedron<float> half{{{{0, 0, 1}, 6}}};  // below z = -6
    spheres.resize(of_spheres), solids.resize(of_solids);
    spheres.fill(0, std::span(ids).first(2), [&](std::uint32_t id) { return id == 0 ? behind : in_front; });
    solids.fill(0, std::span(ids).last(1), [&](std::uint32_t) { return half; });
    const auto check = [&](const ray<float>& world, const vec3<float>& moved, auto& shape, std::uint32_t index) {
        const inverse_map<float> map(translation<float>(moved));
        const mapped_ray<float> ray(world, map);
        hit_record<float> rec{}, expected{};
        detail::nearest<float, kinds, mapped_ray<float>, hit_record<float>> query(leaves, ray, 0.0f, infinity<float>,
                                                                                  rec);
        query.visit<0>(0), query.visit<1>(0);
        REQUIRE(query.finish());
        REQUIRE(detail::hit(shape, ray, 0.0f, infinity<float>, expected));
        CHECK((rec.t == expected.t && rec.point == expected.point && rec.normal == expected.normal));
        CHECK(rec.index == index);
    };
    check({{0.1f, 0.1f, 0}, {0.01f, 0, -1}}, {0, 0, 0}, in_front, 1);
    check({{1, 0, 0}, {0, 0, -1}}, {-1e-12f, 0, 0}, half, 2);  // rounded to a float it would touch the spheres
    check({{0.1f, 0.1f, 0}, {0, 0, -1}}, {0, 0, 7}, behind, 0);

    // What knows plain rays only; a miss records nothing.
    int asked = 0;
    hit_record<float> rec{};
    rec.t = 77;
    const ray<float> world{{0, 0, 0}, {1, 0, 0}};
    const inverse_map<float> none(transform<float>{});
    const mapped_ray<float> ray(world, none);
    CHECK((!detail::hit(mark<float>{false, 5, &asked}, ray, 0.0f, infinity<float>, rec) && rec.t == 77));
    CHECK((detail::hit(mark<float>{true, 5, &asked}, ray, 0.0f, infinity<float>, rec) && rec.t == 5));
}

}  // namespace raio::test
