#pragma once

/// \file
/// The version of raio, and what compilers have to be told.

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
/// times as much. Where compiling takes longer than what is compiled will ever run, define RAIO_QUICK_TO_COMPILE.
#if defined(RAIO_QUICK_TO_COMPILE)
#define RAIO_FLATTEN
#else
#define RAIO_FLATTEN [[gnu::flatten]]
#endif

/// Stands before the formulas themselves: Clang, which goes one step at a time, is told so at each step.
#if defined(__clang__)
#define RAIO_FORMULA RAIO_FLATTEN RAIO_FN
#else
#define RAIO_FORMULA RAIO_FN
#endif

/// Stands before a function that takes numbers of several parts by value. For an argument that is a constant, g++ 12
/// makes a clone that knows some of the parts, and in a large file at -O3 forgets to store what the clone still reads.
#if defined(__GNUC__) && !defined(__clang__)
#define RAIO_NO_CLONES [[gnu::noclone]]
#else
#define RAIO_NO_CLONES
#endif

// The answers are exact because every operation is rounded as IEEE 754 says; -ffast-math takes that back without a
// word.
#if defined(__FAST_MATH__) && !defined(RAIO_ALLOW_FAST_MATH)
#error "raio: -ffast-math breaks the exactness of every answer; compile without it, or define RAIO_ALLOW_FAST_MATH"
#endif
