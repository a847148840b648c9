#pragma once

#include <cstdint>

#include "scene.hpp"

namespace render {

/// The random numbers of one sample of one pixel. They follow from the seed, the pixel, the sample's number and how
/// many were drawn before, and from nothing else: not from the thread, nor from the order in which pixels are rendered.
///
/// The samples of a pixel are spread evenly: they are the points of the Sobol sequence, each pair of dimensions
/// shuffled and scrambled on its own (Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020). A power of two
/// of them is best.
class sampler {
public:
    sampler(std::uint64_t seed, std::uint64_t pixel, std::uint32_t sample)
        : key_(mixed(mixed(seed) ^ pixel)), sample_(sample) {}

    /// The next point, uniform in [0, 1)^2.
    vec2 next_2d() {
        const std::uint64_t shuffle = mixed(++key_), scramble = mixed(shuffle);
        const std::uint32_t index = scrambled(sample_, low_half(shuffle));
        return {unit(scrambled(reversed(index), low_half(scramble))),
                unit(scrambled(sobol(index), low_half(scramble >> 32)))};
    }

    /// The next number, uniform in [0, 1).
    number next_1d() { return next_2d().x; }

private:
    std::uint64_t key_;
    std::uint32_t sample_;

    static number unit(std::uint32_t bits) { return number(bits) * 0x1p-32; }
    static std::uint32_t low_half(std::uint64_t bits) { return static_cast<std::uint32_t>(bits); }

    /// The output function of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014).
    static std::uint64_t mixed(std::uint64_t x) {
        x += 0x9e3779b97f4a7c15;
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
        x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
        return x ^ (x >> 31);
    }

    static std::uint32_t reversed(std::uint32_t x) {
        x = (x >> 16) | (x << 16);
        x = ((x & 0xff00ff00) >> 8) | ((x & 0x00ff00ff) << 8);
        x = ((x & 0xf0f0f0f0) >> 4) | ((x & 0x0f0f0f0f) << 4);
        x = ((x & 0xcccccccc) >> 2) | ((x & 0x33333333) << 2);
        return ((x & 0xaaaaaaaa) >> 1) | ((x & 0x55555555) << 1);
    }

    /// The second dimension of the Sobol sequence; the first is the reversed index.
    static std::uint32_t sobol(std::uint32_t index) {
        std::uint32_t x = 0;
        for (std::uint32_t column = 0x80000000; index != 0; index >>= 1, column ^= column >> 1) {
            if (index & 1) x ^= column;
        }
        return x;
    }

    /// Flips every bit or not, as the seed and all higher bits say: Owen's scrambling, with the permutation of Burley's
    /// listing.
    static std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
        x = reversed(x) + seed;
        x ^= x * 0x6c50b47c;
        x ^= x * 0xb82f1e52;
        x ^= x * 0xc7afe638;
        x ^= x * 0x8d22f6e6;
        return reversed(x);
    }
};

}  // namespace render
