#pragma once

#include <glm/detail/setup.hpp>  // macros only

#include <raio/config.hpp>

/// \file
/// The settings in every name.
///
/// Where two files of a program are compiled with other settings, a sphere has another layout in each, or a function of
/// one name another code, and the linker takes either. So what matters of the settings is part of every name: every
/// header opens the namespace `raio::inline RAIO_ABI`, and such files do not link. Who uses raio never says it:
/// raio::sphere<float> is a raio::v0_1::sphere<float>.
///
/// push_macros.hpp includes this, once the macros of others are put aside: so every header has it.

#if GLM_CONFIG_ALIGNED_GENTYPES == GLM_ENABLE && defined(GLM_FORCE_DEFAULT_ALIGNED_GENTYPES)
#define RAIO_VECTORS _aligned
#else
#define RAIO_VECTORS
#endif
#if defined(__cpp_exceptions) || defined(__CUDACC__)  // whose two passes have to agree
#define RAIO_FAILURES
#else
#define RAIO_FAILURES _no_exceptions
#endif
#define RAIO_JOINED_ABI(major, minor, vectors, rounding, failures) v##major##_##minor##vectors##rounding##failures
#define RAIO_EXPANDED_ABI(...) RAIO_JOINED_ABI(__VA_ARGS__)
#define RAIO_ABI RAIO_EXPANDED_ABI(RAIO_VERSION_MAJOR, RAIO_VERSION_MINOR, RAIO_VECTORS, RAIO_ROUNDING, RAIO_FAILURES)

// What packs, and the trees that are made of them, depend on as well: whether there is xsimd, and the registers that it
// knows. Headers of packs and trees open `inline RAIO_REGISTERS` within the other. (The NEON of 32-bit ARM is not used:
// it takes subnormal numbers for 0, and has no doubles.)
#if __has_include(<xsimd/xsimd.hpp>) && !defined(__CUDACC__) && !defined(RAIO_WITHOUT_XSIMD) && \
    (defined(__SSE2__) || defined(_M_X64) || (defined(__ARM_NEON) && defined(__aarch64__)))
#define RAIO_HAS_XSIMD 1
#else
#define RAIO_HAS_XSIMD 0
#endif
#if !RAIO_HAS_XSIMD
#define RAIO_REGISTERS one_lane
#elif defined(__AVX512F__)
#define RAIO_REGISTERS xsimd_avx512
#elif defined(__AVX2__) && defined(__FMA__)
#define RAIO_REGISTERS xsimd_avx2_fma
#elif defined(__AVX2__)
#define RAIO_REGISTERS xsimd_avx2
#elif defined(__AVX__)
#define RAIO_REGISTERS xsimd_avx
#elif defined(__SSE4_1__)
#define RAIO_REGISTERS xsimd_sse4_1
#elif defined(__ARM_NEON)
#define RAIO_REGISTERS xsimd_neon
#else
#define RAIO_REGISTERS xsimd_sse2
#endif
