#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "support/portable_shapes.hpp"
#include "support/random.hpp"

/// \file
/// The answers are the same bits whatever the compiler, the optimisation and the processor: every build of the tests,
/// with or without fused multiply-adds, must come to the checksums below. They change when a shape's answers change,
/// and only then.

namespace raio::test {

namespace {

/// Fowler, Noll and Vo's hash (1a, 64 bits).
class checksum {
public:
    template <class T>
    void add(T x) {
        using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
        for (auto b = std::bit_cast<bits>(x); b != 0; b = static_cast<bits>(b >> 8)) {
            value_ = (value_ ^ (b & 0xff)) * 1099511628211u;
        }
        value_ = (value_ ^ 0x100) * 1099511628211u;
    }
    template <class T>
    void add(const vec3<T>& v) {
        add(v.x);
        add(v.y);
        add(v.z);
    }
    template <class T>
    void add(const hit_record<T>& rec) {
        add(rec.t);
        add(rec.point);
        add(rec.normal);
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 14695981039346656037u;
};

template <class T, class Make>
std::uint64_t checksum_of_hits(int rays, Make make) {
    portable_numbers numbers;
    checksum sum;
    for (int i = 0; i < rays; ++i) {
        const auto shape = make(numbers);
        hit_record<T> rec{};
        if (!shape.hit(numbers.aimed_ray<T>(), T(0), infinity<T>, rec)) continue;
        sum.add(rec);
    }
    return sum.value();
}

/// The same, as many at a time as a pack has lanes.
template <class P, class Make>
std::uint64_t checksum_of_packs(int rays, Make make) {
    using T = scalar_t<P>;
    portable_numbers numbers;
    checksum sum;
    for (int i = 0; i < rays; i += int(P::lanes)) {
        detail::gathered_numbers<decltype(make(numbers)), P::lanes> shapes;
        ray<P> along;
        for (std::size_t lane = 0; lane < P::lanes; ++lane) {
            shapes.set(lane, make(numbers));
            const ray<T> r = numbers.aimed_ray<T>();
            detail::set_lane(along.origin, lane, r.origin), detail::set_lane(along.direction, lane, r.direction);
        }
        hit_record<P> rec{};
        const auto hit = shapes.shapes().hit(along, P(0), P(infinity<T>), rec);
        for (std::size_t lane = 0; lane < P::lanes; ++lane) {
            if (hit[lane]) sum.add(detail::in_lane<P>(rec, lane));
        }
    }
    return sum.value();
}

/// As they stand below.
std::string hexadecimal(const std::vector<std::uint64_t>& sums) {
    std::ostringstream text;
    for (const std::uint64_t sum : sums) text << std::hex << std::showbase << sum << ", ";
    return text.str();
}

template <class T>
std::vector<std::uint64_t> checksums(int rays) {
    std::vector<std::uint64_t> sums;
    for_every_portable_shape<T>([&](const char*, auto make) { sums.push_back(checksum_of_hits<T>(rays, make)); });
    return sums;
}

}  // namespace

TEST_CASE("the same bits: packs of floats") {
    using numbers = portable_numbers;
    const auto check = [](auto make) {
        const int rays = 16'000;
        CHECK(checksum_of_packs<pack<float>>(rays, make) == checksum_of_hits<float>(rays, make));
    };
    check([](numbers& n) { return sphere<float>{n.point<float>(), n.length<float>()}; });
    check([](numbers& n) { return triangle<float>{n.point<float>(), n.point<float>(), n.point<float>()}; });
    check([](numbers& n) { return cylinder<float>{n.point<float>(), n.point<float>(), n.length<float>()}; });
    check([](numbers& n) { return cone<float>{n.point<float>(), n.point<float>(), n.length<float>()}; });
}

TEST_CASE("the same bits: float") {
    const std::vector<std::uint64_t> expected{
        0x72dcaf02773e175c, 0x1c539f0091ad6c85, 0x4d780105d2c50899, 0x53c27b18a46e4d0c, 0x53c27b18a46e4d0c,
        0x2dcdae2ac9204157, 0x78fbfc6cd8f0fdb1, 0xac26419637f56555, 0x42b228aa366777e1, 0x52a25381ef295a28,
        0xaa76bc7c09bb3e18, 0xb860463c58fe0123, 0xf8e4f1e02b2ff753, 0xccedbf5ea15c15d6, 0xfc909468035b5723,
        0x57cb7033529f90a4, 0x711b379516895d48, 0x12f80cc0ef6c9f03, 0xd0ac8fac6f4dadac, 0x503476b7b706a37d,
        0xad3c692cb4ae5ff0, 0xf7606976606ee9db, 0x7db3d72872773e6e, 0xaa017697df6d279d, 0x00f18851c9f9f93b,
        0x0fd5a664db52ed00, 0xe062c10f4887c661, 0xa0955ed9aff66c6a, 0x1039ee477649fe06, 0x99869e65402a39b0,
        0x219cc565c82b883a, 0xb4e81577141142a9, 0x7c14edd526c5b7dc, 0x737e0bacc20919fe, 0xe343eb2ba0a86dad,
        0xc4c8c8103a5ec3a1, 0xdebd9905328a55e0, 0x34543f22c68df142, 0x75a4962b6493e0c5};
    CHECK(hexadecimal(checksums<float>(20'000)) == hexadecimal(expected));
}

TEST_CASE("the same bits: double") {
    const std::vector<std::uint64_t> expected{
        0x2f8220b990897fe6, 0x451cf41d5a9f7dad, 0x04f9c530e62b81d2, 0xf174f7b0bf34c42d, 0xe1e59bbcff99ebf7,
        0xcbd6e0c1a10fb508, 0xde35d88cafad3bb6, 0x2036cc7698346f61, 0x3512e0b8c051434a, 0xa3621b6b7150f583,
        0x4e0c6c50e20c56c2, 0x5a26c912e34cb9f1, 0x26b7c1cabfb419bd, 0x60a1703e9de418c9, 0xa31ef8653511d11f,
        0x9057657f64eb6521, 0x3108260662e772f3, 0x7ac25e675d7723c8, 0xa5290846f8306b43, 0xc5e8ef9085fc5243,
        0xf8c14d3fdb01774f, 0x7e04ddb8cb714280, 0x86842076ae9912b0, 0x2bb832013711dfee, 0xb306d28dee278cc5,
        0xb7403b65b3a04d4b, 0xc7ad566aced42d9f, 0x053f12982ddebfff, 0xa1c0c6993d2beb12, 0x7934411e602efd05,
        0x7f77e21e0918525e, 0x93855b3421667992, 0x70dc462c04264799, 0x0de6d5bc79e65565, 0x55a74afaa4e61151,
        0xaa50490c54206922, 0xb741a028b7763b43, 0xf9480b4f44f9b3c2, 0xe3a18adaa7358a5b};
    CHECK(hexadecimal(checksums<double>(20'000)) == hexadecimal(expected));
}

// same_bits.cmake compares what several builds print.
TEST_CASE_TEMPLATE("the same bits: in a long run" * doctest::skip(), T, float, double) {
    MESSAGE(hexadecimal(checksums<T>(test_rays)));
}

}  // namespace raio::test
