#pragma once

#include <raio/push_macros.hpp>

#include <array>
#include <cstring>

#include <raio/number/pack_mask.hpp>

/// \file
/// Many numbers that go through one formula together: a shape of packs is as many shapes, a ray of packs as many rays.
///
///     ray<pack<float>> packet;          // as many rays as the processor's registers have lanes
///     sphere<pack<float, 8>> leaf;      // eight spheres, in one register or in as many as it takes
///
/// What a pack answers is what the plain numbers in its lanes answer, bit for bit (proof/settle_lanes.hpp).
///
/// The registers are those of xsimd. Where it is not installed, in CUDA, and where RAIO_WITHOUT_XSIMD is defined, a
/// `pack<S>` has one lane, and a `pack<S, N>` is N plain numbers.

namespace raio::inline RAIO_ABI::inline RAIO_REGISTERS {

/// N numbers S: `float`, `double` or `strict_double`, or, to count with, unsigned ones of the same
/// size.
template <class S, std::size_t N = detail::native_lanes<S>>
class pack {
    static constexpr bool is_strict = !std::is_arithmetic_v<S>;
    using held = std::conditional_t<std::is_arithmetic_v<S>, S, double>;  // what registers know
    static_assert(std::is_arithmetic_v<held> && (sizeof(S) == 4 || sizeof(S) == 8) && 1 <= N && N <= 32);

public:
    using mask = pack_mask<std::conditional_t<sizeof(S) == 4, float, double>, N>;

    /// How many numbers.
    static constexpr std::size_t lanes = N;

    pack() = default;
    /// The same number in every lane.
    template <class Number>
    requires std::is_arithmetic_v<Number> RAIO_FN constexpr pack(Number value) {
        detail::fill(registers_, [&](std::size_t) { return register_type(static_cast<held>(value)); });
    }
    RAIO_FN constexpr pack(S value) requires(!std::is_arithmetic_v<S>) : pack(static_cast<held>(value)) {}

    /// The same numbers, as S.
    template <class From>
    requires(!std::same_as<From, S>) RAIO_FN explicit pack(const pack<From, N>& from) {
        using other = typename pack<From, N>::held;
        if constexpr (std::same_as<other, held>) {
            std::memcpy(&registers_, &from, sizeof(pack));
        } else {
#if defined(__GNUC__) && !defined(__CUDACC__)
            if constexpr (std::has_single_bit(N)) {
                using numbers [[gnu::vector_size(N * sizeof(other))]] = other;
                using converted [[gnu::vector_size(N * sizeof(held))]] = held;
                numbers given;
                std::memcpy(&given, &from, sizeof(given));
                const converted made = __builtin_convertvector(given, converted);
                std::memcpy(&registers_, &made, sizeof(pack));
                return;
            }
#endif
            std::array<other, N> numbers;
            std::array<held, N> converted;
            std::memcpy(&numbers, &from, sizeof(numbers));
            for (std::size_t i = 0; i < N; ++i) converted[i] = static_cast<held>(numbers[i]);
            std::memcpy(&registers_, &converted, sizeof(pack));
        }
    }

    /// N numbers that stand one after the other in memory, aligned or not.
    RAIO_FN static pack load(const S* from) {
        pack result;
        std::memcpy(&result.registers_, from, sizeof(pack));
        return result;
    }
    RAIO_FN void store(S* to) const { std::memcpy(to, &registers_, sizeof(pack)); }

    RAIO_FN S operator[](std::size_t lane) const {
        S value;
        std::memcpy(&value, reinterpret_cast<const char*>(&registers_) + lane * sizeof(S), sizeof(S));
        return value;
    }
    RAIO_FN void set(std::size_t lane, S value) {
        std::memcpy(reinterpret_cast<char*>(&registers_) + lane * sizeof(S), &value, sizeof(S));
    }

