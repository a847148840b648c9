#pragma once

#include <bit>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <raio/math/strict_double.hpp>

/// \file
/// The registers that packs live in, and the masks that comparisons of packs answer.
///
/// The registers are those of xsimd. Where it is not installed, in CUDA, and where RAIO_WITHOUT_XSIMD is defined, they
/// are plain numbers.

#if __has_include(<xsimd/xsimd.hpp>) && !defined(__CUDACC__) && !defined(RAIO_WITHOUT_XSIMD) && \
    (defined(__SSE2__) || defined(_M_X64) || defined(__ARM_NEON))

#include <xsimd/xsimd.hpp>

namespace raio::detail {

/// The widest register that N numbers fill without a rest; the plain number where there is none.
template <class S, std::size_t N, std::size_t Width = xsimd::batch<S>::size>
consteval auto find_register() {
    if constexpr (Width <= 1) {
        return std::type_identity<S>{};
    } else if constexpr (N % Width == 0 && !std::is_void_v<xsimd::make_sized_batch_t<S, Width>>) {
        return std::type_identity<xsimd::make_sized_batch_t<S, Width>>{};
    } else {
        return find_register<S, N, Width / 2>();
    }
}
template <class S, std::size_t N>
using register_of = typename decltype(find_register<S, N>())::type;

template <class S>
inline constexpr std::size_t native_lanes = xsimd::batch<S>::size;

// xsimd 8 cannot say the bits of a mask. Where they have registers of their own, the bits are the mask.
inline std::uint32_t bits_of(std::unsigned_integral auto mask) { return mask; }
#if XSIMD_WITH_SSE2
inline std::uint32_t bits_of(__m128 mask) { return static_cast<std::uint32_t>(_mm_movemask_ps(mask)); }
inline std::uint32_t bits_of(__m128d mask) { return static_cast<std::uint32_t>(_mm_movemask_pd(mask)); }
#endif
#if XSIMD_WITH_AVX
inline std::uint32_t bits_of(__m256 mask) { return static_cast<std::uint32_t>(_mm256_movemask_ps(mask)); }
inline std::uint32_t bits_of(__m256d mask) { return static_cast<std::uint32_t>(_mm256_movemask_pd(mask)); }
#endif
template <class S, class A>
std::uint32_t bits_of(const xsimd::batch_bool<S, A>& mask) {
    if constexpr (requires { mask.mask(); }) {
        return static_cast<std::uint32_t>(mask.mask());
    } else if constexpr (requires { bits_of(mask.data); }) {
        return bits_of(mask.data);
    } else {
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < mask.size; ++i) bits |= std::uint32_t{mask.get(i)} << i;
        return bits;
    }
}

}  // namespace raio::detail

#else

namespace raio::detail {

template <class S, std::size_t N>
using register_of = S;

template <class S>
inline constexpr std::size_t native_lanes = 1;

RAIO_FN constexpr std::uint32_t bits_of(bool mask) { return mask ? 1 : 0; }

}  // namespace raio::detail

#endif

