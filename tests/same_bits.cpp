#include <raio/raio.hpp>

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <vector>

/// \file
/// The answers are the same bits whatever the compiler, the optimisation and the processor: every build of the tests,
/// with or without fused multiply-adds, must come to the checksums below. They change when a shape's answers change,
/// and only then.

namespace raio::test {

namespace {

/// Numbers that are the same everywhere, which the distributions of <random> are not (xorshift64; Marsaglia 2003).
class portable_numbers {
public:
    /// In [0, 1).
    double uniform() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return static_cast<double>(state_ >> 11) * 0x1p-53;
    }

    template <class T>
    T length() {
        return static_cast<T>(uniform());
    }

    /// Around the origin, up to twice the size away along each axis. The size is a power of two: its product is exact,
    /// so that nothing in this test depends on contraction either.
    template <class T>
    vec3<T> point(double size) {
        const double x = centred(), y = centred(), z = centred();
        return {static_cast<T>(x * size), static_cast<T>(y * size), static_cast<T>(z * size)};
    }

private:
    /// In (-2, 2), mostly near 0.
    double centred() {
        double sum = -2.0;
        for (int i = 0; i < 4; ++i) sum += uniform();
        return sum;
    }

    std::uint64_t state_ = 88172645463325252u;
};

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
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 14695981039346656037u;
};

template <class T, class Make>
std::uint64_t checksum_of_hits(Make make) {
    portable_numbers numbers;
    checksum sum;
    for (int i = 0; i < 20000; ++i) {
        const auto shape = make(numbers);
        const vec3<T> origin = numbers.point<T>(4), target = numbers.point<T>(1);
        hit_record<T> rec;
        if (!shape.hit({origin, target - origin}, T(0), infinity<T>, rec)) continue;
        sum.add(rec.t);
        sum.add(rec.point);
        sum.add(rec.normal);
    }
    return sum.value();
}

template <class T>
std::vector<std::uint64_t> checksums() {
    using numbers = portable_numbers;
    const auto some_half_space = [](numbers& n) { return half_space<T>{n.point<T>(1), -n.length<T>()}; };
    return {
        checksum_of_hits<T>([](numbers& n) {
            return sphere<T>{n.point<T>(1), n.length<T>()};
        }),
        checksum_of_hits<T>([](numbers& n) {
            return plane<T>{n.point<T>(1), n.point<T>(1)};
        }),
        checksum_of_hits<T>([](numbers& n) {
            return disc<T>{n.point<T>(1), n.point<T>(1), n.length<T>()};
        }),
        checksum_of_hits<T>([](numbers& n) {
            return triangle<T>{n.point<T>(1), n.point<T>(1), n.point<T>(1)};
        }),
        checksum_of_hits<T>([](numbers& n) {
            return watertight_triangle<T>{n.point<T>(1), n.point<T>(1), n.point<T>(1)};
        }),
        checksum_of_hits<T>([](numbers& n) {
            const vec3<T> corner = n.point<T>(1);
            return box<T>{corner, corner + vec3<T>{n.length<T>(), n.length<T>(), n.length<T>()}};
        }),
        checksum_of_hits<T>([](numbers& n) {
            return cylinder<T>{n.point<T>(1), n.point<T>(1), n.length<T>()};
        }),
        checksum_of_hits<T>([](numbers& n) {
            return open_cylinder<T>{n.point<T>(1), n.point<T>(1), n.length<T>()};
        }),
        checksum_of_hits<T>([&](numbers& n) {
            convex_polyhedron<T> some;
            for (int i = 0; i < 5; ++i) some.planes.push_back(some_half_space(n));
            return some;
        }),
        checksum_of_hits<T>([](numbers& n) {
            return torus<T>{n.point<T>(1), n.point<T>(1), n.length<T>(), n.length<T>()};
        }),
        checksum_of_hits<T>([](numbers& n) {
            return parallelogram<T>{n.point<T>(1), n.point<T>(1), n.point<T>(1)};
        }),
        checksum_of_hits<T>([](numbers& n) {
            return frustum<T>{n.point<T>(1), n.point<T>(1), n.length<T>(), n.length<T>()};
        }),
        checksum_of_hits<T>([](numbers& n) {
            return open_cone<T>{n.point<T>(1), n.point<T>(1), n.length<T>()};
        }),
    };
}

}  // namespace

TEST_CASE("the same bits: float") {
    const std::vector<std::uint64_t> expected{
        0x72dcaf02773e175c, 0x1c539f0091ad6c85, 0x4d780105d2c50899, 0x53c27b18a46e4d0c, 0x53c27b18a46e4d0c,
        0x2dcdae2ac9204157, 0x78fbfc6cd8f0fdb1, 0xac26419637f56555, 0x42b228aa366777e1, 0x52a25381ef295a28,
        0xaa76bc7c09bb3e18, 0xb860463c58fe0123, 0xf8e4f1e02b2ff753};
    CHECK(checksums<float>() == expected);
}

TEST_CASE("the same bits: double") {
    const std::vector<std::uint64_t> expected{
        0xaefcd9958e956a68, 0x5f88f17cc9ccd09c, 0x99b580ed13b93d70, 0xd2c2b3b26abedec8, 0xd2c2b3b26abedec8,
        0x134bf0b264e98f15, 0xf483cffbb816c57f, 0x782238aa0e51e9b1, 0x8737ebf08fcd3053, 0x6a25ace859c8bd0f,
        0xb3c889e3a168ea4f, 0x24783945e17c51a9, 0x606c7bf20f07f370};
    CHECK(checksums<double>() == expected);
}

}  // namespace raio::test