    RAIO_FN constexpr pack operator-() const { return pack(S(-0.0)) - *this; }
    RAIO_FN friend constexpr pack operator+(const pack& a, const pack& b) {
        return made([&](std::size_t i) { return a.registers_[i] + b.registers_[i]; });
    }
    RAIO_FN friend constexpr pack operator-(const pack& a, const pack& b) {
        return made([&](std::size_t i) { return a.registers_[i] - b.registers_[i]; });
    }
    RAIO_FN friend constexpr pack operator*(const pack& a, const pack& b) {
        return made([&](std::size_t i) {
            if constexpr (is_strict) {
                return detail::rounded_product(a.registers_[i], b.registers_[i]);
            } else {
                return a.registers_[i] * b.registers_[i];
            }
        });
    }
    RAIO_FN friend constexpr pack operator/(const pack& a, const pack& b) {
        return made([&](std::size_t i) { return a.registers_[i] / b.registers_[i]; });
    }
    RAIO_FN constexpr pack& operator+=(const pack& b) { return *this = *this + b; }
    RAIO_FN constexpr pack& operator-=(const pack& b) { return *this = *this - b; }
    RAIO_FN constexpr pack& operator*=(const pack& b) { return *this = *this * b; }
    RAIO_FN constexpr pack& operator/=(const pack& b) { return *this = *this / b; }

    RAIO_FN friend constexpr mask operator==(const pack& a, const pack& b) {
        return compared([&](std::size_t i) { return a.registers_[i] == b.registers_[i]; });
    }
    RAIO_FN friend constexpr mask operator!=(const pack& a, const pack& b) { return !(a == b); }
    RAIO_FN friend constexpr mask operator<(const pack& a, const pack& b) {
        return compared([&](std::size_t i) { return a.registers_[i] < b.registers_[i]; });
    }
    RAIO_FN friend constexpr mask operator<=(const pack& a, const pack& b) {
        return compared([&](std::size_t i) { return a.registers_[i] <= b.registers_[i]; });
    }
    RAIO_FN friend constexpr mask operator>(const pack& a, const pack& b) { return b < a; }
    RAIO_FN friend constexpr mask operator>=(const pack& a, const pack& b) { return b <= a; }

    RAIO_FN friend constexpr pack select(const mask& where, const pack& a, const pack& b) {
        return selected(where, a, b);
    }

    /// As the minimum and the maximum of plain numbers: `a`, unless `b` is smaller or larger.
    RAIO_FN static constexpr pack min(const pack& a, const pack& b) {
        return made([&](std::size_t i) { return detail::lesser(a.registers_[i], b.registers_[i]); });
    }
    RAIO_FN static constexpr pack max(const pack& a, const pack& b) {
        return made([&](std::size_t i) { return detail::greater(a.registers_[i], b.registers_[i]); });
    }

    RAIO_FN static constexpr pack flip(const pack& x, const pack& sign) {
        return made([&](std::size_t i) { return detail::flipped(x.registers_[i], sign.registers_[i]); });
    }

    /// a b + c, rounded once.
    RAIO_FN friend pack fma(const pack& a, const pack& b, const pack& c) requires is_strict {
        return made([&](std::size_t i) { return detail::fused(a.registers_[i], b.registers_[i], c.registers_[i]); });
    }
    RAIO_FN friend constexpr pack sqrt(const pack& x) {
        return made([&](std::size_t i) { return sqrt(x.registers_[i]); });
    }
    RAIO_FN friend constexpr pack abs(const pack& x) {
        return made([&](std::size_t i) { return abs(x.registers_[i]); });
    }
    RAIO_FN friend constexpr pack floor(const pack& x) {
        if constexpr (detail::floors_any_number) return made([&](std::size_t i) { return floor(x.registers_[i]); });
        // A number this large has no fraction, and would not fit the integers that xsimd takes it to on old processors.
        const mask whole = !(abs(x) < pack(S(1) / std::numeric_limits<S>::epsilon()));
        pack small = select(whole, pack(0), x);
        return select(whole, x, made([&](std::size_t i) { return floor(small.registers_[i]); }));
    }
    RAIO_FN friend constexpr pack sin(const pack& x) {
        return made([&](std::size_t i) { return detail::trigonometry<register_type>::sine(x.registers_[i]); });
    }
    RAIO_FN friend constexpr pack cos(const pack& x) {
        return made([&](std::size_t i) { return detail::trigonometry<register_type>::cosine(x.registers_[i]); });
    }
    RAIO_FN friend constexpr pack copysign(const pack& magnitude, const pack& sign) {
        return made([&](std::size_t i) { return copysign(magnitude.registers_[i], sign.registers_[i]); });
    }
    RAIO_FN friend constexpr pack atan2(const pack& y, const pack& x) {
        return made([&](std::size_t i) {
            return detail::trigonometry<register_type>::arc_tangent(y.registers_[i], x.registers_[i]);
        });
    }

private:
    template <class, std::size_t>
    friend class pack;

