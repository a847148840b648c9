#pragma once

/// \file
/// The version of raio, and what compilers have to be told.

#if __cplusplus <= 201703L && !(defined(_MSVC_LANG) && _MSVC_LANG > 201703L)
#error "raio needs C++20: compile with -std=c++20, or link raio::raio in CMake, which asks for it"
#include <raio needs C++20>  // there is none: what follows would be errors by the thousand
#endif

#define RAIO_VERSION_MAJOR 0
#define RAIO_VERSION_MINOR 1
#define RAIO_VERSION_PATCH 0

/// Stands before every function: under CUDA it is compiled for the host and for the device, elsewhere it is nothing.
#if defined(__CUDACC__)
#define RAIO_FN __host__ __device__
#else
#define RAIO_FN
#endif

/// Stands before what asks for the formulas of shapes: whatever it calls becomes part of it. Where a file has many
/// shapes, a compiler's budget for inlining is soon spent, and a formula that is called step by step costs up to three
/// times as much. (Tests, which run briefly, define it as nothing.)
#if !defined(RAIO_FLATTEN)
#define RAIO_FLATTEN [[gnu::flatten]]
#endif

/// Stands before the formulas themselves: Clang, which goes one step at a time, is told so at each step.
#if defined(__clang__)
#define RAIO_FORMULA RAIO_FLATTEN RAIO_FN
#else
#define RAIO_FORMULA RAIO_FN
#endif

/// Stands before a function that evaluates a formula as a whole. Of neighbours, two numbers or two flags, g++ makes one
/// vector (superword-level parallelism), and taking them apart again costs up to a sixth of a hit. Such a function
/// does not become part of those that are compiled otherwise.
#if defined(__GNUC__) && !defined(__clang__) && !defined(__CUDACC__)
#define RAIO_NO_SLP [[gnu::optimize("no-tree-slp-vectorize")]]
#else
#define RAIO_NO_SLP
#endif

/// Stands before a function that one call in hundreds needs: it stays out of line, and is compiled to be small.
#define RAIO_RARELY [[gnu::noinline, gnu::cold]]

/// Without optimisation every operation of every number is a call, and a hit takes a hundred times as long. g++ can
/// optimise some functions of a file alone: between push_macros.hpp and pop_macros.hpp it does, and debug builds are of
/// use. (Asked for here, since between them __OPTIMIZE__ is always defined.)
#if defined(__GNUC__) && !defined(__clang__) && !defined(__CUDACC__) && !defined(__OPTIMIZE__)
#define RAIO_OPTIMISES_ITSELF 1
#else
#define RAIO_OPTIMISES_ITSELF 0
#endif

/// Stands before a function that takes numbers of several parts by value. For an argument that is a constant, g++ 12
/// makes a clone that knows some of the parts, and in a large file at -O3 forgets to store what the clone still reads.
#if defined(__GNUC__) && !defined(__clang__)
#define RAIO_NO_CLONES [[gnu::noclone]]
#else
#define RAIO_NO_CLONES
#endif

// The answers are exact because every operation is rounded as IEEE 754 says; -ffast-math takes that back without a
// word, and so does each of its parts that says so here. (Clang shows -fassociative-math and -freciprocal-math only as
// an FLT_EVAL_METHOD of -1, from version 15 on. Version 14 would give itself away when the program runs; but to look
// there, each file of each program that includes raio would need code that runs before main.)
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    defined(__NO_SIGNED_ZEROS__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || \
    (defined(__clang__) && defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ < 0)
#if !defined(RAIO_ALLOW_FAST_MATH)
#error \
    "raio: -ffast-math breaks the exactness of every answer, and so do -fassociative-math, -freciprocal-math, -fno-signed-zeros and -ffinite-math-only alone; compile without it, or define RAIO_ALLOW_FAST_MATH"
#endif
#define RAIO_ROUNDING _fast_math
#else
#define RAIO_ROUNDING
#endif

// The x87 keeps more digits than float and double have, until it runs out of registers: other bits with every build,
// and trees that answer otherwise than the loop. (16 is about halves only.)
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16 && \
    !(defined(__clang__) && __FLT_EVAL_METHOD__ < 0)
#error \
    "raio: numbers are computed with more digits here than they have (FLT_EVAL_METHOD is not 0), and answers would not be exact; on 32-bit x86 compile with -msse2 -mfpmath=sse"
#endif
