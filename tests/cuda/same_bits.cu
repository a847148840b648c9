// A graphics card answers with the bits that its host answers with: every shape of same_bits.cpp, hit by hit.
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <type_traits>
#include <vector>

#include "support/portable_shapes.hpp"

namespace {

void check(cudaError_t error) {
    if (error == cudaSuccess) return;
    std::fprintf(stderr, "%s\n", cudaGetErrorString(error));
    std::exit(1);
}

/// Memory that the card knows by the host's addresses.
template <class Item>
struct pinned {
    using value_type = Item;
    Item* allocate(std::size_t count) {
        void* items = nullptr;
        check(cudaMallocHost(&items, count * sizeof(Item)));
        return static_cast<Item*>(items);
    }
    void deallocate(Item* items, std::size_t) { check(cudaFreeHost(items)); }
    bool operator==(const pinned&) const = default;
};

template <class T>
struct question {
    raio::ray<T> ray;
    bool hit = false;
    raio::hit_record<T> rec{};
};

template <class Shape, class T>
__host__ __device__ void ask(const Shape& shape, question<T>& q) {
    q.hit = shape.hit(q.ray, T(0), raio::infinity<T>, q.rec);
}

template <class Shape, class T>
__global__ void ask_all(const Shape* shapes, question<T>* questions, std::size_t count) {
    const std::size_t i = std::size_t(blockIdx.x) * blockDim.x + threadIdx.x;
    if (i < count) ask(shapes[i], questions[i]);
}

/// What the contract promises, as bits: the rest of a record is near enough.
template <class T>
bool same_answer(const question<T>& a, const question<T>& b) {
    if (!a.hit || !b.hit) return a.hit == b.hit;
    const auto promised = [](const raio::hit_record<T>& r) {
        return std::array{r.t, r.point.x, r.point.y, r.point.z, r.normal.x, r.normal.y, r.normal.z};
    };
    const auto of_a = promised(a.rec), of_b = promised(b.rec);
    return a.rec.front_face == b.rec.front_face && std::memcmp(&of_a, &of_b, sizeof of_a) == 0;
}

/// How many of so many rays the card has another answer for.
template <class T, class Make>
std::ptrdiff_t other_answers(std::size_t rays, const char* name, Make make) {
    raio::test::portable_numbers numbers;
    using shape = decltype(make(numbers));
    std::vector<shape, pinned<shape>> shapes;
    std::vector<question<T>> expected;
    shapes.reserve(rays), expected.reserve(rays);
    for (std::size_t i = 0; i < rays; ++i) {
        shapes.push_back(make(numbers));
        expected.push_back({numbers.aimed_ray<T>()});
    }

    std::vector<question<T>, pinned<question<T>>> answers(expected.begin(), expected.end());
    ask_all<<<unsigned((rays + 127) / 128), 128>>>(shapes.data(), answers.data(), rays);
    check(cudaGetLastError());
    for (std::size_t i = 0; i < rays; ++i) ask(shapes[i], expected[i]);
    check(cudaDeviceSynchronize());

    std::ptrdiff_t hits = 0, others = 0;
    for (std::size_t i = 0; i < rays; ++i) {
        hits += expected[i].hit;
        others += !same_answer(expected[i], answers[i]);
    }
    std::printf("%-27s %-6s %8td hits, %td other answers\n", name, sizeof(T) == 4 ? "float" : "double", hits, others);
    std::fflush(stdout);  // some take seconds, and who stops it is told how far it came
    return others;
}

template <class T>
std::ptrdiff_t other_answers(std::size_t rays) {
    std::ptrdiff_t all = 0;
    raio::test::for_every_portable_shape<T>([&](const char* name, auto make) {
        // What is in a std::vector stays with the host.
        using shape = std::invoke_result_t<decltype(make), raio::test::portable_numbers&>;
        if constexpr (std::is_trivially_destructible_v<shape>) all += other_answers<T>(rays, name, make);
    });
    return all;
}

}  // namespace

int main(int argc, char** argv) {
    const std::size_t rays = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 100'000;
    return other_answers<float>(rays) + other_answers<double>(rays) == 0 ? 0 : 1;
}