    using register_type = detail::register_of<held, N>;
    static constexpr std::size_t count = N * sizeof(S) / sizeof(register_type);

    template <class F>
    RAIO_FN static constexpr pack made(F f) {
        pack result;
        detail::fill(result.registers_, f);
        return result;
    }
    template <class F>
    RAIO_FN static constexpr mask compared(F f) {
        return mask::compared(f);
    }

    RAIO_FN static constexpr pack selected(const mask& where, const pack& a, const pack& b) {
        // Integers as the floating-point numbers whose mask it is: xsimd 8 selects no others without optimisation.
        using choice = detail::register_of<std::conditional_t<sizeof(S) == 4, float, double>, N>;
        return made([&](std::size_t i) {
            return std::bit_cast<register_type>(select(where.of_register(i), std::bit_cast<choice>(a.registers_[i]),
                                                       std::bit_cast<choice>(b.registers_[i])));
        });
    }

    register_type registers_[count];
};

}  // namespace raio::inline RAIO_ABI::inline RAIO_REGISTERS

namespace raio::inline RAIO_ABI {

template <class S, std::size_t N>
struct real_traits<pack<S, N>> {
    using scalar = S;
    using mask = typename pack<S, N>::mask;
    using index = pack<std::conditional_t<sizeof(S) == 4, std::uint32_t, std::uint64_t>, N>;
    using working = pack<strict_double, N>;
    using exact = pack<S, N>;
    using bound = pack<S, N>;
};

/// As with one double, two of them settle what one leaves open.
template <std::size_t N>
struct real_traits<pack<double, N>> {
    using scalar = double;
    using mask = typename pack<double, N>::mask;
    using index = pack<std::uint64_t, N>;
    using working = pack<strict_double, N>;
    using exact = basic_double_double<pack<strict_double, N>>;
    using bound = pack<double, N>;
};

template <std::size_t N>
struct wide<pack<float, N>> {
    using type = pack<double, N>;
};

// A mask that is no bits becomes numbers, which are converted, and a mask again.
template <std::floating_point S, std::size_t N>
template <std::floating_point Other>
requires(!std::same_as<Other, S>) RAIO_FN constexpr pack_mask<S, N>::pack_mask(const pack_mask<Other, N>& other) {
    if constexpr (is_bits && pack_mask<Other, N>::is_bits) {
        parts_[0] = other.parts_[0];
    } else {
        *this = pack<S, N>(select(other, pack<Other, N>(1), pack<Other, N>(0))) > pack<S, N>(0);
    }
}

// One number that converts to a pack: the compiler knows it, as it would not know a pack.
template <class S, std::size_t N>
inline constexpr S infinity<pack<S, N>> = infinity<S>;
template <class S, std::size_t N>
inline constexpr double infinity<basic_double_double<pack<S, N>>> = infinity<double>;
template <class S, std::size_t N>
inline constexpr S pi<pack<S, N>> = pi<S>;

}  // namespace raio::inline RAIO_ABI

template <class S, std::size_t N>
class std::numeric_limits<raio::pack<S, N>> : public std::numeric_limits<S> {};

#include <raio/pop_macros.hpp>