namespace raio {

namespace detail {

/// What the comparison of two registers answers.
template <class Register>
using register_mask = decltype(std::declval<Register>() < std::declval<Register>());

/// A register whose floating-point numbers the compiler itself compares and selects.
template <class Register>
concept native_register = std::floating_point<typename Register::value_type> && requires(const Register a) {
    Register(a.data < a.data ? a.data : a.data);
};

/// In each lane `a`, unless `b` is smaller: which compilers know as one instruction of x86. (What xsimd's own minimum
/// answers for a NaN has changed with its versions.)
template <class Register>
RAIO_FN constexpr Register lesser(const Register& a, const Register& b) {
    if constexpr (native_register<Register>) {
        return Register(b.data < a.data ? b.data : a.data);
    } else {
        return select(b < a, b, a);
    }
}

/// In each lane `a`, unless `b` is larger.
template <class Register>
RAIO_FN constexpr Register greater(const Register& a, const Register& b) {
    if constexpr (native_register<Register>) {
        return Register(a.data < b.data ? b.data : a.data);
    } else {
        return select(a < b, b, a);
    }
}

/// The product, rounded before anything else happens to it: see strict_double.hpp.
template <class Register>
RAIO_FN constexpr Register rounded_product(const Register& a, const Register& b) {
    Register product = a * b;
#if defined(__GNUC__) && (defined(__FMA__) || defined(__FMA4__))
    asm("" : "+v"(product.data));
#elif defined(__GNUC__) && defined(__aarch64__)
    asm("" : "+w"(product.data));
#endif
    return product;
}

/// x, or -x where `sign` is negative.
template <class Register>
RAIO_FN constexpr Register flipped(const Register& x, const Register& sign) {
    if constexpr (requires { x ^ sign; }) {
        return x ^ (sign & Register(-0.0f));
    } else {
        return x * copysign(Register(1), sign);
    }
}

/// Calls `f` with 0, 1, ... N - 1, without a loop: what is indexed with them can live in registers.
template <std::size_t N, class F>
RAIO_FN constexpr void repeat(F f) {
    [&]<std::size_t... I>(std::index_sequence<I...>) { (f(I), ...); }
    (std::make_index_sequence<N>());
}

/// Sets every register to what `f` makes of its number.
template <class Register, std::size_t N, class F>
RAIO_FN constexpr void fill(Register (&registers)[N], F f) {
    repeat<N>([&](std::size_t i) { registers[i] = f(i); });
}

}  // namespace detail

/// What a comparison of packs answers: yes or no in each of N lanes. One type for all packs of numbers as large as S,
/// which is `float` or `double`.
template <std::floating_point S, std::size_t N>
class pack_mask {
public:
    pack_mask() = default;
    /// The same in every lane.
    RAIO_FN constexpr pack_mask(std::same_as<bool> auto value) {
        detail::fill(registers_, [&](std::size_t) { return register_type(value); });
    }

    /// The same lanes, of packs of numbers of another size.
    template <std::floating_point Other>
    requires(!std::same_as<Other, S>) RAIO_FN constexpr pack_mask(const pack_mask<Other, N>& other);

    RAIO_FN constexpr bool operator[](std::size_t lane) const { return (bits(*this) >> lane & 1) != 0; }

    RAIO_FN friend constexpr pack_mask operator&(const pack_mask& a, const pack_mask& b) {
        return made([&](std::size_t i) { return a.registers_[i] & b.registers_[i]; });
    }
    RAIO_FN friend constexpr pack_mask operator|(const pack_mask& a, const pack_mask& b) {
        return made([&](std::size_t i) { return a.registers_[i] | b.registers_[i]; });
    }
    RAIO_FN constexpr pack_mask operator!() const {
        return made([&](std::size_t i) { return !registers_[i]; });
    }
    RAIO_FN friend constexpr pack_mask operator!=(const pack_mask& a, const pack_mask& b) { return (a | b) & !(a & b); }
    RAIO_FN friend constexpr pack_mask operator==(const pack_mask& a, const pack_mask& b) { return !(a != b); }
    RAIO_FN friend constexpr pack_mask operator&&(const pack_mask& a, const pack_mask& b) { return a & b; }
    RAIO_FN friend constexpr pack_mask operator||(const pack_mask& a, const pack_mask& b) { return a | b; }

    RAIO_FN friend constexpr pack_mask select(const pack_mask& where, const pack_mask& a, const pack_mask& b) {
        return (where && a) || (!where && b);
    }

    RAIO_FN friend constexpr bool any(const pack_mask& mask) { return bits(mask) != 0; }
    RAIO_FN friend constexpr bool none(const pack_mask& mask) { return bits(mask) == 0; }
    RAIO_FN friend constexpr bool all(const pack_mask& mask) { return bits(mask) == (~std::uint32_t{0} >> (32 - N)); }

    /// One bit for each lane, the lowest for the first.
    RAIO_FN friend constexpr std::uint32_t bits(const pack_mask& mask) {
        std::uint32_t all = 0;
        detail::repeat<count>([&](std::size_t i) { all |= detail::bits_of(mask.registers_[i]) << (i * (N / count)); });
        return all;
    }

private:
    template <class, std::size_t>
    friend class pack;

    using register_type = detail::register_mask<detail::register_of<S, N>>;
    static constexpr std::size_t count = N * sizeof(S) / sizeof(detail::register_of<S, N>);

    template <class F>
    RAIO_FN static constexpr pack_mask made(F f) {
        pack_mask mask;
        detail::fill(mask.registers_, f);
        return mask;
    }

    register_type registers_[count];
};

}  // namespace raio
