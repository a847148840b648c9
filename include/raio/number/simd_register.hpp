#pragma once

#include <raio/push_macros.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <raio/number/strict_double.hpp>

/// \file
/// The registers that packs live in: those of xsimd. Where it is not installed, in CUDA, and where RAIO_WITHOUT_XSIMD
/// is defined, they are plain numbers.

#if RAIO_HAS_XSIMD

#include <xsimd/xsimd.hpp>

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

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

/// Is there an instruction for it?
#if XSIMD_WITH_SSE4_1
inline constexpr bool floors_any_number = true;
#else
inline constexpr bool floors_any_number = false;
#endif

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

// What each processor calls a b + c with one rounding.
#if defined(__FMA__)
inline __m128d fused_of(__m128d a, __m128d b, __m128d c) { return _mm_fmadd_pd(a, b, c); }
inline __m256d fused_of(__m256d a, __m256d b, __m256d c) { return _mm256_fmadd_pd(a, b, c); }
#if XSIMD_WITH_AVX512F
inline __m512d fused_of(__m512d a, __m512d b, __m512d c) { return _mm512_fmadd_pd(a, b, c); }
#endif
#endif

// Compilers take these for the two instructions, of which the first is enough.
#if XSIMD_WITH_AVX512F
inline __m512 lesser_of(__m512 a, __m512 b) { return _mm512_min_ps(b, a); }
inline __m512d lesser_of(__m512d a, __m512d b) { return _mm512_min_pd(b, a); }
inline __m512 greater_of(__m512 a, __m512 b) { return _mm512_max_ps(b, a); }
inline __m512d greater_of(__m512d a, __m512d b) { return _mm512_max_pd(b, a); }
#endif

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#else

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

template <class S, std::size_t N>
using register_of = S;

template <class S>
inline constexpr std::size_t native_lanes = 1;
inline constexpr bool floors_any_number = true;

RAIO_FN constexpr std::uint32_t bits_of(bool mask) { return mask ? 1 : 0; }

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#endif

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// What the comparison of two registers answers.
template <class Register>
using register_mask = decltype(std::declval<Register>() < std::declval<Register>());

/// Does the processor answer with bits when registers are compared?
template <class Register>
concept has_bit_masks = requires(const register_mask<Register> mask) {
    requires std::unsigned_integral<std::remove_cvref_t<decltype(mask.data)>>;
};

/// A register whose floating-point numbers the compiler itself compares and selects.
template <class Register>
concept native_register = std::floating_point<typename Register::value_type> && requires(const Register a) {
    Register(a.data < a.data ? a.data : a.data);
};

/// In each lane `a`, unless `b` is smaller: which compilers know as one instruction of x86. (What xsimd's own minimum
/// answers for a NaN has changed with its versions.)
template <class Register>
RAIO_FN constexpr Register lesser(const Register& a, const Register& b) {
    if constexpr (requires { lesser_of(a.data, b.data); }) {
        return Register(lesser_of(a.data, b.data));
    } else if constexpr (native_register<Register>) {
        return Register(b.data < a.data ? b.data : a.data);
    } else {
        return select(b < a, b, a);
    }
}

/// In each lane `a`, unless `b` is larger.
template <class Register>
RAIO_FN constexpr Register greater(const Register& a, const Register& b) {
    if constexpr (requires { greater_of(a.data, b.data); }) {
        return Register(greater_of(a.data, b.data));
    } else if constexpr (native_register<Register>) {
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

/// a b + c, rounded once.
template <class Register>
RAIO_FN Register fused(const Register& a, const Register& b, const Register& c) {
    if constexpr (requires { fused_of(a.data, b.data, c.data); }) {
        return Register(fused_of(a.data, b.data, c.data));
    } else if constexpr (std::floating_point<Register>) {
        return std::fma(a, b, c);
    } else {
        using S = typename Register::value_type;
        std::array<S, Register::size> x = std::bit_cast<decltype(x)>(a), y = std::bit_cast<decltype(x)>(b),
                                      z = std::bit_cast<decltype(x)>(c);
        for (std::size_t i = 0; i < x.size(); ++i) z[i] = std::fma(x[i], y[i], z[i]);
        return std::bit_cast<Register>(z);
    }
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

/// What xsimd computes with functions that are static, and so unknown outside of a module that includes it: raio.cppm
/// instantiates these for every register.
template <class Register>
struct trigonometry {
    RAIO_FN static Register sine(const Register& x);
    RAIO_FN static Register cosine(const Register& x);
    RAIO_FN static Register arc_tangent(const Register& y, const Register& x);
};
template <class Register>
RAIO_FN Register trigonometry<Register>::sine(const Register& x) {
    return sin(x);
}
template <class Register>
RAIO_FN Register trigonometry<Register>::cosine(const Register& x) {
    return cos(x);
}
template <class Register>
RAIO_FN Register trigonometry<Register>::arc_tangent(const Register& y, const Register& x) {
    return atan2(y, x);
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

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
