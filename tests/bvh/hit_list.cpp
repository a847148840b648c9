#include <raio/bvh/hit_list.hpp>

#include <doctest/doctest.h>

#include <tuple>

#include <raio/shape/sphere.hpp>

#include "support/random.hpp"

namespace raio::test {

namespace {

hit_record<float> record(float t, std::uint32_t index) {
    hit_record<float> rec{};
    rec.t = t, rec.index = index, rec.front_face = index % 2 == 1;
    return rec;
}

using listed = std::tuple<float, bool, std::uint32_t>;  // t, back or front, index

std::vector<listed> places_of(std::span<const hit_record<float>> hits) {
    std::vector<listed> places;
    for (const hit_record<float>& rec : hits) places.emplace_back(rec.t, !rec.front_face, rec.index);
    return places;
}

}  // namespace

TEST_CASE("nearest_few, all_hits: sorted by t, then fronts first, then by index; the same crossing counts once") {
    random_numbers random(1);
    for (int run = 0; run < 2000; ++run) {
        std::vector<listed> expected;
        std::vector<hit_record<float>> records(static_cast<std::size_t>(random.integer(2, 9)));
        const auto room = std::span(records).subspan(1);
        detail::nearest_few<float> few(room, 100);
        detail::all_hits<float> all(100);
        for (int i = random.integer(0, 20); i > 0; --i) {
            const auto rec =
                record(static_cast<float>(random.integer(0, 5)), static_cast<std::uint32_t>(random.integer(0, 3)));
            records[0] = rec;  // is no part of the room
            few.add(rec), all.add(rec);
            expected.emplace_back(rec.t, !rec.front_face, rec.index);
            std::ranges::sort(expected);
            expected.erase(std::unique(expected.begin(), expected.end()), expected.end());

            const std::size_t count = std::min(room.size(), expected.size());
            REQUIRE(few.count() == count);
            REQUIRE(places_of(room.first(count)) ==
                    std::vector(expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(count)));
            // Nothing beyond the last is wanted once there is no room for it.
            REQUIRE(few.farthest() == (count < room.size() ? 100.0f : room.back().t));
            REQUIRE(all.farthest() == 100);
        }
        REQUIRE(places_of(std::move(all).sorted()) == expected);
    }
}

TEST_CASE_TEMPLATE("for_each_crossing: all of a shape in the window, in order, until it is enough", T, RAIO_NUMBERS) {
    const sphere<T> ball{{0, 0, 0}, 1};
    const auto crossings = [&](const ray<T>& r, T t_min, T t_max, std::size_t enough = 10) {
        std::vector<T> found;
        detail::for_each_crossing(ball, r, t_min, t_max, 7, [&](const hit_record<T>& rec) {
            CHECK(rec.index == 7);
            found.push_back(rec.t);
            return found.size() < enough;
        });
        return found;
    };
    const ray<T> across{{0, 0, 3}, {0, 0, -1}}, along{{1, 0, 3}, {0, 0, -1}}, past{{2, 0, 3}, {0, 0, -1}};
    CHECK(crossings(across, 0, infinity<T>) == std::vector<T>{2, 4});
    CHECK(crossings(across, 0, infinity<T>, 1) == std::vector<T>{2});
    CHECK(crossings(across, 2, 4) == std::vector<T>{2, 4});
    CHECK(crossings(across, T(2.5), infinity<T>) == std::vector<T>{4});
    CHECK(crossings(across, 0, T(3.5)) == std::vector<T>{2});
    CHECK(crossings(across, T(2.5), T(3.5)).empty());
    CHECK(crossings(along, 0, infinity<T>) == std::vector<T>{3});  // both in one place
    CHECK(crossings(past, 0, infinity<T>).empty());
}

}  // namespace raio::test
