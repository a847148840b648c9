#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <raio/bvh/bvh.hpp>
#include <raio/raio.hpp>

/// Built without exceptions and run-time types, and once more without threads: a tree answers as its loop, and what is
/// refused ends in the same words.
namespace {

using namespace raio;

const char* const expected = "raio::bvh: shape 7 has no finite bounds";

[[noreturn]] void end_if_expected(const char* message) {
    std::printf("%s\n", message);
    std::exit(std::strcmp(message, expected) == 0 ? 0 : 1);
}

void check(bool holds, const char* what) {
    if (holds) return;
    std::printf("wrong: %s\n", what);
    std::exit(1);
}

void refuse_nan(std::vector<sphere<float>> balls) {
    balls[7].center.z = std::numeric_limits<float>::quiet_NaN();
    const bvh tree(std::span<const sphere<float>>(balls), {.threads = 4});
    check(false, "a NaN is not refused");
}

}  // namespace

int main() {
    std::vector<sphere<float>> balls;
    for (int i = 0; i < 30'000; ++i) {
        balls.push_back({{float(i % 31), float(i / 31 % 31), float(i / 961)}, 0.25f});
    }
    const bvh tree(std::span<const sphere<float>>(balls), {.threads = 4});
    const group loop{balls};
    for (int i = 0; i < 100; ++i) {
        const ray<float> ray{{-5, float(i % 10), 3}, {20, float(i / 10), float(i % 7)}};
        hit_record<float> expected_rec, rec;
        const bool hit = loop.hit(ray, 0, infinity<float>, expected_rec);
        check(tree.hit(ray, 0, infinity<float>, rec) == hit, "the tree's hit");
        if (hit) check(rec.t == expected_rec.t && rec.index == expected_rec.index, "the tree's record");
    }
    const any_solid<float> any{union_of(balls[0], balls[1])};
    check(any.occluded({{-5, 0, 0}, {1, 0, 0}}, 0, infinity<float>), "any_solid");

#if defined(__cpp_exceptions)
    check(detail::thread_count(8) == 1, "there are threads");
    try {
        refuse_nan(balls);
    } catch (const std::invalid_argument& refused) {
        end_if_expected(refused.what());
    }
#else
    on_failure = end_if_expected;
    refuse_nan(balls);
#endif
    return 1;
}
